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
    TrimmingMethod{"1", "distance of two points", true, trim_by_distance,
                   CurveCoupling::None},
    TrimmingMethod{"2", "straight lines and subdivision", true, trim_by_lines,
                   CurveCoupling::None},
    TrimmingMethod{"3", "segments in sequence", true, trim_in_sequence,
                   CurveCoupling::None},
    TrimmingMethod{"3r", "segments in sequence, repaired", false, trim_repaired,
                   CurveCoupling::None},
    TrimmingMethod{"envelope", "exact upper envelope", false, envelope_trimming,
                   CurveCoupling::Overlapping},
    TrimmingMethod{"winding", "exact winding number", false, winding_trimming,
                   CurveCoupling::Overlapping},
};

}  // namespace

std::span<const TrimmingMethod> trimming_methods()
{
    return methods;
}

}  // namespace endmill
