// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/visibility.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <mutex>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/visibility/detail/direction_count.h"
#include "endmill/visibility/detail/facet_groups.h"
#include "endmill/visibility/detail/part_facets.h"
#include "endmill/visibility/detail/shadow_raster.h"

namespace endmill {
namespace {

// The paper's incidence of 90 degrees is open; nearer than this, in the cosine, a facet
// counts as seen from its edge.
constexpr double least_cosine = 1e-6;

double limit_of(Angle incidence)
{
    require(0 < incidence.radians() && incidence.radians() <= std::numbers::pi / 2,
            "visibility: need 0 < incidence <= 90 degrees");
    return std::max(std::cos(incidence.radians()), least_cosine);
}

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

// Rasters that no thread uses at the moment.
class SpareRasters {
public:
    SpareRasters(const TriangleMesh& part, const FacetGroups& groups)
        : part_{part},
          groups_{groups}
    {
    }

    std::unique_ptr<ShadowRaster> take()
    {
        const std::lock_guard lock{mutex_};
        if (spare_.empty())
            return std::make_unique<ShadowRaster>(part_, groups_);
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
    const FacetGroups& groups_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<ShadowRaster>> spare_;
};

}  // namespace

PartVisibility part_visibility(const TriangleMesh& part, std::span<const Vec3> directions,
                               const VisibilityOptions& options)
{
    require_unit_directions(directions);
    const double least = limit_of(options.incidence);
    const PartFacets facets = part_facets(part);
    PartVisibility visibility{{part.triangles().size(), directions.size()},
                              facets.dropped};
    DirectionCount done{options.progress};
    const FacetGroups groups = facet_groups(part, facets);
    SpareRasters rasters{part, groups};
    parallel_for(directions.size(), [&](std::size_t begin, std::size_t end) {
        std::unique_ptr<ShadowRaster> raster = rasters.take();
        for (std::size_t cell = begin; cell < end; ++cell) {
            const std::span column = visibility.map.column(cell);
            mark_facing(facets, directions[cell], least, column);
            if (options.kind == VisibilityKind::Global)
                raster->clear_blocked(directions[cell], column);
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

}  // namespace endmill
