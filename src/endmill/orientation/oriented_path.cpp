// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/oriented_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/cutter/cutting_body.h"
#include "endmill/machine/tool_motion.h"
#include "endmill/surface/curvature.h"
#include "endmill/surface/largest_cutter.h"
#include "endmill/surface/tool_side.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

// Lead beyond the least one at which the cutter fits.
constexpr double spare_lead_deg = 1;
// Share of a strip by which neighbouring passes are apart, for curvature that changes within
// a strip.
constexpr double used_strip = 0.97;
// Contacts in each patch at which the width of a strip is examined.
constexpr int examined_contacts = 24;
// Rounds in which the distance of two passes is adapted to the narrower strip.
constexpr int adapting_rounds = 4;
// Shares of the tolerances that a motion between two rows may use.
constexpr double gouge_share = 0.5;
constexpr double left_share = 0.05;
// Greatest turn of the axis, and greatest way in radii of the cutter, between two rows.
constexpr double most_turn_deg = 10;
constexpr double most_way = 1;
constexpr int most_halvings = 20;
// Places between two rows at which the motion is examined, and parts of a step up to which
// the cutter may be ahead of them or behind.
constexpr int examined_places = 4;
constexpr double shift = 0.05;
// Height of a small lift, and way to the next pass up to which it is enough, in radii.
constexpr double small_lift = 0.5;
constexpr double near_pass = 2;
// Lifted tools lean by at most this: 80 degrees.
constexpr double least_upright = 0.1736;
// Trials for a clean path, and how the aims change between them.
constexpr int most_trials = 4;
constexpr double lower_height = 0.8;
constexpr double closer_rows = 0.5;
// Distance of the first rays of a judgement, as a share of the cutter's radius.
constexpr double ray_share = 0.2;
// Share of planning in the work of a trial.
constexpr double planning_share = 0.3;

void require_sound(std::span<const Surface> surfaces, const Cutter& cutter,
                   const OrientedOptions& options)
{
    require(!surfaces.empty(), "plan_oriented: need a surface");
    require(options.scallop_height > 0 && options.scallop_height < cutter.radius(),
            "plan_oriented: need a scallop height above 0 and below the radius");
    require(options.inner_tolerance > 0 && options.inner_tolerance < cutter.radius(),
            "plan_oriented: need an inner tolerance above 0 and below the radius");
    require(std::isfinite(options.safe_height), "plan_oriented: need a safe height");
}

// A contact of the tool, with its pose.
struct Pose {
    SurfaceContact at;
    CutterLocation location;
    Angle lead = Angle::radians(0);
    double strip_mm = 0;
    double across = 0;  // mm per unit of the parameter across the feed
    Vec3 feed = Vec3::Zero();
};

// The poses on one surface.
class OrientedSurface {
public:
    OrientedSurface(const Surface& surface, double side, std::size_t number,
                    const Cutter& cutter, const OrientedOptions& options)
        : surface_{surface},
          side_{side},
          number_{number},
          cutter_{cutter},
          options_{options}
    {
        const auto range = curvature_range(surface, side);
        const double concave = range ? -range->least : 0;
        concave_radius_ =
            concave > 0 ? 1 / concave : std::numeric_limits<double>::infinity();
    }

    Parameter across() const
    {
        return options_.along == Parameter::U ? Parameter::V : Parameter::U;
    }

    Interval along_range() const { return surface_.range(options_.along); }
    Interval across_range() const { return surface_.range(across()); }

    // Parameters along a pass at which strips are examined: some in each patch.
    std::vector<double> examined() const
    {
        const std::span<const double> breaks = surface_.breaks(options_.along);
        std::vector<double> places{breaks.front()};
        places.reserve((breaks.size() - 1) * examined_contacts + 1);
        for (std::size_t k = 1; k < breaks.size(); ++k)
            for (int part = 1; part <= examined_contacts; ++part)
                places.push_back(std::lerp(breaks[k - 1], breaks[k],
                                           double(part) / examined_contacts));
        return places;
    }

