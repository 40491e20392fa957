// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/bezier_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "endmill/core/detail/widest_registers.h"
#include "endmill/core/error.h"
#include "endmill/surface/detail/bernstein_basis.h"
#include "endmill/surface/detail/cubic_bernstein.h"

namespace endmill {
namespace {

// Partial derivatives of the four homogeneous coordinates: entry (m, n) is the m-th
// derivative in u and the n-th in v.
template <int Orders>
using Partials = std::array<Eigen::Matrix<double, Orders, Orders>, 4>;

// The control nets of a patch, one after the other for each homogeneous coordinate.
struct Nets {
    const double* first;
    int degree_u;
    int degree_v;
};

// The bicubic case, with matrices of fixed size.
template <int Orders, int Count>
void add_bicubic(Partials<Orders>& partials, const Nets& nets, const SurfacePoint& at)
{
    const auto basis_u = cubic_bernstein<Orders>(at.u);
    const auto basis_v = cubic_bernstein<Orders>(at.v);
    for (int c = 0; c < Count; ++c) {
        const Eigen::Map<const Eigen::Matrix4d, Eigen::Aligned16> net{
            nets.first + std::ptrdiff_t{16} * c};
        partials[c] = basis_u.transpose() * (net * basis_v);
    }
}

template <int Orders, int Count>
void add_general(Partials<Orders>& partials, const Nets& nets, const SurfacePoint& at)
{
    const auto basis_u = bernstein_basis<Orders>(nets.degree_u, at.u);
    const auto basis_v = bernstein_basis<Orders>(nets.degree_v, at.v);
    for (int c = 0; c < Count; ++c) {
        const Eigen::Map<const Eigen::MatrixXd> net{
            nets.first + c * basis_u.rows() * basis_v.rows(), basis_u.rows(),
            basis_v.rows()};
        const BernsteinBasis<Orders> across = net.lazyProduct(basis_v);
        partials[c] = basis_u.transpose().lazyProduct(across);
    }
}

template <int Orders, int Count>
Partials<Orders> partials_at(const Nets& nets, const SurfacePoint& at)
{
    Partials<Orders> partials;
    if (nets.degree_u == 3 && nets.degree_v == 3)
        add_bicubic<Orders, Count>(partials, nets, at);
    else
        add_general<Orders, Count>(partials, nets, at);
    return partials;
}

// The (m, n)-th partial derivative of (w x, w y, w z).
template <int Orders>
Vec3 vector(const Partials<Orders>& partials, int m, int n)
{
    return {partials[0](m, n), partials[1](m, n), partials[2](m, n)};
}

template <int Orders>
SurfaceTangents tangents_of(const Partials<Orders>& p)
{
    return {vector(p, 0, 0), vector(p, 1, 0), vector(p, 0, 1)};
}

SurfaceJet jet_of(const Partials<3>& p)
{
    return {vector(p, 0, 0), vector(p, 1, 0), vector(p, 0, 1),
            vector(p, 2, 0), vector(p, 1, 1), vector(p, 0, 2)};
}

// Number of places that are evaluated at a time.
constexpr std::size_t lanes = 8;

// Bernstein polynomials of one degree at several places. Polynomial k at place i is at [k
// * count + i], and so is its derivative. `count` is a multiple of `lanes`; the places
// beyond the given ones equal the last of these.
struct BasisRows {
    std::size_t count;
    std::vector<double> values;
    std::vector<double> slopes;

