// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/direction_chart.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

// A direction is placed by its azimuth about the pole and a radius that depends on its
// polar angle p and the reach r:
//
//     equidistant   p / r
//     gnomonic      tan p / tan r     great circles are straight
//     orthographic  sin p / sin r     the sphere as seen from the pole

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double side_px = 620;
constexpr double radius_px = 250;
constexpr double middle_y_px = 340;
constexpr double legend_y_px = 650;
constexpr double legend_line_px = 22;
constexpr double legend_sample_px = 34;
constexpr double legend_room_px = 76;  // room for three lines
constexpr double legend_x_px = 60;
constexpr double text_px = 13;
constexpr double mark_px = 3.2;
constexpr double ring_name_px = 14;  // least distance of the names of two rings
constexpr int circle_corners = 120;
constexpr double angle_rounding = 1e-9;  // rad; shows directions exactly at the reach
constexpr LineStyle ring_style{"#cccccc", 1, ""};
constexpr std::string_view scale_colour = "#666666";

}  // namespace

// The projection limits the reach: tan and sin must rise up to it.
DirectionChart::DirectionChart(std::string_view title, const Frame& frame,
                               ChartProjection projection, Angle reach)
    : frame_{frame},
      up_{frame.pole.cross(frame.right)},
      projection_{projection},
      reach_{reach.radians()},
      picture_{side_px, legend_y_px + legend_room_px, title}
{
    const double most = projection == ChartProjection::Equidistant ? pi : pi / 2;
    require(0 < reach_ && (projection == ChartProjection::Gnomonic ? reach_ < most
                                                                   : reach_ <= most),
            "DirectionChart: the reach is beyond the projection");
    picture_.add_text({side_px / 2, 34}, title, {19, "#111111", true, true});
    add_rings();
    add_azimuths();
}

// Distance from the centre of the chart, in px, of a direction with this polar angle in
// rad.
double DirectionChart::radius_at(double polar) const
{
    switch (projection_) {
        case ChartProjection::Equidistant:
            return radius_px * polar / reach_;
        case ChartProjection::Gnomonic:
            return radius_px * std::tan(polar) / std::tan(reach_);
        case ChartProjection::Orthographic:
            return radius_px * std::sin(polar) / std::sin(reach_);
    }
    return 0;
}

// The polar angle is computed by atan2, which is accurate at the pole and at the rim.
PixelPoint DirectionChart::place(const Vec3& direction) const
{
    const PixelPoint across{direction.dot(frame_.right), -direction.dot(up_)};
    const double sine = across.norm();
    const double polar = std::atan2(sine, direction.dot(frame_.pole));
    const double scale = sine > 0 ? radius_at(polar) / sine : 0;
    return PixelPoint{side_px / 2, middle_y_px} + scale * across;
}

// Whether the polar angle of a direction is within the reach.
bool DirectionChart::is_shown(const Vec3& direction) const
{
    const double polar =
        std::atan2(direction.cross(frame_.pole).norm(), direction.dot(frame_.pole));
    return polar <= reach_ + angle_rounding;
}

// A direction beyond the reach interrupts the curve.
void DirectionChart::add_curve(std::span<const Vec3> directions, const LineStyle& style)
{
    std::vector<PixelPoint> piece;
    for (const Vec3& direction : directions) {
        if (is_shown(direction)) {
            piece.push_back(place(direction));
            continue;
        }
        picture_.add_polyline(piece, style);
        piece.clear();
    }
    picture_.add_polyline(piece, style);
}

void DirectionChart::add_marks(std::span<const Vec3> directions, std::string_view colour,
                               std::string_view label)
{
    for (const Vec3& direction : directions)
        if (is_shown(direction))
            picture_.add_disc(place(direction), mark_px, colour);
    picture_.add_disc(next_legend() + PixelPoint{legend_sample_px / 2, 0}, mark_px,
                      colour);
    name_legend(label);
}

void DirectionChart::add_legend(std::string_view label, const LineStyle& style)
{
    const PixelPoint from = next_legend();
    picture_.add_polyline(
        std::array<PixelPoint, 2>{from, from + PixelPoint{legend_sample_px, 0}}, style);
    name_legend(label);
}

// The legend is below the chart and has room for three lines.
PixelPoint DirectionChart::next_legend() const
{
    return {legend_x_px, legend_y_px + legend_line_px * legend_lines_};
}

// Writes the label beside the sample that was just drawn.
void DirectionChart::name_legend(std::string_view label)
{
    picture_.add_text(next_legend() + PixelPoint{legend_sample_px + 10, 0.36 * text_px},
                      label, {text_px});
    ++legend_lines_;
}

// Rings are 5, 15 or 30 degrees apart, depending on the reach. A name is left out if it
// would overlap the name of the ring inside.
void DirectionChart::add_rings()
{
    const double reach_deg = Angle::radians(reach_).degrees();
    const double step_deg = reach_deg > 100 ? 30 : reach_deg > 45 ? 15 : 5;
    double named_radius = 0;
    for (double polar_deg = step_deg; polar_deg <= reach_deg + angle_rounding;
         polar_deg += step_deg) {
        const double radius = radius_at(Angle::degrees(polar_deg).radians());
        std::vector<PixelPoint> ring;
        for (int k = 0; k <= circle_corners; ++k) {
            const double turn = 2 * pi * k / circle_corners;
            ring.emplace_back(side_px / 2 + radius * std::cos(turn),
                              middle_y_px - radius * std::sin(turn));
        }
        picture_.add_polyline(ring, ring_style);
        if (radius < named_radius + ring_name_px)
            continue;
        picture_.add_text({side_px / 2 + 3, middle_y_px + radius - 3},
                          to_text(polar_deg) + "°", {10, scale_colour});
        named_radius = radius;
    }
}

// Rays every 30 degrees, with their azimuths outside the chart.
void DirectionChart::add_azimuths()
{
    constexpr double text_gap_px = 20;
    constexpr int step_deg = 30;
    for (int azimuth = 0; azimuth < 360; azimuth += step_deg) {
        const double turn = Angle::degrees(azimuth).radians();
        const PixelPoint middle{side_px / 2, middle_y_px};
        const PixelPoint along{std::cos(turn), -std::sin(turn)};
        picture_.add_polyline(
            std::array<PixelPoint, 2>{middle, middle + radius_px * along}, ring_style);
        picture_.add_text(middle + (radius_px + text_gap_px) * along + PixelPoint{0, 4},
                          std::to_string(azimuth) + "°", {11, scale_colour, false, true});
    }
}

}  // namespace endmill
