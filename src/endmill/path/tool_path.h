// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"
#include "endmill/machine/kinematics.h"

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

/// What is known of the contact of the cutter at a point of a path: nothing, the unit
/// normal of the part there, or the whole contact.
using KnownContact = std::variant<std::monostate, Vec3, SurfaceContact>;

/// The settings of the machine on the move to a point. A setting that is not given is
/// unknown.
struct CuttingConditions {
    std::optional<double> feed_mm_per_min = {};  ///< speed of the tip along the path
    std::optional<double> spindle_rpm = {};      ///< speed of the spindle
    std::optional<int> tool = {};                ///< number of the tool

    /// Whether both have the same settings.
    friend bool operator==(const CuttingConditions&, const CuttingConditions&) = default;
};

/// A point of a tool path, with the move that leads to it.
struct PathPoint {
    int pass;   ///< number of the pass, from 0
    int point;  ///< number of the point in its pass, from 0
    Move move;  ///< the move that leads here
    /// For a part of several surfaces: number of the surface of this pass, from 0.
    int patch = 0;
    CutterLocation location;            ///< tip and axis
    KnownContact known_contact = {};    ///< where the cutter touches the part
    CuttingConditions conditions = {};  ///< settings for the move that leads here

    /// Returns the contact of the cutter with the surface; null if the cutter is clear of
    /// the part, or if the contact is not known completely.
    const SurfaceContact* contact() const
    {
        return std::get_if<SurfaceContact>(&known_contact);
    }

    /// Returns the unit normal of the part at the contact; null if it is unknown.
    const Vec3* normal() const
    {
        if (const SurfaceContact* whole = contact())
            return &whole->contact.normal;
        return std::get_if<Vec3>(&known_contact);
    }
};

/// The machine that moves along a path, and its positions.
struct MachineMotion {
    Interpolation interpolation = Interpolation::Joint;  ///< Tcp or Joint
    PartOnMachine setup = {};                            ///< with the tool of the path
    /// One for each point of the path, unwrapped: the rotary axes turn from one position to
    /// the next without adding or leaving out full rotations.
    std::vector<AxisPositions> positions = {};
};

/// A tool path: points in the order in which the cutter reaches them. Without a machine
/// the tool moves by Interpolation::Linear, which with a constant axis is a straight line.
struct ToolPath {
    std::vector<PathPoint> points;              ///< in order
    std::optional<MachineMotion> machine = {};  ///< the machine that interpolates

    /// How the tool moves from point to point.
    Interpolation interpolation() const
    {
        return machine ? machine->interpolation : Interpolation::Linear;
    }
};

/// A box along the coordinate axes that holds all tips of a path.
struct TipBox {
    Vec3 low;   ///< mm
    Vec3 high;  ///< mm
};

/// Lengths, time, tools and extent of a path, measured along the tip. The four lengths
/// add up to the length of the path.
struct PathTotals {
    double cut_mm = 0;     ///< mm, of cuts
    double plunge_mm = 0;  ///< mm, of plunges
    double link_mm = 0;    ///< mm, of links and retracts
    double rapid_mm = 0;   ///< mm, of rapids
    /// min, of all moves but the rapids, whose rate is not part of a path. Nothing if one
    /// of these moves has no feed, or if there are none.
    std::optional<double> time_min = {};
    double plunge_time_min = 0;         ///< min, of the plunges that have a feed
    std::vector<int> tools = {};        ///< numbers of the tools, ascending, each once
    std::optional<TipBox> extent = {};  ///< nothing for a path without points
};

/// Adds up the totals of a path move by move.
class PathTotalsSum {
public:
    /// Adds the start of the path, to which no move leads.
    void start(const Vec3& tip, std::optional<int> tool);

    /// Adds a move to `tip` whose length along the tip is `length_mm`. A move of length 0
    /// needs no feed.
    void add(Move move, const Vec3& tip, const CuttingConditions& conditions,
             double length_mm);

    /// The totals so far.
    PathTotals totals() const;

private:
    PathTotals sum_;
    double minutes_ = 0;
    bool is_timed_ = true;  // whether every move that needs a feed has one
};

/// The totals of `path`. No move leads to its first point, which counts for the tools and
/// the extent only.
PathTotals path_totals(const ToolPath& path);

/// The height from which the cutter first moves down at feed. If the cutter is clear of the
/// stock there, this height is an upper bound of the top of a flat stock.
/// \return mm; nothing if the first move at feed does not lead down, or there is none.
std::optional<double> entry_height(const ToolPath& path);

}  // namespace endmill
