// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/section_curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "endmill/core/error.h"

namespace endmill {
namespace {

bool is_before(const SectionPoint& a, const SectionPoint& b)
{
    return std::pair{a.x(), a.y()} < std::pair{b.x(), b.y()};
}

void turn(SectionCurve& curve)
{
    auto& points = curve.points;
    if (!curve.is_closed) {
        if (points.front().x() > points.back().x())
            std::ranges::reverse(points);
        return;
    }
    points.pop_back();
    std::rotate(points.begin(), std::ranges::min_element(points, is_before),
                points.end());
    points.push_back(points.front());
}

// Share by which the tolerance is reduced, for rounding.
constexpr double rounding_share = 1e-9;

double cross(const SectionPoint& a, const SectionPoint& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

// The directions from one point of which every line passes all later points within the
// tolerance. It is narrower than 180 degrees as soon as it is limited at all.
class Cone {
public:
    Cone(const SectionPoint& apex, double tolerance) : apex_{apex}, tolerance_{tolerance}
    {
    }

    // Whether the chord to `point` passes all points so far within the tolerance. Between
    // its ends, because the distances from the apex may not fall.
    bool allows(const SectionPoint& point) const
    {
        const SectionPoint away = point - apex_;
        return away.norm() >= farthest_ &&
               (!is_limited_ || (cross(right_, away) >= 0 && cross(away, left_) >= 0));
    }

    // Limits the directions to those that pass `point` within the tolerance.
    void limit_to(const SectionPoint& point)
    {
        const SectionPoint away = point - apex_;
        farthest_ = away.norm();
        if (farthest_ <= tolerance_)
            return;
        const double sine = tolerance_ / farthest_;
        const double cosine = std::sqrt((1 - sine) * (1 + sine));
        const SectionPoint along = away / farthest_;
        const SectionPoint beside{-along.y(), along.x()};
        const SectionPoint right = cosine * along - sine * beside;
        const SectionPoint left = cosine * along + sine * beside;
        if (!is_limited_ || cross(right_, right) > 0)
            right_ = right;
        if (!is_limited_ || cross(left, left_) > 0)
            left_ = left;
        is_limited_ = true;
    }

private:
    SectionPoint apex_;
    double tolerance_;
    double farthest_ = 0;
    bool is_limited_ = false;
    SectionPoint right_ = SectionPoint::Zero();
    SectionPoint left_ = SectionPoint::Zero();
};

}  // namespace

std::vector<std::size_t> thinned(std::span<const SectionPoint> points, double tolerance)
{
    require(std::isfinite(tolerance) && tolerance >= 0, "thinned: need 0 <= tolerance");
    std::vector<std::size_t> kept;
    for (std::size_t begin = 0; begin < points.size();) {
        kept.push_back(begin);
        std::size_t end = begin + 1;
        Cone cone{points[begin], tolerance * (1 - rounding_share)};
        while (tolerance > 0 && end + 1 < points.size()) {
            cone.limit_to(points[end]);
            if (!cone.allows(points[end + 1]))
                break;
            ++end;
        }
        begin = end;
    }
    return kept;
}

std::vector<SectionCurve> arranged(std::vector<SectionCurve> curves)
{
    std::ranges::for_each(curves, turn);
    std::vector<std::pair<SectionPoint, SectionCurve>> keyed;
    for (SectionCurve& curve : curves) {
        const SectionPoint least = *std::ranges::min_element(curve.points, is_before);
        keyed.emplace_back(least, std::move(curve));
    }
    std::ranges::stable_sort(
        keyed, [](const auto& a, const auto& b) { return is_before(a.first, b.first); });
    std::ranges::transform(keyed, curves.begin(),
                           [](auto& pair) { return std::move(pair.second); });
    return curves;
}

}  // namespace endmill
