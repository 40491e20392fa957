// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/setup_figures.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/figures/axonometric_figure.h"
#include "endmill/figures/detail/setup_styles.h"

// The sphere is drawn from back to front: the parts of the axes inside and behind the
// sphere, the ground, the cells in front, the borders of the motion (dashed behind the
// sphere), the marked directions, then the visible ends of the axes with their names.

namespace endmill {
namespace {

constexpr double longest_chord = 0.1;  // rad; it is off the arc by 1/800 of its length
constexpr double border_step = 0.01;   // rad
// In radii. A corner with less depth is on the outline, but for rounding.
constexpr double least_depth = 1e-9;
constexpr double axis_reach = 1.2;   // length of axes, in radii of the sphere
constexpr double label_reach = 1.3;  // distance of names from the centre, in radii
constexpr int outline_corners = 180;
constexpr double mark_px = 3.2;
constexpr double pole_px = 5;
constexpr double swatch_px = 11;

// Colours of cells: without accessible facets, then five classes from few facets to many.
constexpr std::array<std::string_view, 6> colours{"#f2f2f2", "#e6f1f9", "#cfe3f2",
                                                  "#b3d3ea", "#90bfe0", "#68a8d3"};
constexpr std::size_t classes = colours.size() - 1;
constexpr std::string_view rim_colour = "#8a8a8a";
constexpr LineStyle cell_style{"#ffffff", 0.6, ""};
constexpr std::string_view mark_colour = "#222222";

// The number of accessible facets of each cell, and the division of these numbers into
// classes of equal width.
class ReachClasses {
public:
    // Counts the accessible facets of each cell by the bits of its column.
    explicit ReachClasses(const VisibilityMap& map) : low_{map.facets()}
    {
        for (std::size_t cell = 0; cell < map.cells(); ++cell) {
            std::size_t count = 0;
            for (const std::uint64_t word : map.column(cell))
                count += static_cast<std::size_t>(std::popcount(word));
            counts_.push_back(count);
            high_ = std::max(high_, count);
            if (count > 0)
                low_ = std::min(low_, count);
        }
    }

    // The class of a cell; 0 for a cell without accessible facets.
    std::size_t of(std::size_t cell) const
    {
        const std::size_t count = counts_[cell];
        return count == 0 ? 0 : classes - classes * (high_ - count) / (high_ - low_ + 1);
    }

    // The name of a class in the legend; empty if no cell can be in it.
    std::string name(std::size_t shade) const
    {
        if (shade == 0)
            return std::ranges::count(counts_, 0U) > 0 ? "no facet" : "";
        const std::size_t first = high_ + 1 - below(classes - shade + 1);
        const std::size_t end = high_ + 1 - below(classes - shade);
        if (high_ == 0 || first == end)
            return {};
        if (first + 1 == end)
            return counted(first, "facet");
        return std::to_string(first) + " to " + std::to_string(end - 1) + " facets";
    }

private:
    // Distance below the largest number at which the class begins that has k classes
    // above it.
    std::size_t below(std::size_t k) const
    {
        return (k * (high_ - low_ + 1) + classes - 1) / classes;
    }

    std::vector<std::size_t> counts_;
    std::size_t low_;
    std::size_t high_ = 0;
};

// The part of a spherical polygon in front of the outline; corners behind it are moved
// onto it.
// \return nothing if no corner is in front.
std::vector<Vec3> in_front(std::vector<Vec3> polygon, const Vec3& toward)
{
    const auto depth = [&](const Vec3& point) { return point.dot(toward); };
    if (std::ranges::none_of(polygon,
                             [&](const Vec3& p) { return depth(p) > least_depth; }))
        return {};
    for (Vec3& point : polygon)
        if (depth(point) < 0)
            point = (point - depth(point) * toward).normalized();
    return polygon;
}

// Draws one sphere. Lengths are in radii of the sphere.
class SpherePicture {
public:
    // With a setup all directions are turned to the machine.
    SpherePicture(const SphereGrid& grid, const VisibilityMap& map,
                  const SphereFigure& figure)
        : grid_{&grid},
          reach_{map},
          figure_{&figure},
          turn_{figure.setup ? figure.setup->part_to_machine
                             : Eigen::Matrix3d::Identity()},
          picture_{options_for(figure), extent(figure)},
          toward_{picture_.view().toward}
    {
    }

