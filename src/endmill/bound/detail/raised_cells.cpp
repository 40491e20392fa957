// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/raised_cells.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "endmill/bound/detail/raised_point.h"

namespace endmill {
namespace {

// Divisions of a cell along each parameter.
constexpr int divisions = 4;
constexpr int lattice = divisions + 1;
// A cell whose lowest corner is farther from the boundary of D(x) than its size by this
// factor does not meet it.
constexpr double size_margin = 1.5;
// Most bins in the xy plane.
constexpr double most_bins = 1 << 20;
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
using Triangle = std::array<Vertex, 3>;

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
            visit(Triangle{vertices[k], vertices[k + 1], vertices[k + lattice + 1]});
            visit(
                Triangle{vertices[k], vertices[k + lattice + 1], vertices[k + lattice]});
        }
}

SurfacePoint between(const SurfacePoint& from, const SurfacePoint& to, double share)
{
    return {std::lerp(from.u, to.u, share), std::lerp(from.v, to.v, share)};
}

// The root of Phi between two vertices, by one step of the method of false position and
// a parabola through the three values.
SurfacePoint crossing(const March& march, std::size_t surface, const Vertex& from,
                      const Vertex& to)
{
    const double t = from.excess / (from.excess - to.excess);
    const SurfacePoint guess = between(from.at, to.at, t);
    const double value = march.vertex(surface, guess).excess;
    const double curve = (value - std::lerp(from.excess, to.excess, t)) / (t * (t - 1));
    const double slope = to.excess - from.excess + curve * (2 * t - 1);
    const double moved = t - value / slope;
    return between(from.at, to.at, 0 <= moved && moved <= 1 ? moved : t);
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

// The share of a triangle in which a linear function with these values is below 0.
double share_below(const Triangle& triangle)
{
    std::array<double, 3> value{triangle[0].excess, triangle[1].excess,
                                triangle[2].excess};
    std::ranges::sort(value);
    const auto [a, b, c] = value;
    if (c <= 0)
        return 1;
    if (a >= 0)
        return 0;
    if (b <= 0)
        return 1 - c * c / ((c - a) * (c - b));
    return a * a / ((a - b) * (a - c));
}

}  // namespace

RaisedCells::RaisedCells(const BoundedPart& part, const BoundProblem& problem,
                         double spacing)
    : part_{part},
      problem_{problem},
      grid_{part, spacing}
{
    const double h = problem.scallop_height;
    for (std::uint32_t k = 0; k < grid_.cells().size(); ++k) {
        const DensityCell& cell = grid_.cells()[k];
        const auto corner = [&](double u, double v) -> Vec3 {
            return raised_place(part, cell.surface, {u, v}, h).point;
        };
        const Vec3 point = corner(cell.u.low, cell.v.low);
        double size = 0;
        for (const double u : {cell.u.low, cell.u.high})
            for (const double v : {cell.v.low, cell.v.high})
                size = std::max(size, (corner(u, v) - point).norm());
        entries_.push_back({point, size, k});
        greatest_size_ = std::max(greatest_size_, size);
    }
    sort_into_bins();
}

void RaisedCells::sort_into_bins()
{
    Eigen::AlignedBox3d box;
    for (const Entry& entry : entries_)
        box.extend(entry.point);
    low_ = box.min();
    const Vec3 size = box.sizes();
    const double reach = problem_.cutter.radius() + problem_.stray;
    bin_ = std::max(reach / 3, std::sqrt(size.x() * size.y() / most_bins));
    bin_ = std::max(bin_, std::max(size.x(), size.y()) / most_bins);
    columns_ = static_cast<int>(size.x() / bin_) + 1;
    rows_ = static_cast<int>(size.y() / bin_) + 1;
    const auto bin_of = [&](const Entry& entry) {
        return static_cast<std::size_t>(row(entry.point.y())) * columns_ +
               column(entry.point.x());
    };
    std::ranges::stable_sort(entries_, {}, bin_of);
    bins_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
    for (const Entry& entry : entries_)
        ++bins_[bin_of(entry) + 1];
    for (std::size_t k = 1; k < bins_.size(); ++k)
        bins_[k] += bins_[k - 1];
}

int RaisedCells::column(double x) const
{
    return std::clamp(static_cast<int>((x - low_.x()) / bin_), 0, columns_ - 1);
}

int RaisedCells::row(double y) const
{
    return std::clamp(static_cast<int>((y - low_.y()) / bin_), 0, rows_ - 1);
}

// Calls visit(entry, from_nearest) for the cells whose lowest corner is within `far` of the
// tool, until it returns false.
template <typename Visit>
void RaisedCells::visit_near(const ToolReach& tool, double far, const Visit& visit) const
{
    const Vec3& c = tool.centre();
    for (int row_at = row(c.y() - far); row_at <= row(c.y() + far); ++row_at) {
        const std::size_t first = static_cast<std::size_t>(row_at) * columns_;
        const std::uint32_t begin = bins_[first + column(c.x() - far)];
        const std::uint32_t end = bins_[first + column(c.x() + far) + 1];
        for (std::uint32_t k = begin; k < end; ++k) {
            const Vec3 away = tool.from_nearest(entries_[k].point);
            if (away.squaredNorm() <= far * far && !visit(entries_[k], away))
                return;
        }
    }
}

// The distance from the tool within which a cell that meets D(x) has its lowest corner.
double RaisedCells::far_from(const ToolReach& tool) const
{
    return tool.reach() + size_margin * greatest_size_;
}

bool RaisedCells::has_only(const ContactFrame& frame, const CoverRays& rays) const
{
    const ToolReach tool{problem_, frame.centre};
    bool has_other = false;
    visit_near(tool, tool.reach(), [&](const Entry& entry, const Vec3&) {
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
    visit_near(
        march.tool, far_from(march.tool), [&](const Entry& entry, const Vec3& away) {
            if (std::abs(away.norm() - march.tool.reach()) > size_margin * entry.size)
                return true;
            const DensityCell& cell = grid_.cells()[entry.cell];
            for_each_triangle(divided(march, cell), [&](const Triangle& triangle) {
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
    visit_near(
        march.tool, far_from(march.tool), [&](const Entry& entry, const Vec3& away) {
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
            for_each_triangle(divided(march, cell), [&](const Triangle& triangle) {
                area += share_below(triangle) * element *
                        (triangle[0].area + triangle[1].area + triangle[2].area) / 3;
            });
            pieces.push_back({cell.surface, middle, area});
            return true;
        });
    return pieces;
}

}  // namespace endmill
