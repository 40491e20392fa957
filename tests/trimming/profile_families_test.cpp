// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/profile_families.h"

#include <fstream>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/trimming/trimming_quality.h"
#include "trimmed_curves.h"
#include "trimming_vectors.h"

namespace endmill {
namespace {

using test::offset_curves_json;

constexpr int points = 401;  // number of points of the hard and the wavy profiles

double extent(const SectionCurve& curve)
{
    SectionPoint low = curve.points[0];
    SectionPoint high = low;
    for (const SectionPoint& point : curve.points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    return (high - low).maxCoeff();
}

// A method with its options, and the errors up to which its results count as right, in mm
// and as a share.
struct Trial {
    const char* method;
    TrimmingOptions options;
    TrimmingTolerance tolerance;
};

// The tolerance for method 3r: rounding errors only.
TrimmingTolerance exact(const SectionCurve& curve)
{
    return {.gouge_mm = 1e-9 * extent(curve), .uncovered = 1e-9};
}

Trial trial(const char* method, FoldDetection detection, const SectionCurve& curve)
{
    const std::string_view name = method;
    const TrimmingTolerance sampled{.gouge_mm = name == "1" ? 5e-3 : 2e-3,
                                    .uncovered = 2e-3};
    return {method,
            {.detection = detection, .scan_step = 5e-4, .scan_threshold = 4e-3},
            name == "3r" ? exact(curve) : sampled};
}

Trial convex_trial(const char* method, FoldDetection detection, const SectionCurve& curve,
                   double R)
{
    TrimmingTolerance tolerance = exact(curve);
    if (std::string_view{method} == "1")
        tolerance.gouge_mm = 0.05 * R;
    return {method,
            {.detection = detection, .scan_step = 5e-3 * R, .scan_threshold = 4e-2 * R},
            tolerance};
}

bool is_right(const Trial& trial, const SectionCurve& curve)
{
    const Trimmed trimmed = test::trim(trial.method, curve, trial.options);
    return is_right(trimming_quality({&curve, 1}, trimmed), trial.tolerance);
}

// In the files the methods 1, 2 and 3 have the indices 0, 1 and 2.
constexpr std::array methods{"1", "2", "3"};
// how much a count varies with the last bits of the functions
constexpr double other_libraries = 2;

TEST(HardProfiles, AreTrimmedAsListed)
{
    const auto json = offset_curves_json("hard-cases.json");
    const std::vector<OffsetProfile> profiles = hard_profiles();
    ASSERT_EQ(profiles.size(), json["cases"].size());
    for (std::size_t i = 0; i < profiles.size(); ++i) {
        const auto& listed = json["cases"][i];
        SCOPED_TRACE(profiles[i].name);
        ASSERT_EQ(profiles[i].name, listed["name"]);
        const SectionCurve curve = offset_curve(profiles[i], points);
        for (std::size_t m = 0; m < methods.size(); ++m) {
            EXPECT_EQ(is_right(trial(methods[m], FoldDetection::Literal, curve), curve),
                      listed["literal"][m] == "right")
                << methods[m] << " literal";
            EXPECT_EQ(is_right(trial(methods[m], FoldDetection::Guarded, curve), curve),
                      listed["guarded"][m] == "right")
                << methods[m] << " guarded";
        }
        EXPECT_TRUE(is_right(trial("3r", FoldDetection::Guarded, curve), curve));
    }
}

TEST(HardProfiles, HaveTheEndsThatAreListed)
{
    const auto json = offset_curves_json("hard-cases.json");
    const std::vector<OffsetProfile> profiles = hard_profiles();
    for (std::size_t i = 0; i < profiles.size(); ++i) {
        const SectionCurve curve = offset_curve(profiles[i], points);
        const auto& ends = json["cases"][i]["ends_mm"];
        EXPECT_NEAR(curve.points.front().x(), ends[0].get<double>(), 1e-12);
        EXPECT_NEAR(curve.points.back().x(), ends[1].get<double>(), 1e-12);
    }
}

// The points of a polyline file: a header, then rows of s and z.
std::vector<SectionPoint> polyline(const std::string& name)
{
    std::ifstream file{std::string{ENDMILL_SOURCE_DIR} + "/datasets/offset-curves/" +
                       name};
    std::string row;
    std::getline(file, row);
    EXPECT_EQ(row, "s_mm,z_mm");
    std::vector<SectionPoint> result;
    while (std::getline(file, row))
        result.emplace_back(std::stod(row), std::stod(row.substr(row.find(',') + 1)));
    return result;
}

TEST(HardProfiles, AreTheCurvesOfTheFiles)
{
    for (const OffsetProfile& profile : hard_profiles()) {
        SCOPED_TRACE(profile.name);
        test::expect_points(offset_curve(profile, points).points,
                            polyline("hard-cases/" + profile.name + ".csv"), 1e-13);
    }
    for (const test::TrimmingVector& vector : test::trimming_vectors())
        EXPECT_EQ(vector.curve.points, polyline("vectors/" + vector.name + ".csv"));
}

std::vector<TrimmedPoint> crossings_left(const Trimmed& trimmed)
{
    std::vector<TrimmedPoint> crossings;
    for (const TrimmedCurve& curve : trimmed.curves) {
        for (const TrimmedPoint& point : curve.points) {
            if (point.kind == TrimmedKind::Crossing)
                crossings.push_back(point);
        }
    }
    return crossings;
}

// All joints of the envelope between the ends of the curve are crossings.
TEST(HardProfiles, AreJoinedWhereTheExactAnswerIs)
{
    const auto json = offset_curves_json("hard-cases.json");
    const std::vector<OffsetProfile> profiles = hard_profiles();
    for (std::size_t i = 0; i < profiles.size(); ++i) {
        SCOPED_TRACE(profiles[i].name);
        const auto crossings =
            crossings_left(test::trim("3r", offset_curve(profiles[i], points)));
        std::size_t k = 0;
        for (const auto& joint : json["cases"][i]["joints"]) {
            if (joint["kind"] != "crossing")
                continue;
            ASSERT_LT(k, crossings.size());
            EXPECT_EQ(crossings[k].on.point, joint["segments"][0]);
            EXPECT_EQ(crossings[k].across.point, joint["segments"][1]);
            EXPECT_NEAR(crossings[k].at.x(), joint["sampled"][0].get<double>(), 1e-9);
            EXPECT_NEAR(crossings[k].at.y(), joint["sampled"][1].get<double>(), 1e-9);
            ++k;
        }
        EXPECT_EQ(k, crossings.size());
    }
}

// The largest distance of the crossings from `smooth` over several samplings. For a
// single sampling it would depend on where the crossing lies between two points.
double worst_distance(const OffsetProfile& profile, int count,
                      const std::vector<SectionPoint>& smooth)
{
    double worst = 0;
    for (int more = 0; more < 6; ++more) {
        const auto crossings =
            crossings_left(test::trim("3r", offset_curve(profile, count + more)));
        EXPECT_EQ(crossings.size(), smooth.size());
        for (std::size_t k = 0; k < std::min(smooth.size(), crossings.size()); ++k)
            worst = std::max(worst, (crossings[k].at - smooth[k]).norm());
    }
    return worst;
}

// Chords of an eighth of the length have a 64th of the error.
TEST(HardProfiles, AreJoinedWhereTheSmoothCurvesCrossInTheLimit)
{
    const auto json = offset_curves_json("hard-cases.json");
    const std::vector<OffsetProfile> profiles = hard_profiles();
    for (std::size_t i = 0; i < profiles.size(); ++i) {
        SCOPED_TRACE(profiles[i].name);
        std::vector<SectionPoint> smooth;
        for (const auto& joint : json["cases"][i]["joints"]) {
            if (joint["kind"] == "crossing")
                smooth.emplace_back(joint["smooth"][0], joint["smooth"][1]);
        }
        const double coarse = worst_distance(profiles[i], 401, smooth);
        const double fine = worst_distance(profiles[i], 3201, smooth);
        constexpr double list_rounding = 1e-10;  // of the listed numbers
        EXPECT_LE(fine, std::max(coarse / 32, list_rounding));
    }
}

TEST(HardProfiles, WithoutInterferenceAreUnchangedExceptByThePrint)
{
    for (const OffsetProfile& profile : hard_profiles()) {
        if (profile.name != "gentle-wave" && profile.name != "hill-and-valley")
            continue;
        const SectionCurve curve = offset_curve(profile, points);
        const auto guarded = trial("1", FoldDetection::Guarded, curve).options;
        for (const char* method : {"1", "2", "3", "3r"}) {
            const Trimmed trimmed = test::trim(method, curve, guarded);
            EXPECT_EQ(test::points_left(trimmed), curve.points);
            EXPECT_EQ(trimmed.unresolved, 0);
        }
        for (const char* method : methods) {
            const auto left = test::points_left(test::trim(
                method, curve, trial(method, FoldDetection::Literal, curve).options));
            const double kept = (left.back().x() - left.front().x()) /
                                (curve.points.back().x() - curve.points.front().x());
            EXPECT_LT(kept, 0.4) << "known failure: the print cuts off good path";
        }
    }
}

// Counts the wrong results of methods 1, 2, 3 and 3r, in this order.
template <typename MakeTrial>
std::array<int, 4> count_wrong(const std::vector<OffsetProfile>& profiles, int count,
                               const MakeTrial& make_trial)
{
    std::array<int, 4> wrong{};
    for (const OffsetProfile& profile : profiles) {
        const SectionCurve curve = offset_curve(profile, count);
        for (std::size_t m = 0; m < wrong.size(); ++m) {
            const char* method = m < methods.size() ? methods[m] : "3r";
            wrong[m] += !is_right(make_trial(method, curve, profile.radius), curve);
        }
    }
    return wrong;
}

void expect_counts(const std::array<int, 4>& wrong, const nlohmann::json& listed)
{
    for (std::size_t m = 0; m < methods.size(); ++m)
        EXPECT_NEAR(wrong[m], listed[m].get<int>(), other_libraries) << methods[m];
    EXPECT_EQ(wrong[3], 0) << "3r";
}

TEST(WavyProfiles, HaveTheListedErrors)
{
    const auto family = offset_curves_json("random-families.json")["families"][0];
    const std::vector<OffsetProfile> profiles = wavy_profiles();
    ASSERT_EQ(profiles.size(), 400U);
    EXPECT_DOUBLE_EQ(profiles.front().radius, family["first"][8].get<double>());
    EXPECT_DOUBLE_EQ(profiles.back().radius, family["last"][8].get<double>());
    for (const char* detection : {"literal", "guarded"}) {
        const auto mode = detection == std::string_view{"literal"}
                              ? FoldDetection::Literal
                              : FoldDetection::Guarded;
        const auto wrong = count_wrong(
            profiles, points, [&](const char* method, const SectionCurve& curve, double) {
                return trial(method, mode, curve);
            });
        expect_counts(wrong, family["wrong"][detection]);
    }
}

// Without P3, a hill followed by a valley does not count as a fold.
TEST(WavyProfiles, HaveFewerErrorsWithoutPatternP3)
{
    const auto family = offset_curves_json("random-families.json")["families"][0];
    const auto wrong =
        count_wrong(wavy_profiles(), points,
                    [&](const char* method, const SectionCurve& curve, double) {
                        auto made = trial(method, FoldDetection::Literal, curve);
                        made.options.patterns = FoldPatterns::P4;
                        return made;
                    });
    expect_counts(wrong, family["wrong"]["literal without P3"]);
}

TEST(ConvexProfiles, HaveTheListedErrors)
{
    const auto family = offset_curves_json("random-families.json")["families"][1];
    for (const int count : {41, 101, 401}) {
        SCOPED_TRACE(count);
        const std::string size = std::to_string(count);
        const std::vector<OffsetProfile> profiles = convex_profiles(count);
        ASSERT_EQ(profiles.size(), 500U);
        EXPECT_DOUBLE_EQ(profiles.front().radius, family["first"][size][4].get<double>());
        EXPECT_DOUBLE_EQ(profiles.back().radius, family["last"][size][4].get<double>());
        for (const char* detection : {"literal", "guarded"}) {
            const auto mode = detection == std::string_view{"literal"}
                                  ? FoldDetection::Literal
                                  : FoldDetection::Guarded;
            const auto wrong =
                count_wrong(profiles, count,
                            [&](const char* method, const SectionCurve& curve, double R) {
                                return convex_trial(method, mode, curve, R);
                            });
            expect_counts(wrong, family["wrong"][detection][size]);
        }
    }
}

TEST(ConvexProfiles, AreRightBy3rAlsoWithManyPoints)
{
    constexpr int many = 1601;
    const std::vector<OffsetProfile> profiles = convex_profiles(many);
    for (const OffsetProfile& profile : profiles) {
        const SectionCurve curve = offset_curve(profile, many);
        EXPECT_TRUE(is_right(
            convex_trial("3r", FoldDetection::Guarded, curve, profile.radius), curve));
    }
    EXPECT_THROW(convex_profiles(42), DomainError);
}

}  // namespace
}  // namespace endmill
