// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/translational_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"
#include "endmill/planning/detail/interval_forms.h"
#include "endmill/planning/path_interval.h"
#include "endmill/planning/step_length.h"

// On r(u, v) = A(u) + B(v) the partials are A' and B', and the twist vanishes:
// 1. With steps by the curvature of the curve, all passes along u have the same points and the
//    same chord length. A is marched once per tolerance, and once from its far end.
// 2. At a contact, T_c is the part of B' across A', of length w after projection. Its
//    components in A' and B' are a = -F / (E w) and b = 1 / w; the curvature across is
//    -(a^2 A'' + b^2 B'') . N.
// 3. The neighbour on the next pass solves eq. (9), (10) by Newton's method on the two curves.
//    A contact whose start value lies further than the best neighbour so far, by several
//    times the correction of the start value, is not solved where the least governs.

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int most_passes = 400;
constexpr int most_steps = 2000;
// As in cross_section.cpp, from which the results must not differ.
constexpr int most_iterations = 8;
constexpr double most_pieces_a_step = 0.3;
constexpr double residual_share = 1e-12;
// Newton's steps square their error: after a step of this many pieces it is rounding.
constexpr double last_step = 1e-8;
// A step of this many pieces is in the region of convergence.
constexpr double small_step = 0.1;
// As in iso_parametric.cpp.
constexpr double least_advance = 1e-4;
constexpr int dense_samples = 16;
// A start value is off by a small part of its own correction.
constexpr double sure_corrections = 4;

// The rules by which a pass is marched.
struct MarchRules {
    double chord_tolerance;
    EndPoint end_point;
    PatchBorders borders;
};

// Where a step from t ends; nothing if the pass ends at t. Adds the step, or the share of it that is left,
// to `steps`.
std::optional<double> next_parameter(const CompositeCurve& curve, double t,
                                     const StepLength& step, const MarchRules& rules,
                                     double& steps)
{
    const double end = curve.end();
    const CurveJet jet = curve.jet(t);
    const Vec3 feed = jet.first / jet.first.norm();
    std::optional<double> next;
    if (step.status != LengthStatus::Unlimited)
        next = curve.first_reach(t, feed, step.projected);
    if (next)
        steps += 1;
    else
        steps += std::clamp((curve.point(end) - jet.point).dot(feed) / step.projected,
                            0.0, 1.0);
    if (!next && rules.end_point == EndPoint::Force)
        next = end;
    if (rules.borders == PatchBorders::Stop) {
        const double above = std::floor(t + end_width) + 1;
        next = std::min(next.value_or(end), std::min(above, end));
    }
    return next;
}

template <typename Curvature>
std::optional<MarchedCurve> march_with(const CompositeCurve& curve,
                                       const MarchRules& rules,
                                       const Curvature& curvature)
{
    const double end = curve.end();
    MarchedCurve pass{{0}, 0};
    double t = 0;
    while (t < end) {
        const CurveJet jet = curve.jet(t);
        if (!(jet.first.norm() > 0) ||
            static_cast<int>(pass.parameters.size()) > most_steps)
            return std::nullopt;
        const StepLength step = step_length(curvature(jet), rules.chord_tolerance);
        const auto next = next_parameter(curve, t, step, rules, pass.steps);
        if (!next)
            break;
        if (*next <= t)
            return std::nullopt;
        t = *next >= end - end_width ? end : *next;
        pass.parameters.push_back(t);
    }
    return pass;
}

double curvature_of(const CurveJet& jet)
{
    const double speed2 = jet.first.squaredNorm();
    return jet.first.cross(jet.second).norm() / (speed2 * std::sqrt(speed2));
}

// A contact as far as its own curve determines it.
struct AlongFrame {
    double parameter;
    CurveJet jet;
    Vec3 feed;     // T_s
    double speed;  // |A'|
};

AlongFrame along_frame(const CompositeCurve& along, double t)
{
    const CurveJet jet = along.jet(t);
    const double speed = jet.first.norm();
    return {t, jet, jet.first / speed, speed};
}

// The contacts of a pass, in the order of the march.
struct PassPoints {
    std::vector<AlongFrame> frames;
    double chord_mm = 0;
};

