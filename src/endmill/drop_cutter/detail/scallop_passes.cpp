// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/scallop_passes.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/mesh/mesh_checks.h"

// The gaps between neighbouring planes are filled independently of each other. A gap is
// divided where the scallop height does not hold, and its parts are examined at those samples
// only. It is divided in the middle, or where the cutter touches both sides of an inner
// corner. The strips between the outermost planes and the borders of the mesh are gaps with a
// pass on one side. If the mesh slopes at such a border, passes beyond it are added at the level
// interval until the contacts have reached the border, and the gaps between them are filled
// too.

namespace endmill {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr std::size_t most_passes = 1'000'000;
// Share by which a length may exceed its limit, for rounding. The pitch of a level plane is
// exactly the level interval.
constexpr double rounding_share = 1e-6;
// Factor up to which the number of samples grows, so that a tiny scallop height takes no more
// than its many planes.
constexpr double most_refinement = 20;
// Rise between two samples, per distance, from which a wall may lie between them. The contacts
// at samples show the slopes below it.
constexpr double wall_slope = 1;
// z of the unit normal below which a face is steep: 45 degrees.
constexpr double steep_normal = 0.7;
// Cosine of the angle, 2.6 degrees, up to which the cutter touches a face and not its edge.
constexpr double same_normal = 0.999;

// A gap is not divided closer to its end than at this share of its width.
constexpr double least_share = 0.125;
// The contact moves this many times as far as the cutter, at least, where a corner is sought.
constexpr double corner_ratio = 1.02;
// A jump of the contact, as a share of the level interval, that leaves the scallop height.
constexpr double least_jump_share = 0.1;
// Beside an inner corner a place is examined if the cutter comes so near to it, as a share of
// the scallop height: half of a limit that exceeds the height by a fifth.
constexpr double reach_share = 0.6;
// Share of the scallop height that passes beside a corner may leave. The rest is for a corner
// across it. There the places that are examined are at most a = sqrt(reach * r / 2) beside the
// cutter's contact, which adds a^2 / (2 r) to the scallop, a quarter of the reach or 0.15 of
// the height. Where more than two faces meet, it is more.
constexpr double corner_share = 0.7;
// Number of places that are examined between a pass and a corner.
constexpr int corner_parts = 5;
// The position of a jump is found to 1/1024 of the distance of the passes.
constexpr int jump_halvings = 10;

// The cutter's tips and contacts in one plane, by sample; nothing where the cutter meets no
// point of the mesh, or where the plane has no pass.
struct SampledPass {
    double position;
    std::vector<std::optional<DropContact>> contacts;
};

using Samples = std::vector<std::size_t>;  // ascending

// Samples of a gap at which the scallop height does not hold, and the plane that divides it.
struct Opening {
    Samples samples;
    double position;  // mm
};

// The places of the cutter on both sides of the plane where its contact jumps.
struct ContactJump {
    double position;  // mm
    DropContact low;
    DropContact high;
};

// The border of a mesh.
class MeshBorder {
public:
    MeshBorder() = default;  // none

    explicit MeshBorder(const TriangleMesh& mesh)
    {
        for (const BoundaryLoop& loop : boundary_loops(mesh)) {
            const std::vector<std::int32_t>& points = loop.points;
            points_.insert(points_.end(), points.begin(), points.end());
            for (std::size_t k = 0; k < points.size(); ++k)
                edges_.push_back(std::minmax(points[k], points[(k + 1) % points.size()]));
        }
        std::ranges::sort(points_);
        std::ranges::sort(edges_);
    }

    // Whether a contact lies on an edge or at a corner of its triangle that belong to the
    // border.
    bool contains(const TriangleMesh& mesh, const DropContact& contact) const
    {
        const auto& triangle = mesh.triangles()[contact.triangle];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t one = triangle[k];
            const std::int32_t other = triangle[(k + 1) % 3];
            const Vec3& from = mesh.points()[one];
            const Vec3 along = mesh.points()[other] - from;
            const Vec3 way = contact.point - from;
            if (way.norm() <= border_rounding && std::ranges::binary_search(points_, one))
                return true;
            if (way.cross(along).norm() <= border_rounding * along.norm() &&
                std::ranges::binary_search(edges_, std::pair<std::int32_t, std::int32_t>{
                                                       std::minmax(one, other)}))
                return true;
        }
        return false;
    }

private:
    std::vector<std::int32_t> points_;                          // ascending
    std::vector<std::pair<std::int32_t, std::int32_t>> edges_;  // ascending
};

