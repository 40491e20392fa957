// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/nurbs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/surface/detail/bernstein_basis.h"

namespace endmill {
namespace {

// A span narrower than this share of the range comes from the rounding of a repeated
// knot.
constexpr double least_span = 1e-12;
// Beyond this range of sizes, fourth powers of partial derivatives would overflow or
// vanish.
constexpr double least_range = 1e-50;
constexpr double greatest_range = 1e50;

// A span between two different knots, with the Bezier form of the spline on it.
struct Span {
    double start;
    double end;
    // Number of the first of the degree + 1 control points that act on the span.
    int first_point;
    // Bezier control point i is the sum over k of bezier(i, k) times control point
    // first_point + k.
    Eigen::MatrixXd bezier;
};

// Numbers of the knots at which the spans of the range start.
std::vector<int> span_starts(const SplineParameter& parameter)
{
    std::vector<int> starts;
    for (int k = parameter.degree; k < parameter.points(); ++k)
        if (parameter.knots[k] < parameter.knots[k + 1])
            starts.push_back(k);
    return starts;
}

// Bezier control point i of the span that starts at knot `start`: the polar form of the
// spline with p - i arguments at the start of the span and i arguments at its end. The
// rows of the identity stand for the control points, so that the result is the row of
// their factors.
Eigen::RowVectorXd bezier_row(const SplineParameter& parameter, int start, int i)
{
    const auto& [p, knots] = parameter;
    Eigen::MatrixXd points = Eigen::MatrixXd::Identity(p + 1, p + 1);
    for (int level = 1; level <= p; ++level) {
        const double t = level <= p - i ? knots[start] : knots[start + 1];
        for (int k = p; k >= level; --k) {
            const int first = start - p + k;
            const double share =
                (t - knots[first]) / (knots[first + p + 1 - level] - knots[first]);
            points.row(k) = (1 - share) * points.row(k - 1) + share * points.row(k);
        }
    }
    return points.row(p);
}

std::vector<Span> spans_of(const SplineParameter& parameter)
{
    const auto& [p, knots] = parameter;
    std::vector<Span> spans;
    for (const int start : span_starts(parameter)) {
        Span& span = spans.emplace_back(Span{knots[start], knots[start + 1], start - p,
                                             Eigen::MatrixXd(p + 1, p + 1)});
        for (int i = 0; i <= p; ++i)
            span.bezier.row(i) = bezier_row(parameter, start, i);
    }
    return spans;
}

std::vector<double> breaks_of(std::span<const Span> spans)
{
    std::vector<double> breaks{spans.front().start};
    for (const Span& span : spans)
        breaks.push_back(span.end);
    return breaks;
}

Eigen::Vector4d homogeneous(const Nurbs& nurbs, int i, int j)
{
    const auto at = static_cast<std::size_t>(j) * nurbs.u.points() + i;
    const double weight = nurbs.weights.empty() ? 1 : nurbs.weights[at];
    Eigen::Vector4d point;
    point << weight * nurbs.control_points[at], weight;
    return point;
}

// The patch on the product of two spans.
BezierPatch patch_on(const Nurbs& nurbs, const Span& along_u, const Span& along_v)
{
    const int p = nurbs.u.degree;
    const int q = nurbs.v.degree;
    std::vector<Eigen::Vector4d> net(static_cast<std::size_t>(p + 1) * (q + 1));
    for (int c = 0; c < 4; ++c) {
        Eigen::MatrixXd points{p + 1, q + 1};
        for (int j = 0; j <= q; ++j)
            for (int i = 0; i <= p; ++i)
                points(i, j) = homogeneous(nurbs, along_u.first_point + i,
                                           along_v.first_point + j)[c];
        points = along_u.bezier * points * along_v.bezier.transpose();
        for (int j = 0; j <= q; ++j)
            for (int i = 0; i <= p; ++i)
                net[static_cast<std::size_t>(j) * (p + 1) + i][c] = points(i, j);
    }
    return BezierPatch::from_homogeneous(p, q, net, !nurbs.weights.empty());
}

bool repeats_too_often(const SplineParameter& parameter)
{
    const auto& [degree, knots] = parameter;
    const auto beyond = static_cast<std::size_t>(degree) + 1;
    for (std::size_t k = 0; k + beyond < knots.size(); ++k)
        if (knots[k] == knots[k + beyond])
            return true;
    return false;
}

}  // namespace

std::string flaw(const SplineParameter& parameter)
{
    const auto& [degree, knots] = parameter;
    if (degree < 1 || degree > most_degree)
        return "the degree is not in 1 … " + std::to_string(most_degree);
    if (!std::ranges::all_of(knots, [](double knot) { return std::isfinite(knot); }))
        return "a knot is not finite";
    if (!std::ranges::is_sorted(knots))
        return "the knots fall";
    if (parameter.points() < degree + 1)
        return "there are fewer than degree + 1 control points";
    if (repeats_too_often(parameter))
        return "a knot is repeated more than degree + 1 times";
    const double range = knots[parameter.points()] - knots[degree];
    if (!(range > 0) || !std::isfinite(range))
        return "the range between knot [degree] and knot [points] is empty";
    if (range < least_range || range > greatest_range)
        return "the range between knot [degree] and knot [points] is not within 1e-50 … "
               "1e50";
    for (const int start : span_starts(parameter))
        if (knots[start + 1] - knots[start] <= least_span * range)
            return "two knots lie closer than 1e-12 of the range";
    return {};
}

Surface nurbs_surface(const Nurbs& nurbs, ToolSide tool_side)
{
    require(flaw(nurbs.u).empty() && flaw(nurbs.v).empty(),
            "nurbs_surface: the degrees or knots are unsound");
    const auto count = static_cast<std::size_t>(nurbs.u.points()) * nurbs.v.points();
    require(nurbs.control_points.size() == count,
            "nurbs_surface: the number of control points does not match the knots");
    require(nurbs.weights.empty() || nurbs.weights.size() == count,
            "nurbs_surface: a weight is needed for each control point");
    const std::vector<Span> along_u = spans_of(nurbs.u);
    const std::vector<Span> along_v = spans_of(nurbs.v);
    std::vector<BezierPatch> patches;
    patches.reserve(along_u.size() * along_v.size());
    for (const Span& v : along_v)
        for (const Span& u : along_u)
            patches.push_back(patch_on(nurbs, u, v));
    return Surface{breaks_of(along_u), breaks_of(along_v), std::move(patches), tool_side};
}

namespace {

// The patches of a surface along both parameters, and where neighbours share their control points.
class PatchGrid {
public:
    explicit PatchGrid(const Surface& surface)
        : surface_{surface},
          degrees_{surface.patch(0, 0).degree(Parameter::U),
                   surface.patch(0, 0).degree(Parameter::V)}
    {
        for (int j = 0; j < surface.patches(Parameter::V); ++j)
            for (int i = 0; i < surface.patches(Parameter::U); ++i)
                look_at(i, j);
    }

