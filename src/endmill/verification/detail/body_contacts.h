// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "endmill/core/tolerance.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/stock/detail/sweep_tree.h"
#include "endmill/stock/detail/tile_cut.h"
#include "endmill/verification/verification_result.h"

namespace endmill {

/// Bounds on the contact depth of one move.
struct BodyMove {
    double depth = 0;           ///< mm; the body is at least this deep in the part
    Vec3 place = Vec3::Zero();  ///< mm; where it is that deep
    /// Upper bound of the depth in mm. Moves below the slack and moves that are shallower
    /// than the deepest one get no closer bound than that.
    double most = std::numeric_limits<double>::infinity();

    /// Whether the body is in the part for certain.
    bool is_in() const { return depth > part_contact_slack; }
};

/// The moves of a path while they are tested against a part in passes over ever finer
/// triangles. Each pass tests the moves that the passes before left open.
class BodyMoves {
public:
    /// \param sweeps of the path; they must outlive the object.
    explicit BodyMoves(std::span<const StraightSweep> sweeps);

    /// Whether a move is left that may be in the part, or whose depth may exceed the
    /// greatest depth found by more than the accuracy asked for.
    bool has_open() const { return !open_.empty(); }

    /// The sweeps of the open moves.
    std::vector<StraightSweep> open_sweeps() const;

    /// The open move with this number among the open moves.
    const BodyMove& open(std::size_t number) const { return moves_[open_[number]]; }

    /// Depth in mm up to which a contact of an open move does not matter: the slack, or
    /// for a move that is in the part the greatest depth found.
    double negligible(std::size_t number) const;

    /// Accuracy in mm that a depth beyond the negligible one needs.
    double sharpness(std::size_t number) const;

    /// Merges the bounds that were found for an open move.
    void take(std::size_t number, const BodyMove& found);

    /// Starts a pass: discards the upper bounds of the open moves.
    void begin_pass();

    /// Ends a pass: closes the moves that finer triangles cannot change.
    /// \param chord_error distance of the part from the triangles of the pass, mm.
    void end_pass(double chord_error);

    /// The contacts of all moves.
    /// \param first number of the path point to which the first sweep leads.
    PartCollisions found(std::size_t first) const;

private:
    double depth_sharpness() const;

    std::span<const StraightSweep> sweeps_;
    std::vector<BodyMove> moves_;
    std::vector<std::uint32_t> open_;  // numbers of the open moves
    double deepest_ = 0;               // greatest depth found, mm
};

/// A cylinder on the open moves and the triangles of the part.
struct BodyAndMesh {
    const TriangleMesh& mesh;
    double chord_error;  ///< distance of the part from the mesh, mm
    BodyCylinder cylinder;
    const SweepTree& tree;  ///< of the open moves
};

/// Bounds the depth of the cylinder in the part for the open moves.
/// The result is the same with any number of threads.
void find_contacts(const BodyAndMesh& task, BodyMoves& moves);

}  // namespace endmill
