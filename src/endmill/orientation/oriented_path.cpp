// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/oriented_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/cutter/cutting_body.h"
#include "endmill/machine/kinematics.h"
#include "endmill/machine/tool_motion.h"
#include "endmill/mesh/mesh_checks.h"
#include "endmill/orientation/detail/contact_cones.h"
#include "endmill/orientation/detail/field_passes.h"
#include "endmill/orientation/detail/mesh_shape.h"
#include "endmill/orientation/detail/oriented_contacts.h"
#include "endmill/orientation/detail/oriented_surface.h"
#include "endmill/orientation/detail/tool_clearance.h"
#include "endmill/surface/sampling.h"
#include "endmill/surface/tool_side.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

// Distance of a field's triangles from the part, as a share of the inner tolerance.
constexpr double triangle_share = 0.25;
// Triangles of surfaces for visibility cones.
constexpr std::size_t most_cone_triangles = 3'000'000;
// Height of a small lift, and way to the next pass up to which it is enough, in radii.
constexpr double small_lift = 0.5;
constexpr double near_pass = 2;
// Lifted tools lean by at most this: 80 degrees.
constexpr double least_upright = 0.1736;
// The line on which a tilted cutter touches bends: with R 5, r 1, lead 10 and tilt 8 degrees its end
// is 1.18 times as far from the contact as its tangent there at the border of the strip.
constexpr double bent_line = 1.25;
// Parts of the way beyond the end of a pass that are tested, and steps of a tested link in radii.
constexpr int way_parts = 4;
constexpr double tested_step = 0.2;
// Trials for a clean path, and how the aims change between them.
constexpr int most_trials = 8;
constexpr double lower_height = 0.8;
constexpr double closer_rows = 0.5;
// Share by which the greatest remaining stock of a mesh falls with closer passes; else it is
// beyond reach.
constexpr double steady_share = 0.95;
// Distance of the first rays of a judgement, as a share of the cutter's radius.
constexpr double ray_share = 0.2;
// Share of laying passes in the planning of a mesh.
constexpr double laying_share = 0.7;
// Share of planning in the work of a trial.
constexpr double planning_share = 0.3;

// Joins passes to one path.
class OrientedLinking {
public:
    // \param clearance of a mesh, whose links and ends of passes are tested; null: they are
    //        not tested.
    OrientedLinking(const Cutter& cutter, const OrientedOptions& options,
                    const ToolClearance* clearance, OrientedPath& result)
        : cutter_{cutter},
          options_{options},
          clearance_{clearance},
          result_{result},
          body_{cutter}
    {
    }

    void add_pass(const std::vector<PassPose>& rows, int patch)
    {
        patch_ = patch;
        const PassPose& first = rows.front();
        const double ahead = -clear_way(first, -skewed_way(first));
        if (ahead > 0) {
            approach(moved_along(first, -ahead), {});
            add(first, Move::Cut);
        } else {
            approach(first, first.place.at);
        }
        note(first);
        for (std::size_t k = 1; k < rows.size(); ++k) {
            add(rows[k], Move::Cut);
            note(rows[k]);
            result_.cut_contact_mm += contact_way(rows[k - 1], rows[k]);
        }
        last_ = rows.back();
        // Beside the pass the rim of a leaning cutter is behind the contact. It runs on until
        // the rim has left the part over twice the strip, as the part may curve away.
        const double half = std::min(last_.strip_mm, cutter_.radius());
        const double behind =
            cutter_.radius() -
            std::sqrt(cutter_.radius() * cutter_.radius() - half * half) +
            skewed_way(last_);
        if (!cutter_.is_ball() && last_.inclination.lead.radians() >= 0) {
            const double way = clear_way(last_, behind);
            last_ = moved_along(last_, way);
            if (way > 0)
                add_point(last_.location, Move::Cut, {});
        }
        ++result_.passes;
    }

    // Lifts the tool after the last pass.
    void finish() { lift(last_, Move::Retract); }

private:
    double half_strip(const PassPose& pose) const
    {
        return std::min(pose.strip_mm / 2, cutter_.radius());
    }

    // How far the line of contact of a tilted cutter is ahead on one side of the pass, and
    // behind on the other, in mm.
    double skewed_way(const PassPose& pose) const
    {
        if (cutter_.is_ball() || pose.inclination.tilt.radians() == 0)
            return 0;
        const auto skew = contact_skew(cutter_, pose.place.curvature, pose.inclination);
        return std::min(cutter_.radius(),
                        skew ? bent_line * std::abs(*skew) * half_strip(pose) : 0);
    }

