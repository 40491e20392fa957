// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "endmill/core/vec.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/visibility/detail/box_heights.h"
#include "endmill/visibility/detail/point_cells.h"
#include "endmill/visibility/detail/wall_lanes.h"

namespace endmill {

/// Unbounded walls that close a part with open borders.
///
/// The area vector of the part, the integral of its normals, points up. A wall extends
/// down from each border edge. An edge is at the border if the numbers of its uses in the
/// two senses differ; it has as many walls as they differ by. Part and walls together bound
/// a solid, which may overlap itself: the number of times that it contains a point is well
/// defined, and is 0 at infinity in every direction except down.
///
/// Walls take more time than they save if there are many. With more than one border edge
/// for eight facets there are no walls, and every answer is that nothing is known.
class BorderWalls {
public:
    /// \param part facets in mm.
    explicit BorderWalls(const TriangleMesh& part);

    /// Number of walls: 0 for a closed part whose facets are oriented alike, and for a
    /// part with too many border edges.
    std::size_t count() const { return edges_.size(); }

    /// Prepares the walls for rays along one direction.
    /// \param rows scaled rotation; its third row is the direction. \param centre mm, is
    ///        projected to 0. All projected coordinates are within [-1, 1].
    /// \param accuracy error bound of the projected coordinates.
    void look_along(const Eigen::Matrix3d& rows, const Vec3& centre, double accuracy);

    /// Answers for the rays in the lanes `asked`: is the number of times that the ray leaves
    /// the solid through walls equal to the times that it enters through them?
    /// \param places starts of the rays, projected.
    ExitLanes exits(const PlaceLanes& places, unsigned asked) const;

    /// The number of times that each ray from a box leaves the solid through walls, less
    /// the times that it enters through them; nothing if it is uncertain or not the same
    /// for all. \param box in the frame of the walls.
    std::optional<int> exits(const ProjectedBox& box) const;

    /// Maps projected coordinates to the frame of the walls.
    const Eigen::Matrix3d& frame() const { return frame_; }

private:
    // The ends are numbers of points in the order of the uses of the edge.
    struct Edge {
        std::array<std::uint32_t, 2> ends;
    };

    // A wall in its frame.
    struct Wall {
        std::array<Eigen::Vector3f, 2> ends;  // by rising across
        bool is_left;                         // by a ray that meets the wall
    };

    Wall wall(const Edge& edge) const;
    void project(const Eigen::Matrix3d& rows, const Vec3& centre);
    void choose_strips();
    void put(const Wall& wall, WallLanes& lanes, std::size_t lane) const;
    WallStrips strips() const
    {
        return {begin_, blocks_, low_, strips_per_length_, doubt_};
    }

    std::vector<Vec3> points_;  // mm, of the border
    std::vector<Edge> edges_;
    Vec3 up_ = Vec3::UnitZ();

    bool are_too_many_ = false;  // there are border edges without walls
    bool is_along_ = false;      // the rays run along the walls
    Eigen::Matrix3d frame_ = Eigen::Matrix3d::Identity();
    float doubt_ = 0;           // error bound across and along
    float doubt_of_depth_ = 0;  // error bound of the depth
    float low_ = 0;             // least place across
    float strips_per_length_ = 0;
    std::vector<Eigen::Vector3f> ends_;  // `points_` in the frame
    std::vector<Wall> walls_;
    std::vector<std::uint32_t> begin_;  // first block of each strip, and the end
    std::vector<std::uint32_t> count_;  // number of walls in each strip
    std::vector<WallLanes> blocks_;
};

}  // namespace endmill
