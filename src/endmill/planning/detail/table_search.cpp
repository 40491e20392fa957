// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/table_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "endmill/core/error.h"

// Counts of passes and points jump, so that table_loss says little about the way to a better surface.
// structure_loss replaces them by real numbers: passes with a share of the last interval, steps with a share of the
// last step. It is searched in boxes about pairs of curves that nearly have their numbers; the boxes shrink, and the unit of
// the loss with them. Only the last box is searched by table_loss.

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Interval scallop_range{0.3, 1.1};  // h / delta
// Weight of squared percents of deviation against bits.
constexpr double percent_weight = 2;
// The ratio h / delta that pairs are tried with, and those that are predicted from it.
constexpr double first_ratio = 0.5;
constexpr int predicted_ratios = 400;
// Sides of the boxes in which pairs are fitted and refined, as shares of the ranges. The unit of structure_loss is
// as many percent.
constexpr double fitting_box = 0.1;
constexpr std::array refining_boxes{0.03, 0.01, 0.003};
constexpr double cell_box = 0.002;
constexpr int population = 20;

double percent(double value, double target)
{
    return 100 * (value / target - 1);
}

double run_loss(const DirectionCost& run, const DirectionCost& target)
{
    if (is_left_out(target))
        return 0;
    const double points =
        percent(static_cast<double>(run.ncl), static_cast<double>(target.ncl));
    const double travel = percent(run.tcd_mm, target.tcd_mm);
    return deviation_bits(run, target) +
           percent_weight * (points * points + travel * travel);
}

FamilyMember member_of(SurfaceFamily family, std::span<const double> values)
{
    return family_surface(family, values.first(values.size() - 1));
}

// Passes by which the real number of passes misses the interval that gives N passes.
double missing_pass_count(double passes_real, int passes, LastPath last_path)
{
    // With a pass on the border N is the next whole number, without one the last, with the
    // rule of half an interval the nearest.
    const double high = last_path == LastPath::Border ? passes
                        : last_path == LastPath::Half ? passes + 0.5
                                                      : passes + 1;
    const double low = high - 1;
    return std::max({0.0, low - passes_real, passes_real - high});
}

// A surface with the loss by which it was judged.
struct Candidate {
    double loss;
    std::vector<double> values;  // of the family, then h / delta
};

// Real numbers of passes with the largest tolerance. Indices: direction, diameter.
using CoarsePasses = std::array<std::array<double, 3>, 2>;

std::optional<CoarsePasses> coarse_passes(const FamilyMember& member,
                                          RunPolicies policies)
{
    policies.table.scallop_per_tolerance = first_ratio;
    CoarsePasses passes{};
    int runs = 0;
    const auto keep = [&](const RunPlace& at, const TableRun& run) {
        passes[at.direction][at.diameter] = run.passes_real;
        return ++runs < 6;
    };
    if (!visit_runs(member, policies, keep))
        return std::nullopt;
    return passes;
}

// The pair with the ratio h / delta for which it misses the fewest passes with the largest tolerance, judged by
// their squares in percent. The interval grows about with the root of the ratio.
Candidate judged_pair(SurfaceFamily family, const RunPolicies& policies,
                      std::vector<double> values, const DecodedTables& decoded)
{
    const LastPath last_path = policies.table.plan.last_path;
    Candidate pair{infinity, std::move(values)};
    const auto passes = coarse_passes(family_surface(family, pair.values), policies);
    pair.values.push_back(first_ratio);
    if (!passes)
        return pair;
    for (int i = 0; i <= predicted_ratios; ++i) {
        const double ratio = std::lerp(scallop_range.low, scallop_range.high,
                                       i / double(predicted_ratios));
        double squares = 0;
        for (int k = 0; k < 2; ++k)
            for (int j = 0; j < 3; ++j) {
                const int count = decoded.counts[k][0][j];
                if (count == 0)
                    continue;
                const double real =
                    1 + std::sqrt(first_ratio / ratio) * ((*passes)[k][j] - 1);
                const double missing =
                    100 * missing_pass_count(real, count, last_path) / count;
                squares += missing * missing;
            }
        if (squares < pair.loss) {
            pair.loss = squares;
            pair.values.back() = ratio;
        }
    }
    return pair;
}

// log(1 + x^2): quadratic near zero, and nearly indifferent to what is lost anyway.
double mild(double x)
{
    return std::log1p(x * x);
}

