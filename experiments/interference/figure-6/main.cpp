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
#include "endmill/figures/section_svg.h"
#include "endmill/trimming/cut_out.h"
#include "endmill/trimming/detail/envelope_trimming.h"
#include "endmill/trimming/detail/profile_families.h"
#include "endmill/trimming/detail/section_views.h"
#include "endmill/trimming/trimming_quality.h"
#include "support/experiment.h"
#include "support/named_cells.h"

using namespace endmill;

namespace {

OffsetProfile profile_named(const std::string& name)
{
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

void draw(Experiment& run, CsvTable& result, const std::string& cause,
          const std::string& name)
{
    const OffsetProfile profile = profile_named(name);
    const int points = static_cast<int>(run.number("points"));
    const SectionCurve curve = offset_curve(profile, points);
    const std::span curves{&curve, 1};
    const Trimmed left = envelope_trimming(curves);
    const auto cuts = cut_out(curves, left);
    const TrimmingQuality before = trimming_quality(curves, untrimmed(curves));
    result.add_row({cause, name, profile.radius, static_cast<std::int64_t>(cuts.size()),
                    before.gouge_mm, trimming_quality(curves, left).gouge_mm,
                    word(!cuts.empty())});
    FigureOptions figure;
    figure.title = cause;
    figure.captions = {"profile " + name + ", ball of radius " + to_text(profile.radius) +
                       " mm"};
    run.write(name + ".svg", section_svg({curves,
                                          left.curves,
                                          Cutter::ball(profile.radius),
                                          {outline(profile, points)}},
                                         figure));
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/figure-6", [](Experiment& run) {
        CsvTable result{{"row", "profile", "radius_mm", "stretches_cut",
                         "below_envelope_before_mm", "below_envelope_after_mm",
                         "interference"}};
        const auto causes = run.texts("causes");
        const auto profiles = run.texts("profiles");
        for (std::size_t k = 0; k < causes.size(); ++k)
            draw(run, result, causes[k], profiles.at(k));
        run.write_result(result);
    });
}
