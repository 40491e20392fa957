// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/setup/setup_pose.h"
#include "support/named_cells.h"
#include "support/studied_part.h"

namespace endmill {

/// A search over the tool axes at cells, named as in params.json.
struct NamedSearch {
    std::string family;  ///< CA or AB
    std::string mode;    ///< name of a SetupMode

    /// Searches without limits. \throws DomainError for an unknown name.
    PoseSearchResult operator()(const StudiedPart& part) const;

    std::string label() const { return family + ", " + mode; }  ///< for rows
};

/// Every family in every mode.
std::vector<NamedSearch> named_searches(const std::vector<std::string>& families,
                                        const std::vector<std::string>& modes);

/// A search and what it found.
struct FoundSetup {
    NamedSearch search;
    PoseSearchResult found;
};

/// Runs the searches on a part.
std::vector<FoundSetup> found_setups(const StudiedPart& part,
                                     const std::vector<NamedSearch>& searches);

/// The result of a family's search in a mode. \pre it is one of `setups`.
const PoseSearchResult& result_of(const std::vector<FoundSetup>& setups,
                                  const std::string& family, const std::string& mode);

/// The area in rad^2 that the pose of family A,B needs for all nearest directions.
double true_area(const StudiedPart& part, const FittedPose& fit);

/// Columns of `search_cells`, after `row`.
std::vector<std::string> search_columns();

/// Result of one of the searches of a part: the pose of least area, its ranges, the number
/// of poses skipped, over_corrected: its area over that of the same family in the mode
/// `corrected`, and in A,B true_area_deg2: the area that the pose needs for all nearest
/// directions, not only for those that the mode considers, and true_over_claimed, its
/// ratio to the area of the search.
NamedCells search_cells(const StudiedPart& part, const std::vector<FoundSetup>& setups,
                        const FoundSetup& shown);

/// Result of the search on a moved part: its least area, and its relative difference from
/// that of the part. \pre both have a pose.
NamedCells moved_cells(const StudiedPart& part, const StudiedPart& moved_part,
                       const NamedSearch& search);

}  // namespace endmill
