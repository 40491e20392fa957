// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/verification.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/detail/units.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/deviation/detail/deviation_measurement.h"
#include "endmill/deviation/detail/part_gap.h"
#include "endmill/stock/detail/sweep_tree.h"
#include "endmill/surface/extent.h"
#include "endmill/verification/detail/earlier_gouge.h"
#include "endmill/verification/detail/finer_contacts.h"
#include "endmill/verification/detail/part_box.h"
#include "endmill/verification/detail/part_collisions.h"
#include "endmill/verification/detail/stock_ray.h"
#include "endmill/verification/detail/tool_runs.h"
#include "endmill/verification/detail/turning_verification.h"

namespace endmill {
namespace {

constexpr double below = 1;  // mm of material below the lowest of part and tips
constexpr double above = 1;  // mm of material above the part
// Memory per move of an earlier run: its tip, its sweep and its place in the tree.
constexpr double bytes_an_earlier_move = 200;
// Memory per ray: its entries in the deviation, its share of a tile, and room for growing
// vectors.
constexpr double bytes_a_ray = 16;
// Limit of the number of rays.
constexpr double most_rays = 4e9;
// Approximate number of first rays by which deviation_of_path measures a part.
constexpr double rays_of_a_path = 1e5;
// Cells are up to this factor smaller in area than the square of the pitch, because a
// side has a whole number of them.
constexpr double spare = 1.05;
// Share of the memory for finer cells, and for the triangles against which shank and
// holder are tested.
constexpr double finer_share = 0.125;

// The path of the task with its tools, which it must outlive.
ChangingTool changing_tool(const VerificationTask& task)
{
    return {*task.path, task.cutter, task.body, task.changes};
}

// Returns the kept stock of the task; null if the stock is a block.
const KeptStock* kept_stock(const VerificationTask& task)
{
    require(!std::holds_alternative<const KeptDexels*>(task.stock),
            "verify_path: three axes take no stock of dexels");
    const auto* kept = std::get_if<const KeptStock*>(&task.stock);
    return kept ? *kept : nullptr;
}

// Returns the history of the kept stock; null if there is none.
const StockHistory* history_of(const VerificationTask& task)
{
    const KeptStock* kept = kept_stock(task);
    return kept && kept->history ? &*kept->history : nullptr;
}

// Returns the box that holds all material before the path.
Block stock_box(const VerificationTask& task)
{
    const KeptStock* kept = kept_stock(task);
    return kept ? material_box(kept->heights) : std::get<Block>(task.stock);
}

// Area of the part, mm^2.
double area_of(const Part& part)
{
    double sum = 0;
    if (const auto* mesh = std::get_if<TriangleMesh>(&part)) {
        for (std::size_t i = 0; i < mesh->triangles().size(); ++i) {
            const auto [a, b, c] = mesh->corners(i);
            sum += (b - a).cross(c - a).norm() / 2;
        }
        return sum;
    }
    for (const Surface& surface : std::get<std::vector<Surface>>(part))
        sum += area(surface);
    return sum;
}

double longest_side(const Block& block)
{
    return (block.high - block.low).maxCoeff();
}

// Returns the power of ten by which a number is multiplied so that it has this many
// digits before the point.
double units_of(double value, int digits)
{
    return std::pow(10, digits - 1 - std::floor(std::log10(value)));
}

// Estimates the memory of stock and rays at a resolution, in bytes.
class MemoryNeed {
public:
    explicit MemoryNeed(const VerificationTask& task)
        : area_{task.judged ? area_of(*task.judged->part) : 0},
          box_{stock_box(task)},
          extra_bytes_per_cell_{task.extra_bytes_per_cell}
    {
        if (const KeptStock* kept = kept_stock(task))
            pitch_ = kept->heights.grid().pitch;
        if (const StockHistory* history = history_of(task))
            earlier_moves_ = static_cast<double>(sweep_count(*history));
    }

    double rays(double resolution) const
    {
        return area_ / (resolution * resolution) * bytes_a_ray;
    }

    // A kept stock has its own pitch, whatever the resolution.
    double both(double resolution) const
    {
        return rays(resolution) + earlier_moves_ * bytes_an_earlier_move +
               required_bytes(box_, pitch_.value_or(resolution), extra_bytes_per_cell_);
    }

