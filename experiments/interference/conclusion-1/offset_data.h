// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "support/experiment.h"

namespace endmill {

/// Machining data from the offset of a part: its sections, trimmed by method 3 as printed.
struct OffsetData {
    double gouge_mm;  ///< deepest gouge of the trimmed sections
    /// The same for the envelope of the same sections, which is their exact result.
    double gouge_with_envelope_mm;
};

/// A part, a cutter, and what the paper's method gives.
struct OffsetCase {
    std::string surface;  ///< a file in datasets/surfaces
    std::string cutter;   ///< a word of `cutters` in params.json
    /// Contacts of the grid at which eq. (5) is 0 / 0.
    std::ptrdiff_t contacts_without_normal;
    double allowed_gouge_mm;         ///< up to which data are usable
    std::optional<OffsetData> data;  ///< nothing if the offset cannot be made

    /// Whether the data are there and do not gouge.
    bool is_usable() const { return data && data->gouge_mm <= allowed_gouge_mm; }
    /// The same for the exact method.
    bool is_usable_with_envelope() const
    {
        return data && data->gouge_with_envelope_mm <= allowed_gouge_mm;
    }
};

/// All surfaces with all cutters of params.json.
std::vector<OffsetCase> offset_cases(Experiment& run);

}  // namespace endmill
