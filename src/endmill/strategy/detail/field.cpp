// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/field.h"

#include <algorithm>
#include <utility>

#include "endmill/strategy/detail/coverage.h"
#include "endmill/strategy/detail/guide_field.h"
#include "endmill/strategy/detail/section_march.h"

namespace endmill {
namespace {

// Samples across a strip.
constexpr double field_samples_across = 6;
// The factors of a guide field grow faster than the samples.
constexpr std::size_t most_field_samples = 400'000;
// Share of the layout height by which a sample may miss its cover.
constexpr double field_slack_share = 0.005;

}  // namespace

LaidPasses field_passes(const CoveredPart& part, const BallCutter& cutter,
                        const StrategyOptions& options)
{
    const double height = options.scallop_height;
    PartSamples samples =
        part.samples(strip_width(cutter, height) / field_samples_across,
                     std::min(options.most_samples, most_field_samples));
    Coverage coverage{samples, cutter, layout_share * height};
    SectionMarch march{coverage, guide_field(samples, cutter, height, options.distance),
                       field_slack_share * height};
    std::vector<LaidPass> passes = march.passes();
    return {std::move(samples), std::move(passes)};
}

}  // namespace endmill