// The projected interval of path_interval where its status is Ok, which is certain if the
// curvature is small enough; nothing elsewhere.
std::optional<double> plain_interval(double R, double k, double h)
{
    const double closing = 1 + 2 * k * R;
    const double highest = 2 * R / h - 1;  // h is below its limit for closing < highest^2
    const double g2 = h * (2 * R - h) / ((1 + k * R) * (1 + k * h));
    const double kg2 = k * k * g2;
    if (closing < 0 || closing > highest * highest / 2 || kg2 > 0.5)
        return std::nullopt;
    return 2 * std::sqrt(g2 * (1 - kg2 / 4)) * (1 - kg2 / 2);
}

// The projected interval; infinite if it is unlimited, nothing if the ball does not fit.
std::optional<double> projected_interval(double R, double k, double h,
                                         IntervalArithmetic arithmetic)
{
    if (!(1 + k * R > 0))
        return std::nullopt;
    if (arithmetic == IntervalArithmetic::Exact)
        if (const auto plain = plain_interval(R, k, h))
            return plain;
    const PathInterval exact = path_interval(BallCutter{R}, k, h);
    if (arithmetic == IntervalArithmetic::Exact || k == 0 ||
        exact.status != LengthStatus::Ok)
        return exact.projected;
    const double rho = 1 / k;
    const double l =
        std::abs(printed_interval({R, h, rho}, IntervalForm::Printed, Precision::Single));
    const double d = l * std::sqrt(4 * rho * rho - l * l) / (2 * std::abs(rho));
    return d > 0 && std::isfinite(d) ? d : exact.projected;
}

// Where a pass lies on the other curve, and the ball.
struct PassPlace {
    double v;
    CurveJet across;
    double radius;
};

// The runs of one tolerance with passes along `along`.
class PassPlanner {
public:
    // `turn` is the sign that turns along' x across' upward.
    PassPlanner(const CompositeCurve& along, const CompositeCurve& across, double turn,
                const RunPolicies& policies, double tolerance)
        : along_{along},
          back_{reversed(along)},
          across_{across},
          turn_{turn},
          policies_{policies},
          options_{policies.table.plan},
          tolerance_{tolerance},
          scallop_{policies.table.scallop_per_tolerance * tolerance}
    {
        Vec3 low = along.points()[0] + across.points()[0];
        Vec3 high = low;
        for (const Vec3& a : along.points())
            for (const Vec3& b : across.points()) {
                low = low.cwiseMin(a + b);
                high = high.cwiseMax(a + b);
            }
        residual_ = residual_share * (high - low).norm();
        if (options_.governing == Governing::DenseMin)
            for (int piece = 0; piece < along.pieces(); ++piece)
                for (int sample = 0; sample <= dense_samples; ++sample)
                    dense_.push_back(
                        along_frame(along, piece + sample / double(dense_samples)));
    }

    // Marches the passes that all have the same points; false if it fails.
    bool prepare()
    {
        if (!has_equal_passes())
            return true;
        const auto forward = points(false, 0);
        const auto backward = points(true, 0);
        if (!forward || !backward)
            return false;
        equal_ = {*forward, *backward};
        return true;
    }

    std::optional<TableRun> run(double radius) const
    {
        const double end = across_.end();
        Travelled travelled{{{0, 0}, 0, 0}, std::nullopt};
        TableRun& run = travelled.run;
        std::optional<double> v = 0;
        std::optional<PassPoints> own;
        while (v) {
            const bool is_back = options_.march == March::Alternate &&
                                 run.passes % 2 == 1 && !policies_.points_of_first_pass;
            if (!has_equal_passes() && !(policies_.points_of_first_pass && own)) {
                own = points(is_back, *v);
                if (!own)
                    return std::nullopt;
            }
            const PassPoints& pass = has_equal_passes() ? equal_[is_back ? 1 : 0] : *own;
            const PassPlace place{*v, across_.jet(*v), radius};
            // A pass of zig-zag is cut with rising parameter if its number is even.
            const bool is_marched_as_cut = is_back == (run.passes % 2 == 1);
            add_pass(travelled, pass, place, is_marched_as_cut);
            if (*v == end)
                break;
            const auto candidate = next_candidate(pass, place);
            if (!candidate || run.passes > most_passes ||
                !(*candidate - *v >= least_advance))
                return std::nullopt;
            if (*candidate >= end - end_width)
                run.passes_real =
                    run.passes + std::clamp((end - *v) / (*candidate - *v), 0.0, 1.0);
            v = following(*v, *candidate);
        }
        return run;
    }

private:
    struct Tip {
        Vec3 contact;
        Vec3 tip;
    };

