// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/surface_kinds.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "endmill/core/text.h"
#include "endmill/core/tolerance.h"
#include "endmill/files/detail/control_net.h"
#include "endmill/surface/detail/bernstein_basis.h"
#include "endmill/surface/extent.h"
#include "endmill/surface/nurbs.h"

namespace endmill {
namespace {

// Largest number of patches along u or v.
constexpr std::int64_t most_patches = 10000;

// The degree in `value`. Numbers beyond a million are reported by `whole_number`.
int read_degree(const JsonValue& value)
{
    const std::int64_t degree = value.whole_number(-1'000'000, 1'000'000);
    if (degree < 1 || degree > most_degree)
        throw value.complaint("degree " + std::to_string(degree),
                              "1 to " + std::to_string(most_degree), "E_SURFACE");
    return static_cast<int>(degree);
}

// The degree and the knot vector of u or v. Falling knots are reported at their place;
// `flaw` finds everything else.
SplineParameter read_parameter(const JsonValue& root, const std::string& name)
{
    const JsonValue knots = root.member("knots_" + name);
    SplineParameter parameter{read_degree(root.member("degree_" + name)), {}};
    for (std::size_t k = 0; k < knots.size(); ++k) {
        const JsonValue knot = knots.item(k);
        parameter.knots.push_back(knot.number());
        if (k > 0 && parameter.knots[k] < parameter.knots[k - 1])
            throw knot.complaint(
                knot.shown() + " after " + to_text(parameter.knots[k - 1]),
                "knots that do not fall", "E_SURFACE");
    }
    if (const std::string found = flaw(parameter); !found.empty())
        throw knots.complaint(
            found, "a knot vector of degree " + std::to_string(parameter.degree),
            "E_SURFACE");
    return parameter;
}

// Memory of the Bezier patches of a spline surface, in bytes. Every knot interval becomes
// a patch with (degree + 1) points along each parameter, so the patches can be far larger
// than the file.
double patch_bytes(const SplineParameter& u, const SplineParameter& v)
{
    const auto along = [](const SplineParameter& parameter) {
        return double(parameter.points()) * (parameter.degree + 1);
    };
    return along(u) * along(v) * 4 * sizeof(double);
}

// Memory of a height grid in bytes. Each cell becomes a bicubic patch of 440 bytes; the
// rest is for the heights as JSON values, numbers and control points.
double grid_bytes(std::size_t columns, std::size_t rows)
{
    constexpr double bytes_per_height = 560;
    return bytes_per_height * static_cast<double>(columns) * static_cast<double>(rows);
}

// The number of control points that a knot vector requires.
ExpectedCount points_along(const SplineParameter& parameter, const std::string& name)
{
    return {static_cast<std::size_t>(parameter.points()),
            "knots_" + name + " - degree_" + name + " - 1"};
}

// Checks the degree that the size of a net implies.
void require_degree(const JsonValue& net, std::size_t points, const char* thing)
{
    if (points < 2 || points > most_degree + 1)
        throw net.complaint("net has " + counted(points, thing) + ", degree " +
                                std::to_string(static_cast<std::int64_t>(points) - 1),
                            "degree 1 to " + std::to_string(most_degree), "E_SURFACE");
}

// Checks that grid lines rise, by more than `least_grid_interval` of their range each.
void require_rising(const JsonValue& value, const std::vector<double>& lines)
{
    if (lines.size() < 2)
        throw value.complaint(counted(lines.size(), "grid line"), "at least 2",
                              "E_SURFACE");
    const double least = least_grid_interval * (lines.back() - lines.front());
    for (std::size_t k = 1; k < lines.size(); ++k)
        if (!(lines[k] - lines[k - 1] > std::max(least, 0.0)))
            throw value.item(k).complaint(
                value.item(k).shown() + " after " + value.item(k - 1).shown(),
                "grid lines that rise, each by more than 1e-9 of the range", "E_SURFACE");
}

// A vector of one surface. An initializer list would copy the surface.
std::vector<Surface> single(Surface surface)
{
    std::vector<Surface> surfaces;
    surfaces.push_back(std::move(surface));
    return surfaces;
}

}  // namespace

std::vector<Surface> read_bezier(const SurfaceSource& source)
{
    const auto count = [&](const char* key) {
        return source.root.member(key).whole_number(1, most_patches);
    };
    const std::int64_t patches_u = count("patches_u");
    const std::int64_t patches_v = count("patches_v");
    const auto points = [](std::int64_t patches, const char* reason) {
        return ExpectedCount{static_cast<std::size_t>(3 * patches + 1), reason};
    };
    const ControlNet net = read_net(source.root.member("control_points"), source.lengths,
                                    points(patches_u, "3 patches_u + 1"),
                                    points(patches_v, "3 patches_v + 1"));
    return single(composite_bezier(static_cast<int>(patches_u),
                                   static_cast<int>(patches_v), net.points,
                                   source.tool_side));
}

std::vector<Surface> read_nurbs(const SurfaceSource& source)
{
    Nurbs nurbs{
        read_parameter(source.root, "u"), read_parameter(source.root, "v"), {}, {}};
    const ExpectedCount columns = points_along(nurbs.u, "u");
    const ExpectedCount rows = points_along(nurbs.v, "v");
    nurbs.control_points =
        read_net(source.root.member("control_points"), source.lengths, columns, rows)
            .points;
    if (const auto weights = source.root.find_member("weights"))
        nurbs.weights = read_weights(*weights, columns, rows);
    require_memory(source.file, patch_bytes(nurbs.u, nurbs.v), source.limits);
    return single(nurbs_surface(nurbs, source.tool_side));
}

std::vector<Surface> read_bezier_patches(const SurfaceSource& source)
{
    const JsonValue patches = source.root.member("patches");
    if (patches.size() == 0)
        throw patches.complaint("no patches", "at least one", "E_SURFACE");
    std::vector<Surface> surfaces;
    for (std::size_t number = 0; number < patches.size(); ++number) {
        const JsonValue value = patches.item(number);
        const ControlNet net =
            read_net(value, source.lengths, std::nullopt, std::nullopt);
        require_degree(value, net.rows, "row");
        require_degree(value, net.columns, "column");
        surfaces.push_back(
            Surface{{0, 1},
                    {0, 1},
                    {BezierPatch{static_cast<int>(net.columns) - 1,
                                 static_cast<int>(net.rows) - 1, net.points}},
                    source.tool_side});
    }
    return surfaces;
}

std::vector<Surface> read_height_grid(const SurfaceSource& source)
{
    const JsonValue x_value = source.root.member("x");
    const JsonValue y_value = source.root.member("y");
    const std::vector<double> x = read_lengths(x_value, source.lengths);
    const std::vector<double> y = read_lengths(y_value, source.lengths);
    require_rising(x_value, x);
    require_rising(y_value, y);
    const std::vector<double> z =
        read_length_rows(source.root.member("z"), source.lengths,
                         {x.size(), "length of x"}, {y.size(), "length of y"});
    require_memory(source.file, grid_bytes(x.size(), y.size()), source.limits);
    Surface surface = height_grid(x, y, z, source.tool_side);
    const double most = source.lengths.max_extent_mm;
    const auto [low, high] = extent(surface, Vec3::UnitZ());
    if (std::max(-low, high) > most)
        throw source.root.member("z").complaint(
            "the surface between its heights reaches " + to_text(std::max(-low, high)) +
                " mm",
            "at most " + to_text(most) + " mm: grid lines that are spaced more evenly",
            "E_RANGE");
    return single(std::move(surface));
}

}  // namespace endmill
