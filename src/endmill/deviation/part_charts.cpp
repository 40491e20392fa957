// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/part_charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/mesh/detail/edge_uses.h"
#include "endmill/surface/curvature.h"
#include "endmill/surface/detail/patch_sides.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

using Eigen::Vector2d;

// Tolerance of a unit normal's z: an upright wall counts as facing the tool whatever its
// rounding.
constexpr double wall_z = 1e-9;
// Rounding error of a cell's side at the end of its chart, as a share of the chart's
// width. Cells are much wider.
constexpr double border_rounding = 1e-12;

// Returns the normal of a triangle, with its area as length.
Vec3 area_vector(const std::array<Vec3, 3>& corners)
{
    return (corners[1] - corners[0]).cross(corners[2] - corners[0]) / 2;
}

// Returns the directions, one of all those that differ by less than about 1e-3.
std::vector<Vec3> distinct(std::span<const Vec3> directions)
{
    constexpr double cells = 1000;
    std::vector<std::pair<std::array<long, 3>, std::size_t>> keys;
    keys.reserve(directions.size());
    for (std::size_t k = 0; k < directions.size(); ++k) {
        const Vec3 at = cells * directions[k];
        keys.push_back(
            {{std::lround(at.x()), std::lround(at.y()), std::lround(at.z())}, k});
    }
    std::ranges::sort(keys);
    std::vector<Vec3> some;
    for (std::size_t k = 0; k < keys.size(); ++k)
        if (k == 0 || keys[k].first != keys[k - 1].first)
            some.push_back(directions[keys[k].second]);
    return some;
}

// Converts parameters of a chart to parameters of its patch, in [0, 1].
std::vector<double> within(std::span<const double> at, double low, double width)
{
    std::vector<double> shares;
    shares.reserve(at.size());
    for (const double parameter : at)
        shares.push_back((parameter - low) / width);
    return shares;
}

}  // namespace

Vector2d PartCell::centre() const
{
    Vector2d sum = at[0];
    for (int k = 1; k < corners; ++k)
        sum += at[static_cast<std::size_t>(k)];
    return sum / corners;
}

std::array<PartCell, 4> PartCell::quarters() const
{
    const auto between = [&](std::size_t a, std::size_t b) -> Vector2d {
        return (at[a] + at[b]) / 2;
    };
    if (corners == 3) {
        const Vector2d ab = between(0, 1);
        const Vector2d bc = between(1, 2);
        const Vector2d ca = between(2, 0);
        return {PartCell{chart, 3, {at[0], ab, ca}}, PartCell{chart, 3, {ab, at[1], bc}},
                PartCell{chart, 3, {ca, bc, at[2]}}, PartCell{chart, 3, {ab, bc, ca}}};
    }
    const Vector2d ab = between(0, 1);
    const Vector2d bc = between(1, 2);
    const Vector2d cd = between(2, 3);
    const Vector2d da = between(3, 0);
    const Vector2d middle = (ab + cd) / 2;
    return {PartCell{chart, 4, {at[0], ab, middle, da}},
            PartCell{chart, 4, {ab, at[1], bc, middle}},
            PartCell{chart, 4, {middle, bc, at[2], cd}},
            PartCell{chart, 4, {da, middle, cd, at[3]}}};
}