class GapFilling {
public:
    GapFilling(const DropCutter& drop_cutter, const MeshBorder& border,
               const DriveFrame& frame, const Interval& along, const PassLimit& limit,
               std::atomic<std::size_t>& count)
        : drop_cutter_{drop_cutter},
          border_{border},
          frame_{frame},
          limit_{limit},
          cutter_{drop_cutter.cutter().radius() - limit.allowance,
                  std::max(0.0, drop_cutter.cutter().corner_radius() - limit.allowance)},
          along_{along},
          count_{count}
    {
        const double length = along.high - along.low;
        const double fine = std::min(std::ceil(4 * length / limit.level_interval) + 1,
                                     most_refinement * limit.samples);
        samples_ = static_cast<std::size_t>(std::max(double(limit.samples), fine));
        step_ = length / static_cast<double>(samples_ - 1);
        const auto chord = [&](double radius) {
            const double h = std::min(limit.height, radius);
            return 2 * std::sqrt(h * (2 * radius - h)) * (1 + rounding_share);
        };
        level_interval_ = limit.level_interval * (1 + rounding_share);
        slope_interval_ = std::min(level_interval_, chord(cutter_.corner_radius()));
        wall_interval_ = chord(cutter_.radius());
        window_ = step_ > 0 ? static_cast<std::size_t>(cutter_.radius() / step_) : 0;
    }

    // The whole of a given plane.
    SampledPass whole(double position) const { return at(position, all()); }

    Samples all() const
    {
        Samples every(samples_);
        for (std::size_t k = 0; k < samples_; ++k)
            every[k] = k;
        return every;
    }

    // Fills the gap from `low` to `high` at some samples. A side without a pass is a border of
    // the mesh.
    void fill(const SampledPass* before, const SampledPass* behind,
              const Interval& across, const Samples& samples)
    {
        if (across.high - across.low <= limit_.height)
            return;
        const double middle = across.low + (across.high - across.low) / 2;
        const double examined = !before ? across.low : !behind ? across.high : middle;
        if (!(across.low < middle && middle < across.high))
            return;
        const auto [open, position] =
            opening(before, behind, at(examined, samples), samples, across);
        if (open.empty())
            return;
        if (++count_ > most_passes)
            throw LimitError{
                "mesh_passes: a scallop height of this mesh takes over a million passes; "
                "expected a larger one"};
        const SampledPass added = at(position, open);
        passes_.push_back({position, stretches(open)});
        fill(before, &added, {across.low, position}, open);
        fill(&added, behind, {position, across.high}, open);
    }

    // Fills the strip between an outermost plane and the border of the mesh, and adds passes
    // beyond the border.
    void fill_outside(const SampledPass& outermost, double border, bool beyond)
    {
        const bool is_low = border < outermost.position;
        const auto strip = [&](double a, double b) {
            return Interval{std::min(a, b), std::max(a, b)};
        };
        const auto fill_between = [&](const SampledPass* outer, const SampledPass& inner,
                                      double end, const Samples& samples) {
            fill(is_low ? outer : &inner, is_low ? &inner : outer,
                 strip(end, inner.position), samples);
        };
        Samples open = beyond ? sloping(at(border, all()), border) : Samples{};
        Samples level;
        std::ranges::set_difference(all(), open, std::back_inserter(level));
        fill_between(nullptr, outermost, border, level);
        SampledPass inner = outermost;
        for (double away = limit_.level_interval; !open.empty();
             away += limit_.level_interval) {
            const double position = border + (is_low ? -away : away);
            SampledPass outer = at(position, open);
            passes_.push_back({position, stretches(open)});
            fill_between(&outer, inner, position, open);
            open = sloping(outer, border);
            inner = std::move(outer);
        }
    }

    std::vector<AddedPass> take() { return std::move(passes_); }

private:
    double s_of(std::size_t sample) const
    {
        return sample + 1 == samples_ ? along_.high
                                      : along_.low + step_ * static_cast<double>(sample);
    }

