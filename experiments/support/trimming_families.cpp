// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/trimming_families.h"

#include <algorithm>

#include "endmill/trimming/detail/profile_families.h"

namespace endmill {
namespace {

// Tolerances of a right result, and the step and threshold of method 1.
// Source: docs/methods/interference.md, section 9.
constexpr double scan_threshold_in_steps = 8;

std::vector<TrimmingTrial> planar_trials(const std::vector<OffsetProfile>& profiles,
                                         int points)
{
    std::vector<TrimmingTrial> trials;
    trials.reserve(profiles.size());
    for (const OffsetProfile& profile : profiles)
        trials.push_back(planar_trial(offset_curve(profile, points)));
    return trials;
}

// The larger of the extents in s and in z, mm.
double extent_of(const SectionCurve& curve)
{
    SectionPoint low = curve.points.front();
    SectionPoint high = low;
    for (const SectionPoint& point : curve.points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    return (high - low).maxCoeff();
}

}  // namespace

TrimmingTrial planar_trial(SectionCurve curve)
{
    constexpr double step = 5e-4;  // mm
    return {std::move(curve),
            {.gouge_mm = 2e-3, .uncovered = 2e-3},
            5e-3,
            step,
            scan_threshold_in_steps * step};
}

std::vector<TrimmingTrial> hard_trials(int points)
{
    return planar_trials(hard_profiles(), points);
}

std::vector<TrimmingTrial> wavy_trials(int points)
{
    return planar_trials(wavy_profiles(), points);
}

std::vector<TrimmingTrial> convex_trials(int points)
{
    std::vector<TrimmingTrial> trials;
    for (const OffsetProfile& profile : convex_profiles(points)) {
        TrimmingTrial trial{offset_curve(profile, points), {}};
        trial.tolerance.gouge_mm = 1e-9 * extent_of(trial.curve);
        trial.tolerance.uncovered = 1e-9;
        trial.scan_gouge_mm = 0.05 * profile.radius;
        trial.scan_step_mm = 5e-3 * profile.radius;
        trial.scan_threshold_mm = scan_threshold_in_steps * trial.scan_step_mm;
        trials.push_back(std::move(trial));
    }
    return trials;
}

std::vector<TrimmingTrial> section_trials(const SectionPlan& plan)
{
    constexpr std::size_t fewest_points = 4;
    constexpr double gouge = 0.02;  // mm
    constexpr double step = 5e-3;   // mm
    std::vector<TrimmingTrial> trials;
    for (const PlaneSection& section : offset_sections(plan).sections)
        for (const SectionCurve& curve : section.curves)
            if (curve.points.size() >= fewest_points)
                trials.push_back({curve,
                                  {.step_back_mm = step_back_on_parts_mm,
                                   .gouge_mm = gouge,
                                   .uncovered = 0.02},
                                  gouge,
                                  step,
                                  4 * step});
    return trials;
}

}  // namespace endmill
