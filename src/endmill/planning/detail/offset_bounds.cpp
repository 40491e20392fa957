// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/offset_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

#include "endmill/core/parallel.h"
#include "endmill/surface/detail/bend_bounds.h"
#include "endmill/surface/detail/bernstein_net.h"
#include "endmill/surface/detail/collapsed_edge.h"

// The bounds of the normal N = n / |n|, n = du x dv:
// 1. n is a polynomial of a patch. Its Bernstein coefficients bound it by their convex
//    hull. On a collapsed edge n has a linear factor, which is divided out; this does not
//    change N.
// 2. The patch is divided into count by count pieces. On a piece the least length of n is
//    bounded by its components along the mean direction, and the lengths of its
//    derivatives by their greatest coefficients.
// 3. These three give a bound on |N_uu| and |N_vv|.
// 4. Where the least length is small beside the greatest one, the bounds are wide, and
//    the pieces are halved, down to 1/32 of the patch. For patches with weights, n is w^3
//    du x dv, which has the same direction.

namespace endmill {
namespace {

// Least and greatest number of rectangles of a patch in each parameter. The least is that
// of bend_bounds.
constexpr int least_count = 4;
constexpr int most_count = 32;
// Least length of du x dv, as a share of the greatest, above which a rectangle is not
// halved: the bounds would gain little.
constexpr double even_normals = 0.3;

// The Bernstein coefficients of a vector polynomial, here du x dv.
using VectorNet = std::array<BernsteinNet, 3>;

// du x dv without the linear factors that vanish on collapsed edges.
VectorNet reduced_normal_nets(const BezierPatch& patch)
{
    VectorNet nets;
    for (int c = 0; c < 3; ++c) {
        nets[c] = normal_net(patch, Vec3::Unit(c));
        for (const Parameter parameter : {Parameter::U, Parameter::V})
            for (const int edge : {0, 1})
                if (is_collapsed(patch, parameter, edge))
                    nets[c] = divided_by_edge(nets[c], parameter, edge);
    }
    return nets;
}

// Coefficients of the derivative along u.
BernsteinNet derivative(const BernsteinNet& net)
{
    const auto degree = net.rows() - 1;
    if (degree == 0)
        return BernsteinNet::Zero(1, net.cols());
    return double(degree) * (net.bottomRows(degree) - net.topRows(degree));
}

// Upper bound of the length of the vector.
double longest(const VectorNet& nets)
{
    return std::sqrt(
        (nets[0].array().square() + nets[1].array().square() + nets[2].array().square())
            .maxCoeff());
}

template <class Change>
VectorNet changed(const VectorNet& nets, const Change& change)
{
    return {change(nets[0]), change(nets[1]), change(nets[2])};
}

// Lower bound of the length of the vector: the least component along the mean direction.
double shortest(const VectorNet& nets)
{
    Vec3 mean{nets[0].mean(), nets[1].mean(), nets[2].mean()};
    if (!(mean.norm() > 0))
        return 0;
    mean.normalize();
    return (mean[0] * nets[0] + mean[1] * nets[1] + mean[2] * nets[2]).minCoeff();
}

// Upper bound of |N_uu| for N = n / |n|, where `least` bounds |n| from below. With t =
// |n_u| / |n|, the component of N_uu along N is -|N_u|^2, at most t^2 in size. The
// component across N is that of n_uu / |n| - 2 (|n|_u / |n|) N_u, at most |n_uu| / |n| +
// t^2.
double normal_bend(const VectorNet& nets, double least)
{
    if (!(least > 0))
        return std::numeric_limits<double>::infinity();
    const VectorNet first = changed(nets, derivative);
    const double turn = longest(first) / least;
    const double across = longest(changed(first, derivative)) / least + turn * turn;
    return std::hypot(across, turn * turn);
}

VectorNet transposed_nets(const VectorNet& nets)
{
    return changed(
        nets, [](const BernsteinNet& net) -> BernsteinNet { return net.transpose(); });
}

// The coefficients on `count` equal pieces along `along`; `count` is a power of two.
std::vector<VectorNet> pieces_along(VectorNet nets, Parameter along, int count)
{
    if (count == 1)
        return {std::move(nets)};
    VectorNet low;
    VectorNet high;
    for (int c = 0; c < 3; ++c)
        std::tie(low[c], high[c]) = halves(nets[c], along);
    std::vector<VectorNet> pieces = pieces_along(std::move(low), along, count / 2);
    for (VectorNet& piece : pieces_along(std::move(high), along, count / 2))
        pieces.push_back(std::move(piece));
    return pieces;
}

// Bounds on the second derivatives of N.
struct NormalBends {
    double uu;
    double vv;
};

// Bounds on count by count pieces, per squared unit of the patch's parameters, u running
// fastest.
struct GridBends {
    int count;
    bool is_even;  // halving would not improve any piece much
    std::vector<NormalBends> pieces;
};

GridBends normal_bends(const VectorNet& nets, int count)
{
    GridBends grid{count, true, {}};
    const double unit = double(count) * count;
    for (const VectorNet& row : pieces_along(nets, Parameter::V, count))
        for (const VectorNet& piece : pieces_along(row, Parameter::U, count)) {
            const double least = shortest(piece);
            grid.is_even = grid.is_even && least >= even_normals * longest(piece);
            grid.pieces.push_back({unit * normal_bend(piece, least),
                                   unit * normal_bend(transposed_nets(piece), least)});
        }
    return grid;
}

GridBends normal_bends(const BezierPatch& patch)
{
    const VectorNet nets = reduced_normal_nets(patch);
    GridBends grid = normal_bends(nets, least_count);
    while (!grid.is_even && grid.count < most_count)
        grid = normal_bends(nets, 2 * grid.count);
    return grid;
}

std::vector<OffsetBends> patch_rectangles(const Surface& surface, int i, int j)
{
    const BezierPatch& patch = surface.patch(i, j);
    const GridBends normals = normal_bends(patch);
    const auto bends = bend_bounds(patch);
    const auto u = surface.breaks(Parameter::U).subspan(i, 2);
    const auto v = surface.breaks(Parameter::V).subspan(j, 2);
    const double unit_u = 1 / ((u[1] - u[0]) * (u[1] - u[0]));
    const double unit_v = 1 / ((v[1] - v[0]) * (v[1] - v[0]));
    const int count = normals.count;
    const auto cut = [count](std::span<const double> range, int k) {
        return k == count ? range[1] : std::lerp(range[0], range[1], k / double(count));
    };
    std::vector<OffsetBends> rectangles;
    for (int row = 0; row < count; ++row)
        for (int column = 0; column < count; ++column) {
            const BendBounds& r = bends[row * bounded_pieces / count * bounded_pieces +
                                        column * bounded_pieces / count];
            const NormalBends& n = normals.pieces[row * count + column];
            rectangles.push_back({{cut(u, column), cut(v, row)},
                                  {cut(u, column + 1), cut(v, row + 1)},
                                  unit_u * r.uu,
                                  unit_v * r.vv,
                                  unit_u * n.uu,
                                  unit_v * n.vv});
        }
    return rectangles;
}

}  // namespace

OffsetBounds::OffsetBounds(const Surface& surface) : surface_{&surface}
{
    const int columns = surface.patches(Parameter::U);
    const auto count = static_cast<std::size_t>(columns) * surface.patches(Parameter::V);
    std::vector<std::vector<OffsetBends>> of_patches(count);
    parallel_for(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            of_patches[k] = patch_rectangles(surface, int(k) % columns, int(k) / columns);
    });
    for (const std::vector<OffsetBends>& own : of_patches) {
        const int side = static_cast<int>(std::lround(std::sqrt(double(own.size()))));
        patches_.push_back({rectangles_.size(), side});
        rectangles_.insert(rectangles_.end(), own.begin(), own.end());
    }
}