// Loss of the steps that the passes of a curve miss.
double step_loss(const std::array<CurveMarch, 3>& marches, const CurveTarget& target,
                 double unit_percent)
{
    double loss = 0;
    for (int i = 0; i < 3; ++i) {
        const PassPair& pair = target[i];
        // Without f, the present one, as far as the sum allows.
        const int forward = pair.points_forward.value_or(
            std::clamp(marches[i].points_forward, pair.points_a_pair / 2 - 1,
                       pair.points_a_pair / 2 + 2));
        const double unit = unit_percent / 100 * pair.points_a_pair / 2;
        loss +=
            mild(missing_steps(marches[i].steps_forward, forward) / unit) +
            mild(missing_steps(marches[i].steps_backward, pair.points_a_pair - forward) /
                 unit);
    }
    return loss;
}

// The stages after the search for curves.
class PairSearch {
public:
    PairSearch(SurfaceFamily family, const RunPolicies& policies,
               const EconomyTables& target, const DecodedTables& decoded,
               const StagedSearch& search)
        : family_{family},
          policies_{policies},
          target_{target},
          decoded_{decoded},
          search_{search},
          ranges_{fit_ranges(family)}
    {
    }

    // All pairs of the curves that exist, those with the fewest missing passes first.
    std::vector<Candidate> pairs(
        const std::array<std::vector<std::vector<double>>, 2>& curves) const
    {
        std::vector<Candidate> pairs;
        const std::array own{curve_positions(family_, 0), curve_positions(family_, 1)};
        std::vector<double> values(value_ranges(family_).size());
        for (const std::vector<double>& a : curves[0])
            for (const std::vector<double>& b : curves[1]) {
                for (std::size_t i = 0; i < a.size(); ++i)
                    values[own[0][i]] = a[i];
                for (std::size_t i = 0; i < b.size(); ++i)
                    values[own[1][i]] = b[i];
                Candidate pair = judged_pair(family_, policies_, values, decoded_);
                if (std::isfinite(pair.loss))
                    pairs.push_back(std::move(pair));
            }
        std::ranges::stable_sort(pairs, {}, &Candidate::loss);
        return pairs;
    }

    // The first of `pairs` judged by structure_loss, the best of them fitted, and the best of these refined.
    TableFit best_fit(std::span<const Candidate> pairs)
    {
        std::vector<Candidate> fits = judged(pairs);
        fits.resize(std::min<std::size_t>(fits.size(), search_.fitted));
        for (Candidate& fit : fits)
            fit = fitted(fit.values, fitting_box);
        std::ranges::stable_sort(fits, {}, &Candidate::loss);
        fits.resize(std::min<std::size_t>(fits.size(), search_.refined));
        TableFit best{{}, infinity, 0};
        for (Candidate& fit : fits) {
            for (const double side : refining_boxes)
                fit = fitted(fit.values, side);
            FoundValues found = minimise(
                box_about(fit.values, ranges_, cell_box),
                [&](std::span<const double> trial, double give_up) {
                    return table_loss(family_, policies_, target_, trial, give_up);
                },
                settings(fit.values));
            evaluations_ += found.evaluations;
            if (found.loss < best.loss)
                best = {std::move(found.values), found.loss, 0};
        }
        best.evaluations = evaluations_;
        return best;
    }

private:
    BoundedSearch settings(const std::vector<double>& start) const
    {
        return {.evaluations = search_.evaluations,
                .seed = search_.seed,
                .population = population,
                .start = {start}};
    }

    // How far a surface is from the numbers of decode and the travel of the target: sum of log(1 + (e / unit)^2) over the
    // deviations e in percent of the travel, as if the numbers of passes were the decoded ones, of the passes and of the
    // steps. It is continuous in the values but for jumps of a step, unlike table_loss. Gives up beyond `give_up`; infinite if
    // a run does not exist.
    double structure_loss(std::span<const double> values, double unit_percent,
                          double give_up) const
    {
        RunPolicies policies = policies_;
        policies.table.scallop_per_tolerance = values.back();
        const FamilyMember member = member_of(family_, values);
        const auto& surface = std::get<TranslationalSurface>(member);
        const std::array marches{march_both_ways(surface.along_u),
                                 march_both_ways(surface.along_v)};
        if (!marches[0] || !marches[1])
            return infinity;
        double loss = step_loss(*marches[0], decoded_.passes[0], unit_percent) +
                      step_loss(*marches[1], decoded_.passes[1], unit_percent);
        const auto add = [&](const RunPlace& at, const TableRun& run) {
            const auto [k, i, j] = at;
            const int passes = decoded_.counts[k][i][j];
            if (passes == 0)
                return true;
            const CurveMarch& march = (*marches[k])[i];
            const double chord = (march.forward_mm + march.backward_mm) / 2;
            const double travel = run.cost.tcd_mm + (passes - run.passes) * chord;
            const double missing = missing_pass_count(run.passes_real, passes,
                                                      policies.table.plan.last_path);
            loss += mild(percent(travel, target_.runs[k][i][j].tcd_mm) / unit_percent) +
                    mild(100 * missing / passes / unit_percent);
            return loss <= give_up;
        };
        if (loss <= give_up && !visit_runs(member, policies, add))
            return infinity;
        return loss;
    }

