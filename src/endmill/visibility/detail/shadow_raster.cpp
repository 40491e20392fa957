// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/shadow_raster.h"

#include <algorithm>
#include <array>
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

// A cosine of normal and direction above which a well-shaped facet certainly faces the
// viewer. Normals are known to 1e-7, and the products of floats round by less than 1e-6.
constexpr float least_certain_cosine = 1e-5F;
// Error bound of a cosine computed in floats.
constexpr double float_cosine_error = 1e-6;

// Projects an offset in doubles and rounds it to floats.
[[gnu::always_inline]] inline Eigen::Vector3f seen(const Eigen::Matrix3d& rows,
                                                   const Vec3& offset)
{
    const Vec3 place =
        rows.col(0) * offset.x() + rows.col(1) * offset.y() + rows.col(2) * offset.z();
    return place.cast<float>();
}

// Few points in so many cells leave most cells empty, and so most clusters without one.
constexpr std::size_t cells_a_cluster = 4;

constexpr std::size_t groups_a_cluster = FacetCluster::size / float_lanes;

// The facets of a group of a cluster.
constexpr std::uint64_t facets_of(std::size_t group)
{
    return std::uint64_t{0xFF} << (group * float_lanes);
}

// Boxes around clusters after a linear map.
class BoxProjection {
public:
    // `frame` is applied to the coordinates that `rows` projects with this accuracy.
    BoxProjection(const Eigen::Matrix3d& frame, const Eigen::Matrix3d& rows,
                  const Vec3& centre, double accuracy)
        : rows_{frame * rows},
          sizes_{rows_.cwiseAbs()},
          centre_{centre},
          margin_{accuracies * accuracy * frame.cwiseAbs().rowwise().sum()}
    {
    }

    ProjectedBox box_of(const FacetCluster& cluster) const
    {
        const Vec3 at = cluster.centre - centre_;
        const Vec3 centre =
            rows_.col(0) * at.x() + rows_.col(1) * at.y() + rows_.col(2) * at.z();
        const Vec3 half = sizes_.col(0) * cluster.half.x() +
                          sizes_.col(1) * cluster.half.y() +
                          sizes_.col(2) * cluster.half.z() + margin_;
        return {(centre - half).cast<float>(), (centre + half).cast<float>()};
    }

private:
    // The roundings of a box are at most a few accuracies.
    static constexpr double accuracies = 16;

    Eigen::Matrix3d rows_;
    Eigen::Matrix3d sizes_;
    Vec3 centre_;
    Vec3 margin_;
};

// Tests whether a facet without area is one, beyond the range of coordinates in which
// are_collinear is exact. Such a facet casts no shadow but closes the part.
bool is_certainly_collinear(const TriangleMesh& part, std::size_t facet)
{
    return std::ranges::all_of(part.corners(facet), [](const Vec3& corner) {
        const auto sizes = corner.cwiseAbs().array();
        return (sizes == 0 || (sizes >= 1e-140 && sizes <= 1e140)).all();
    });
}

}  // namespace

ShadowRaster::ShadowRaster(const TriangleMesh& part, const PartFacets& facets,
                           const FacetGroups& groups, const BorderWalls& walls)
    : part_{&part},
      facets_{&facets},
      groups_{&groups},
      walls_{walls},
      is_closed_{std::ranges::all_of(
          facets.dropped,
          [&](std::size_t facet) { return is_certainly_collinear(part, facet); })},
      centre_{Vec3::Zero()},
      scale_{1},
      accuracy_{float_roundoff},
      corners_(groups.points.size(), Eigen::Vector4f::Zero()),
      asked_(groups.clusters.size()),
      facing_(groups.clusters.size()),
      casting_(groups.clusters.size()),
      walled_(groups.clusters.size()),
      outside_(groups.clusters.size()),
      boxes_(groups.clusters.size())
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

void ShadowRaster::choose_rows(const Vec3& direction)
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
}

void ShadowRaster::project_corners()
{
    const std::vector<Vec3>& points = groups_->points;
    for (std::size_t k = 0; k < points.size(); ++k)
        corners_[k].head<3>() = seen(rows_, points[k] - centre_);
}