    // Returns the least resolution of two digits, not below `resolution`, at which stock
    // and rays fit.
    double fitting_resolution(double resolution, double bytes) const
    {
        const double least =
            std::max(resolution, std::sqrt(spare * area_ * bytes_a_ray /
                                           std::min(bytes, most_rays * bytes_a_ray)));
        double fitting = rounded_up(least);
        while (both(fitting) > bytes)
            fitting = rounded_up(fitting * (1 + two_digit_step));
        return fitting;
    }

    double area() const { return area_; }  // mm^2

private:
    // Smaller than the step between two numbers of two digits, so that none is skipped.
    static constexpr double two_digit_step = 0.005;

    static double rounded_up(double value)
    {
        const double units = units_of(value, 2);
        return std::ceil(value * units) / units;
    }

    double area_;
    Block box_;
    double extra_bytes_per_cell_;
    std::optional<double> pitch_;
    double earlier_moves_ = 0;
};

// Returns the number with three digits, rounded down.
std::string at_least_text(double value)
{
    if (!(value > 0) || !std::isfinite(value))
        return to_text(value);
    const double units = units_of(value, 3);
    return to_text(std::floor(value * units) / units);
}

// Explains a path that cuts nothing over the part.
std::string why_nothing_is_cut(double gap)
{
    if (!std::isfinite(gap))
        return "it has no move, or the part has no side that faces the tool";
    if (!(gap > 0))
        return "the cutter is beside or under the part, too close for a distance; "
               "expected a move over the part, into the stock";
    return "cutter and part are at least " + at_least_text(gap) + " mm apart";
}

// Checks the memory. Stock and rays exist at the same time.
void require_fitting(const VerificationTask& task)
{
    require(std::isfinite(task.resolution) && task.resolution > 0,
            "verify_path: need 0 < resolution");
    const double limit = task.max_memory_gib * bytes_per_gib;
    const double extra = task.extra_bytes_per_cell;
    const KeptStock* kept = kept_stock(task);
    const Block box = stock_box(task);
    if (!task.judged || kept)
        require_stock_memory(box, kept ? kept->heights.grid().pitch : task.resolution,
                             limit / bytes_per_gib, extra);
    const MemoryNeed need{task};
    const double bytes = need.both(task.resolution);
    if (!task.judged ||
        (bytes <= limit && need.rays(task.resolution) <= most_rays * bytes_a_ray))
        return;
    const double fixed = kept ? need.both(std::numeric_limits<double>::infinity())
                              : required_bytes(box, longest_side(box), extra);
    std::string proposal;
    if (fixed < limit)
        proposal = ", which a resolution of " +
                   to_text(need.fitting_resolution(task.resolution, limit)) + " mm fits";
    throw LimitError{"a part of " + to_text(std::round(need.area())) +
                     " mm2 and its stock at a resolution of " + to_text(task.resolution) +
                     " mm would need about " +
                     to_text(std::ceil(bytes / bytes_per_gib * 10) / 10) +
                     " GiB; expected at most " + to_text(task.max_memory_gib) +
                     " GiB (--max-memory)" + proposal};
}

// Returns the material on a ray before the path. The history describes the stock exactly,
// so it is preferred to the heights.
InitialRay initial_ray_of(const VerificationTask& task)
{
    if (const StockHistory* history = history_of(task))
        return
            [history](const PartRay& ray) { return ray_in_block(history->block, ray); };
    if (const KeptStock* kept = kept_stock(task))
        return [kept](const PartRay& ray) { return ray_in_stock(kept->heights, ray); };
    return [block = std::get<Block>(task.stock)](const PartRay& ray) {
        return ray_in_block(block, ray);
    };
}

// Refuses a path that cuts nothing over the part. If rays show no cut, the overlap of
// path and part is tested directly.
void require_cutting(const VerificationTask& task, const PartCharts& charts,
                     const JoinedSweeps& all, const Deviation& deviation)
{
    if (all.earlier() > 0 ? deviation.is_cut_by_path : deviation.is_cut)
        return;
    const SweepTree own{all.own()};
    if (!passes_over(charts, own, stock_box(task).high.z()))
        throw GeometryError{"the path cuts nothing over the part: " +
                            why_nothing_is_cut(part_gap(charts, own))};
}

// The sweeps of all runs.
std::vector<StraightSweep> sweeps_of(std::span<const ToolRun> runs)
{
    std::vector<StraightSweep> sweeps;
    for (const ToolRun& run : runs) {
        const std::vector<StraightSweep> own = path_sweeps(run.path, run.cutter);
        sweeps.insert(sweeps.end(), own.begin(), own.end());
    }
    return sweeps;
}

// The contacts of shank and holder of all runs with the part.
PartCollisions collisions_of(std::span<const ToolRun> runs, const Part& part,
                             double most_bytes)
{
    PartCollisions all;
    for (const ToolRun& run : runs) {
        PartCollisions found =
            part_collisions(part, run.path, run.cutter, run.body, most_bytes);
        if (found.deepest && found.moves.deepest > all.moves.deepest)
            all.deepest = {found.deepest->point, found.deepest->move + run.offset};
        all.moves.count += found.moves.count;
        if (!all.moves.first && found.moves.first)
            all.moves.first = *found.moves.first + run.offset;
        all.moves.deepest = std::max(all.moves.deepest, found.moves.deepest);
        all.error_mm = std::max(all.error_mm, found.error_mm);
        all.bound_mm = std::max(all.bound_mm, found.bound_mm);
    }
    return all;
}

// Measures the deviation from the part.
Deviation deviation_of(const VerificationTask& task, std::span<const ToolRun> runs,
                       const JudgedPart& judged)
{
    const PartCharts charts = part_charts(*judged.part);
    const JoinedSweeps all{history_of(task), sweeps_of(runs), task.path->points.size()};
    const MachinedStock stock{all.all(), all.earlier(), initial_ray_of(task)};
    Deviation deviation =
        measure_deviation(charts, stock,
                          {.limits = judged.limits,
                           .pitch = task.resolution,
                           .max_refine = judged.max_refine,
                           .most_cells = static_cast<std::size_t>(most_rays),
                           .is_accessible = judged.is_accessible,
                           .skipped_facets = judged.skipped_facets,
                           .progress = judged.progress});
    require_cutting(task, charts, all, deviation);
    for (auto* place : {&deviation.deepest, &deviation.highest})
        if (*place)
            (*place)->sweep = all.point_of((*place)->sweep);
    return deviation;
}

// A kept stock is known only at the centres of its cells, so finer cells cannot show
// more.
StockContacts contacts_with_stock(const VerificationTask& task,
                                  std::span<const ToolRun> runs, const Removal& removal,
                                  const StockGrid& grid)
{
    const ToolRun& first = runs.front();
    const FinerContacts finer{first.path, first.cutter, first.body,
                              finer_share * task.max_memory_gib * bytes_per_gib,
                              runs.subspan(1)};
    const Block box = stock_box(task);
    return kept_stock(task) ? contacts_of(removal, grid, box.high.z(), finer)
                            : finer_contacts(removal, box, grid, finer);
}

}  // namespace

Block default_block(const Part* part, const ToolPath& path, const Cutter& cutter)
{
    Block tips{Vec3::Constant(std::numeric_limits<double>::infinity()),
               Vec3::Constant(-std::numeric_limits<double>::infinity())};
    const auto add = [&](std::size_t number) {
        const Vec3& tip = path.points[number].location.tip;
        tips.low = tips.low.cwiseMin(tip);
        tips.high = tips.high.cwiseMax(tip);
    };
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const Move move = path.points[k].move;
        const bool cuts_along = move == Move::Cut || move == Move::Link;
        if (cuts_along || move == Move::Plunge)
            add(k);
        if (cuts_along && k > 0)
            add(k - 1);
    }
    if (!part && !tips.low.allFinite())
        throw GeometryError{
            "the path has no cutting move; expected a cutting move, a part or a stock, "
            "which define where the material is"};
    Block block = part ? bounding_box(*part) : tips;
    if (!block.low.allFinite())
        throw GeometryError{"the part is empty"};
    const Vec3 sideways{cutter.radius(), cutter.radius(), 0};
    const double lowest = std::min(block.low.z(), tips.low.z()) - below;
    block.low -= sideways;
    block.high += sideways;
    block.low.z() = lowest;
    block.high.z() += part ? above : 0;
    return block;
}

