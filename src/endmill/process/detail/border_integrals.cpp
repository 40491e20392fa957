// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/border_integrals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "endmill/core/detail/widest_registers.h"

// Line integrals along the borders of the engaged region, by an adaptive Gauss-Kronrod
// rule:
// 1. All arcs are put on a stack. Arcs of constant azimuth are skipped: their integral is
//    0.
// 2. For the arc on top, the points at the 15 nodes are computed, with y dX - X dy, then
//    the eight integrands, and from them the eight sums of the Kronrod rule and of the
//    Gauss rule.
// 3. If no pair of sums differs by more than the tolerance, the Kronrod sums are added to
//    the total. Otherwise the two halves of the arc replace it on the stack.
// All loops run over 16 nodes without branches, so that the compiler uses SIMD registers.
// With (1 - cos d) dt = (y dX - X dy) / (1 - Z), no integrand has a singular point
// (paper/notes/ball-engagement.md, section 3).

namespace endmill {
namespace {

constexpr int nodes = 16;  // 15, and one of weight 0 that fills the SIMD registers
constexpr int lanes = 4;

using Row = std::array<double, nodes>;

// Nodes and weights of the Gauss-Kronrod rule of 15 nodes on [-1, 1] and of its Gauss
// rule of 7 nodes, in ascending order of the nodes.
struct Rule {
    Row node{};
    Row weight{};
    Row gauss_weight{};  // 0 at the nodes that the Gauss rule does not have
};

// Boost tabulates the nodes from 0 on; every second one belongs to the Gauss rule.
Rule gauss_kronrod_rule()
{
    using boost::math::quadrature::gauss;
    using boost::math::quadrature::gauss_kronrod;
    const auto& kronrod_node = gauss_kronrod<double, 15>::abscissa();
    const auto& kronrod_weight = gauss_kronrod<double, 15>::weights();
    const auto& gauss_weight = gauss<double, 7>::weights();
    constexpr std::size_t middle = 7;
    Rule rule;
    for (std::size_t k = 0; k < kronrod_node.size(); ++k)
        for (const int side : {-1, 1}) {
            const std::size_t at = side < 0 ? middle - k : middle + k;
            rule.node[at] = k == 0 ? 0 : side * kronrod_node[k];
            rule.weight[at] = kronrod_weight[k];
            rule.gauss_weight[at] = k % 2 == 0 ? gauss_weight[k / 2] : 0;
        }
    return rule;
}

const Rule rule = gauss_kronrod_rule();

// Coefficients of torque_height_share in powers of 2u - 1, from its Chebyshev series of
// degree
// 20. The next term of the series is 1e-17.
constexpr std::array<double, 21> height_share{
    0.709199576156145235,    0.054400565125139498,    0.0153326269269083556,
    0.00450451999558602168,  0.001357108979340724,    0.000415819481432203479,
    0.000128954507092785666, 4.03554436357991056e-5,  1.27182570285136182e-5,
    4.03086804541122726e-6,  1.2834287233552013e-6,   4.10269873936984827e-7,
    1.31566550375541486e-7,  4.21969366451421578e-8,  1.3591079314634928e-8,
    4.53173313639513294e-9,  1.47539347212301531e-9,  3.65779664717030118e-10,
    1.14572538003212002e-10, 8.72284951619901148e-11, 2.92228169349759437e-11};

// Horner's rule in v = 2u - 1.
inline double height_share_at(double u)
{
    const double v = 2 * u - 1;
    double sum = height_share.back();
    for (std::size_t k = height_share.size() - 1; k-- > 0;)
        sum = sum * v + height_share[k];
    return sum;
}

// Four numbers in one register, as an extension of GCC and Clang.
using Lanes = double __attribute__((vector_size(lanes * sizeof(double))));

// The same for all nodes at once, `u` becoming the result: even and odd powers apart, by
// Horner's rule in v^2. The steps of one sum wait for each other, so that two short sums
// take less time than a long one.
inline void replace_by_height_share(Row& u)
{
    std::array<Lanes, nodes / lanes> v;
    std::array<Lanes, nodes / lanes> square;
    std::array<Lanes, nodes / lanes> even;
    std::array<Lanes, nodes / lanes> odd;
    std::memcpy(&v, &u, sizeof v);
    for (std::size_t i = 0; i < v.size(); ++i) {
        v[i] = 2 * v[i] - 1;
        square[i] = v[i] * v[i];
        even[i] = Lanes{} + height_share[height_share.size() - 1];
        odd[i] = Lanes{} + height_share[height_share.size() - 2];
    }
    ENDMILL_NOT_UNROLLED
    for (std::size_t k = height_share.size() - 1; k > 2; k -= 2)
        for (std::size_t i = 0; i < v.size(); ++i) {
            even[i] = even[i] * square[i] + height_share[k - 2];
            odd[i] = odd[i] * square[i] + height_share[k - 3];
        }
    for (std::size_t i = 0; i < v.size(); ++i)
        v[i] = (even[i] * square[i] + height_share[0]) + odd[i] * v[i];
    std::memcpy(&u, &v, sizeof u);
}

// Points of a border at the nodes. `turn` is the product of the node's step with y dX - X
// dy, which is sin^2 of the latitude times the change of the azimuth.
struct BorderNodes {
    Row x;
    Row y;
    Row z;
    Row turn;
};

// Part of an arc.
struct Stretch {
    BorderKind kind;
    double from;  // p
    double to;    // p
};

// The parameter p at node i.
inline double parameter(const Stretch& stretch, int i)
{
    return (stretch.from + stretch.to) / 2 +
           (stretch.to - stretch.from) / 2 * rule.node[i];
}

// Derivative of the angle x = 2 atan(p) by the variable of the rule on [-1, 1], times 1 +
// p^2.
inline double angle_rate(const Stretch& stretch)
{
    return stretch.to - stretch.from;
}

// Nodes on the front plane.
inline void front_nodes(const EngagedRegion& region, const Stretch& stretch,
                        BorderNodes& at)
{
    const double rate = angle_rate(stretch) * region.sin_lambda;
    for (int i = 0; i < nodes; ++i) {
        const double p = parameter(stretch, i);
        const double unit = 1 / (1 + p * p);
        const double cosine = (1 - p) * (1 + p) * unit;
        at.x[i] = cosine * region.sin_lambda;
        at.y[i] = -2 * p * unit;
        at.z[i] = -cosine * region.cos_lambda;
        at.turn[i] = rate * unit;
    }
}

// Nodes on the wall.
inline void wall_nodes(const EngagedRegion& region, const Stretch& stretch,
                       BorderNodes& at)
{
    const double rho = std::sqrt((1 - region.wall) * (1 + region.wall));
    const double rate = angle_rate(stretch) * region.wall;
    for (int i = 0; i < nodes; ++i) {
        const double p = parameter(stretch, i);
        const double unit = 1 / (1 + p * p);
        const double cosine = rho * (1 - p) * (1 + p) * unit;
        at.x[i] = rho * 2 * p * unit;
        at.y[i] = region.wall;
        at.z[i] = -cosine;
        at.turn[i] = rate * unit * cosine;
    }
}

// Nodes on the curve of the previous pass. The formulas of pass_point, repeated here for
// 16 points at once without a function call.
inline void previous_ball_nodes(const EngagedRegion& region, const Stretch& stretch,
                                BorderNodes& at)
{
    const EngagedRegion& r = region;
    const PreviousPassCurve& c = region.pass;
    const double rate = angle_rate(stretch);
    for (int i = 0; i < nodes; ++i) {
        const double p = parameter(stretch, i);
        const double unit = 1 / (1 + p * p);
        const double sine = 2 * p * unit;
        const double cosine = (1 - p) * (1 + p) * unit;
        const double half_sine = c.amplitude * sine;
        const double half_cosine = std::sqrt((1 - half_sine) * (1 + half_sine));
        const double sin_nu = 2 * half_sine * half_cosine;
        const double cos_nu = 1 - 2 * half_sine * half_sine;
        const double sin_phi = cos_nu * c.cos_mu + sin_nu * c.sin_mu;
        const double cos_phi = sin_nu * c.cos_mu - cos_nu * c.sin_mu;
        const double tau = c.reach * cosine;
        const double w = -c.rise - cos_phi;
        const double phi_by_x = -2 * c.amplitude * cosine / half_cosine;
        const double x_by_x =
            -c.reach * sine * r.cos_lambda - sin_phi * phi_by_x * r.sin_lambda;
        at.x[i] = tau * r.cos_lambda - w * r.sin_lambda;
        at.y[i] = sin_phi - c.across;
        at.z[i] = w * r.cos_lambda + tau * r.sin_lambda;
        at.turn[i] = rate * unit * (at.y[i] * x_by_x - at.x[i] * cos_phi * phi_by_x);
    }
}

// The integrands of I1 to I8 at the nodes.
using Integrands = std::array<Row, 8>;

// Keeps divisions by sin^2 of the latitude finite at the tip, where the azimuth is
// undefined and the integrands vanish.
constexpr double least_square = 1e-300;

// The share of the height at the nodes.
inline Row height_shares(const BorderNodes& at)
{
    Row share;
    for (int i = 0; i < nodes; ++i) {
        const double square = at.x[i] * at.x[i] + at.y[i] * at.y[i] + least_square;
        share[i] = square * (1 / (1 - at.z[i]));
    }
    replace_by_height_share(share);
    return share;
}

// Integrands with the paper's chip: its thickness is |sin(azimuth)|.
inline void paper_integrands(const BorderNodes& at, Integrands& f)
{
    const Row share = height_shares(at);
    for (int i = 0; i < nodes; ++i) {
        const double square = at.x[i] * at.x[i] + at.y[i] * at.y[i] + least_square;
        const double sine = std::sqrt(square);
        const double sin_azimuth = at.x[i] / sine;
        const double cos_azimuth = at.y[i] / sine;
        const double chip = std::abs(sin_azimuth);
        const double above_tip = 1 / (1 - at.z[i]);
        const double edge = at.turn[i] * above_tip;
        const double torque = edge * sine * share[i];
        f[0][i] = chip * cos_azimuth * edge;
        f[1][i] = chip * sin_azimuth * edge;
        f[2][i] = cos_azimuth * edge;
        f[3][i] = sin_azimuth * edge;
        f[4][i] = chip * edge;
        f[5][i] = edge;
        f[6][i] = chip * torque;
        f[7][i] = torque;
    }
}

// Integrands with the exact chip: its area is (cos lambda sin d sin t - sin lambda cos d)
// dd dt.
inline void exact_integrands(const EngagedRegion& region, const BorderNodes& at,
                             Integrands& f)
{
    const Row share = height_shares(at);
    const double along = region.cos_lambda;
    const double down = region.sin_lambda;
    for (int i = 0; i < nodes; ++i) {
        const double square = at.x[i] * at.x[i] + at.y[i] * at.y[i] + least_square;
        const double sine = std::sqrt(square);
        const double sin_azimuth = at.x[i] / sine;
        const double cos_azimuth = at.y[i] / sine;
        const double above_tip = 1 / (1 - at.z[i]);
        const double edge = at.turn[i] * above_tip;
        const double torque = edge * sine * share[i];
        const double chip = along * sin_azimuth * edge - down * at.turn[i] / sine;
        f[0][i] = cos_azimuth * chip;
        f[1][i] = sin_azimuth * chip;
        f[2][i] = cos_azimuth * edge;
        f[3][i] = sin_azimuth * edge;
        f[4][i] = chip;
        f[5][i] = edge;
        f[6][i] = along * sin_azimuth * torque - down * at.turn[i] / 2;
        f[7][i] = torque;
    }
}

// Weighted sum in four independent lanes.
inline double weighted(const Row& weight, const Row& f)
{
    Lanes part{};
    for (int i = 0; i < nodes; i += lanes) {
        Lanes factor;
        Lanes value;
        std::memcpy(&factor, &weight[i], sizeof factor);
        std::memcpy(&value, &f[i], sizeof value);
        part += factor * value;
    }
    return (part[0] + part[1]) + (part[2] + part[3]);
}

// Sums over a part of an arc by both rules.
struct BothSums {
    CoefficientSums kronrod;
    CoefficientSums gauss;
};

ENDMILL_WIDEST_REGISTERS
void integrate(const EngagedRegion& region, ChipModel chip, const Stretch& stretch,
               BothSums& sums)
{
    BorderNodes at;
    if (stretch.kind == BorderKind::Front)
        front_nodes(region, stretch, at);
    else if (stretch.kind == BorderKind::Wall)
        wall_nodes(region, stretch, at);
    else
        previous_ball_nodes(region, stretch, at);
    Integrands f;
    if (chip == ChipModel::Paper)
        paper_integrands(at, f);
    else
        exact_integrands(region, at, f);
    for (std::size_t k = 0; k < f.size(); ++k) {
        sums.kronrod[k] = weighted(rule.weight, f[k]);
        sums.gauss[k] = weighted(rule.gauss_weight, f[k]);
    }
}

double largest_difference(const BothSums& sums)
{
    double largest = 0;
    for (std::size_t k = 0; k < sums.gauss.size(); ++k)
        largest = std::max(largest, std::abs(sums.kronrod[k] - sums.gauss[k]));
    return largest;
}

}  // namespace

double torque_height_share(double one_minus_cosine)
{
    return height_share_at(one_minus_cosine);
}

CoefficientSums border_integrals(const EngagedRegion& region, ChipModel chip,
                                 double tolerance)
{
    CoefficientSums total{};
    std::vector<Stretch> open;
    const std::vector<BorderArc> arcs = region.borders(
        chip == ChipModel::Paper ? BorderSplit::AtAxis : BorderSplit::Whole);
    for (const BorderArc& arc : arcs)
        if (!region.is_radial(arc.kind))
            open.push_back({arc.kind, arc.from, arc.to});
    while (!open.empty()) {
        const Stretch stretch = open.back();
        open.pop_back();
        BothSums sums;
        integrate(region, chip, stretch, sums);
        if (largest_difference(sums) <= tolerance) {
            for (std::size_t k = 0; k < total.size(); ++k)
                total[k] += sums.kronrod[k];
            continue;
        }
        const double middle = (stretch.from + stretch.to) / 2;
        open.push_back({stretch.kind, middle, stretch.to});
        open.push_back({stretch.kind, stretch.from, middle});
    }
    return total;
}

}  // namespace endmill