    // The path so far and its end.
    struct Travelled {
        TableRun run;
        std::optional<Tip> last;
    };

    bool has_equal_passes() const
    {
        return options_.step_curvature == StepCurvature::Curve;
    }

    std::optional<PassPoints> points(bool is_back, double v) const
    {
        const CompositeCurve& curve = is_back ? back_ : along_;
        std::optional<MarchedCurve> marched;
        if (has_equal_passes())
            marched = march_curve(curve, tolerance_, options_.end_point,
                                  options_.patch_borders);
        else {
            const Vec3 across = across_.jet(v).first;
            marched = march_with(
                curve, {tolerance_, options_.end_point, options_.patch_borders},
                [&](const CurveJet& jet) {
                    const Vec3 normal = jet.first.cross(across).normalized();
                    return jet.second.dot(normal) / jet.first.squaredNorm();
                });
        }
        if (!marched)
            return std::nullopt;
        PassPoints pass;
        for (const double t : marched->parameters)
            pass.frames.push_back(along_frame(along_, is_back ? along_.end() - t : t));
        for (std::size_t i = 0; i + 1 < pass.frames.size(); ++i)
            pass.chord_mm +=
                (pass.frames[i + 1].jet.point - pass.frames[i].jet.point).norm();
        return pass;
    }

    // Adds points and travel of a pass.
    void add_pass(Travelled& travelled, const PassPoints& pass, const PassPlace& place,
                  bool is_marched_as_cut) const
    {
        const bool counts_links = policies_.table.counted == CountedMoves::CutsAndLinks;
        const bool by_tips = policies_.table.distance == TravelKind::Tip;
        const auto tip_at = [&](const AlongFrame& frame) -> Tip {
            const Vec3 contact = frame.jet.point + place.across.point;
            const Vec3 normal =
                turn_ * frame.jet.first.cross(place.across.first).normalized();
            return {contact, contact + place.radius * normal};
        };
        const auto distance = [&](const Tip& from, const Tip& to) {
            return by_tips ? (to.tip - from.tip).norm()
                           : (to.contact - from.contact).norm();
        };
        DirectionCost& cost = travelled.run.cost;
        ++travelled.run.passes;
        cost.ncl += pass.frames.size();
        const Tip front = tip_at(pass.frames.front());
        const Tip back = tip_at(pass.frames.back());
        if (travelled.last && counts_links)
            cost.tcd_mm += distance(*travelled.last, is_marched_as_cut ? front : back);
        travelled.last = is_marched_as_cut ? back : front;
        if (!by_tips) {
            cost.tcd_mm += pass.chord_mm;
            return;
        }
        Tip before = front;
        for (std::size_t i = 1; i < pass.frames.size(); ++i) {
            const Tip here = tip_at(pass.frames[i]);
            cost.tcd_mm += distance(before, here);
            before = here;
        }
    }

    // The parameter of the next pass that the rule `governing` selects; infinite if nothing
    // limits it, nothing if the ball does not fit or a normal is not upward.
    std::optional<double> next_candidate(const PassPoints& pass,
                                         const PassPlace& place) const
    {
        switch (options_.governing) {
            case Governing::Min:
            case Governing::DenseMin:
                return least_candidate(pass, place);
            case Governing::Max:
            case Governing::First:
            case Governing::Mean:
                break;
        }
        double most = -infinity;
        double sum = 0;
        int count = 0;
        for (const AlongFrame& frame : pass.frames) {
            const auto found = candidate(frame, place, infinity);
            if (!found)
                return std::nullopt;
            if (!std::isfinite(*found))
                continue;
            if (options_.governing == Governing::First)
                return found;
            ++count;
            sum += *found;
            most = std::max(most, *found);
        }
        if (count == 0)
            return infinity;
        return options_.governing == Governing::Mean ? sum / count : most;
    }