    Nurbs nurbs() const
    {
        Nurbs nurbs{parameter(Parameter::U), parameter(Parameter::V), {}, {}};
        for (const auto& [j, b] : places(Parameter::V))
            for (const auto& [i, a] : places(Parameter::U)) {
                const BezierPatch& patch = surface_.patch(i, j);
                nurbs.control_points.push_back(patch.control_point(a, b));
                if (is_rational_)
                    nurbs.weights.push_back(patch.homogeneous_point(a, b)[3]);
            }
        return nurbs;
    }

private:
    int degree(Parameter along) const
    {
        return along == Parameter::U ? degrees_[0] : degrees_[1];
    }
    bool is_joined(Parameter along) const
    {
        return along == Parameter::U ? is_joined_[0] : is_joined_[1];
    }

    void look_at(int i, int j)
    {
        const BezierPatch& patch = surface_.patch(i, j);
        require(patch.degree(Parameter::U) == degrees_[0] &&
                    patch.degree(Parameter::V) == degrees_[1],
                "nurbs_of: patches of different degrees are no single NURBS");
        is_rational_ = is_rational_ || patch.is_rational();
        for (int k = 0; i > 0 && k <= degrees_[1]; ++k)
            is_joined_[0] =
                is_joined_[0] &&
                patch.homogeneous_point(0, k) ==
                    surface_.patch(i - 1, j).homogeneous_point(degrees_[0], k);
        for (int k = 0; j > 0 && k <= degrees_[0]; ++k)
            is_joined_[1] =
                is_joined_[1] &&
                patch.homogeneous_point(k, 0) ==
                    surface_.patch(i, j - 1).homogeneous_point(k, degrees_[1]);
    }

    // Numbers of a patch and of a control point in it, for all control points along a parameter.
    std::vector<std::pair<int, int>> places(Parameter along) const
    {
        std::vector<std::pair<int, int>> places;
        for (int i = 0; i < surface_.patches(along); ++i)
            for (int k = i > 0 && is_joined(along) ? 1 : 0; k <= degree(along); ++k)
                places.emplace_back(i, k);
        return places;
    }

    SplineParameter parameter(Parameter along) const
    {
        SplineParameter parameter{degree(along), {}};
        const std::span<const double> breaks = surface_.breaks(along);
        for (std::size_t i = 0; i < breaks.size(); ++i) {
            const bool is_inner = i > 0 && i + 1 < breaks.size();
            const int times = degree(along) + (is_inner && is_joined(along) ? 0 : 1);
            parameter.knots.insert(parameter.knots.end(), static_cast<std::size_t>(times),
                                   breaks[i]);
        }
        return parameter;
    }

    const Surface& surface_;
    std::array<int, 2> degrees_;
    bool is_rational_ = false;
    std::array<bool, 2> is_joined_{true, true};
};

}  // namespace

Nurbs nurbs_of(const Surface& surface)
{
    return PatchGrid{surface}.nurbs();
}

}  // namespace endmill
