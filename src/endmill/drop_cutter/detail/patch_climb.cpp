// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/patch_climb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "endmill/drop_cutter/detail/contact_height.h"

namespace endmill {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

// Newton's method converges quadratically. An iteration that needs more rounds creeps
// along a ridge.
constexpr int most_rounds = 100;
constexpr int most_halvings = 30;
// mm, smallest rise of a step. The height is needed to 1e-9 mm.
constexpr double least_rise = 1e-14;
// Share of the cutter's radius. A longer step might leave the hill on which it starts.
constexpr double longest_step = 0.25;
// 1/mm. Where the height has a smaller curvature, a step has its largest length.
constexpr double least_bend = 1e-9;
// Share of R^2. A point as near to the rim counts as on it.
constexpr double at_rim = 1e-10;
// Share of R. A position that is not below the cutter is moved to this distance from the
// axis.
constexpr double below_share = 0.99;
// Share of the surface's diagonal. A shorter partial counts as zero.
constexpr double least_pace = 1e-9;

// A step in mm along u and v, with its predicted rise.
struct Step {
    Vector2d by = Vector2d::Zero();
    double rise = 0;
};

// The Newton step for a given slope and curvature of the height, with the signs of the
// eigenvalues changed such that the step rises.
Step step_up(const Vector2d& slope, const Matrix2d& bend)
{
    const Eigen::SelfAdjointEigenSolver<Matrix2d> axes{bend};
    const Vector2d along = axes.eigenvectors().transpose() * slope;
    const Vector2d by =
        along.cwiseQuotient(axes.eigenvalues().cwiseAbs().cwiseMax(least_bend));
    return {axes.eigenvectors() * by, along.dot(by) / 2};
}

// The Newton step along a unit direction only.
Step step_along(const Vector2d& direction, const Vector2d& slope, const Matrix2d& bend)
{
    const double rise = slope.dot(direction);
    const double by =
        rise / std::max(std::abs(direction.dot(bend * direction)), least_bend);
    return {by * direction, rise * by / 2};
}

// For u and for v: -1 at the lower end of the patch, +1 at the upper end, otherwise 0.
Vector2d ends_at(const Vector2d& at, const Vector2d& low, const Vector2d& high)
{
    return (at.array() >= high.array()).cast<double>() -
           (at.array() <= low.array()).cast<double>();
}

// Newton's method with an active set, for the highest contact of a cutter with one patch.
// The unknowns are u and v. Constraints are the four edges of the patch and, for a flat
// cutter, its rim. In each round:
// 1. The step with the largest predicted rise is chosen among three kinds: a free Newton
//    step, a step along an active edge, and a step along the rim. Steps that leave an
//    active constraint are not allowed.
// 2. The step is limited in length and cut off at the edges of the patch.
// 3. For a flat cutter a position beyond the rim is moved back to it.
// 4. The step is halved until the height grows. The iteration ends when no step rises.
class PatchClimb {
public:
    PatchClimb(const Surface& surface, PatchNumber patch, const Cutter& cutter,
               const Vector2d& axis)
        : surface_{surface},
          patch_{patch},
          cutter_{cutter},
          axis_{axis},
          low_{surface.breaks(Parameter::U)[patch.i],
               surface.breaks(Parameter::V)[patch.j]},
          high_{surface.breaks(Parameter::U)[patch.i + 1],
                surface.breaks(Parameter::V)[patch.j + 1]}
    {
    }

    std::optional<PatchContact> from(const Vector2d& start)
    {
        at_ = start.cwiseMax(low_).cwiseMin(high_);
        const auto here = height(at_);
        if (!here)
            return std::nullopt;
        here_ = *here;
        for (int round = 0; round < most_rounds; ++round)
            if (!rises())
                break;
        return PatchContact{patch_, at_, here_.point, here_.value, slope(), beyond()};
    }

private:
    SurfaceJet jet(const Vector2d& at) const
    {
        return surface_.jet_in_patch(patch_.i, patch_.j, at.x(), at.y());
    }

    std::optional<ContactHeight> height(const Vector2d& at) const
    {
        return contact_height(jet(at), cutter_, axis_);
    }

