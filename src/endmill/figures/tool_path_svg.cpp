// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/tool_path_svg.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

// Moves are grouped by style: cuts, links, and moves clear of the part. Each style is
// drawn as a whole, so that links are visible above the cuts that they join.

namespace endmill {
namespace {

// A style, and its name in the legend.
struct Stroke {
    std::string_view label;
    LineStyle style;
};

// In the order of drawing; the last is on top.
constexpr std::array<Stroke, 3> strokes{
    Stroke{"cut", {"#1d4f91", 0.7, ""}},
    Stroke{"link", {"#d1402f", 1.5, ""}},
    Stroke{"rapid, plunge, retract", {"#7d8590", 1, "5 3"}},
};

// The index in `strokes` of the style for a move.
std::size_t stroke_of(Move move)
{
    if (move == Move::Cut)
        return 0;
    return move == Move::Link ? 1 : 2;
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

// Draws the runs of consecutive moves that belong to `stroke`. A run starts at the point
// before its first move. \return whether there is one.
bool add_runs(AxonometricFigure& figure, const ToolPath& path,
              std::span<const Vec3> places, std::size_t stroke)
{
    bool any = false;
    for (std::size_t i = 1; i < places.size();) {
        std::size_t end = i;
        while (end < places.size() && stroke_of(path.points[end].move) == stroke)
            ++end;
        if (end > i) {
            figure.add_curve(places.subspan(i - 1, end - i + 1), strokes[stroke].style);
            any = true;
        }
        i = end + 1;
    }
    return any;
}

}  // namespace

std::string tool_path_svg(const ToolPath& path, const FigureOptions& options)
{
    const std::vector<Vec3> places = drawn_points(path);
    AxonometricFigure figure{options, places};
    for (std::size_t stroke = 0; stroke < strokes.size(); ++stroke)
        if (add_runs(figure, path, places, stroke))
            figure.add_legend(strokes[stroke].label, strokes[stroke].style);
    return figure.text();
}

}  // namespace endmill
