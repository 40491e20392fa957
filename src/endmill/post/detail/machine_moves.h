// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "endmill/machine/kinematics.h"
#include "endmill/path/tool_path.h"
#include "endmill/post/machine_path.h"

namespace endmill {

/// How the rotary axes turn along a move that the machine shall make.
enum class RotaryCourse {
    GreatArc,  ///< so that the tool axis turns evenly on a great arc
    Even,      ///< each axis evenly
};

/// A move that the machine shall make: the tip goes evenly on a straight line in the part.
struct IntendedMove {
    CutterLocation from;          ///< pose at the start
    CutterLocation to;            ///< pose at the end
    RotaryPositions from_rotary;  ///< rad, at the start
    RotaryPositions to_rotary;    ///< rad, at the end
    RotaryCourse course;          ///< of the axes between
    std::size_t branch = 0;       ///< solution, for a great arc
    double axis_slack = 0;        ///< rad, error of the axis beside that of the pieces
    PathPoint point;              ///< what the end of the move states
    std::size_t row = 0;          ///< index of that point in the path
    /// mm/min, feed of the move; none: a rapid.
    std::optional<double> feed_mm_per_min = {};
};

/// Divides moves into motions of the machine that stay within the tolerance.
class MachineMoves {
public:
    /// \param setup must outlive this. \param options must outlive this.
    MachineMoves(const PartOnMachine& setup, const MachinePathOptions& options);

    /// Begins at a pose. \pre nothing was added
    void begin(const CutterLocation& pose, const RotaryPositions& rotary,
               const PathPoint& point);

    /// Adds the motions of a move from the pose reached last. A move that changes nothing
    /// is left out unless it ends at a point of the path.
    void add(const IntendedMove& move);

    /// The motions so far; this is empty afterwards.
    MachinePath take();

private:
    struct Stop {
        double u = 0;         // parameter along the move
        CutterLocation pose;  // intended
        AxisPositions at;     // positions for this pose
    };

    struct PieceErrors {
        double tip = 0;    // mm, bound for tip and reference point
        double axis = 0;   // rad, bound
        double speed = 0;  // mm, bound of the first derivative of the tip
    };

    Stop stop_at(const IntendedMove& move, double u) const;
    RotaryPositions rotary_at(const IntendedMove& move, const Vec3& axis, double u) const;
    PieceErrors errors(const IntendedMove& move, const Stop& from, const Stop& to) const;
    void add_piece(const IntendedMove& move, const Stop& from, const Stop& to,
                   const PieceErrors& errors);
    double piece_minutes(const IntendedMove& move, const Stop& from, const Stop& to);
    double least_minutes(const AxisPositions& from, const AxisPositions& to) const;
    void append(const PathPoint& point, const Stop& stop, double minutes,
                std::size_t row);

    const PartOnMachine& setup_;
    const MachinePathOptions& options_;
    MachinePath made_;
};

}  // namespace endmill
