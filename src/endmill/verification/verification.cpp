// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/verification.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/deviation/detail/part_gap.h"
#include "endmill/stock/stock_memory.h"
#include "endmill/surface/extent.h"
#include "endmill/verification/detail/stock_ray.h"

namespace endmill {
namespace {

constexpr double below = 1;  // mm of material under the lowest of part and tips
constexpr double above = 1;  // mm over the part
// Of the memory of a move of an earlier run: its tip, its sweep, and its place in a tree.
constexpr double bytes_an_earlier_move = 200;
constexpr double gib = 1024.0 * 1024 * 1024;
// A ray's place in the deviation, its share of a tile, and room for what grows.
constexpr double bytes_a_ray = 16;
constexpr double most_rays = 4e9;
// Cells are somewhat smaller than the pitch, to be whole numbers along the part.
constexpr double spare = 1.05;
// Of the memory, for a closer look at rapids, and at shank and holder.
constexpr double finer_share = 0.125;

Block bounding_box(const Part& part)
{
    Block box{Vec3::Constant(std::numeric_limits<double>::infinity()),
              Vec3::Constant(-std::numeric_limits<double>::infinity())};
    if (const auto* mesh = std::get_if<TriangleMesh>(&part)) {
        for (const Triangle& triangle : mesh->triangles())
            for (const std::int32_t corner : triangle) {
                const Vec3& point = mesh->points()[static_cast<std::size_t>(corner)];
                box.low = box.low.cwiseMin(point);
                box.high = box.high.cwiseMax(point);
            }
        return box;
    }
    for (int c = 0; c < 3; ++c) {
        const Interval along =
            extent(std::get<std::vector<Surface>>(part), Vec3::Unit(c));
        box.low[c] = along.low;
        box.high[c] = along.high;
    }
    return box;
}

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

// As many of ten to the power of what a number of so many digits is counted in.
double units_of(double value, int digits)
{
    return std::pow(10, digits - 1 - std::floor(std::log10(value)));
}

// What stock and rays of a verification take at a resolution, in bytes.
class MemoryNeed {
public:
    explicit MemoryNeed(const VerificationTask& task)
        : task_{task},
          area_{task.part ? area_of(*task.part) : 0}
    {
    }

    double rays(double resolution) const
    {
        return area_ / (resolution * resolution) * bytes_a_ray;
    }

    // A stock that is given has a pitch of its own.
    double both(double resolution) const
    {
        const double pitch = task_.stock ? task_.stock->grid().pitch : resolution;
        const double moves =
            task_.history ? static_cast<double>(sweep_count(*task_.history)) : 0;
        return rays(resolution) + moves * bytes_an_earlier_move +
               required_bytes(task_.block, pitch, task_.extra_bytes_per_cell);
    }

    // The least resolution of two digits at which both fit, coarser than `resolution`.
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
    // Below the step of two digits, so that none is left out.
    static constexpr double two_digit_step = 0.005;

    static double rounded_up(double value)
    {
        const double units = units_of(value, 2);
        return std::ceil(value * units) / units;
    }