    Vector2d ends(const Vector2d& at) const { return ends_at(at, low_, high_); }

    bool is_at_rim() const
    {
        const double R = cutter_.radius();
        return cutter_.is_flat() && here_.rim > -at_rim * R * R;
    }

    // The lengths of the partials, at least `least_pace` of the surface's diagonal.
    Vector2d pace() const
    {
        return here_.pace.cwiseMax(least_pace * surface_.diagonal());
    }

    // The allowed step with the largest predicted rise.
    Step best_step() const
    {
        const Vector2d scale = pace().cwiseInverse();
        const Vector2d slope = here_.gradient.cwiseProduct(scale);
        const Matrix2d bend = scale.asDiagonal() * here_.hessian * scale.asDiagonal();
        const Vector2d end = ends(at_);
        const Vector2d rim = here_.rim_gradient.cwiseProduct(scale).normalized();
        const bool has_rim = is_at_rim();
        const auto leads_out = [&](const Vector2d& by, bool along_rim) {
            return end.x() * by.x() > 0 || end.y() * by.y() > 0 ||
                   (has_rim && !along_rim && rim.dot(by) > 0);
        };
        Step best;
        const auto consider = [&](const Step& step, bool along_rim) {
            if (step.rise > best.rise && !leads_out(step.by, along_rim))
                best = step;
        };
        consider(step_up(slope, bend), false);
        if (end.x() != 0)
            consider(step_along(Vector2d::UnitY(), slope, bend), false);
        if (end.y() != 0)
            consider(step_along(Vector2d::UnitX(), slope, bend), false);
        if (has_rim) {
            const double push = rim_push();
            consider(step_along({-rim.y(), rim.x()}, slope,
                                bend - push * (scale.asDiagonal() * here_.rim_hessian *
                                               scale.asDiagonal())),
                     true);
        }
        return best;
    }

    // The Lagrange multiplier of the rim: the derivative of the height by half the square
    // of a flat cutter's radius.
    double rim_push() const
    {
        const Vector2d scale = pace().cwiseInverse();
        const Vector2d rim = here_.rim_gradient.cwiseProduct(scale);
        return here_.gradient.cwiseProduct(scale).dot(rim) / rim.squaredNorm();
    }

    bool rises()
    {
        Step step = best_step();
        if (!(step.rise > least_rise))
            return false;
        const double longest = longest_step * cutter_.radius();
        if (step.by.norm() > longest)
            step.by *= longest / step.by.norm();
        Vector2d by = step.by.cwiseQuotient(pace());
        for (int halving = 0; halving < most_halvings; ++halving, by /= 2)
            if (moves_to(ended(by)))
                return true;
        return false;
    }

    // The end of a step, cut off at the edges of the patch.
    Vector2d ended(const Vector2d& by) const
    {
        double share = 1;
        int first = -1;
        for (const int k : {0, 1}) {
            const double end = by[k] > 0 ? high_[k] : low_[k];
            if (by[k] != 0 && (end - at_[k]) / by[k] < share) {
                share = (end - at_[k]) / by[k];
                first = k;
            }
        }
        Vector2d to = (at_ + share * by).cwiseMax(low_).cwiseMin(high_);
        if (first >= 0)
            to[first] = by[first] > 0 ? high_[first] : low_[first];
        return to;
    }

    bool moves_to(Vector2d to)
    {
        if (cutter_.is_flat()) {
            const auto below = back_to_rim(to);
            if (!below)
                return false;
            to = *below;
        }
        const auto found = height(to);
        if (!found || !(found->value > here_.value))
            return false;
        at_ = to;
        here_ = *found;
        return true;
    }

