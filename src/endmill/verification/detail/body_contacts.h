// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"
#include "endmill/stock/detail/sweep_tree.h"
#include "endmill/stock/detail/tile_cut.h"
#include "endmill/verification/part_collisions.h"

namespace endmill {

/// What is known of one move.
struct BodyMove {
    /// mm; so deep it is in the part for certain, at `place`.
    double depth = 0;
    Vec3 place = Vec3::Zero();
    /// mm; it is no deeper. Of a move below the slack, and of one that is shallower than the
    /// deepest, only that.
    double most = std::numeric_limits<double>::infinity();

    bool is_in() const { return depth > part_contact_slack; }
};

/// The moves of a path against a part, in passes over ever finer triangles: each looks at
/// the moves that those before it left open.
class BodyMoves {
public:
    /// \param sweeps of the path, which must outlive it.
    explicit BodyMoves(std::span<const StraightSweep> sweeps);

    /// Whether a move may be in the part, or deeper than the deepest found by more than is
    /// sharp enough.
    bool has_open() const { return !open_.empty(); }

    std::vector<StraightSweep> open_sweeps() const;

    /// Move `number` of those that are open.
    const BodyMove& open(std::size_t number) const { return moves_[open_[number]]; }

    /// What of move `number` of those that are open is of no interest, in mm: not in the
    /// part, or not the deepest.
    double negligible(std::size_t number) const;

    /// How closely a depth beyond the negligible is asked for, in mm.
    double sharpness(std::size_t number) const;

    /// Counts in what was found of an open move.
    void take(std::size_t number, const BodyMove& found);

    void begin_pass();  ///< all that bounds the open moves is to be found anew
    void end_pass(
        double chord_error);  ///< leaves those open that finer triangles may tell

    /// \param first the point to which the first sweep leads.
    PartCollisions found(std::size_t first) const;

private:
    double depth_sharpness() const;

    std::span<const StraightSweep> sweeps_;
    std::vector<BodyMove> moves_;
    std::vector<std::uint32_t> open_;
    double deepest_ = 0;  // mm
};

/// Triangles and a cylinder on the open moves.
struct BodyAndMesh {
    const TriangleMesh& mesh;
    double chord_error;  ///< mm, of the part from the mesh
    BodyCylinder cylinder;
    const SweepTree& tree;  ///< of the open moves
};

/// Finds how deep the cylinder comes into the part on the open moves.
void find_contacts(const BodyAndMesh& task, BodyMoves& moves);

}  // namespace endmill
