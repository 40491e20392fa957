// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/reached_share.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace endmill {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr double infinite = std::numeric_limits<double>::infinity();
// Share by which the radius is enlarged, for rounding errors. Coordinates may be a thousand
// times the radius.
constexpr double rounding_share = 1e-9;

double cross(const Vec2& a, const Vec2& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

// The places from which a disc reaches a triangle are the triangle and three capsules around its
// sides. The stretch of a line inside this convex set ends at the outermost ends of its
// stretches inside the capsules, unless it begins or ends inside the triangle.
class Reach {
public:
    Reach(const Vec2& from, const Vec2& to, double radius)
        : from_{from},
          along_{to - from},
          length2_{along_.squaredNorm()},
          radius_{radius * (1 + rounding_share)}
    {
    }

    // Adds the shares at which the disc reaches the point.
    void add_point(const Vec2& point)
    {
        const Vec2 away = point - from_;
        if (!(length2_ > 0)) {
            if (away.norm() <= radius_)
                add(0, 1);
            return;
        }
        const double middle = away.dot(along_) / length2_;
        const double beside2 = (away - middle * along_).squaredNorm();
        const double half2 = (radius_ * radius_ - beside2) / length2_;
        if (half2 >= 0)
            add(middle - std::sqrt(half2), middle + std::sqrt(half2));
    }

    // Adds the shares at which the disc reaches the side between its ends.
    void add_side(const Vec2& a, const Vec2& b)
    {
        const Vec2 side = b - a;
        const double size2 = side.squaredNorm();
        if (!(size2 > 0))
            return;
        // 0 <= (p - a) . side <= size2, and |cross(side, p - a)| <= radius |side|
        const Vec2 away = from_ - a;
        const double reach = radius_ * std::sqrt(size2);
        const Range along = shares_within({away.dot(side), along_.dot(side)}, {0, size2});
        const Range beside =
            shares_within({cross(side, away), cross(side, along_)}, {-reach, reach});
        const double low = std::max({0.0, along.low, beside.low});
        const double high = std::min({1.0, along.high, beside.high});
        if (low <= high)
            add(low, high);
    }

    std::optional<std::pair<double, double>> found() const
    {
        const double low = std::max(0.0, low_);
        const double high = std::min(1.0, high_);
        if (!(low <= high))
            return std::nullopt;
        return std::pair{low, high};
    }

    void add(double low, double high)
    {
        low_ = std::min(low_, low);
        high_ = std::max(high_, high);
    }

private:
    struct Range {
        double low;
        double high;
    };
    // A linear function of the share.
    struct Linear {
        double value;  // at share 0
        double rate;
    };

    // The shares at which the function lies within a range.
    static Range shares_within(const Linear& function, const Range& range)
    {
        if (function.rate == 0)
            return range.low <= function.value && function.value <= range.high
                       ? Range{-infinite, infinite}
                       : Range{infinite, -infinite};
        const double one = (range.low - function.value) / function.rate;
        const double other = (range.high - function.value) / function.rate;
        return {std::min(one, other), std::max(one, other)};
    }

    Vec2 from_;
    Vec2 along_;
    double length2_;
    double radius_;
    double low_ = infinite;
    double high_ = -infinite;
};

bool contains(const std::array<Vec2, 3>& corners, const Vec2& place)
{
    const double one = cross(corners[1] - corners[0], place - corners[0]);
    const double two = cross(corners[2] - corners[1], place - corners[1]);
    const double three = cross(corners[0] - corners[2], place - corners[2]);
    return (one >= 0 && two >= 0 && three >= 0) || (one <= 0 && two <= 0 && three <= 0);
}

}  // namespace

std::optional<std::pair<double, double>> reached_share(const std::array<Vec3, 3>& corners,
                                                       const Vec2& from, const Vec2& to,
                                                       double radius)
{
    const std::array<Vec2, 3> flat{corners[0].head<2>(), corners[1].head<2>(),
                                   corners[2].head<2>()};
    Reach reach{from, to, radius};
    for (std::size_t k = 0; k < 3; ++k) {
        reach.add_point(flat[k]);
        reach.add_side(flat[k], flat[(k + 1) % 3]);
    }
    if (contains(flat, from))
        reach.add(0, 0);
    if (contains(flat, to))
        reach.add(1, 1);
    return reach.found();
}

}  // namespace endmill
