// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/largest_cutter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "endmill/core/parallel.h"
#include "endmill/mesh/detail/point_tree.h"
#include "endmill/surface/curvature.h"
#include "endmill/surface/detail/box_search.h"
#include "endmill/surface/detail/collapsed_edge.h"

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int most_samples_per_side = 33;  // of a patch, for curvature
constexpr int least_samples_per_side = 5;  // of a patch, on surfaces of very many patches
constexpr double most_curvature_samples = 4e6;   // of a surface
constexpr std::size_t candidates_to_refine = 5;  // of a patch, or of all pairs
// of a part
constexpr double most_pair_samples = 15'000;
// Pairs closer than this, in widths of a patch, are left to curvature. They would only
// find it again with more rounding, or find a crease, which admits no ball at all and
// which `continuity` reports.
constexpr double least_pair_distance = 0.125;
// A surface is plane for a ball whose radius is this number of diagonals.
constexpr double flat_diagonals = 1e6;
// Pairs that admit a ball of this number of diagonals are ignored.
constexpr double largest_pair_diagonals = 8;

// A local minimum among the samples, from which the search is refined.
struct Candidate {
    double value;     // the smaller, the better
    int i, j;         // column and row of the patch
    SurfacePoint at;  // in the patch
    // Difference between the neighbouring samples and this one. The true minimum between
    // the samples is less far below it.
    double rise = 0;
};

// Whether a partial derivative is so short, in the parameters of its patch, that it may
// be rounding. This happens next to a collapsed edge.
bool is_near_pole(double diagonal, const Vec3& local_du, const Vec3& local_dv)
{
    constexpr double shortest = 1e-8;  // of the surface's diagonal
    return diagonal == 0 ||
           std::min(local_du.norm(), local_dv.norm()) <= shortest * diagonal;
}

bool is_near_pole(const Surface& surface, const SurfacePoint& at,
                  const SurfaceTangents& tangents)
{
    return is_near_pole(surface.diagonal(),
                        tangents.du * surface.patch_width(Parameter::U, at.u),
                        tangents.dv * surface.patch_width(Parameter::V, at.v));
}

// A function of the principal curvatures to minimise.
using PrincipalValue = double (*)(const PrincipalCurvatures&);

double least_curvature(const PrincipalCurvatures& k)
{
    return k.least;
}

double negative_greatest_curvature(const PrincipalCurvatures& k)
{
    return -k.greatest;
}

// A patch, examined in its own parameters from 0 to 1.
struct SidedPatch {
    const BezierPatch& patch;
    double diagonal;  // of the surface
    double side;

    SidedPatch(const Surface& surface, int i, int j, double sign)
        : patch{surface.patch(i, j)},
          diagonal{surface.diagonal()},
          side{sign}
    {
    }

    // Nothing where there is no normal.
    std::optional<PrincipalCurvatures> curvatures(double u, double v) const
    {
        const SurfaceJet jet = patch.jet(u, v);
        const Vec3 across = jet.du.cross(jet.dv);
        if (is_near_pole(diagonal, jet.du, jet.dv) ||
            is_singular({jet.point, jet.du, jet.dv}, across))
            return std::nullopt;
        return principal_curvatures(
            fundamental_forms(jet, Vec3{side * across.normalized()}));
    }

    // The range of a parameter without the margin of a collapsed edge: next to a pole
    // curvature loses its digits.
    Interval range(Parameter along) const
    {
        constexpr double rim = 1e-3;
        return {is_collapsed(patch, along, 0) ? rim : 0,
                is_collapsed(patch, along, 1) ? 1 - rim : 1};
    }
};

int curvature_samples_per_side(const Surface& surface)
{
    const double patches =
        double(surface.patches(Parameter::U)) * surface.patches(Parameter::V);
    return std::clamp(static_cast<int>(std::sqrt(most_curvature_samples / patches)),
                      least_samples_per_side, most_samples_per_side);
}

// The samples of a patch, evenly over both ranges.
struct SampleGrid {
    Interval u;
    Interval v;
    int samples;  // in each direction

    SurfacePoint at(int column, int row) const
    {
        return {std::lerp(u.low, u.high, column / (samples - 1.0)),
                std::lerp(v.low, v.high, row / (samples - 1.0))};
    }
};

