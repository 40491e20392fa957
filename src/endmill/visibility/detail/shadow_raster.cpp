// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/shadow_raster.h"

#include <bit>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "endmill/visibility/detail/ray_blocking.h"

namespace endmill {
namespace {

// Half a unit in the last place of 1 in single precision.
constexpr float float_roundoff = std::numeric_limits<float>::epsilon() / 2;

// Squared sine of the angle between a direction and the x axis below which the y axis is
// projected to the first coordinate instead.
constexpr double nearly_along = 0.1;

// Projects an offset in doubles and rounds it to floats.
[[gnu::always_inline]] inline Eigen::Vector3f seen(const Eigen::Matrix3d& rows,
                                                   const Vec3& offset)
{
    const Vec3 place =
        rows.col(0) * offset.x() + rows.col(1) * offset.y() + rows.col(2) * offset.z();
    return place.cast<float>();
}

}  // namespace

ShadowRaster::ShadowRaster(const TriangleMesh& part, const FacetGroups& groups)
    : part_{&part},
      groups_{&groups},
      centre_{Vec3::Zero()},
      scale_{1},
      accuracy_{float_roundoff},
      corners_(groups.points.size(), Eigen::Vector4f::Zero())
{
    Eigen::AlignedBox3d box;
    for (const Vec3& point : part.points())
        box.extend(point);
    if (part.points().empty())
        return;
    centre_ = box.min() / 2 + box.max() / 2;
    // Slightly more than half the diagonal, so that rounded coordinates stay within [-1,
    // 1].
    const double reach = 1.000001 * (box.max() / 2 - box.min() / 2).stableNorm();
    if (!(reach > 0))
        return;
    scale_ = 1 / reach;
    const double largest =
        std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    // Half a unit in the last place of a float below 1, and at most a dozen roundings of
    // doubles of the size of the given coordinates.
    accuracy_ = float_roundoff / 2 + 0x1p-49 * (1 + largest / reach);
}

void ShadowRaster::look_along(const Vec3& direction)
{
    // Many parts have edges along x and y. The projection maps one of these axes to the
    // first coordinate, so that the boxes of such facets cover fewer cells.
    const Vec3 along = direction.normalized();
    Vec3 across = Vec3::UnitX() - along.x() * along;
    if (across.squaredNorm() < nearly_along)
        across = Vec3::UnitY() - along.y() * along;
    across.normalize();
    rows_.row(0) = scale_ * across;
    rows_.row(1) = scale_ * along.cross(across);
    rows_.row(2) = scale_ * along;
    const std::vector<Vec3>& points = groups_->points;
    for (std::size_t k = 0; k < points.size(); ++k)
        corners_[k].head<3>() = seen(rows_, points[k] - centre_);
}

void ShadowRaster::gather(std::span<const std::uint64_t> column)
{
    points_.clear();
    std::size_t k = 0;
    for (const FacetGroup& group : groups_->groups)
        for (int lane = 0; lane < group.count; ++lane, ++k) {
            const std::int32_t facet = group.facet[lane];
            if ((column[facet / 64] >> (facet % 64) & 1) != 0)
                points_.push_back({seen(rows_, groups_->centroids[k] - centre_), facet});
        }
    cells_.sort(points_);
    covered_.covered_lanes.assign(cells_.blocks().size(), 0);
}

void ShadowRaster::clear_blocked(const Vec3& direction, std::span<std::uint64_t> column)
{
    look_along(direction);
    gather(column);
    if (cells_.points() == 0)
        return;
    ShadowLanes shadows;
    for (const FacetGroup& group : groups_->groups) {
        shadows.facet = group.facet;
        for (int k = 0; k < 3; ++k)
            for (int lane = 0; lane < float_lanes; ++lane) {
                const Eigen::Vector4f& corner = corners_[group.corner[k][lane]];
                for (int axis = 0; axis < 3; ++axis)
                    shadows.corner[k][axis][lane] = corner[axis];
            }
        prepare_shadows(shadows, static_cast<float>(accuracy_));
        mark_covered(shadows, cells_, covered_);
        decide(direction);
    }
    clear_covered(column);
}

void ShadowRaster::decide(const Vec3& direction)
{
    for (const UncertainCover& doubt : covered_.uncertain) {
        std::uint8_t& covered_lanes = covered_.covered_lanes[doubt.place / float_lanes];
        if (!covered_.is_covered(doubt.place) &&
            blocks_ray(part_->corners(cells_.number_at(doubt.place)), direction,
                       part_->corners(doubt.facet)))
            covered_lanes |= static_cast<std::uint8_t>(1U << doubt.place % float_lanes);
    }
    covered_.uncertain.clear();
}

void ShadowRaster::clear_covered(std::span<std::uint64_t> column) const
{
    for (std::size_t place = 0; place < cells_.points(); ++place) {
        const auto facet = static_cast<std::size_t>(cells_.number_at(place));
        column[facet / 64] &=
            ~(std::uint64_t{covered_.is_covered(place)} << (facet % 64));
    }
}

}  // namespace endmill