    // A position below a flat cutter: `to` itself, or the position at which the way to it
    // is back at the rim. An active edge is kept.
    std::optional<Vector2d> back_to_rim(Vector2d to) const
    {
        const double R = cutter_.radius();
        const Vector2d scale = pace().cwiseInverse().cwiseAbs2();
        const Vector2d end = ends(at_);
        for (int round = 0; round < most_rounds; ++round) {
            const SurfaceJet there = jet(to);
            const Vector2d across = there.point.head<2>() - axis_;
            const double rim = (across.squaredNorm() - R * R) / 2;
            if (rim <= 0)
                return to;
            Vector2d out{there.du.head<2>().dot(across), there.dv.head<2>().dot(across)};
            for (const int k : {0, 1})
                if (end[k] != 0 && to[k] == at_[k])
                    out[k] = 0;
            const double length2 = out.dot(scale.cwiseProduct(out));
            if (!(length2 > 0))
                return std::nullopt;
            // A little further than the rim, so that rounding does not leave the point
            // outside.
            const double excess = rim + at_rim / 4 * R * R;
            to = (to - excess / length2 * scale.cwiseProduct(out))
                     .cwiseMax(low_)
                     .cwiseMin(high_);
        }
        return std::nullopt;
    }

    // The derivative of the height by x and y of the axis.
    Vector2d slope() const
    {
        if (!cutter_.is_flat())
            return here_.slope;
        if (!is_at_rim())
            return Vector2d::Zero();
        return edge_free_push() * (here_.point.head<2>() - axis_);
    }

    // The Lagrange multiplier of the rim where an edge of the patch is active as well.
    double edge_free_push() const
    {
        const Vector2d end = ends(at_);
        const Vector2d& rim = here_.rim_gradient;
        for (const int k : {0, 1})
            if (end[k] != 0 && rim[1 - k] != 0) {
                const double push = here_.gradient[1 - k] / rim[1 - k];
                if (end[k] * (here_.gradient[k] - push * rim[k]) > 0)
                    return std::max(push, 0.0);
            }
        return std::max(rim_push(), 0.0);
    }

    Vector2d beyond() const
    {
        Vector2d push = here_.gradient;
        if (cutter_.is_flat() && is_at_rim())
            push -= edge_free_push() * here_.rim_gradient;
        push = push.cwiseQuotient(pace());
        const Vector2d end = ends(at_);
        return (push.array() * end.array() > 0).select(push, 0);
    }

    const Surface& surface_;
    PatchNumber patch_;
    const Cutter& cutter_;
    const Vector2d& axis_;
    Vector2d low_;
    Vector2d high_;
    Vector2d at_ = Vector2d::Zero();
    ContactHeight here_{};
};

}  // namespace

std::optional<Vector2d> place_below(const Surface& surface, const Vector2d& start,
                                    const Cutter& cutter, const Vector2d& axis)
{
    const Interval u = surface.range(Parameter::U);
    const Interval v = surface.range(Parameter::V);
    const Vector2d low{u.low, v.low};
    const Vector2d high{u.high, v.high};
    Vector2d at = start.cwiseMax(low).cwiseMin(high);
    for (int round = 0; round < most_rounds; ++round) {
        const SurfaceTangents here = surface.tangents(at.x(), at.y());
        Matrix2d plan;
        plan << here.du.head<2>(), here.dv.head<2>();
        const Vector2d across = here.point.head<2>() - axis;
        const double rho = across.norm();
        if (rho < cutter.radius())
            return at;
        const Vector2d way = (below_share * cutter.radius() / rho - 1) * across;
        const Eigen::FullPivLU<Matrix2d> factors{plan};
        if (!factors.isInvertible())
            return std::nullopt;
        Vector2d by = factors.solve(way);
        const Vector2d end = ends_at(at, low, high);
        for (const int k : {0, 1})  // along the edge if the way leaves the surface
            if (end[k] * by[k] > 0) {
                by[k] = 0;
                by[1 - k] = plan.col(1 - k).dot(way) / plan.col(1 - k).squaredNorm();
            }
        const Vector2d next = (at + by).cwiseMax(low).cwiseMin(high);
        if (next == at)
            return std::nullopt;
        at = next;
    }
    return std::nullopt;
}

std::optional<PatchContact> climb(const Surface& surface, PatchNumber patch,
                                  const Vector2d& start, const Cutter& cutter,
                                  const Vector2d& axis)
{
    return PatchClimb{surface, patch, cutter, axis}.from(start);
}

}  // namespace endmill