    SampledPass at(double position, const Samples& samples) const
    {
        SampledPass pass{position, {}};
        pass.contacts.resize(samples_);
        std::optional<std::size_t> hint;
        for (const std::size_t k : samples) {
            const Vec2 place = frame_.point(s_of(k), position, 0).head<2>();
            pass.contacts[k] = drop_cutter_.contact(place, hint);
            if (pass.contacts[k])
                hint = pass.contacts[k]->triangle;
        }
        return pass;
    }

    // The samples of a pass at which the contact has not reached the border.
    Samples sloping(const SampledPass& pass, double border) const
    {
        Samples found;
        for (std::size_t k = 0; k < samples_; ++k)
            if (const auto& contact = pass.contacts[k];
                contact &&
                std::abs(frame_.across(contact->point) - border) > border_rounding)
                found.push_back(k);
        return found;
    }

    // Those of `samples` at which the scallop height does not hold. Most of them decide whether
    // the gap is divided at a corner, or in the middle.
    Opening opening(const SampledPass* before, const SampledPass* behind,
                    const SampledPass& examined, const Samples& samples,
                    const Interval& across) const
    {
        const bool is_wide = width(before, behind, examined) > wall_interval_;
        Samples open;
        std::vector<double> corners;
        for (const std::size_t k : samples)
            if (rolls_off(examined, k)) {
                if (!is_border_covered(before, behind, *examined.contacts[k], k))
                    open.push_back(k);
            } else if (examined.contacts[k] ? (is_wide && is_beside_wall(examined, k)) ||
                                                  are_apart(before, behind, k) ||
                                                  !is_covered(before, behind, examined, k)
                                            : (before && leaves_wall(*before, k)) ||
                                                  (behind && leaves_wall(*behind, k)))
                open.push_back(k);
            else if (const auto corner = open_corner(before, behind, examined, k)) {
                open.push_back(k);
                corners.push_back(*corner);
            }
        const double width = across.high - across.low;
        double position = across.low + width / 2;
        if (2 * corners.size() > open.size()) {
            const auto median =
                corners.begin() + static_cast<std::ptrdiff_t>(corners.size() / 2);
            std::ranges::nth_element(corners, median);
            position = std::clamp(*median, across.low + least_share * width,
                                  across.high - least_share * width);
        }
        return {std::move(open), position};
    }

    // The plane between two passes where the cutter touches both sides of an inner corner, if
    // the passes leave more than the scallop height beside it.
    std::optional<double> open_corner(const SampledPass* before,
                                      const SampledPass* behind,
                                      const SampledPass& examined, std::size_t k) const
    {
        if (!before || !behind || !before->contacts[k] || !behind->contacts[k])
            return std::nullopt;
        const auto jump = contact_jump(*before, *behind, examined, k);
        if (!jump)
            return std::nullopt;
        const auto is_open = [&](const CutterContact& place) {
            const Vec3 above = above_part(place, corner_share);
            return !is_cut(above, *before, k) && !is_cut(above, *behind, k);
        };
        const CutterContact low = place(jump->low, jump->position, k);
        const CutterContact high = place(jump->high, jump->position, k);
        if (is_open(beside(low, high.point)) || is_open(beside(high, low.point)))
            return jump->position;
        for (const SampledPass* pass : {before, behind})
            for (int part = 1; part <= corner_parts; ++part) {
                const double position =
                    jump->position +
                    part * (pass->position - jump->position) / (corner_parts + 1);
                const auto contact =
                    drop_cutter_.contact(frame_.point(s_of(k), position, 0).head<2>(),
                                         pass->contacts[k]->triangle);
                if (contact && is_open(place(*contact, position, k)))
                    return jump->position;
            }
        return is_open(low) || is_open(high) ? std::optional{jump->position}
                                             : std::nullopt;
    }

    // The point and the normal of a contact in a plane at a sample.
    CutterContact place(const DropContact& contact, double position, std::size_t k) const
    {
        const Vec3 tip = frame_.point(s_of(k), position, contact.tip_z);
        return {contact.point, contact_normal(tip, contact.point)};
    }

    // The place beside a contact in a corner, on the way to the contact on its other side, to
    // which the cutter comes within half of the scallop height.
    CutterContact beside(const CutterContact& contact, const Vec3& other) const
    {
        const Vec3 towards = other - contact.point;
        const double rise = towards.dot(contact.normal);
        const Vec3 along = towards - rise * contact.normal;
        const double distance = along.norm();
        if (!(rise > 0 && distance > 0))
            return contact;
        // the tangent of half the angle of the corner is rise / distance
        const double reach =
            std::min(distance / 2, reach_share * limit_.height / 2 * distance / rise);
        return {contact.point + reach / distance * along, contact.normal};
    }

