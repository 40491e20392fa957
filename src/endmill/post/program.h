// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// Types that all readers and writers of this module share: a program that was read, the
/// options for reading, and a program that was written.

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"

namespace endmill {

/// A machine program or CL data that was read.
struct Program {
    ToolPath path;  ///< tips, with cutting conditions if the program has any
    std::optional<Cutter> cutter;  ///< the cutter, if the program names one (APT does)
    std::vector<std::string> remarks;  ///< for a person: assumed units, motion left out
    double position_error_mm = 0;      ///< mm, rounding error of a coordinate in the text
    /// Index of the first point that a move at feed reaches while the spindle turns
    /// counterclockwise (M4); a path has no place for it.
    std::optional<std::size_t> counterclockwise_from = {};
    /// Index of the first point to which a tapping cycle (G74, G84) returns with the
    /// spindle reversed; a path has no place for it either.
    std::optional<std::size_t> tapping_from = {};
};

/// How the number of a rotary word leads to a position.
enum class RotaryWrap {
    Unwrapped,  ///< the number is the position: -700 differs from 20
    Shortest,   ///< the position nearest to the one before; half a rotation is positive
    /// The sign is the sense of the turn, and the number without it the position within a
    /// rotation, below 360: LinuxCNC's wrapped rotary axes.
    Signed,
};

/// The machine whose program is read, for its rotary words.
struct RotaryReading {
    PartOnMachine setup = {};                    ///< machine, tool and clamped part
    Interpolation frame = Interpolation::Joint;  ///< of X, Y and Z: Joint or Tcp
    std::array<RotaryWrap, 2> wraps = {};        ///< of R1 and R2
    double cutter_radius = 0;  ///< mm, for the feed of moves that turn the tool
};

/// Options for reading a G-code program or canonical output, and limits of what is
/// accepted.
struct GcodeReadOptions {
    /// mm, largest distance between an arc and its chords.
    double arc_tolerance_mm = 0.001;
    bool block_delete = false;  ///< whether blocks that begin with / are left out
    /// mm, height of the programmed point above the tip: the corner radius if the program
    /// describes the centre of the corner circle, 0 if it describes the tip.
    double programmed_point_height_mm = 0;
    double max_extent_mm = 1e6;            ///< mm, largest magnitude of a coordinate
    std::size_t most_points = 10'000'000;  ///< largest number of path points
    /// mm, canonical output: a coordinate of larger magnitude stands for a position that
    /// only the machine knows (`interpreter_parameters`).
    double machine_position_mm = std::numeric_limits<double>::infinity();
    /// The machine of a program with rotary words; without it they must be 0.
    std::optional<RotaryReading> rotary = {};
};

/// Number of path points that fit into `memory_gib` GiB while a program is read.
/// \pre memory_gib >= 0
std::size_t points_within(double memory_gib);

/// Checks reading options.
/// \throws DomainError unless the arc tolerance and the extent are positive, the height
///         of the programmed point is at least 0, all are finite, and the number of
///         points fits an int; for a frame other than Joint or Tcp.
void require_sound(const GcodeReadOptions& options);

/// Length of punched tape for one character, in m: tape has ten characters per inch.
inline constexpr double tape_metres_per_character = 0.00254;

/// Unit of the lengths in a program.
enum class ProgramUnit {
    Mm,    ///< G21
    Inch,  ///< G20
};

/// Length of one `unit` in mm: 1 or 25.4.
double millimetres_per(ProgramUnit unit);

/// Largest number of digits after the decimal point in a written program. Nine digits
/// keep all that a double stores of a coordinate up to 1e6 mm.
inline constexpr int most_decimals = 9;

/// Smallest and largest of the numbers added so far; both are std::nullopt if there are
/// none.
struct MinMax {
    std::optional<double> least;     ///< smallest number
    std::optional<double> greatest;  ///< largest number

    /// Widens the range to include `number`. \pre `number` is not NaN.
    void add(double number)
    {
        least = std::min(number, least.value_or(number));
        greatest = std::max(number, greatest.value_or(number));
    }
};

/// Whether the move to this point of `path` is a descent: a plunge, or the move at feed to
/// the first point, which the tool reaches from above.
bool is_descent(const ToolPath& path, std::size_t point);

/// Which feed a move gets if both the path and the settings have one.
enum class FeedChoice {
    OfPath,      ///< that of the path
    OfSettings,  ///< that of the settings
};

/// Feeds that are set for the moves of a path.
struct FeedSettings {
    std::optional<double> cutting_mm_per_min = {};  ///< mm/min, of all moves but rapids
    FeedChoice choice = FeedChoice::OfPath;         ///< for moves that have a feed
    std::optional<double> plunge_mm_per_min = {};   ///< mm/min, of all descents
    /// Feed of descents as a share of the cutting feed; above 0, at most 1.
    double plunge_share = 1;

    /// mm/min, of a descent before moves with this cutting feed.
    double plunge(double cutting) const
    {
        return plunge_mm_per_min.value_or(plunge_share * cutting);
    }
};

/// Sets the feeds of `path`. With FeedChoice::OfPath a move keeps its own feed, but a descent
/// gets a given `plunge_mm_per_min` in any case.
/// \throws DomainError if `plunge_mm_per_min` is above the largest feed of the other moves
///         of the changed path; unless all numbers are above 0 and the share at most 1.
void set_feeds(ToolPath& path, const FeedSettings& feeds);

/// The text of a program, and a record of the changes that writing made.
struct WrittenProgram {
    std::string text;       ///< the whole program
    std::size_t lines = 0;  ///< number of lines
    /// Number of points left out because they equal the previous one after rounding.
    std::size_t repeated_points = 0;
    std::size_t slanted_rapids = 0;    ///< rapids that change height and position at once
    double max_rounding_error_mm = 0;  ///< mm, largest rounding error of a coordinate
    int decimals = 4;                  ///< digits after the point of coordinates
    double safe_height_mm = 0;         ///< mm, safe height of a G-code program
    std::size_t arcs = 0;              ///< number of arcs
    double max_arc_error_mm = 0;  ///< mm, bound of the distance between arcs and path
    std::size_t ramps = 0;        ///< descents along a slope
    /// Descents that stay vertical although slopes are wanted, because no cut follows
    /// them, the cuts are too short for a slope, or the tool was changed.
    std::size_t straight_descents = 0;
    /// Of the moves that the program describes, from the point at which all axes have a
    /// position; arcs with their own length. Tools as the program names them.
    PathTotals totals;
    MinMax feed_mm_per_min;  ///< mm/min, range of the cutting feeds before rounding
    MinMax plunge_feed_mm_per_min;  ///< mm/min, range of the feeds of descents
    MinMax spindle_rpm;             ///< rpm, range of the spindle speeds before rounding

    /// Length in m of a punched tape with the text, line ends included.
    double tape_length_m() const
    {
        return tape_metres_per_character * static_cast<double>(text.size());
    }
};

}  // namespace endmill
