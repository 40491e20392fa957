// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "endmill/post/detail/arc.h"
#include "endmill/post/detail/text_lines.h"
#include "endmill/post/gcode_reader.h"
#include "endmill/post/program.h"

namespace endmill {

/// How fast a move is.
struct MoveFeed {
    double value = 0;           ///< above 0; mm/min, or 1/min if inverse time
    bool inverse_time = false;  ///< the move lasts 1 / value minutes
};

/// Puts together the path of a program, move by move, from positions of the programmed
/// point in mm. A straight feed downwards is a `Plunge`, upwards a `Retract`. The first
/// point says where the path begins, and is a `Rapid` whatever leads to it.
///
/// A pass is a run of moves that do not cut, then one of cuts: a new pass begins with the
/// first move after cuts that does not cut. What follows the last cut belongs to its pass.
///
/// The `tool` of a move is the one that was changed to last; in a program that never
/// changes, the one that was selected last. `spindle_rpm` is the speed that was set last,
/// whether or not a start was told; none after a stop, until the next start.
class ProgramBuilder {
public:
    /// \param lines where complaints say to be; \param options as the reader has them.
    /// Both outlive this. \throws DomainError as `check_options`.
    ProgramBuilder(const TextLines& lines, const GcodeReadOptions& options);

    /// Whether the path has begun.
    bool has_position() const { return !path_.points.empty(); }

    /// How many points the path has so far.
    std::size_t point_count() const { return path_.points.size(); }

    /// Goes straight to `target`; without a feed as a rapid.
    /// \throws FormatError E_RANGE if a coordinate or the feed is out of range.
    /// \throws LimitError if the path has too many points.
    void go_to(const Vec3& target, const std::optional<MoveFeed>& feed);

    /// Goes along `arc`, which starts where the path has come to, in chords.
    /// \throws as `go_to`. \pre has_position(), both radii are positive.
    void go_along(const Arc& arc, const MoveFeed& feed);

    void set_spindle_speed(double rpm) { speed_rpm_ = rpm; }  ///< S; 0 is a stop
    void start_spindle() { spindle_stopped_ = false; }        ///< M3, M4
    void stop_spindle() { spindle_stopped_ = true; }          ///< M5

    void select_tool(int number);  ///< T
    void change_tool();            ///< M6, to the one that was selected last, if any
    void change_tool(int number);  ///< to this one

    /// Notes what a person should know; the same thing only once.
    void remark(const std::string& text);

    /// What was read; afterwards this is empty.
    Program take();

private:
    struct ToolChoice {
        std::size_t first_point;
        int tool;
    };

    void append(Move move, const Vec3& point);
    void set_feed(const MoveFeed& feed, std::size_t first_point);
    void fill_selected_tools();
    void remark_tools();
    void close_last_pass();

    const TextLines& lines_;
    const GcodeReadOptions& options_;
    ToolPath path_;
    std::vector<std::string> remarks_;
    std::vector<ToolChoice> selections_;
    Vec3 position_ = Vec3::Zero();  // of the programmed point
    std::optional<double> speed_rpm_;
    bool spindle_stopped_ = false;
    bool has_changes_ = false;
    std::optional<int> tool_;
};

}  // namespace endmill
