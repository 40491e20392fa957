// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/turning_verification.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/deviation/detail/turning_measurement.h"
#include "endmill/stock/detail/dexel_removal.h"
#include "endmill/stock/detail/removable_path.h"
#include "endmill/verification/detail/part_box.h"
#include "endmill/verification/detail/stock_ray.h"
#include "endmill/verification/detail/tool_runs.h"
#include "endmill/verification/detail/turning_contacts.h"

namespace endmill {
namespace {

// Greatest turn of a piece in rad. Motions that turn more are divided first, so that the
// bounding volumes are tight; they are divided further where that is needed.
constexpr double most_turn = 0.03;
constexpr int most_halvings = 12;
// A rapid, or shank or holder, is in the material for certain if more than this is
// removed on a ray, in mm: a few units of the dexels.
constexpr double certain_contact = 1e-5;
// Cells at work in the search for contacts with the part.
constexpr std::size_t most_contact_cells = 4'000'000;
// Limit of coordinates, as for heights.
constexpr double largest_coordinate = 1e9;  // mm

const Block& block_of(const VerificationTask& task)
{
    const auto* block = std::get_if<Block>(&task.stock);
    if (!block)
        throw GeometryError{
            "a stock of heights was given; expected a block for a path with a turning "
            "axis (--stock block, or X0,Y0,Z0,X1,Y1,Z1)"};
    return *block;
}

// A ball that holds the stock and the part.
Sphere region_of(const VerificationTask& task, const Block& part)
{
    const Block& block = block_of(task);
    const Vec3 low = block.low.cwiseMin(part.low);
    const Vec3 high = block.high.cwiseMax(part.high);
    // Rays may start half a pitch beside the part, and end at the block.
    return {(low + high) / 2, (high - low).norm() / 2 * 1.01 + task.resolution};
}

// Adds a motion, divided until its pieces turn little.
void add_pieces(std::vector<ToolPiece>& pieces, const ToolPiece& whole, int halvings)
{
    if (whole.motion.turn() <= most_turn || halvings == 0) {
        pieces.push_back(whole);
        pieces.back().order = static_cast<std::int32_t>(pieces.size());
        return;
    }
    for (const ToolMotion& half : whole.motion.halves())
        add_pieces(pieces, {half, whole.body, whole.point, 0}, halvings - 1);
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

void require_finite(const ToolPath& path)
{
    for (const PathPoint& point : path.points) {
        const Vec3& tip = point.location.tip;
        require(tip.allFinite() && tip.cwiseAbs().maxCoeff() <= largest_coordinate,
                "removal along a path: a tip is not within 1e9 mm");
    }
    require(!path.machine || path.machine->positions.size() == path.points.size(),
            "verify_path: need the positions of the machine at every point");
}

// The motions of all cutters, and of all shanks and holders.
struct Motions {
    std::vector<ToolPiece> cutters;
    std::vector<ToolPiece> bodies;
};

// \param path whole, with the machine that interpolates it.
Motions motions_of(const ToolPath& path, std::span<const ToolRun> runs)
{
    Motions motions;
    std::int32_t order = 0;
    for (const ToolRun& run : runs) {
        const CuttingBody cutter{run.cutter};
        std::vector<CuttingBody> bodies;
        for (const ToolCylinder& cylinder : run.body)
            bodies.push_back(CuttingBody::of_cylinder(cylinder));
        const bool stands = !run.path.points.empty() && cuts_at_start(run.path);
        for (std::size_t k = stands ? 0 : 1; k < run.path.points.size(); ++k) {
            const std::size_t to = k + run.offset;
            const auto point = static_cast<std::int32_t>(to);
            const ToolMotion motion = motion_between(path, k == 0 ? to : to - 1, to);
            std::vector<ToolPiece> pieces;
            add_pieces(pieces, {motion, cutter, point, 0}, most_halvings);
            for (ToolPiece& piece : pieces) {
                piece.order = ++order;
                motions.cutters.push_back(piece);
                for (const CuttingBody& body : bodies)
                    motions.bodies.push_back({piece.motion, body, point, order});
            }
        }
    }
    return motions;
}

// Returns a distance in whole micrometres, rounded down.
std::string gap_text(double gap)
{
    return to_text(std::floor(gap * 1000) / 1000);
}

PartFindings findings_on(const VerificationTask& task, const PartCharts& charts,
                         const ToolPieces& cutters)
{
    const JudgedPart& judged = *task.judged;
    const Block& block = block_of(task);
    const TurnedStock stock{
        cutters, [&block](const PartRay& ray) { return ray_in_block(block, ray); }};
    TurningDeviation found =
        measure_turning_deviation(charts, stock,
                                  {.limits = judged.limits,
                                   .pitch = task.resolution,
                                   .max_refine = judged.max_refine,
                                   .is_accessible = judged.is_accessible,
                                   .skipped_facets = judged.skipped_facets,
                                   .progress = judged.progress});
    if (!found.deviation.is_cut)
        throw GeometryError{
            "the path cuts nothing over the part: " +
            (std::isfinite(found.gap_mm) && found.gap_mm > 0
                 ? "cutter and part are at least " + gap_text(found.gap_mm) + " mm apart"
                 : "it has no move beside the part, or the part has no side that faces "
                   "the tool")};
    return {.limits = judged.limits,
            .deviation = std::move(found.deviation),
            .collisions = {}};
}

// Adds a contact of a move with the stock.
void add_contact(MoveCount& count, std::size_t point, double depth)
{
    if (depth <= certain_contact)
        return;
    ++count.count;
    if (!count.first)
        count.first = point;
    count.deepest = std::max(count.deepest, depth);
}

StockContacts contacts_of(const ToolPath& path, const DexelRemoval& removal, double pitch)
{
    StockContacts contacts;
    // A circle of this diameter contains a ray of one of the fields.
    contacts.width_mm = std::sqrt(2.0) * pitch;
    for (std::size_t k = 0; k < removal.moves.size(); ++k) {
        const DexelMove& move = removal.moves[k];
        const bool is_rapid = path.points[k].move == Move::Rapid;
        if (is_rapid)
            add_contact(contacts.rapid_cuts, k, move.deepest);
        add_contact(contacts.collisions, k, move.body_depth);
        const double possible =
            std::max(is_rapid ? move.most_deep : 0.0, move.most_body_depth);
        if (possible > ignored_contact && !contacts.first_possible)
            contacts.first_possible = k;
        contacts.possible_mm = std::max(contacts.possible_mm, possible);
    }
    return contacts;
}

Removal removal_of(const DexelRemoval& of, const StockContacts& contacts)
{
    Removal removal;
    removal.removed.reserve(of.moves.size());
    removal.deepest.reserve(of.moves.size());
    for (const DexelMove& move : of.moves) {
        removal.removed.push_back(move.removed);
        removal.deepest.push_back(move.deepest);
        if (&move != of.moves.data() && !(move.most_deep > certain_contact))
            ++removal.air_moves;
    }
    removal.total = of.removed;
    removal.rapid_cuts = contacts.rapid_cuts;
    removal.collisions = contacts.collisions;
    return removal;
}

}  // namespace

Verification verify_turning_path(const VerificationTask& task)
{
    require(std::isfinite(task.resolution) && task.resolution > 0,
            "verify_path: need 0 < resolution");
    require_finite(*task.path);
    const Block& block = block_of(task);
    require_dexel_memory(block, task.resolution, task.max_memory_gib);
    const ToolRuns tools{{*task.path, task.cutter, task.body, task.changes}};
    Motions motions = motions_of(*task.path, tools.list());
    const Sphere region =
        region_of(task, task.judged ? bounding_box(*task.judged->part) : block);
    const ToolPieces cutters{std::move(motions.cutters), region};
    const ToolPieces bodies{std::move(motions.bodies), region};
    std::optional<PartFindings> on_part;
    if (task.judged) {
        const PartCharts charts = judged_charts(task);
        on_part = findings_on(task, charts, cutters);
        on_part->collisions =
            turning_contacts(charts, bodies, task.resolution, most_contact_cells);
    }
    DexelStock rest{block, task.resolution};
    const DexelRemoval removed = remove_from_dexels(
        rest, {cutters, bodies, task.path->points.size()}, task.progress);
    const StockContacts contacts = contacts_of(*task.path, removed, task.resolution);
    Verification found{.on_part = std::move(on_part),
                       .removal = removal_of(removed, contacts),
                       .contacts = contacts,
                       .earlier_moves = {},
                       .rest = std::move(rest),
                       .removed_bounds = RemovedBounds{removed.bound, removed.spread},
                       .verdict = Verdict::Clean};
    found.verdict = verdict_with_contacts(found);
    return found;
}

}  // namespace endmill
