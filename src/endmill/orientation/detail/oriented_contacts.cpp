// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/oriented_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/cutter/cutting_body.h"
#include "endmill/strategy/detail/mesh_net.h"
#include "endmill/strategy/strategy.h"

namespace endmill {
namespace {

// Share of the scallop height for which passes are laid. The rest is for what the motion
// between two rows leaves.
constexpr double between_passes = 0.95;
// Share of the inner tolerance that the path of the ball has. The rest is for leaning axes.
constexpr double ball_tolerance = 0.5;
// Share of a strip that a field must keep, as on surfaces.
constexpr double used_field_strip = 0.9;
// Greatest scallop height of the ball in its radii.
constexpr double most_height = 0.3;
// Share of the curvature of the ball that a concave part has at most where it touches.
constexpr double most_concave = 0.999;
// Facets at which strips are compared, and directions of the feed at each.
constexpr std::size_t compared_facets = 2000;
constexpr int compared_feeds = 8;
// Facets with a lower z of their normal do not count: passes are laid from above.
constexpr double least_facing = 1e-3;
// Steps by which a pass is continued, in radii of the cutter, and share of a step by which the
// mesh may be away from the tangent.
constexpr double step_share = 0.25;
constexpr double most_off_tangent = 0.3;
// Contacts whose balls are nearer than this, in mm, are one.
constexpr double same_centre = 1e-9;
// Share of the inner tolerance by which a continued pass may gouge.
constexpr double gouge_share = 0.5;

// The part of a vector across the unit normal, made unit; any tangent if there is none.
Vec3 tangent_of(const Vec3& vector, const Vec3& normal)
{
    const Vec3 tangent = vector - normal.dot(vector) * normal;
    const double length = tangent.norm();
    return length > same_centre ? Vec3{tangent / length} : normal.unitOrthogonal();
}

// The curvature along a feed and across. A ball fits at the contact, so the part is less concave
// than the ball is convex, whatever a coarse mesh seems to be.
ContactCurvature curvature_along(const Eigen::Matrix3d& tensor, const Vec3& normal,
                                 const Vec3& feed, double radius)
{
    Eigen::Matrix<double, 3, 2> basis;
    basis << feed, normal.cross(feed);
    const Eigen::Matrix2d flat = basis.transpose() * tensor * basis;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
    solver.computeDirect(flat);
    const Eigen::Vector2d kept = solver.eigenvalues().cwiseMax(-most_concave / radius);
    const Eigen::Matrix2d tame =
        solver.eigenvectors() * kept.asDiagonal() * solver.eigenvectors().transpose();
    return {tame(0, 0), tame(1, 1), tame(0, 1)};
}

bool faces_up(const ShapePlace& place)
{
    return place.normal.z() > least_facing;
}

// The numbers of some facets that face up, evenly through the mesh.
std::vector<std::size_t> facets_to_compare(const MeshShape& shape)
{
    const std::size_t count = shape.mesh().triangles().size();
    const std::size_t step = std::max<std::size_t>(1, count / compared_facets);
    std::vector<std::size_t> found;
    found.reserve(count / step + 1);
    for (std::size_t facet = 0; facet < count; facet += step)
        if (faces_up(shape.middle(facet)))
            found.push_back(facet);
    return found;
}

// The least radius in mm of a concave curvature at facets that face up.
double concave_radius(const MeshShape& shape, double radius)
{
    double concave = 0;
    for (const std::size_t facet : facets_to_compare(shape)) {
        const ShapePlace at = shape.middle(facet);
        const Vec3 feed = tangent_of(Vec3::UnitX(), at.normal);
        const auto [along, across, mixed] =
            curvature_along(at.tensor, at.normal, feed, radius);
        const double least =
            (along + across) / 2 - std::hypot((along - across) / 2, mixed);
        concave = std::max(concave, -least);
    }
    return concave > 0 ? 1 / concave : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<ContactCurve> contact_curves(const ToolPath& path)
{
    std::vector<ContactCurve> curves;
    bool is_open = false;
    for (const PathPoint& point : path.points) {
        const SurfaceContact* at = point.contact();
        if (!at) {
            is_open = false;
            continue;
        }
        if (!is_open || point.move != Move::Cut)
            curves.emplace_back();
        is_open = true;
        curves.back().push_back(at->contact);
    }
    return curves;
}

OrientedContacts::OrientedContacts(const MeshShape& shape,
                                   std::span<const ContactCurve> curves, double height,
                                   const Cutter& cutter, const OrientedOptions& options)
    : OrientedPart{cutter, options, concave_radius(shape, cutter.radius())},
      shape_{shape},
      height_{height}
{
    curves_.reserve(curves.size());
    for (const ContactCurve& contacts : curves)
        curves_.push_back(curve_of(contacts));
}

OrientedContacts::Curve OrientedContacts::curve_of(const ContactCurve& contacts) const
{
    require(!contacts.empty(), "OrientedContacts: need a contact on each curve");
    Curve found;
    found.reserve(contacts.size());
    for (const CutterContact& contact : contacts) {
        const Vec3 centre = contact.point + cutter().radius() * contact.normal;
        const double step = found.empty() ? 0 : (centre - found.back().centre).norm();
        if (found.empty() || step > same_centre)
            found.push_back({contact, centre, Vec3::Zero(),
                             found.empty() ? 0 : found.back().along + step});
    }
    for (std::size_t k = 0; k < found.size(); ++k) {
        const Vec3& before = found[k == 0 ? k : k - 1].centre;
        const Vec3& after = found[std::min(k + 1, found.size() - 1)].centre;
        found[k].feed = tangent_of(after - before, found[k].contact.normal);
    }
    return found;
}

std::vector<PassLine> OrientedContacts::passes() const
{
    std::vector<PassLine> lines;
    lines.reserve(curves_.size());
    for (std::size_t k = 0; k < curves_.size(); ++k)
        lines.push_back({static_cast<double>(k)});
    return lines;
}

CutterContact OrientedContacts::contact_between(const CurvePoint& from,
                                                const CurvePoint& to, double share) const
{
    const Vec3 normal =
        (from.contact.normal + share * (to.contact.normal - from.contact.normal))
            .normalized();
    if (cutter().is_ball()) {
        const Vec3 centre = from.centre + share * (to.centre - from.centre);
        return {centre - cutter().radius() * normal, normal};
    }
    return {
        shape_
            .nearest(from.contact.point + share * (to.contact.point - from.contact.point))
            .point,
        normal};
}

PassPlace OrientedContacts::place_at(const CutterContact& contact, const Vec3& feed) const
{
    PassPlace place{{contact.point.x(), contact.point.y(), contact}};
    place.feed = tangent_of(feed, contact.normal);
    place.curvature = curvature_along(shape_.nearest(contact.point).tensor,
                                      contact.normal, place.feed, cutter().radius());
    place.across = 1;
    return place;
}

PassPlace OrientedContacts::place(double along, const PassLine& line) const
{
    const Curve& points = curve(line);
    const auto next = std::ranges::upper_bound(points, along, {}, &CurvePoint::along);
    const CurvePoint& to = next == points.end() ? points.back() : *next;
    const CurvePoint& from = next == points.begin() ? to : *std::prev(next);
    const double way = to.along - from.along;
    const double share = way > 0 ? std::clamp((along - from.along) / way, 0.0, 1.0) : 0.0;
    PassPlace found = place_at(contact_between(from, to, share),
                               from.feed + share * (to.feed - from.feed));
    found.along = along;
    return found;
}

std::vector<double> OrientedContacts::fixed_rows(const PassLine& line) const
{
    std::vector<double> rows;
    rows.reserve(curve(line).size());
    for (const CurvePoint& point : curve(line))
        rows.push_back(point.along);
    return rows;
}

double OrientedContacts::needed_strip(const PassPlace& place, const PassLine&) const
{
    const auto strip =
        strip_width(Cutter::ball(cutter().radius()), place.curvature, {}, height_);
    return strip ? *strip / used_field_strip : 0;
}

std::string OrientedContacts::name_of(const PassPlace& place) const
{
    const Vec3& point = place.at.contact.point;
    const auto rounded = [](double value) {
        return to_text(std::round(value * 1e3) / 1e3);
    };
    std::string name{"("};
    name.append(rounded(point.x())).append(", ").append(rounded(point.y()));
    return name.append(", ").append(rounded(point.z())).append(") mm");
}

namespace {

// The scallop height for which the ball's strips are nowhere wider than those of the cutter.
double ball_height(const ContactTask& task)
{
    const double height = task.options.scallop_height;
    const Cutter& cutter = task.cutter;
    const double most = std::max(height, most_height * cutter.radius());
    if (cutter.is_ball())
        return between_passes * height;
    const OrientedContacts part{task.shape, {}, height, cutter, task.options};
    const Cutter ball = Cutter::ball(cutter.radius());
    double ratio = most / height;
    for (const std::size_t facet : facets_to_compare(task.shape)) {
        const ShapePlace at = task.shape.middle(facet);
        const Vec3 first = tangent_of(Vec3::UnitX(), at.normal);
        for (int k = 0; k < compared_feeds; ++k) {
            const double turn = 2 * std::numbers::pi * k / compared_feeds;
            const PassPlace place = part.place_at(
                {at.point, at.normal},
                std::cos(turn) * first + std::sin(turn) * at.normal.cross(first));
            const auto inclination = part.fitting_inclination(place);
            if (!inclination)
                continue;
            const auto own = strip_width(cutter, place.curvature, *inclination, height);
            const auto of_ball = strip_width(ball, place.curvature, {}, height);
            if (own && of_ball)
                ratio = std::min(ratio, *own * *own / (*of_ball * *of_ball));
        }
    }
    return between_passes * ratio * height;
}

TriangleMesh without(const TriangleMesh& mesh, std::span<const std::size_t> skipped)
{
    std::vector<Triangle> kept;
    kept.reserve(mesh.triangles().size());
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k)
        if (!std::ranges::binary_search(skipped, k))
            kept.push_back(mesh.triangles()[k]);
    return {{mesh.points().begin(), mesh.points().end()}, std::move(kept)};
}

CoveringPath ball_path(const ContactTask& task, double height)
{
    const MeshPassOptions& laid = task.options.mesh_passes;
    const BallCutter ball{task.cutter.radius()};
    StrategyOptions options;
    options.scallop_height = height;
    options.inner_tolerance = ball_tolerance * task.options.inner_tolerance;
    options.link.order = task.options.order;
    options.link.safe_height = task.options.safe_height;
    options.direction = laid.direction;
    options.most_points = task.options.most_points;
    options.most_samples = laid.most_samples;
    options.progress = task.options.progress;
    const Part whole{task.shape.mesh()};
    if (laid.skipped_facets.empty())
        return covering_by_strategy(laid.strategy, whole, ball, options);
    options.protected_part =
        std::make_shared<const ProtectedPart>(whole, ball, options.inner_tolerance);
    const Part cut{without(task.shape.mesh(), laid.skipped_facets)};
    return covering_by_strategy(laid.strategy, cut, ball, options);
}

// Continues curves on the mesh.
class CurveContinuation {
public:
    // \param reach way in mm by which curves are continued.
    CurveContinuation(const ContactTask& task, const OrientedContacts& part, double reach)
        : task_{task},
          part_{part},
          body_{task.cutter},
          reach_{reach}
    {
    }

    ContactCurve continued(const ContactCurve& curve) const
    {
        if (curve.size() < 2 ||
            (curve.front().point - curve.back().point).norm() <= same_centre)
            return curve;
        ContactCurve found = ahead_of(curve[1], curve.front(), -1);
        std::ranges::reverse(found);
        found.insert(found.end(), curve.begin(), curve.end());
        const ContactCurve after = ahead_of(curve[curve.size() - 2], curve.back(), 1);
        found.insert(found.end(), after.begin(), after.end());
        return found;
    }

private:
    // Contacts beyond `end`, away from `before`. \param side 1 in the direction of the feed.
    ContactCurve ahead_of(const CutterContact& before, const CutterContact& end,
                          double side) const
    {
        const double radius = task_.cutter.radius();
        const auto steps = static_cast<int>(std::ceil(reach_ / (step_share * radius)));
        ContactCurve found;
        CutterContact at = end;
        Vec3 way = tangent_of(
            (end.point + radius * end.normal) - (before.point + radius * before.normal),
            end.normal);
        for (int k = 0; k < steps; ++k) {
            const double step = reach_ / steps;
            const Vec3 aim = at.point + step * way;
            const ShapePlace place = task_.shape.nearest(aim);
            if ((place.point - aim).norm() > most_off_tangent * step ||
                place.normal.dot(at.normal) < std::cos(crease_angle) || !faces_up(place))
                break;
            way = tangent_of(way, place.normal);
            at = {place.point, place.normal};
            if (!is_clear(at, side * way))
                break;
            found.push_back(at);
        }
        return found;
    }

    bool is_clear(const CutterContact& contact, const Vec3& feed) const
    {
        const PassPlace place = part_.place_at(contact, feed);
        const auto inclination = part_.fitting_inclination(place);
        if (!inclination)
            return false;
        const Vec3 axis = inclined_axis(contact.normal, place.feed, *inclination);
        const CutterLocation location{
            control_point(task_.cutter, contact, ControlPoint::Tip, axis), axis};
        return task_.clearance.is_clear(body_, frame_at(location),
                                        -gouge_share * task_.options.inner_tolerance);
    }

    const ContactTask& task_;
    const OrientedContacts& part_;
    CuttingBody body_;
    double reach_;
};

}  // namespace

LaidContacts oriented_contacts(const ContactTask& task)
{
    const double height = ball_height(task);
    const CoveringPath laid = ball_path(task, height);
    std::vector<ContactCurve> curves = contact_curves(laid.path);
    if (!task.cutter.is_ball()) {
        const OrientedContacts part{task.shape, {}, height, task.cutter, task.options};
        const double reach = std::sqrt(height * (2 * task.cutter.radius() - height));
        const CurveContinuation continuation{task, part, reach};
        for (ContactCurve& curve : curves)
            curve = continuation.continued(curve);
    }
    return {{task.shape, curves, height, task.cutter, task.options}, laid.passes};
}

}  // namespace endmill
