// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/trimming_methods.h"

#include <array>

#include "endmill/trimming/detail/distance_trimming.h"
#include "endmill/trimming/detail/envelope_trimming.h"
#include "endmill/trimming/detail/line_trimming.h"
#include "endmill/trimming/detail/sequence_trimming.h"
#include "endmill/trimming/detail/winding_trimming.h"

namespace endmill {
namespace {

// The table of methods: name, title, whether the method uses TrimmingOptions::detection,
// function. A new method needs its header above and one line here.
constexpr std::array methods{
    TrimmingMethod{"1", "distance of two points", true, trim_by_distance},
    TrimmingMethod{"2", "straight lines and subdivision", true, trim_by_lines},
    TrimmingMethod{"3", "segments in sequence", true, trim_in_sequence},
    TrimmingMethod{"3r", "segments in sequence, repaired", false, trim_repaired},
    TrimmingMethod{"envelope", "exact upper envelope", false, envelope_trimming},
    TrimmingMethod{"winding", "exact winding number", false, winding_trimming},
};

}  // namespace

std::span<const TrimmingMethod> trimming_methods()
{
    return methods;
}

}  // namespace endmill
