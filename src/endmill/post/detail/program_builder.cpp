// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/program_builder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "endmill/core/angle.h"
#include "endmill/core/detail/large_pages.h"
#include "endmill/post/detail/feed_move.h"

namespace endmill {
namespace {

// A block that moves all three axes has about this length.
constexpr std::size_t likely_bytes_per_block = 30;

// Height in mm of a move to a reference position above all points so far. The default
// safe height of written programs has the same clearance.
constexpr double clearance_mm = 5;

}  // namespace

ProgramBuilder::ProgramBuilder(const TextLines& lines, const GcodeReadOptions& options,
                               KeptPoints kept)
    : lines_{lines},
      options_{options}
{
    require_sound(options);
    if (options.rotary) {
        path_.machine = MachineMotion{.interpolation = options.rotary->frame,
                                      .setup = options.rotary->setup,
                                      .positions = {}};
        programmed_setup_ = options.rotary->setup;
        programmed_setup_->tool_length -= options.programmed_point_height_mm;
    }
    if (kept == KeptPoints::Last)
        return;
    const std::size_t likely_points = lines.rest().size() / likely_bytes_per_block;
    reserve_in_large_pages(path_.points, std::min(likely_points, options.most_points));
}

void ProgramBuilder::forget_points()
{
    if (path_.points.size() <= 1)
        return;
    forgotten_ += path_.points.size() - 1;
    path_.points.erase(path_.points.begin(), path_.points.end() - 1);
    if (!path_.machine)
        return;
    auto& positions = path_.machine->positions;
    positions.erase(positions.begin(), positions.end() - 1);
    programmed_.erase(programmed_.begin(), programmed_.end() - 1);
}

// The move to the first point starts at an unknown position and cuts nothing, so it is a
// rapid without a feed.
void ProgramBuilder::go_to(const Vec3& target, const std::optional<MoveFeed>& feed)
{
    const std::size_t first_point = path_.points.size();
    append(feed && has_position() ? kind_of_feed(target) : Move::Rapid, target);
    if (feed && first_point > 0)
        set_feed(*feed, first_point);
}

double ProgramBuilder::safe_height_mm() const
{
    return highest_mm_ + clearance_mm;
}

// The safe height does not grow by the rapids at the safe height.
void ProgramBuilder::go_at_safe_height(const Vec3& target)
{
    const double highest = highest_mm_;
    append(Move::Rapid, target);
    highest_mm_ = highest;
}

// The number of chords is checked before they are made, because a single word P can
// demand any number of them.
void ProgramBuilder::go_along(const Arc& arc, const MoveFeed& feed)
{
    const ArcChords chords{arc, options_.arc_tolerance_mm};
    const std::size_t first_point = path_.points.size();
    const auto most = static_cast<double>(room());
    if (!(chords.count() <= most))
        throw LimitError{lines_.file() + ':' + std::to_string(lines_.number()) +
                         ": an arc of " + brief(chords.count()) +
                         " chords makes more than " +
                         std::to_string(options_.most_points) +
                         " points (--max-memory, --arc-tolerance)"};
    const auto count = static_cast<std::size_t>(chords.count());
    const RotaryPositions from = rotary_;
    for (std::size_t number = 1; number <= count; ++number) {
        const double u = static_cast<double>(number) / static_cast<double>(count);
        append(Move::Cut, chords.end(number),
               number == count
                   ? rotary_target_
                   : RotaryPositions{from[0] + u * (rotary_target_[0] - from[0]),
                                     from[1] + u * (rotary_target_[1] - from[1])});
    }
    set_feed(feed, first_point);
}

// The kind of a straight move at feed to `target`. With rotary axes a move along the axis of
// the tool is a plunge or a retract; rounded coordinates are off that line by microns.
Move ProgramBuilder::kind_of_feed(const Vec3& target) const
{
    constexpr double rounding_mm = 1e-3;
    constexpr double least_ratio = 10;
    if (!path_.machine)
        return feed_move(position_, target);
    if (rotary_target_ != rotary_)
        return Move::Cut;
    const CutterLocation& from = path_.points.back().location;
    const Vec3 way = location_of(target, rotary_target_).tip - from.tip;
    const double along = way.dot(from.axis);
    const double across = (way - along * from.axis).norm();
    if (across > rounding_mm || !(std::abs(along) > least_ratio * across))
        return Move::Cut;
    return along < 0 ? Move::Plunge : Move::Retract;
}

// The pose for a programmed point. A programmed point above the tip is the tip of a tool
// that is shorter by its height.
CutterLocation ProgramBuilder::location_of(const Vec3& point,
                                           const RotaryPositions& rotary) const
{
    const double height = options_.programmed_point_height_mm;
    if (!path_.machine)
        return {point - height * Vec3::UnitZ(), Vec3::UnitZ()};
    const PartOnMachine& setup = *programmed_setup_;
    CutterLocation location = tool_location(setup, {rotary, point});
    if (path_.machine->interpolation == Interpolation::Tcp)
        location.tip = setup.part_to_machine.transpose() * (point - setup.clamp);
    location.tip -= height * location.axis;
    return location;
}

void ProgramBuilder::append(Move move, const Vec3& point)
{
    append(move, point, rotary_target_);
}

void ProgramBuilder::append(Move move, const Vec3& point, const RotaryPositions& rotary)
{
    for (const double coordinate : point)
        check_extent(coordinate, options_.max_extent_mm, lines_);
    if (point_count() >= options_.most_points)
        throw LimitError{lines_.file() + ':' + std::to_string(lines_.number()) +
                         ": more than " + std::to_string(options_.most_points) +
                         " points (--max-memory)"};
    int pass = 0;
    int number = 0;
    // A pass is a run of moves without cuts followed by a run of cuts.
    if (has_position()) {
        const PathPoint& last = path_.points.back();
        const bool is_new_pass = last.move == Move::Cut && move != Move::Cut;
        pass = is_new_pass ? last.pass + 1 : last.pass;
        number = is_new_pass ? 0 : last.point + 1;
    }
    const CutterLocation location = location_of(point, rotary);
    if (path_.machine) {
        for (const double coordinate : location.tip)
            check_extent(coordinate, options_.max_extent_mm, lines_);
        path_.machine->positions.push_back(
            axis_positions(path_.machine->setup, rotary, location.tip));
        programmed_.push_back(point);
    }
    rotary_ = rotary;
    const bool is_turning = !spindle_stopped_ && speed_rpm_ && *speed_rpm_ > 0;
    path_.points.push_back(
        {.pass = pass,
         .point = number,
         .move = move,
         .location = location,
         .conditions = {.spindle_rpm = is_turning ? speed_rpm_ : std::nullopt,
                        .tool = tool_}});
    if (move != Move::Rapid && !spindle_stopped_ && !counterclockwise_from_ &&
        spindle_sense_ == SpindleSense::Counterclockwise)
        counterclockwise_from_ = point_count() - 1;
    position_ = point;
    highest_mm_ = std::max(highest_mm_, point.z());
    if (move == Move::Cut || move == Move::Plunge)
        highest_cut_mm_ = std::max(highest_cut_mm_, point.z());
}

// Sets the feed of the points from `first_point` on, which are one move of the program.
// Precondition: `first_point` is not 0.
void ProgramBuilder::set_feed(const MoveFeed& feed, std::size_t first_point)
{
    auto& points = path_.points;
    double feed_mm_per_min = feed.value;
    const bool turns =
        path_.machine && path_.machine->positions.back().rotary !=
                             path_.machine->positions[first_point - 1].rotary;
    if (turns || feed.mode == FeedRateMode::InverseTime) {
        double way = 0;
        for (std::size_t i = first_point; i < points.size(); ++i)
            way += way_of_feed(i);
        if (way == 0)
            return;  // a move of length 0 takes time but has no feed
        feed_mm_per_min = way / minutes_of(feed, first_point);
    }
    if (!(std::isfinite(feed_mm_per_min) && feed_mm_per_min > 0))
        throw lines_.range_complaint("a feed of " + brief(feed_mm_per_min) + " mm/min",
                                     "a feed that a double can store");
    for (std::size_t i = first_point; i < points.size(); ++i)
        points[i].conditions.feed_mm_per_min = feed_mm_per_min;
}

// mm, the way that the feed of a move to a point measures: that of the tip, or that of the
// rim of the cutter if it turns further.
double ProgramBuilder::way_of_feed(std::size_t point) const
{
    const CutterLocation& from = path_.points[point - 1].location;
    const CutterLocation& to = path_.points[point].location;
    const double way = (to.tip - from.tip).norm();
    if (!path_.machine)
        return way;
    return std::max(way,
                    options_.rotary->cutter_radius * angle_between(from.axis, to.axis));
}

// The time of the points from `first_point` on, which are one move of the program. Under
// G94 the feed is that of X, Y and Z, or of the rotary axes where these do not move.
double ProgramBuilder::minutes_of(const MoveFeed& feed, std::size_t first_point) const
{
    if (feed.mode == FeedRateMode::InverseTime)
        return 1 / feed.value;
    double length = 0;
    for (std::size_t i = first_point; i < programmed_.size(); ++i)
        length += (programmed_[i] - programmed_[i - 1]).norm();
    if (length > 0)
        return length / feed.value;
    const auto& positions = path_.machine->positions;
    double turn_deg = 0;
    for (std::size_t i = first_point; i < positions.size(); ++i) {
        const RotaryPositions& from = positions[i - 1].rotary;
        const RotaryPositions& to = positions[i].rotary;
        turn_deg +=
            Angle::radians(std::hypot(to[0] - from[0], to[1] - from[1])).degrees();
    }
    return turn_deg * feed.mm_per_unit / feed.value;
}

// T selects the next tool and M6 changes to it, so that a program may select a tool
// early. Whether the program has an M6 at all is known only at its end.
void ProgramBuilder::start_spindle(SpindleSense sense)
{
    spindle_stopped_ = false;
    spindle_sense_ = sense;
}

void ProgramBuilder::select_tool(int number)
{
    if (selections_.empty() || selections_.back().tool != number)
        selections_.push_back({point_count(), number});
}

void ProgramBuilder::change_tool()
{
    has_changes_ = true;
    if (!selections_.empty())
        tool_ = selections_.back().tool;
}

void ProgramBuilder::change_tool(int number)
{
    has_changes_ = true;
    tool_ = number;
}

void ProgramBuilder::remark(const std::string& text)
{
    if (std::ranges::find(remarks_, text) == remarks_.end())
        remarks_.push_back(text);
}

// In a program without M6 the T itself changes the tool: by hand, or on a turret.
void ProgramBuilder::fill_selected_tools()
{
    for (std::size_t k = 0; k < selections_.size(); ++k) {
        const bool is_last = k + 1 == selections_.size();
        const std::size_t end =
            is_last ? path_.points.size() : selections_[k + 1].first_point;
        for (std::size_t i = selections_[k].first_point; i < end; ++i)
            path_.points[i].conditions.tool = selections_[k].tool;
    }
}

// The moves after the last cut have begun a pass without cuts; adds them to the pass
// before.
void ProgramBuilder::close_last_pass()
{
    auto& points = path_.points;
    const auto is_cut = [](const PathPoint& point) { return point.move == Move::Cut; };
    const auto after_cuts = std::find_if(points.rbegin(), points.rend(), is_cut).base();
    if (after_cuts == points.begin())
        return;
    for (auto point = after_cuts; point != points.end(); ++point) {
        point->pass = (point - 1)->pass;
        point->point = (point - 1)->point + 1;
    }
}

Program ProgramBuilder::take()
{
    if (!has_changes_)
        fill_selected_tools();
    close_last_pass();
    if (counterclockwise_from_)
        remark("the spindle turns counterclockwise (M4) from the move to point " +
               std::to_string(*counterclockwise_from_) +
               " on; the path does not store the direction");
    Program program{.path = std::move(path_),
                    .cutter = {},
                    .remarks = std::move(remarks_),
                    .counterclockwise_from = counterclockwise_from_,
                    .tapping_from = tapping_from_};
    path_ = {};
    remarks_ = {};
    return program;
}

}  // namespace endmill
