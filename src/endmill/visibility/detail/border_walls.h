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

namespace endmill {

/// Unbounded walls that close a part with open borders.
///
/// The area vector of the part, the integral of its normals, points up. A wall extends
/// down from each border edge. An edge is at the border if the numbers of its uses in the
/// two senses differ. Part and walls together bound a solid, which may overlap itself: the
/// number of times that it contains a point is well defined, and is 0 at infinity in every
/// direction except down.
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

    /// The number of times that a ray leaves the solid through walls, less the times that
    /// it enters through them; nothing if that is uncertain.
    /// \param place start of the ray, projected.
    std::optional<int> exits(const Eigen::Vector3f& place) const;

    /// The number that `exits` has for all rays that start in a box; nothing if it is
    /// uncertain or not the same for all.
    /// \param box projected.
    std::optional<int> exits(const ProjectedBox& box) const;

private:
    struct Edge {
        std::array<Vec3, 2> ends;  // mm
        int uses;                  // from the first end to the second, less the opposite
    };

    // A wall in a frame across and along all walls. Its points have the same depth all the
    // way down. A ray meets the wall if it starts between the ends, farther along, and at
    // a smaller depth.
    struct Wall {
        std::array<Eigen::Vector3d, 2> ends;  // across, along, depth; by rising across
        int exits;                            // of a ray that meets the wall
    };

    // A wall in one of the strips into which the frame is divided across.
    struct Piece {
        std::array<float, 2> along;  // least and largest
        std::array<float, 2> depth;  // least and largest
        std::uint32_t wall;
        int exits;
        bool is_whole;  // the wall crosses the whole strip
    };

    // Where rays start: least and largest coordinates.
    struct Starts {
        std::array<float, 2> along;
        std::array<float, 2> depth;
    };

    Eigen::Vector3d seen(const Eigen::Vector3d& projected) const;
    void choose_strips();
    std::size_t strip_at(double across) const;
    Piece piece(std::uint32_t wall, std::size_t strip) const;
    std::optional<int> exits(const Piece& piece, const Starts& starts) const;
    std::optional<int> exits_at(const Wall& wall, const Eigen::Vector3d& start) const;

    std::vector<Edge> edges_;
    Vec3 up_ = Vec3::UnitZ();

    bool are_too_many_ = false;       // there are border edges without walls
    bool is_along_ = false;           // the rays run along the walls
    Eigen::Vector2d down_{0.0, 1.0};  // unit, the sense of the walls
    double slope_ = 0;                // rise of the walls towards the viewer
    double doubt_ = 0;                // error bound across and along
    double doubt_of_depth_ = 0;
    double low_ = 0;  // least place across
    double strips_per_length_ = 0;
    std::vector<Wall> walls_;
    std::vector<std::uint32_t> begin_;  // first piece of each strip, and the end
    std::vector<Piece> pieces_;         // in each strip by falling largest depth
};

}  // namespace endmill