// Finds the facets in question, those that certainly face the viewer, and the others,
// which cast their shadows.
void ShadowRaster::find_facing(const Vec3& direction, double least)
{
    const std::array<float, 3> limits{static_cast<float>(least - float_cosine_error),
                                      static_cast<float>(least + float_cosine_error),
                                      least_certain_cosine};
    for (std::size_t cluster = 0; cluster < groups_->clusters.size(); ++cluster) {
        const FacetCluster& here = groups_->clusters[cluster];
        const std::size_t first = cluster * groups_a_cluster;
        const auto [may_be_asked, is_asked, faces] = facets_above(
            std::span{groups_->normals}.subspan(
                first, std::min(groups_a_cluster, groups_->normals.size() - first)),
            direction.cast<float>(), limits);
        facing_[cluster] = faces & here.well_shaped;
        casting_[cluster] = here.facets & ~facing_[cluster];
        asked_[cluster] = is_asked & here.facets;
        for (std::uint64_t rest = may_be_asked & ~is_asked & here.facets; rest != 0;
             rest &= rest - 1) {
            const int bit = std::countr_zero(rest);
            const std::int32_t facet =
                facet_at(static_cast<std::int32_t>(cluster * FacetCluster::size) + bit);
            if (facets_->normals[facet].dot(direction) > least)
                asked_[cluster] |= std::uint64_t{1} << bit;
        }
    }
}

void ShadowRaster::find_boxes()
{
    const BoxProjection projection{Eigen::Matrix3d::Identity(), rows_, centre_,
                                   accuracy_};
    for (std::size_t k = 0; k < boxes_.size(); ++k)
        boxes_[k] = projection.box_of(groups_->clusters[k]);
}

// Sets the bits of some facets of a cluster.
void ShadowRaster::mark(std::size_t cluster, std::uint64_t facets,
                        std::span<std::uint64_t> column) const
{
    for (; facets != 0; facets &= facets - 1) {
        const auto facet = static_cast<std::size_t>(facet_at(static_cast<std::int32_t>(
            cluster * FacetCluster::size + std::countr_zero(facets))));
        column[facet / 64] |= std::uint64_t{1} << (facet % 64);
    }
}

// Answers for whole clusters where the walls and the boxes around the casting clusters
// suffice, and removes these facets from the question.
void ShadowRaster::answer_clusters(std::span<std::uint64_t> column)
{
    heights_.reset(boxes_);
    for (std::size_t cluster = 0; cluster < boxes_.size(); ++cluster)
        if (casting_[cluster] != 0)
            heights_.add(boxes_[cluster]);
    const BoxProjection in_walls{walls_.frame(), rows_, centre_, accuracy_};
    for (std::size_t cluster = 0; cluster < boxes_.size(); ++cluster) {
        if (asked_[cluster] == 0)
            continue;
        const std::uint64_t outside =
            asked_[cluster] & outside_[cluster] & facing_[cluster];
        const std::optional<int> exits =
            is_closed_ ? walls_.exits(in_walls.box_of(groups_->clusters[cluster]))
                       : std::nullopt;
        walled_[cluster] = exits == 0 ? 0 : ~std::uint64_t{0};
        const bool is_clear =
            exits == 0 && outside != 0 && heights_.are_clear_of(boxes_[cluster]);
        if (is_clear)
            mark(cluster, outside, column);
        if (is_clear || exits.value_or(0) != 0)
            asked_[cluster] &= ~outside;
    }
}

// Collects the centroids in question, without those that are hidden because their rays
// leave the solid through walls.
void ShadowRaster::collect_points()
{
    points_.clear();
    for (std::size_t cluster = 0; cluster < asked_.size(); ++cluster)
        for (std::size_t group = 0; group < groups_a_cluster; ++group)
            if ((asked_[cluster] & facets_of(group)) != 0)
                collect_group(cluster * groups_a_cluster + group);
}

void ShadowRaster::collect_group(std::size_t group)
{
    const std::size_t cluster = group / groups_a_cluster;
    const std::size_t shift = group % groups_a_cluster * float_lanes;
    const PlaceLanes places = projected(groups_->centroids[group], rows_, centre_);
    const auto lanes_of = [&](std::uint64_t facets) {
        return static_cast<unsigned>(facets >> shift & 0xFFU);
    };
    unsigned asked = lanes_of(asked_[cluster]);
    const unsigned walled = lanes_of(asked_[cluster] & walled_[cluster]);
    if (is_closed_ && walled != 0) {
        const ExitLanes exits = walls_.exits(places, walled);
        walled_[cluster] &= ~(std::uint64_t{exits.none} << shift);
        asked &= ~(exits.some & lanes_of(outside_[cluster] & facing_[cluster]));
    }
    for (unsigned rest = asked; rest != 0; rest &= rest - 1) {
        const int lane = std::countr_zero(rest);
        points_.push_back(
            {places.place(lane), static_cast<std::int32_t>(group * float_lanes) + lane});
    }
}