// The smallest samples of patch (i, j) that are not above their eight neighbours: one for
// each local minimum, even if many samples around one minimum are below another minimum.
std::vector<Candidate> basins(const Eigen::MatrixXd& values, const SampleGrid& grid,
                              int i, int j)
{
    std::vector<Candidate> found;
    for (int row = 0; row < grid.samples; ++row)
        for (int column = 0; column < grid.samples; ++column) {
            const int left = std::max(column - 1, 0);
            const int below = std::max(row - 1, 0);
            const int right = std::min(column + 1, grid.samples - 1);
            const int above = std::min(row + 1, grid.samples - 1);
            const double value = values(column, row);
            const auto around =
                values.block(left, below, right - left + 1, above - below + 1);
            if (value <= around.minCoeff() && std::isfinite(value))
                found.push_back(
                    {value, i, j, grid.at(column, row), around.maxCoeff() - value});
        }
    std::ranges::stable_sort(found, {}, &Candidate::value);
    if (found.size() > candidates_to_refine)
        found.resize(candidates_to_refine);
    return found;
}

// The basins of each of `functions` in a patch, from the same samples.
std::vector<std::vector<Candidate>> basins_of(const Surface& surface, double side,
                                              std::span<const PrincipalValue> functions,
                                              int i, int j)
{
    const SidedPatch patch{surface, i, j, side};
    const SampleGrid grid{patch.range(Parameter::U), patch.range(Parameter::V),
                          curvature_samples_per_side(surface)};
    std::vector<Eigen::MatrixXd> values(
        functions.size(),
        Eigen::MatrixXd::Constant(grid.samples, grid.samples, infinity));
    for (int row = 0; row < grid.samples; ++row)
        for (int column = 0; column < grid.samples; ++column) {
            const auto [u, v] = grid.at(column, row);
            if (const auto curvatures = patch.curvatures(u, v))
                for (std::size_t f = 0; f < functions.size(); ++f)
                    values[f](column, row) = functions[f](*curvatures);
        }
    std::vector<std::vector<Candidate>> found;
    found.reserve(values.size());
    for (const Eigen::MatrixXd& one : values)
        found.push_back(basins(one, grid, i, j));
    return found;
}

// Refines a minimum by a local search in its patch.
Candidate refined(const Surface& surface, double side, PrincipalValue function,
                  const Candidate& start)
{
    const SidedPatch patch{surface, start.i, start.j, side};
    const Interval u = patch.range(Parameter::U);
    const Interval v = patch.range(Parameter::V);
    const BoxMinimum found = minimize_in_box(
        [&](const Eigen::VectorXd& x) {
            const auto curvatures = patch.curvatures(x[0], x[1]);
            return curvatures ? function(*curvatures) : infinity;
        },
        {Eigen::Vector2d{u.low, v.low}, Eigen::Vector2d{u.high, v.high}},
        Eigen::Vector2d{start.at.u, start.at.v},
        std::min(u.length(), v.length()) / (curvature_samples_per_side(surface) - 1));
    if (!(found.value < start.value))
        return start;
    return {found.value, start.i, start.j, {found.at[0], found.at[1]}};
}

// Whether a minimum is taken in place of another one. Of equal ones, such as those of a symmetric
// surface, it is the one in the first patch and nearest to its first corner, so that rounding
// does not choose.
bool is_preferred(const Candidate& found, const Candidate& known)
{
    constexpr double equal_share = 1e-9;
    const double apart = found.value - known.value;
    if (std::abs(apart) > equal_share * std::abs(known.value))
        return apart < 0;
    const auto place = [](const Candidate& one) {
        return std::tuple{one.j, one.i, one.at.u + one.at.v};
    };
    return place(found) < place(known);
}

