// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/chord_error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "endmill/core/parallel.h"
#include "endmill/surface/iso_line.h"

namespace endmill {
namespace {

constexpr int samples = 16;  // intervals a cut
constexpr int refinements = 40;

double distance_to_segment(const Vec3& point, const Vec3& start, const Vec3& end)
{
    const Vec3 chord = end - start;
    const double square = chord.squaredNorm();
    const double share =
        square > 0 ? std::clamp((point - start).dot(chord) / square, 0.0, 1.0) : 0;
    return (point - start - share * chord).norm();
}

// A cut along a line, by the parameter and the contact at its two ends.
struct Cut {
    double from;
    double to;
    Vec3 start;
    Vec3 end;
};

// Greatest distance in the two samples around `middle`, by golden section.
double refined_parameter(const IsoLine& line, const Cut& cut, double middle)
{
    constexpr double golden = 0.61803398874989485;
    const double step = (cut.to - cut.from) / samples;
    const auto distance = [&](double u) {
        return distance_to_segment(line.point(u), cut.start, cut.end);
    };
    double low = middle - step;
    double high = middle + step;
    double inner_low = high - golden * (high - low);
    double inner_high = low + golden * (high - low);
    double at_low = distance(inner_low);
    double at_high = distance(inner_high);
    for (int k = 0; k < refinements; ++k) {
        if (at_low > at_high) {
            high = std::exchange(inner_high, inner_low);
            at_high = at_low;
            at_low = distance(inner_low = high - golden * (high - low));
        } else {
            low = std::exchange(inner_low, inner_high);
            at_low = at_high;
            at_high = distance(inner_high = low + golden * (high - low));
        }
    }
    return (low + high) / 2;
}

void keep_greater(ChordError& error, double distance, const SurfacePoint& at)
{
    if (distance > error.greatest_mm) {
        error.greatest_mm = distance;
        error.at = at;
    }
}

void measure_cut(const IsoLine& line, const Cut& cut, ChordError& error)
{
    Vec3 previous = cut.start;
    double worst = 0;
    double worst_parameter = cut.from;
    for (int sample = 1; sample <= samples; ++sample) {
        const double u = std::lerp(cut.from, cut.to, sample / double(samples));
        const Vec3 point = sample < samples ? line.point(u) : cut.end;
        error.pitch_mm = std::max(error.pitch_mm, (point - previous).norm());
        previous = point;
        const double distance = distance_to_segment(point, cut.start, cut.end);
        if (distance > worst) {
            worst = distance;
            worst_parameter = u;
        }
    }
    // Refining pays only where the sample could be the worst of all.
    if (worst <= 0.9 * error.greatest_mm)
        return;
    keep_greater(error, worst, {worst_parameter, line.v()});
    const double u = refined_parameter(line, cut, worst_parameter);
    keep_greater(error, distance_to_segment(line.point(u), cut.start, cut.end),
                 {u, line.v()});
}

ChordError measure_pass(const Surface& surface, std::span<const PathPoint> pass,
                        Parameter along)
{
    const auto parameters = [&](const PathPoint& point) {
        const auto& [u, v, contact] = *point.contact;
        return along == Parameter::U ? SurfacePoint{u, v} : SurfacePoint{v, u};
    };
    ChordError error{0, 0, {0, 0}};
    std::optional<IsoLine> line;
    for (std::size_t k = 1; k < pass.size(); ++k) {
        if (pass[k].move != Move::Cut)
            continue;
        const SurfacePoint from = parameters(pass[k - 1]);
        const SurfacePoint to = parameters(pass[k]);
        if (!line)
            line.emplace(surface, from.v);
        measure_cut(*line,
                    {from.u, to.u, pass[k - 1].contact->contact.point,
                     pass[k].contact->contact.point},
                    error);
    }
    return error;
}

std::vector<std::span<const PathPoint>> split_into_passes(const ToolPath& path)
{
    std::vector<std::span<const PathPoint>> passes;
    auto begin = path.points.begin();
    while (begin != path.points.end()) {
        const auto end = std::find_if(begin, path.points.end(), [&](const PathPoint& p) {
            return p.pass != begin->pass;
        });
        passes.emplace_back(begin, end);
        begin = end;
    }
    return passes;
}

}  // namespace

ChordError chord_error(const Surface& surface, const ToolPath& path, Parameter along)
{
    const Surface turned = along == Parameter::U ? surface : transposed(surface);
    const auto passes = split_into_passes(path);
    std::vector<ChordError> errors(passes.size());
    parallel_for(passes.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            errors[k] = measure_pass(turned, passes[k], along);
    });
    ChordError whole{0, 0, {0, 0}};
    for (const ChordError& error : errors) {
        keep_greater(whole, error.greatest_mm, error.at);
        whole.pitch_mm = std::max(whole.pitch_mm, error.pitch_mm);
    }
    if (along == Parameter::V)
        std::swap(whole.at.u, whole.at.v);
    return whole;
}

}  // namespace endmill
