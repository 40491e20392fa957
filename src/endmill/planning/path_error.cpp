// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/path_error.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "endmill/planning/detail/iso_cuts.h"
#include "endmill/planning/detail/segment_distance.h"

// The chord error is sampled, as a user of the paper would measure it.
//
// The motion error is a bound over all points of the line. It relies on the convexity of
// the distance from the straight way of the ball centre:
// 1. An interval of the line deviates from its chord by at most w^2 / 8 times the bound
//    on its second derivative, where w is its width.
// 2. The distance of the chord from the way is greatest at an end of the chord. This
//    bounds the remaining stock on the interval.
// 3. The distance is nowhere below that from the plane through the point of the way
//    nearest to the chord's middle, perpendicular to the direction from there to the
//    middle. This bounds the gouge on the interval.
// 4. If neither bound exceeds what was already measured, the interval is done. Otherwise
//    it is halved, and its middle is measured.

namespace endmill {
namespace {

// Least and greatest number of sample intervals of a cut.
constexpr int least_samples = 64;
constexpr int most_samples = 4096;
// Greatest mean distance in mm between the samples of a cut, while there are less than
// the greatest number. The worst sample is refined afterwards.
constexpr double mean_pitch_mm = 0.25;
// Steps of the golden section: they narrow two sample intervals by 4e-9.
constexpr int refinements = 40;

// The same as segment_distance but for the order of its roundings. Stored chord errors
// depend on the last digit.
double distance_to_segment(const Vec3& point, const Vec3& start, const Vec3& end)
{
    const Vec3 chord = end - start;
    const double square = chord.squaredNorm();
    const double share =
        square > 0 ? std::clamp((point - start).dot(chord) / square, 0.0, 1.0) : 0;
    return (point - start - share * chord).norm();
}

// A cut along a line: parameter and contact of both ends.
struct Cut {
    double from;
    double to;
    Vec3 start;
    Vec3 end;
};

// The parameter in [low, high] at which the line is farthest from the chord, by golden
// section.
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

// Number of sample intervals of a cut: doubled until their mean length is small enough.
int sample_count(const IsoLine& line, const Cut& cut)
{
    int count = least_samples;
    double length = 0;
    for (int k = 1; k <= least_samples; ++k)
        length +=
            (line.point(std::lerp(cut.from, cut.to, k / double(least_samples))) -
             line.point(std::lerp(cut.from, cut.to, (k - 1) / double(least_samples))))
                .norm();
    while (count < most_samples && length > count * mean_pitch_mm)
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

// Whether the bound on the second derivative allows a greater error than the one found so
// far.
bool may_be_worst(const IsoLine& line, const Cut& cut, const ChordError& error)
{
    const auto [low, high] = std::minmax(cut.from, cut.to);
    return line.chord_error_bound(low, high) > error.greatest_mm;
}

// Accuracy of the motion error, as a share of the radius. It is far below any tolerance.
constexpr double resolution_per_radius = 1e-6;
// Most halvings of an interval. Each divides its deviation from the chord by 4.
constexpr int most_halvings = 40;

// A straight move of the ball centre beside the line between two parameters.
struct CentreMove {
    double from;
    double to;
    Vec3 start;
    Vec3 end;
};

// An interval of the line, with a bound on its deviation from its chord.
struct LineInterval {
    double low;
    double high;
    Vec3 at_low;
    Vec3 at_high;
    double bend;  // bound on the second derivative, mm per squared unit of u
    int halvings;

    double chord_error() const { return (high - low) * (high - low) / 8 * bend; }
};

// Keeps the greatest deviations of the moves measured so far.
class MotionMeter {
public:
    explicit MotionMeter(double radius)
        : radius_{radius},
          error_{{}, {}, resolution_per_radius * radius}
    {
    }

    // Measures one move. The line is first divided at the borders of patches, where its
    // second derivative may jump.
    void measure(const IsoLine& line, const CentreMove& move, int patch,
                 std::span<const double> breaks)
    {
        const auto [low, high] = std::minmax(move.from, move.to);
        std::vector<LineInterval> open;
        double from = low;
        for (const double border : breaks)
            if (low < border && border < high) {
                open.push_back(interval(line, from, border));
                from = border;
            }
        open.push_back(interval(line, from, high));
        for (const double u : {low, high})
            note(line.point(u), u, line, move, patch);
        while (!open.empty()) {
            const LineInterval next = std::move(open.back());
            open.pop_back();
            if (is_settled(next, move))
                continue;
            const double middle = (next.low + next.high) / 2;
            const Vec3 at_middle = line.point(middle);
            note(at_middle, middle, line, move, patch);
            const int halvings = next.halvings + 1;
            open.push_back(
                {next.low, middle, next.at_low, at_middle, next.bend, halvings});
            open.push_back(
                {middle, next.high, at_middle, next.at_high, next.bend, halvings});
        }
    }

    const MotionError& error() const { return error_; }

private:
    static LineInterval interval(const IsoLine& line, double low, double high)
    {
        return {low, high, line.point(low), line.point(high), line.bend_bound(low, high),
                0};
    }

    // Updates the deviations by one point of the line.
    void note(const Vec3& point, double u, const IsoLine& line, const CentreMove& move,
              int patch)
    {
        const double outside = segment_distance(point, move.start, move.end) - radius_;
        LineDeviation& deviation = outside > 0 ? error_.remaining : error_.gouge;
        if (std::abs(outside) > deviation.greatest_mm)
            deviation = {std::abs(outside), {u, line.v()}, patch};
    }

    // Whether no point of the interval deviates by more than was already measured, see
    // the steps 2 and 3 above.
    bool is_settled(const LineInterval& interval, const CentreMove& move) const
    {
        if (interval.halvings == most_halvings)
            return true;
        const double deviation = interval.chord_error();
        const auto distance = [&](const Vec3& point) {
            return segment_distance(point, move.start, move.end);
        };
        const double greatest =
            std::max(distance(interval.at_low), distance(interval.at_high)) + deviation;
        if (greatest - radius_ > error_.remaining.greatest_mm + error_.bound_mm)
            return false;
        const Vec3 middle = (interval.at_low + interval.at_high) / 2;
        const Vec3 nearest = nearest_on_segment(middle, move.start, move.end);
        const Vec3 away = (middle - nearest).stableNormalized();
        const double least =
            std::max(0.0, std::min(away.dot(interval.at_low - nearest),
                                   away.dot(interval.at_high - nearest)) -
                              deviation);
        return radius_ - least <= error_.gouge.greatest_mm + error_.bound_mm;
    }

    double radius_;
    MotionError error_;
};

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
        const Cut cut{move.from, move.to, move.start.contact()->contact.point,
                      move.end.contact()->contact.point};
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

double MotionError::greatest_mm() const
{
    return std::max(gouge.greatest_mm, remaining.greatest_mm);
}

MotionError motion_error(std::span<const Surface> surfaces, const ToolPath& path,
                         const BallCutter& cutter, Parameter along)
{
    const auto centre = [&](const PathPoint& point) -> Vec3 {
        return point.location.tip + cutter.radius() * point.location.axis;
    };
    MotionMeter meter{cutter.radius()};
    for_each_iso_cut(surfaces, path, along, [&](const IsoCut& move) {
        meter.measure(move.line,
                      {move.from, move.to, centre(move.start), centre(move.end)},
                      move.start.patch, move.surface.breaks(Parameter::U));
    });
    MotionError error = meter.error();
    if (along == Parameter::V)
        for (LineDeviation* deviation : {&error.gouge, &error.remaining})
            std::swap(deviation->at.u, deviation->at.v);
    return error;
}

PathErrors path_errors(const ChordError& chord, const MotionError& motion,
                       double gouge_mm, double scallop_mm)
{
    return {chord.greatest_mm, std::max(gouge_mm, motion.gouge.greatest_mm), scallop_mm};
}

std::set<PathLimit> missed_limits(const PathErrors& errors, const PathErrors& limits)
{
    std::set<PathLimit> missed;
    if (errors.chord > limits.chord)
        missed.insert(PathLimit::Chord);
    if (errors.gouge > limits.gouge)
        missed.insert(PathLimit::Gouge);
    if (errors.scallop > limits.scallop)
        missed.insert(PathLimit::Scallop);
    return missed;
}

}  // namespace endmill