    // Draws everything from back to front.
    std::string text()
    {
        if (figure_->setup)
            add_axes_behind(machine_directions(*figure_->setup));
        add_ground();
        if (grid_->cells.size() <= most_filled_cells)
            add_cells();
        if (figure_->setup)
            add_borders();
        add_marks();
        if (figure_->setup)
            add_axes_in_front(machine_directions(*figure_->setup));
        add_legend();
        return picture_.text();
    }

private:
    // The axes are X, Y, Z of the machine if there is a setup, else x, y, z of the part.
    static FigureOptions options_for(const SphereFigure& figure)
    {
        FigureOptions options{.title = figure.title,
                              .captions = figure.captions,
                              .width_px = figure.width_px,
                              .azimuth = figure.azimuth,
                              .elevation = figure.elevation,
                              .has_length = false};
        if (figure.setup)
            options.axis_names = {"X", "Y", "Z"};
        return options;
    }

    // Points that bound the sphere, the axes and their names.
    static std::vector<Vec3> extent(const SphereFigure& figure)
    {
        const AxonometricView view{figure.azimuth, figure.elevation};
        return {-label_reach * view.right, label_reach * view.right,
                -label_reach * view.up, label_reach * view.up};
    }

    // Fills the disc that the sphere is seen as, with the colour of cells without facets.
    void add_ground()
    {
        const AxonometricView& view = picture_.view();
        std::vector<Vec3> rim;
        for (int k = 0; k < outline_corners; ++k) {
            const double angle = 2 * std::numbers::pi * k / outline_corners;
            rim.emplace_back(std::cos(angle) * view.right + std::sin(angle) * view.up);
        }
        picture_.add_polygon(rim, colours[0], {rim_colour, 1.2, ""});
    }

    // Fills the cells on the front half.
    void add_cells()
    {
        for (std::size_t cell = 0; cell < grid_->cells.size(); ++cell) {
            const std::vector<Vec3> polygon = in_front(outline(cell), toward_);
            if (polygon.empty())
                continue;
            picture_.add_polygon(polygon, colours.at(reach_.of(cell)), cell_style);
        }
    }

    // The outline of a cell in the drawn directions. Sides are arcs of great circles and
    // are divided into short chords.
    std::vector<Vec3> outline(std::size_t cell) const
    {
        std::vector<Vec3> polygon;
        const Triangle& corners = grid_->cells[cell];
        for (std::size_t side = 0; side < 3; ++side) {
            const Vec3 from = turn_ * grid_->corners[corners[side]];
            const Vec3 to = turn_ * grid_->corners[corners[(side + 1) % 3]];
            const int pieces = std::max(
                1, static_cast<int>(std::ceil((to - from).norm() / longest_chord)));
            for (int k = 0; k < pieces; ++k)
                polygon.emplace_back(
                    (from + static_cast<double>(k) / pieces * (to - from)).normalized());
        }
        return polygon;
    }

    // Draws the borders of the needed motion and of the machine's motion.
    void add_borders()
    {
        // The border of the machine is drawn first, so that the needed one covers it.
        std::vector<SetupLine> lines = motion_borders(*figure_->setup, border_step);
        std::ranges::reverse(lines);
        for (const SetupLine& line : lines)
            add_border(line);
    }