    // The pose at a place of a pass that runs towards larger parameters, or smaller ones.
    Pose pose(double along, double across, bool is_forward) const
    {
        const bool is_u = options_.along == Parameter::U;
        const SurfacePoint at =
            is_u ? SurfacePoint{along, across} : SurfacePoint{across, along};
        const SurfaceJet jet = surface_.jet(at.u, at.v);
        const FundamentalForms forms = fundamental_forms(jet, side_);
        const Vec3 line = is_u ? jet.du : jet.dv;
        const Vec3 feed = (is_forward ? line : Vec3{-line}).normalized();
        const Vec3 left = forms.normal.cross(feed);
        const ContactCurvature curvature = curvature_at(forms, jet, feed, left);
        const Inclination inclination = inclination_at(curvature, at, jet.point);
        const auto strip =
            strip_width(cutter_, curvature, inclination, options_.scallop_height);
        if (!strip)
            throw_gouge(curvature, at, jet.point);
        const Vec3 axis = inclined_axis(forms.normal, feed, inclination);
        const CutterContact contact{jet.point, forms.normal};
        return {{at.u, at.v, contact},
                {control_point(cutter_, contact, ControlPoint::Tip, axis), axis},
                inclination.lead,
                *strip,
                std::abs((is_u ? jet.dv : jet.du).dot(left)),
                feed};
    }

    // Half the part of the strip that counts, as a length of the parameter across, at the
    // narrowest place of a pass.
    double reach(double across, std::span<const double> places) const
    {
        double least = std::numeric_limits<double>::infinity();
        for (const double along : places)
            for (const bool is_forward : {true, false}) {
                const Pose at = pose(along, across, is_forward);
                least = std::min(least, used_strip * at.strip_mm / 2 / at.across);
            }
        return least;
    }

    // The parameters of all passes.
    std::vector<double> passes() const
    {
        const std::vector<double> places = examined();
        const double low = across_range().low;
        const double high = across_range().high;
        // the place whose strip ends `way` before it or after it
        const auto place_beyond = [&](double end) {
            double place = end;
            for (int round = 0; round < adapting_rounds; ++round)
                place = std::min(high, end + reach(place, places));
            return std::min(place, end + reach(place, places));
        };
        std::vector<double> found{place_beyond(low)};
        for (;;) {
            const double end = found.back() + reach(found.back(), places);
            if (end >= high)
                return found;
            const double next = place_beyond(end);
            require(next > found.back(), "plan_oriented: strips have no width");
            found.push_back(next);
        }
    }

    // The poses of a pass, as many as the tolerances need.
    std::vector<Pose> rows(double across, bool is_forward) const
    {
        const std::span<const double> breaks = surface_.breaks(options_.along);
        std::vector<Pose> found{
            pose(is_forward ? breaks.front() : breaks.back(), across, is_forward)};
        for (std::size_t k = 1; k < breaks.size(); ++k) {
            const std::size_t number = is_forward ? k : breaks.size() - 1 - k;
            add_rows(pose(breaks[number], across, is_forward), across, is_forward,
                     most_halvings, found);
        }
        return found;
    }

private:
    static ContactCurvature curvature_at(const FundamentalForms& forms,
                                         const SurfaceJet& jet, const Vec3& feed,
                                         const Vec3& left)
    {
        const TangentVector f = tangent_components(forms, jet, feed);
        const TangentVector b = tangent_components(forms, jet, left);
        return {normal_curvature(forms, f), normal_curvature(forms, b),
                -(forms.e * f.a * b.a + forms.f * (f.a * b.b + f.b * b.a) +
                  forms.g * f.b * b.b)};
    }

    Inclination inclination_at(const ContactCurvature& curvature, const SurfacePoint& at,
                               const Vec3& point) const
    {
        Inclination inclination = options_.inclination;
        if (options_.mode == AxisMode::Fixed)
            return inclination;
        const auto beside = least_lead(cutter_, curvature);
        const auto heel = heel_lead(cutter_, concave_radius_);
        if (!beside || !heel)
            throw_gouge(curvature, at, point);
        const double needed = std::max(beside->degrees(), heel->degrees());
        const double spare = needed > 0 ? spare_lead_deg : 0;
        inclination.lead =
            Angle::degrees(std::max(inclination.lead.degrees(), needed + spare));
        return inclination;
    }

    [[noreturn]] void throw_gouge(const ContactCurvature& curvature,
                                  const SurfacePoint& at, const Vec3& point) const
    {
        std::ostringstream message;
        message << "the cutter does not fit at " << place_text(at, point);
        if (number_ > 0)
            message << " of patch " << number_;
        const auto least = least_lead(cutter_, curvature);
        if (least)
            message << " with this inclination; the least lead there is "
                    << to_text(std::ceil(100 * least->degrees()) / 100)
                    << " degrees without tilt";
        else
            message << " with any lead; choose a smaller cutter or corner radius";
        throw GeometryError{message.str()};
    }

