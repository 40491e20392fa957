// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/visibility.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/tolerance.h"
#include "endmill/visibility/detail/border_walls.h"
#include "endmill/visibility/detail/cylinder_contact.h"
#include "endmill/visibility/detail/direction_count.h"
#include "endmill/visibility/detail/facet_boxes.h"
#include "endmill/visibility/detail/facet_groups.h"
#include "endmill/visibility/detail/part_facets.h"
#include "endmill/visibility/detail/ray_blocking.h"
#include "endmill/visibility/detail/shadow_raster.h"

namespace endmill {
namespace {

// Largest number of words of a map, 2^45 bytes. A larger map is refused before memory is
// requested.
constexpr std::size_t most_words = std::size_t{1} << 42;

double limit_of(Angle incidence)
{
    require(0 < incidence.radians() && incidence.radians() <= std::numbers::pi / 2,
            "visibility: need 0 < incidence <= 90 degrees");
    return std::max(std::cos(incidence.radians()), least_facing_cosine);
}

// Sets the bits of the facets whose incidence is within the limit.
void mark_facing(const PartFacets& facets, const Vec3& direction, double least,
                 std::span<std::uint64_t> column)
{
    const std::vector<Vec3>& normals = facets.normals;
    for (std::size_t word = 0; word < column.size(); ++word) {
        const std::size_t end = std::min<std::size_t>(64, normals.size() - 64 * word);
        std::uint64_t bits = 0;
        for (std::size_t k = 0; k < end; ++k) {
            const bool faces = normals[64 * word + k].dot(direction) > least;
            bits |= std::uint64_t{faces} << k;
        }
        column[word] = bits;
    }
}

// The rasters that no thread uses at the moment. A raster keeps memory between
// directions.
class SpareRasters {
public:
    SpareRasters(const TriangleMesh& part, const PartFacets& facets)
        : part_{part},
          facets_{facets},
          groups_{facet_groups(part, facets)},
          walls_{part}
    {
    }

    std::unique_ptr<ShadowRaster> take()
    {
        const std::lock_guard lock{mutex_};
        if (spare_.empty())
            return std::make_unique<ShadowRaster>(part_, facets_, groups_, walls_);
        std::unique_ptr<ShadowRaster> raster = std::move(spare_.back());
        spare_.pop_back();
        return raster;
    }

    void give_back(std::unique_ptr<ShadowRaster> raster)
    {
        const std::lock_guard lock{mutex_};
        spare_.push_back(std::move(raster));
    }

private:
    const TriangleMesh& part_;
    const PartFacets& facets_;
    FacetGroups groups_;
    BorderWalls walls_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<ShadowRaster>> spare_;
};

void require_valid(std::span<const ToolCylinder> body)
{
    for (const ToolCylinder& cylinder : body)
        require(
            std::isfinite(cylinder.diameter) && cylinder.diameter > 0 &&
                std::isfinite(cylinder.to) && 0 <= cylinder.from &&
                cylinder.from < cylinder.to,
            "tool visibility: a cylinder needs a diameter above 0 and 0 <= from < to");
}

// A part and the body of a tool that must not meet it.
class BodyClearance {
public:
    BodyClearance(const TriangleMesh& part, std::span<const ToolCylinder> body)
        : part_{part},
          boxes_{part},
          centroids_{part_facets(part).centroids},
          body_{body.begin(), body.end()}
    {
        // The widest cylinder is the most likely to meet a facet, so that it is tested
        // first.
        std::ranges::stable_sort(body_, std::greater{}, &ToolCylinder::diameter);
    }

    bool meets_at(std::size_t facet, const Vec3& direction) const
    {
        return std::ranges::any_of(body_, [&](const ToolCylinder& each) {
            return meets_any(
                {centroids_[facet], direction, each.diameter / 2, each.from, each.to});
        });
    }

    // Clears the bits of the facets at which the body meets the part along `direction`.
    void clear_blocked(const Vec3& direction, std::span<std::uint64_t> column) const
    {
        for (std::size_t word = 0; word < column.size(); ++word)
            for (std::uint64_t rest = column[word]; rest != 0; rest &= rest - 1) {
                const auto bit = static_cast<unsigned>(std::countr_zero(rest));
                if (meets_at(64 * word + bit, direction))
                    column[word] &= ~(std::uint64_t{1} << bit);
            }
    }

private:
    bool meets_any(const SolidCylinder& cylinder) const
    {
        return boxes_.any(
            [&](const Vec3& low, const Vec3& high) {
                return may_meet(cylinder, low, high);
            },
            [&](std::size_t facet) { return meets(cylinder, part_.corners(facet)); });
    }