    // By how much the contact moves farther than the cutter between two of its places, whose
    // distance in plan is `apart`. Above 0 an inner corner may lie between them.
    static double excess(const DropContact& one, const DropContact& other, double apart)
    {
        const double moved = std::hypot(apart, other.tip_z - one.tip_z);
        return (other.point - one.point).norm() - corner_ratio * moved;
    }

    // Whether an inner corner across the feed may lie beside a sample.
    bool is_beside_corner(const SampledPass& pass, std::size_t k) const
    {
        const auto& contacts = pass.contacts;
        const auto is_corner_between = [&](std::size_t a, std::size_t b) {
            return contacts[a] && contacts[b] &&
                   excess(*contacts[a], *contacts[b], step_) > 0;
        };
        return (k > 0 && is_corner_between(k - 1, k)) ||
               (k + 1 < samples_ && is_corner_between(k, k + 1));
    }

    // The jump of the contact between two passes at a sample; nothing if it moves evenly. In
    // an inner corner the contact moves farther than the cutter.
    std::optional<ContactJump> contact_jump(const SampledPass& before,
                                            const SampledPass& behind,
                                            const SampledPass& examined,
                                            std::size_t k) const
    {
        Interval across{before.position, behind.position};
        DropContact low = *before.contacts[k];
        DropContact high = *behind.contacts[k];
        DropContact middle = *examined.contacts[k];
        double apart = (across.high - across.low) / 2;
        if (excess(low, high, 2 * apart) <= 0 && excess(low, middle, apart) <= 0 &&
            excess(middle, high, apart) <= 0)
            return std::nullopt;
        for (int halving = 1;; ++halving) {
            if (excess(low, middle, apart) > excess(middle, high, apart)) {
                across.high -= apart;
                high = middle;
            } else {
                across.low += apart;
                low = middle;
            }
            if ((high.point - low.point).norm() <= least_jump_share * level_interval_)
                return std::nullopt;
            apart /= 2;
            const double position = across.low + apart;
            if (halving == jump_halvings)
                return ContactJump{position, low, high};
            const auto contact = drop_cutter_.contact(
                frame_.point(s_of(k), position, 0).head<2>(), low.triangle);
            if (!contact)
                return std::nullopt;
            middle = *contact;
        }
    }

    // The distance of the passes between which another one is examined. The border of the
    // mesh, where there is only one, lies in the middle between two.
    static double width(const SampledPass* before, const SampledPass* behind,
                        const SampledPass& examined)
    {
        if (before && behind)
            return behind->position - before->position;
        return 2 * std::abs((before ? before : behind)->position - examined.position);
    }

    // Whether the cutter touches the face of a steep wall, beside which it loses the mesh. At
    // an edge, around which it only rolls, no pass is needed.
    bool leaves_wall(const SampledPass& pass, std::size_t k) const
    {
        if (!pass.contacts[k])
            return false;
        const DropContact& contact = *pass.contacts[k];
        const auto [a, b, c] = drop_cutter_.mesh().corners(contact.triangle);
        const Vec3 face = (b - a).cross(c - a);
        const Vec3 tip = frame_.point(s_of(k), pass.position, contact.tip_z);
        const double size = face.norm();
        return std::abs(face.z()) < steep_normal * size &&
               std::abs(face.dot(contact_normal(tip, contact.point))) >
                   same_normal * size;
    }

    // Whether the cutter follows a wall across the feed between a sample and one beside it.
    // It cuts the wall with its shank, whose radius may ask for closer passes than the flat
    // bottom does.
    bool is_beside_wall(const SampledPass& pass, std::size_t k) const
    {
        const auto is_wall = [&](std::size_t a, std::size_t b) {
            return pass.contacts[a] && pass.contacts[b] &&
                   std::abs(pass.contacts[a]->tip_z - pass.contacts[b]->tip_z) >
                       wall_slope * step_;
        };
        return (k > 0 && is_wall(k - 1, k)) || (k + 1 < samples_ && is_wall(k, k + 1));
    }