    double along_of(const Pose& pose) const
    {
        return options_.along == Parameter::U ? pose.at.u : pose.at.v;
    }

    void add_rows(const Pose& to, double across, bool is_forward, int halvings,
                  std::vector<Pose>& rows) const
    {
        const Pose from = rows.back();
        if (halvings == 0 || is_fine(from, to, across, is_forward)) {
            rows.push_back(to);
            return;
        }
        const Pose middle = pose((along_of(from) + along_of(to)) / 2, across, is_forward);
        add_rows(middle, across, is_forward, halvings - 1, rows);
        add_rows(to, across, is_forward, halvings - 1, rows);
    }

    // Whether the motion between two rows keeps its tolerances at contacts between them.
    bool is_fine(const Pose& from, const Pose& to, double across, bool is_forward) const
    {
        const CuttingBody body{cutter_};
        const double way = (to.at.contact.point - from.at.contact.point).norm();
        if (way > most_way * cutter_.radius() ||
            from.location.axis.dot(to.location.axis) <
                std::cos(Angle::degrees(most_turn_deg).radians()))
            return false;
        const ToolMotion motion{from.location, to.location};
        const double most_left =
            std::min(left_share * options_.scallop_height, options_.inner_tolerance);
        for (int k = 1; k < examined_places; ++k) {
            const double share = double(k) / examined_places;
            const Pose wanted =
                pose(std::lerp(along_of(from), along_of(to), share), across, is_forward);
            double least = std::numeric_limits<double>::infinity();
            for (const double u : {share - shift, share, share + shift})
                least = std::min(
                    least, body.distance(motion.seen(wanted.at.contact.point, u)).value);
            if (least > most_left || least < -gouge_share * options_.inner_tolerance)
                return false;
        }
        return true;
    }

    const Surface& surface_;
    double side_;
    std::size_t number_;
    const Cutter& cutter_;
    const OrientedOptions& options_;
    double concave_radius_;
};

// Joins passes to one path.
class OrientedLinking {
public:
    OrientedLinking(const Cutter& cutter, const OrientedOptions& options,
                    OrientedPath& result)
        : cutter_{cutter},
          options_{options},
          result_{result}
    {
    }

    void add_pass(const std::vector<Pose>& rows, int patch)
    {
        patch_ = patch;
        approach(rows.front());
        note(rows.front());
        for (std::size_t k = 1; k < rows.size(); ++k) {
            add(rows[k], Move::Cut);
            note(rows[k]);
            result_.cut_contact_mm +=
                (rows[k].at.contact.point - rows[k - 1].at.contact.point).norm();
        }
        last_ = rows.back();
        // Beside the pass the rim of a leaning cutter is behind the contact. It runs on until
        // the rim has left the part over the whole strip.
        const double half = std::min(last_.strip_mm / 2, cutter_.radius());
        const double behind =
            cutter_.radius() -
            std::sqrt(cutter_.radius() * cutter_.radius() - half * half);
        if (!cutter_.is_ball() && last_.lead.radians() >= 0) {
            last_.location.tip += behind * last_.feed;
            add_point(last_.location, Move::Cut, {});
        }
        ++result_.passes;
    }

    // Lifts the tool after the last pass.
    void finish() { lift(last_, Move::Retract); }

private:
    void note(const Pose& pose)
    {
        const bool is_first = is_first_;
        is_first_ = false;
        if (is_first || pose.lead.radians() < result_.least_lead.radians())
            result_.least_lead = pose.lead;
        if (is_first || pose.lead.radians() > result_.greatest_lead.radians())
            result_.greatest_lead = pose.lead;
        if (is_first || pose.strip_mm < result_.narrowest_strip_mm)
            result_.narrowest_strip_mm = pose.strip_mm;
    }

    void add_point(const CutterLocation& location, Move move, KnownContact contact)
    {
        if (result_.path.points.size() >= options_.most_points)
            throw LimitError{"the path needs more points than allowed"};
        result_.path.points.push_back({static_cast<int>(result_.passes), 0, move, patch_,
                                       location, std::move(contact)});
    }

    void add(const Pose& pose, Move move) { add_point(pose.location, move, pose.at); }

    // The tool lifted along its axis by `height` mm.
    void raise(const Pose& pose, double height, Move move)
    {
        const auto& [tip, axis] = pose.location;
        add_point({tip + height * axis, axis}, move, {});
    }

