// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/turning_motions.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "endmill/core/error.h"
#include "endmill/stock/detail/removable_path.h"

namespace endmill {
namespace {

// Greatest turn of a piece in rad. Motions that turn more are divided first, so that the
// bounding volumes are tight; they are divided further where that is needed.
constexpr double most_turn = 0.03;
constexpr int most_halvings = 12;
constexpr double infinite = std::numeric_limits<double>::infinity();

// How far a motion moves against its axis, mm.
double sinking(const ToolMotion& motion)
{
    return -(motion.to().tip - motion.from().tip).dot(motion.from().axes.col(2));
}

// Adds a motion, divided until its pieces turn little and sink by at most `most_sinking`.
void add_pieces(std::vector<ToolPiece>& pieces, const ToolPiece& whole,
                double most_sinking, int halvings)
{
    if (halvings == 0 ||
        (whole.motion.turn() <= most_turn && sinking(whole.motion) <= most_sinking)) {
        pieces.push_back(whole);
        return;
    }
    for (const ToolMotion& half : whole.motion.halves())
        add_pieces(pieces, {half, whole.body, whole.point, 0}, most_sinking,
                   halvings - 1);
}

// Returns the neck of a cutter of finite length; nothing if it has none.
std::optional<CuttingBody> neck_of(const ToolRun& run)
{
    const double radius = run.cutter.radius() - neck_clearance;
    double end = infinite;
    for (const ToolCylinder& cylinder : run.body)
        end = std::min(end, cylinder.from);
    if (!(run.cutting_length < end) || !(radius > 0))
        return std::nullopt;
    return CuttingBody::of_cylinder({2 * radius, run.cutting_length, end});
}

// Returns how far the cutter may sink until a body that is not wider reaches a height that
// it has not cleared before.
double most_sinking(const Cutter& cutter, std::span<const CuttingBody> bodies)
{
    double most = infinite;
    for (const CuttingBody& body : bodies) {
        const double room = body.base() - cutter.corner_radius();
        if (body.cutter().radius() <= cutter.radius() && room > 0)
            most = std::min(most, room);
    }
    return most;
}

// Returns the motion between two points.
ToolMotion motion_between(const ToolPath& path, std::size_t from, std::size_t to)
{
    if (const auto& machine = path.machine)
        return {machine->setup, machine->interpolation, machine->positions[from],
                machine->positions[to]};
    try {
        return {path.points[from].location, path.points[to].location};
    } catch (const DomainError&) {
        const PathPoint& point = path.points[to];
        throw GeometryError{"the tool axes of pass " + std::to_string(point.pass) +
                            ", point " + std::to_string(point.point) +
                            " and of the point before are opposite, or not unit vectors: "
                            "the turn between them is not defined; expected points "
                            "between them"};
    }
}

// Returns the motion to a pose of an earlier run.
ToolMotion motion_between(const EarlierTurningRun& run, std::size_t from, std::size_t to)
{
    if (const auto& machine = run.machine)
        return {machine->setup, machine->interpolation, machine->positions[from],
                machine->positions[to]};
    try {
        return {run.poses[from], run.poses[to]};
    } catch (const DomainError&) {
        throw GeometryError{"the tool axes of pose " + std::to_string(to) +
                            " of an earlier run and of the pose before are opposite, or "
                            "not unit vectors: the turn between them is not defined"};
    }
}

}  // namespace

TurningMotions motions_along(const ToolPath& path, std::span<const ToolRun> runs)
{
    TurningMotions motions;
    std::int32_t order = 0;
    for (const ToolRun& run : runs) {
        const CuttingBody cutter{run.cutter, run.cutting_length};
        std::vector<CuttingBody> bodies;
        bodies.reserve(run.body.size() + 1);
        for (const ToolCylinder& cylinder : run.body)
            bodies.push_back(CuttingBody::of_cylinder(cylinder));
        const std::optional<CuttingBody> neck = neck_of(run);
        if (neck)
            bodies.push_back(*neck);
        const double sinks = most_sinking(run.cutter, bodies);
        const bool stands = !run.path.points.empty() && cuts_at_start(run.path);
        for (std::size_t k = stands ? 0 : 1; k < run.path.points.size(); ++k) {
            const std::size_t to = k + run.offset;
            const auto point = static_cast<std::int32_t>(to);
            const ToolMotion motion = motion_between(path, k == 0 ? to : to - 1, to);
            std::vector<ToolPiece> pieces;
            add_pieces(pieces, {motion, cutter, point, 0}, sinks, most_halvings);
            for (ToolPiece& piece : pieces) {
                piece.order = ++order;
                motions.cutters.push_back(piece);
                for (const CuttingBody& body : bodies) {
                    const bool is_neck = neck && &body == &bodies.back();
                    (is_neck ? motions.necks : motions.bodies)
                        .push_back({piece.motion, body, point, order});
                }
            }
        }
    }
    return motions;
}

std::vector<ToolPiece> earlier_motions(const TurningHistory& history, std::int32_t point)
{
    std::vector<ToolPiece> pieces;
    for (const EarlierTurningRun& run : history.runs)
        for (std::size_t k = run.stands_at_first ? 0 : 1; k < run.poses.size(); ++k)
            add_pieces(pieces,
                       {motion_between(run, k == 0 ? 0 : k - 1, k), run.cutter, point, 0},
                       infinite, most_halvings);
    std::int32_t order = 0;
    for (ToolPiece& piece : pieces)
        piece.order = ++order;
    return pieces;
}

}  // namespace endmill