    // Begins with the contact that governed the pass before: most others are then certain to
    // lie further away.
    std::optional<double> least_candidate(const PassPoints& pass,
                                          const PassPlace& place) const
    {
        const std::size_t likely = std::min(likely_, pass.frames.size() - 1);
        auto best = candidate(pass.frames[likely], place, infinity);
        for (std::size_t i = 0; best && i < pass.frames.size(); ++i) {
            const auto found = candidate(pass.frames[i], place, *best);
            if (found && *found < *best)
                likely_ = i;
            best = lesser(best, found);
        }
        for (std::size_t i = 0; best && i < dense_.size(); ++i)
            best = lesser(best, candidate(dense_[i], place, *best));
        return best;
    }

    // The smaller of two; nothing if the second one is nothing.
    static std::optional<double> lesser(const std::optional<double>& best,
                                        const std::optional<double>& found)
    {
        return found ? std::optional{std::min(*best, *found)} : std::nullopt;
    }

    // The candidate of a contact, infinite if it does not limit the next pass or lies beyond
    // `most_v`; nothing if the ball does not fit or the normal is not upward.
    std::optional<double> candidate(const AlongFrame& frame, const PassPlace& place,
                                    double most_v) const
    {
        const Vec3& p = frame.jet.first;
        const Vec3& q = place.across.first;
        const double q_along = q.dot(frame.feed);
        const Vec3 sideways = q - q_along * frame.feed;
        const double w = sideways.norm();
        const Vec3 normal = turn_ / (frame.speed * w) * p.cross(q);
        if (!(normal.z() > 0))
            return std::nullopt;
        const Vec3 cross_feed = sideways / w;
        const double b = 1 / w;
        const double a = -q_along / (frame.speed * w);
        double k = -(a * a * frame.jet.second + b * b * place.across.second).dot(normal);
        const CrossFrame cross{frame, place, cross_feed, a, b, w};
        if (options_.cross_curvature == CrossCurvature::Chord) {
            const auto [u_eps, v_eps] = partner(cross, options_.cross_step, infinity);
            const Vec3 chord = along_.point(u_eps) - frame.jet.point +
                               across_.point(v_eps) - place.across.point;
            k = -2 * normal.dot(chord) / chord.squaredNorm();
        }
        const auto distance =
            projected_interval(place.radius, k, scallop_, policies_.interval);
        if (!distance || std::isinf(*distance))
            return distance;
        return partner(cross, *distance, most_v).second;
    }

    struct CrossFrame {
        const AlongFrame& along;
        const PassPlace& place;
        const Vec3& cross_feed;
        double a;  // components of T_c
        double b;
        double w;  // B' . T_c
    };

    // The parameters of the point at `distance` in the check plane; v infinite if it is
    // certain to lie beyond `most_v`.
    std::pair<double, double> partner(const CrossFrame& frame, double distance,
                                      double most_v) const
    {
        const AlongFrame& at = frame.along;
        const double u_linear = at.parameter + frame.a * distance;
        const CurveJet& from = frame.place.across;
        const double v_linear = frame.place.v + frame.b * distance;
        const Vec3 bend =
            distance * distance / 2 *
            (frame.a * frame.a * at.jet.second + frame.b * frame.b * from.second);
        const double back_v = bend.dot(frame.cross_feed) / frame.w;
        const double back_u =
            (bend.dot(at.feed) - back_v * from.first.dot(at.feed)) / at.speed;
        double u = u_linear - back_u;
        double v = v_linear - back_v;
        if (v - sure_corrections * (std::abs(back_v) + std::abs(back_u)) > most_v)
            return {u, infinity};
        const Vec3 start = at.jet.point + from.point;
        for (int iteration = 0; iteration <= most_iterations; ++iteration) {
            const CurveJet along = along_.jet(u);
            const CurveJet across = across_.jet(v);
            const Vec3 chord = along.point + across.point - start;
            const double f = chord.dot(at.feed);
            const double g = chord.dot(frame.cross_feed) - distance;
            if (std::max(std::abs(f), std::abs(g)) <= residual_)
                return {u, v};
            const double fu = along.first.dot(at.feed);
            const double fv = across.first.dot(at.feed);
            const double gu = along.first.dot(frame.cross_feed);
            const double gv = across.first.dot(frame.cross_feed);
            const double per_determinant = 1 / (fu * gv - fv * gu);
            const double step_u = (fv * g - gv * f) * per_determinant;
            const double step_v = (gu * f - fu * g) * per_determinant;
            const double pieces = std::max(std::abs(step_u), std::abs(step_v));
            if (!std::isfinite(pieces))
                break;
            const double share =
                pieces <= most_pieces_a_step ? 1 : most_pieces_a_step / pieces;
            u += share * step_u;
            v += share * step_v;
            if (pieces <= last_step)
                return {u, v};
            // Converging steps at least halve: the others add up to at most this one.
            if (pieces <= small_step && v - pieces > most_v)
                return {u, infinity};
        }
        return {u_linear, v_linear};
    }

