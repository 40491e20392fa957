// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "endmill/cutter/cutter.h"

namespace endmill {

/// The kind of move that leads to a point of a path.
enum class Move {
    Cut,      ///< in the material, along a pass
    Link,     ///< at cutting feed, from the end of a pass to the start of the next
    Rapid,    ///< at rapid speed, clear of the part
    Plunge,   ///< down along the axis onto the part; every planned path begins with one
    Retract,  ///< up along the axis, clear of the part
};

/// The word for `move` in files: "cut", "link", "rapid", "plunge" or "retract".
std::string_view move_name(Move move);

/// The move with this name.
/// \return nothing if there is none.
std::optional<Move> move_from_name(std::string_view name);

/// A contact of the cutter with a parametric surface.
struct SurfaceContact {
    double u;               ///< parameter u of the contact on the surface
    double v;               ///< parameter v of the contact on the surface
    CutterContact contact;  ///< point and normal
};

/// A point of a tool path, with the move that leads to it.
struct PathPoint {
    int pass;                 ///< number of the pass, from 0
    int point;                ///< number of the point in its pass, from 0
    Move move;                ///< the move that leads here
    CutterLocation location;  ///< tip and axis
    /// Place where the cutter touches the surface. Empty if it is clear of the part, or
    /// if only the tip is known.
    std::optional<SurfaceContact> contact;
    /// For a part of several surfaces: number of the surface of this pass, from 0.
    int patch = 0;
};

/// The settings of the machine on the move to a point. A setting that is not given is
/// unknown.
struct CuttingConditions {
    std::optional<double> feed_mm_per_min;  ///< speed of the tip along the path
    std::optional<double> spindle_rpm;      ///< speed of the spindle
    std::optional<int> tool;                ///< number of the tool

    /// Whether both have the same settings.
    friend bool operator==(const CuttingConditions&, const CuttingConditions&) = default;
};

/// A tool path: points in the order in which the cutter reaches them. Between points the
/// tip moves on a straight line. `conditions` and `normals` are either empty or have one
/// entry for each point.
struct ToolPath {
    std::vector<PathPoint> points;  ///< in order
    /// Settings for the move to each point; empty if no setting is known.
    std::vector<CuttingConditions> conditions = {};
    /// Unit normal of the part at each contact, for paths without other contact data. A
    /// normal is zero where it is unknown. Empty if all are unknown.
    std::vector<Vec3> normals = {};

    /// Unit normal of the part where the cutter touches it at points[i].
    /// \return nothing if it is unknown.
    std::optional<Vec3> normal(std::size_t i) const
    {
        if (points[i].contact)
            return points[i].contact->contact.normal;
        if (normals.empty() || normals[i] == Vec3::Zero())
            return std::nullopt;
        return normals[i];
    }
};

/// Lengths of a path, measured along the tip.
struct PathLengths {
    double at_feed_mm = 0;  ///< mm, of cuts and links
    double lifted_mm = 0;   ///< mm, of rapids, retracts and plunges
};

/// The lengths of the moves of `path`. No move leads to its first point.
PathLengths path_lengths(const ToolPath& path);

}  // namespace endmill
