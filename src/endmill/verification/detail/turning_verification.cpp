// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/turning_verification.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/cutter/straight_sweep.h"
#include "endmill/deviation/detail/deviation_measurement.h"
#include "endmill/deviation/detail/turning_measurement.h"
#include "endmill/stock/detail/dexel_removal.h"
#include "endmill/stock/detail/removable_path.h"
#include "endmill/verification/detail/earlier_gouge.h"
#include "endmill/verification/detail/part_box.h"
#include "endmill/verification/detail/tool_runs.h"
#include "endmill/verification/detail/turning_contacts.h"
#include "endmill/verification/detail/turning_motions.h"
#include "endmill/verification/detail/turning_stock.h"

namespace endmill {
namespace {

// A rapid, or shank or holder, is in the material for certain if more than this is
// removed on a ray, in mm: a few units of the dexels.
constexpr double certain_contact = 1e-5;
// Cells at work in the search for contacts with the part.
constexpr std::size_t most_contact_cells = 4'000'000;
// Greatest difference of a unit axis from +z. It moves places a metre up the tool by no more
// than the rounding of a distance.
constexpr double upright_tolerance = 1e-13;
// Limit of coordinates, as for heights.
constexpr double largest_coordinate = 1e9;  // mm

// A ball that holds the stock and the part.
Sphere region_of(const VerificationTask& task, const Block& block, const Block& part)
{
    const Vec3 low = block.low.cwiseMin(part.low);
    const Vec3 high = block.high.cwiseMax(part.high);
    // Rays may start half a pitch beside the part, and end at the block.
    return {(low + high) / 2, (high - low).norm() / 2 * 1.01 + task.resolution};
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

// Returns a distance in whole micrometres, rounded down.
std::string gap_text(double gap)
{
    return to_text(std::floor(gap * 1000) / 1000);
}

// Returns the sweeps of pieces if all of them are straight moves of endless cutters along
// +z; else nothing.
std::optional<std::vector<StraightSweep>> upright_sweeps(
    std::span<const ToolPiece> pieces)
{
    std::vector<StraightSweep> sweeps;
    sweeps.reserve(pieces.size());
    for (const ToolPiece& piece : pieces) {
        const auto& [tip, axes] = piece.motion.from();
        if (piece.motion.turn() != 0 || std::isfinite(piece.body.length()) ||
            !((axes.col(2) - Vec3::UnitZ()).norm() <= upright_tolerance))
            return std::nullopt;
        sweeps.emplace_back(piece.body.cutter(), tip, piece.motion.to().tip);
    }
    return sweeps;
}

// The motions that the deviation is judged by.
struct JudgedMotions {
    std::vector<ToolPiece> pieces;  // those of earlier runs first
    std::size_t earlier;            // number of them
    Sphere region;                  // holds part and stock
};

// Measures the deviation. Without a turn, the straight approximation of a motion is its
// sweep, so that the closed forms of three axes hold.
TurningDeviation deviation_of(const VerificationTask& task, const PartCharts& charts,
                              JudgedMotions motions, const TurningStock& before)
{
    const JudgedPart& judged = *task.judged;
    const DeviationOptions options{.limits = judged.limits,
                                   .pitch = task.resolution,
                                   .max_refine = judged.max_refine,
                                   .is_accessible = judged.is_accessible,
                                   .skipped_facets = judged.skipped_facets,
                                   .progress = judged.progress};
    if (const auto sweeps = upright_sweeps(motions.pieces)) {
        Deviation found = measure_deviation(
            charts, MachinedStock{*sweeps, motions.earlier, before.initial_ray()},
            options);
        for (auto* place : {&found.deepest, &found.highest})
            if (*place && (*place)->sweep >= 0)
                (*place)->sweep =
                    motions.pieces[static_cast<std::size_t>((*place)->sweep)].point;
        // Where nothing is cut, the distance is measured below.
        if (found.is_cut)
            return {std::move(found), 0};
    }
    const ToolPieces cutters{std::move(motions.pieces), motions.region};
    return measure_turning_deviation(charts, {cutters, before.initial_ray()}, options);
}

PartFindings findings_on(const VerificationTask& task, const PartCharts& charts,
                         JudgedMotions motions, const TurningStock& before)
{
    TurningDeviation found = deviation_of(task, charts, std::move(motions), before);
    // With earlier runs the gap is that of all cutters; a path that cuts elsewhere is then
    // not refused.
    if (!found.deviation.is_cut && !before.earlier_moves())
        throw GeometryError{
            "the path cuts nothing over the part: " +
            (std::isfinite(found.gap_mm) && found.gap_mm > 0
                 ? "cutter and part are at least " + gap_text(found.gap_mm) + " mm apart"
                 : "it has no move beside the part, or the part has no side that faces "
                   "the tool")};
    // Moves of earlier runs are numbered behind the points of the path.
    for (auto* place : {&found.deviation.deepest, &found.deviation.highest})
        if (*place &&
            (*place)->sweep >= static_cast<std::int32_t>(task.path->points.size()))
            (*place)->sweep = by_earlier_run;
    PartFindings findings{.limits = task.judged->limits,
                          .deviation = std::move(found.deviation),
                          .collisions = {}};
    if (const HeightStock* heights = before.heights_only())
        findings.earlier_gouge =
            earlier_gouge(charts, findings.deviation.tiles, *heights);
    return findings;
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

// The range of the upper ends of the material on the rays along z; nothing without any.
std::optional<HeightRange> height_range(const DexelStock& stock)
{
    const DexelField& field = stock.field(2);
    std::optional<HeightRange> range;
    for (int row = 0; row < field.rows(); ++row)
        for (int column = 0; column < field.columns(); ++column) {
            const auto upper = field.upper(column, row);
            if (upper.empty())
                continue;
            const double top = stock.block().low.z() + upper.back().to * stock.unit();
            if (!range)
                range = HeightRange{top, top};
            range->low = std::min(range->low, top);
            range->high = std::max(range->high, top);
        }
    return range;
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
    require_finite(*task.path);
    const TurningStock before{task};
    const ToolRuns tools{
        {*task.path, task.cutter, task.body, task.changes, task.cutting_length}};
    TurningMotions motions = motions_along(*task.path, tools.list());
    const Sphere region =
        region_of(task, before.box(),
                  task.judged ? bounding_box(*task.judged->part) : before.box());
    const ToolPieces bodies{motions.bodies, region};
    std::optional<PartFindings> on_part;
    if (task.judged) {
        JudgedMotions all{
            before.earlier_motions(static_cast<std::int32_t>(task.path->points.size())),
            0, region};
        all.earlier = all.pieces.size();
        all.pieces.insert(all.pieces.end(), motions.cutters.begin(),
                          motions.cutters.end());
        const PartCharts charts = judged_charts(task);
        on_part = findings_on(task, charts, std::move(all), before);
        on_part->collisions =
            turning_contacts(charts, bodies, task.resolution, most_contact_cells);
    }
    const ToolPieces cutters{std::move(motions.cutters), region};
    motions.bodies.insert(motions.bodies.end(), motions.necks.begin(),
                          motions.necks.end());
    const ToolPieces not_cutting{std::move(motions.bodies), region};
    DexelStock rest = before.dexels();
    const DexelRemoval removed = remove_from_dexels(
        rest, {cutters, not_cutting, task.path->points.size()}, task.progress);
    const StockContacts contacts = contacts_of(*task.path, removed, before.pitch());
    Verification found{.on_part = std::move(on_part),
                       .removal = removal_of(removed, contacts),
                       .contacts = contacts,
                       .earlier_moves = before.earlier_moves(),
                       .rest = std::move(rest),
                       .removed_bounds = RemovedBounds{removed.bound, removed.spread},
                       .verdict = Verdict::Clean};
    found.removal.left = height_range(std::get<DexelStock>(found.rest));
    found.verdict = verdict_with_contacts(found);
    return found;
}

std::optional<TurningHistory> history_of_turning_rest(const VerificationTask& task)
{
    const TurningStock before{task};
    std::optional<TurningHistory> history = before.history();
    if (!history)
        return std::nullopt;
    const ToolRuns tools{
        {*task.path, task.cutter, task.body, task.changes, task.cutting_length}};
    history->runs.reserve(history->runs.size() + tools.list().size());
    for (const ToolRun& run : tools.list())
        history->runs.push_back(
            turning_run_along(*task.path, run.offset, run.offset + run.path.points.size(),
                              CuttingBody{run.cutter, run.cutting_length},
                              !run.path.points.empty() && cuts_at_start(run.path)));
    return history;
}

}  // namespace endmill