    // The pose moved along its feed, off the part.
    static PassPose moved_along(PassPose pose, double way)
    {
        pose.location.tip += way * pose.place.feed;
        return pose;
    }

    // The greatest part of a way along the feed on which a cutter is clear of the mesh.
    double clear_way(const PassPose& pose, double way) const
    {
        if (!clearance_)
            return way;
        double clear = 0;
        for (int k = 1; k <= way_parts; ++k) {
            const double part = way * k / way_parts;
            if (!is_clear(moved_along(pose, part).location))
                break;
            clear = part;
        }
        return clear;
    }

    bool is_clear(const CutterLocation& location) const
    {
        return clearance_->is_clear(body_, frame_at(location), -options_.inner_tolerance);
    }

    // Whether a lifted tool is clear of the mesh on its way, at places in steps of a share of
    // the radius.
    bool is_clear(const ToolMotion& motion) const
    {
        if (!clearance_)
            return true;
        const double way = (motion.to().tip - motion.from().tip).norm();
        const int steps =
            1 + static_cast<int>(std::ceil(way / (tested_step * cutter_.radius())));
        for (int k = 0; k <= steps; ++k)
            if (!is_clear(motion.location(double(k) / steps)))
                return false;
        return true;
    }

    static void widen(AngleExtent& extent, const Angle& angle)
    {
        if (angle.radians() < extent.least.radians())
            extent.least = angle;
        if (angle.radians() > extent.greatest.radians())
            extent.greatest = angle;
    }

    void note(const PassPose& pose)
    {
        const auto& [lead, tilt] = pose.inclination;
        if (is_first_) {
            is_first_ = false;
            result_.lead = {lead, lead};
            result_.tilt = {tilt, tilt};
            result_.narrowest_strip_mm = pose.strip_mm;
        }
        widen(result_.lead, lead);
        widen(result_.tilt, tilt);
        result_.narrowest_strip_mm = std::min(result_.narrowest_strip_mm, pose.strip_mm);
        result_.widest_strip_mm = std::max(result_.widest_strip_mm, pose.strip_mm);
    }

    void add_point(const CutterLocation& location, Move move, KnownContact contact)
    {
        if (result_.path.points.size() >= options_.most_points)
            throw LimitError{"the path needs more points than allowed"};
        result_.path.points.push_back({static_cast<int>(result_.passes), 0, move, patch_,
                                       location, std::move(contact)});
    }

    void add(const PassPose& pose, Move move)
    {
        add_point(pose.location, move, pose.place.at);
    }

    // The tool lifted along its axis by `height` mm.
    static CutterLocation raised(const PassPose& pose, double height)
    {
        const auto& [tip, axis] = pose.location;
        return {tip + height * axis, axis};
    }

    void raise(const PassPose& pose, double height, Move move)
    {
        add_point(raised(pose, height), move, {});
    }

    // Height in mm of the lift along the axis to the safe height.
    double safe_lift(const PassPose& pose) const
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

    void lift(const PassPose& pose, Move move) { raise(pose, safe_lift(pose), move); }

    void approach(const PassPose& pose, const KnownContact& contact)
    {
        if (result_.path.points.empty()) {
            add_point(pose.location, Move::Plunge, contact);
            return;
        }
        const double way = contact_way(last_, pose);
        const double turn =
            std::acos(std::clamp(last_.location.axis.dot(pose.location.axis), -1.0, 1.0));
        const double height = cutter_.radius() * (small_lift + std::sin(turn));
        if (options_.order == PassOrder::ZigZag && turn < std::numbers::pi / 2 &&
            way <= near_pass * cutter_.radius() &&
            is_clear(ToolMotion{raised(last_, height), raised(pose, height)})) {
            raise(last_, height, Move::Retract);
            raise(pose, height, Move::Link);
        } else {
            lift(last_, Move::Retract);
            lift(pose, Move::Rapid);
        }
        add_point(pose.location, Move::Plunge, contact);
    }

