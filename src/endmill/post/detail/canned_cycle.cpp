// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/canned_cycle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "endmill/core/detail/units.h"

// The moves of a hole, from R on:
//   G81, G82   feed to the depth; rapid to the clearance level
//   G83        feed by Q; rapid to R and back to just above the last depth; and so on
//   G73        the same, with a short rapid up instead of the return to R
//   G74, G84   feed to the depth and back to the clearance level (tapping)
//   G85        feed to the depth and back to R; rapid to the clearance level
//   G89        feed to the depth and back to the clearance level
//   G86, G88   as G81; the spindle stops before the retract
// In G88 the operator retracts the tool by hand, which is taken as a rapid.

namespace endmill {
namespace {

constexpr std::array axis_letters{'X', 'Y', 'Z'};

// Distance above the last depth at which a drill returns to feed after a peck, and length
// of the retract of G73. LinuxCNC takes a hundredth of an inch.
constexpr double peck_clearance_mm = 0.01 * mm_per_inch;

// A last peck shorter than this, in mm, is left to the peck before: it comes from the
// rounding of a sum of pecks.
constexpr double shortest_peck_mm = 1e-9;

// Number of pecks from R to the bottom; a whole number that may exceed the range of
// integers.
double peck_count(double r, double bottom, double peck)
{
    return std::max(1.0, std::ceil((r - bottom - shortest_peck_mm) / peck));
}

std::vector<HoleMove> pecked_hole(const CannedCycle& cycle, double bottom, double peck,
                                  bool returns_to_r)
{
    std::vector<HoleMove> moves;
    const auto pecks = static_cast<std::size_t>(peck_count(cycle.r, bottom, peck));
    for (std::size_t number = 1; number < pecks; ++number) {
        const double depth = cycle.r - static_cast<double>(number) * peck;
        moves.push_back({depth, true});
        if (returns_to_r)
            moves.push_back({cycle.r, false});
        moves.push_back({depth + peck_clearance_mm, false});
    }
    moves.push_back({bottom, true});
    moves.push_back({cycle.clear, false});
    return moves;
}

std::vector<HoleMove> hole_moves(int code, const CannedCycle& cycle, double bottom,
                                 double peck)
{
    switch (code) {
        case 73:
        case 83:
            return pecked_hole(cycle, bottom, peck, code == 83);
        case 74:
        case 84:
            return {{bottom, true}, {cycle.clear, true, true}};
        case 89:
            return {{bottom, true}, {cycle.clear, true}};
        case 85:
            return {{bottom, true}, {cycle.r, true}, {cycle.clear, false}};
        default:
            return {{bottom, true}, {cycle.clear, false}};
    }
}

bool has_pecks(int code)
{
    return code == 73 || code == 83;
}

// Sets the position of the first hole, which is that before the block until then, and the
// step to the next one.
void place_holes(CannedCycle& cycle, const GcodeBlock& block, const GcodeModes& modes)
{
    const bool is_increment = modes.distance == DistanceMode::Incremental;
    for (const int axis : {cycle.axes.first, cycle.axes.second}) {
        const char letter = axis_letters[static_cast<std::size_t>(axis)];
        if (!block.has(letter))
            continue;
        const double length = block.value(letter) * modes.mm_per_unit();
        cycle.first_hole[axis] = length + (is_increment ? cycle.first_hole[axis] : 0);
        cycle.step[axis] = is_increment ? length : 0;
    }
}

// Number of holes: L, or K as on Fanuc controls.
double hole_count(const GcodeBlock& block, const TextLines& lines)
{
    for (const char letter : {'L', 'K'}) {
        if (!block.has(letter))
            continue;
        const double count = block.value(letter);
        if (!(count >= 1 && count == std::floor(count)))
            throw lines.complaint(letter + brief(count) + " holes of a canned cycle",
                                  "a whole number from 1");
        return count;
    }
    return 1;
}

// The number of moves is checked before they are made, because a single word L or Q can
// demand any number of them.
void check_room(double moves, std::size_t room, const TextLines& lines)
{
    if (!(moves <= static_cast<double>(room)))
        throw LimitError{lines.file() + ':' + std::to_string(lines.number()) +
                         ": a canned cycle of " + brief(moves) +
                         " moves makes more than the points that are left (" +
                         std::to_string(room) + "; --max-memory)"};
}

}  // namespace

// A word must be given in the first block of its cycle. LinuxCNC keeps the numbers of the
// words and of the initial level when the unit changes, other controls the lengths.
void CannedCycles::take_words(const GcodeBlock& block, const GcodeModes& modes,
                              char depth_letter, const TextLines& lines)
{
    if (code_ != 0 && mm_per_unit_ != modes.mm_per_unit())
        throw lines.complaint("G20 or G21 within a canned cycle", "G80 before it");
    mm_per_unit_ = modes.mm_per_unit();
    const bool is_new = code_ != modes.cycle;
    const auto take = [&](char letter, double& word, const char* meaning) {
        if (block.has(letter))
            word = block.value(letter) * modes.mm_per_unit();
        else if (is_new)
            throw lines.complaint(
                'G' + std::to_string(modes.cycle) + " without " + letter,
                std::string(1, letter) + ", " + meaning);
    };
    take('R', r_, "the level above the hole where the feed begins");
    take(depth_letter, depth_, "the depth of the hole");
    if (!has_pecks(modes.cycle))
        return;
    take('Q', peck_, "the depth of a peck");
    if (!(peck_ > 0))
        throw lines.complaint("a peck of Q" + brief(peck_ / modes.mm_per_unit()),
                              "Q > 0");
}

CannedCycle CannedCycles::next(const GcodeBlock& block, const GcodeModes& modes,
                               const Vec3& position, std::size_t room,
                               const TextLines& lines)
{
    if (!block.has_any("XYZ"))
        throw lines.complaint("a canned cycle without X, Y and Z",
                              "a position of a hole");
    const PlaneAxes axes = plane_axes(modes.plane);
    const auto normal = static_cast<std::size_t>(axes.normal);
    if (code_ == 0)
        initial_level_ = position[axes.normal];
    take_words(block, modes, axis_letters[normal], lines);
    code_ = modes.cycle;

    const bool is_increment = modes.distance == DistanceMode::Incremental;
    CannedCycle cycle{.axes = axes,
                      .first_hole = position,
                      .step = Vec3::Zero(),
                      .holes = 1,
                      .begins_at_r = false,
                      .approach = 0,
                      .r = r_ + (is_increment ? initial_level_ : 0),
                      .clear = 0,
                      .hole = {}};
    const double bottom = depth_ + (is_increment ? cycle.r : 0);
    if (!(cycle.r >= bottom))
        throw lines.complaint(
            "R at " + brief(cycle.r) + " mm, below the depth at " + brief(bottom) + " mm",
            "R above the depth");
    place_holes(cycle, block, modes);
    set_levels(cycle, modes.retract, position[axes.normal]);

    const double pecks = has_pecks(code_) ? peck_count(cycle.r, bottom, peck_) : 1;
    const double holes = hole_count(block, lines);
    constexpr double most_moves_per_peck = 3;
    constexpr double moves_around_pecks = 3;
    check_room(holes * (most_moves_per_peck * pecks + moves_around_pecks) + 1, room,
               lines);
    cycle.holes = static_cast<std::size_t>(holes);
    cycle.hole = hole_moves(code_, cycle, bottom, peck_);
    return cycle;
}

// Below R the tool first rises over its place. From above R it keeps its height to the
// first hole; from R it goes there at the initial level under G98.
void CannedCycles::set_levels(CannedCycle& cycle, RetractLevel retract,
                              double start) const
{
    const bool to_initial = retract == RetractLevel::Initial;
    cycle.begins_at_r = initial_level_ < cycle.r;
    cycle.clear = to_initial ? std::max(initial_level_, cycle.r) : cycle.r;
    if (cycle.begins_at_r)
        cycle.approach = cycle.r;
    else
        cycle.approach = start > cycle.r ? start : cycle.clear;
}

}  // namespace endmill