namespace {

// The cut whose deviation is measured.
struct Cut {
    const ToolPath& path;
    const Cutter& cutter;
};

Deviation measured_in_block(const Part& part, const Cut& cut,
                            const DeviationOptions& options,
                            const std::optional<DeviationLimits>& proved)
{
    const Block block = default_block(&part, cut.path, cut.cutter);
    const std::vector<StraightSweep> sweeps = path_sweeps(cut.path, cut.cutter);
    const MachinedStock stock{
        sweeps, 0, [&block](const PartRay& ray) { return ray_in_block(block, ray); },
        proved};
    return measure_deviation(part_charts(part), stock, options);
}

}  // namespace

Deviation deviation_in_block(const Part& part, const ToolPath& path, const Cutter& cutter,
                             const DeviationOptions& options)
{
    return measured_in_block(part, {path, cutter}, options, std::nullopt);
}

Deviation deviation_of_path(const Part& part, const ToolPath& path, const Cutter& cutter,
                            const PathDeviationOptions& options)
{
    // The removal refuses an axis that changes.
    const Eigen::Matrix3d rotation =
        upright_rotation(fixed_axis(path).value_or(Vec3::UnitZ()));
    DeviationOptions measure;
    measure.limits = options.limits;
    measure.pitch = std::sqrt(area_of(part) / rays_of_a_path);
    measure.is_accessible = options.is_accessible;
    measure.progress = options.progress;
    std::optional<DeviationLimits> proved;
    if (options.proof != LimitProof::None)
        proved = options.limits;
    if (options.proof == LimitProof::GougeProved)
        proved->scallop = std::numeric_limits<double>::infinity();
    const ToolPath upright = turned(path, rotation);
    return measured_in_block(turned(part, rotation), {upright, cutter}, measure, proved);
}

