// SPDX-License-Identifier: GPL-3.0-or-later
#include "interference/twist-rule/twist_counts.h"

#include <algorithm>

#include "endmill/core/error.h"
#include "endmill/trimming/detail/fold_scan.h"
#include "endmill/trimming/detail/profile_families.h"
#include "endmill/trimming/detail/section_runs.h"
#include "endmill/trimming/detail/section_views.h"
#include "support/printed_search.h"
#include "support/timed_trimming.h"

namespace endmill {
namespace {

// The runs of z along a whole curve. Their signs alternate.
struct Runs {
    bool first_grows = false;
    int count = 0;

    // Number of runs from the first falling (or growing) one on.
    int from_first(bool grows) const { return first_grows == grows ? count : count - 1; }
    bool read_plus_minus_plus() const { return from_first(true) >= 3; }
    bool change_three_times() const { return from_first(false) >= 4; }
};

Runs runs_of(const SectionCurve& curve)
{
    const SectionChain chain{curve.points, 0};
    RunReader reader{chain, RunAxis::Z, dead_band(curve.points), chain.first()};
    Runs runs;
    while (const auto run = reader.next()) {
        if (runs.count == 0)
            runs.first_grows = run->grows;
        ++runs.count;
    }
    return runs;
}

// Whether the curve has a fold as printed, and no line through a segment of B, from its
// cusp to the end of the curve, meets A.
bool has_fold_that_no_line_meets(const SectionCurve& curve)
{
    std::vector<PlaneSection> sections(1);
    sections[0].curves.push_back(curve);
    const auto folds = first_literal_folds(sections);
    if (folds.empty())
        return false;
    const auto& [chain, branches] = folds.front();
    for (auto b = branches.cusp_b; b != chain.last(); b = chain.next(b))
        if (first_crossed_of_a(chain, branches, b))
            return false;
    return true;
}

// Whether method 3 with literal detection trims the curve wrongly.
bool is_wrong(const TrimmingTrial& trial, const TrimmingMethod& method)
{
    const std::span curves{&trial.curve, 1};
    return !is_right(trimming_quality(curves, method.trim(curves, printed_options)),
                     trial.tolerance);
}

}  // namespace

TwistCounts twist_counts(const std::vector<TrimmingTrial>& trials)
{
    const TrimmingMethod& to_run_end = trimming_method("3");
    TwistCounts counts;
    for (const TrimmingTrial& trial : trials) {
        if (trial.curve.is_closed)
            continue;
        const Runs runs = runs_of(trial.curve);
        const bool crosses = crossing_curves({&trial, 1}) > 0;
        const bool three_runs = runs.read_plus_minus_plus();
        counts.crossing += crosses ? 1 : 0;
        counts.without_three_changes += crosses && !runs.change_three_times() ? 1 : 0;
        counts.three_runs += three_runs ? 1 : 0;
        counts.three_runs_without_crossing += three_runs && !crosses ? 1 : 0;
        counts.no_line_meets_a +=
            crosses && has_fold_that_no_line_meets(trial.curve) ? 1 : 0;
        counts.wrong_to_run_end += is_wrong(trial, to_run_end) ? 1 : 0;
        counts.wrong_to_curve_end += is_wrong(trial, printed_method_3()) ? 1 : 0;
    }
    return counts;
}

double depth_below_envelope(const SectionCurve& curve)
{
    const std::span curves{&curve, 1};
    return trimming_quality(curves, untrimmed(curves)).gouge_mm;
}

double path_lost_as_printed(const SectionCurve& curve)
{
    const std::span curves{&curve, 1};
    return trimming_quality(curves, printed_method_3().trim(curves, printed_options))
        .uncovered;
}

std::size_t hard_profile_number(const std::string& name)
{
    const auto profiles = hard_profiles();
    const auto found = std::ranges::find(profiles, name, &OffsetProfile::name);
    require(found != profiles.end(), "there is no such profile");
    return static_cast<std::size_t>(found - profiles.begin());
}

}  // namespace endmill
