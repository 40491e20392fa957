// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/sphere_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/visibility/detail/grid_word.h"

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;

// The solid angle of a spherical triangle, in sr. Differences of corners keep the
// relative accuracy for small cells. Source: [VanOosteromStrackee, eq. (8)].
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c)
{
    const double volume = a.dot((b - a).cross(c - a));
    return 2 * std::atan2(volume, 1 + a.dot(b) + b.dot(c) + c.dot(a));
}

// Builds a grid from corners and cells, in the order in which they are added.
class GridBuilder {
public:
    std::int32_t corner(const Vec3& direction)
    {
        grid_.corners.push_back(direction);
        return static_cast<std::int32_t>(grid_.corners.size()) - 1;
    }

    const Vec3& at(std::int32_t corner) const { return grid_.corners[corner]; }

    // Adds a cell. Its corners may be given in either sense; they are stored
    // counter-clockwise seen from outside.
    void cell(std::int32_t a, std::int32_t b, std::int32_t c)
    {
        grid_.centres.push_back((at(a) + at(b) + at(c)).normalized());
        if (at(a).dot(at(b).cross(at(c))) < 0)
            std::swap(b, c);
        grid_.cells.push_back({a, b, c});
        grid_.solid_angles_sr.push_back(solid_angle(at(a), at(b), at(c)));
    }

    SphereGrid grid(std::string name) &&
    {
        grid_.name = std::move(name);
        return std::move(grid_);
    }

private:
    SphereGrid grid_;
};

Vec3 direction(double polar, double azimuth)
{
    return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
            std::cos(polar)};
}

// The corners of one half of the bipyramid in rings about the pole, with 6 k corners on
// ring k.
class HexRings {
public:
    HexRings(GridBuilder& builder, int f)
    {
        for (int k = 0; k <= f; ++k) {
            std::vector<std::int32_t>& ring = rings_.emplace_back();
            for (int i = 0; i < std::max(1, 6 * k); ++i) {
                Vec3 point = direction(pi / 2 * k / f, k == 0 ? 0 : pi / 3 * i / k);
                if (k == f)
                    point.z() = 0;  // exact, because both halves share the last ring
                ring.push_back(builder.corner(point));
            }
        }
    }

    // The southern half that matches this northern half.
    HexRings below(GridBuilder& builder) const
    {
        HexRings south{*this};
        for (std::size_t k = 0; k + 1 < rings_.size(); ++k)
            for (std::int32_t& corner : south.rings_[k]) {
                const Vec3 above = builder.at(corner);
                corner = builder.corner({above.x(), above.y(), -above.z()});
            }
        return south;
    }

    void add_cells(GridBuilder& builder) const
    {
        const int f = static_cast<int>(rings_.size()) - 1;
        for (int k = 0; k < f; ++k)
            for (int s = 0; s < 6; ++s)
                for (int i = 0; i <= k; ++i) {
                    builder.cell(at(k, s, i), at(k + 1, s, i), at(k + 1, s, i + 1));
                    if (i < k)
                        builder.cell(at(k, s, i), at(k + 1, s, i + 1), at(k, s, i + 1));
                }
    }

private:
    std::int32_t at(int ring, int sector, int i) const
    {
        return rings_[ring][ring == 0 ? 0 : (sector * ring + i) % (6 * ring)];
    }

    std::vector<std::vector<std::int32_t>> rings_;
};

void add_hex(GridBuilder& builder, int f)
{
    const HexRings north{builder, f};
    north.add_cells(builder);
    north.below(builder).add_cells(builder);
}

// The corners of the squares on a cube. The key is the place on the cube: a number of
// steps from -f to f along each axis. Faces share the corners on their common sides.
class CubeCorners {
public:
    CubeCorners(GridBuilder& builder, int f) : builder_{builder}, f_{f} {}

    std::int32_t at(const std::array<int, 3>& steps)
    {
        const auto [place, is_new] = numbers_.try_emplace(steps, 0);
        if (is_new)
            place->second = builder_.corner(
                Vec3{along(steps[0]), along(steps[1]), along(steps[2])}.normalized());
        return place->second;
    }

private:
    double along(int step) const
    {
        return std::abs(step) == f_ ? (step < 0 ? -1.0 : 1.0)
                                    : std::tan(pi / 4 * step / f_);
    }

    GridBuilder& builder_;
    int f_;
    std::map<std::array<int, 3>, std::int32_t> numbers_;
};

void add_cube_face(GridBuilder& builder, CubeCorners& corners, int f, int axis, int sign)
{
    const auto corner = [&](int i, int j) {
        std::array<int, 3> steps{};
        steps[axis] = sign * f;
        steps[(axis + 1) % 3] = 2 * i - f;
        steps[(axis + 2) % 3] = 2 * j - f;
        return corners.at(steps);
    };
    for (int i = 0; i < f; ++i)
        for (int j = 0; j < f; ++j) {
            builder.cell(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1));
            builder.cell(corner(i, j), corner(i + 1, j + 1), corner(i, j + 1));
        }
}

