// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/table_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "endmill/core/error.h"
#include "endmill/planning/detail/least_squares.h"

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Interval scallop_range{0.3, 1.1};  // h / delta
// Ratios h / delta that a pair of curves is tried with: a first one, and those predicted from it.
constexpr double first_ratio = 0.5;
constexpr int ratio_rounds = 3;
constexpr int predicted_ratios = 400;
// Weight of squared percents of deviation against bits.
constexpr double percent_weight = 2;
// Penalties of a square millimetre of height beyond the limit, and of the square of a concavity of twice
// the limit.
constexpr double height_weight = 0.01;
constexpr double concavity_weight = 10;
constexpr int height_samples = 30;  // a piece
// Residuals of the fit: a millimetre of travel weighs as much as this part of a pass or a step.
constexpr double count_unit = 0.01;
// Sides of the boxes in which fits are refined, as shares of the ranges.
constexpr double wide_box = 0.1;
constexpr double narrow_box = 0.002;

double percent(double value, double target)
{
    return 100 * (value / target - 1);
}

double run_loss(const DirectionCost& run, const DirectionCost& target)
{
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

struct Pair {
    double squares;  // of missing passes in percent
    std::vector<double> values;
};

// Real numbers of passes of the 18 runs; nothing if a run does not exist.
std::optional<std::vector<double>> real_passes(const FamilyMember& member,
                                               RunPolicies policies, double ratio)
{
    policies.table.scallop_per_tolerance = ratio;
    std::vector<double> passes(18);
    const auto keep = [&](const RunPlace& at, const TableRun& run) {
        passes[9 * at.direction + 3 * at.tolerance + at.diameter] = run.passes_real;
        return true;
    };
    if (!visit_runs(member, policies, keep))
        return std::nullopt;
    return passes;
}

// Squares of the missing passes in percent, if N - 1 were multiplied by `factor`.
double missing_squares(std::span<const double> passes, double factor,
                       const DecodedTables& decoded, LastPath last_path)
{
    double squares = 0;
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const int count = decoded.counts[k][i][j];
                const double real = 1 + factor * (passes[9 * k + 3 * i + j] - 1);
                const double missing =
                    100 * missing_pass_count(real, count, last_path) / count;
                squares += missing * missing;
            }
    return squares;
}

// The ratio with the fewest missing passes. The interval grows about with the root of the ratio; each
// round predicts the best ratio from the last one.
Pair best_ratio(SurfaceFamily family, const RunPolicies& policies,
                std::vector<double> values, const DecodedTables& decoded)
{
    const FamilyMember member = family_surface(family, values);
    const LastPath last_path = policies.table.plan.last_path;
    Pair pair{infinity, std::move(values)};
    pair.values.push_back(first_ratio);
    double ratio = first_ratio;
    for (int round = 0; round < ratio_rounds; ++round) {
        const auto passes = real_passes(member, policies, ratio);
        if (!passes)
            return pair;
        const double squares = missing_squares(*passes, 1, decoded, last_path);
        if (squares < pair.squares) {
            pair.squares = squares;
            pair.values.back() = ratio;
        }
        double best = infinity;
        double predicted = ratio;
        for (int i = 0; i <= predicted_ratios; ++i) {
            const double trial = std::lerp(scallop_range.low, scallop_range.high,
                                           i / double(predicted_ratios));
            const double found =
                missing_squares(*passes, std::sqrt(ratio / trial), decoded, last_path);
            if (found < best) {
                best = found;
                predicted = trial;
            }
        }
        ratio = predicted;
    }
    return pair;
}

// Real numbers of steps by which a march misses the counts of its target.
void add_missing_steps(std::vector<double>& residuals,
                       const std::array<CurveMarch, 3>& marches,
                       const CurveTarget& target)
{
    for (int i = 0; i < 3; ++i) {
        const PassPair& pair = target[i];
        // Without f, the present one, as far as the sum allows.
        const int forward = pair.points_forward.value_or(
            std::clamp(marches[i].points_forward, pair.points_a_pair / 2 - 1,
                       pair.points_a_pair / 2 + 2));
        residuals.push_back(missing_steps(marches[i].steps_forward, forward) /
                            count_unit);
        residuals.push_back(
            missing_steps(marches[i].steps_backward, pair.points_a_pair - forward) /
            count_unit);
    }
}

// Residuals that are continuous in the values while the counts are near the decoded ones: travel as if
// the number of passes were the decoded one, missing passes, missing steps.
class DecodedResiduals {
public:
    DecodedResiduals(SurfaceFamily family, const RunPolicies& policies,
                     const EconomyTables& target, const DecodedTables& decoded)
        : family_{family},
          policies_{policies},
          target_{target},
          decoded_{decoded}
    {
    }

