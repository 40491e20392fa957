// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball-end-milling/equations/printed_geometry.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/surface/detail/explicit_surface.h"

namespace endmill {
namespace {

constexpr int steps = 40;  // of the grid along each direction

// Largest deviations over the grid, for one direction of the feed.
struct Deviations {
    double eq8 = 0;
    double eq9 = 0;
    double eq10 = 0;
    double eq11 = 0;
    double round_trip = 0;
};

void raise(double& largest, double value)
{
    largest = std::max(largest, std::abs(value));
}

// Adds the point with the tangents `ru`, `rv` and the direction (cos, sin) of the curve.
void add_point(Deviations& found, const Vec3& ru, const Vec3& rv, double cosine,
               double sine)
{
    const Vec3 along = cosine * ru + sine * rv;  // A u'
    // u'^T G u' with G = A^T A.
    const double form = cosine * cosine * ru.dot(ru) + 2 * cosine * sine * ru.dot(rv) +
                        sine * sine * rv.dot(rv);
    const Vec3 feed = along / std::sqrt(form);
    const Vec3 normal = ru.cross(rv).normalized();
    const Vec3 across = feed.cross(normal);
    const double lambda = std::atan2(feed.z(), std::hypot(feed.x(), feed.y()));
    const double mu = std::atan2(across.z(), normal.z());
    raise(found.eq8, feed.norm() - 1);
    raise(found.eq9, std::cos(lambda) - (feed.x() * feed.x() + feed.y() * feed.y()));
    raise(found.eq10, normal.z() - std::cos(mu) * std::cos(lambda));
    raise(found.eq11, feed.x() * normal.y() + feed.y() * normal.x() - across.z());
    // The normal from mu and lambda, turned about the feed.
    const Vec3 ahead{cosine, sine, 0};
    const Vec3 right{sine, -cosine, 0};
    const Vec3 up = -std::sin(lambda) * ahead + std::cos(lambda) * Vec3::UnitZ();
    raise(found.round_trip, (std::cos(mu) * up - std::sin(mu) * right - normal).norm());
}

Deviations over_test_surface(double turn_deg)
{
    const Angle turn = Angle::degrees(turn_deg);
    const double cosine = std::cos(turn.radians());
    const double sine = std::sin(turn.radians());
    Deviations found;
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j) {
            const HeightJet jet =
                ball_end_test_surface(-60 + 120.0 * i / steps, -40 + 80.0 * j / steps);
            add_point(found, {1, 0, jet.zx}, {0, 1, jet.zy}, cosine, sine);
        }
    return found;
}

// Pick feed by eq. (13) less the distance of the ball centres, on a cylinder of radius rho
// along the feed; + outside, - inside.
double pick_feed_deviation(double rho, double r0, double sign)
{
    const double half_pitch = 0.05;                        // rad
    const double across = 2 * rho * std::sin(half_pitch);  // |dr2 x T|
    const double centres = 2 * (rho + sign * r0) * std::sin(half_pitch);
    return (1 + sign * r0 / rho) * across - centres;
}

}  // namespace

void add_geometry_equations(CsvTable& result, const GeometryCases& cases)
{
    const Deviations turned = over_test_surface(cases.feed_turn_deg);
    const Deviations straight = over_test_surface(0);
    const double rho = cases.cylinder_radius_mm;
    const double pick_feed =
        std::max(std::abs(pick_feed_deviation(rho, cases.ball_radius_mm, 1)),
                 std::abs(pick_feed_deviation(rho, cases.ball_radius_mm, -1)));
    add_named(result, "eq. (8)", {{"deviation", turned.eq8}});
    add_named(result, "eq. (9)", {{"deviation", turned.eq9}});
    add_named(result, "eq. (10)", {{"deviation", turned.eq10}});
    add_named(result, "eq. (11)", {{"deviation", turned.eq11}});
    add_named(result, "eq. (11), Ty = 0", {{"deviation", straight.eq11}});
    add_named(result, "mu and lambda", {{"deviation", turned.round_trip}});
    add_named(result, "eq. (13)", {{"deviation", pick_feed}});
}

}  // namespace endmill
