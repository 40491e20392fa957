// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/force_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/figures/detail/ball_lines.h"
#include "endmill/process/detail/engaged_region.h"

// The figure is drawn from back to front:
//
// 1. The facets of the lower half ball and of the groove that the previous pass left
//    behind the cutter, sorted by depth, and the disc that closes the half ball.
// 2. The outline of the previous pass ahead of the cutter, dashed.
// 3. The engaged part, as narrow bands between latitudes, and its borders.
// 4. Arrows, angles and names.

namespace endmill {
namespace {

using std::numbers::pi;

constexpr LineStyle ball_style{"#b9c6d6", 0.5, ""};
constexpr LineStyle rim_style{"#5d6f85", 1.1, ""};
constexpr LineStyle pass_style{"#b08d57", 0.5, ""};
constexpr LineStyle pass_ahead_style{"#b08d57", 1.1, "5 4"};
constexpr LineStyle engaged_style{"#e8a13a", 0.6, ""};
constexpr LineStyle border_style{"#a33b00", 2, ""};
constexpr LineStyle hidden_style{"#a33b00", 1.1, "3 3"};
constexpr LineStyle frame_style{"#333333", 1.3, ""};
constexpr LineStyle move_style{"#0b5fa5", 2, ""};
constexpr LineStyle angle_style{"#0b5fa5", 1, ""};

constexpr std::string_view ball_fill = "#eef3f9";
constexpr std::string_view lid_fill = "#dbe4ee";
constexpr std::string_view pass_fill = "#f8f1e4";

constexpr double pass_behind = 1.7;  // length of the previous pass behind the ball, radii
constexpr double pass_ahead = 1.35;  // length of it ahead of the ball, in radii
constexpr double arrow_reach = 1.6;  // length of the level arrows, in radii
constexpr double upright_reach = 1.1;  // length of the upright arrows, in radii
constexpr double angle_reach = 1.32;   // radius of the arcs that show angles, in radii

// The name of a border in tables.
std::string border_name(BorderKind kind, PreviousPass previous)
{
    switch (kind) {
        case BorderKind::Front:
            return "front";
        case BorderKind::PreviousBall:
            return "previous pass";
        case BorderKind::Wall:
            break;
    }
    return previous == PreviousPass::Edge ? "edge" : "wall of the previous pass";
}

// Directions of the move in the frame of BallEngagement.
// Source: docs/methods/ball-end-milling.md, section 3.
struct MoveDirections {
    explicit MoveDirections(const BallEngagement& engagement)
        : feed{std::cos(engagement.lambda), 0, std::sin(engagement.lambda)},
          upright{-std::sin(engagement.lambda), 0, std::cos(engagement.lambda)},
          pick{std::cos(engagement.mu) * Vec3::UnitY() +
               std::sin(engagement.mu) * upright},
          normal{std::cos(engagement.mu) * upright -
                 std::sin(engagement.mu) * Vec3::UnitY()},
          previous{-engagement.pick_feed_ratio * pick}
    {
    }

    // A point on the lower half of the previous pass: at a distance along the feed, and
    // at an angle from its lowest line towards Y.
    Vec3 on_previous(double along, double angle) const
    {
        return previous + along * feed + std::sin(angle) * Vec3::UnitY() -
               std::cos(angle) * upright;
    }

    Vec3 feed;
    Vec3 upright;  // normal to the feed, in the vertical plane through it
    Vec3 pick;
    Vec3 normal;
    Vec3 previous;  // a point of the previous pass's axis
};

// A facet with its colours, to be sorted by depth.
struct Facet {
    std::vector<Vec3> outline;  // in the axes of the figure, in mm
    std::string_view fill;
    LineStyle style;
};

// Adds the facets of the lower half ball of which at least one corner faces the viewer.
void add_ball_facets(const BallFrame& frame, const Vec3& toward,
                     std::vector<Facet>& facets)
{
    constexpr int rows = 9;
    constexpr int columns = 36;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double low = pi / 2 * row / rows;
            const double high = pi / 2 * (row + 1) / rows;
            const double from = 2 * pi * column / columns;
            const double to = 2 * pi * (column + 1) / columns;
            std::vector<Vec3> outline = frame.in_room(latitude_line(low, from, to));
            const auto back = frame.in_room(latitude_line(high, to, from));
            outline.insert(outline.end(), back.begin(), back.end());
            const bool is_seen = std::ranges::any_of(
                outline, [&](const Vec3& point) { return point.dot(toward) > 0; });
            if (is_seen)
                facets.push_back({std::move(outline), ball_fill, ball_style});
        }
}

// Adds the groove that the previous pass left behind the front of the ball.
void add_pass_facets(const BallFrame& frame, const MoveDirections& move,
                     std::vector<Facet>& facets)
{
    constexpr int rows = 18;
    constexpr int columns = 10;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double low = pi * row / rows - pi / 2;
            const double high = pi * (row + 1) / rows - pi / 2;
            const double from = -pass_behind * column / columns;
            const double to = -pass_behind * (column + 1) / columns;
            facets.push_back(
                {frame.in_room(std::vector<Vec3>{
                     move.on_previous(from, low), move.on_previous(to, low),
                     move.on_previous(to, high), move.on_previous(from, high)}),
                 pass_fill, pass_style});
        }
}

