// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/stock/mesh_stock.h"

// Dual contouring of three fields of rays.
//
// Nodes are the places where three rays meet, and one more layer of them outside the block.
// A node is inside if all three rays have material there. The stock is scanned in layers of
// cubes between the nodes k and k + 1 along z:
//
// 1. The nodes of the layer k + 1 are marked.
// 2. Each cube whose nodes are not all alike gets a vertex.
// 3. Each edge between two different nodes gets the quadrilateral of the vertices of the
//    four cubes around it: edges along z in this layer of cubes, edges along x and y on its
//    lower side, together with the layer below.
//
// Every side of a quadrilateral belongs to a face between two cubes. A face has an even
// number of such edges, so the mesh is closed.

namespace endmill {
namespace {

// Steepest slope that the normal of a crossing takes from a neighbouring ray. Where the
// surface is steeper, the rays of other fields cross it.
constexpr double steepest = 20;
// Largest second difference of three neighbouring ends, as a share of the distance of the
// rays, at which the surface counts as smooth.
constexpr double most_bend = 0.25;
// Least eigenvalue of the tangent planes of a cube, as a share of the largest, in whose
// direction they determine the vertex. On a smooth surface the others come from curvature.
constexpr double least_eigenvalue = 0.1;

using Node = std::array<int, 3>;

// A place where the surface crosses a ray.
struct Crossing {
    Vec3 point;   // mm, from the block's low corner
    Vec3 normal;  // unit
    // Less where the ray runs along the surface, because small differences of its end then
    // turn the normal much.
    double weight;
};

// The rays of a stock by the nodes that they pass.
class NodeRays {
public:
    explicit NodeRays(const DexelStock& stock)
        : stock_{stock},
          counts_{stock.field(2).columns(), stock.field(2).rows(), stock.field(0).rows()},
          steps_{stock.field(2).column_step(), stock.field(2).row_step(),
                 stock.field(0).row_step()}
    {
    }

    const Node& counts() const { return counts_; }  // of nodes in the block
    const Vec3& steps() const { return steps_; }    // mm

    // Place of a node along an axis, mm from the block's low corner.
    double at(int axis, int number) const { return (number + 0.5) * steps_[axis]; }

    // The intervals of the ray along an axis through a node in the block.
    std::span<const DexelInterval> intervals(int axis, const Node& node) const
    {
        return stock_.field(axis).upper(node[std::size_t((axis + 1) % 3)],
                                        node[std::size_t((axis + 2) % 3)]);
    }

    double length(std::int32_t units) const { return units * stock_.unit(); }

    // Whether the ray along an axis has material at a node in the block.
    bool has_material(int axis, const Node& node) const
    {
        const double place = at(axis, node[std::size_t(axis)]);
        const auto on_ray = intervals(axis, node);
        const auto after = std::ranges::upper_bound(
            on_ray, place, {},
            [&](const DexelInterval& one) { return length(one.from); });
        return after != on_ray.begin() && length(std::prev(after)->to) >= place;
    }

    // The crossing between an inside node and the next or the previous one along an axis.
    Crossing crossing(int axis, const Node& inside, bool is_upwards) const
    {
        const int number = inside[std::size_t(axis)];
        const double from = at(axis, number);
        const double to = at(axis, is_upwards ? number + 1 : number - 1);
        double end = to;
        for (const DexelInterval& one : intervals(axis, inside))
            if (length(one.from) <= from && from <= length(one.to))
                end = length(is_upwards ? one.to : one.from);
        end = is_upwards ? std::min(end, to) : std::max(end, to);
        const RayEnd ray_end{axis, inside, end, is_upwards};
        Crossing found{Vec3::Zero(), Vec3::Zero(), 1};
        for (int c = 0; c < 3; ++c)
            found.point[c] = c == axis ? end : at(c, inside[std::size_t(c)]);
        found.normal[axis] = 1;
        for (int across = 0; across < 3; ++across)
            if (across != axis)
                found.normal[across] = -slope(ray_end, across);
        found.normal.normalize();
        found.weight = found.normal[axis] * found.normal[axis];
        if (!is_upwards)
            found.normal = -found.normal;
        return found;
    }

private:
    // An end of an interval on a ray.
    struct RayEnd {
        int axis;       // of the ray
        Node node;      // on the ray
        double place;   // mm from the block's low corner
        bool is_upper;  // of its interval
    };