    BasisRows(int degree, std::span<const double> at)
        : count{(at.size() + lanes - 1) / lanes * lanes}
    {
        const auto polynomials = static_cast<std::size_t>(degree) + 1;
        values.resize(polynomials * count);
        slopes.resize(polynomials * count);
        for (std::size_t i = 0; i < at.size(); ++i) {
            if (degree == 3)
                take(i, cubic_bernstein<2>(at[i]));
            else
                take(i, bernstein_basis<2>(degree, at[i]));
        }
        for (std::size_t k = 0; k < polynomials; ++k)
            for (std::size_t i = at.size(); i < count; ++i) {
                values[k * count + i] = values[k * count + at.size() - 1];
                slopes[k * count + i] = slopes[k * count + at.size() - 1];
            }
    }

private:
    template <typename Basis>
    void take(std::size_t place, const Basis& basis)
    {
        for (Eigen::Index k = 0; k < basis.rows(); ++k) {
            values[static_cast<std::size_t>(k) * count + place] = basis(k, 0);
            slopes[static_cast<std::size_t>(k) * count + place] = basis(k, 1);
        }
    }
};

// One coordinate to be evaluated on a grid: at all places along u, and at up to `lanes`
// places along v.
struct GridSum {
    const double* net;       // control net, u varying fastest
    const double* values_u;  // as in BasisRows
    const double* slopes_u;
    const double* values_v;  // as in BasisRows, from the first of the places along v
    const double* slopes_v;
    std::size_t points_u;
    std::size_t points_v;
    std::size_t count_u;   // multiple of `lanes`
    std::size_t stride_v;  // count of the BasisRows along v
    std::size_t rows;      // places along v
};

// Evaluates the coordinate on the grid, then its partial derivatives in u and in v. The
// sum over the control points along v comes first, for all places along v at a time.
// Place (i, j) is at [j * count_u + i].
// \tparam points control points along u and along v, if both are known; else 0.
template <std::size_t points>
[[gnu::always_inline]] inline void sum_up_grid(const GridSum& grid,
                                               double* __restrict sums)
{
    const std::size_t points_u = points > 0 ? points : grid.points_u;
    const std::size_t points_v = points > 0 ? points : grid.points_v;
    constexpr std::size_t most_points = points > 0 ? points : most_degree + 1;
    std::array<double, most_points * lanes> across;
    std::array<double, most_points * lanes> across_dv;
    for (std::size_t a = 0; a < points_u; ++a)
        for (std::size_t j = 0; j < lanes; ++j) {
            double value = 0;
            double slope = 0;
            for (std::size_t b = 0; b < points_v; ++b) {
                const double point = grid.net[b * points_u + a];
                value += point * grid.values_v[b * grid.stride_v + j];
                slope += point * grid.slopes_v[b * grid.stride_v + j];
            }
            across[a * lanes + j] = value;
            across_dv[a * lanes + j] = slope;
        }
    const std::size_t count = grid.count_u;
    const std::size_t size = grid.rows * count;
    for (std::size_t j = 0; j < grid.rows; ++j)
        for (std::size_t i = 0; i < count; ++i) {
            double value = 0;
            double along_u = 0;
            double along_v = 0;
            for (std::size_t a = 0; a < points_u; ++a) {
                const double value_u = grid.values_u[a * count + i];
                value += across[a * lanes + j] * value_u;
                along_u += across[a * lanes + j] * grid.slopes_u[a * count + i];
                along_v += across_dv[a * lanes + j] * value_u;
            }
            sums[j * count + i] = value;
            sums[size + j * count + i] = along_u;
            sums[2 * size + j * count + i] = along_v;
        }
}

ENDMILL_WIDEST_REGISTERS
void sum_up_bicubic(const GridSum grid, double* __restrict sums)
{
    sum_up_grid<4>(grid, sums);
}

ENDMILL_WIDEST_REGISTERS
void sum_up_general(const GridSum grid, double* __restrict sums)
{
    sum_up_grid<0>(grid, sums);
}

// One coordinate to be evaluated at several places along u and one place in v.
struct RowSum {
    const double* net;       // control net, u varying fastest
    const double* values_u;  // as in BasisRows
    const double* values_v;  // at one place
    std::size_t points_u;
    std::size_t points_v;
    std::size_t stride_v;
    std::size_t count;  // multiple of `lanes`
};

// Converts the sums of w r and w at all places to those of r, as `projected` does.
ENDMILL_WIDEST_REGISTERS
void project(std::size_t count, double* __restrict sums)
{
    const double* const w = sums + 9 * count;
    const double* const w_u = w + count;
    const double* const w_v = w_u + count;
    for (std::size_t c = 0; c < 3; ++c) {
        double* const r = sums + 3 * c * count;
        double* const r_u = r + count;
        double* const r_v = r_u + count;
        for (std::size_t first = 0; first < count; first += lanes) {
            ENDMILL_NOT_UNROLLED
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                const std::size_t i = first + lane;
                const double point = r[i] / w[i];
                const double along_u = (r_u[i] - w_u[i] * point) / w[i];
                const double along_v = (r_v[i] - w_v[i] * point) / w[i];
                r[i] = point;
                r_u[i] = along_u;
                r_v[i] = along_v;
            }
        }
    }
}

// Evaluates the coordinate alone.
ENDMILL_WIDEST_REGISTERS
void sum_up_values(const RowSum row, double* __restrict sums)
{
    const std::size_t count = row.count;
    for (std::size_t i = 0; i < count; ++i)
        sums[i] = 0;
    for (std::size_t a = 0; a < row.points_u; ++a) {
        double across = 0;
        for (std::size_t b = 0; b < row.points_v; ++b)
            across += row.net[b * row.points_u + a] * row.values_v[b * row.stride_v];
        const double* __restrict values = row.values_u + a * count;
        for (std::size_t i = 0; i < count; ++i)
            sums[i] += across * values[i];
    }
}

using HomogeneousNet = std::vector<Eigen::Vector4d>;

struct Degrees {
    int u;
    int v;
};

// The patch of these degrees whose control point (i, j) is `point(i, j)`.
template <class Point>
BezierPatch rearranged(const BezierPatch& patch, Degrees degrees, const Point& point)
{
    HomogeneousNet net;
    for (int j = 0; j <= degrees.v; ++j)
        for (int i = 0; i <= degrees.u; ++i)
            net.push_back(point(i, j));
    return BezierPatch::from_homogeneous(degrees.u, degrees.v, net, patch.is_rational());
}

}  // namespace

