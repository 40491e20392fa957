// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "endmill/cutter/cutter.h"
#include "endmill/deviation/deviation.h"
#include "endmill/drop_cutter/drop_cutter.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/path/tool_path.h"
#include "endmill/surface/part.h"

namespace endmill {

/// The mesh of a part.
struct ProtectedMesh {
    std::shared_ptr<const TriangleMesh> mesh;  ///< not null
    double chord_error;  ///< greatest distance of the part from the mesh, mm
};

/// A part that a ball along +z must not enter while it cuts another part, such as a wall
/// beside it. The shank above the ball is part of the tool. An immutable value; all threads
/// may use it.
///
/// Surfaces are replaced by a mesh that is nowhere farther from them than a tenth of the
/// tolerance, and the ball is larger by as much. Contacts keep a quarter of the tolerance
/// from the mesh. Moves may come nearer, but do not enter it, so that the chords of moves
/// have room.
/// Source: docs/methods/iso-scallop.md, section 8.
class ProtectedPart {
public:
    /// \param part      the part; it must outlive this object.
    /// \param cutter    the ball, radius R.
    /// \param tolerance greatest depth of a gouge in mm, above 0 and below R.
    /// \throws DomainError if the tolerance is out of range.
    /// \throws LimitError if a mesh of the surfaces would need more than ten million
    ///         triangles.
    ProtectedPart(const Part& part, const BallCutter& cutter, double tolerance);

    /// Whether a ball with this centre, in mm, keeps its distance.
    bool is_clear(const Vec3& centre) const;

    /// Whether a straight move of the centre is proved not to enter the part.
    /// \param from, to centres, mm.
    bool is_clear(const Vec3& from, const Vec3& to) const;

    /// Whether the ball can come within `distance` mm of a place of the other part: whether
    /// it keeps its distance where it would touch the place, moved away by `distance` along
    /// the normal.
    bool is_accessible(const CutterContact& place, double distance) const;

    /// The contact, moved along its normal just so far that the ball keeps its distance. It
    /// stays where it is if more than `most` mm would be needed.
    CutterContact held_off(const CutterContact& contact, double most) const;

    /// Greatest height of the part, mm.
    double highest() const { return high_.z(); }

    /// Checks that no move of a path enters the part.
    /// \param path tips along +z.
    /// \throws GeometryError with the place of the first move that does.
    void require_clear(const ToolPath& path) const;

    /// Gouges of the part by a path. Remaining stock is not judged: it has no limit. Surfaces
    /// with places that do not face the tool are judged by their mesh, whose chord error is
    /// added to the depth.
    Deviation deviation(const ToolPath& path) const;

    /// The verdict on a path by both parts.
    /// \param deviation of this part, as above.
    /// \param of_other  the verdict on the path by the part that it cuts.
    Verdict verdict(const Deviation& deviation, Verdict of_other) const;

    const BallCutter& cutter() const { return cutter_; }  ///< the ball

private:
    ProtectedPart(const Part& part, const BallCutter& cutter, double tolerance,
                  ProtectedMesh mesh);
    bool is_clear(const Vec3& from, const Vec3& to, double rise) const;
    double depth(const Vec3& centre) const;
    bool faces_tool() const;

    const Part* part_;
    BallCutter cutter_;
    double tolerance_;
    ProtectedMesh mesh_;
    Vec3 low_;          // of the mesh, mm
    Vec3 high_;         // of the mesh, mm
    DropCutter seat_;   // a ball that contacts keep off the mesh
    DropCutter moved_;  // a smaller one that moves keep off it
};

}  // namespace endmill