    // Draws a border; the pieces behind the sphere are dashed.
    void add_border(const SetupLine& line)
    {
        const DirectionCurve& curve = line.directions;
        if (curve.size() == 1 && curve[0].dot(toward_) >= 0)
            picture_.add_disc(curve[0], pole_px + 2, setup_style(line.object).colour);
        std::vector<Vec3> piece;
        for (std::size_t i = 0; i < curve.size(); ++i) {
            piece.push_back(curve[i]);
            const bool is_front = curve[i].dot(toward_) >= 0;
            const bool is_last = i + 1 == curve.size();
            if (is_last || (curve[i + 1].dot(toward_) >= 0) != is_front) {
                picture_.add_curve(piece, is_front ? setup_style(line.object)
                                                   : hidden_style(line.object));
                piece = {piece.back()};
            }
        }
    }

    // Draws the marked directions on the front half.
    void add_marks()
    {
        for (const Vec3& direction : figure_->marked) {
            const Vec3 place = turn_ * direction;
            if (place.dot(toward_) > 0)
                picture_.add_disc(place, mark_px, mark_colour);
        }
    }

    // Draws the axes as lines through the sphere; what is added later covers their hidden
    // parts.
    void add_axes_behind(const RotaryFrame& frame)
    {
        for (const SetupAxis& axis : setup_axes(frame))
            picture_.add_curve(
                std::array<Vec3, 2>{axis.is_half_line ? Vec3{Vec3::Zero()}
                                                      : Vec3{-axis_reach * axis.axis},
                                    axis_reach * axis.axis},
                setup_style(axis.object));
    }

    // Draws the ends of the axes that come out of the front half.
    void add_axes_in_front(const RotaryFrame& frame)
    {
        for (const SetupAxis& axis : setup_axes(frame))
            for (const double side : {-1.0, 1.0}) {
                const Vec3 end = side * axis.axis;
                if (end.dot(toward_) < 0 || (axis.is_half_line && side < 0))
                    continue;
                picture_.add_curve(std::array<Vec3, 2>{end, axis_reach * end},
                                   setup_style(axis.object));
                picture_.add_disc(end, pole_px, setup_style(axis.object).colour);
            }
        for (const SetupAxis& axis : setup_axes(frame))
            add_name(axis);
    }

    // Writes the name of an axis at its visible end.
    void add_name(const SetupAxis& axis)
    {
        const bool is_turned = axis.axis.dot(toward_) < 0 && !axis.is_half_line;
        const double side = is_turned ? -1 : 1;
        picture_.add_label(side * label_reach * axis.axis, {0, 0},
                           (is_turned ? "−" : "") + std::string{axis.name},
                           setup_style(axis.object).colour);
    }

    // The legend names axes, borders, marks and the classes of cells.
    void add_legend()
    {
        if (figure_->setup) {
            add_setup_legend(picture_, machine_directions(*figure_->setup));
            add_border_legend(picture_, *figure_->setup);
        }
        if (!figure_->marked.empty())
            picture_.add_disc_legend("nearest cells, MD", mark_px, mark_colour);
        if (grid_->cells.size() <= most_filled_cells)
            add_classes();
        else
            picture_.add_legend("cells too fine to draw", {colours[0], swatch_px, ""});
    }

    // Names the classes that occur.
    void add_classes()
    {
        for (std::size_t k = 0; k < colours.size(); ++k)
            if (const std::string name = reach_.name(k); !name.empty())
                picture_.add_legend(name, {colours[k], swatch_px, ""});
    }

    const SphereGrid* grid_;
    ReachClasses reach_;
    const SphereFigure* figure_;
    Eigen::Matrix3d turn_;
    AxonometricFigure picture_;
    Vec3 toward_;
};

}  // namespace

std::string sphere_svg(const SphereGrid& grid, const VisibilityMap& map,
                       const SphereFigure& figure)
{
    require(grid.cells.size() == map.cells() && map.facets() > 0,
            "sphere_svg: need a map of the grid's cells, of at least one facet");
    return SpherePicture{grid, map, figure}.text();
}

}  // namespace endmill
