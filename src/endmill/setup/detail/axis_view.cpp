// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/axis_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;

/// Sine of an angle from the axis below which a cell counts as lying on it. The rounding
/// of unit vectors is 1e-16, and no machine resolves 1e-12 rad.
constexpr double on_axis = 1e-12;

/// Longest part of an interval of azimuths, in radii. Short parts improve the bound of
/// the sweep, which depends on the differences of their lengths; most intervals are a
/// little longer than 2 radii and are not cut.
constexpr double longest_part = 3;

double in_one_turn(double azimuth)
{
    const double positive = azimuth < 0 ? azimuth + 2 * pi : azimuth;
    return positive < 2 * pi ? positive : positive - 2 * pi;
}

/// Adds one cell after the other to a view.
class Viewer {
public:
    explicit Viewer(const AxisPlace& place)
        : place_{place},
          zero_{azimuth_zero(place.axis)},
          quarter_{place.axis.cross(zero_)},
          sin_radius_{std::max(std::sin(place.radius), on_axis)},
          highest_{highest(place)}
    {
    }

    void add(std::uint32_t cell, const Vec3& centre, AxisView& view) const
    {
        const double z = centre.dot(place_.axis);
        const bool is_ca = place_.family == RotaryFamily::CA;
        if (!is_ca && std::abs(z) > highest_)
            return;
        const double x = centre.dot(zero_);
        const double y = centre.dot(quarter_);
        const double r = std::sqrt(x * x + y * y);
        const double level = is_ca ? std::atan2(r, z) : std::atan2(std::abs(z), r);
        const std::uint8_t side = is_ca || z >= 0 ? 0 : 1;
        const bool here = level <= place_.reach[side] + place_.radius;
        const bool opposite = is_ca && level <= place_.reach[1] + place_.radius;
        if (!here && !opposite)
            return;
        const bool is_free = r <= sin_radius_;
        const double azimuth = is_free ? 0 : std::atan2(y, x);
        const double spread =
            is_free || place_.radius == 0 ? 0 : std::asin(sin_radius_ / r);
        auto add_side = [&](std::uint8_t to, double at) {
            if (is_free)
                view.free.push_back({0, 0, level, cell, to});
            else
                add_parts({at - spread, at + spread, level, cell, to}, view);
        };
        if (here)
            add_side(side, azimuth);
        if (opposite)
            add_side(1, azimuth + pi);
    }

private:
    void add_parts(const SeenCell& whole, AxisView& view) const
    {
        const double length = whole.end - whole.begin;
        const double part = longest_part * place_.radius;
        const int count = length <= part ? 1 : int(std::ceil(length / part));
        for (int k = 0; k < count; ++k) {
            const double begin = in_one_turn(whole.begin + length * k / count);
            view.swept.push_back(
                {begin, begin + length / count, whole.level, whole.cell, whole.side});
        }
    }

    /// An upper bound of the sines of the latitudes of cells within reach, for A,B.
    static double highest(const AxisPlace& place)
    {
        const double reach = std::max(place.reach[0], place.reach[1]) + place.radius;
        return reach < pi / 2 ? std::sin(reach) + on_axis : 2;
    }

    AxisPlace place_;
    Vec3 zero_;
    Vec3 quarter_;
    double sin_radius_;
    double highest_;
};

}  // namespace

Vec3 azimuth_zero(const Vec3& axis)
{
    int least = 0;
    axis.cwiseAbs().minCoeff(&least);
    return Vec3::Unit(least).cross(axis).normalized();
}

AxisView axis_view(const AxisPlace& place, std::span<const Vec3> centres)
{
    AxisView view;
    view.swept.reserve(centres.size() * (place.family == RotaryFamily::CA ? 3 : 2));
    const Viewer viewer{place};
    for (std::size_t k = 0; k < centres.size(); ++k)
        viewer.add(std::uint32_t(k), centres[k], view);
    std::sort(view.swept.begin(), view.swept.end(),
              [](const SeenCell& a, const SeenCell& b) {
                  if (a.begin != b.begin)
                      return a.begin < b.begin;
                  return a.cell != b.cell ? a.cell < b.cell : a.side < b.side;
              });
    return view;
}

}  // namespace endmill