// The lower half circle of the previous pass at a distance along the feed.
std::vector<Vec3> pass_section(const MoveDirections& move, double along)
{
    constexpr int steps = 90;
    std::vector<Vec3> line;
    for (int k = 0; k <= steps; ++k)
        line.push_back(move.on_previous(along, pi * k / steps - pi / 2));
    return line;
}

// Draws the facets of groove and ball from back to front, then the upper disc of the
// ball.
void add_solids(AxonometricFigure& figure, const BallFrame& frame,
                const MoveDirections& move)
{
    const Vec3 toward = figure.view().toward;
    std::vector<Facet> facets;
    add_pass_facets(frame, move, facets);
    add_ball_facets(frame, toward, facets);
    const auto depth = [&](const Facet& facet) {
        Vec3 sum = Vec3::Zero();
        for (const Vec3& point : facet.outline)
            sum += point;
        return toward.dot(sum) / static_cast<double>(facet.outline.size());
    };
    std::ranges::stable_sort(facets, {}, depth);
    for (const Facet& facet : facets)
        figure.add_polygon(facet.outline, facet.fill, facet.style);
    figure.add_polygon(frame.in_room(latitude_line(pi / 2, 0, 2 * pi)), lid_fill,
                       rim_style);
}

// Adds the visible engaged part as narrow bands between latitudes.
void add_engaged_part(AxonometricFigure& figure, const BallFrame& frame,
                      const BallEngagement& engagement)
{
    constexpr int bands = 90;
    const Vec3 toward = figure.view().toward;
    const double highest = highest_latitude(engagement);
    for (int band = 0; band < bands; ++band) {
        const double low = highest * band / bands;
        const double high = highest * (band + 1) / bands;
        for (const AzimuthRange& range : engaged_ranges(engagement, (low + high) / 2)) {
            std::vector<Vec3> below = latitude_line(low, range.from, range.to);
            std::vector<Vec3> above = latitude_line(high, range.from, range.to);
            const auto is_hidden = [&](const Vec3& point) {
                return frame.in_room(point).dot(toward) < 0;
            };
            std::erase_if(below, is_hidden);
            std::erase_if(above, is_hidden);
            std::vector<Vec3> outline = frame.in_room(below);
            const std::vector<Vec3> upper = frame.in_room(above);
            outline.insert(outline.end(), upper.rbegin(), upper.rend());
            figure.add_polygon(outline, engaged_style.colour, engaged_style);
        }
    }
}

// Writes "E" in the middle of the widest engaged range, at two thirds of the height.
void add_name(AxonometricFigure& figure, const BallFrame& frame,
              const BallEngagement& engagement)
{
    const double latitude = highest_latitude(engagement) * 2 / 3;
    const std::vector<AzimuthRange> ranges = engaged_ranges(engagement, latitude);
    if (ranges.empty())
        return;
    const AzimuthRange widest = *std::ranges::max_element(
        ranges, {}, [](const AzimuthRange& range) { return range.to - range.from; });
    figure.add_label(frame.in_room(ball_point(latitude, (widest.from + widest.to) / 2)),
                     {0, 0}, "E", "#222222");
}

// Draws a line on the ball, dashed where the ball hides it.
void add_border(AxonometricFigure& figure, const BallFrame& frame,
                const std::vector<Vec3>& border)
{
    const Vec3 toward = figure.view().toward;
    const std::vector<Vec3> line = frame.in_room(border);
    for (std::size_t begin = 0; begin + 1 < line.size();) {
        const auto is_seen = [&](std::size_t k) { return line[k].dot(toward) >= 0; };
        std::size_t end = begin + 1;
        while (end + 1 < line.size() && is_seen(end) == is_seen(begin + 1))
            ++end;
        figure.add_curve(std::span{line}.subspan(begin, end - begin + 1),
                         is_seen(begin + 1) ? border_style : hidden_style);
        begin = end;
    }
}

