// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <locale>
#include <numeric>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/figures/tool_path_svg.h"

namespace endmill {
namespace {

// Colours of the classes, from the least density to the greatest.
constexpr std::array<std::string_view, 5> class_colours{"#ffe9a8", "#fcb171", "#e9776a",
                                                        "#ab467b", "#5f2a74"};
// Densities that differ by less than this share of the least one are one class.
constexpr double least_spread = 0.01;
constexpr double legend_width_px = 8;
constexpr double outline_px = 0.5;  // closes the gaps between cells

// Cells of about the same density.
struct DensityClass {
    std::string_view colour;
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
};

// Classes of about as many cells each, and the number of that of each cell.
struct DensityClasses {
    std::array<DensityClass, class_colours.size()> classes;
    std::vector<std::size_t> class_of;
};

DensityClasses classes_of(std::span<const DensityPiece> pieces)
{
    require(!pieces.empty(), "density_svg: need a cell");
    std::vector<double> sorted;
    sorted.reserve(pieces.size());
    for (const DensityPiece& piece : pieces) {
        require(std::isfinite(piece.density_per_mm),
                "density_svg: a density is not finite");
        sorted.push_back(piece.density_per_mm);
    }
    std::ranges::sort(sorted);
    std::array<double, class_colours.size() - 1> limits{};
    for (std::size_t k = 0; k < limits.size(); ++k)
        limits[k] = sorted[(k + 1) * sorted.size() / class_colours.size()];
    if (sorted.back() <= (1 + least_spread) * sorted.front())
        limits.fill(sorted.back());  // one class
    DensityClasses found;
    for (std::size_t k = 0; k < class_colours.size(); ++k)
        found.classes[k].colour = class_colours[k];
    found.class_of.reserve(pieces.size());
    for (const auto& [corners, density] : pieces) {
        const auto number = static_cast<std::size_t>(
            std::ranges::lower_bound(limits, density) - limits.begin());
        DensityClass& own = found.classes[number];
        own.least = std::min(own.least, density);
        own.greatest = std::max(own.greatest, density);
        found.class_of.push_back(number);
    }
    return found;
}

std::string number_text(double value)
{
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(3);
    text << value;
    return text.str();
}

std::string label_of(double from, double to)
{
    const std::string low = number_text(from);
    const std::string high = number_text(to);
    return (low == high ? low : low + " to " + high) + " per mm";
}

}  // namespace

std::string density_svg(std::span<const DensityPiece> pieces,
                        const FigureOptions& options)
{
    const auto [classes, class_of] = classes_of(pieces);
    std::vector<Vec3> extent;
    extent.reserve(4 * pieces.size());
    for (const DensityPiece& piece : pieces)
        extent.insert(extent.end(), piece.corners.begin(), piece.corners.end());
    FigureOptions shown = options;
    shown.has_ticks = true;
    AxonometricFigure figure{shown, extent};
    std::vector<std::size_t> by_depth(pieces.size());
    std::iota(by_depth.begin(), by_depth.end(), std::size_t{0});
    const Vec3 toward = figure.view().toward;
    std::ranges::stable_sort(by_depth, {}, [&](std::size_t piece) {
        const auto& [a, b, c, d] = pieces[piece].corners;
        return toward.dot(a + b + c + d);
    });
    for (const std::size_t piece : by_depth) {
        const std::string_view colour = class_colours[class_of[piece]];
        figure.add_polygon(pieces[piece].corners, colour, {colour, outline_px, ""});
    }
    for (const auto& [colour, least, greatest] : classes)
        if (least <= greatest)
            figure.add_legend(label_of(least, greatest), {colour, legend_width_px, ""});
    return figure.text();
}

}  // namespace endmill
