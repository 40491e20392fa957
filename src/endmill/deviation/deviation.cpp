// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/deviation.h"

#include "endmill/core/tolerance.h"

namespace endmill {

std::string_view verdict_name(Verdict verdict)
{
    switch (verdict) {
        case Verdict::Clean:
            return "clean";
        case Verdict::Gouged:
            return "gouged";
        case Verdict::Uncut:
            return "uncut";
        case Verdict::Undecided:
            return "undecided";
        case Verdict::NotJudged:
            return "not judged";
        case Verdict::Collides:
            return "collides";
    }
    return {};
}

Verdict verdict(const Deviation& deviation, const DeviationLimits& limits)
{
    const double tolerance = limits.tolerance + verdict_slack;
    const double scallop = limits.scallop + verdict_slack;
    if (deviation.max_gouge_mm > tolerance)
        return Verdict::Gouged;
    // Tested before `Uncut`: while the bound allows a gouge, more rays could still find
    // one.
    if (deviation.max_gouge_mm + deviation.gouge_bound_mm > tolerance)
        return Verdict::Undecided;
    if (deviation.max_scallop_mm > scallop)
        return Verdict::Uncut;
    const bool is_low = deviation.max_scallop_mm + deviation.scallop_bound_mm <= scallop;
    return is_low ? Verdict::Clean : Verdict::Undecided;
}

RefinedBounds refined_bounds(const Deviation& deviation, const DeviationLimits& limits)
{
    const bool is_gouged = deviation.max_gouge_mm > limits.tolerance + verdict_slack;
    const bool is_uncut = deviation.max_scallop_mm > limits.scallop + verdict_slack;
    return {!is_gouged, !is_gouged && !is_uncut};
}

}  // namespace endmill
