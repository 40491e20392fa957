// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/tool_path_svg.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/figures/detail/drawn_mesh.h"
#include "endmill/figures/detail/surface_cells.h"

// The part is drawn first, from back to front. Moves are grouped by style: cuts, links,
// and moves clear of the part. Each style is drawn as a whole, so that links are visible
// above the cuts that they join. Start and direction are on top.

namespace endmill {
namespace {

// A style, and its name in the legend.
struct Stroke {
    std::string_view label;
    LineStyle style;
};

// In the order of drawing; the last is on top.
constexpr std::array<Stroke, 3> plain_strokes{
    Stroke{"cut", {"#1d4f91", 0.7, ""}},
    Stroke{"link", {"#d1402f", 1.5, ""}},
    Stroke{"rapid, plunge, retract", {"#7d8590", 1, "5 3"}},
};

// The same with cuts by the use of their strips: the first four below these shares.
constexpr std::array<double, 4> use_limits{0.25, 0.5, 0.75, 1};
constexpr std::array<Stroke, 7> use_strokes{
    Stroke{"cut, use below 25 %", {"#d7301f", 1.1, ""}},
    Stroke{"cut, 25 to 50 %", {"#f08a3c", 1.1, ""}},
    Stroke{"cut, 50 to 75 %", {"#5aae61", 1.1, ""}},
    Stroke{"cut, 75 to 100 %", {"#3690c0", 1.1, ""}},
    Stroke{"cut, a strip or more", {"#173f7a", 1.1, ""}},
    Stroke{"link", {"#7b3294", 1.3, ""}},
    Stroke{"rapid, plunge, retract", {"#7d8590", 1, "5 3"}},
};

constexpr LineStyle part_outline{"#c3d0e0", 0.5, ""};
constexpr LineStyle direction_style{"#111111", 1.6, ""};
constexpr LineStyle axis_style{"#b8860b", 1.1, ""};
constexpr std::string_view start_colour = "#1a7f37";
constexpr double start_radius_px = 5;

// Number of arrows on the path, and their length as a share of its diagonal.
constexpr std::size_t most_arrows = 7;
constexpr double arrow_share = 0.03;
// Number of tool axes that are drawn if the axis turns, and their length as a share of the
// diagonal. Axes that differ by less than this, as unit vectors, count as equal.
constexpr std::size_t most_axes = 60;
constexpr double axis_share = 0.06;
constexpr double least_turn = 1e-6;

// Most cells of the drawn part, and most of them along the side of a patch.
constexpr int most_cells = 4000;
constexpr int most_spaces = 12;

// The strokes of a figure, and the number of that for the move to each point.
struct DrawnMoves {
    std::span<const Stroke> strokes;
    std::vector<std::size_t> stroke_of;
};

DrawnMoves drawn_moves(const ToolPath& path, std::span<const double> strip_use)
{
    DrawnMoves moves{plain_strokes, {}};
    if (!strip_use.empty())
        moves.strokes = use_strokes;
    const std::size_t link = moves.strokes.size() - 2;
    moves.stroke_of.reserve(path.points.size());
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const Move move = path.points[k].move;
        if (move != Move::Cut)
            moves.stroke_of.push_back(move == Move::Link ? link : link + 1);
        else if (strip_use.empty())
            moves.stroke_of.push_back(0);
        else
            moves.stroke_of.push_back(std::ranges::upper_bound(use_limits, strip_use[k]) -
                                      use_limits.begin());
    }
    return moves;
}

// The drawn point of each path point: the contact, or the tip where there is none.
std::vector<Vec3> drawn_points(const ToolPath& path)
{
    std::vector<Vec3> points;
    points.reserve(path.points.size());
    for (const PathPoint& point : path.points)
        points.push_back(point.contact() ? point.contact()->contact.point
                                         : point.location.tip);
    return points;
}

// Draws the runs of consecutive moves that belong to a stroke. A run starts at the point
// before its first move. \return whether there is one.
bool add_runs(AxonometricFigure& figure, std::span<const Vec3> places,
              const DrawnMoves& moves, std::size_t stroke)
{
    bool any = false;
    for (std::size_t i = 1; i < places.size();) {
        std::size_t end = i;
        while (end < places.size() && moves.stroke_of[end] == stroke)
            ++end;
        if (end > i) {
            figure.add_curve(places.subspan(i - 1, end - i + 1),
                             moves.strokes[stroke].style);
            any = true;
        }
        i = end + 1;
    }
    return any;
}

// A flat piece of the part.
struct PartPiece {
    std::vector<Vec3> outline;
    Vec3 normal;  // of either side and any length
    Vec3 middle;  // by which pieces are sorted
};

// The pieces of surfaces. Parts of many patches have fewer cells in each.
std::vector<PartPiece> pieces_of(std::span<const Surface> part)
{
    double patches = 0;
    for (const Surface& surface : part)
        patches += double(surface.patches(Parameter::U)) * surface.patches(Parameter::V);
    int spaces = most_spaces;
    while (spaces > 1 && spaces * spaces * patches > most_cells)
        --spaces;
    std::vector<PartPiece> pieces;
    for (const Surface& surface : part)
        for (const SurfaceCell& cell : surface_cells(surface, spaces))
            pieces.push_back({{cell.outline.begin(), cell.outline.end()},
                              cell.diagonals_normal(),
                              cell.middle()});
    return pieces;
}

std::vector<PartPiece> pieces_of(const TriangleMesh& mesh)
{
    const std::span<const Vec3> points = mesh.points();
    const DrawnMesh drawn = drawn_mesh(points, mesh.triangles(), most_cells);
    std::vector<PartPiece> pieces;
    pieces.reserve(drawn.triangles.size());
    for (const auto& [i, j, k] : drawn.triangles) {
        const Vec3& a = points[i];
        const Vec3& b = points[j];
        const Vec3& c = points[k];
        pieces.push_back({{a, b, c}, (b - a).cross(c - a), (a + b + c) / 3});
    }
    return pieces;
}

// Draws the pieces of the part from back to front.
void add_part(AxonometricFigure& figure, std::vector<PartPiece> pieces)
{
    const Vec3 toward = figure.view().toward;
    std::ranges::stable_sort(
        pieces, {}, [&](const PartPiece& piece) { return toward.dot(piece.middle); });
    for (const PartPiece& piece : pieces)
        figure.add_polygon(piece.outline, shade_of(piece.normal, figure.view()),
                           part_outline);
    if (!pieces.empty())
        figure.add_legend("part", {"#a6bad4", 8, ""});
}

// The runs of consecutive cuts, as the indices of their first and last points.
std::vector<std::pair<std::size_t, std::size_t>> cuts_of(const ToolPath& path)
{
    std::vector<std::pair<std::size_t, std::size_t>> cuts;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        if (path.points[i].move != Move::Cut)
            continue;
        if (cuts.empty() || cuts.back().second + 1 != i)
            cuts.emplace_back(i - 1, i);
        cuts.back().second = i;
    }
    return cuts;
}

