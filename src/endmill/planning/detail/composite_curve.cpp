// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/composite_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/surface/detail/cubic_root.h"

namespace endmill {

CompositeCurve::CompositeCurve(std::vector<Vec3> points) : points_{std::move(points)}
{
    const std::size_t count = points_.size();
    require(count >= 4 && count % 3 == 1,
            "CompositeCurve: need 3 n + 1 control points, n >= 1");
    require(std::ranges::all_of(points_, [](const Vec3& p) { return p.allFinite(); }),
            "CompositeCurve: the control points must be finite");
    for (std::size_t i = 0; i + 3 < count; i += 3) {
        const Vec3& a = points_[i];
        const Vec3& b = points_[i + 1];
        const Vec3& c = points_[i + 2];
        const Vec3& d = points_[i + 3];
        coefficients_.push_back(
            {a, 3 * (b - a), 3 * (a - 2 * b + c), d - a + 3 * (b - c)});
    }
}

int CompositeCurve::piece_number(double t) const
{
    return std::clamp(static_cast<int>(t), 0, pieces() - 1);
}

Vec3 CompositeCurve::point(double t) const
{
    const int piece = piece_number(t);
    const auto& [c0, c1, c2, c3] = coefficients_[piece];
    const double s = t - piece;
    return c0 + s * (c1 + s * (c2 + s * c3));
}

CurveJet CompositeCurve::jet(double t) const
{
    const int piece = piece_number(t);
    const auto& [c0, c1, c2, c3] = coefficients_[piece];
    const double s = t - piece;
    return {c0 + s * (c1 + s * (c2 + s * c3)), c1 + s * (2 * c2 + 3 * s * c3),
            2 * c2 + 6 * s * c3};
}

std::optional<double> CompositeCurve::first_reach(double from, const Vec3& direction,
                                                  double distance) const
{
    const double level = point(from).dot(direction) + distance;
    int piece = piece_number(from);
    double low = from - piece;
    for (; piece < pieces(); ++piece) {
        std::array<double, 4> beyond{};  // signed distance of the control points, mm
        for (int k = 0; k < 4; ++k)
            beyond[k] =
                points_[3 * static_cast<std::size_t>(piece) + k].dot(direction) - level;
        if (*std::ranges::max_element(beyond) >= 0) {
            if (low > 0)
                beyond = restrict_to_upper_end(beyond, low);
            if (const auto t = first_rise_to_zero(beyond))
                return piece + low + *t * (1 - low);
        }
        low = 0;
    }
    return std::nullopt;
}

CompositeCurve reversed(const CompositeCurve& curve)
{
    return CompositeCurve{{curve.points().rbegin(), curve.points().rend()}};
}

}  // namespace endmill
