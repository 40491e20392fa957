// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/curve_target.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/planning/detail/translational_tables.h"

namespace endmill {
namespace {

// See has_regular_passes.
constexpr int most_uneven_points = 2;
constexpr double most_uneven_share = 0.01;
constexpr double least_length_share = 0.985;

constexpr double step_weight = 4;
// A last step shorter than this share of a step might vanish by rounding.
constexpr double least_share = 1e-3;
// How far f may be from half of f + b if it is not known.
constexpr int most_difference = 3;
constexpr int intervals_a_piece = 200;

double chord_length(const CompositeCurve& curve, const MarchedCurve& pass)
{
    double length = 0;
    Vec3 before = curve.point(pass.parameters.front());
    for (const double t : pass.parameters) {
        const Vec3 here = curve.point(t);
        length += (here - before).norm();
        before = here;
    }
    return length;
}

double count_loss(const CurveMarch& march, int forward, int backward)
{
    const double f = missing_steps(march.steps_forward, forward);
    const double b = missing_steps(march.steps_backward, backward);
    return step_weight * (f * f + b * b);
}

std::optional<CurveMarch> march_both_ways(const CompositeCurve& curve,
                                          const CompositeCurve& back,
                                          double chord_tolerance)
{
    const auto forward = march_curve(curve, chord_tolerance);
    const auto backward = march_curve(back, chord_tolerance);
    if (!forward || !backward)
        return std::nullopt;
    return CurveMarch{static_cast<int>(forward->parameters.size()),
                      static_cast<int>(backward->parameters.size()),
                      forward->steps,
                      backward->steps,
                      chord_length(curve, *forward),
                      chord_length(back, *backward)};
}

double length_excess(const CurveMarch& march, const PassPair& target)
{
    const double mean = (march.forward_mm + march.backward_mm) / 2;
    return std::max(0.0, std::abs(mean - target.chord_mm) - target.chord_tolerance_mm);
}

double pair_loss(const CurveMarch& march, const PassPair& pair)
{
    double counts = std::numeric_limits<double>::infinity();
    const int half = pair.points_a_pair / 2;
    const int first = pair.points_forward.value_or(half - most_difference);
    const int last = pair.points_forward.value_or(half + most_difference);
    for (int f = first; f <= last; ++f)
        counts = std::min(counts, count_loss(march, f, pair.points_a_pair - f));
    const double excess = length_excess(march, pair);
    return counts + excess * excess;
}

}  // namespace

double missing_steps(double steps, int points)
{
    const double low = points - 2 + least_share;
    const double high = points - 1;
    return std::max({0.0, low - steps, steps - high});
}

std::optional<std::array<CurveMarch, 3>> march_both_ways(const CompositeCurve& curve)
{
    const CompositeCurve back = reversed(curve);
    std::array<CurveMarch, 3> marches{};
    for (int i = 0; i < 3; ++i) {
        const auto march = march_both_ways(curve, back, table_tolerances_mm[i]);
        if (!march)
            return std::nullopt;
        marches[i] = *march;
    }
    return marches;
}

double curve_loss(const std::array<CurveMarch, 3>& march, const CurveTarget& target)
{
    double loss = 0;
    for (int i = 0; i < 3; ++i)
        loss += pair_loss(march[i], target[i]);
    return loss;
}

double curve_loss(const CompositeCurve& curve, const CurveTarget& target, double give_up)
{
    const CompositeCurve back = reversed(curve);
    double loss = 0;
    for (int i = 0; i < 3 && loss <= give_up; ++i) {
        const auto march = march_both_ways(curve, back, table_tolerances_mm[i]);
        if (!march)
            return std::numeric_limits<double>::infinity();
        loss += pair_loss(*march, target[i]);
    }
    return loss;
}

bool has_regular_passes(const std::array<CurveMarch, 3>& march)
{
    const auto mean_mm = [](const CurveMarch& pass) {
        return (pass.forward_mm + pass.backward_mm) / 2;
    };
    const double longest = mean_mm(march.back());
    return std::ranges::all_of(march, [&](const CurveMarch& pass) {
        return std::abs(pass.points_forward - pass.points_backward) <=
                   most_uneven_points &&
               std::abs(pass.forward_mm - pass.backward_mm) <=
                   most_uneven_share * longest &&
               mean_mm(pass) >= least_length_share * longest;
    });
}

int curve_matches(const std::array<CurveMarch, 3>& march, const CurveTarget& target)
{
    int matches = 0;
    for (int i = 0; i < 3; ++i) {
        const PassPair& pair = target[i];
        const int f = march[i].points_forward;
        const int b = march[i].points_backward;
        if (pair.points_forward) {
            matches += f == *pair.points_forward ? 1 : 0;
            matches += b == pair.points_a_pair - *pair.points_forward ? 1 : 0;
        } else {
            matches += f + b == pair.points_a_pair ? 2 : 0;
        }
        matches += length_excess(march[i], pair) == 0 ? 1 : 0;
    }
    return matches;
}

CurveIntegrals curve_integrals(const CompositeCurve& curve)
{
    CurveIntegrals integrals{0, 0, 0};
    for (int piece = 0; piece < curve.pieces(); ++piece)
        for (int i = 0; i <= intervals_a_piece; ++i) {
            const bool is_end = i == 0 || i == intervals_a_piece;
            const double weight = (is_end       ? 1.0
                                   : i % 2 == 1 ? 4.0
                                                : 2.0) /
                                  (3.0 * intervals_a_piece);
            // The jet at a joint belongs to the piece above; stay within this one.
            constexpr double inside = 1 - 1e-12;
            const CurveJet jet = curve.jet(piece + (i == intervals_a_piece
                                                        ? inside
                                                        : i / double(intervals_a_piece)));
            const double speed = jet.first.norm();
            const double bend = jet.first.cross(jet.second).norm();
            const double curvature = bend / (speed * speed * speed);
            integrals.arc_mm += weight * speed;
            integrals.turning += weight * curvature * speed;
            integrals.root_curvature += weight * std::sqrt(curvature) * speed;
        }
    return integrals;
}

}  // namespace endmill