    // Whether the cutter touches the border of level ground, around which it rolls off the
    // mesh.
    bool rolls_off(const SampledPass& pass, std::size_t k) const
    {
        const auto& contact = pass.contacts[k];
        return contact && border_.contains(drop_cutter_.mesh(), *contact) &&
               upper_normal(*contact).z() >= same_normal &&
               contact_normal(frame_.point(s_of(k), pass.position, contact->tip_z),
                              contact->point)
                       .z() < same_normal;
    }

    // The unit normal of the touched triangle, upwards.
    Vec3 upper_normal(const DropContact& contact) const
    {
        const auto [a, b, c] = drop_cutter_.mesh().corners(contact.triangle);
        const Vec3 normal = (b - a).cross(c - a).normalized();
        return normal.z() < 0 ? Vec3{-normal} : normal;
    }

    // Whether the point at the scallop height above a contact on the border, along the normal
    // of the mesh, is cut by a pass beside it. The cutter may do so between two samples.
    bool is_border_covered(const SampledPass* before, const SampledPass* behind,
                           const DropContact& contact, std::size_t k) const
    {
        const Vec3 above = above_part({contact.point, upper_normal(contact)});
        const auto is_cut_by = [&](const SampledPass* pass) {
            return pass && (is_cut(above, *pass, k) || is_cut_between(above, *pass));
        };
        return is_cut_by(before) || is_cut_by(behind);
    }

    // Whether the cutter contains `point` where it passes beside it, between two samples.
    bool is_cut_between(const Vec3& point, const SampledPass& pass) const
    {
        const double place = (frame_.along(point) - along_.low) / step_;
        if (!(place >= 0 && place < static_cast<double>(samples_ - 1)))
            return false;
        const auto k = static_cast<std::size_t>(place);
        if (!pass.contacts[k] || !pass.contacts[k + 1])
            return false;
        const double share = place - static_cast<double>(k);
        const double tip_z =
            std::lerp(pass.contacts[k]->tip_z, pass.contacts[k + 1]->tip_z, share);
        return contains(frame_.point(frame_.along(point), pass.position, tip_z), point);
    }

    // Whether the cutter's places on both sides are farther apart than on level ground, or on
    // a slope, where a flat bottom does not touch: a wall or a steep slope may lie between
    // them.
    bool are_apart(const SampledPass* before, const SampledPass* behind,
                   std::size_t k) const
    {
        if (!before || !behind || !before->contacts[k] || !behind->contacts[k] ||
            rolls_off(*before, k) || rolls_off(*behind, k))
            return false;
        const double rise =
            std::abs(behind->contacts[k]->tip_z - before->contacts[k]->tip_z);
        const double apart = std::hypot(behind->position - before->position, rise);
        return apart > (rise > limit_.height ? slope_interval_ : level_interval_);
    }

    // Whether the point at the scallop height above the contact is cut by a pass beside it.
    bool is_covered(const SampledPass* before, const SampledPass* behind,
                    const SampledPass& examined, std::size_t k) const
    {
        const Vec3 above = above_part(place(*examined.contacts[k], examined.position, k),
                                      is_beside_corner(examined, k) ? corner_share : 1);
        return (before && is_cut(above, *before, k)) ||
               (behind && is_cut(above, *behind, k));
    }

    // The point at the scallop height above a place that the cutter touches.
    Vec3 above_part(const CutterContact& place, double share = 1) const
    {
        return place.point +
               (limit_.allowance + share * limit_.height * (1 + rounding_share)) *
                   place.normal;
    }

    // The normal of the dropped cutter at its contact, into the cutter.
    Vec3 contact_normal(const Vec3& tip, const Vec3& contact) const
    {
        const Cutter& cutter = drop_cutter_.cutter();
        const Vec2 away = tip.head<2>() - contact.head<2>();
        const double distance = away.norm();
        if (distance <= cutter.flat_radius() || !(cutter.corner_radius() > 0))
            return Vec3::UnitZ();
        const double share =
            std::min(1.0, (distance - cutter.flat_radius()) / cutter.corner_radius());
        const Vec2 level = share / distance * away;
        return {level.x(), level.y(), std::sqrt((1 - share) * (1 + share))};
    }