const OffsetBends& OffsetBounds::at(double u, double v) const
{
    const int i = surface_->patch_number(Parameter::U, u);
    const int j = surface_->patch_number(Parameter::V, v);
    const PatchGrid& grid =
        patches_[static_cast<std::size_t>(j) * surface_->patches(Parameter::U) + i];
    const auto place = [&](Parameter along, int number, double parameter) {
        const auto range = surface_->breaks(along).subspan(number, 2);
        const double share = (parameter - range[0]) / (range[1] - range[0]);
        return std::clamp(static_cast<int>(share * grid.count), 0, grid.count - 1);
    };
    int column = place(Parameter::U, i, u);
    int row = place(Parameter::V, j, v);
    const auto rectangle = [&]() -> const OffsetBends& {
        return rectangles_[grid.first + static_cast<std::size_t>(row) * grid.count +
                           column];
    };
    // Rounding may have put a point on a border into the rectangle below it.
    if (column + 1 < grid.count && u >= rectangle().high.u)
        ++column;
    if (row + 1 < grid.count && v >= rectangle().high.v)
        ++row;
    return rectangle();
}

std::vector<OffsetBends> OffsetBounds::across(Interval v) const
{
    const int columns = surface_->patches(Parameter::U);
    std::vector<OffsetBends> found;
    const int last = surface_->patch_number(Parameter::V, v.high);
    for (int j = surface_->patch_number(Parameter::V, v.low); j <= last; ++j)
        for (int i = 0; i < columns; ++i) {
            const PatchGrid& grid = patches_[static_cast<std::size_t>(j) * columns + i];
            const auto own = std::span{rectangles_}.subspan(
                grid.first, static_cast<std::size_t>(grid.count) * grid.count);
            for (const OffsetBends& rectangle : own)
                if (rectangle.low.v < v.high && v.low < rectangle.high.v)
                    found.push_back(rectangle);
        }
    return found;
}

}  // namespace endmill
