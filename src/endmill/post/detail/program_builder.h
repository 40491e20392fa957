// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "endmill/post/detail/arc.h"
#include "endmill/post/detail/gcode_modes.h"
#include "endmill/post/detail/text_lines.h"
#include "endmill/post/program.h"

namespace endmill {

/// Feed of a move.
struct MoveFeed {
    double value = 0;  ///< above 0; mm/min, or 1/min for inverse time
    FeedRateMode mode = FeedRateMode::PerMinute;  ///< meaning of the value
    /// mm per unit of length: a move of rotary axes alone has degrees per minute instead of
    /// units per minute.
    double mm_per_unit = 1;
};

/// How the spindle turns, seen along the tool from the spindle.
enum class SpindleSense {
    Clockwise,         ///< M3
    Counterclockwise,  ///< M4
};

/// Which points a ProgramBuilder keeps.
enum class KeptPoints {
    All,   ///< the whole path
    Last,  ///< those since the last `forget_points`, for a caller that needs no path
};

/// Builds the path of a program move by move, from positions of the programmed point in
/// mm.
///
/// - *Kinds of moves*: a straight feed down is a Plunge, up a Retract, otherwise a Cut.
///   The first point only states where the path begins, so it is a Rapid whatever move
///   leads to it.
/// - *Passes*: a pass is a run of moves that do not cut, followed by a run of cuts. A new
///   pass begins with the first move after cuts that does not cut. Moves after the last
///   cut belong to the pass of that cut.
/// - *Tools*: the tool of a move is the one changed to last. In a program without tool
///   changes it is the one selected last.
/// - *Rotary axes*: with `GcodeReadOptions::rotary` a point has the pose of the tool, and
///   the path the positions of the machine. A move at feed along a resting axis is a Plunge
///   or a Retract. Its feed is that of the tip in the part.
/// - *Spindle*: the speed of a move is the one set last, whether or not the program has a
///   start command. After a stop there is none until the next start.
class ProgramBuilder {
public:
    /// \param lines for error messages; must outlive the builder.
    /// \param options of the reader; must outlive the builder.
    /// \param kept points to keep.
    /// \throws DomainError unless the options are sound.
    ProgramBuilder(const TextLines& lines, const GcodeReadOptions& options,
                   KeptPoints kept = KeptPoints::All);

    /// Whether the path has a point.
    bool has_position() const { return !path_.points.empty(); }

    /// Position of the programmed point at the end of the path so far, in mm.
    /// \pre has_position()
    const Vec3& position() const { return position_; }

    /// Height in mm of the rapids that stand for moves to a reference position: 5 mm above
    /// all points so far but those of such rapids. \pre has_position()
    double safe_height_mm() const;

    /// Height in mm of the highest point that a plunge or a cut has reached; -infinity
    /// before the first one.
    double highest_cut_mm() const { return highest_cut_mm_; }

    /// Whether the last move is a plunge or a cut. \pre has_position()
    bool ends_with_cut() const
    {
        const Move last = path_.points.back().move;
        return last == Move::Cut || last == Move::Plunge;
    }

    /// Adds a rapid that stands for a move to or from a reference position, whose target
    /// the program does not state. Errors as `go_to`.
    void go_at_safe_height(const Vec3& target);

    /// Number of points that can still be added.
    std::size_t room() const { return options_.most_points - point_count(); }

    /// Number of points of the path so far.
    std::size_t point_count() const { return forgotten_ + path_.points.size(); }

    /// Releases all points but the last one; they still count. \pre KeptPoints::Last
    void forget_points();

    /// Sets the positions of the rotary axes (rad) at the end of the next move.
    void turn_to(const RotaryPositions& rotary) { rotary_target_ = rotary; }

    /// Adds a straight move to `target` (mm). A move without a feed is a rapid.
    /// \throws FormatError E_RANGE if a coordinate or the feed is out of range.
    /// \throws LimitError if the path has too many points.
    void go_to(const Vec3& target, const std::optional<MoveFeed>& feed);

    /// Adds the chords of `arc`, which starts at the current position. Errors as `go_to`.
    /// \pre has_position(), and both radii are positive.
    void go_along(const Arc& arc, const MoveFeed& feed);

    void set_spindle_speed(double rpm) { speed_rpm_ = rpm; }  ///< S; 0 is a stop
    void start_spindle(SpindleSense sense);                   ///< M3, M4
    void stop_spindle() { spindle_stopped_ = true; }          ///< M5

    /// Notes that the spindle is reversed on the next move alone, which leaves a hole of a
    /// tapping cycle.
    void note_tapping() { tapping_from_ = tapping_from_.value_or(path_.points.size()); }

    void select_tool(int number);  ///< T
    void change_tool();            ///< M6: to the tool selected last, if any
    void change_tool(int number);  ///< to the tool with this number

    /// Adds a remark for a person. A repeated remark is added once.
    void remark(const std::string& text);

    /// The program. The builder is empty afterwards. \pre KeptPoints::All
    Program take();

private:
    struct ToolChoice {
        std::size_t first_point;
        int tool;
    };

    void append(Move move, const Vec3& point);
    void append(Move move, const Vec3& point, const RotaryPositions& rotary);
    CutterLocation location_of(const Vec3& point, const RotaryPositions& rotary) const;
    Move kind_of_feed(const Vec3& target) const;
    double way_of_feed(std::size_t point) const;
    double minutes_of(const MoveFeed& feed, std::size_t first_point) const;
    void set_feed(const MoveFeed& feed, std::size_t first_point);
    void fill_selected_tools();
    void close_last_pass();

    const TextLines& lines_;
    const GcodeReadOptions& options_;
    ToolPath path_;  // without the points that were forgotten
    std::size_t forgotten_ = 0;
    std::vector<std::string> remarks_;
    std::vector<ToolChoice> selections_;
    Vec3 position_ = Vec3::Zero();                   // of the programmed point, mm
    RotaryPositions rotary_{0, 0};                   // rad, at the last point
    RotaryPositions rotary_target_{0, 0};            // rad, at the end of the next move
    std::optional<PartOnMachine> programmed_setup_;  // with the programmed point as tip
    std::vector<Vec3> programmed_;  // mm, of all points, if rotary axes are read
    double highest_mm_ = -std::numeric_limits<double>::infinity();
    double highest_cut_mm_ = -std::numeric_limits<double>::infinity();
    std::optional<double> speed_rpm_;
    bool spindle_stopped_ = false;
    SpindleSense spindle_sense_ = SpindleSense::Clockwise;
    std::optional<std::size_t> counterclockwise_from_;
    std::optional<std::size_t> tapping_from_;
    bool has_changes_ = false;
    std::optional<int> tool_;
};

}  // namespace endmill
