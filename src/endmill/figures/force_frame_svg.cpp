// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/force_figures.h"

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/figures/detail/ball_lines.h"
#include "endmill/process/cutting_force.h"
#include "endmill/process/detail/engaged_region.h"

// The directions of the force components are not drawn from formulas of this file. They
// are taken from the force model itself (`force_profile`), so the figure shows the signs
// that the program uses.

namespace endmill {
namespace {

using std::numbers::pi;

constexpr LineStyle ball_style{"#9aabc0", 0.9, ""};
constexpr LineStyle construction_style{"#777777", 1, "4 3"};
constexpr LineStyle frame_style{"#333333", 1.4, ""};
constexpr LineStyle edge_style{"#555555", 2, ""};
constexpr LineStyle element_style{"#000000", 6, ""};
constexpr LineStyle engaged_style{"#e8a13a", 5, ""};
constexpr std::string_view engaged_name_colour = "#a8660a";
constexpr LineStyle force_style{"#a33b00", 2.2, ""};
constexpr LineStyle angle_style{"#0b5fa5", 1.3, ""};
constexpr LineStyle turn_style{"#2e7d32", 2, ""};

constexpr double frame_reach = 1.75;   // length of the arrows X and Y, in radii
constexpr double upright_reach = 1.3;  // length of the arrow Z, in radii
constexpr double force_reach = 0.8;    // length of the force arrows, in radii
constexpr double shank_top = 0.5;      // height of the drawn shank, in radii

// The force at the element for a material with the given force ratios: the radial
// component is `radial` times the tangential one, the axial component `axial` times.
// Ratios of 0 leave only the tangential component.
CuttingForce force_with(const EdgeElement& element, Milling milling, double radial,
                        double axial)
{
    const CuttingMaterial material{.specific_resistance_n_per_mm2 = 1000,
                                   .edge_thickness_mm = 0,
                                   .r1 = radial,
                                   .r2 = radial,
                                   .r3 = axial,
                                   .r4 = axial,
                                   .alpha = 0.5,
                                   .v1_m_per_min = 1};
    const std::array turns{element.azimuth};
    return force_profile({.engagement = element.engagement,
                          .material = material,
                          .tool = {.radius = 1, .flutes = 1},
                          .feed_per_tooth_mm = 1,
                          .milling = milling},
                         turns)
        .front();
}

// The force as a vector, in N.
Vec3 vector_of(const CuttingForce& force)
{
    return {force.x_n, force.y_n, force.z_n};
}

// Points and directions that the drawing of an element needs, in the frame.
struct Places {
    Vec3 element;  // the element on the unit ball
    Vec3 axis;     // the point of the cutter's axis at the height of the element
    Vec3 radial;   // unit, horizontal, from the axis to the element
};

// The element, the axis at its height, and the horizontal radius between them.
Places places_of(const EdgeElement& element)
{
    const Vec3 at = ball_point(element.latitude, element.azimuth);
    const Vec3 axis{0, 0, at.z()};
    return {at, axis, (at - axis).normalized()};
}

// Points of the ball at one azimuth between two latitudes, all in rad: a straight edge.
std::vector<Vec3> meridian(double azimuth, double from, double to)
{
    constexpr int steps = 60;
    std::vector<Vec3> line;
    for (int k = 0; k <= steps; ++k)
        line.push_back(ball_point(from + (to - from) * k / steps, azimuth));
    return line;
}

// Draws the ball by its rim, the top of the shank, and its outline as the viewer sees it.
void add_cutter(AxonometricFigure& figure, const BallFrame& frame)
{
    const std::vector<Vec3> rim = latitude_line(pi / 2, 0, 2 * pi);
    std::vector<Vec3> top = rim;
    for (Vec3& point : top)
        point += shank_top * Vec3::UnitZ();
    figure.add_curve(frame.in_room(rim), ball_style);
    figure.add_curve(frame.in_room(top), ball_style);
    const AxonometricView& view = figure.view();
    for (const double side : {-1.0, 1.0})
        figure.add_curve(
            std::array<Vec3, 2>{
                frame.radius_mm * side * view.right,
                frame.radius_mm * (side * view.right + shank_top * Vec3::UnitZ())},
            ball_style);
    std::vector<Vec3> outline;
    for (const Vec3& point : arc_between(Vec3::Zero(), view.right, -view.up, 1))
        outline.push_back(frame.radius_mm * point);
    for (const Vec3& point : arc_between(Vec3::Zero(), -view.up, -view.right, 1))
        outline.push_back(frame.radius_mm * point);
    figure.add_curve(outline, ball_style);
}

// Draws X, Y and Z with their meaning.
void add_axes(AxonometricFigure& figure, const BallFrame& frame)
{
    const auto add = [&](const Vec3& tip, std::string_view name) {
        add_named_arrow(figure, frame, std::array<Vec3, 2>{Vec3::Zero(), tip}, name,
                        frame_style);
    };
    add(frame_reach * Vec3::UnitX(), "X");
    add(frame_reach * Vec3::UnitY(), "Y");
    add(upright_reach * Vec3::UnitZ(), "Z");
    figure.add_label(frame.in_room(Vec3{frame_reach * Vec3::UnitX()}), {0, 32}, "feed",
                     frame_style.colour);
    // Y points to the viewer's left when milling down, to the right when milling up.
    const double outwards_px = frame.milling == Milling::Down ? -40 : 40;
    figure.add_label(frame.in_room(Vec3{frame_reach * Vec3::UnitY()}), {outwards_px, 30},
                     "uncut stock", frame_style.colour);
}

// Draws the azimuth, from the parallel to Y through the axis to the element, and the
// latitude.
void add_angles(AxonometricFigure& figure, const BallFrame& frame,
                const EdgeElement& element)
{
    const Places places = places_of(element);
    const double radius = std::sin(element.latitude);
    const auto line = [&](const Vec3& from, const Vec3& to, const LineStyle& style) {
        figure.add_curve(frame.in_room(std::vector<Vec3>{from, to}), style);
    };
    line(Vec3::Zero(), -Vec3::UnitZ(), construction_style);
    line(places.axis, places.axis + radius * Vec3::UnitY(), construction_style);
    line(places.axis, places.element, construction_style);
    line(Vec3::Zero(), places.element, construction_style);
    const auto add = [&](const std::vector<Vec3>& arc, const PixelPoint& shift,
                         std::string_view name) {
        const std::vector<Vec3> drawn = frame.in_room(arc);
        figure.add_curve(drawn, angle_style);
        figure.add_label(drawn[drawn.size() / 2], shift, name, angle_style.colour);
    };
    add(arc_between(places.axis, Vec3::UnitY(), places.radial, 0.55 * radius), {0, 11},
        "θ");
    add(arc_between(Vec3::Zero(), -Vec3::UnitZ(), places.element, 0.45), {0, 12}, "δ");
    figure.add_label(frame.in_room(Vec3{places.axis + 0.75 * radius * places.radial}),
                     {0, -10}, "r", angle_style.colour);
}

// Draws the edge, its element, and the engaged azimuths at the element's latitude.
void add_edge(AxonometricFigure& figure, const BallFrame& frame,
              const EdgeElement& element)
{
    constexpr double half_element = 3 * pi / 180;
    figure.add_curve(frame.in_room(latitude_line(element.latitude, 0, 2 * pi)),
                     construction_style);
    for (const AzimuthRange& range :
         engaged_ranges(element.engagement, element.latitude)) {
        const auto cut =
            frame.in_room(latitude_line(element.latitude, range.from, range.to));
        figure.add_curve(cut, engaged_style);
        figure.add_label(cut.front(), {0, 16}, "φ1", engaged_name_colour);
        const Vec3 side = cut.back() - frame.in_room(places_of(element).axis);
        figure.add_label(cut.back() + 0.2 * side, {0, 0}, "φ2", engaged_name_colour);
    }
    figure.add_curve(frame.in_room(meridian(element.azimuth, 0, pi / 2)), edge_style);
    figure.add_curve(
        frame.in_room(meridian(element.azimuth, element.latitude - half_element,
                               element.latitude + half_element)),
        element_style);
}

// Draws the three force components at the element, all of the same length.
void add_forces(AxonometricFigure& figure, const BallFrame& frame,
                const EdgeElement& element)
{
    const ForceDirections forces = force_directions(element, frame);
    const Vec3 at = frame.turned(places_of(element).element);
    const BallFrame room{Milling::Up, frame.radius_mm};
    for (const auto& [direction, name] : {std::pair{forces.tangential, "dF_T"},
                                          {forces.radial, "dF_R"},
                                          {forces.axial, "dF_z"}})
        add_named_arrow(figure, room,
                        std::array<Vec3, 2>{at, at + force_reach * direction}, name,
                        force_style);
}

// Draws the sense of the spindle: clockwise seen from above, around the front of the
// shank.
void add_turn(AxonometricFigure& figure, double radius_mm)
{
    const Vec3 centre = radius_mm * (shank_top + 0.25) * Vec3::UnitZ();
    const Vec3 right = figure.view().right;
    const Vec3 front = right.cross(Vec3::UnitZ());
    std::vector<Vec3> arc = arc_between(centre, right, front, 0.45 * radius_mm);
    const auto rest = arc_between(centre, front, -right, 0.45 * radius_mm);
    arc.insert(arc.end(), rest.begin() + 1, rest.end());
    figure.add_curve(arc, turn_style);
    const Vec3 last = arc.back() - arc[arc.size() - 2];
    figure.add_arrow(arc.back(), arc.back() + 4 * last, turn_style);
}

}  // namespace

// The force is linear in the ratios of the components, so the difference to the force
// without a component is that component.
ForceDirections force_directions(const EdgeElement& element, const BallFrame& frame)
{
    const Vec3 tangential = vector_of(force_with(element, frame.milling, 0, 0));
    require(tangential.norm() > 0, "force_directions: the edge does not cut");
    const Vec3 with_radial = vector_of(force_with(element, frame.milling, 1, 0));
    const Vec3 with_axial = vector_of(force_with(element, frame.milling, 0, 1));
    return {frame.turned(tangential.normalized()),
            frame.turned((with_radial - tangential).normalized()),
            frame.turned((with_axial - tangential).normalized())};
}

std::string force_frame_svg(const EdgeElement& element, const BallFrame& frame,
                            const std::string& title)
{
    std::vector<Vec3> extent = latitude_line(pi / 2, 0, 2 * pi);
    for (const Vec3& tip : {Vec3{-Vec3::UnitZ()}, Vec3{1.1 * frame_reach * Vec3::UnitX()},
                            Vec3{1.1 * frame_reach * Vec3::UnitY()},
                            Vec3{1.1 * upright_reach * Vec3::UnitZ()}})
        extent.push_back(tip);
    const ForceDirections forces = force_directions(element, frame);
    for (const Vec3& force : {forces.tangential, forces.radial, forces.axial})
        extent.emplace_back(places_of(element).element +
                            1.3 * force_reach * frame.turned(force));
    const double side = frame.milling == Milling::Down ? -1 : 1;
    AxonometricFigure figure{
        {.title = title,
         .captions =
             {"δ = " + to_text(Angle::radians(element.latitude).written_degrees()) +
              "°, θ = " + to_text(Angle::radians(element.azimuth).written_degrees()) +
              "°, f_p = " + to_text(element.engagement.pick_feed_ratio) +
              " r0, l = " + to_text(element.engagement.depth_ratio) +
              " r0, μ = λ = 0; r0 = " + to_text(frame.radius_mm) + " mm"},
         .azimuth = Angle::degrees(side * 64),
         .elevation = Angle::degrees(24)},
        frame.in_room(extent)};
    add_cutter(figure, frame);
    add_edge(figure, frame, element);
    add_angles(figure, frame, element);
    add_axes(figure, frame);
    add_forces(figure, frame, element);
    add_turn(figure, frame.radius_mm);
    figure.add_legend("edge (drawn straight) with its element", edge_style);
    figure.add_legend("azimuths φ1 to φ2 that cut at the element's latitude",
                      engaged_style);
    figure.add_legend("dF_T, dF_R on the work; dF_z, the thrust, on the cutter",
                      force_style);
    figure.add_legend("sense of the spindle, M03", turn_style);
    return figure.text();
}

}  // namespace endmill