    const VerificationTask& task_;
    double area_;
};

// Three digits, rounded down.
std::string at_least_text(double value)
{
    if (!(value > 0) || !std::isfinite(value))
        return to_text(value);
    const double units = units_of(value, 3);
    return to_text(std::floor(value * units) / units);
}

std::string why_nothing_is_cut(double gap)
{
    if (!std::isfinite(gap))
        return "it has no move, or the part has no side that faces the tool";
    if (!(gap > 0))
        return "the cutter is beside or under the part, nearer than can be told; "
               "expected a move over the part, into the stock";
    return "cutter and part are at least " + at_least_text(gap) + " mm apart";
}

// Stock and rays live at the same time.
void require_fitting(const VerificationTask& task)
{
    require(std::isfinite(task.resolution) && task.resolution > 0,
            "verify_path: need 0 < resolution");
    const double limit = task.max_memory_gib * gib;
    const double extra = task.extra_bytes_per_cell;
    if (!task.part || task.stock)
        require_stock_memory(task.block,
                             task.stock ? task.stock->grid().pitch : task.resolution,
                             limit / gib, extra);
    const MemoryNeed need{task};
    const double bytes = need.both(task.resolution);
    if (!task.part ||
        (bytes <= limit && need.rays(task.resolution) <= most_rays * bytes_a_ray))
        return;
    const double fixed =
        task.stock ? need.both(std::numeric_limits<double>::infinity())
                   : required_bytes(task.block, longest_side(task.block), extra);
    std::string proposal;
    if (fixed < limit)
        proposal = ", which a resolution of " +
                   to_text(need.fitting_resolution(task.resolution, limit)) + " mm fits";
    throw LimitError{"a part of " + to_text(std::round(need.area())) +
                     " mm2 and its stock at a resolution of " + to_text(task.resolution) +
                     " mm would need about " + to_text(std::ceil(bytes / gib * 10) / 10) +
                     " GiB; expected at most " + to_text(task.max_memory_gib) +
                     " GiB (--max-memory)" + proposal};
}

MownRay ray_before(const VerificationTask& task, const PartRay& ray)
{
    if (task.history)
        return ray_in_block(task.history->block, ray);
    return task.stock ? ray_in_stock(*task.stock, ray) : ray_in_block(task.block, ray);
}

void require_cutting(const VerificationTask& task, const PartCharts& charts,
                     const JoinedSweeps& all, const Deviation& deviation)
{
    if (all.earlier() > 0 ? deviation.is_cut_by_path : deviation.is_cut)
        return;
    const SweepTree own{all.own()};
    if (!passes_over(charts, own, task.block.high.z()))
        throw GeometryError{"the path cuts nothing over the part: " +
                            why_nothing_is_cut(part_gap(charts, own))};
}

std::optional<Deviation> deviation_of(const VerificationTask& task)
{
    if (!task.part)
        return std::nullopt;
    const PartCharts charts = part_charts(*task.part);
    const JoinedSweeps all{task.history, *task.path, task.cutter};
    const SweepTree tree{all.all()};
    DeviationOptions options = task.deviation;
    options.pitch = task.resolution;
    options.most_cells = static_cast<std::size_t>(most_rays);
    options.stock = [&](const PartRay& ray) { return ray_before(task, ray); };
    options.earlier_sweeps = all.earlier();
    Deviation deviation = measure_deviation(charts, tree, options);
    require_cutting(task, charts, all, deviation);
    for (auto* place : {&deviation.deepest, &deviation.highest})
        if (*place)
            (*place)->sweep = all.point_of((*place)->sweep);
    return deviation;
}

// Of a stock that is no block nothing is known between its cells.
StockContacts contacts_with_stock(const VerificationTask& task, const Removal& removal,
                                  const StockGrid& grid)
{
    const FinerContacts finer{*task.path, task.cutter, task.body,
                              finer_share * task.max_memory_gib * gib};
    return task.stock ? contacts_of(removal, grid, task.block.high.z(), finer)
                      : finer_contacts(removal, task.block, grid, finer);
}

Verdict verdict_of(const Verification& found, const DeviationLimits& limits)
{
    if (found.contacts.rapid_cuts.count > 0 || found.contacts.collisions.count > 0 ||
        found.part_collisions.moves.count > 0)
        return Verdict::Gouged;
    const Verdict of_rest =
        found.deviation ? verdict(*found.deviation, limits) : Verdict::Clean;
    const EarlierGouge& earlier = found.earlier_gouge;
    const bool is_open =
        found.part_collisions.bound_mm > closed_contact_bound ||
        earlier.found_mm + earlier.bound_mm > limits.tolerance + verdict_slack;
    return is_open && of_rest != Verdict::Gouged ? Verdict::Undecided : of_rest;
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
            "the path has no cutting move; expected one, a part or a "
            "stock to tell where the material is"};
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

Deviation deviation_in_block(const Part& part, const ToolPath& path, const Cutter& cutter,
                             DeviationOptions options)
{
    const Block block = default_block(&part, path, cutter);
    options.stock = [&block](const PartRay& ray) { return ray_in_block(block, ray); };
    const PartCharts charts = part_charts(part);
    const std::vector<StraightSweep> sweeps = path_sweeps(path, cutter);
    return measure_deviation(charts, SweepTree{sweeps}, options);
}

std::optional<StockHistory> history_of_rest(const VerificationTask& task)
{
    if (task.stock && !task.history)
        return std::nullopt;
    StockHistory history = task.history ? *task.history : StockHistory{task.block, {}};
    history.runs.push_back(run_along(*task.path, task.cutter));
    return history;
}

Verification verify_path(const VerificationTask& task)
{
    require(task.path != nullptr, "verify_path: need a path");
    require_fitting(task);
    std::optional<Deviation> deviation = deviation_of(task);
    HeightStock rest =
        task.stock ? *task.stock : block_stock(task.block, task.resolution);
    Removal removal = remove_along(rest, *task.path, task.cutter, {task.body});
    PartCollisions in_part;
    if (task.part)
        in_part = part_collisions(*task.part, *task.path, task.cutter, task.body,
                                  finer_share * task.max_memory_gib * gib);
    const StockContacts contacts = contacts_with_stock(task, removal, rest.grid());
    removal.rapid_cuts = contacts.rapid_cuts;
    removal.collisions = contacts.collisions;
    Verification found{.deviation = std::move(deviation),
                       .removal = std::move(removal),
                       .contacts = contacts,
                       .part_collisions = std::move(in_part),
                       .earlier_moves = {},
                       .earlier_gouge = {},
                       .rest = std::move(rest),
                       .verdict = Verdict::Clean};
    if (task.history)
        found.earlier_moves = sweep_count(*task.history);
    if (task.stock && !task.history && found.deviation)
        found.earlier_gouge =
            earlier_gouge(part_charts(*task.part), found.deviation->tiles, *task.stock);
    found.verdict = verdict_of(found, task.deviation.limits);
    return found;
}

}  // namespace endmill
