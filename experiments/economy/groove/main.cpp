// SPDX-License-Identifier: GPL-3.0-or-later
// Two grooves that one pass covers, although the integral of one over the widest strip is
// longer than the pass.
//
//   economy-groove OUTPUT_FOLDER
//
// Deterministic. Columns: README.md beside this. All numbers come from points of the
// grooves alone, by quadrature.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

#include "endmill/core/vec.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

using std::numbers::pi;

// A groove of circular section, which a ball cuts along the line theta = 0.
struct Groove {
    double section;  // radius of the section, mm
    double R;        // of the ball, mm
    double h;        // that may be left, mm
    double end;      // the spine runs from 0 to this angle, rad
    double copies;   // of this piece
    bool has_flank;  // the tool is upright, with a flank above the ball
    double near;     // how far along the spine the ball reaches, rad; larger is safe
    std::function<Vec3(double t, double theta, double r)> point;  // r from the spine

    // The angle at which a ball at theta = 0 just reaches the raised point of its section.
    double half_angle() const
    {
        const double y = section - h;
        const double c = section - R;
        return std::acos((y * y + c * c - R * R) / (2 * y * c));
    }

    Vec3 surface(double t, double theta) const { return point(t, theta, section); }
    Vec3 raised(double t, double theta) const { return point(t, theta, section - h); }
    Vec3 centre(double t) const { return point(t, 0, section - R); }

    double reach(const Vec3& raised_point, double t) const
    {
        Vec3 away = raised_point - centre(t);
        if (has_flank)
            away.z() = std::min(0.0, away.z());
        return away.norm();
    }
};

// Area element per dt and dtheta, by central differences.
double area_element(const Groove& groove, double t, double theta)
{
    constexpr double e = 1e-5;  // balances the error of differences with that of rounding
    const Vec3 dt = groove.surface(t + e, theta) - groove.surface(t - e, theta);
    const Vec3 dtheta = groove.surface(t, theta + e) - groove.surface(t, theta - e);
    return dt.cross(dtheta).norm() / (4 * e * e);
}

// Integral of the area element where `counts` holds, by the rule of the middle point.
double area(const Groove& groove, double t_low, double t_high, int parts,
            const std::function<bool(double t, double theta)>& counts)
{
    const double alpha = groove.half_angle();
    const double dt = (t_high - t_low) / parts;
    const double dtheta = 2 * alpha / parts;
    double sum = 0;
    for (int i = 0; i < parts; ++i)
        for (int j = 0; j < parts; ++j) {
            const double t = t_low + (i + 0.5) * dt;
            const double theta = -alpha + (j + 0.5) * dtheta;
            if (counts(t, theta))
                sum += area_element(groove, t, theta);
        }
    return sum * dt * dtheta;
}

double pass_length(const Groove& groove)
{
    constexpr int parts = 20000;
    double length = 0;
    for (int k = 0; k < parts; ++k)
        length += (groove.surface(groove.end * (k + 1) / parts, 0) -
                   groove.surface(groove.end * k / parts, 0))
                      .norm();
    return groove.copies * length;
}

// The greatest distance of a raised point of the middle section from the pass.
double farthest_raised_point(const Groove& groove)
{
    constexpr int points = 100;
    constexpr int centres = 2000;
    const double t = groove.end / 2;
    double farthest = 0;
    for (int j = -points; j <= points; ++j) {
        const Vec3 raised = groove.raised(t, groove.half_angle() * j / points);
        double nearest = std::numeric_limits<double>::infinity();
        for (int k = -centres; k <= centres; ++k)
            nearest =
                std::min(nearest, groove.reach(raised, t + groove.near * k / centres));
        farthest = std::max(farthest, nearest);
    }
    return farthest;
}

void add_groove(CsvTable& result, const std::string& name, const Groove& groove,
                int parts)
{
    const double widest = 2 * groove.section * groove.half_angle();
    const double whole = groove.copies * area(groove, 0, groove.end, parts,
                                              [](double, double) { return true; });
    const double middle = groove.end / 2;
    const double disc =
        area(groove, middle - groove.near, middle + groove.near, parts,
             [&](double t, double theta) {
                 return groove.reach(groove.raised(t, theta), middle) <= groove.R;
             });
    const double pass = pass_length(groove);
    const double claimed = (whole - disc) / widest;
    result.add_row({name, pass, groove.half_angle(), widest, whole / widest,
                    disc / widest, claimed, claimed / pass, farthest_raised_point(groove),
                    groove.R});
}

// A groove around a helix; theta = 0 is the line nearest to the axis. \param turns of it.
Groove helical_groove(double turns)
{
    constexpr double spine = 19;
    constexpr double rise = 13 / (2 * pi);
    const double speed = std::hypot(spine, rise);
    return {9,
            7.5,
            0.5,
            2 * pi,
            turns,
            false,
            0.6,
            [=](double t, double theta, double r) -> Vec3 {
                const Vec3 inwards{-std::cos(t), -std::sin(t), 0};
                const Vec3 binormal{rise * std::sin(t) / speed,
                                    -rise * std::cos(t) / speed, spine / speed};
                return Vec3{spine * std::cos(t), spine * std::sin(t), rise * t} +
                       r * (std::cos(theta) * inwards + std::sin(theta) * binormal);
            }};
}

// A groove around a third of a wheel with a level axis, which an upright tool reaches.
Groove wheel_groove()
{
    constexpr double spine = 13;
    return {10,
            9.8,
            0.055,
            2 * pi / 3,
            1,
            true,
            2 * pi / 3 / 2,
            [=](double t, double theta, double r) -> Vec3 {
                const double angle = t - pi / 3;
                const Vec3 outwards{std::sin(angle), 0, std::cos(angle)};
                return spine * outwards - r * std::cos(theta) * outwards +
                       r * std::sin(theta) * Vec3::UnitY();
            }};
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "economy/groove", [](Experiment& run) {
        const auto parts = static_cast<int>(run.number("parts"));
        CsvTable result{{"row", "pass_mm", "half_angle_rad", "widest_strip_mm",
                         "integral_mm", "disc_mm", "claimed_bound_mm",
                         "claimed_over_pass", "farthest_raised_mm", "ball_radius_mm"}};
        add_groove(result, "helical groove, ten turns", helical_groove(10), parts);
        add_groove(result, "groove around a wheel", wheel_groove(), parts);
        run.write_result(result);
    });
}
