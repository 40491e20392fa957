// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/triangle_mesh.h"

#include <atomic>
#include <limits>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"

namespace endmill {
namespace {

// Whether `holds` is true for all items. There may be millions, so the test uses all
// threads. It does not stop at the first failure, which lets the compiler test several
// items at once.
template <typename Items, typename Predicate>
bool all_hold(const Items& items, const Predicate& holds)
{
    std::atomic<bool> do_all{true};
    parallel_for(items.size(), [&](std::size_t begin, std::size_t end) {
        bool is_all = true;
        for (std::size_t k = begin; k < end; ++k)
            is_all &= holds(items[k]);
        if (!is_all)
            do_all = false;
    });
    return do_all;
}

}  // namespace

TriangleMesh::TriangleMesh(std::vector<Vec3> points, std::vector<Triangle> triangles)
    : points_{std::move(points)},
      triangles_{std::move(triangles)}
{
    constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
    require(points_.size() <= most && triangles_.size() <= most,
            "TriangleMesh: at most 2^31 - 1 points and triangles");
    require(all_hold(points_, [](const Vec3& point) { return point.allFinite(); }),
            "TriangleMesh: points must be finite");
    const auto count = static_cast<std::uint32_t>(points_.size());
    // a negative number becomes a large one
    const auto exists = [count](std::int32_t number) -> unsigned {
        return static_cast<std::uint32_t>(number) < count ? 1 : 0;
    };
    require(all_hold(triangles_,
                     [exists](const Triangle& corners) {
                         return (exists(corners[0]) & exists(corners[1]) &
                                 exists(corners[2])) != 0;
                     }),
            "TriangleMesh: a triangle names a point that does not exist");
}

}  // namespace endmill
