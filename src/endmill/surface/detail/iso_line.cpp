// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/iso_line.h"

#include <algorithm>
#include <array>
#include <utility>

#include "endmill/core/tolerance.h"
#include "endmill/surface/detail/bernstein_basis.h"
#include "endmill/surface/detail/bernstein_polynomial.h"
#include "endmill/surface/detail/cubic_bernstein.h"
#include "endmill/surface/detail/cubic_root.h"

namespace endmill {
namespace {

using CubicNets = Eigen::Map<const Eigen::Matrix<double, 4, 9>, Eigen::Aligned16>;

// The homogeneous curve v = constant of a patch and its derivatives across, in the layout
// of IsoLine::Piece. `basis` holds the Bernstein polynomials at v.
template <int Coordinates, class Basis>
Eigen::MatrixXd nets_across(const BezierPatch& patch, const Basis& basis)
{
    const int degree_u = patch.degree(Parameter::U);
    const int degree_v = patch.degree(Parameter::V);
    Eigen::MatrixXd nets = Eigen::MatrixXd::Zero(degree_u + 1, 3 * Coordinates);
    for (int j = 0; j <= degree_v; ++j)
        for (int k = 0; k <= degree_u; ++k) {
            const Eigen::Vector4d point = patch.homogeneous_point(k, j);
            for (int order = 0; order < 3; ++order)
                for (int c = 0; c < Coordinates; ++c)
                    nets(k, order * Coordinates + c) += basis(j, order) * point[c];
        }
    return nets;
}

double longest_row(const Eigen::MatrixXd& points)
{
    return points.rowwise().norm().maxCoeff();
}

// Control points of the derivative of a curve over an interval of this width.
Eigen::MatrixXd derivative(const Eigen::MatrixXd& points, double width)
{
    const auto degree = points.rows() - 1;
    if (degree == 0)
        return Eigen::MatrixXd::Zero(1, points.cols());
    return double(degree) / width * (points.bottomRows(degree) - points.topRows(degree));
}

}  // namespace

IsoLine::IsoLine(const Surface& surface, double v)
    : v_{v},
      is_point_{true},
      breaks_{surface.breaks(Parameter::U).begin(), surface.breaks(Parameter::U).end()}
{
    const double same_point = same_point_share * surface.diagonal();
    const int row = surface.patch_number(Parameter::V, v);
    const auto breaks_v = surface.breaks(Parameter::V);
    const double slope = 1 / (breaks_v[row + 1] - breaks_v[row]);
    const double local_v = (v - breaks_v[row]) * slope;
    pieces_.reserve(breaks_.size() - 1);
    for (int i = 0; i < surface.patches(Parameter::U); ++i) {
        const BezierPatch& patch = surface.patch(i, row);
        BernsteinBasis<3> basis = bernstein_basis<3>(patch.degree(Parameter::V), local_v);
        basis.col(1) *= slope;
        basis.col(2) *= slope * slope;
        pieces_.push_back({patch.is_rational(), patch.is_rational()
                                                    ? nets_across<4>(patch, basis)
                                                    : nets_across<3>(patch, basis)});
    }
    const Vec3 start = point(breaks_.front());
    for (const Piece& piece : pieces_)
        for (const auto& net_point : piece.nets.rowwise()) {
            const double weight = piece.is_rational ? net_point[3] : 1;
            const Vec3 from_start = net_point.head<3>().transpose() / weight - start;
            is_point_ = is_point_ && from_start.norm() <= same_point;
        }
}

int IsoLine::piece_number(double u) const
{
    const auto first = breaks_.begin() + 1;
    return static_cast<int>(std::upper_bound(first, breaks_.end() - 1, u) - first);
}

Vec3 IsoLine::point(double u) const
{
    const int i = piece_number(u);
    const Piece& piece = pieces_[i];
    const double t = (u - breaks_[i]) / (breaks_[i + 1] - breaks_[i]);
    if (piece.is_cubic())
        return CubicNets{piece.nets.data()}.leftCols<3>().transpose() *
               cubic_bernstein<2>(t).col(0);
    const auto basis = bernstein_basis<1>(static_cast<int>(piece.nets.rows()) - 1, t);
    const Vec3 point = piece.nets.leftCols<3>().transpose().lazyProduct(basis);
    return piece.is_rational ? Vec3{point / piece.nets.col(3).dot(basis.col(0))} : point;
}

SurfaceJet IsoLine::jet(double u) const
{
    const int i = piece_number(u);
    const double slope = 1 / (breaks_[i + 1] - breaks_[i]);
    return jet_of(pieces_[i], (u - breaks_[i]) * slope, slope);
}

SurfaceJet IsoLine::jet_of(const Piece& piece, double t, double slope)
{
    if (piece.is_cubic()) {
        Eigen::Matrix<double, 4, 3> basis = cubic_bernstein<3>(t);
        basis.col(1) *= slope;
        basis.col(2) *= slope * slope;
        const CubicNets nets{piece.nets.data()};
        const Eigen::Matrix3d along = nets.leftCols<3>().transpose() * basis;
        const Eigen::Matrix<double, 3, 2> across =
            nets.middleCols<3>(3).transpose() * basis.leftCols<2>();
        return {along.col(0),  along.col(1),
                across.col(0), along.col(2),
                across.col(1), nets.rightCols<3>().transpose() * basis.col(0)};
    }
    BernsteinBasis<3> basis =
        bernstein_basis<3>(static_cast<int>(piece.nets.rows()) - 1, t);
    basis.col(1) *= slope;
    basis.col(2) *= slope * slope;
    // Row c of block m holds the derivatives along u of coordinate c of the m-th
    // derivative across.
    const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::ColMajor, 12> partials =
        piece.nets.transpose().lazyProduct(basis);
    const int coordinates = piece.is_rational ? 4 : 3;
    const auto vector = [&](int along, int across) -> Vec3 {
        return partials.col(along).segment<3>(across * coordinates);
    };
    SurfaceJet jet{vector(0, 0), vector(1, 0), vector(0, 1),
                   vector(2, 0), vector(1, 1), vector(0, 2)};
    if (!piece.is_rational)
        return jet;
    Eigen::Matrix3d weights;
    for (int across = 0; across < 3; ++across)
        weights.col(across) = partials.row(across * coordinates + 3);
    return projected(jet, weights);
}

double IsoLine::bend_bound_of(int piece, double low, double high) const
{
    const double start = breaks_[piece];
    const double width = breaks_[piece + 1] - start;
    const bool is_rational = pieces_[piece].is_rational;
    const Eigen::MatrixXd& nets = pieces_[piece].nets;
    // The second derivative is linear, so it is greatest at an end.
    if (pieces_[piece].is_cubic()) {
        const auto bend = [&](double u) -> Vec3 {
            return CubicNets{nets.data()}.leftCols<3>().transpose() *
                   cubic_bernstein<3>((u - start) / width).col(2);
        };
        return std::max(bend(low).norm(), bend(high).norm()) / (width * width);
    }
    const auto first_columns = [&](int from, int count) {
        Eigen::MatrixXd part{nets.rows(), count};
        for (int c = 0; c < count; ++c) {
            const auto column = nets.col(from + c);
            const BernsteinPolynomial on_part =
                restricted({column.begin(), column.end()}, (low - start) / width,
                           (high - start) / width);
            part.col(c) = Eigen::Map<const Eigen::VectorXd>{
                on_part.data(), static_cast<Eigen::Index>(on_part.size())};
        }
        return part;
    };
    // Measured from a point of the line, so that the bound does not depend on the place
    // of the origin.
    Eigen::MatrixXd points = first_columns(0, 3);
    if (!is_rational)
        return longest_row(derivative(derivative(points, high - low), high - low));
    const Eigen::MatrixXd w = first_columns(3, 1);
    const Eigen::RowVector3d origin = points.row(0) / w(0, 0);
    points -= w * origin;
    const auto longest = [&](const Eigen::MatrixXd& net, int times) {
        Eigen::MatrixXd derived = net;
        for (int k = 0; k < times; ++k)
            derived = derivative(derived, high - low);
        return longest_row(derived);
    };
    const double least_w = w.minCoeff();
    const double r = longest(points, 0) / least_w;
    const double dr = (longest(points, 1) + longest(w, 1) * r) / least_w;
    return (longest(points, 2) + 2 * longest(w, 1) * dr + longest(w, 2) * r) / least_w;
}

double IsoLine::bend_bound(double from, double to) const
{
    double bound = 0;
    for (int i = piece_number(from); i < static_cast<int>(pieces_.size()); ++i) {
        const double low = std::max(from, breaks_[i]);
        const double high = std::min(to, breaks_[i + 1]);
        if (low < high)
            bound = std::max(bound, bend_bound_of(i, low, high));
        if (to <= breaks_[i + 1])
            break;
    }
    return bound;
}

// A jump of the first derivative at a border bends the line like a kink: it adds at most
// width / 4 times the jump. A gap adds its whole length.
double IsoLine::chord_error_bound(double from, double to) const
{
    const double width = to - from;
    double bound = width * width / 8 * bend_bound(from, to);
    for (int i = piece_number(from) + 1; i < static_cast<int>(pieces_.size()); ++i) {
        if (to <= breaks_[i])
            break;
        const SurfaceJet below =
            jet_of(pieces_[i - 1], 1, 1 / (breaks_[i] - breaks_[i - 1]));
        const SurfaceJet above = jet_of(pieces_[i], 0, 1 / (breaks_[i + 1] - breaks_[i]));
        bound +=
            width / 4 * (above.du - below.du).norm() + (above.point - below.point).norm();
    }
    return bound;
}

std::optional<double> IsoLine::first_reach(double from, const Vec3& direction,
                                           double distance) const
{
    const Vec3 start = point(from);
    int i = piece_number(from);
    double local_start = (from - breaks_[i]) / (breaks_[i + 1] - breaks_[i]);
    for (; i < static_cast<int>(pieces_.size()); ++i) {
        if (const auto t =
                first_reach_on(pieces_[i], local_start, {start, direction, distance})) {
            const double local = local_start + *t * (1 - local_start);
            return breaks_[i] + local * (breaks_[i + 1] - breaks_[i]);
        }
        local_start = 0;
    }
    return std::nullopt;
}

std::optional<double> IsoLine::first_reach_on(const Piece& piece, double from,
                                              const Reach& reach)
{
    const auto& [start, direction, distance] = reach;
    if (piece.is_cubic()) {
        const CubicNets nets{piece.nets.data()};
        // Signed distance of the control points beyond `distance`, in mm.
        std::array<double, 4> beyond;
        for (int k = 0; k < 4; ++k)
            beyond[k] =
                (nets.row(k).head<3>().transpose() - start).dot(direction) - distance;
        if (from > 0)
            beyond = restrict_to_upper_end(beyond, from);
        return first_rise_to_zero(beyond);
    }
    BernsteinPolynomial beyond(piece.nets.rows());  // the same, times the weight
    for (int k = 0; k < piece.nets.rows(); ++k) {
        const double weight = piece.is_rational ? piece.nets(k, 3) : 1;
        const Vec3 from_start = piece.nets.row(k).head<3>().transpose() - weight * start;
        beyond[k] = from_start.dot(direction) - weight * distance;
    }
    if (from > 0)
        beyond = restricted(std::move(beyond), from, 1);
    return first_rise_to_zero(beyond);
}

}  // namespace endmill