    // How much an end changes to the next ray on one side, at most by the steepest slope;
    // nothing without a ray there.
    // \param side 1 or -1.
    std::optional<double> change(const RayEnd& end, int across, int side) const
    {
        Node other = end.node;
        int& number = other[std::size_t(across)];
        number += side;
        if (number < 0 || number >= counts_[std::size_t(across)])
            return std::nullopt;
        double found = steepest * steps_[across];
        for (const DexelInterval& one : intervals(end.axis, other)) {
            const double away = length(end.is_upper ? one.to : one.from) - end.place;
            if (std::abs(away) < std::abs(found))
                found = away;
        }
        return found;
    }

    // Slope of the surface at an end. At an edge of the stock the side that changes less
    // counts.
    double slope(const RayEnd& end, int across) const
    {
        const double step = steps_[across];
        const auto before = change(end, across, -1);
        const auto after = change(end, across, 1);
        if (before && after && std::abs(*before + *after) <= most_bend * step)
            return (*after - *before) / (2 * step);
        if (after && (!before || std::abs(*after) <= std::abs(*before)))
            return *after / step;
        return before ? -*before / step : 0;
    }

    const DexelStock& stock_;
    Node counts_;
    Vec3 steps_;
};

// Returns the place where the tangent planes of the crossings meet, as near as possible to
// their middle.
Vec3 meeting_point(std::span<const Crossing> crossings)
{
    Vec3 middle = Vec3::Zero();
    for (const Crossing& one : crossings)
        middle += one.point;
    middle /= static_cast<double>(crossings.size());
    Eigen::Matrix3d planes = Eigen::Matrix3d::Zero();
    Vec3 offsets = Vec3::Zero();
    for (const Crossing& one : crossings) {
        const Vec3 weighted = one.weight * one.normal;
        planes += weighted * one.normal.transpose();
        offsets += weighted * one.normal.dot(one.point - middle);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver{planes};
    const Vec3& values = solver.eigenvalues();
    Vec3 place = middle;
    for (int c = 0; c < 3; ++c)
        if (values[c] > least_eigenvalue * values[2]) {
            const Vec3 direction = solver.eigenvectors().col(c);
            place += direction * (direction.dot(offsets) / values[c]);
        }
    return place;
}

class DexelSurface {
public:
    explicit DexelSurface(const DexelStock& stock)
        : rays_{stock},
          low_{stock.block().low},
          across_{static_cast<std::size_t>(rays_.counts()[0]) + 2},
          along_{static_cast<std::size_t>(rays_.counts()[1]) + 2},
          below_(across_ * along_, 0),
          above_(across_ * along_, 0),
          lower_cubes_(across_ * along_, none),
          cubes_(across_ * along_, none)
    {
    }

    TriangleMesh mesh()
    {
        for (int k = -1; k < rays_.counts()[2]; ++k) {
            std::swap(below_, above_);
            mark(above_, k + 1);
            std::swap(lower_cubes_, cubes_);
            std::ranges::fill(cubes_, none);
            for_cubes([&](int i, int j) { add_vertex({i, j, k}); });
            for_cubes([&](int i, int j) { add_quadrilaterals({i, j, k}); });
        }
        return {std::move(points_), std::move(triangles_)};
    }

private:
    static constexpr std::int32_t none = -1;
    static constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();

    // Number of a node or cube in its layer; both count from -1.
    std::size_t index(int i, int j) const
    {
        return static_cast<std::size_t>(j + 1) * across_ +
               static_cast<std::size_t>(i + 1);
    }

    template <typename Use>
    void for_cubes(const Use& use) const
    {
        for (int j = -1; j < rays_.counts()[1]; ++j)
            for (int i = -1; i < rays_.counts()[0]; ++i)
                use(i, j);
    }

    void mark(std::vector<std::uint8_t>& layer, int k) const
    {
        std::ranges::fill(layer, std::uint8_t{0});
        if (k >= rays_.counts()[2])
            return;
        const auto rows = static_cast<std::size_t>(rays_.counts()[1]);
        parallel_for(rows, [&](std::size_t begin, std::size_t end) {
            for (auto j = static_cast<int>(begin); j < static_cast<int>(end); ++j)
                for (int i = 0; i < rays_.counts()[0]; ++i) {
                    const Node node{i, j, k};
                    layer[index(i, j)] = rays_.has_material(2, node) &&
                                         rays_.has_material(0, node) &&
                                         rays_.has_material(1, node);
                }
        });
    }

    // Whether a node of the layers k and k + 1 is inside.
    bool is_inside(int i, int j, bool is_above) const
    {
        return (is_above ? above_ : below_)[index(i, j)] != 0;
    }

    // Adds the vertex of a cube from a node to the next one along x, y and z.
    void add_vertex(const Node& cube)
    {
        const auto [i, j, k] = cube;
        std::array<bool, 8> inside{};
        for (std::size_t c = 0; c < 8; ++c)
            inside[c] = is_inside(i + static_cast<int>(c & 1U),
                                  j + static_cast<int>(c >> 1U & 1U), (c & 4U) != 0);
        const auto count = std::ranges::count(inside, true);
        if (count == 0 || count == 8)
            return;
        std::array<Crossing, 12> crossings;
        std::size_t found = 0;
        for (std::size_t c = 0; c < 8; ++c)
            for (int axis = 0; axis < 3; ++axis) {
                const std::size_t bit = std::size_t{1} << static_cast<unsigned>(axis);
                if ((c & bit) != 0 || inside[c] == inside[c | bit])
                    continue;
                const std::size_t of = inside[c] ? c : c | bit;
                const Node node{i + static_cast<int>(of & 1U),
                                j + static_cast<int>(of >> 1U & 1U),
                                k + static_cast<int>(of >> 2U & 1U)};
                crossings[found++] = rays_.crossing(axis, node, inside[c]);
            }
        Vec3 place = meeting_point({crossings.data(), found});
        for (int c = 0; c < 3; ++c)
            place[c] = std::clamp(place[c], rays_.at(c, cube[std::size_t(c)]),
                                  rays_.at(c, cube[std::size_t(c)] + 1));
        if (points_.size() >= most)
            throw LimitError{"the mesh of the stock has more than 2^31 - 1 points"};
        cubes_[index(i, j)] = static_cast<std::int32_t>(points_.size());
        points_.emplace_back(low_ + place);
    }

    // Adds the surface around the three edges that begin at the first node of a cube.
    void add_quadrilaterals(const Node& cube)
    {
        const auto [i, j, k] = cube;
        const bool here = is_inside(i, j, false);
        if (here != is_inside(i, j, true))
            add(here, {cubes_[index(i - 1, j - 1)], cubes_[index(i, j - 1)],
                       cubes_[index(i, j)], cubes_[index(i - 1, j)]});
        if (here != is_inside(i + 1, j, false))
            add(here, {lower_cubes_[index(i, j - 1)], lower_cubes_[index(i, j)],
                       cubes_[index(i, j)], cubes_[index(i, j - 1)]});
        if (here != is_inside(i, j + 1, false))
            add(here, {lower_cubes_[index(i - 1, j)], cubes_[index(i - 1, j)],
                       cubes_[index(i, j)], lower_cubes_[index(i, j)]});
    }

    // Adds two triangles that meet along the shorter diagonal.
    // \param corners counter-clockwise seen from the end of the edge.
    void add(bool is_inside_first, std::array<std::int32_t, 4> corners)
    {
        if (triangles_.size() + 2 > most)
            throw LimitError{"the mesh of the stock has more than 2^31 - 1 triangles"};
        if (!is_inside_first)
            std::swap(corners[1], corners[3]);
        const auto point = [&](std::size_t c) -> const Vec3& {
            return points_[static_cast<std::size_t>(corners[c])];
        };
        const std::size_t first =
            (point(0) - point(2)).squaredNorm() <= (point(1) - point(3)).squaredNorm()
                ? 0
                : 1;
        const auto corner = [&](std::size_t c) { return corners[(first + c) % 4]; };
        triangles_.push_back({corner(0), corner(1), corner(2)});
        triangles_.push_back({corner(0), corner(2), corner(3)});
    }

    NodeRays rays_;
    Vec3 low_;
    std::size_t across_;  // nodes of a layer along x, with those outside the block
    std::size_t along_;   // the same along y
    std::vector<std::uint8_t> below_;  // whether the nodes of a layer are inside
    std::vector<std::uint8_t> above_;
    std::vector<std::int32_t> lower_cubes_;  // vertices of the cubes of a layer
    std::vector<std::int32_t> cubes_;
    std::vector<Vec3> points_;
    std::vector<Triangle> triangles_;
};

}  // namespace

TriangleMesh stock_mesh(const DexelStock& stock)
{
    return DexelSurface{stock}.mesh();
}

}  // namespace endmill
