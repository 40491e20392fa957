// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/region_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/error.h"

// How a strip grows over the border of a region.
//
// An edge between a facet that is cut and one that is not has a budget: how far the strip
// reaches beyond it. Edges are taken in the order of their budgets. Let t_k be the budget at the
// edge opposite to corner k of a facet, divided by the height over this edge. What is left of
// the facet is the triangle of the barycentric coordinates l_k >= t_k. If it is empty, the whole
// facet is cut, and the strip goes on beyond it. In the end the other facets that were reached
// are cut up to that triangle.

namespace endmill {
namespace {

// Turn of the normal in rad at which an edge ends the strip: there the tool may roll about the
// edge instead of running on.
constexpr double sharp_turn = 0.5;

Vec3 area_vector(const TriangleMesh& part, std::size_t facet)
{
    const auto [a, b, c] = part.corners(facet);
    return (b - a).cross(c - a) / 2;
}

class StripGrowth {
public:
    StripGrowth(const TriangleMesh& part, std::span<const std::size_t> facets,
                const RegionBorder& border)
        : part_{part},
          border_{border},
          is_cut_(part.triangles().size(), 0),
          shares_(part.triangles().size(), {0, 0, 0})
    {
        find_neighbours();
        for (const std::size_t facet : facets)
            is_cut_[facet] = 1;
        for (const std::size_t facet : facets)
            offer_edges(facet, border.width);
        grow();
    }

    TriangleMesh mesh() const
    {
        std::vector<Vec3> points{part_.points().begin(), part_.points().end()};
        std::vector<Triangle> triangles;
        for (std::size_t facet = 0; facet < is_cut_.size(); ++facet)
            if (is_cut_[facet] != 0)
                triangles.push_back(part_.triangles()[facet]);
            else if (shares_[facet] != Shares{0, 0, 0})
                add_ring(facet, points, triangles);
        return {std::move(points), std::move(triangles)};
    }

private:
    using Shares = std::array<double, 3>;

    // An edge of a facet that is not cut yet, opposite to one of its corners.
    struct Offer {
        double budget;  // mm
        std::size_t facet;
        std::size_t corner;

        // The greatest budget comes first, then the lowest facet.
        friend bool operator<(const Offer& a, const Offer& b)
        {
            if (a.budget != b.budget)
                return a.budget < b.budget;
            return std::pair{a.facet, a.corner} > std::pair{b.facet, b.corner};
        }
    };

    // A facet beyond an edge, and its corner opposite to it.
    struct Neighbour {
        std::int64_t facet = -1;
        std::size_t corner = 0;
    };

    void find_neighbours()
    {
        struct Use {
            MeshEdge edge;
            std::size_t facet;
            std::size_t corner;
        };
        std::vector<Use> uses;
        uses.reserve(3 * is_cut_.size());
        for (std::size_t facet = 0; facet < is_cut_.size(); ++facet)
            for (std::size_t k = 0; k < 3; ++k) {
                const Triangle& corners = part_.triangles()[facet];
                const auto [low, high] =
                    std::minmax(corners[(k + 1) % 3], corners[(k + 2) % 3]);
                uses.push_back({{low, high}, facet, k});
            }
        std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
            return std::pair{a.edge, a.facet} < std::pair{b.edge, b.facet};
        });
        neighbours_.resize(is_cut_.size());
        for (std::size_t k = 1; k < uses.size(); ++k) {
            const Use& a = uses[k - 1];
            const Use& b = uses[k];
            if (a.edge != b.edge)
                continue;
            neighbours_[a.facet][a.corner] = {static_cast<std::int64_t>(b.facet),
                                              b.corner};
            neighbours_[b.facet][b.corner] = {static_cast<std::int64_t>(a.facet),
                                              a.corner};
        }
    }

    bool is_smooth(std::size_t a, std::size_t b) const
    {
        const Vec3 first = area_vector(part_, a);
        const Vec3 second = area_vector(part_, b);
        return std::atan2(first.cross(second).norm(), first.dot(second)) <= sharp_turn;
    }

    // Offers the edges of a facet that is cut to the facets beyond them.
    void offer_edges(std::size_t facet, double budget)
    {
        if (!(budget > 0))
            return;
        for (const Neighbour& beyond : neighbours_[facet]) {
            if (beyond.facet < 0)
                continue;
            const auto other = static_cast<std::size_t>(beyond.facet);
            if (is_cut_[other] == 0 && border_.may_cut(other) && is_smooth(facet, other))
                offers_.push({budget, other, beyond.corner});
        }
    }

    // The height of a facet over the edge opposite to a corner, mm.
    double height(std::size_t facet, std::size_t corner) const
    {
        const std::array<Vec3, 3> at = part_.corners(facet);
        return 2 * area_vector(part_, facet).norm() /
               (at[(corner + 1) % 3] - at[(corner + 2) % 3]).norm();
    }

    void grow()
    {
        while (!offers_.empty()) {
            const auto [budget, facet, corner] = offers_.top();
            offers_.pop();
            if (is_cut_[facet] != 0)
                continue;
            const double over = height(facet, corner);
            Shares& shares = shares_[facet];
            shares[corner] = std::max(shares[corner], over > 0 ? budget / over : 1);
            if (!(shares[0] + shares[1] + shares[2] >= 1))
                continue;
            is_cut_[facet] = 1;
            offer_edges(facet, budget - over / 2);
        }
    }

    // Adds the strips of a facet along its edges.
    void add_ring(std::size_t facet, std::vector<Vec3>& points,
                  std::vector<Triangle>& triangles) const
    {
        const Shares& shares = shares_[facet];
        const std::array<Vec3, 3> at = part_.corners(facet);
        const Triangle& outer = part_.triangles()[facet];
        const double rest = 1 - shares[0] - shares[1] - shares[2];
        Triangle inner{};
        for (std::size_t k = 0; k < 3; ++k) {
            inner[k] = static_cast<std::int32_t>(points.size());
            points.emplace_back(shares[0] * at[0] + shares[1] * at[1] +
                                shares[2] * at[2] + rest * at[k]);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            if (shares[k] == 0)
                continue;
            const std::size_t a = (k + 1) % 3;
            const std::size_t b = (k + 2) % 3;
            triangles.push_back({outer[a], outer[b], inner[b]});
            triangles.push_back({outer[a], inner[b], inner[a]});
        }
    }

    const TriangleMesh& part_;
    const RegionBorder& border_;
    std::vector<char> is_cut_;
    std::vector<Shares> shares_;
    std::vector<std::array<Neighbour, 3>> neighbours_;
    std::priority_queue<Offer> offers_;
};

}  // namespace

TriangleMesh region_mesh(const TriangleMesh& part, std::span<const std::size_t> facets,
                         const RegionBorder& border)
{
    require(std::isfinite(border.width) && border.width >= 0,
            "region_mesh: need a width from 0");
    return StripGrowth{part, facets, border}.mesh();
}

}  // namespace endmill