void add_cube(GridBuilder& builder, int f)
{
    CubeCorners corners{builder, f};
    for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {-1, 1})
            add_cube_face(builder, corners, f, axis, sign);
}

// The corners on a parallel between two bands. A pole is repeated as often as a parallel
// has corners.
std::vector<std::int32_t> latitude_ring(GridBuilder& builder, int around, int ring,
                                        int bands)
{
    if (ring == 0 || ring == bands)
        return std::vector<std::int32_t>(around,
                                         builder.corner({0, 0, ring == 0 ? 1.0 : -1.0}));
    std::vector<std::int32_t> corners;
    corners.reserve(around);
    for (int j = 0; j < around; ++j)
        corners.push_back(
            builder.corner(direction(pi * ring / bands, 2 * pi * j / around)));
    return corners;
}

void add_latlong(GridBuilder& builder, int around, int bands)
{
    std::vector<std::vector<std::int32_t>> rings;
    rings.reserve(bands + 1);
    for (int i = 0; i <= bands; ++i)
        rings.push_back(latitude_ring(builder, around, i, bands));
    for (int i = 0; i < bands; ++i)
        for (int j = 0; j < around; ++j) {
            const int next = (j + 1) % around;
            if (i + 1 < bands)
                builder.cell(rings[i][j], rings[i + 1][j], rings[i + 1][next]);
            if (i > 0)
                builder.cell(rings[i][j], rings[i + 1][next], rings[i][next]);
        }
}

// Adds the twelve corners of an icosahedron. \return its twenty triangles, which are the
// triples of neighbouring corners.
std::vector<Triangle> icosahedron(GridBuilder& builder)
{
    constexpr double tau = std::numbers::phi;
    for (int axis = 0; axis < 3; ++axis)
        for (const double one : {-1.0, 1.0})
            for (const double long_side : {-tau, tau}) {
                Vec3 point = Vec3::Zero();
                point[axis] = one;
                point[(axis + 1) % 3] = long_side;
                builder.corner(point.normalized());
            }
    const auto are_neighbours = [&](std::int32_t a, std::int32_t b) {
        // The dot product is 1/sqrt(5) for neighbours and at most -1/sqrt(5) for others.
        return builder.at(a).dot(builder.at(b)) > 0.4;
    };
    std::vector<Triangle> triangles;
    for (std::int32_t a = 0; a < 12; ++a)
        for (std::int32_t b = a + 1; b < 12; ++b)
            for (std::int32_t c = b + 1; c < 12; ++c)
                if (are_neighbours(a, b) && are_neighbours(b, c) && are_neighbours(c, a))
                    triangles.push_back({a, b, c});
    return triangles;
}

// Each level divides every triangle into four at the middles of its sides.
void add_ico(GridBuilder& builder, int levels)
{
    std::vector<Triangle> triangles = icosahedron(builder);
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
        const auto middle = [&](std::int32_t a, std::int32_t b) {
            const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), 0);
            if (is_new)
                place->second =
                    builder.corner((builder.at(a) + builder.at(b)).normalized());
            return place->second;
        };
        std::vector<Triangle> finer;
        finer.reserve(4 * triangles.size());
        for (const auto& [a, b, c] : triangles) {
            const std::int32_t ab = middle(a, b);
            const std::int32_t bc = middle(b, c);
            const std::int32_t ca = middle(c, a);
            finer.insert(finer.end(),
                         {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        triangles = std::move(finer);
    }
    for (const auto& [a, b, c] : triangles)
        builder.cell(a, b, c);
}

}  // namespace

SphereGrid sphere_grid(std::string_view name)
{
    const GridWord word = grid_word(name);
    const std::string fineness = std::to_string(word.fineness);
    GridBuilder builder;
    switch (word.kind) {
        case GridKind::Hex:
            add_hex(builder, word.fineness);
            return std::move(builder).grid("hex:" + fineness);
        case GridKind::Cube:
            add_cube(builder, word.fineness);
            return std::move(builder).grid("cube:" + fineness);
        case GridKind::LatLong:
            add_latlong(builder, word.fineness, word.bands);
            return std::move(builder).grid("latlong:" + fineness + "x" +
                                           std::to_string(word.bands));
        case GridKind::Ico:
            break;
    }
    add_ico(builder, word.fineness);
    return std::move(builder).grid("ico:" + fineness);
}

std::size_t sphere_grid_cells(std::string_view name)
{
    return static_cast<std::size_t>(grid_word(name).cells);
}

}  // namespace endmill