// The least value of each of `functions` over all patches; nothing if no sample of the
// surface has a normal. The minima are refined in the order of their values. A minimum is
// skipped if it cannot fall below the best one found.
std::vector<std::optional<Candidate>> least_values(
    const Surface& surface, double side, std::span<const PrincipalValue> functions)
{
    const auto columns = static_cast<std::size_t>(surface.patches(Parameter::U));
    const auto rows = static_cast<std::size_t>(surface.patches(Parameter::V));
    std::vector<std::vector<std::vector<Candidate>>> by_patch(columns * rows);
    parallel_for(by_patch.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t number = begin; number < end; ++number)
            by_patch[number] =
                basins_of(surface, side, functions, static_cast<int>(number % columns),
                          static_cast<int>(number / columns));
    });
    std::vector<std::optional<Candidate>> least(functions.size());
    for (std::size_t f = 0; f < functions.size(); ++f) {
        std::vector<Candidate> starts;
        for (const auto& patch : by_patch)
            starts.insert(starts.end(), patch[f].begin(), patch[f].end());
        std::ranges::stable_sort(starts, {}, &Candidate::value);
        for (const Candidate& start : starts) {
            if (least[f] && start.value - start.rise > least[f]->value)
                continue;
            const Candidate found = refined(surface, side, functions[f], start);
            if (!least[f] || is_preferred(found, *least[f]))
                least[f] = found;
        }
    }
    return least;
}

// A part: its surfaces and the signs of their normals.
struct SidedSurfaces {
    std::span<const Surface> surfaces;
    std::span<const double> sides;
};

// A point of the part with its normal.
struct SurfaceSample {
    std::size_t surface;
    SurfacePoint at;
    Vec3 point;
    Vec3 normal;  // on the tool's side
};

// Parameters of the sample lines: `per_patch` lines a patch, borders included; or, if
// that is below one, evenly over the range.
std::vector<double> sample_lines(const Surface& surface, Parameter along,
                                 double per_patch)
{
    const auto breaks = surface.breaks(along);
    if (per_patch < 1) {
        const int lines =
            std::max(2, static_cast<int>(per_patch * double(breaks.size())));
        std::vector<double> values(lines);
        for (int k = 0; k < lines; ++k)
            values[k] = std::lerp(breaks.front(), breaks.back(), k / double(lines - 1));
        return values;
    }
    const int steps = static_cast<int>(per_patch);
    std::vector<double> values{breaks.front()};
    for (std::size_t k = 1; k < breaks.size(); ++k)
        for (int step = 1; step <= steps; ++step)
            values.push_back(std::lerp(breaks[k - 1], breaks[k], step / double(steps)));
    return values;
}

// Adds the samples of one surface. Places without a normal are skipped.
void add_samples(const SidedSurfaces& part, std::size_t number, double per_patch,
                 std::vector<SurfaceSample>& samples)
{
    const Surface& surface = part.surfaces[number];
    const auto along_u = sample_lines(surface, Parameter::U, per_patch);
    for (const double v : sample_lines(surface, Parameter::V, per_patch))
        for (const double u : along_u) {
            const SurfaceTangents tangents = surface.tangents(u, v);
            if (!is_near_pole(surface, {u, v}, tangents) && !is_singular(tangents))
                samples.push_back({number,
                                   {u, v},
                                   tangents.point,
                                   part.sides[number] * unit_normal(tangents)});
        }
}

std::vector<SurfaceSample> samples_of(const SidedSurfaces& part)
{
    constexpr double most_per_patch = 48;
    double patches = 0;
    for (const Surface& surface : part.surfaces)
        patches += double(surface.patches(Parameter::U)) * surface.patches(Parameter::V);
    const double per_patch =
        std::min(std::sqrt(most_pair_samples / patches), most_per_patch);
    std::vector<SurfaceSample> samples;
    for (std::size_t number = 0; number < part.surfaces.size(); ++number)
        add_samples(part, number, per_patch, samples);
    return samples;
}

double patch_size(const Surface& surface)
{
    return surface.diagonal() /
           std::max(surface.patches(Parameter::U), surface.patches(Parameter::V));
}

// Whether two places are so close that the ball through them only shows curvature, or a
// crease. On one surface this is decided by their parameters, on two surfaces by their
// distance.
bool are_near(const SidedSurfaces& part, const SurfaceSample& p, const SurfaceSample& q)
{
    const Surface& surface = part.surfaces[p.surface];
    if (p.surface != q.surface)
        return (q.point - p.point).norm() <
               least_pair_distance *
                   std::min(patch_size(surface), patch_size(part.surfaces[q.surface]));
    const auto widths_apart = [&](Parameter along, double a, double b) {
        return std::abs(a - b) * surface.patches(along) / surface.range(along).length();
    };
    return std::max(widths_apart(Parameter::U, p.at.u, q.at.u),
                    widths_apart(Parameter::V, p.at.v, q.at.v)) < least_pair_distance;
}

