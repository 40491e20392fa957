// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/program_builder.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
}

// The move to the first point starts at an unknown position and cuts nothing, so it is a
// rapid without a feed.
void ProgramBuilder::go_to(const Vec3& target, const std::optional<MoveFeed>& feed)
{
    const std::size_t first_point = path_.points.size();
    append(feed && has_position() ? feed_move(position_, target) : Move::Rapid, target);
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
    for (std::size_t number = 1; number <= count; ++number)
        append(Move::Cut, chords.end(number));
    set_feed(feed, first_point);
}

void ProgramBuilder::append(Move move, const Vec3& point)
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
    const Vec3 tip = point - options_.programmed_point_height_mm * Vec3::UnitZ();
    const bool is_turning = !spindle_stopped_ && speed_rpm_ && *speed_rpm_ > 0;
    path_.points.push_back(
        {.pass = pass,
         .point = number,
         .move = move,
         .location = {tip, Vec3::UnitZ()},
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
    if (feed.mode == FeedRateMode::InverseTime) {
        double length = 0;
        for (std::size_t i = first_point; i < points.size(); ++i)
            length += (points[i].location.tip - points[i - 1].location.tip).norm();
        if (length == 0)
            return;  // a move of length 0 takes time but has no feed
        // F is 1 over the minutes of the whole move.
        feed_mm_per_min *= length;
    }
    if (!(std::isfinite(feed_mm_per_min) && feed_mm_per_min > 0))
        throw lines_.range_complaint("a feed of " + brief(feed_mm_per_min) + " mm/min",
                                     "a feed that a double can store");
    for (std::size_t i = first_point; i < points.size(); ++i)
        points[i].conditions.feed_mm_per_min = feed_mm_per_min;
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
