// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 6 of Jang, Kim and Jeong: the causes of interference, one profile for each,
// before and after trimming.
//
//   interference-figure-6 OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include <algorithm>
#include <cstdint>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/cutter/plane_offset.h"
#include "endmill/figures/section_svg.h"
#include "endmill/files/result_csv.h"
#include "endmill/trimming/cut_out.h"
#include "endmill/trimming/detail/envelope_trimming.h"
#include "endmill/trimming/detail/profile_families.h"
#include "endmill/trimming/detail/section_views.h"
#include "endmill/trimming/trimming_quality.h"
#include "support/experiment.h"
#include "support/named_cells.h"

using namespace endmill;

namespace {

// The profile of the hard cases with this name; or `ridge`, a smooth convex ridge with the
// radius of curvature 1 mm at its top.
OffsetProfile profile_named(const std::string& name)
{
    if (name == "ridge")
        return {
            name, [](double x) { return -x * x / 2; }, [](double x) { return -x; }, -3, 3,
            1};
    const auto profiles = hard_profiles();
    const auto found = std::ranges::find(profiles, name, &OffsetProfile::name);
    require(found != profiles.end(), "there is no such profile");
    return *found;
}

std::vector<SectionPoint> outline(const OffsetProfile& profile, int points)
{
    std::vector<SectionPoint> line;
    for (int i = 0; i < points; ++i) {
        const double x = profile.from + (profile.to - profile.from) * i / (points - 1);
        line.emplace_back(x, profile.height(x));
    }
    return line;
}

// The offset of `profile` for a flat end mill with the radius of its ball.
SectionCurve flat_offset(const OffsetProfile& profile, int points)
{
    std::vector<ProfilePoint> samples;
    for (const SectionPoint& point : outline(profile, points))
        samples.push_back({point, profile_normal(profile.slope(point.x()))});
    SectionCurve curve;
    for (const SectionPoint& point : plane_offset(Cutter::flat(profile.radius), samples))
        if (curve.points.empty() || point != curve.points.back())
            curve.points.push_back(point);
    return curve;
}

// A row of the result: a cause, its profile, and the cutter.
struct Cause {
    std::string name;
    OffsetProfile profile;
    bool is_flat;  // a flat end mill instead of a ball
};

// The curve of each cause before and after trimming, for `endmill view`.
struct Planes {
    std::vector<PlaneSection> before = {};
    std::vector<Trimmed> after = {};
};

void draw(Experiment& run, CsvTable& result, Planes& planes, const Cause& cause,
          const std::string& file)
{
    const OffsetProfile& profile = cause.profile;
    const int points = static_cast<int>(run.number("points"));
    const Cutter cutter =
        cause.is_flat ? Cutter::flat(profile.radius) : Cutter::ball(profile.radius);
    const SectionCurve curve =
        cause.is_flat ? flat_offset(profile, points) : offset_curve(profile, points);
    const std::span curves{&curve, 1};
    const Trimmed left = envelope_trimming(curves);
    const auto cuts = cut_out(curves, left);
    const TrimmingQuality before = trimming_quality(curves, untrimmed(curves));
    result.add_row({cause.name, profile.name, cutter_word(cutter), profile.radius,
                    static_cast<std::int64_t>(cuts.size()), before.gouge_mm,
                    trimming_quality(curves, left).gouge_mm, word(!cuts.empty())});
    planes.before.emplace_back().curves.push_back(curve);
    planes.after.push_back(left);
    FigureOptions figure;
    figure.title = cause.name;
    figure.captions = {"profile " + profile.name + ", " + cutter_word(cutter) +
                       " (diameter in mm)"};
    run.write(file, section_svg({curves, left.curves, cutter, {outline(profile, points)}},
                                figure));
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/figure-6", [](Experiment& run) {
        CsvTable result{{"row", "profile", "cutter", "radius_mm", "stretches_cut",
                         "below_envelope_before_mm", "below_envelope_after_mm",
                         "interference"}};
        Planes planes;
        const auto causes = run.texts("causes");
        const auto profiles = run.texts("profiles");
        const auto radii = run.numbers("radii_mm");
        const auto cutters = run.texts("cutters");
        const auto files = run.texts("files");
        for (std::size_t k = 0; k < causes.size(); ++k) {
            OffsetProfile profile = profile_named(profiles.at(k));
            profile.radius = radii.at(k);
            draw(run, result, planes, {causes[k], profile, cutters.at(k) == "flat"},
                 files.at(k) + ".svg");
        }
        std::string names;
        for (std::size_t k = 0; k < causes.size(); ++k)
            names += ", \"plane_" + std::to_string(k) + "\": \"" + causes[k] + "\"";
        run.write("summary.json", "{\"name\": \"" + run.name() + "\"" + names + "}\n");
        run.write("sections.csv", sections_csv(planes.before, nullptr));
        run.write("trimmed.csv", trimmed_csv(planes.after, nullptr));
        run.write_result(result);
    });
}
