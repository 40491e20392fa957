// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/cover_boundary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "endmill/bound/detail/raised_point.h"

namespace endmill {
namespace {

// Change of r^2, as a share of it, at which a root is accepted. The change is applied, so
// that its error is about the square. The flow is taken where the change was computed: r
// divided by the slope hardly depends on r, so that the flow is accurate to about 1e-4.
constexpr double root_accuracy = 2e-3;
// Steps after which a ray is given up. Newton's method takes one or two.
constexpr int most_steps = 60;
// Halvings of the angle between a ray that ends at the boundary of D(x) and one that ends at
// the border.
constexpr int end_halvings = 10;
// Rays shorter than this share of the half axis start at the border.
constexpr double shortest_ray = 1e-9;
// Largest r^2 that is searched. The flank of an upright tool may cover a wall without end.
constexpr double farthest = 1e6;
// A point farther from the contact than the rays by this factor in r^2 belongs to another
// component of D(x).
constexpr double component_margin = 1.5;

}  // namespace

Eigen::Vector2d boundary_flow(const ContactFrame& frame, const BoundProblem& problem,
                              const Vec3& away, double rate)
{
    const double R =
        problem.length == BoundedLength::Contact ? problem.cutter.radius() : 0;
    return {rate * (1 + R * frame.k.least) * away.dot(frame.e1),
            rate * (1 + R * frame.k.greatest) * away.dot(frame.e2)};
}

CoverRays::CoverRays(const BoundedPart& part, const BoundProblem& problem,
                     const ContactFrame& frame, int rays)
    : part_{part},
      problem_{problem},
      frame_{frame},
      tool_{problem, frame.centre},
      scale_{
          std::abs(frame.along_1.a * frame.along_2.b - frame.along_1.b * frame.along_2.a)}
{
    ends_.resize(static_cast<std::size_t>(rays));
    for (std::size_t k = 0; k < ends_.size(); ++k) {
        ends_[k] = end_of(ray_at(angle_of(static_cast<double>(k))), guess_at(k));
        if (!is_complete_)
            return;
    }
    add_boundary();
}

// The parabola through the ends of the last three rays, if they are at the boundary.
double CoverRays::guess_at(std::size_t number) const
{
    const auto is_inside = [&](std::size_t back) {
        return number >= back && ends_[number - back].is_inside;
    };
    if (!is_inside(1))
        return 1;
    const double last = ends_[number - 1].r;
    if (!is_inside(2) || !is_inside(3))
        return last;
    return std::max(last / 2, 3 * (last - ends_[number - 2].r) + ends_[number - 3].r);
}

double CoverRays::angle_of(double number) const
{
    return 2 * std::numbers::pi * number / static_cast<double>(ends_.size());
}

CoverRays::Ray CoverRays::ray_at(double angle) const
{
    const double x = std::cos(angle);
    const double y = std::sin(angle);
    return {x * frame_.along_1.a + y * frame_.along_2.a,
            x * frame_.along_1.b + y * frame_.along_2.b};
}

// The r at which a ray leaves the range of the parameters.
double CoverRays::border(const Ray& ray) const
{
    const auto leaves = [](double from, double step, Interval range) {
        if (step == 0)
            return std::numeric_limits<double>::infinity();
        return std::max(0.0, ((step > 0 ? range.high : range.low) - from) / step);
    };
    const Surface& surface = part_.surfaces[frame_.surface];
    return std::min(leaves(frame_.at.u, ray.u, surface.range(Parameter::U)),
                    leaves(frame_.at.v, ray.v, surface.range(Parameter::V)));
}

CoverRays::Probe CoverRays::probe(const Ray& ray, double r) const
{
    const SurfacePoint at{frame_.at.u + r * ray.u, frame_.at.v + r * ray.v};
    const RaisedJet raised =
        raised_jet(part_, frame_.surface, at, problem_.scallop_height);
    const Vec3 away = tool_.from_nearest(raised.point);
    return {at,
            r,
            away.squaredNorm() - tool_.reach() * tool_.reach(),
            2 * away.dot(ray.u * raised.du + ray.v * raised.dv),
            away,
            raised.area};
}

// Newton's change of r^2; a step outwards where the excess does not rise.
double CoverRays::change_of_square(const Probe& here)
{
    return here.slope > 0 ? -here.excess * 2 * here.r / here.slope : here.r * here.r;
}

// Newton's method in r^2, in which the excess is nearly linear, kept between points inside
// and outside.
CoverRays::End CoverRays::end_of(const Ray& ray, double guess)
{
    const double last = border(ray);
    if (last < shortest_ray)
        return {probe(ray, 0), 0, false};
    double inside = 0;
    double outside = std::min(last * last, farthest);
    bool is_outside_known = false;
    double square = guess * guess;
    for (int step = 0; step < most_steps; ++step) {
        if (!is_outside_known && square >= outside) {
            const Probe end = probe(ray, std::sqrt(outside));
            if (end.excess <= 0) {
                is_complete_ = outside < farthest && end.area > 0;
                return {end, end.r, false};
            }
            is_outside_known = true;
        }
        if (!(inside < square && square < outside))
            square = (inside + outside) / 2;
        const Probe here = probe(ray, std::sqrt(square));
        if (here.area == 0)
            break;
        (here.excess > 0 ? outside : inside) = square;
        is_outside_known = is_outside_known || here.excess > 0;
        const double change = change_of_square(here);
        if (std::abs(change) <= root_accuracy * square)
            return {here, std::sqrt(square + change), true};
        square += std::min(change, 3 * square);
    }
    is_complete_ = false;
    return {};
}

void CoverRays::add(const Probe& probe, double step)
{
    const double distance = std::sqrt(probe.excess + tool_.reach() * tool_.reach());
    const double slope = probe.slope / (2 * distance);
    const double rate = step * probe.area * scale_ * probe.r / slope;
    boundary_.push_back({frame_.surface, probe.at,
                         boundary_flow(frame_, problem_, probe.away / distance, rate)});
}

// The trapezoidal rule over each arc of rays that end at the boundary of D(x).
void CoverRays::add_boundary()
{
    const std::size_t count = ends_.size();
    const double step = angle_of(1);
    boundary_.reserve(count + 4);
    for (std::size_t k = 0; k < count; ++k) {
        if (!ends_[k].is_inside)
            continue;
        const bool has_next = ends_[(k + 1) % count].is_inside;
        const bool has_last = ends_[(k + count - 1) % count].is_inside;
        add(ends_[k].probe, ((has_next ? 0.5 : 0) + (has_last ? 0.5 : 0)) * step);
        if (!has_next)
            add_last(k, true);
        if (!has_last)
            add_last(k, false);
    }
}

// The end of an arc between ray `inside` and the next or the one before it, which ends at
// the border.
void CoverRays::add_last(std::size_t inside, bool is_ahead)
{
    const double step = is_ahead ? angle_of(1) : -angle_of(1);
    const double from = angle_of(static_cast<double>(inside));
    double share = 0;
    for (double half = 0.5; half > std::ldexp(0.7, -end_halvings); half /= 2) {
        const Ray ray = ray_at(from + (share + half) * step);
        const double last = border(ray);
        if (last >= shortest_ray && probe(ray, last).excess > 0)
            share += half;
    }
    const double half_step = share * angle_of(1) / 2;
    add(ends_[inside].probe, half_step);
    const Ray ray = ray_at(from + share * step);
    const End end = end_of(ray, std::min(ends_[inside].r, border(ray)));
    if (end.is_inside)
        add(end.probe, half_step);
}

double CoverRays::elongation() const
{
    double greatest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (const End& end : ends_)
        if (end.is_inside) {
            greatest = std::max(greatest, end.r);
            least = std::min(least, end.r);
        }
    return greatest > 0 ? greatest / least : 1;
}

bool CoverRays::contains(const SurfacePoint& at) const
{
    const double u = at.u - frame_.at.u;
    const double v = at.v - frame_.at.v;
    const double determinant =
        frame_.along_1.a * frame_.along_2.b - frame_.along_1.b * frame_.along_2.a;
    const double x = (u * frame_.along_2.b - v * frame_.along_2.a) / determinant;
    const double y = (v * frame_.along_1.a - u * frame_.along_1.b) / determinant;
    const std::size_t count = ends_.size();
    const double turn = std::atan2(y, x) / (2 * std::numbers::pi);
    const double place = (turn < 0 ? turn + 1 : turn) * static_cast<double>(count);
    const auto before = static_cast<std::size_t>(place) % count;
    const double r = std::max(ends_[before].r, ends_[(before + 1) % count].r);
    return x * x + y * y <= component_margin * r * r;
}

std::vector<CoveredPiece> CoverRays::covered() const
{
    // Gauss's rule with two points for the integral of r dr = d(r^2) / 2.
    constexpr double gauss = 0.21132486540518713;
    std::vector<CoveredPiece> pieces;
    for (std::size_t k = 0; k < ends_.size(); ++k) {
        const double r = ends_[k].r;
        const Ray ray = ray_at(angle_of(static_cast<double>(k)));
        for (const double share : {gauss, 1 - gauss}) {
            const double at_r = r * std::sqrt(share);
            const SurfacePoint at{frame_.at.u + at_r * ray.u, frame_.at.v + at_r * ray.v};
            const double area =
                raised_place(part_, frame_.surface, at, problem_.scallop_height).area;
            pieces.push_back(
                {frame_.surface, at, angle_of(1) * scale_ * r * r / 4 * area});
        }
    }
    return pieces;
}

}  // namespace endmill
