// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "endmill/deviation/detail/half_space.h"
#include "endmill/deviation/part_charts.h"
#include "endmill/stock/detail/tool_pieces.h"

namespace endmill {

/// Bounds of the signed thickness of the material on one measuring ray, for moves with a
/// turning axis. The thickness is the smallest t at which the ray's line is inside the
/// cutter at some pose, over all poses whose line inside the cutter reaches t >= 0. A
/// volume that ends below the part's surface has removed material on another side of the
/// part.
struct BoundedRay {
    double low = 0;                    ///< mm, the thickness is not less
    double high = 0;                   ///< mm, the thickness is not more
    const ToolPiece* piece = nullptr;  ///< that leaves at most `high`; null: the stock
    double slope = 0;  ///< tangent of the angle between the cutter there and the part
};

/// Lowers the bounds of a ray by a piece of a motion. Where the bounds of the piece are
/// farther apart than `sharpness`, the piece is halved.
///
/// Seen from the tool, a place of the part moves on a curve. Let F be the least signed
/// distance on the straight line between its ends, and e the error of that line. Where F
/// <= -e the place is removed for certain, where F > e it is not. F is followed along the
/// ray by Newton steps that cannot pass a place with F <= e.
/// Source: docs/methods/five-axis-removal.md, sections 2 and 3.
/// \param sharpness in mm, above 0.
void cut(BoundedRay& bounded, const PartRay& ray, const ToolPiece& piece,
         double sharpness);

/// A place near a piece of a motion.
struct PieceDistance {
    double lower;  ///< mm, lower bound of the signed distance from the swept volume
    double at;     ///< parameter u of the pose that comes nearest
    /// Direction out of the cutter, seen from the tool, of at most unit length. At a place
    /// that is v away, the distance is at least lower + out . v, less `slack` times |v|.
    Vec3 out;
    double slack;  ///< for the turn of the motion
};

/// Returns the distance of a place from what a piece sweeps.
/// \param enough mm; above it, any lower bound that exceeds it may be returned.
PieceDistance distance_from(const ToolPiece& piece, const Vec3& place, double enough);

/// Returns `v`, a vector in the part, as seen from the tool at the pose of a distance.
Vec3 seen_from(const ToolPiece& piece, const PieceDistance& distance, const Vec3& v);

/// Neighbouring rays: they start within `reach` mm of a place, at most `sag` mm beside the
/// plane through it, and are at most `length` mm long. Their directions differ from the
/// plane's normal by at most `tilt`.
struct RayDisc {
    Vec3 centre;    ///< mm
    Vec3 normal;    ///< unit
    double reach;   ///< mm
    double length;  ///< mm
    double sag;     ///< mm
    double tilt;    ///< length of the difference of unit vectors
};

/// Whether a piece may remove a place of one of the rays.
bool may_reach(const ToolPiece& piece, const RayDisc& rays);

/// Returns an upper bound of the thickness that a piece leaves on a ray; at least 0. The
/// piece is not halved.
///
/// If `near` mm bound the distances between the rays of several calls, at their ends too,
/// then everything between these ends is removed as well: the removed places form a convex
/// set but for the turn of the motion.
/// Source: docs/methods/five-axis-removal.md, section 4.
/// \return nothing if the bound is not below `before`.
std::optional<double> thickness_by(const ToolPiece& piece, const PartRay& ray,
                                   double near, double before);

/// Returns a half space that contains all that a piece clears, with a normal close to the
/// given one. `least` is minus infinity if there is none.
/// \param normal unit.
HalfSpace half_space_of(const ToolPiece& piece, const Vec3& normal);

/// Returns the distance in mm by which the turn of a piece moves its half spaces away. A
/// half of the piece has a quarter of it.
double half_space_slack(const ToolPiece& piece);

}  // namespace endmill