    const Cutter& cutter_;
    const OrientedOptions& options_;
    const ToolClearance* clearance_;
    OrientedPath& result_;
    CuttingBody body_;
    PassPose last_{};
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

// Sums up the turns of the axis.
void measure_turns(OrientedPath& result)
{
    double travel = 0;
    const std::vector<PathPoint>& points = result.path.points;
    for (std::size_t k = 1; k < points.size(); ++k) {
        const double turn =
            angle_between(points[k - 1].location.axis, points[k].location.axis);
        travel += turn;
        const SurfaceContact* from = points[k - 1].contact();
        const SurfaceContact* to = points[k].contact();
        if (points[k].move != Move::Cut || !from || !to)
            continue;
        const double way = (to->contact.point - from->contact.point).norm();
        if (way > 0)
            result.most_turn_deg_per_mm = std::max(result.most_turn_deg_per_mm,
                                                   Angle::radians(turn).degrees() / way);
    }
    result.rotary_travel = Angle::radians(travel);
}

// The rows of all passes by the modes Fixed and Lead.
std::vector<PassRows> rows_of_passes(std::span<const OrientedPart* const> parts,
                                     const OrientedOptions& options)
{
    std::vector<PassRows> passes;
    std::size_t points = 0;
    for (std::size_t number = 0; number < parts.size(); ++number) {
        const std::vector<PassLine> lines = parts[number]->passes();
        for (std::size_t k = 0; k < lines.size(); ++k) {
            passes.push_back({number, lines[k], parts[number]->rows(lines[k])});
            points += passes.back().rows.size();
            if (points > options.most_points)
                throw LimitError{"the path needs more points than allowed"};
            if (options.progress)
                options.progress(
                    (static_cast<double>(number) +
                     static_cast<double>(k + 1) / static_cast<double>(lines.size())) /
                    static_cast<double>(parts.size()));
        }
    }
    return passes;
}

// The path over the passes of all parts.
// \param tested clearance of a mesh whose links are tested; null: they are not tested.
OrientedPath linked(const std::vector<PassRows>& passes, const Cutter& cutter,
                    const OrientedOptions& options, const ToolClearance* tested)
{
    OrientedPath result;
    OrientedLinking linking{cutter, options, tested, result};
    for (const PassRows& pass : passes)
        linking.add_pass(pass.rows, static_cast<int>(pass.surface));
    linking.finish();
    number_rows(result.path);
    measure_turns(result);
    return result;
}

// Refuses a mesh whose normals contradict each other.
void require_consistent(const TriangleMesh& mesh)
{
    const std::size_t edges = mesh_report(mesh).inconsistent_edges;
    if (edges > 0)
        throw GeometryError{
            "at " + std::to_string(edges) + (edges == 1 ? " edge" : " edges") +
            " of the mesh the two triangles face opposite sides; expected "
            "triangles that are all counter-clockwise seen from outside"};
}

std::string rounded_text(double value)
{
    return to_text(std::round(value * 1e3) / 1e3);
}

// Refuses a mesh on which a wide cutter gouges in the poses of modes Fixed and Lead. The normals
// of a coarse mesh are not those of its facets, and no row between two poses mends that.
void require_clear_poses(const TriangleMesh& mesh, const ToolPath& path,
                         const Cutter& cutter, double deepest)
{
    const ToolClearance clearance{mesh};
    const CuttingBody body{cutter};
    const double least = -deepest - ToolClearance::accuracy;
    for (const PathPoint& point : path.points) {
        const SurfaceContact* at = point.contact();
        const ToolFrame tool = frame_at(point.location);
        if (!at || clearance.is_clear(body, tool, least))
            continue;
        const Vec3& place = at->contact.point;
        std::ostringstream message;
        message
            << "the cutter gouges the mesh by "
            << rounded_text(-clearance.gap(body, tool, 0)) << " mm at ("
            << rounded_text(place.x()) << ", " << rounded_text(place.y()) << ", "
            << rounded_text(place.z())
            << ") mm; expected a finer mesh, a greater lead, a ball-end cutter or the "
               "mode field";
        throw GeometryError{message.str()};
    }
}

// The aims after a path that is not clean. \param asked the limits of the path.
OrientedOptions aimed_closer(OrientedOptions aimed, const Verification& verification,
                             const OrientedOptions& asked)
{
    const Deviation& found = verification.on_part->deviation;
    const bool may_gouge =
        found.max_gouge_mm + found.gouge_bound_mm > asked.inner_tolerance;
    const bool may_leave =
        found.max_scallop_mm + found.scallop_bound_mm > asked.scallop_height;
    if (may_gouge && (verification.verdict == Verdict::Gouged || !may_leave))
        aimed.inner_tolerance *= closer_rows;
    if (may_leave && (verification.verdict != Verdict::Gouged ||
                      found.max_scallop_mm > asked.scallop_height))
        aimed.scallop_height *= lower_height;
    return aimed;
}

OrientedOptions with_progress(const OrientedOptions& options, double from, double to)
{
    OrientedOptions result = options;
    if (options.progress)
        result.progress = [whole = options.progress, from, to](double share) {
            whole(std::lerp(from, to, share));
        };
    return result;
}

}  // namespace