std::optional<StockHistory> history_of_rest(const VerificationTask& task)
{
    if (task.engine == RemovalEngine::FiveAxis)
        return std::nullopt;
    const KeptStock* kept = kept_stock(task);
    if (kept && !kept->history)
        return std::nullopt;
    StockHistory history =
        kept ? *kept->history : StockHistory{std::get<Block>(task.stock), {}};
    const ToolRuns runs{changing_tool(task)};
    for (const ToolRun& run : runs.list())
        history.runs.push_back(run_along(run.path, run.cutter));
    return history;
}

std::optional<TurningHistory> turning_history_of_rest(const VerificationTask& task)
{
    if (task.engine != RemovalEngine::FiveAxis)
        return std::nullopt;
    return history_of_turning_rest(task);
}

Verification verify_path(const VerificationTask& task)
{
    require(task.path != nullptr, "verify_path: need a path");
    require(!task.judged || task.judged->part != nullptr, "verify_path: need a part");
    if (task.engine == RemovalEngine::FiveAxis)
        return verify_turning_path(task);
    const ToolRuns tools{changing_tool(task)};
    const std::span<const ToolRun> runs = tools.list();
    require_fitting(task);
    const KeptStock* kept = kept_stock(task);
    std::optional<PartFindings> on_part;
    if (const auto& judged = task.judged)
        on_part = PartFindings{.limits = judged->limits,
                               .deviation = deviation_of(task, runs, *judged),
                               .collisions = {}};
    HeightStock rest =
        kept ? kept->heights : block_stock(std::get<Block>(task.stock), task.resolution);
    Removal removal = remove_along(rest, runs);
    if (on_part)
        on_part->collisions = collisions_of(
            runs, *task.judged->part, finer_share * task.max_memory_gib * bytes_per_gib);
    const StockContacts contacts = contacts_with_stock(task, runs, removal, rest.grid());
    removal.rapid_cuts = contacts.rapid_cuts;
    removal.collisions = contacts.collisions;
    Verification found{.on_part = std::move(on_part),
                       .removal = std::move(removal),
                       .contacts = contacts,
                       .earlier_moves = {},
                       .rest = std::move(rest),
                       .removed_bounds = {},
                       .verdict = Verdict::Clean};
    if (const StockHistory* history = history_of(task))
        found.earlier_moves = sweep_count(*history);
    else if (kept && found.on_part)
        found.on_part->earlier_gouge =
            earlier_gouge(part_charts(*task.judged->part), found.on_part->deviation.tiles,
                          kept->heights);
    found.verdict = verdict_with_contacts(found);
    return found;
}

}  // namespace endmill