// Radius of the ball that touches at `p` and passes through `q`; infinite if `q` is
// behind the tangent plane or too close.
double pair_radius(const SidedSurfaces& part, const SurfaceSample& p,
                   const SurfaceSample& q)
{
    if (are_near(part, p, q))
        return infinity;
    const Vec3 chord = q.point - p.point;
    const double height = p.normal.dot(chord);
    return height > 0 ? chord.squaredNorm() / (2 * height) : infinity;
}

struct Pair {
    SurfaceSample p;
    SurfaceSample q;
};

// Finds pairs of samples that admit the smallest balls: for each sample, the ball of the
// current limit is placed on it, and the sample nearest to its centre, if it is inside,
// gives a smaller limit. The last pairs of the falling sequence are returned.
std::vector<Pair> tightest_sampled_pairs(const SidedSurfaces& part, double limit)
{
    const std::vector<SurfaceSample> samples = samples_of(part);
    std::vector<Vec3> points;
    points.reserve(samples.size());
    for (const SurfaceSample& sample : samples)
        points.push_back(sample.point);
    if (points.empty())
        return {};
    const PointTree tree{points};
    constexpr double inside = 1 - 1e-12;  // excludes the contact itself
    std::vector<Pair> pairs;
    for (const SurfaceSample& p : samples)
        for (;;) {
            const Vec3 centre = p.point + limit * p.normal;
            const auto q = tree.nearest_within(centre, inside * limit);
            const double radius = q ? pair_radius(part, p, samples[*q]) : infinity;
            if (!(radius < limit))
                break;
            limit = radius;
            pairs.push_back({p, samples[*q]});
        }
    if (pairs.size() > candidates_to_refine)
        pairs.erase(pairs.begin(), pairs.end() - candidates_to_refine);
    return pairs;
}

// Refines a pair by a local search over the four parameters of both places.
BoxMinimum refined_pair(const SidedSurfaces& part, const Pair& start)
{
    const auto sample = [&](std::size_t number, double u, double v) -> SurfaceSample {
        const Surface& surface = part.surfaces[number];
        const SurfaceTangents tangents = surface.tangents(u, v);
        const bool has_normal =
            !is_near_pole(surface, {u, v}, tangents) && !is_singular(tangents);
        const Vec3 normal =
            has_normal ? Vec3{part.sides[number] * unit_normal(tangents)} : Vec3::Zero();
        return {number, {u, v}, tangents.point, normal};
    };
    const std::size_t p = start.p.surface;
    const std::size_t q = start.q.surface;
    const auto radius = [&](const Eigen::VectorXd& x) {
        return pair_radius(part, sample(p, x[0], x[1]), sample(q, x[2], x[3]));
    };
    SearchBox box{Eigen::Vector4d::Zero(), Eigen::Vector4d::Zero()};
    double step = infinity;
    for (int k = 0; k < 4; ++k) {
        const Parameter along = k % 2 == 0 ? Parameter::U : Parameter::V;
        const Surface& surface = part.surfaces[k < 2 ? p : q];
        const Interval range = surface.range(along);
        box.low[k] = range.low;
        box.high[k] = range.high;
        step = std::min(step, range.length() / surface.patches(along) / 32);
    }
    return minimize_in_box(
        radius, box,
        Eigen::Vector4d{start.p.at.u, start.p.at.v, start.q.at.u, start.q.at.v}, step);
}

}  // namespace