    std::vector<Candidate> judged(std::span<const Candidate> pairs)
    {
        std::vector<Candidate> candidates;
        for (const Candidate& pair : pairs) {
            if (static_cast<int>(candidates.size()) >= search_.scored)
                break;
            candidates.push_back(
                {structure_loss(pair.values, fitting_box, infinity), pair.values});
            ++evaluations_;
        }
        std::ranges::stable_sort(candidates, {}, &Candidate::loss);
        return candidates;
    }

    // The best values in a box with these sides about `start`.
    Candidate fitted(const std::vector<double>& start, double side)
    {
        FoundValues found = minimise(
            box_about(start, ranges_, side),
            [&](std::span<const double> trial, double give_up) {
                return structure_loss(trial, side, give_up);
            },
            settings(start));
        evaluations_ += found.evaluations;
        return {found.loss, std::move(found.values)};
    }

    SurfaceFamily family_;
    const RunPolicies& policies_;
    const EconomyTables& target_;
    const DecodedTables& decoded_;
    const StagedSearch& search_;
    std::vector<Interval> ranges_;
    int evaluations_ = 0;  // of surfaces
};

}  // namespace

std::vector<Interval> fit_ranges(SurfaceFamily family)
{
    std::vector<Interval> ranges = value_ranges(family);
    ranges.push_back(scallop_range);
    return ranges;
}

std::optional<EconomyTables> fitted_tables(SurfaceFamily family, RunPolicies policies,
                                           std::span<const double> values)
{
    policies.table.scallop_per_tolerance = values.back();
    EconomyTables tables;
    const auto keep = [&](const RunPlace& at, const TableRun& run) {
        tables.runs[at.direction][at.tolerance][at.diameter] = run.cost;
        return true;
    };
    if (!visit_runs(member_of(family, values), policies, keep))
        return std::nullopt;
    return tables;
}

double table_loss(SurfaceFamily family, RunPolicies policies, const EconomyTables& target,
                  std::span<const double> values, double give_up)
{
    policies.table.scallop_per_tolerance = values.back();
    double loss = 0;
    const auto add = [&](const RunPlace& at, const TableRun& run) {
        loss += run_loss(run.cost, target.runs[at.direction][at.tolerance][at.diameter]);
        return loss <= give_up;
    };
    if (!visit_runs(member_of(family, values), policies, add))
        return infinity;
    return loss;
}

TableFit search_cells(SurfaceFamily family, const RunPolicies& policies,
                      const EconomyTables& target, const BoundedSearch& search)
{
    const auto loss = [&](std::span<const double> values, double give_up) {
        return table_loss(family, policies, target, values, give_up);
    };
    FoundValues found = minimise(fit_ranges(family), loss, search);
    return {std::move(found.values), found.loss, found.evaluations};
}

StagedFit search_in_stages(SurfaceFamily family, const RunPolicies& policies,
                           const EconomyTables& target, const DecodedTables& decoded,
                           const StagedSearch& search)
{
    require(family == SurfaceFamily::Translational || family == SurfaceFamily::Uneven ||
                family == SurfaceFamily::Skew,
            "search_in_stages: need a family with free curves");
    std::array<std::vector<std::vector<double>>, 2> curves;
    for (int k = 0; k < 2; ++k)
        curves[k] = search_curves(family, k, decoded.passes[k], search.curves);
    StagedFit fit{
        {static_cast<int>(curves[0].size()), static_cast<int>(curves[1].size())},
        infinity,
        TableFit{{}, infinity, 0}};
    PairSearch stages{family, policies, target, decoded, search};
    const std::vector<Candidate> pairs = stages.pairs(curves);
    if (pairs.empty())
        return fit;
    int coarse_runs = 0;
    for (const auto& direction : decoded.counts)
        for (const int count : direction.front())
            coarse_runs += count > 0 ? 1 : 0;
    fit.passes_percent = std::sqrt(pairs.front().loss / coarse_runs);
    fit.best = stages.best_fit(pairs);
    return fit;
}

}  // namespace endmill