double PartCell::area(const PartRay& centre_ray) const
{
    double twice = 0;  // twice the area in parameters
    for (int k = 0; k < corners; ++k) {
        const Vector2d& a = at[static_cast<std::size_t>(k)];
        const Vector2d& b = at[static_cast<std::size_t>((k + 1) % corners)];
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return std::abs(twice) / 2 * centre_ray.du.cross(centre_ray.dv).norm();
}

double PartCell::reach(const PartRay& centre_ray) const
{
    const Vector2d middle = centre();
    const double along_u = centre_ray.du.squaredNorm();
    const double along_both = 2 * centre_ray.du.dot(centre_ray.dv);
    const double along_v = centre_ray.dv.squaredNorm();
    double reach2 = 0;
    for (int k = 0; k < corners; ++k) {
        const Vector2d away = at[static_cast<std::size_t>(k)] - middle;
        reach2 =
            std::max(reach2, away.x() * (away.x() * along_u + away.y() * along_both) +
                                 away.y() * away.y() * along_v);
    }
    return std::sqrt(reach2);
}

PartCharts::PartCharts(std::span<const Surface> surfaces, std::span<const double> sides)
    : surfaces_{surfaces},
      sides_{sides.begin(), sides.end()}
{
    require(surfaces.size() == sides.size(), "PartCharts: need a side for each surface");
    for (std::uint32_t k = 0; k < surfaces.size(); ++k)
        for (int j = 0; j < surfaces[k].patches(Parameter::V); ++j)
            for (int i = 0; i < surfaces[k].patches(Parameter::U); ++i) {
                const auto u = surfaces[k].breaks(Parameter::U).subspan(i, 2);
                const auto v = surfaces[k].breaks(Parameter::V).subspan(j, 2);
                charts_.push_back({k, i, j, {u[0], v[0]}, {u[1] - u[0], v[1] - v[0]}});
            }
    mark_borders_of_surfaces();
}

PartCharts::PartCharts(const TriangleMesh& mesh)
    : PartCharts{mesh, std::array{Vec3{Vec3::UnitZ()}}}
{
}

PartCharts::PartCharts(const TriangleMesh& mesh, std::span<const Vec3> tool_axes)
    : mesh_{&mesh}
{
    const std::vector<Vec3> axes = distinct(tool_axes);
    for (std::uint32_t k = 0; k < mesh.triangles().size(); ++k) {
        const Vec3 area = area_vector(mesh.corners(k));
        const double least = -wall_z * area.norm();
        if (area.norm() > 0 && std::ranges::any_of(axes, [&](const Vec3& axis) {
                return area.dot(axis) >= least;
            }))
            charts_.push_back({k, 0, 0, {0, 0}, {1, 1}});
    }
    mark_borders_of_mesh();
}

PartCell PartCharts::whole(std::uint32_t chart) const
{
    if (mesh_)
        return {chart, 3, {Vector2d{0, 0}, Vector2d{1, 0}, Vector2d{0, 1}}};
    const auto& [source, i, j, low, width] = charts_[chart];
    const auto u = surfaces_[source].breaks(Parameter::U).subspan(i, 2);
    const auto v = surfaces_[source].breaks(Parameter::V).subspan(j, 2);
    return {chart,
            4,
            {Vector2d{u[0], v[0]}, Vector2d{u[1], v[0]}, Vector2d{u[1], v[1]},
             Vector2d{u[0], v[1]}}};
}

std::optional<PartRay> PartCharts::ray(std::uint32_t number, const Vector2d& at) const
{
    const Chart& chart = charts_[number];
    if (mesh_) {
        const auto [a, b, c] = mesh_->corners(chart.source);
        const Vec3 normal = (b - a).cross(c - a).normalized();
        return PartRay{a + at.x() * (b - a) + at.y() * (c - a), normal, b - a, c - a};
    }
    const Vector2d within = (at - chart.low).cwiseQuotient(chart.width);
    const PartRay found = ray(chart, surfaces_[chart.source]
                                         .patch(chart.column, chart.row)
                                         .tangents(within.x(), within.y()));
    return has_normal(found) ? std::optional{found} : std::nullopt;
}

// \param tangents by the patch's own parameters.
// \return a ray whose normal is zero if the surface has none there.
PartRay PartCharts::ray(const Chart& chart, const SurfaceTangents& tangents) const
{
    const Vec3 across = tangents.du.cross(tangents.dv);
    const double sign = is_singular(tangents, across) ? 0 : sides_[chart.source];
    PartRay found{tangents.point, Vec3::Zero(), tangents.du / chart.width.x(),
                  tangents.dv / chart.width.y()};
    if (sign != 0)
        found.normal = sign / across.norm() * across;
    return found;
}

std::vector<PartRay> PartCharts::rays(std::uint32_t number, std::span<const double> u,
                                      std::span<const double> v) const
{
    const Chart& chart = charts_[number];
    const std::vector<double> within_u = within(u, chart.low.x(), chart.width.x());
    const std::vector<double> within_v = within(v, chart.low.y(), chart.width.y());
    std::vector<PartRay> rays;
    rays.reserve(u.size() * v.size());
    for (const SurfaceTangents& tangents : surfaces_[chart.source]
                                               .patch(chart.column, chart.row)
                                               .tangents(within_u, within_v))
        rays.push_back(ray(chart, tangents));
    return rays;
}

std::vector<Vec3> PartCharts::points(std::uint32_t number, std::span<const double> u,
                                     std::span<const double> v) const
{
    const Chart& chart = charts_[number];
    return surfaces_[chart.source]
        .patch(chart.column, chart.row)
        .places(within(u, chart.low.x(), chart.width.x()),
                within(v, chart.low.y(), chart.width.y()));
}

PartCharts::CurvatureBounds PartCharts::curvature(std::uint32_t chart,
                                                  const Vector2d& at) const
{
    if (mesh_)
        return {0, 0};
    const Chart& own = charts_[chart];
    const double side = sides_[own.source];
    const SurfaceJet jet =
        surfaces_[own.source].jet_in_patch(own.column, own.row, at.x(), at.y());
    if (is_singular({jet.point, jet.du, jet.dv}))
        return {0, 0};
    const PrincipalCurvatures k = principal_curvatures(fundamental_forms(jet, side));
    return {std::max(0.0, k.greatest), std::max(std::abs(k.least), std::abs(k.greatest))};
}

// Marks the sides of patches that meet no other side of the part.
void PartCharts::mark_borders_of_surfaces()
{
    const std::vector<PatchSide> sides = patch_sides(surfaces_);
    std::vector<bool> meets(sides.size());
    borders_.assign(charts_.size(), 0);
    for (const auto& [one, other] : meeting_sides(sides, same_end_mm(surfaces_)))
        meets[one] = meets[other] = true;
    std::vector<std::size_t> first{0};  // first chart of each surface
    for (const Surface& surface : surfaces_)
        first.push_back(first.back() +
                        static_cast<std::size_t>(surface.patches(Parameter::U)) *
                            static_cast<std::size_t>(surface.patches(Parameter::V)));
    for (std::size_t k = 0; k < sides.size(); ++k) {
        if (meets[k])
            continue;
        const PatchSide& side = sides[k];
        const int columns = side.surface->patches(Parameter::U);
        const int rows = side.surface->patches(Parameter::V);
        const bool along_u = side.along == Parameter::U;
        const int last = (along_u ? rows : columns) - 1;
        const int across = side.end == 0 ? 0 : last;
        const int column = along_u ? side.patch : across;
        const int row = along_u ? across : side.patch;
        const unsigned which =
            along_u ? (side.end == 0 ? 0U : 2U) : (side.end == 0 ? 3U : 1U);
        const std::size_t chart =
            first[side.number] + static_cast<std::size_t>(row * columns + column);
        borders_[chart] |= static_cast<Sides>(1U << which);
    }
}

// Marks the sides of triangles that no other triangle shares.
void PartCharts::mark_borders_of_mesh()
{
    std::vector<Sides> borders(mesh_->triangles().size());
    EdgeUses{*mesh_}.for_each([&](const MeshEdge& edge, std::span<const EdgeUse> uses) {
        if (uses.size() > 1)
            return;
        const auto number = static_cast<std::size_t>(uses.front().triangle());
        const Triangle& triangle = mesh_->triangles()[number];
        const std::int32_t start = uses.front().is_forward() ? edge[0] : edge[1];
        const auto side =
            static_cast<unsigned>(std::ranges::find(triangle, start) - triangle.begin());
        borders[number] |= static_cast<Sides>(1U << side);
    });
    for (const Chart& chart : charts_)
        borders_.push_back(borders[chart.source]);
}

// Returns the sides of the chart on which at least `corners` corners of the cell lie.
PartCharts::Sides PartCharts::touched(const PartCell& cell, int corners) const
{
    const PartCell all = whole(cell.chart);
    Sides touched = 0;
    for (int k = 0; k < all.corners; ++k) {
        const Vector2d& from = all.at[static_cast<std::size_t>(k)];
        const Vector2d along =
            all.at[static_cast<std::size_t>((k + 1) % all.corners)] - from;
        const Vector2d away =
            all.at[static_cast<std::size_t>((k + 2) % all.corners)] - from;
        const double opposite = along.x() * away.y() - along.y() * away.x();
        int on_side = 0;
        for (int c = 0; c < cell.corners; ++c) {
            const Vector2d at = cell.at[static_cast<std::size_t>(c)] - from;
            if (along.x() * at.y() - along.y() * at.x() <= border_rounding * opposite)
                ++on_side;
        }
        if (on_side >= corners)
            touched |= static_cast<Sides>(1U << static_cast<unsigned>(k));
    }
    return touched;
}

bool PartCharts::touches_side(const PartCell& cell) const
{
    return touched(cell, 1) != 0;
}

bool PartCharts::touches_border(const PartCell& cell) const
{
    const Sides borders = borders_[cell.chart];
    return borders != 0 && (touched(cell, 1) & borders) != 0;
}

bool PartCharts::runs_along_border(const PartCell& cell) const
{
    const Sides borders = borders_[cell.chart];
    return borders != 0 && (touched(cell, 2) & borders) != 0;
}

std::size_t PartCharts::source(std::uint32_t chart) const
{
    return charts_[chart].source;
}

PartCell PartTile::cell(int number) const
{
    const auto& at = whole.at;
    const int i = number % columns;
    const int j = number / columns;
    if (whole.corners == 4) {
        const auto node = [&](int column, int row) -> Vector2d {
            return at[0] + column / double(columns) * (at[1] - at[0]) +
                   row / double(rows) * (at[3] - at[0]);
        };
        return {whole.chart,
                4,
                {node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)}};
    }
    // Row j of a triangle, counted from the side between corners 0 and 1, has 2 (columns
    // - j) - 1 cells.
    int row = 0;
    int left = number;
    while (left >= 2 * (columns - row) - 1) {
        left -= 2 * (columns - row) - 1;
        ++row;
    }
    const int column = left / 2;
    const auto node = [&](int along, int up) -> Vector2d {
        return at[0] + along / double(columns) * (at[1] - at[0]) +
               up / double(columns) * (at[2] - at[0]);
    };
    if (left % 2 == 0)
        return {whole.chart,
                3,
                {node(column, row), node(column + 1, row), node(column, row + 1)}};
    return {whole.chart,
            3,
            {node(column + 1, row), node(column + 1, row + 1), node(column, row + 1)}};
}

PartCharts part_charts(const Part& part)
{
    if (const auto* mesh = std::get_if<TriangleMesh>(&part))
        return PartCharts{*mesh};
    const std::span<const Surface> surfaces = std::get<std::vector<Surface>>(part);
    return PartCharts{surfaces, tool_side_signs(surfaces, Vec3::UnitZ())};
}

PartCharts part_charts(const Part& part, std::span<const Vec3> tool_axes)
{
    if (const auto* mesh = std::get_if<TriangleMesh>(&part))
        return PartCharts{*mesh, tool_axes};
    return part_charts(part);
}

}  // namespace endmill
