// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/cover_front.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "endmill/core/parallel.h"

// How the distance between passes is found:
// 1. The pass at v is sampled: ball centres at places R / 8 apart or closer.
// 2. For each sample, a bracketed search in v along u = constant finds the front point,
//    where the point raised by the scallop height lies just R from the nearest ball
//    centre of the pass.
// 3. A second search moves a trial pass away from the first one. Its excess is the
//    greatest distance, less R, of a raised front point from the centres of the trial
//    pass. The next pass lies where the excess is zero. The nearest centre of a pass is
//    found by descent from a sample and refined by a parabola through three squared
//    distances.

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Sample spacing is at most one over this many radii.
constexpr double samples_per_radius = 8;
// Least and greatest number of samples of a patch.
constexpr double least_samples = 32;
constexpr double most_samples = 1024;
// Lines of a patch that are measured to find the length of the longest pass.
constexpr int measured_lines = 5;
// Accuracy of the next pass, as a share of the interval between the passes.
constexpr double same_interval = 2e-4;
// Accuracy of the front, as a share of the width that a pass covers.
constexpr double same_front = 1e-6;
// Most iterations of a bracketed search.
constexpr int most_iterations = 60;

// An interval that contains a root: the function is negative or zero at `low`, positive
// at `high`.
struct Bracket {
    double low;
    double at_low;
    double high;
    double at_high;
};

// Narrows the bracket to `width` and returns its lower end. The method is regula falsi
// that halves the function value at an end that stays twice (Illinois method).
template <class Function>
double last_not_above(Bracket b, double width, const Function& function)
{
    int same_side = 0;
    for (int k = 0; k < most_iterations && b.high - b.low > width; ++k) {
        double share = b.at_low / (b.at_low - b.at_high);
        if (!(share > 0 && share < 1))
            share = 0.5;
        // The trial point keeps half of `width` from both ends. Otherwise one end might
        // stay and the bracket would not become narrow.
        const double margin = std::min(0.5, width / 2 / (b.high - b.low));
        const double middle =
            std::lerp(b.low, b.high, std::clamp(share, margin, 1 - margin));
        const double at_middle = function(middle);
        if (at_middle <= 0) {
            b.low = middle;
            b.at_low = at_middle;
            same_side = std::min(same_side, 0) - 1;
            if (same_side < -1)
                b.at_high /= 2;
        } else {
            b.high = middle;
            b.at_high = at_middle;
            same_side = std::max(same_side, 0) + 1;
            if (same_side > 1)
                b.at_low /= 2;
        }
    }
    return b.low;
}

}  // namespace

CoverFront::CoverFront(const MarchedSurface& marched, const BallCutter& cutter,
                       double scallop_height, Parameter direction, double offset)
    : marched_{&marched},
      cutter_{cutter},
      height_{scallop_height + offset},
      scallop_height_{scallop_height},
      offset_{offset},
      direction_{direction},
      parameters_{sample_parameters()}
{
}

// The parameters of the samples. The longest of some lines of each column of patches
// determines their number.
std::vector<double> CoverFront::sample_parameters() const
{
    const Surface& surface = marched_->surface;
    const auto breaks = surface.breaks(Parameter::U);
    const auto breaks_v = surface.breaks(Parameter::V);
    std::vector<double> lengths(breaks.size() - 1, 0.0);
    for (std::size_t j = 0; j + 1 < breaks_v.size(); ++j)
        for (int line = 0; line < measured_lines; ++line) {
            const IsoLine iso{surface, std::lerp(breaks_v[j], breaks_v[j + 1],
                                                 line / double(measured_lines - 1))};
            for (std::size_t i = 0; i < lengths.size(); ++i) {
                double length = 0;
                Vec3 previous = iso.point(breaks[i]);
                for (int k = 1; k <= 8; ++k) {
                    const Vec3 point =
                        iso.point(std::lerp(breaks[i], breaks[i + 1], k / 8.0));
                    length += (point - previous).norm();
                    previous = point;
                }
                lengths[i] = std::max(lengths[i], length);
            }
        }
    std::vector<double> parameters;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        const int count = static_cast<int>(
            std::clamp(std::ceil(samples_per_radius * lengths[i] / cutter_.radius()),
                       least_samples, most_samples));
        for (int k = 0; k < count; ++k)
            parameters.push_back(std::lerp(breaks[i], breaks[i + 1], k / double(count)));
    }
    parameters.push_back(breaks.back());
    return parameters;
}

