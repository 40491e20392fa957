// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/path/tool_path.h"
#include "endmill/process/detail/contact_search.h"
#include "endmill/process/detail/cut_moves.h"

namespace endmill {

/// Contact of the ball with the part at the middle of a move.
struct MoveContact {
    Vec3 normal;  ///< unit normal of the part, towards the ball centre
    std::optional<BallFoot> foot = {};  ///< foot of the ball centre, if the part is given
};

/// Contact without a part: the normalised sum of the normals that `path` states at the two
/// ends of `move`, or std::nullopt where a normal is missing.
std::optional<MoveContact> stated_contact(const ToolPath& path, const CutMove& move);

/// A ball and the tolerance of its contact with the part.
struct BallOnPart {
    double radius;     ///< mm
    double tolerance;  ///< mm, by which the ball may miss the part
};

/// Checks that the contacts stated in `path` belong to this ball.
/// \throws GeometryError if the distance between a stated contact at an end of a move and
///         the ball centre differs from the radius by more than the tolerance; the
///         message names the first such point.
void require_ball(const ToolPath& path, std::span<const CutMove> moves,
                  const BallOnPart& ball);

/// Contacts by projection on a part. The search at a point starts from the contact stated
/// in `path`, or else from the contact of the move before.
/// \throws GeometryError if the ball at an end of a move misses the part by more than the
///         tolerance; the message states the largest distance and its place.
/// The result does not depend on the number of threads.
std::vector<std::optional<MoveContact>> projected_contacts(const ToolPath& path,
                                                           std::span<const CutMove> moves,
                                                           const ContactSearch& part,
                                                           const BallOnPart& ball);

}  // namespace endmill
