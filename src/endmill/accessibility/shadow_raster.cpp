// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/accessibility/shadow_raster.h"

#include <bit>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "endmill/accessibility/ray_blocking.h"

namespace endmill {
namespace {

// Half a unit in the last place of 1 in single precision.
constexpr float rounding = std::numeric_limits<float>::epsilon() / 2;

// A shift and the scaled rows of a rotation, in doubles.
[[gnu::always_inline]] inline Eigen::Vector3f seen(const Eigen::Matrix3d& rows,
                                                   const Vec3& offset)
{
    const Vec3 place =
        rows.col(0) * offset.x() + rows.col(1) * offset.y() + rows.col(2) * offset.z();
    return place.cast<float>();
}

void add_facet(EightShadows& shadows, std::int32_t facet,
               const std::array<const Eigen::Vector4f*, 3>& corners)
{
    shadows.facet[shadows.count] = facet;
    for (int k = 0; k < 3; ++k)
        for (int axis = 0; axis < 3; ++axis)
            shadows.corner[k][axis][shadows.count] = (*corners[k])[axis];
    ++shadows.count;
}

}  // namespace

ShadowRaster::ShadowRaster(const TriangleMesh& part, const PartFacets& facets)
    : part_{&part},
      facets_{&facets},
      centre_{Vec3::Zero()},
      scale_{1},
      accuracy_{rounding},
      corners_(part.points().size(), Eigen::Vector4f::Zero())
{
    Eigen::AlignedBox3d box;
    for (const Vec3& point : part.points())
        box.extend(point);
    if (part.points().empty())
        return;
    centre_ = box.min() / 2 + box.max() / 2;
    // A little more than half the diagonal, so that rounded coordinates stay within 1.
    const double reach = 1.000001 * (box.max() / 2 - box.min() / 2).stableNorm();
    if (!(reach > 0))
        return;
    scale_ = 1 / reach;
    const double largest =
        std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    // Half a rounding to a float, since they are below 1, and those of the doubles before: a
    // dozen at most, of the coordinates as given.
    accuracy_ = rounding / 2 + 0x1p-49 * (1 + largest / reach);
}

void ShadowRaster::look_along(const Vec3& direction)
{
    // Parts have sides along x and y: seen along rows and columns of cells, there are fewer
    // cells between them.
    Vec3 across = Vec3::UnitX() - direction.x() * direction;
    if (across.squaredNorm() < 0.1)
        across = Vec3::UnitY() - direction.y() * direction;
    across.normalize();
    rows_.row(0) = scale_ * across;
    rows_.row(1) = scale_ * direction.cross(across);
    rows_.row(2) = scale_ * direction;
    const std::span points = part_->points();
    for (std::size_t k = 0; k < points.size(); ++k)
        corners_[k].head<3>() = seen(rows_, points[k] - centre_);
}

void ShadowRaster::gather(std::span<const std::uint64_t> column)
{
    points_.clear();
    for (std::size_t word = 0; word < column.size(); ++word)
        for (std::uint64_t rest = column[word]; rest != 0; rest &= rest - 1) {
            const std::size_t facet = 64 * word + std::countr_zero(rest);
            points_.push_back({seen(rows_, facets_->centroids[facet] - centre_),
                               static_cast<std::int32_t>(facet)});
        }
    cells_.sort(points_);
    darkness_.is_dark.assign(cells_.points(), 0);
}

void ShadowRaster::clear_blocked(const Vec3& direction, std::span<std::uint64_t> column)
{
    look_along(direction);
    gather(column);
    if (cells_.points() == 0)
        return;
    EightShadows shadows;
    const auto work = [&] {
        prepare_shadows(shadows, cells_, static_cast<float>(accuracy_));
        darken(shadows, cells_, darkness_);
        decide(direction);
        shadows.count = 0;
    };
    const std::span triangles = part_->triangles();
    for (std::size_t facet = 0; facet < triangles.size(); ++facet) {
        if (!facets_->has_area(facet))
            continue;
        const auto& [a, b, c] = triangles[facet];
        add_facet(shadows, static_cast<std::int32_t>(facet),
                  {&corners_[a], &corners_[b], &corners_[c]});
        if (shadows.count == wide_lanes)
            work();
    }
    work();
    clear_dark(column);
}

void ShadowRaster::decide(const Vec3& direction)
{
    for (const ShadowDoubt& doubt : darkness_.doubts) {
        std::uint8_t& is_dark = darkness_.is_dark[doubt.place];
        if (is_dark == 0 && blocks_ray(part_->corners(cells_.number_at(doubt.place)),
                                       direction, part_->corners(doubt.facet)))
            is_dark = 1;
    }
    darkness_.doubts.clear();
}

void ShadowRaster::clear_dark(std::span<std::uint64_t> column) const
{
    for (std::size_t place = 0; place < darkness_.is_dark.size(); ++place) {
        const auto facet = static_cast<std::size_t>(cells_.number_at(place));
        column[facet / 64] &= ~(std::uint64_t{darkness_.is_dark[place]} << (facet % 64));
    }
}

}  // namespace endmill
