// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/trimming/detail/wrong_curves.h"
#include "support/offset_sections.h"

namespace endmill {

/// A planar curve of about 10 mm with the tolerances of a right result.
TrimmingTrial planar_trial(SectionCurve curve);

/// The hard profiles, sampled at `points`.
std::vector<TrimmingTrial> hard_trials(int points);

/// The wavy profiles, sampled at `points`.
std::vector<TrimmingTrial> wavy_trials(int points);

/// The convex profiles for `points`. \throws DomainError as `convex_profiles`.
std::vector<TrimmingTrial> convex_trials(int points);

/// The section curves of an offset, without those of fewer than four points.
std::vector<TrimmingTrial> section_trials(const SectionPlan& plan);

}  // namespace endmill
