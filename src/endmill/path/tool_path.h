// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "endmill/cutter/cutter.h"

namespace endmill {

/// How the cutter comes to a point of its path.
enum class Move {
    Cut,      ///< in the material, along a pass
    Link,     ///< at cutting feed from the end of a pass to the start of the next
    Rapid,    ///< clear of the part
    Plunge,   ///< down along the axis onto the part; so begins every path
    Retract,  ///< up along the axis, clear of the part
};

/// The word for `move` in files: "cut", "link", "rapid", "plunge" or "retract".
std::string_view move_name(Move move);

/// The move that `name` stands for, if any.
std::optional<Move> move_from_name(std::string_view name);

/// Contact of the cutter with a parametric surface.
struct SurfaceContact {
    double u;
    double v;
    CutterContact contact;
};

/// A point of a tool path and the move that leads to it.
struct PathPoint {
    int pass;   ///< from 0
    int point;  ///< from 0 in each pass
    Move move;
    CutterLocation location;
    std::optional<SurfaceContact>
        contact;    ///< none where the cutter is clear of the part
    int patch = 0;  ///< of a part of several surfaces: whose pass this is, from 0
};

/// What the machine is told of the move to a point; none where nothing is said.
struct CuttingConditions {
    std::optional<double> feed_mm_per_min;
    std::optional<double> spindle_rpm;
    std::optional<int> tool;  ///< its number

    /// Whether both say the same.
    friend bool operator==(const CuttingConditions&, const CuttingConditions&) = default;
};

/// What the cutter does, in order. Between points the tip goes straight.
struct ToolPath {
    std::vector<PathPoint> points;
    std::vector<CuttingConditions> conditions = {};  ///< none, or one a point
    /// None, or one a point: the part's unit normal where the cutter touches it, if the path
    /// tells no more of the contact; else 0.
    std::vector<Vec3> normals = {};

    /// The part's unit normal where the cutter touches it at points[i]; none if not told.
    std::optional<Vec3> normal(std::size_t i) const
    {
        if (points[i].contact)
            return points[i].contact->contact.normal;
        if (normals.empty() || normals[i] == Vec3::Zero())
            return std::nullopt;
        return normals[i];
    }
};

/// How far the tip of a cutter goes, in mm.
struct PathLengths {
    double at_feed_mm = 0;  ///< cuts and links
    double lifted_mm = 0;   ///< rapids, retracts and plunges
};

/// The lengths of the straight moves of `path`; nothing leads to its first point.
PathLengths path_lengths(const ToolPath& path);

}  // namespace endmill
