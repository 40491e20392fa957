// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/sheet_newton.h"

#include <cmath>

#include <Eigen/LU>

namespace endmill {
namespace {

// Newton's method squares its error; what needs more rounds does not converge.
constexpr int most_rounds = 12;
// Pivots smaller than this share of the largest: the tangents do not span the plane.
constexpr double least_pivot = 1e-9;

// Of a parameter, by which a solution at a sheet's end may lie beyond: rounding.
constexpr double end_slack = 1e-9;

bool is_on_sheet(const Eigen::Vector2d& at, const SheetStart& start)
{
    return (at.array() >= start.low.array() - end_slack).all() &&
           (at.array() <= start.high.array() + end_slack).all();
}

bool is_within(const Eigen::Vector2d& at, const SheetStart& start)
{
    return ((at - start.at).cwiseAbs().array() <= start.reach.array()).all();
}

// The step that makes the linear `residual` vanish; nothing if it is not determined.
template <int n>
std::optional<Eigen::Vector<double, n>> newton_step(
    const Eigen::Matrix<double, n, n>& slope, const Eigen::Vector<double, n>& residual)
{
    Eigen::FullPivLU<Eigen::Matrix<double, n, n>> factors{slope};
    factors.setThreshold(least_pivot);
    if (!slope.allFinite() || !residual.allFinite() || !factors.isInvertible())
        return std::nullopt;
    return Eigen::Vector<double, n>{factors.solve(-residual)};
}

}  // namespace

std::optional<double> height_on_sheet(const SheetStart& start, const DriveFrame& frame,
                                      double s, double across)
{
    Eigen::Vector2d at = start.at;
    for (int round = 0; round < most_rounds; ++round) {
        const auto found = start.sheet(at);
        if (!found)
            return std::nullopt;
        const Eigen::Vector2d residual{frame.along(found->point) - s,
                                       frame.across(found->point) - across};
        if (residual.norm() <= sheet_residual)
            return is_on_sheet(at, start) ? std::optional{found->point.z()}
                                          : std::nullopt;
        Eigen::Matrix2d slope;
        slope << frame.along(found->du), frame.along(found->dv), frame.across(found->du),
            frame.across(found->dv);
        const auto step = newton_step<2>(slope, residual);
        if (!step)
            return std::nullopt;
        at += *step;
        if (!is_within(at, start))
            return std::nullopt;
    }
    return std::nullopt;
}

std::optional<SectionPoint> crossing_of_sheets(const SheetStart& one,
                                               const SheetStart& other,
                                               const DriveFrame& frame, double across)
{
    Eigen::Vector4d at;
    at << one.at, other.at;
    for (int round = 0; round < most_rounds; ++round) {
        const auto a = one.sheet(at.head<2>());
        const auto b = other.sheet(at.tail<2>());
        if (!a || !b)
            return std::nullopt;
        Eigen::Vector4d residual;
        residual << a->point - b->point, frame.across(a->point) - across;
        Eigen::Matrix4d slope = Eigen::Matrix4d::Zero();
        slope.block<3, 1>(0, 0) = a->du;
        slope.block<3, 1>(0, 1) = a->dv;
        slope.block<3, 1>(0, 2) = -b->du;
        slope.block<3, 1>(0, 3) = -b->dv;
        slope(3, 0) = frame.across(a->du);
        slope(3, 1) = frame.across(a->dv);
        const auto step = newton_step<4>(slope, residual);
        if (!step)  // one contact twice has no determined step either
            return std::nullopt;
        if (residual.norm() <= sheet_residual) {
            if (!is_on_sheet(at.head<2>(), one) || !is_on_sheet(at.tail<2>(), other))
                return std::nullopt;
            return SectionPoint{frame.along(a->point), a->point.z()};
        }
        at += *step;
        if (!is_within(at.head<2>(), one) || !is_within(at.tail<2>(), other))
            return std::nullopt;
    }
    return std::nullopt;
}

}  // namespace endmill
