// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/chord_error.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "endmill/planning/detail/iso_cuts.h"

namespace endmill {
namespace {

constexpr int least_samples = 64;  // intervals a cut
constexpr int most_samples = 4096;
constexpr double widest_pitch_mm = 1;
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

// Where the line is farthest from the chord in low … high, by golden section.
double refined_parameter(const IsoLine& line, const Cut& cut, double low, double high)
{
    constexpr double golden = 0.61803398874989485;
    const auto distance = [&](double u) {
        return distance_to_segment(line.point(u), cut.start, cut.end);
    };
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

// Halves the pitch until neighbouring samples lie close.
int sample_count(const IsoLine& line, const Cut& cut)
{
    int count = least_samples;
    double length = 0;
    for (int k = 1; k <= least_samples; ++k)
        length +=
            (line.point(std::lerp(cut.from, cut.to, k / double(least_samples))) -
             line.point(std::lerp(cut.from, cut.to, (k - 1) / double(least_samples))))
                .norm();
    while (count < most_samples && length > count * widest_pitch_mm / 4)
        count *= 2;
    return count;
}

void measure_cut(const IsoLine& line, const Cut& cut, ChordError& error)
{
    const int count = sample_count(line, cut);
    const auto parameter = [&](int sample) {
        return std::lerp(cut.from, cut.to, sample / double(count));
    };
    Vec3 previous = cut.start;
    double worst = 0;
    int worst_sample = 0;
    for (int sample = 1; sample <= count; ++sample) {
        const Vec3 point = sample < count ? line.point(parameter(sample)) : cut.end;
        error.pitch_mm = std::max(error.pitch_mm, (point - previous).norm());
        previous = point;
        const double distance = distance_to_segment(point, cut.start, cut.end);
        if (distance > worst) {
            worst = distance;
            worst_sample = sample;
        }
    }
    keep_greater(error, worst, {parameter(worst_sample), line.v()});
    const double u =
        refined_parameter(line, cut, parameter(std::max(worst_sample - 1, 0)),
                          parameter(std::min(worst_sample + 1, count)));
    keep_greater(error, distance_to_segment(line.point(u), cut.start, cut.end),
                 {u, line.v()});
}

bool may_be_worst(const IsoLine& line, const Cut& cut, const ChordError& error)
{
    const auto [low, high] = std::minmax(cut.from, cut.to);
    return line.chord_error_bound(low, high) > error.greatest_mm;
}

}  // namespace

ChordError chord_error(const Surface& surface, const ToolPath& path, Parameter along)
{
    return chord_error(std::span{&surface, 1}, path, along);
}

ChordError chord_error(std::span<const Surface> surfaces, const ToolPath& path,
                       Parameter along)
{
    ChordError error{0, 0, {0, 0}};
    for_each_iso_cut(surfaces, path, along, [&](const IsoCut& move) {
        const Cut cut{move.from, move.to, move.start.contact->contact.point,
                      move.end.contact->contact.point};
        const double before = error.greatest_mm;
        if (may_be_worst(move.line, cut, error))
            measure_cut(move.line, cut, error);
        if (error.greatest_mm > before)
            error.patch = move.start.patch;
    });
    if (along == Parameter::V)
        std::swap(error.at.u, error.at.v);
    return error;
}

}  // namespace endmill