namespace {

std::optional<CurvatureRange> range_of(const std::optional<Candidate>& least,
                                       const std::optional<Candidate>& greatest)
{
    if (!least || !greatest)
        return std::nullopt;
    // Without a minus zero.
    return CurvatureRange{least->value + 0.0, 0.0 - greatest->value};
}

std::optional<CutterLimit> limit_of(const Surface& surface, std::size_t number,
                                    const std::optional<Candidate>& tightest)
{
    if (!tightest || !(-tightest->value * flat_diagonals * surface.diagonal() > 1))
        return std::nullopt;
    const auto& [value, i, j, at, rise] = *tightest;
    const auto place = [&](Parameter along, int patch, double local) {
        const auto breaks = surface.breaks(along);
        return std::lerp(breaks[patch], breaks[patch + 1], local);
    };
    return CutterLimit{-1 / value,
                       number,
                       {place(Parameter::U, i, at.u), place(Parameter::V, j, at.v)},
                       surface.patch(i, j).tangents(at.u, at.v).point};
}

void widen(std::optional<CurvatureRange>& whole, const std::optional<CurvatureRange>& own)
{
    if (!own)
        return;
    if (!whole)
        whole = own;
    whole->least = std::min(whole->least, own->least);
    whole->greatest = std::max(whole->greatest, own->greatest);
}

void tighten(std::optional<CutterLimit>& whole, const std::optional<CutterLimit>& own)
{
    if (own && (!whole || own->radius_mm < whole->radius_mm))
        whole = own;
}

}  // namespace

CurvatureExtremes curvature_extremes(std::span<const Surface> surfaces,
                                     std::span<const double> sides)
{
    CurvatureExtremes whole;
    for (std::size_t number = 0; number < surfaces.size(); ++number) {
        const Surface& surface = surfaces[number];
        const auto extremes = least_values(
            surface, sides[number],
            std::array<PrincipalValue, 2>{least_curvature, negative_greatest_curvature});
        widen(whole.range, range_of(extremes[0], extremes[1]));
        tighten(whole.limit, limit_of(surface, number, extremes[0]));
    }
    return whole;
}

std::optional<CurvatureRange> curvature_range(const Surface& surface, double side)
{
    return curvature_range(std::span{&surface, 1}, std::span{&side, 1});
}

std::optional<CurvatureRange> curvature_range(std::span<const Surface> surfaces,
                                              std::span<const double> sides)
{
    return curvature_extremes(surfaces, sides).range;
}

std::optional<CutterLimit> largest_cutter_by_curvature(const Surface& surface,
                                                       double side)
{
    return largest_cutter_by_curvature(std::span{&surface, 1}, std::span{&side, 1});
}

std::optional<CutterLimit> largest_cutter_by_curvature(std::span<const Surface> surfaces,
                                                       std::span<const double> sides)
{
    std::optional<CutterLimit> limit;
    for (std::size_t number = 0; number < surfaces.size(); ++number)
        tighten(limit, limit_of(surfaces[number], number,
                                least_values(
                                    surfaces[number], sides[number],
                                    std::array<PrincipalValue, 1>{least_curvature})[0]));
    return limit;
}

std::optional<CutterLimit> largest_cutter(const Surface& surface, double side)
{
    return largest_cutter(std::span{&surface, 1}, std::span{&side, 1});
}

std::optional<CutterLimit> largest_cutter(std::span<const Surface> surfaces,
                                          std::span<const double> sides)
{
    return largest_cutter(surfaces, sides, largest_cutter_by_curvature(surfaces, sides));
}

// The limit by curvature is the start value of the search over pairs.
std::optional<CutterLimit> largest_cutter(std::span<const Surface> surfaces,
                                          std::span<const double> sides,
                                          const std::optional<CutterLimit>& by_curvature)
{
    std::optional<CutterLimit> limit = by_curvature;
    double size = 0;
    for (const Surface& surface : surfaces)
        size = std::max(size, surface.diagonal());
    double radius = largest_pair_diagonals * size;
    if (limit)
        radius = std::min(radius, limit->radius_mm);
    const SidedSurfaces part{surfaces, sides};
    for (const Pair& pair : tightest_sampled_pairs(part, radius)) {
        const BoxMinimum tightest = refined_pair(part, pair);
        if (!(tightest.value < radius))
            continue;
        radius = tightest.value;
        const SurfacePoint at{tightest.at[0], tightest.at[1]};
        const std::size_t number = pair.p.surface;
        limit =
            CutterLimit{radius, number, at, surfaces[number].tangents(at.u, at.v).point};
    }
    return limit;
}

}  // namespace endmill