BezierPatch::BezierPatch(int degree_u, int degree_v, bool is_rational)
    : degree_u_{degree_u},
      degree_v_{degree_v},
      is_rational_{is_rational}
{
    require(1 <= degree_u && degree_u <= most_degree && 1 <= degree_v &&
                degree_v <= most_degree,
            "BezierPatch: degrees must be in 1 … 25");
}

BezierPatch::BezierPatch(std::span<const Vec3> net) : BezierPatch{3, 3, net} {}

BezierPatch::BezierPatch(int degree_u, int degree_v, std::span<const Vec3> net,
                         std::span<const double> weights)
    : BezierPatch{degree_u, degree_v, !weights.empty()}
{
    const auto count = static_cast<std::size_t>(points());
    require(net.size() == count,
            "BezierPatch: a net has (degree_u + 1)(degree_v + 1) control points");
    require(weights.empty() || weights.size() == count,
            "BezierPatch: a rational net has a weight for each control point");
    HomogeneousNet homogeneous;
    for (std::size_t k = 0; k < count; ++k) {
        const double weight = weights.empty() ? 1 : weights[k];
        homogeneous.emplace_back();
        homogeneous.back() << weight * net[k], weight;
    }
    *this = from_homogeneous(degree_u, degree_v, homogeneous, is_rational_);
}

BezierPatch BezierPatch::from_homogeneous(int degree_u, int degree_v,
                                          std::span<const Eigen::Vector4d> net,
                                          bool is_rational)
{
    BezierPatch patch{degree_u, degree_v, is_rational};
    require(net.size() == static_cast<std::size_t>(patch.points()),
            "BezierPatch: a net has (degree_u + 1)(degree_v + 1) control points");
    require(std::ranges::all_of(net, [](const auto& point) { return point.allFinite(); }),
            "BezierPatch: control points must be finite");
    require(std::ranges::all_of(net, [](const auto& point) { return point[3] > 0; }),
            "BezierPatch: weights must be above zero");
    // Only ratios of weights matter. Scaling by a power of two causes no rounding.
    double greatest = 0;
    for (const Eigen::Vector4d& point : net)
        greatest = std::max(greatest, point[3]);
    const int exponent = is_rational ? std::ilogb(greatest) : 0;
    for (int c = 0; c < (is_rational ? 4 : 3); ++c)
        for (const Eigen::Vector4d& point : net)
            patch.nets_.push_back(std::ldexp(point[c], -exponent));
    return patch;
}

// A rational patch is evaluated in homogeneous coordinates and then projected.
SurfaceTangents BezierPatch::tangents(double u, double v) const
{
    const Nets nets{nets_.data(), degree_u_, degree_v_};
    if (!is_rational_)
        return tangents_of(partials_at<2, 3>(nets, {u, v}));
    const auto partials = partials_at<2, 4>(nets, {u, v});
    return projected(tangents_of(partials), partials[3]);
}