    // Height in mm of the lift along the axis to the safe height.
    double safe_lift(const Pose& pose) const
    {
        const auto& [tip, axis] = pose.location;
        if (axis.z() < least_upright)
            throw GeometryError{
                "the tool leans by more than 80 degrees at the end of a pass, so that it "
                "cannot be lifted to the safe height along its axis"};
        // the lowest point of the cutter may be lower than its tip
        const double lowest = tip.z() - cutter_.radius() * std::hypot(axis.x(), axis.y());
        return std::max(0.0, (options_.safe_height - lowest) / axis.z());
    }

    void lift(const Pose& pose, Move move) { raise(pose, safe_lift(pose), move); }

    void approach(const Pose& pose)
    {
        if (result_.path.points.empty()) {
            add(pose, Move::Plunge);
            return;
        }
        const double way = (pose.at.contact.point - last_.at.contact.point).norm();
        const double turn =
            std::acos(std::clamp(last_.location.axis.dot(pose.location.axis), -1.0, 1.0));
        if (options_.order == PassOrder::ZigZag && turn < std::numbers::pi / 2 &&
            way <= near_pass * cutter_.radius()) {
            const double height = cutter_.radius() * (small_lift + std::sin(turn));
            raise(last_, height, Move::Retract);
            raise(pose, height, Move::Link);
        } else {
            lift(last_, Move::Retract);
            lift(pose, Move::Rapid);
        }
        add(pose, Move::Plunge);
    }

    const Cutter& cutter_;
    const OrientedOptions& options_;
    OrientedPath& result_;
    Pose last_{};
    int patch_ = 0;
    bool is_first_ = true;
};

void number_rows(ToolPath& path)
{
    int pass = -1;
    int next = 0;
    for (PathPoint& point : path.points) {
        next = point.pass == pass ? next + 1 : 0;
        pass = point.pass;
        point.point = next;
    }
}

}  // namespace

OrientedPath plan_oriented(std::span<const Surface> surfaces, const Cutter& cutter,
                           const OrientedOptions& options)
{
    require_sound(surfaces, cutter, options);
    const std::vector<double> sides = tool_side_signs(surfaces, Vec3::UnitZ());
    OrientedPath result;
    OrientedLinking linking{cutter, options, result};
    for (std::size_t number = 0; number < surfaces.size(); ++number) {
        const OrientedSurface surface{surfaces[number], sides[number], number, cutter,
                                      options};
        const std::vector<double> passes = surface.passes();
        for (std::size_t k = 0; k < passes.size(); ++k) {
            const bool is_forward = options.order == PassOrder::OneWay || k % 2 == 0;
            linking.add_pass(surface.rows(passes[k], is_forward),
                             static_cast<int>(number));
            if (options.progress)
                options.progress(
                    (static_cast<double>(number) +
                     static_cast<double>(k + 1) / static_cast<double>(passes.size())) /
                    static_cast<double>(surfaces.size()));
        }
    }
    linking.finish();
    number_rows(result.path);
    return result;
}

JudgedOrientedPath plan_judged_oriented(std::span<const Surface> surfaces,
                                        const Cutter& cutter,
                                        const OrientedOptions& options)
{
    const Part part{std::vector<Surface>(surfaces.begin(), surfaces.end())};
    OrientedOptions aimed = options;
    if (options.progress)
        aimed.progress = [&](double share) { options.progress(planning_share * share); };
    for (int trial = 1;; ++trial) {
        OrientedPath plan = plan_oriented(surfaces, cutter, aimed);
        VerificationTask task{.path = &plan.path,
                              .cutter = cutter,
                              .stock = default_block(&part, plan.path, cutter)};
        task.judged = JudgedPart{
            .part = &part, .limits = {options.inner_tolerance, options.scallop_height}};
        if (options.progress)
            task.judged->progress = [&](double share) {
                options.progress(std::lerp(planning_share, 1.0, share));
            };
        task.resolution = ray_share * cutter.radius();
        task.engine = RemovalEngine::FiveAxis;
        Verification verification = verify_path(task);
        const Verdict verdict = verification.verdict;
        if (verdict == Verdict::Clean || trial == most_trials)
            return {std::move(plan), std::move(verification)};
        if (verdict == Verdict::Gouged)
            aimed.inner_tolerance *= closer_rows;
        else
            aimed.scallop_height *= lower_height;
    }
}

}  // namespace endmill