OrientedPath plan_oriented(std::span<const Surface> surfaces, const Cutter& cutter,
                           const OrientedOptions& options)
{
    require(!surfaces.empty(), "plan_oriented: need a surface");
    require_sound(options, cutter);
    const std::vector<double> sides = tool_side_signs(surfaces, Vec3::UnitZ());
    std::vector<OrientedSurface> oriented;
    oriented.reserve(surfaces.size());
    for (std::size_t number = 0; number < surfaces.size(); ++number)
        oriented.emplace_back(surfaces[number], sides[number], number, cutter, options);
    std::vector<const OrientedPart*> parts;
    parts.reserve(oriented.size());
    for (const OrientedSurface& surface : oriented)
        parts.push_back(&surface);
    std::vector<PassRows> passes = rows_of_passes(parts, options);
    std::optional<double> gap;
    if (options.mode == AxisMode::Field) {
        const ToolClearance clearance{surfaces, sides,
                                      triangle_share * options.inner_tolerance};
        const TriangleMesh sampling =
            sampled(surfaces, sides, options.inner_tolerance, most_cone_triangles).mesh;
        const ContactCones cones{sampling, options.inner_tolerance};
        gap = turn_by_field({parts, clearance, cutter, options, &cones}, passes);
    }
    OrientedPath result = linked(passes, cutter, options, nullptr);
    result.least_gap_mm = gap;
    return result;
}

OrientedPath plan_oriented(const TriangleMesh& mesh, const Cutter& cutter,
                           const OrientedOptions& options)
{
    require(!mesh.triangles().empty(), "plan_oriented: need a triangle");
    require_sound(options, cutter);
    require_consistent(mesh);
    const MeshShape shape{mesh};
    const ToolClearance clearance{mesh};
    const OrientedOptions laying = with_progress(options, 0, laying_share);
    const OrientedOptions posing = with_progress(options, laying_share, 1);
    const LaidContacts laid = oriented_contacts({shape, clearance, cutter, laying});
    const std::vector<const OrientedPart*> parts{&laid.part};
    std::vector<PassRows> passes = rows_of_passes(parts, posing);
    if (passes.empty())
        throw GeometryError{"the cutter reaches no place of the mesh along +z"};
    std::optional<double> gap;
    if (options.mode == AxisMode::Field) {
        const ContactCones cones{mesh, options.inner_tolerance};
        gap = turn_by_field({parts, clearance, cutter, posing, &cones}, passes);
    }
    OrientedPath result = linked(passes, cutter, options, &clearance);
    result.passes = laid.passes;
    result.least_gap_mm = gap;
    return result;
}

JudgedOrientedPath plan_judged_oriented(const Part& part, const Cutter& cutter,
                                        const OrientedOptions& options)
{
    OrientedOptions aimed = with_progress(options, 0, planning_share);
    const auto* mesh = std::get_if<TriangleMesh>(&part);
    // On a mesh, whether passes are closer than before, and the stock that remained, mm.
    bool is_closer = false;
    double left_before = 0;
    for (int trial = 1;; ++trial) {
        OrientedPath plan = std::visit(
            [&](const auto& kind) { return plan_oriented(kind, cutter, aimed); }, part);
        if (mesh && trial == 1 && options.mode != AxisMode::Field && !cutter.is_ball())
            require_clear_poses(*mesh, plan.path, cutter, options.inner_tolerance);
        VerificationTask task{.path = &plan.path,
                              .cutter = cutter,
                              .stock = default_block(&part, plan.path, cutter)};
        task.judged = JudgedPart{
            .part = &part, .limits = {options.inner_tolerance, options.scallop_height}};
        task.judged->skipped_facets = options.mesh_passes.skipped_facets;
        if (options.progress)
            task.judged->progress = [&](double share) {
                options.progress(std::lerp(planning_share, 1.0, share));
            };
        task.resolution = ray_share * cutter.radius();
        task.engine = RemovalEngine::FiveAxis;
        Verification verification = verify_path(task);
        const Deviation& found = verification.on_part->deviation;
        const bool is_beyond_reach = is_closer &&
                                     verification.verdict != Verdict::Gouged &&
                                     found.max_scallop_mm > options.scallop_height &&
                                     !(found.max_scallop_mm < steady_share * left_before);
        if (verification.verdict == Verdict::Clean || trial == most_trials ||
            is_beyond_reach)
            return {std::move(plan), std::move(verification)};
        OrientedOptions closer = aimed_closer(aimed, verification, options);
        is_closer = mesh && closer.scallop_height < aimed.scallop_height;
        left_before = found.max_scallop_mm;
        aimed = std::move(closer);
    }
}

}  // namespace endmill