// Draws the frame, the directions of the move, their angles and the pick feed.
void add_arrows(AxonometricFigure& figure, const BallFrame& frame,
                const MoveDirections& move)
{
    const auto add = [&](const Vec3& direction, double reach, std::string_view name,
                         const LineStyle& style) {
        add_named_arrow(figure, frame,
                        std::array<Vec3, 2>{Vec3::Zero(), reach * direction}, name,
                        style);
    };
    add(Vec3::UnitX(), arrow_reach, "X", frame_style);
    add(Vec3::UnitY(), arrow_reach, "Y", frame_style);
    add(Vec3::UnitZ(), upright_reach, "Z", frame_style);
    add(move.feed, arrow_reach, "T", move_style);
    add(move.normal, upright_reach, "N", move_style);
    const auto add_angle = [&](const Vec3& from, const Vec3& to, double shift_px,
                               std::string_view name) {
        const auto arc = frame.in_room(arc_between(Vec3::Zero(), from, to, angle_reach));
        figure.add_curve(arc, angle_style);
        figure.add_label(arc[arc.size() / 2], {shift_px, 0}, name, angle_style.colour);
    };
    add_angle(Vec3::UnitX(), move.feed, 12, "λ");
    add_angle(Vec3::UnitY(), move.pick, -12, "μ");
    figure.add_arrow(frame.in_room(move.previous), Vec3::Zero(), move_style);
    figure.add_curve(
        frame.in_room(std::vector<Vec3>{Vec3::Zero(), angle_reach * move.pick}),
        {move_style.colour, 1, "2 3"});
    figure.add_label(frame.in_room(move.previous), {18, -4}, "F_p", move_style.colour);
}

}  // namespace

// Arcs are sampled in their own parameter. The top is a circle of latitude and is found
// by its engaged ranges.
std::vector<EngagementBorder> engagement_borders(const BallEngagement& engagement)
{
    constexpr int steps = 60;  // of an arc
    require_sound(engagement);
    require(!is_air(engagement), "engagement_borders: nothing is cut");
    const EngagedRegion region{engagement};
    std::vector<EngagementBorder> borders;
    for (const BorderArc& arc : region.borders(BorderSplit::Whole)) {
        EngagementBorder border{border_name(arc.kind, region.previous), {}};
        for (int k = 0; k <= steps; ++k) {
            const double p = arc.from + (arc.to - arc.from) * k / steps;
            border.points.push_back(region.point(arc.kind, p));
        }
        borders.push_back(std::move(border));
    }
    const double top = std::atan2(region.top_sine, region.top_cosine);
    for (const AzimuthRange& range : engaged_ranges(engagement, top))
        borders.push_back({"stock's top", latitude_line(top, range.from, range.to)});
    return borders;
}

std::string engagement_svg(const BallEngagement& engagement, const BallFrame& frame,
                           const std::vector<std::string>& captions)
{
    const MoveDirections move{engagement};
    std::vector<Vec3> extent = pass_section(move, -pass_behind);
    for (const auto& line :
         {pass_section(move, pass_ahead), latitude_line(pi / 2, 0, 2 * pi)})
        extent.insert(extent.end(), line.begin(), line.end());
    for (const Vec3& direction : {Vec3{Vec3::UnitX()}, Vec3{Vec3::UnitY()}, move.feed})
        extent.push_back(1.1 * arrow_reach * direction);
    for (const Vec3& direction : {Vec3{Vec3::UnitZ()}, move.normal})
        extent.push_back(1.1 * upright_reach * direction);
    const double side = frame.milling == Milling::Down ? -1 : 1;
    AxonometricFigure figure{{.title = "As figure 2: what a ball-end cutter engages",
                              .captions = captions,
                              .azimuth = Angle::degrees(side * 40),
                              .elevation = Angle::degrees(16)},
                             frame.in_room(extent)};
    add_solids(figure, frame, move);
    for (const double angle : {-pi / 2, 0.0, pi / 2})
        figure.add_curve(
            frame.in_room(std::vector<Vec3>{move.on_previous(0, angle),
                                            move.on_previous(pass_ahead, angle)}),
            pass_ahead_style);
    figure.add_curve(frame.in_room(pass_section(move, pass_ahead)), pass_ahead_style);
    add_engaged_part(figure, frame, engagement);
    for (const EngagementBorder& border : engagement_borders(engagement))
        add_border(figure, frame, border.points);
    add_arrows(figure, frame, move);
    add_name(figure, frame, engagement);
    figure.add_legend("engaged part E of the ball", {engaged_style.colour, 9, ""});
    figure.add_legend("its borders; dashed where the ball hides them", border_style);
    figure.add_legend("previous pass: left behind, and ahead (dashed)", pass_ahead_style);
    figure.add_legend("feed T, surface normal N, pick feed F_p", move_style);
    return figure.text();
}

}  // namespace endmill
