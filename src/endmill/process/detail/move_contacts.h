// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/path/tool_path.h"
#include "endmill/process/detail/contact_search.h"
#include "endmill/process/detail/cut_moves.h"

namespace endmill {

/// The contact of the ball in the middle of a move.
struct MoveContact {
    Vec3 normal;                        ///< of the part, unit, towards the centre
    std::optional<BallFoot> foot = {};  ///< if the part is known
};

/// What is known of contacts without a part: between the normals that `path` tells of
/// both ends of a move, none where it does not.
std::vector<std::optional<MoveContact>> told_contacts(const ToolPath& path,
                                                      std::span<const CutMove> moves);

/// How far a ball may be from the part that it touches.
struct BallOnPart {
    double radius;     ///< mm
    double tolerance;  ///< mm
};

/// \throws GeometryError if a contact that `path` tells of an end of a move is not as far
///         from the ball's centre as its radius, within the tolerance: names the first.
void require_ball(const ToolPath& path, std::span<const CutMove> moves,
                  const BallOnPart& ball);

/// The contacts by projection on a part, searched from what `path` tells, or else from
/// move to move.
/// \throws GeometryError if the ball at an end of a move misses the part by more than the
///         tolerance: says by how much it does where it does most.
/// The same with any number of threads.
std::vector<std::optional<MoveContact>> projected_contacts(const ToolPath& path,
                                                           std::span<const CutMove> moves,
                                                           const ContactSearch& part,
                                                           const BallOnPart& ball);

}  // namespace endmill
