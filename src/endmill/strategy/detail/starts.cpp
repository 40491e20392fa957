// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/starts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace endmill {
namespace {

// Directions of section starts.
constexpr int section_angles = 12;
// Cosine of the turn of the border from which it has a corner.
constexpr double corner_cosine = 0.8;

// A place on the border, with its distance along the borders from their first place.
struct BorderPlace {
    SampleEdge at;
    double share;
    bool is_corner;
};

// The samples of all borders, loop after loop.
std::vector<BorderPlace> border_places(const PartSamples& samples)
{
    std::map<std::int32_t, std::vector<std::int32_t>> next;
    for (const auto& [a, b] : samples.border()) {
        next[samples.representative(a)].push_back(b);
        next[samples.representative(b)].push_back(a);
    }
    std::vector<BorderPlace> places;
    std::map<std::int32_t, bool> is_seen;
    double length = 0;
    for (const auto& [start, unused] : next) {
        if (is_seen[start])
            continue;
        std::vector<std::int32_t> loop;
        for (std::int32_t at = start; at >= 0;) {
            is_seen[samples.representative(at)] = true;
            loop.push_back(at);
            std::int32_t further = -1;
            for (const std::int32_t candidate : next[samples.representative(at)])
                if (!is_seen[samples.representative(candidate)])
                    further = candidate;
            at = further;
        }
        const std::size_t count = loop.size();
        for (std::size_t k = 0; k < count; ++k) {
            const Vec3& before = samples.point(loop[(k + count - 1) % count]);
            const Vec3& here = samples.point(loop[k]);
            const Vec3& after = samples.point(loop[(k + 1) % count]);
            const double turn =
                (here - before).normalized().dot((after - here).normalized());
            places.push_back(
                {{loop[k], loop[k], 0}, length, turn < corner_cosine || k == 0});
            length += (after - here).norm();
        }
    }
    for (BorderPlace& place : places)
        place.share /= length;
    return places;
}

// The section of the samples with an upright plane.
std::vector<LevelLine> section(const PartSamples& samples, const LineStart& start)
{
    std::vector<double> values(samples.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = samples.point(i).y() * std::cos(start.angle) -
                    samples.point(i).x() * std::sin(start.angle);
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double level = std::lerp(*low, *high, start.share);
    for (double& value : values)
        value -= level;
    return level_lines(samples, values);
}

// The border of the connected part of the samples that contains `inside`, or the sample.
std::vector<SampleEdge> border_of_component(const PartSamples& samples,
                                            std::int32_t inside)
{
    SampleWalk walk{samples};
    std::vector<bool> is_inside(samples.size(), false);
    walk.from(std::array{inside}, [&](std::int32_t i) { return is_inside[i] = true; });
    std::vector<SampleEdge> places;
    for (const auto& [a, b] : samples.border())
        if (is_inside[a]) {
            places.push_back({a, a, 0});
            places.push_back({b, b, 0});
        }
    if (places.empty())
        places.push_back({inside, inside, 0});
    return places;
}

// A connected part of the samples that are not covered.
struct UncoveredRegion {
    std::vector<std::int32_t> samples;
    std::vector<SampleEdge> rim;  // those beside covered ones
};

UncoveredRegion uncovered_region(const Coverage& coverage, std::int32_t inside,
                                 double slack)
{
    const PartSamples& samples = coverage.samples();
    const auto is_uncovered = [&](std::int32_t i) { return coverage.gaps()[i] > slack; };
    UncoveredRegion region;
    SampleWalk walk{samples};
    walk.from(std::array{inside}, [&](std::int32_t i) {
        if (is_uncovered(i))
            region.samples.push_back(i);
        return is_uncovered(i);
    });
    for (const std::int32_t i : region.samples)
        if (!std::ranges::all_of(samples.neighbours(i), is_uncovered))
            region.rim.push_back({i, i, 0});
    return region;
}

// Covers other components, what a first pass of no length left, and what lies behind places
// that a front could not pass. A region in which no start covers anything is left.
void cover_rest(FrontMarch& march, const Coverage& coverage, double slack)
{
    const PartSamples& samples = coverage.samples();
    std::size_t left = march.uncovered_samples();
    const auto covers_more = [&](std::vector<SampleEdge> front) {
        if (front.empty())
            return false;
        march.run(std::move(front));
        const std::size_t before = std::exchange(left, march.uncovered_samples());
        return left < before;
    };
    std::vector<bool> is_given_up(samples.size(), false);
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(samples.size());) {
        if (is_given_up[i] || !(coverage.gaps()[i] > slack)) {
            ++i;
            continue;
        }
        if (covers_more(border_of_component(samples, i)))
            continue;
        const UncoveredRegion region = uncovered_region(coverage, i, slack);
        if (covers_more(region.rim) || covers_more({{i, i, 0}}))
            continue;
        for (const std::int32_t sample : region.samples)
            is_given_up[sample] = true;
    }
}

}  // namespace

std::vector<MarchStart> march_starts(const PartSamples& samples)
{
    std::vector<MarchStart> starts;
    const std::vector<BorderPlace> border = border_places(samples);
    if (!border.empty())
        starts.push_back(BorderStart{0, 1});
    std::vector<double> corners;
    for (const BorderPlace& place : border)
        if (place.is_corner)
            corners.push_back(place.share);
    corners.push_back(1);
    for (std::size_t k = 0; k + 1 < corners.size() && corners.size() > 2; ++k)
        starts.push_back(BorderStart{corners[k], corners[k + 1]});
    for (int angle = 0; angle < section_angles; ++angle)
        starts.push_back(LineStart{angle * std::numbers::pi / section_angles, 0.5});
    return starts;
}

std::vector<LevelLine> lay_lines(Coverage& coverage,
                                 const std::optional<MarchStart>& start, double slack,
                                 int rounds)
{
    const PartSamples& samples = coverage.samples();
    FrontMarch march{coverage, slack, rounds};
    if (start) {
        if (const auto* line = std::get_if<LineStart>(&*start)) {
            march.lay(section(samples, *line));
            march.run();
        } else {
            const auto& side = std::get<BorderStart>(*start);
            std::vector<SampleEdge> front;
            for (const BorderPlace& place : border_places(samples))
                if (place.share >= side.first_share && place.share <= side.last_share)
                    front.push_back(place.at);
            march.run(std::move(front));
        }
    }
    cover_rest(march, coverage, slack);
    return {march.passes().begin(), march.passes().end()};
}

std::vector<LaidPass> passes_on(std::span<const LevelLine> lines,
                                const PartSamples& samples)
{
    std::vector<LaidPass> passes;
    passes.reserve(lines.size());
    for (const LevelLine& line : lines) {
        LaidPass pass{{}, line.is_closed};
        pass.contacts.reserve(line.places.size());
        for (const SampleEdge& place : line.places)
            pass.contacts.push_back(samples.contact(place));
        passes.push_back(std::move(pass));
    }
    return passes;
}

}  // namespace endmill