    const TriangleMesh& part_;
    FacetBoxes boxes_;
    std::vector<Vec3> centroids_;
    std::vector<ToolCylinder> body_;
};

// The corners of a facet in mm.
std::array<Vec3, 3> corners_of(const TriangleMesh& part, std::size_t facet)
{
    const Triangle& triangle = part.triangles()[facet];
    return {part.points()[triangle[0]], part.points()[triangle[1]],
            part.points()[triangle[2]]};
}

}  // namespace

VisibilityMap::VisibilityMap(std::size_t facets, std::size_t cells)
    : facets_{facets},
      cells_{cells},
      words_{facets / 64 + (facets % 64 != 0 ? 1 : 0)}
{
    const LimitError no_memory{"visibility map: no memory for its bits"};
    if (words_ > 0 && cells_ > most_words / words_)
        throw LimitError{no_memory};
    try {
        bits_.resize(words_ * cells_);
    } catch (const std::bad_alloc&) {
        throw LimitError{no_memory};
    }
}

PartVisibility part_visibility(const TriangleMesh& part, std::span<const Vec3> directions,
                               const VisibilityOptions& options)
{
    require_unit_directions(directions);
    require(options.share.step > 0, "visibility: need a step above 0 between directions");
    const double least = limit_of(options.incidence);
    const PartFacets facets = part_facets(part);
    PartVisibility visibility{{part.triangles().size(), directions.size()},
                              facets.dropped};
    DirectionCount done{options.progress};
    const DirectionShare& share = options.share;
    const std::size_t count = share.count(directions.size());
    if (options.kind == VisibilityKind::Local) {
        parallel_for(count, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                const std::size_t cell = share.direction(k);
                mark_facing(facets, directions[cell], least, visibility.map.column(cell));
                done.one_more();
            }
        });
        return visibility;
    }
    SpareRasters rasters{part, facets};
    parallel_for(count, [&](std::size_t begin, std::size_t end) {
        std::unique_ptr<ShadowRaster> raster = rasters.take();
        for (std::size_t k = begin; k < end; ++k) {
            const std::size_t cell = share.direction(k);
            raster->mark_seen(directions[cell], least, visibility.map.column(cell));
            done.one_more();
        }
        rasters.give_back(std::move(raster));
    });
    return visibility;
}

std::vector<std::size_t> empty_cones(const PartVisibility& visibility)
{
    const VisibilityMap& map = visibility.map;
    std::vector<std::uint64_t> seen(map.words());
    for (const std::size_t facet : visibility.dropped)
        seen[facet / 64] |= std::uint64_t{1} << (facet % 64);
    for (std::size_t cell = 0; cell < map.cells(); ++cell)
        std::ranges::transform(seen, map.column(cell), seen.begin(), std::bit_or<>{});
    std::vector<std::size_t> empty;
    for (std::size_t facet = 0; facet < map.facets(); ++facet)
        if ((seen[facet / 64] >> (facet % 64) & 1) == 0)
            empty.push_back(facet);
    return empty;
}

std::optional<std::size_t> hiding_facet(const TriangleMesh& part, std::size_t facet,
                                        const Vec3& direction)
{
    require(facet < part.triangles().size() && direction.squaredNorm() > 0,
            "hiding_facet: need a facet of the part and a direction");
    const std::array<Vec3, 3> from = corners_of(part, facet);
    const Vec3 centroid = (from[0] + from[1] + from[2]) / 3;
    std::optional<std::size_t> hiding;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t other = 0; other < part.triangles().size(); ++other) {
        const std::array<Vec3, 3> at = corners_of(part, other);
        const Vec3 normal = (at[1] - at[0]).cross(at[2] - at[0]);
        if (other == facet || normal.squaredNorm() == 0 ||
            !blocks_ray(from, direction, at))
            continue;
        // A facet along the ray has no single distance; its own counts as the least.
        const double rise = normal.dot(direction);
        const double distance = rise == 0 ? 0 : normal.dot(at[0] - centroid) / rise;
        if (distance < nearest) {
            nearest = distance;
            hiding = other;
        }
    }
    return hiding;
}

std::vector<double> visible_fractions(const VisibilityMap& map,
                                      std::span<const double> solid_angles_sr)
{
    require(solid_angles_sr.size() == map.cells(),
            "visible_fractions: need a solid angle for each cell");
    std::vector<double> seen(map.facets(), 0.0);
    double all = 0;
    for (std::size_t cell = 0; cell < map.cells(); ++cell) {
        all += solid_angles_sr[cell];
        const std::span column = map.column(cell);
        for (std::size_t word = 0; word < column.size(); ++word)
            for (std::uint64_t rest = column[word]; rest != 0; rest &= rest - 1)
                seen[64 * word + std::countr_zero(rest)] += solid_angles_sr[cell];
    }
    for (double& share : seen)
        share /= all;
    return seen;
}

void keep_reachable(PartVisibility& visibility, const TriangleMesh& part,
                    std::span<const Vec3> directions, std::span<const ToolCylinder> body,
                    const std::function<void(std::size_t done)>& progress)
{
    require(visibility.map.facets() == part.triangles().size() &&
                visibility.map.cells() == directions.size(),
            "tool visibility: the map is not of this part and these directions");
    require_unit_directions(directions);
    require_valid(body);
    const BodyClearance clearance{part, body};
    DirectionCount done{progress};
    parallel_for(directions.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t cell = begin; cell < end; ++cell) {
            clearance.clear_blocked(directions[cell], visibility.map.column(cell));
            done.one_more();
        }
    });
}

}  // namespace endmill