// Draws an arrow that ends half way along the points.
void add_direction(AxonometricFigure& figure, std::span<const Vec3> points, double size)
{
    double whole = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        whole += (points[i] - points[i - 1]).norm();
    double along = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec3 step = points[i] - points[i - 1];
        const double length = step.norm();
        if (along + length >= whole / 2 && length > 0) {
            const Vec3 head = points[i - 1] + (whole / 2 - along) / length * step;
            figure.add_arrow(head - size / length * step, head, direction_style);
            return;
        }
        along += length;
    }
}

// Marks the start of the path and the direction of a few cuts at equal steps.
void add_marks(AxonometricFigure& figure, const ToolPath& path,
               std::span<const Vec3> places)
{
    Eigen::AlignedBox3d box;
    for (const Vec3& place : places)
        box.extend(place);
    const auto cuts = cuts_of(path);
    const std::size_t arrows = std::min(most_arrows, cuts.size());
    for (std::size_t k = 0; k < arrows; ++k) {
        const auto& [first, last] = cuts[k * cuts.size() / arrows];
        add_direction(figure, places.subspan(first, last - first + 1),
                      arrow_share * box.diagonal().norm());
    }
    figure.add_disc(places.front(), start_radius_px, start_colour);
    figure.add_disc_legend("start", start_radius_px, start_colour);
    if (arrows > 0)
        figure.add_legend("direction", direction_style);
}

// The lines of some tool axes, from the cuts upwards; none if the axis does not turn.
std::vector<std::array<Vec3, 2>> axis_lines(const ToolPath& path,
                                            std::span<const Vec3> places)
{
    Eigen::AlignedBox3d box;
    std::vector<std::size_t> cut;
    bool turns = false;
    for (std::size_t i = 0; i < places.size(); ++i) {
        box.extend(places[i]);
        if (path.points[i].move != Move::Cut)
            continue;
        cut.push_back(i);
        const Vec3& axis = path.points[i].location.axis;
        turns =
            turns || (axis - path.points[cut.front()].location.axis).norm() > least_turn;
    }
    std::vector<std::array<Vec3, 2>> lines;
    if (!turns)
        return lines;
    const double length = axis_share * box.diagonal().norm();
    const std::size_t count = std::min(most_axes, cut.size());
    lines.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = cut[k * cut.size() / count];
        lines.push_back({places[i], places[i] + length * path.points[i].location.axis});
    }
    return lines;
}

std::string drawn_path(const ToolPath& path, const FigureOptions& options,
                       std::vector<PartPiece> pieces, const DrawnMoves& moves)
{
    const std::vector<Vec3> places = drawn_points(path);
    std::vector<Vec3> extent = places;
    for (const PartPiece& piece : pieces)
        extent.insert(extent.end(), piece.outline.begin(), piece.outline.end());
    const std::vector<std::array<Vec3, 2>> axes = axis_lines(path, places);
    for (const std::array<Vec3, 2>& axis : axes)
        extent.push_back(axis.back());
    FigureOptions ticked = options;
    ticked.has_ticks = true;
    AxonometricFigure figure{ticked, extent};
    add_part(figure, std::move(pieces));
    for (std::size_t stroke = 0; stroke < moves.strokes.size(); ++stroke)
        if (add_runs(figure, places, moves, stroke))
            figure.add_legend(moves.strokes[stroke].label, moves.strokes[stroke].style);
    for (const std::array<Vec3, 2>& axis : axes)
        figure.add_curve(axis, axis_style);
    if (!axes.empty())
        figure.add_legend("tool axis", axis_style);
    if (!places.empty())
        add_marks(figure, path, places);
    return figure.text();
}

}  // namespace

std::string tool_path_svg(const ToolPath& path, const FigureOptions& options,
                          std::span<const Surface> part)
{
    return drawn_path(path, options, pieces_of(part), drawn_moves(path, {}));
}

std::string tool_path_svg(const ToolPath& path, const FigureOptions& options,
                          const PathDrawing& drawing)
{
    require(drawing.strip_use.empty() || drawing.strip_use.size() == path.points.size(),
            "tool_path_svg: need a strip use for each point");
    std::vector<PartPiece> pieces;
    if (drawing.part)
        pieces =
            std::visit([](const auto& part) { return pieces_of(part); }, *drawing.part);
    return drawn_path(path, options, std::move(pieces),
                      drawn_moves(path, drawing.strip_use));
}

}  // namespace endmill