void ShadowRaster::mark_seen(const Vec3& direction, double least,
                             std::span<std::uint64_t> column)
{
    choose_rows(direction);
    find_facing(direction, least);
    find_boxes();
    walls_.look_along(rows_, centre_, accuracy_);
    answer_clusters(column);
    collect_points();
    if (points_.empty())
        return;
    project_corners();
    cast_shadows(direction);
    points_.clear();
    const auto bit_of = [](std::int32_t place) {
        return std::uint64_t{1} << place % FacetCluster::size;
    };
    for_each_uncovered([&](const NumberedPoint& point) {
        const std::size_t cluster = point.number / FacetCluster::size;
        if ((outside_[cluster] & facing_[cluster] & ~walled_[cluster] &
             bit_of(point.number)) != 0)
            mark(cluster, bit_of(point.number), column);
        else
            points_.push_back(point);
    });
    if (points_.empty())
        return;
    for (std::size_t cluster = 0; cluster < casting_.size(); ++cluster)
        casting_[cluster] ^= groups_->clusters[cluster].facets;
    cast_shadows(direction);
    for_each_uncovered([&](const NumberedPoint& point) {
        const std::size_t cluster = point.number / FacetCluster::size;
        mark(cluster, bit_of(point.number), column);
        outside_[cluster] |= facing_[cluster] & ~walled_[cluster] & bit_of(point.number);
    });
}

// Finds which of `points_` the casting facets cover.
void ShadowRaster::cast_shadows(const Vec3& direction)
{
    cells_.sort(points_, cells_a_cluster * casting_.size());
    covered_.covered_lanes.assign(cells_.blocks().size(), 0);
    std::array<std::int32_t, FacetCluster::size> places;
    for (std::size_t cluster = 0; cluster < casting_.size(); ++cluster) {
        if (casting_[cluster] == 0 || !may_cover_points(boxes_[cluster]))
            continue;
        std::size_t count = 0;
        for (std::uint64_t rest = casting_[cluster]; rest != 0; rest &= rest - 1)
            places[count++] = static_cast<std::int32_t>(cluster * FacetCluster::size +
                                                        std::countr_zero(rest));
        for (std::size_t first = 0; first < count; first += float_lanes)
            cast_group(
                {&places[first], std::min<std::size_t>(float_lanes, count - first)});
        decide(direction);
    }
}

// Tests whether there are points in the box of a cluster or below it.
bool ShadowRaster::may_cover_points(const ProjectedBox& box) const
{
    const int first = cells_.column_at(box.low.x());
    const int last = cells_.column_at(box.high.x());
    const int last_row = cells_.row_at(box.high.y());
    for (int row = cells_.row_at(box.low.y()); row <= last_row; ++row)
        if (cells_.any_below(row, first, last, box.high.z()))
            return true;
    return false;
}

// Casts the shadows of up to eight facets; further lanes repeat the last one.
void ShadowRaster::cast_group(std::span<const std::int32_t> places)
{
    for (std::size_t lane = 0; lane < float_lanes; ++lane) {
        const std::int32_t place = places[std::min(lane, places.size() - 1)];
        const FacetGroup& group = groups_->groups[place / float_lanes];
        shadows_.facet[lane] = place;
        for (int k = 0; k < 3; ++k) {
            const Eigen::Vector4f& corner =
                corners_[group.corner[k][place % float_lanes]];
            for (int axis = 0; axis < 3; ++axis)
                shadows_.corner[k][axis][lane] = corner[axis];
        }
    }
    prepare_shadows(shadows_, static_cast<float>(accuracy_));
    mark_covered(shadows_, cells_, covered_);
}

void ShadowRaster::decide(const Vec3& direction)
{
    for (const UncertainCover& doubt : covered_.uncertain) {
        std::uint8_t& covered_lanes = covered_.covered_lanes[doubt.place / float_lanes];
        if (!covered_.is_covered(doubt.place) &&
            blocks_ray(part_->corners(facet_at(cells_.number_at(doubt.place))), direction,
                       part_->corners(facet_at(doubt.facet))))
            covered_lanes |= static_cast<std::uint8_t>(1U << doubt.place % float_lanes);
    }
    covered_.uncertain.clear();
}

template <typename Visit>
void ShadowRaster::for_each_uncovered(const Visit& visit) const
{
    for (std::size_t place = 0; place < cells_.points(); ++place)
        if (!covered_.is_covered(place))
            visit(cells_.point_at(place));
}

std::int32_t ShadowRaster::facet_at(std::int32_t place) const
{
    return groups_->groups[place / float_lanes].facet[place % float_lanes];
}

}  // namespace endmill