    std::optional<Eigen::VectorXd> operator()(std::span<const double> values) const
    {
        RunPolicies policies = policies_;
        policies.table.scallop_per_tolerance = values.back();
        const FamilyMember member = member_of(family_, values);
        const auto& surface = std::get<TranslationalSurface>(member);
        const std::array marches{march_both_ways(surface.along_u),
                                 march_both_ways(surface.along_v)};
        if (!marches[0] || !marches[1])
            return std::nullopt;
        std::vector<double> residuals;
        const auto add = [&](const RunPlace& at, const TableRun& run) {
            const auto [k, i, j] = at;
            const int passes = decoded_.counts[k][i][j];
            const CurveMarch& march = (*marches[k])[i];
            const double chord = (march.forward_mm + march.backward_mm) / 2;
            residuals.push_back(run.cost.tcd_mm + (passes - run.passes) * chord -
                                target_.runs[k][i][j].tcd_mm);
            residuals.push_back(missing_pass_count(run.passes_real, passes,
                                                   policies.table.plan.last_path) /
                                count_unit);
            return true;
        };
        if (!visit_runs(member, policies, add))
            return std::nullopt;
        for (int k = 0; k < 2; ++k)
            add_missing_steps(residuals, *marches[k], decoded_.passes[k]);
        return Eigen::VectorXd{Eigen::Map<const Eigen::VectorXd>(
            residuals.data(), static_cast<Eigen::Index>(residuals.size()))};
    }

private:
    SurfaceFamily family_;
    const RunPolicies& policies_;
    const EconomyTables& target_;
    const DecodedTables& decoded_;
};

// The part of `ranges` about `values` whose sides are `share` of theirs.
std::vector<Interval> box_about(std::span<const double> values,
                                std::span<const Interval> ranges, double share)
{
    std::vector<Interval> box;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        const double half = share / 2 * ranges[i].length();
        box.push_back({std::max(ranges[i].low, values[i] - half),
                       std::min(ranges[i].high, values[i] + half)});
    }
    return box;
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
          ranges_{fit_ranges(family)},
          residuals_{family, policies, target, decoded}
    {
    }

    // All pairs of the curves with their best ratios, those with the fewest missing passes first.
    std::vector<Pair> pairs(
        const std::array<std::vector<std::vector<double>>, 2>& curves) const
    {
        std::vector<Pair> pairs;
        const std::array own{curve_positions(family_, 0), curve_positions(family_, 1)};
        std::vector<double> values(value_ranges(family_).size());
        for (const std::vector<double>& a : curves[0])
            for (const std::vector<double>& b : curves[1]) {
                for (std::size_t i = 0; i < a.size(); ++i)
                    values[own[0][i]] = a[i];
                for (std::size_t i = 0; i < b.size(); ++i)
                    values[own[1][i]] = b[i];
                pairs.push_back(best_ratio(family_, policies_, values, decoded_));
            }
        std::ranges::stable_sort(pairs, {}, &Pair::squares);
        return pairs;
    }

    // The first of `pairs` fitted by least squares, those with the smallest loss first.
    std::vector<TableFit> fits(std::span<const Pair> pairs) const
    {
        std::vector<TableFit> fits;
        for (const Pair& pair : pairs) {
            if (static_cast<int>(fits.size()) >= search_.fitted ||
                !std::isfinite(pair.squares))
                break;
            const LeastSquares found =
                least_squares(ranges_, residuals_, pair.values, search_.fit_iterations);
            fits.push_back(
                {found.values, loss(found.values, infinity), found.evaluations});
        }
        std::ranges::stable_sort(fits, {}, &TableFit::loss);
        return fits;
    }

    // Refines a fit: first the continuous residuals, in a wide box and then by least squares,
    // and last the cells themselves in a narrow box.
    TableFit refined(const TableFit& start) const
    {
        const auto squares = [&](std::span<const double> trial, double) {
            const auto found = residuals_(trial);
            return found ? found->squaredNorm() : infinity;
        };
        const auto cells = [&](std::span<const double> trial, double give_up) {
            return loss(trial, give_up);
        };
        const int evaluations = search_.refined_evaluations / 2;
        const FoundValues wide = minimise(
            box_about(start.values, ranges_, wide_box), squares,
            {.evaluations = evaluations, .seed = search_.seed, .start = {start.values}});
        const LeastSquares fitted =
            least_squares(ranges_, residuals_, wide.values, search_.fit_iterations);
        const FoundValues narrow = minimise(
            box_about(fitted.values, ranges_, narrow_box), cells,
            {.evaluations = evaluations, .seed = search_.seed, .start = {fitted.values}});
        return {narrow.values, narrow.loss,
                wide.evaluations + fitted.evaluations + narrow.evaluations};
    }

