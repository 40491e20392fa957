// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/visibility.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/visibility/detail/cylinder_contact.h"
#include "endmill/visibility/detail/direction_count.h"
#include "endmill/visibility/detail/facet_boxes.h"
#include "endmill/visibility/detail/part_facets.h"

namespace endmill {
namespace {

void require_sound(std::span<const ToolCylinder> body)
{
    for (const ToolCylinder& cylinder : body)
        require(
            std::isfinite(cylinder.diameter) && cylinder.diameter > 0 &&
                std::isfinite(cylinder.to) && 0 <= cylinder.from &&
                cylinder.from < cylinder.to,
            "tool visibility: a cylinder needs a diameter above 0 and 0 <= from < to");
}

// A part and the body that must not meet it.
class Hindrance {
public:
    Hindrance(const TriangleMesh& part, std::span<const ToolCylinder> body)
        : part_{part},
          boxes_{part},
          centroids_{part_facets(part).centroids},
          body_{body.begin(), body.end()}
    {
        // The widest first: where one meets a facet, the others need not be asked.
        std::ranges::stable_sort(body_, std::greater{}, &ToolCylinder::diameter);
    }

    bool meets_at(std::size_t facet, const Vec3& direction) const
    {
        return std::ranges::any_of(body_, [&](const ToolCylinder& each) {
            return meets_any(
                {centroids_[facet], direction, each.diameter / 2, each.from, each.to});
        });
    }

    // Leaves of a column what is not hindered along its direction.
    void clear_hindered(const Vec3& direction, std::span<std::uint64_t> column) const
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

}  // namespace

void keep_reachable(PartVisibility& visibility, const TriangleMesh& part,
                    std::span<const Vec3> directions, std::span<const ToolCylinder> body,
                    const std::function<void(std::size_t done)>& progress)
{
    require(visibility.map.facets() == part.triangles().size() &&
                visibility.map.cells() == directions.size(),
            "tool visibility: the map is not of this part and these directions");
    require_unit_directions(directions);
    require_sound(body);
    const Hindrance hindrance{part, body};
    DirectionCount done{progress};
    parallel_for(directions.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t cell = begin; cell < end; ++cell) {
            hindrance.clear_hindered(directions[cell], visibility.map.column(cell));
            done.one_more();
        }
    });
}

}  // namespace endmill
