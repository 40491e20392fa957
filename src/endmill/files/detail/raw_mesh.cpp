// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/raw_mesh.h"

#include <algorithm>
#include <utility>

#include "endmill/files/detail/polygon_fan.h"

namespace endmill {

RawMeshBuilder::RawMeshBuilder(const MeshSource& source, std::size_t points,
                               std::size_t faces)
    : source_{source}
{
    // Counts that a file claims are checked here, before memory is allocated for them.
    require_numbers(source, points);
    require_numbers(source, faces);
    require_memory_for(static_cast<double>(points), static_cast<double>(faces));
    points_.reserve(points);
    triangles_.reserve(faces);
}

void RawMeshBuilder::add_face(std::span<const std::int32_t> corners, FilePlace place)
{
    require_corners(corners, place);
    if (corners.size() == 3)
        add_triangle({corners[0], corners[1], corners[2]});
    else
        add_fan(corners, place);
}

RawMesh RawMeshBuilder::take()
{
    return {{std::move(points_), std::move(triangles_)}, split_faces_, out_of_plane_mm_};
}

// Checks that a face has at least three corners and no corner twice.
void RawMeshBuilder::require_corners(std::span<const std::int32_t> corners,
                                     FilePlace place)
{
    if (corners.size() < 3)
        throw complaint(source_, "E_DEGENERATE", place,
                        "a face of " + std::to_string(corners.size()) + " corner" +
                            (corners.size() == 1 ? "" : "s"),
                        "at least 3");
    // Most faces are triangles and need three comparisons; only longer faces are sorted.
    bool has_one_twice =
        corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
    if (corners.size() > 3) {
        sorted_.assign(corners.begin(), corners.end());
        std::ranges::sort(sorted_);
        has_one_twice = std::ranges::adjacent_find(sorted_) != sorted_.end();
    }
    if (has_one_twice)
        throw complaint(source_, "E_DEGENERATE", place, "a face names a point twice",
                        "different corners");
}

// Splits a face of more than three corners around the hub that `fan_corner` finds.
void RawMeshBuilder::add_fan(std::span<const std::int32_t> corners, FilePlace place)
{
    polygon_.clear();
    polygon_.reserve(corners.size());
    for (const std::int32_t corner : corners)
        polygon_.push_back(points_[corner]);
    const auto hub = fan_corner(polygon_);
    if (!hub)
        throw complaint(source_, "E_POLYGON", place,
                        "a face of " + std::to_string(corners.size()) +
                            " corners that is far from convex or crosses itself",
                        "triangles or convex faces");
    ++split_faces_;
    out_of_plane_mm_ = std::max(out_of_plane_mm_, out_of_plane(polygon_));
    // The triangles follow the order of the corners and so keep the orientation of the
    // face.
    const std::size_t count = corners.size();
    for (std::size_t i = 2; i < count; ++i)
        add_triangle({corners[*hub], corners[(*hub + i - 1) % count],
                      corners[(*hub + i) % count]});
}

// Split faces make more triangles than faces were announced. The array then grows by half
// its size, after a check of the memory limit. Doubling, as std::vector does by itself,
// could exceed the limit although the mesh fits.
void RawMeshBuilder::add_triangle(const Triangle& triangle)
{
    if (triangles_.size() == triangles_.capacity()) {
        // The old and the new array exist at the same time while the triangles are
        // copied.
        const std::size_t more = std::max<std::size_t>(1024, triangles_.size() / 2);
        require_numbers(source_, triangles_.size() + more);
        require_memory_for(static_cast<double>(points_.size()),
                           static_cast<double>(2 * triangles_.size() + more));
        triangles_.reserve(triangles_.size() + more);
    }
    triangles_.push_back(triangle);
}

// Checks the memory for the content of the file and the mesh together.
void RawMeshBuilder::require_memory_for(double points, double triangles) const
{
    require_memory(source_.file,
                   static_cast<double>(source_.content.size()) + sizeof(Vec3) * points +
                       sizeof(Triangle) * triangles,
                   source_.limits);
}

}  // namespace endmill