private:
    double loss(std::span<const double> values, double give_up) const
    {
        return table_loss(family_, policies_, target_, values, give_up);
    }

    SurfaceFamily family_;
    const RunPolicies& policies_;
    const EconomyTables& target_;
    const DecodedTables& decoded_;
    const StagedSearch& search_;
    std::vector<Interval> ranges_;
    DecodedResiduals residuals_;
};

}  // namespace

std::vector<Interval> fit_ranges(SurfaceFamily family)
{
    std::vector<Interval> ranges = value_ranges(family);
    ranges.push_back(scallop_range);
    return ranges;
}

std::vector<std::size_t> curve_positions(SurfaceFamily family, int curve)
{
    // Runs of values: those of A, those of B, and again where the family has more.
    std::vector<std::size_t> lengths{7, 5};
    if (family == SurfaceFamily::Uneven)
        lengths.insert(lengths.end(), {6, 4});
    if (family == SurfaceFamily::Skew)
        lengths.insert(lengths.end(), {7, 5});
    std::vector<std::size_t> own;
    std::size_t first = 0;
    for (std::size_t k = 0; k < lengths.size(); ++k) {
        for (std::size_t i = 0; i < lengths[k]; ++i)
            if (static_cast<int>(k % 2) == curve)
                own.push_back(first + i);
        first += lengths[k];
    }
    return own;
}

CompositeCurve family_curve(SurfaceFamily family, int curve,
                            std::span<const double> values)
{
    const std::vector<std::size_t> positions = curve_positions(family, curve);
    std::vector<double> all(value_ranges(family).size(), 0.0);
    for (std::size_t i = 0; i < positions.size(); ++i)
        all[positions[i]] = values[i];
    const FamilyMember member = family_surface(family, all);
    const auto& surface = std::get<TranslationalSurface>(member);
    return curve == 0 ? surface.along_u : surface.along_v;
}

double height_of(const CompositeCurve& curve)
{
    double low = infinity;
    double high = -infinity;
    for (int i = 0; i <= height_samples * curve.pieces(); ++i) {
        const double z = curve.point(i / double(height_samples)).z();
        low = std::min(low, z);
        high = std::max(high, z);
    }
    return high - low;
}

double concavity_of(const CompositeCurve& curve)
{
    double most = 0;
    for (int i = 0; i <= height_samples * curve.pieces(); ++i) {
        const CurveJet jet = curve.jet(i / double(height_samples));
        const double speed2 = jet.first.squaredNorm();
        const Vec3 up = Vec3::UnitZ() - jet.first.z() / speed2 * jet.first;
        most = std::max(most, jet.second.dot(up) / (speed2 * up.norm()));
    }
    return most;
}

std::vector<std::vector<double>> search_curves(SurfaceFamily family, int curve,
                                               const CurveTarget& target,
                                               const StagedSearch& search)
{
    const std::vector<Interval> all_ranges = value_ranges(family);
    std::vector<Interval> ranges;
    for (const std::size_t position : curve_positions(family, curve))
        ranges.push_back(all_ranges[position]);
    const auto loss = [&](std::span<const double> values, double give_up) {
        const CompositeCurve trial = family_curve(family, curve, values);
        const double excess = std::max(0.0, height_of(trial) - search.most_height);
        const double tight =
            std::max(0.0, concavity_of(trial) / search.most_concavity - 1);
        const double penalty =
            height_weight * excess * excess + concavity_weight * tight * tight;
        return penalty + curve_loss(trial, target, give_up - penalty);
    };
    std::vector<std::vector<double>> curves;
    for (int i = 0; i < search.curves; ++i) {
        FoundValues best =
            minimise(ranges, loss,
                     {.evaluations = search.curve_evaluations,
                      .seed = search.seed + static_cast<std::uint32_t>(i)});
        if (best.loss <= search.accepted_loss)
            curves.push_back(std::move(best.values));
    }
    return curves;
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
        curves[k] = search_curves(family, k, decoded.passes[k], search);
    StagedFit fit{
        {static_cast<int>(curves[0].size()), static_cast<int>(curves[1].size())},
        infinity,
        TableFit{{}, infinity, 0}};
    const PairSearch stages{family, policies, target, decoded, search};
    const std::vector<Pair> pairs = stages.pairs(curves);
    if (pairs.empty())
        return fit;
    constexpr int cells = 18;
    fit.passes_percent = std::sqrt(pairs.front().squares / cells);

    const std::vector<TableFit> fits = stages.fits(pairs);
    int evaluations = 0;
    for (const TableFit& found : fits)
        evaluations += found.evaluations;
    const auto refined = std::min<std::size_t>(fits.size(), search.refined);
    for (std::size_t i = 0; i < refined; ++i) {
        TableFit found = stages.refined(fits[i]);
        evaluations += found.evaluations;
        if (found.loss < fit.best.loss)
            fit.best = std::move(found);
    }
    fit.best.evaluations = evaluations;
    return fit;
}

}  // namespace endmill
