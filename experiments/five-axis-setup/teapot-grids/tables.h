// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/setup/setup_pose.h"
#include "support/named_cells.h"
#include "support/studied_part.h"

namespace endmill {

/// A search over the tool axes at cells, by the words of a params.json.
struct NamedSearch {
    std::string family;  ///< CA or AB
    std::string mode;    ///< of setup_mode.h

    /// Without limits. \throws DomainError for an unknown word.
    PoseSearchResult operator()(const StudiedPart& part) const;

    std::string label() const { return family + ", " + mode; }  ///< for rows
};

/// Every family in every mode.
std::vector<NamedSearch> named_searches(const std::vector<std::string>& families,
                                        const std::vector<std::string>& modes);

/// Columns of `search_cells`, behind `row`.
std::vector<std::string> search_columns();

/// What the search finds: the pose of least area, what it needs, the poses skipped, and in A,B
/// true_area_deg2: what the pose needs with all that represents the cones, not only with what
/// the mode looked at.
NamedCells search_cells(const StudiedPart& part, const NamedSearch& search);

/// The search on a part that was moved: its least area, and by how much it differs from that
/// of the part, relatively. \pre both have a pose.
NamedCells moved_cells(const StudiedPart& part, const StudiedPart& moved_part,
                       const NamedSearch& search);

}  // namespace endmill