    std::optional<double> following(double v, double candidate) const
    {
        const double end = across_.end();
        if (candidate < end - end_width)
            return candidate;
        const bool lies_on_border = candidate <= end + end_width;
        const bool half_is_left = end - v >= (candidate - v) / 2;
        if (lies_on_border || options_.last_path == LastPath::Border ||
            (options_.last_path == LastPath::Half && half_is_left))
            return end;
        return std::nullopt;
    }

    CompositeCurve along_;
    CompositeCurve back_;
    CompositeCurve across_;
    double turn_;
    const RunPolicies& policies_;
    const IsoParametricOptions& options_;
    double tolerance_;
    double scallop_;
    double residual_ = 0;
    std::vector<AlongFrame> dense_;
    std::array<PassPoints, 2> equal_;
    // The contact that governed the last pass. It affects the time only.
    mutable std::size_t likely_ = 0;
};

}  // namespace

Surface as_surface(const TranslationalSurface& surface)
{
    std::vector<Vec3> net;
    for (const Vec3& b : surface.along_v.points())
        for (const Vec3& a : surface.along_u.points())
            net.emplace_back(a + b);
    return composite_bezier(surface.along_u.pieces(), surface.along_v.pieces(), net);
}

std::optional<MarchedCurve> march_curve(const CompositeCurve& curve,
                                        double chord_tolerance, EndPoint end_point,
                                        PatchBorders borders)
{
    return march_with(curve, {chord_tolerance, end_point, borders}, curvature_of);
}

bool visit_runs(const TranslationalSurface& surface, const RunPolicies& policies,
                const std::function<bool(const RunPlace&, const TableRun&)>& visit)
{
    const CompositeCurve& a = surface.along_u;
    const CompositeCurve& b = surface.along_v;
    const double turn = a.jet(0).first.cross(b.jet(0).first).z() > 0 ? 1 : -1;
    for (int i = 0; i < 3; ++i) {
        std::array planners{PassPlanner{a, b, turn, policies, table_tolerances_mm[i]},
                            PassPlanner{b, a, -turn, policies, table_tolerances_mm[i]}};
        if (!planners[0].prepare() || !planners[1].prepare())
            return false;
        for (int j = 2; j >= 0; --j)
            for (int k = 0; k < 2; ++k) {
                const auto run =
                    planners[k].run(policies.radius_per_diameter * table_diameters_mm[j]);
                if (!run)
                    return false;
                if (!visit({k, i, j}, *run))
                    return true;
            }
    }
    return true;
}

std::optional<TableRuns> table_runs(const TranslationalSurface& surface,
                                    const RunPolicies& policies)
{
    TableRuns runs{};
    const auto keep = [&](const RunPlace& at, const TableRun& run) {
        runs[at.direction][at.tolerance][at.diameter] = run;
        return true;
    };
    if (!visit_runs(surface, policies, keep))
        return std::nullopt;
    return runs;
}

EconomyTables tables_of(const TableRuns& runs)
{
    EconomyTables tables;
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                tables.runs[k][i][j] = runs[k][i][j].cost;
    return tables;
}

}  // namespace endmill