std::vector<SurfaceTangents> BezierPatch::tangents(std::span<const double> u,
                                                   std::span<const double> v) const
{
    std::vector<SurfaceTangents> all;
    if (u.empty())
        return all;
    all.reserve(u.size() * v.size());
    const BasisRows basis_u{degree_u_, u};
    const BasisRows basis_v{degree_v_, v};
    const bool is_bicubic = degree_u_ == 3 && degree_v_ == 3;
    const std::size_t count = basis_u.count;
    std::vector<double> sums(4 * 3 * std::min(lanes, v.size()) * count);
    for (std::size_t first = 0; first < v.size(); first += lanes) {
        const std::size_t rows = std::min(lanes, v.size() - first);
        const std::size_t size = rows * count;
        for (std::size_t c = 0; c < (is_rational_ ? 4U : 3U); ++c) {
            const GridSum grid{
                .net = nets_.data() + c * static_cast<std::size_t>(points()),
                .values_u = basis_u.values.data(),
                .slopes_u = basis_u.slopes.data(),
                .values_v = &basis_v.values[first],
                .slopes_v = &basis_v.slopes[first],
                .points_u = static_cast<std::size_t>(degree_u_) + 1,
                .points_v = static_cast<std::size_t>(degree_v_) + 1,
                .count_u = count,
                .stride_v = basis_v.count,
                .rows = rows};
            if (is_bicubic)
                sum_up_bicubic(grid, &sums[3 * c * size]);
            else
                sum_up_general(grid, &sums[3 * c * size]);
        }
        if (is_rational_)
            project(size, sums.data());
        for (std::size_t j = 0; j < rows; ++j)
            for (std::size_t i = 0; i < u.size(); ++i) {
                const double* const at = &sums[j * count + i];
                const auto vector = [&](std::size_t kind) -> Vec3 {
                    return {at[kind * size], at[(3 + kind) * size],
                            at[(6 + kind) * size]};
                };
                all.push_back({vector(0), vector(1), vector(2)});
            }
    }
    return all;
}

std::vector<Vec3> BezierPatch::places(std::span<const double> u,
                                      std::span<const double> v) const
{
    std::vector<Vec3> all;
    all.reserve(u.size() * v.size());
    const BasisRows basis_u{degree_u_, u};
    const BasisRows basis_v{degree_v_, v};
    const auto size = static_cast<std::size_t>(points());
    const std::size_t count = basis_u.count;
    std::vector<double> sums(4 * count, 1);
    for (std::size_t j = 0; j < v.size(); ++j) {
        for (std::size_t c = 0; c < (is_rational_ ? 4U : 3U); ++c)
            sum_up_values({nets_.data() + c * size, basis_u.values.data(),
                           &basis_v.values[j], static_cast<std::size_t>(degree_u_) + 1,
                           static_cast<std::size_t>(degree_v_) + 1, basis_v.count, count},
                          &sums[c * count]);
        for (std::size_t i = 0; i < u.size(); ++i)
            all.emplace_back(Vec3{sums[i], sums[count + i], sums[2 * count + i]} /
                             sums[3 * count + i]);
    }
    return all;
}

SurfaceJet BezierPatch::jet(double u, double v) const
{
    const Nets nets{nets_.data(), degree_u_, degree_v_};
    if (!is_rational_)
        return jet_of(partials_at<3, 3>(nets, {u, v}));
    const auto partials = partials_at<3, 4>(nets, {u, v});
    return projected(jet_of(partials), partials[3]);
}

BezierPatch transposed(const BezierPatch& patch)
{
    return rearranged(patch, {patch.degree(Parameter::V), patch.degree(Parameter::U)},
                      [&](int i, int j) { return patch.homogeneous_point(j, i); });
}

BezierPatch reversed_in_u(const BezierPatch& patch)
{
    const int degree = patch.degree(Parameter::U);
    return rearranged(patch, {degree, patch.degree(Parameter::V)}, [&](int i, int j) {
        return patch.homogeneous_point(degree - i, j);
    });
}

}  // namespace endmill