    // Whether the cutter contains `point` at one of the samples of a pass near sample `k`.
    bool is_cut(const Vec3& point, const SampledPass& pass, std::size_t k) const
    {
        const std::size_t first = k > window_ ? k - window_ : 0;
        const std::size_t last = std::min(samples_ - 1, k + window_);
        if (is_cut_at(point, pass, k))
            return true;
        for (std::size_t i = first; i <= last; ++i)
            if (is_cut_at(point, pass, i))
                return true;
        return false;
    }

    bool is_cut_at(const Vec3& point, const SampledPass& pass, std::size_t k) const
    {
        const auto& contact = pass.contacts[k];
        if (!contact)
            return false;
        return contains(frame_.point(s_of(k), pass.position, contact->tip_z), point);
    }

    // Whether the cutter without the allowance contains a point, with its tip dropped to `tip`.
    bool contains(const Vec3& tip, const Vec3& point) const
    {
        const double distance = (point - tip).head<2>().norm();
        // the reference point of both cutters is the same
        const double tip_z =
            tip.z() + drop_cutter_.cutter().corner_radius() - cutter_.corner_radius();
        return distance <= cutter_.radius() &&
               point.z() >= tip_z + cutter_.profile(distance);
    }

    // Stretches around runs of samples, each with one sample more at its ends.
    std::vector<Interval> stretches(const Samples& samples) const
    {
        std::vector<Interval> found;
        std::size_t end = 0;  // of the last stretch
        for (const std::size_t k : samples) {
            const std::size_t first = k > 0 ? k - 1 : 0;
            const std::size_t last = std::min(samples_ - 1, k + 1);
            if (found.empty() || first > end)
                found.push_back({s_of(first), s_of(last)});
            found.back().high = s_of(last);
            end = last;
        }
        return found;
    }

    const DropCutter& drop_cutter_;
    const MeshBorder& border_;
    const DriveFrame& frame_;
    PassLimit limit_;
    Cutter cutter_;  // without the allowance
    Interval along_;
    std::atomic<std::size_t>& count_;
    std::size_t samples_;
    double step_;
    // Largest distances, in mm, of passes on level ground, on a slope across the feed, and of
    // upright passes along a wall.
    double level_interval_;
    double slope_interval_;
    double wall_interval_;
    std::size_t window_;  // samples within the cutter's radius
    std::vector<AddedPass> passes_;
};

void check(const DropCutter& drop_cutter, const DrivePlanes& planes,
           const PassLimit& limit)
{
    require(limit.height > 0 && std::isfinite(limit.height),
            "mesh_passes: need 0 < scallop height");
    require(limit.level_interval > 0 && std::isfinite(limit.level_interval),
            "mesh_passes: need 0 < level interval");
    require(limit.allowance >= 0 && limit.allowance < drop_cutter.cutter().radius(),
            "mesh_passes: need 0 <= allowance < radius");
    require(std::ranges::is_sorted(planes.positions),
            "mesh_passes: need ascending planes");
}

}  // namespace

std::vector<AddedPass> added_passes(const DropCutter& drop_cutter,
                                    const DrivePlanes& planes, const Interval& along,
                                    const PassLimit& limit)
{
    check(drop_cutter, planes, limit);
    const std::vector<double>& positions = planes.positions;
    if (positions.empty())
        return {};
    const Interval across = extent_across(drop_cutter.mesh(), planes.frame);
    const double beyond = limit.beyond_borders ? drop_cutter.cutter().radius() : 0;
    const Interval examined{along.low - beyond, along.high + beyond};
    const MeshBorder border =
        limit.beyond_borders ? MeshBorder{drop_cutter.mesh()} : MeshBorder{};
    std::atomic<std::size_t> count = 0;
    std::vector<std::vector<AddedPass>> added(positions.size() + 1);
    parallel_for(added.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            GapFilling gap{drop_cutter, border, planes.frame, examined, limit, count};
            const bool is_first = k == 0;
            const bool is_last = k == positions.size();
            const SampledPass one = gap.whole(positions[is_first ? 0 : k - 1]);
            if (is_first || is_last)
                gap.fill_outside(one, is_first ? across.low : across.high,
                                 limit.beyond_borders);
            else {
                const SampledPass other = gap.whole(positions[k]);
                gap.fill(&one, &other, {one.position, other.position}, gap.all());
            }
            added[k] = gap.take();
        }
    });
    std::vector<AddedPass> all;
    for (std::vector<AddedPass>& some : added)
        std::ranges::move(some, std::back_inserter(all));
    return all;
}

}  // namespace endmill
