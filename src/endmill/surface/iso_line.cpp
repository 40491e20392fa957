// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/iso_line.h"

#include <algorithm>

#include "endmill/surface/cubic_bernstein.h"
#include "endmill/surface/cubic_root.h"

namespace endmill {
namespace {

constexpr double same_point_share = 1e-12;  // of the surface's diagonal

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
    Eigen::Matrix<double, 4, 3> basis = cubic_bernstein<3>((v - breaks_v[row]) * slope);
    basis.col(1) *= slope;
    basis.col(2) *= slope * slope;

    pieces_.reserve(breaks_.size() - 1);
    for (int i = 0; i < surface.patches(Parameter::U); ++i) {
        Piece& piece = pieces_.emplace_back();
        for (int k = 0; k < 4; ++k) {
            Eigen::Matrix<double, 4, 3> column;
            for (int j = 0; j < 4; ++j)
                column.row(j) = surface.patch(i, row).control_point(k, j);
            const Eigen::Matrix3d partials = column.transpose() * basis;
            piece.point.row(k) = partials.col(0);
            piece.dv.row(k) = partials.col(1);
            piece.dvv.row(k) = partials.col(2);
            const auto from_start = piece.point.row(k) - pieces_.front().point.row(0);
            is_point_ = is_point_ && from_start.norm() <= same_point;
        }
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
    const double t = (u - breaks_[i]) / (breaks_[i + 1] - breaks_[i]);
    return pieces_[i].point.transpose() * cubic_bernstein<2>(t).col(0);
}

SurfaceJet IsoLine::jet(double u) const
{
    const int i = piece_number(u);
    const double slope = 1 / (breaks_[i + 1] - breaks_[i]);
    Eigen::Matrix<double, 4, 3> basis = cubic_bernstein<3>((u - breaks_[i]) * slope);
    basis.col(1) *= slope;
    basis.col(2) *= slope * slope;
    const Eigen::Matrix3d along = pieces_[i].point.transpose() * basis;
    const Eigen::Matrix<double, 3, 2> across =
        pieces_[i].dv.transpose() * basis.leftCols<2>();
    return {along.col(0), along.col(1),  across.col(0),
            along.col(2), across.col(1), pieces_[i].dvv.transpose() * basis.col(0)};
}

Vec3 IsoLine::bend(int piece, double u) const
{
    const double slope = 1 / (breaks_[piece + 1] - breaks_[piece]);
    const double t = (u - breaks_[piece]) * slope;
    return slope * slope *
           (pieces_[piece].point.transpose() * cubic_bernstein<3>(t).col(2));
}

double IsoLine::greatest_bend(double from, double to) const
{
    // Linear on each piece, so that it is greatest at an end of it.
    double greatest = 0;
    for (int i = piece_number(from); i < static_cast<int>(pieces_.size()); ++i) {
        const double low = std::max(from, breaks_[i]);
        const double high = std::min(to, breaks_[i + 1]);
        greatest = std::max({greatest, bend(i, low).norm(), bend(i, high).norm()});
        if (to <= breaks_[i + 1])
            break;
    }
    return greatest;
}

std::optional<double> IsoLine::first_reach(double from, const Vec3& direction,
                                           double distance) const
{
    const Vec3 start = point(from);
    int i = piece_number(from);
    double local_start = (from - breaks_[i]) / (breaks_[i + 1] - breaks_[i]);
    for (; i < static_cast<int>(pieces_.size()); ++i) {
        std::array<double, 4> beyond;  // how far the line is beyond `distance`, in mm
        for (int k = 0; k < 4; ++k)
            beyond[k] =
                (pieces_[i].point.row(k).transpose() - start).dot(direction) - distance;
        if (local_start > 0)
            beyond = restrict_to_upper_end(beyond, local_start);
        if (const auto t = first_rise_to_zero(beyond)) {
            const double local = local_start + *t * (1 - local_start);
            return breaks_[i] + local * (breaks_[i + 1] - breaks_[i]);
        }
        local_start = 0;
    }
    return std::nullopt;
}

}  // namespace endmill
