// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/wrong_curves.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/trimming/detail/profile_families.h"

namespace endmill {
namespace {

TrimmingTrial trial(std::vector<SectionPoint> points)
{
    TrimmingTrial made;
    made.curve.points = std::move(points);
    made.tolerance = {.gouge_mm = 1e-9, .uncovered = 1e-9};
    return made;
}

const std::vector<SectionPoint> hill{{-2, 0}, {0, 1}, {2, 0}};
const std::vector<SectionPoint> loop{{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}};

TEST(CrossingCurves, CountsTheCurvesThatCrossThemselves)
{
    EXPECT_EQ(crossing_curves(std::vector{trial(hill), trial(loop), trial(loop)}), 2U);
    const std::vector<SectionPoint> touch{{-2, 0}, {2, 0}, {0, 1}, {0, 0}, {-1, 1}};
    EXPECT_EQ(crossing_curves(std::vector{trial(touch)}), 0U)
        << "a point on a segment is no crossing";
}

TEST(WrongCurves, AreNoneForACurveWithoutAFold)
{
    for (const TriedMethod& method : tried_methods()) {
        TrimmingTrial easy = trial(hill);
        easy.scan_step_mm = 0.01;
        easy.scan_threshold_mm = 0.08;
        EXPECT_EQ(wrong_curves(std::vector{easy}, method), 0U) << method.label;
    }
}

// The envelope is exact, so it is right on every hard profile; the paper's methods with literal
// detection fail on some.
TEST(WrongCurves, OfTheHardProfilesAreNoneForTheEnvelopeOnly)
{
    std::vector<TrimmingTrial> trials;
    for (const OffsetProfile& profile : hard_profiles()) {
        TrimmingTrial made = trial(offset_curve(profile, 401).points);
        made.tolerance = {.gouge_mm = 2e-3, .uncovered = 2e-3};
        trials.push_back(std::move(made));
    }
    const auto wrong = [&](const std::string& label) {
        const auto methods = tried_methods();
        const auto found = std::ranges::find(methods, label, &TriedMethod::label);
        return found == methods.end() ? 1000 : wrong_curves(trials, *found);
    };
    EXPECT_EQ(wrong("envelope"), 0U);
    EXPECT_GT(wrong("literal 3"), 0U);
    EXPECT_LE(wrong("literal 3"), trials.size());
}

TEST(WrongCurves, RefusesAnUnknownMethod)
{
    const std::vector<TrimmingTrial> trials{trial(hill)};
    EXPECT_THROW(wrong_curves(trials, {"none", "none", FoldDetection::Guarded}),
                 DomainError);
}

TEST(TriedMethods, HaveDifferentLabels)
{
    std::vector<std::string> labels;
    for (const TriedMethod& method : tried_methods())
        labels.push_back(method.label);
    std::ranges::sort(labels);
    EXPECT_TRUE(std::ranges::adjacent_find(labels) == labels.end());
    EXPECT_TRUE(std::ranges::binary_search(labels, "guarded 1"));
}

}  // namespace
}  // namespace endmill
