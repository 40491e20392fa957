// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball-end-milling/figure-7/path_figure.h"

#include <vector>

#include "endmill/figures/axonometric_figure.h"

namespace endmill {
namespace {

constexpr LineStyle cut_style{"#1d4f91", 0.6, ""};
constexpr LineStyle air_style{"#c3c9d0", 0.5, "3 3"};
constexpr LineStyle stroke_style{"#D55E00", 2.4, ""};

// Points of consecutive moves of one kind, with the point before them.
struct Run {
    std::vector<Vec3> points;
    bool is_cut;
    int pass;
};

std::vector<Run> runs_of(const ToolPath& path)
{
    std::vector<Run> runs;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        const PathPoint& point = path.points[i];
        const bool is_cut = point.move == Move::Cut;
        if (runs.empty() || runs.back().is_cut != is_cut)
            runs.push_back({{path.points[i - 1].location.tip}, is_cut, point.pass});
        runs.back().points.push_back(point.location.tip);
    }
    return runs;
}

}  // namespace

std::string stroke_path_figure(const MilledPath& milled, double radius, double safe_z,
                               int stroke)
{
    const ToolPath path = milled_tool_path(milled, radius, safe_z);
    std::vector<Vec3> extent;
    for (const PathPoint& point : path.points)
        extent.push_back(point.location.tip);
    AxonometricFigure figure{
        {.title = "Cutter path, tips",
         .captions =
             {"one way along x, ball of radius 5 mm, cusp 0.2 mm, outer tolerance "
              "0.01 mm"}},
        extent};
    const std::vector<Run> runs = runs_of(path);
    for (const Run& run : runs)
        if (!run.is_cut)
            figure.add_curve(run.points, air_style);
    for (const Run& run : runs)
        if (run.is_cut)
            figure.add_curve(run.points, cut_style);
    for (const Run& run : runs)
        if (run.is_cut && run.pass == stroke) {
            figure.add_curve(run.points, stroke_style);
            figure.add_label(run.points.back(), {16, 4}, "A", stroke_style.colour);
        }
    figure.add_legend("cut", cut_style);
    figure.add_legend("our stroke A", stroke_style);
    figure.add_legend("lift, return, plunge", air_style);
    return figure.text();
}

}  // namespace endmill