PassSamples CoverFront::samples(double v) const
{
    const ContactLine line{*marched_, v, direction_};
    PassSamples pass{v, parameters_, {}};
    pass.centres.reserve(parameters_.size());
    for (const double u : parameters_)
        pass.centres.push_back(ball_centre(offset_contact(line.at(u), offset_), cutter_));
    return pass;
}

CoverFront::Foot CoverFront::foot(const PassSamples& pass, const Vec3& point,
                                  std::size_t start)
{
    const auto square = [&](std::size_t k) {
        return (point - pass.centres[k]).squaredNorm();
    };
    std::size_t best = start;
    double least = square(best);
    for (const int step : {1, -1})
        while (true) {
            const std::size_t next = best + step;  // wraps to a huge number below 0
            if (next >= pass.centres.size())
                break;
            const double at_next = square(next);
            if (at_next >= least)
                break;
            best = next;
            least = at_next;
        }
    if (best == 0 || best + 1 == pass.centres.size())
        return {std::sqrt(least), pass.u[best]};
    // The minimum of the parabola through the squared distances of three neighbouring
    // samples, which are taken as equidistant.
    const double before = square(best - 1);
    const double after = square(best + 1);
    const double bend = before + after - 2 * least;
    const double shift =
        bend > 0 ? std::clamp((before - after) / (2 * bend), -1.0, 1.0) : 0;
    const double u = pass.u[best] + (shift < 0 ? pass.u[best] - pass.u[best - 1]
                                               : pass.u[best + 1] - pass.u[best]) *
                                        shift;
    const double lowest = least - (before - after) * shift / 4;
    return {std::sqrt(std::max(0.0, lowest)), u};
}

Vec3 CoverFront::raised(const SurfaceContact& contact) const
{
    return contact.contact.point + height_ * contact.contact.normal;
}

FrontPoint CoverFront::front_at(const PassSamples& pass, std::size_t sample,
                                double guess) const
{
    const double end = marched_->surface.range(Parameter::V).high;
    const double u = pass.u[sample];
    const auto contact = [&](double v) {
        return contact_at(*marched_, {u, v}, direction_);
    };
    const auto excess = [&](double v) {
        return foot(pass, raised(contact(v)), sample).distance - cutter_.radius();
    };
    Bracket bracket{pass.v, -scallop_height_, pass.v, -scallop_height_};
    double step = guess;
    while (bracket.at_high <= 0 && bracket.high < end) {
        bracket.low = bracket.high;
        bracket.at_low = bracket.at_high;
        bracket.high = std::min(end, bracket.high + step);
        bracket.at_high = excess(bracket.high);
        step *= 1.5;
    }
    const double v =
        bracket.at_high <= 0
            ? end
            : last_not_above(bracket, same_front * (bracket.high - pass.v), excess);
    const SurfaceContact front = contact(v);
    return {front, foot(pass, raised(front), sample).u};
}

std::vector<FrontPoint> CoverFront::front(const PassSamples& pass, double guess) const
{
    std::vector<FrontPoint> front(pass.u.size());
    parallel_for(front.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            front[k] = front_at(pass, k, guess);
    });
    return front;
}

// Greatest distance in mm, less R, of the raised points of `front` from the ball centres
// of the pass at v. Only front points before v count. Where the front lies beyond v, the
// first pass covers everything up to the trial pass.
double CoverFront::excess(double v, std::span<const FrontPoint> front) const
{
    const PassSamples pass = samples(v);
    double most = -infinity;
    for (std::size_t k = 0; k < front.size(); ++k)
        if (front[k].contact.v < v)
            most = std::max(most, foot(pass, raised(front[k].contact), k).distance -
                                      cutter_.radius());
    return most;
}

// The search starts at the nearest front point, because no front point lies before a pass
// there.
double CoverFront::next_pass(double v, std::span<const FrontPoint> front) const
{
    const double end = marched_->surface.range(Parameter::V).high;
    double nearest = end;
    for (const FrontPoint& point : front)
        nearest = std::min(nearest, point.contact.v);
    if (nearest >= end)
        return end;
    const auto function = [&](double next) { return excess(next, front); };
    Bracket bracket{nearest, -scallop_height_, nearest, -scallop_height_};
    // The next pass usually lies about as far beyond the front as the front beyond the
    // pass. Further steps are shorter.
    double step = nearest - v;
    while (bracket.at_high <= 0 && bracket.high < end) {
        bracket.low = bracket.high;
        bracket.at_low = bracket.at_high;
        bracket.high = std::min(end, bracket.high + step);
        bracket.at_high = function(bracket.high);
        step = (nearest - v) / 4;
    }
    if (bracket.at_high <= 0)
        return end;
    return last_not_above(bracket, same_interval * (bracket.low - v), function);
}

}  // namespace endmill
