// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/field.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/strategy/detail/coverage.h"
#include "endmill/strategy/detail/guide_field.h"
#include "endmill/strategy/detail/section_march.h"

namespace endmill {
namespace {

// Samples across a strip, fewer if they would be too many.
constexpr std::array<double, 3> field_samples_across{6, 4, 3};
// The factors of a guide field grow faster than the samples.
constexpr std::size_t most_field_samples = 400'000;
// Share of the layout height by which a sample may miss its cover.
constexpr double field_slack_share = 0.005;

// Samples for the estimate of the length.
constexpr FewSamplesLimits estimate_samples{3, 40'000};

std::vector<LaidPass> passes_along_field(const PartSamples& samples,
                                         const BallCutter& cutter, double height,
                                         TravelKind distance)
{
    Coverage coverage{samples, cutter, layout_share * height};
    return SectionMarch{coverage, guide_field(samples, cutter, height, distance),
                        field_slack_share * height}
        .passes();
}

// As dense as the guide field permits.
PartSamples samples_for_field(const CoveredPart& part, double height,
                              std::size_t most_samples)
{
    const double width = strip_width(part.cutter(), height);
    for (const double across : field_samples_across)
        try {
            return part.samples(width / across,
                                std::min(most_samples, most_field_samples));
        } catch (const LimitError&) {
            if (across == field_samples_across.back() &&
                most_samples < most_field_samples)
                throw;
        }
    throw LimitError{"the part would need more than " +
                     std::to_string(most_field_samples) +
                     " samples at this scallop height, the most with which field plans; "
                     "expected a larger --scallop or another --strategy"};
}

}  // namespace

LaidPasses field_passes(const CoveredPart& part, const BallCutter& cutter,
                        const StrategyOptions& options)
{
    const double height = options.scallop_height;
    PartSamples samples = samples_for_field(part, height, options.most_samples);
    std::vector<LaidPass> passes =
        passes_along_field(samples, cutter, height, options.distance);
    return {std::move(samples), std::move(passes)};
}

double field_travel(const CoveredPart& part, const BallCutter& cutter,
                    const StrategyOptions& options)
{
    const auto [samples, height] =
        few_samples(part, estimate_samples, options.scallop_height,
                    std::min(options.most_samples, most_field_samples));
    const PassLengths lengths = pass_lengths(
        passes_along_field(samples, cutter, height, options.distance), cutter.radius());
    return scaled_travel(
        options.distance == TravelKind::Tip ? lengths.tip_mm : lengths.contact_mm, cutter,
        height, options.scallop_height);
}

}  // namespace endmill
