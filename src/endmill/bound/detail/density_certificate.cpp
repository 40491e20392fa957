// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/density_certificate.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"

namespace endmill {
namespace {

// Sizes as shares of the width of the disc on a plane: of leaves, of the first boxes, and how
// far surfaces are extended.
constexpr double leaf_share = 0.1;
constexpr double box_share = 0.12;
constexpr double extension_share = 0.8;
// Halvings of a box, in one parameter each.
constexpr int most_halvings = 4;
// Boxes that are evaluated at once.
constexpr std::size_t batch = 2048;
// Share of the integral that may be given up.
constexpr double most_given_up = 0.2;
// Margin for the single precision of places in cells and for rounding in sums.
constexpr double rounding_margin = 1e-6;

struct Task {
    ContactBox box;
    int halvings;
};

ContactBox box_of(std::size_t surface, int i, int j, const ParameterBox& box)
{
    return {{surface, i, j, {(box.u.low + box.u.high) / 2, (box.v.low + box.v.high) / 2}},
            box};
}

std::vector<Task> first_tasks(const DensityGrid& grid, double size)
{
    std::vector<Task> tasks;
    for (const DensityCell& cell : grid.cells()) {
        const auto parts = [&](double length) {
            return std::max(1, static_cast<int>(std::lround(length / size)));
        };
        const int m = parts(cell.length_u);
        const int n = parts(cell.length_v);
        const auto part = [](const Interval& range, int k, int count) -> Interval {
            return {
                std::lerp(range.low, range.high, k / static_cast<double>(count)),
                std::lerp(range.low, range.high, (k + 1) / static_cast<double>(count))};
        };
        for (int b = 0; b < n; ++b)
            for (int a = 0; a < m; ++a)
                tasks.push_back({box_of(cell.surface, cell.i, cell.j,
                                        {part(cell.u, a, m), part(cell.v, b, n)}),
                                 0});
    }
    return tasks;
}

std::pair<Task, Task> halves(const Task& task, bool in_u)
{
    ParameterBox low = task.box.box;
    ParameterBox high = low;
    (in_u ? low.u.high : low.v.high) = in_u ? task.box.middle.at.u : task.box.middle.at.v;
    (in_u ? high.u.low : high.v.low) = in_u ? task.box.middle.at.u : task.box.middle.at.v;
    const ContactPlace& at = task.box.middle;
    return {{box_of(at.surface, at.i, at.j, low), task.halvings + 1},
            {box_of(at.surface, at.i, at.j, high), task.halvings + 1}};
}

}  // namespace

CertifiedDensity certified_density(const BoundedPart& part, const BoundProblem& problem,
                                   std::span<const double> density,
                                   const CertificateOptions& options)
{
    const double width = 2 * plane_half_width(problem);
    const DensityGrid grid{part, options.node_spacing};
    const EnclosureGrid enclosures{
        part, problem, grid, density, leaf_share * width, extension_share * width};
    CertifiedDensity result;
    std::vector<double> divisors(grid.nodes(), 1);
    std::vector<bool> is_given_up(grid.nodes());
    std::string reason;
    std::vector<Task> tasks = first_tasks(grid, box_share * width);
    std::size_t first = 0;
    while (first < tasks.size()) {
        const std::size_t count = std::min(batch, tasks.size() - first);
        std::vector<CertifiedInflow> found(count);
        parallel_for(count, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k)
                found[k] = certified_inflow(part, problem, grid, density, enclosures,
                                            tasks[first + k].box);
        });
        for (std::size_t k = 0; k < count; ++k) {
            const CertifiedInflow& inflow = found[k];
            const Task task = tasks[first + k];
            ++result.boxes;
            if (inflow.kind == CertifiedInflow::Kind::NoContact)
                continue;
            const bool is_known = inflow.kind == CertifiedInflow::Kind::Bounded;
            if (!(is_known && inflow.inflow <= 1 + options.excess) &&
                task.halvings < most_halvings && tasks.size() < options.most_boxes) {
                const auto [low, high] =
                    halves(task, is_known ? inflow.is_wide_in_u : task.halvings % 2 == 0);
                tasks.push_back(low);
                tasks.push_back(high);
                continue;
            }
            if (is_known) {
                result.greatest_inflow = std::max(result.greatest_inflow, inflow.inflow);
                result.greatest_disc = std::max(result.greatest_disc, inflow.disc);
            } else if (reason.empty())
                reason =
                    std::string{inflow.reason} + " near " +
                    place_text(task.box.middle.at,
                               part.surfaces[task.box.middle.surface]
                                   .tangents(task.box.middle.at.u, task.box.middle.at.v)
                                   .point);
            if (!is_known && inflow.cells.empty())
                throw GeometryError{"certified_bound: no certificate; " + reason};
            for (const std::uint32_t cell : inflow.cells)
                for (const std::uint32_t node : grid.corners(cell)) {
                    if (is_known)
                        divisors[node] = std::max(divisors[node], inflow.inflow);
                    else
                        is_given_up[node] = true;
                }
        }
        first += count;
        if (options.progress)
            options.progress(static_cast<double>(first) /
                             static_cast<double>(tasks.size()));
    }
    std::vector<double> kept(density.begin(), density.end());
    result.at_nodes = kept;
    for (std::size_t node = 0; node < kept.size(); ++node) {
        if (is_given_up[node])
            kept[node] = 0;
        result.at_nodes[node] = kept[node] / divisors[node];
    }
    const auto sum = [&](std::span<const double> values) {
        return std::inner_product(values.begin(), values.end(), grid.weights().begin(),
                                  0.0);
    };
    result.given_up = 1 - sum(kept) / sum(density);
    if (result.given_up > most_given_up)
        throw GeometryError{"certified_bound: no certificate; " + reason};
    result.integral = (1 - rounding_margin) * enclosures.least_integral(result.at_nodes);
    result.greatest_disc *= 1 + rounding_margin;
    return result;
}

}  // namespace endmill
