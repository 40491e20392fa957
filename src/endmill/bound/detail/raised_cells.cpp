// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/raised_cells.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "endmill/bound/detail/boundary_in_triangle.h"
#include "endmill/bound/detail/raised_point.h"

namespace endmill {
namespace {

// Divisions of a cell along each parameter.
constexpr int divisions = 4;
constexpr int lattice = divisions + 1;
// A cell whose lowest corner is farther from the boundary of D(x) than its size by this
// factor does not meet it.
constexpr double size_margin = 1.5;
// Least |grad Phi|. Where the tool touches the raised surface a second time it is 0, and
// the inflow has no limit.
constexpr double least_gradient = 1e-6;

// A vertex of the divided cell.
struct Vertex {
    SurfacePoint at;
    double excess;  // Phi, mm
    double area;    // J
};

using Lattice = std::array<Vertex, lattice * lattice>;
using CellHalf = std::array<Vertex, 3>;

// What the marching of one contact needs.
struct March {
    const BoundedPart& part;
    const BoundProblem& problem;
    const ContactFrame& frame;
    ToolReach tool;

    Vertex vertex(std::size_t surface, const SurfacePoint& at) const
    {
        const RaisedPlace raised =
            raised_place(part, surface, at, problem.scallop_height);
        return {at, tool.excess(raised.point), raised.area};
    }
};

Lattice divided(const March& march, const DensityCell& cell)
{
    Lattice vertices;
    std::size_t k = 0;
    for (int b = 0; b < lattice; ++b)
        for (int a = 0; a < lattice; ++a, ++k)
            vertices[k] =
                march.vertex(cell.surface,
                             {std::lerp(cell.u.low, cell.u.high, a / double{divisions}),
                              std::lerp(cell.v.low, cell.v.high, b / double{divisions})});
    return vertices;
}

template <typename Visit>
void for_each_triangle(const Lattice& vertices, const Visit& visit)
{
    for (std::size_t b = 0; b < divisions; ++b)
        for (std::size_t a = 0; a < divisions; ++a) {
            const std::size_t k = b * lattice + a;
            visit(CellHalf{vertices[k], vertices[k + 1], vertices[k + lattice + 1]});
            visit(
                CellHalf{vertices[k], vertices[k + lattice + 1], vertices[k + lattice]});
        }
}

SurfacePoint between(const SurfacePoint& from, const SurfacePoint& to, double share)
{
    return {std::lerp(from.u, to.u, share), std::lerp(from.v, to.v, share)};
}

// The place between two vertices where Phi is 0.
SurfacePoint crossing(const March& march, std::size_t surface, const Vertex& from,
                      const Vertex& to)
{
    const double share = crossing_share(from.excess, to.excess, [&](double t) {
        return march.vertex(surface, between(from.at, to.at, t)).excess;
    });
    return between(from.at, to.at, share);
}

// The flow through a straight piece of boundary, from the gradient at its middle.
BoundaryFlow flow_through(const March& march, std::size_t surface,
                          const SurfacePoint& from, const SurfacePoint& to)
{
    const SurfacePoint middle = between(from, to, 0.5);
    const RaisedJet jet =
        raised_jet(march.part, surface, middle, march.problem.scallop_height);
    const Vec3 away = march.tool.from_nearest(jet.point).normalized();
    const double slope_u = away.dot(jet.du);
    const double slope_v = away.dot(jet.dv);
    const double E = jet.surface_du.squaredNorm();
    const double F = jet.surface_du.dot(jet.surface_dv);
    const double G = jet.surface_dv.squaredNorm();
    const double gradient =
        std::sqrt(std::max(0.0, G * slope_u * slope_u - 2 * F * slope_u * slope_v +
                                    E * slope_v * slope_v)) /
        jet.area;
    const double length =
        ((to.u - from.u) * jet.surface_du + (to.v - from.v) * jet.surface_dv).norm();
    return {surface, middle,
            boundary_flow(march.frame, march.problem, away,
                          length / std::max(gradient, least_gradient))};
}

}  // namespace

RaisedCells::RaisedCells(const BoundedPart& part, const BoundProblem& problem,
                         double spacing)
    : part_{part},
      problem_{problem},
      grid_{part, spacing},
      bins_{entries(), problem.cutter.radius() + problem.stray}
{
}

std::vector<RaisedCells::Entry> RaisedCells::entries() const
{
    const double h = problem_.scallop_height;
    std::vector<Entry> entries;
    entries.reserve(grid_.cells().size());
    for (std::uint32_t k = 0; k < grid_.cells().size(); ++k) {
        const DensityCell& cell = grid_.cells()[k];
        const auto corner = [&](double u, double v) -> Vec3 {
            return raised_place(part_, cell.surface, {u, v}, h).point;
        };
        const Vec3 point = corner(cell.u.low, cell.v.low);
        double size = 0;
        for (const double u : {cell.u.low, cell.u.high})
            for (const double v : {cell.v.low, cell.v.high})
                size = std::max(size, (corner(u, v) - point).norm());
        entries.push_back({point, size, k});
    }
    return entries;
}

// The distance from the tool within which a cell that meets D(x) has its lowest corner.
double RaisedCells::far_from(const ToolReach& tool) const
{
    return tool.reach() + size_margin * bins_.greatest_size();
}

bool RaisedCells::has_only(const ContactFrame& frame, const CoverRays& rays) const
{
    const ToolReach tool{problem_, frame.centre};
    bool has_other = false;
    bins_.visit_near(tool, tool.reach(), [&](std::uint32_t number, const Vec3&) {
        const Entry& entry = bins_.items()[number];
        const DensityCell& cell = grid_.cells()[entry.cell];
        has_other =
            cell.surface != frame.surface || !rays.contains({cell.u.low, cell.v.low});
        return !has_other;
    });
    return !has_other;
}

std::vector<BoundaryFlow> RaisedCells::boundary(const ContactFrame& frame) const
{
    const March march{part_, problem_, frame, ToolReach{problem_, frame.centre}};
    std::vector<BoundaryFlow> pieces;
    bins_.visit_near(
        march.tool, far_from(march.tool), [&](std::uint32_t number, const Vec3& away) {
            const Entry& entry = bins_.items()[number];
            if (std::abs(away.norm() - march.tool.reach()) > size_margin * entry.size)
                return true;
            const DensityCell& cell = grid_.cells()[entry.cell];
            for_each_triangle(divided(march, cell), [&](const CellHalf& triangle) {
                std::array<SurfacePoint, 2> ends;
                std::size_t found = 0;
                for (std::size_t k = 0; k < 3; ++k) {
                    const Vertex& from = triangle[k];
                    const Vertex& to = triangle[(k + 1) % 3];
                    if ((from.excess > 0) != (to.excess > 0) && found < 2)
                        ends[found++] = crossing(march, cell.surface, from, to);
                }
                if (found == 2) {
                    const BoundaryFlow piece =
                        flow_through(march, cell.surface, ends[0], ends[1]);
                    if (piece.flow.allFinite())
                        pieces.push_back(piece);
                }
            });
            return true;
        });
    return pieces;
}

std::vector<CoveredPiece> RaisedCells::covered(const ContactFrame& frame) const
{
    const March march{part_, problem_, frame, ToolReach{problem_, frame.centre}};
    std::vector<CoveredPiece> pieces;
    bins_.visit_near(
        march.tool, far_from(march.tool), [&](std::uint32_t number, const Vec3& away) {
            const Entry& entry = bins_.items()[number];
            const DensityCell& cell = grid_.cells()[entry.cell];
            const double excess = away.norm() - march.tool.reach();
            if (excess > size_margin * entry.size)
                return true;
            const SurfacePoint middle{(cell.u.low + cell.u.high) / 2,
                                      (cell.v.low + cell.v.high) / 2};
            if (excess < -size_margin * entry.size) {
                pieces.push_back({cell.surface, middle, cell.area});
                return true;
            }
            const double element =
                cell.u.length() * cell.v.length() / (2 * divisions * divisions);
            double area = 0;
            for_each_triangle(divided(march, cell), [&](const CellHalf& triangle) {
                area += share_below({triangle[0].excess, triangle[1].excess,
                                     triangle[2].excess}) *
                        element *
                        (triangle[0].area + triangle[1].area + triangle[2].area) / 3;
            });
            pieces.push_back({cell.surface, middle, area});
            return true;
        });
    return pieces;
}

}  // namespace endmill
