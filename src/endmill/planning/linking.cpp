// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/linking.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/planning/detail/contact_line.h"

namespace endmill {
namespace {

// Shares of the way to the safe height by which an arch is raised, in the order of trial.
constexpr std::array arch_shares{0.125, 0.25, 0.5};

// The location at the safe height above `location`.
CutterLocation lifted(const CutterLocation& location, const LinkOptions& options)
{
    const double height = location.tip.dot(options.axis);
    if (height > options.safe_height)
        throw GeometryError{"the safe height " + to_text(options.safe_height) +
                            " mm lies below the path, which reaches " + to_text(height) +
                            " mm"};
    return {location.tip + (options.safe_height - height) * options.axis, location.axis};
}

using IsClear = std::function<bool(const Vec3& from, const Vec3& to)>;

// By how much an arch between two contacts is raised, mm; nothing if there is none. It travels
// at feed where a lifted link plunges, so it must not be longer than retract and plunge.
std::optional<double> arch_height(const SurfaceContact& from, const SurfaceContact& to,
                                  const BallCutter& cutter, const LinkOptions& options,
                                  const IsClear& is_clear)
{
    const Vec3 start = ball_centre(from, cutter);
    const Vec3 end = ball_centre(to, cutter);
    const double safe = options.safe_height + cutter.radius();
    const double up = safe - start.dot(options.axis);
    const double down = safe - end.dot(options.axis);
    for (const double share : arch_shares) {
        const double height = share * std::min(up, down);
        if (!(height > 0) || 2 * height + (end - start).norm() > up + down)
            return std::nullopt;
        const Vec3 raise = height * options.axis;
        if (is_clear(start + raise, end + raise))
            return height;
    }
    return std::nullopt;
}

// How two pieces are linked, and by how much an arch is raised.
enum class LinkKind { Straight, Arched, Lifted };
struct ChosenLink {
    LinkKind kind;
    double height = 0;  // mm
};

ChosenLink chosen_link(const SurfaceContact& from, const SurfaceContact& to,
                       const BallCutter& cutter, const LinkOptions& options,
                       const IsClear& is_clear)
{
    if (is_clear(ball_centre(from, cutter), ball_centre(to, cutter)))
        return {LinkKind::Straight};
    if (options.barred == BarredLink::Arched)
        if (const auto height = arch_height(from, to, cutter, options, is_clear))
            return {LinkKind::Arched, *height};
    return {LinkKind::Lifted};
}

// Appends moves between contacts to a path, and numbers its passes and points.
class PathBuilder {
public:
    PathBuilder(const BallCutter& cutter, const LinkOptions& options, std::size_t points)
        : cutter_{cutter},
          options_{options}
    {
        path_.points.reserve(points);
    }

    void start_pass() { point_ = 0, ++pass_; }

    void add(Move move, const SurfaceContact& contact)
    {
        add(move, locate(cutter_, contact.contact, options_.axis), contact);
    }

    // Appends a retract by `height` mm and a link to as much above `contact`. A plunge follows.
    void arch_over(const SurfaceContact& contact, double height)
    {
        CutterLocation from = path_.points.back().location;
        CutterLocation to = locate(cutter_, contact.contact, options_.axis);
        from.tip += height * options_.axis;
        to.tip += height * options_.axis;
        add(Move::Retract, from);
        add(Move::Link, to);
    }

    // Appends a retract and a rapid to the place above `contact`. A plunge may follow.
    void lift_over(const SurfaceContact& contact)
    {
        const CutterLocation next = locate(cutter_, contact.contact, options_.axis);
        add(Move::Retract, lifted(path_.points.back().location, options_));
        add(Move::Rapid, lifted(next, options_));
    }

    // Appends the moves of a link up to the place above `contact`.
    // \return the move that leads to the contact.
    Move lead_over(const ChosenLink& link, const SurfaceContact& contact)
    {
        if (link.kind == LinkKind::Straight)
            return Move::Link;
        if (link.kind == LinkKind::Arched)
            arch_over(contact, link.height);
        else
            lift_over(contact);
        return Move::Plunge;
    }

    ToolPath take() { return std::move(path_); }

private:
    void add(Move move, const CutterLocation& location, const KnownContact& known = {})
    {
        path_.points.push_back({pass_, point_++, move, 0, location, known});
    }

    const BallCutter& cutter_;
    const LinkOptions& options_;
    ToolPath path_;
    int pass_ = -1;
    int point_ = 0;
};

// Appends trimmed curves to a path as passes of cutter tips.
class SectionPath {
public:
    SectionPath(const DriveFrame& frame, const Cutter& cutter, const LinkOptions& options)
        : frame_{frame},
          corner_radius_{cutter.corner_radius()},
          safe_height_{options.safe_height}
    {
    }

    void reserve(std::size_t points) { path_.points.reserve(points); }

    void add_pass(const TrimmedCurve& curve, double across, bool backwards)
    {
        const std::size_t count = curve.points.size();
        point_ = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const SectionPoint& at = curve.points[backwards ? count - 1 - k : k].at;
            const Vec3 tip = tip_of(at, across);
            if (k == 0 && pass_ > 0)
                lift_over(tip);
            add(k == 0 ? Move::Plunge : Move::Cut, tip);
        }
        ++pass_;
    }

    ToolPath take() { return std::move(path_); }

private:
    // The tip for a reference point, which lies one corner radius above it.
    Vec3 tip_of(const SectionPoint& at, double across) const
    {
        Vec3 tip = frame_.point(at.x(), across, at.y() - corner_radius_);
        if (tip.z() > safe_height_)
            throw GeometryError{"the safe height " + to_text(safe_height_) +
                                " mm lies below the path, which reaches " +
                                to_text(tip.z()) + " mm"};
        return tip;
    }

    void lift_over(const Vec3& next)
    {
        const Vec3& last = path_.points.back().location.tip;
        const Vec3 up{last.x(), last.y(), safe_height_};
        add(Move::Retract, up);
        add(Move::Rapid, {next.x(), next.y(), safe_height_});
    }

    void add(Move move, const Vec3& tip)
    {
        path_.points.push_back({pass_, point_++, move, 0, {tip, Vec3::UnitZ()}});
    }

    const DriveFrame& frame_;
    double corner_radius_;
    double safe_height_;
    ToolPath path_;
    int pass_ = 0;
    int point_ = 0;
};

}  // namespace

ToolPath link_passes(std::span<const Pass> passes, const BallCutter& cutter,
                     const LinkOptions& options)
{
    std::size_t contacts = 0;
    for (const Pass& pass : passes)
        contacts += pass.size();
    const auto next = [at = passes.begin()]() mutable {
        return std::span<const SurfaceContact>{*at++};
    };
    return link_passes_one_by_one({passes.size(), contacts, next}, cutter, options);
}

ToolPath link_passes_one_by_one(const PassSource& source, const BallCutter& cutter,
                                const LinkOptions& options)
{
    const bool one_way = options.order == PassOrder::OneWay;
    const std::size_t lifts = one_way ? 2 * source.passes : 0;
    PathBuilder builder{cutter, options, source.contacts + lifts};
    for (std::size_t number = 0; number < source.passes; ++number) {
        const std::span<const SurfaceContact> pass = source.next();
        const bool backwards = !one_way && number % 2 == 1;
        const auto contact = [&](std::size_t k) -> const SurfaceContact& {
            return pass[backwards ? pass.size() - 1 - k : k];
        };
        builder.start_pass();
        const bool lift = one_way && number > 0;
        if (lift)
            builder.lift_over(contact(0));
        builder.add(lift || number == 0 ? Move::Plunge : Move::Link, contact(0));
        for (std::size_t k = 1; k < pass.size(); ++k)
            builder.add(Move::Cut, contact(k));
    }
    return builder.take();
}

LinkedPath link_pieces(
    std::span<const PassPiece> pieces, const BallCutter& cutter,
    const LinkOptions& options,
    const std::function<bool(const Vec3& from, const Vec3& to)>& is_clear)
{
    std::size_t points = 2 * pieces.size();
    for (const PassPiece& piece : pieces)
        points += piece.contacts.size();
    PathBuilder builder{cutter, options, points};
    std::size_t lifted_links = 0;
    std::size_t arched_links = 0;
    const PassPiece* previous = nullptr;
    for (const PassPiece& piece : pieces) {
        const SurfaceContact& first = piece.contacts.front();
        const bool is_new = !previous || previous->pass != piece.pass;
        if (is_new)
            builder.start_pass();
        Move move = Move::Plunge;
        if (previous) {
            const bool returns = is_new && options.order == PassOrder::OneWay;
            const ChosenLink link = returns
                                        ? ChosenLink{LinkKind::Lifted}
                                        : chosen_link(previous->contacts.back(), first,
                                                      cutter, options, is_clear);
            move = builder.lead_over(link, first);
            arched_links += link.kind == LinkKind::Arched ? 1 : 0;
            lifted_links += link.kind == LinkKind::Lifted && !returns ? 1 : 0;
        }
        builder.add(move, first);
        for (std::size_t k = 1; k < piece.contacts.size(); ++k)
            builder.add(Move::Cut, piece.contacts[k]);
        previous = &piece;
    }
    return {builder.take(), lifted_links, arched_links};
}

ToolPath join_paths(std::span<const ToolPath> paths, const LinkOptions& options)
{
    ToolPath joined;
    int passes = 0;
    for (std::size_t number = 0; number < paths.size(); ++number) {
        const auto& points = paths[number].points;
        if (points.empty())
            continue;
        const int patch = static_cast<int>(number);
        int lifts = 0;  // points of the lift, which belong to the first pass of this path
        if (!joined.points.empty()) {
            const CutterLocation from = lifted(joined.points.back().location, options);
            const CutterLocation to = lifted(points.front().location, options);
            joined.points.push_back({passes, 0, Move::Retract, patch, from});
            joined.points.push_back({passes, 1, Move::Rapid, patch, to});
            lifts = 2;
        }
        for (PathPoint point : points) {
            if (point.pass == 0)
                point.point += lifts;
            point.pass += passes;
            point.patch = patch;
            joined.points.push_back(point);
        }
        passes = joined.points.back().pass + 1;
    }
    return joined;
}

ToolPath link_sections(std::span<const PlaneCurves> planes, const DriveFrame& frame,
                       const Cutter& cutter, const LinkOptions& options)
{
    require(options.axis == Vec3::UnitZ(), "link_sections: the axis must be +z");
    std::size_t points = 0;
    for (const PlaneCurves& plane : planes)
        for (const TrimmedCurve& curve : plane.curves)
            points += curve.points.size() + 2;
    SectionPath path{frame, cutter, options};
    path.reserve(points);
    for (std::size_t k = 0; k < planes.size(); ++k) {
        const auto& [across, curves] = planes[k];
        const bool backwards = options.order == PassOrder::ZigZag && k % 2 == 1;
        for (std::size_t c = 0; c < curves.size(); ++c)
            path.add_pass(curves[backwards ? curves.size() - 1 - c : c], across,
                          backwards);
    }
    return path.take();
}

ToolPath link_sections(std::span<const Trimmed> trimmed, const DrivePlanes& planes,
                       const Cutter& cutter, const LinkOptions& options)
{
    require(trimmed.size() == planes.positions.size(),
            "link_sections: need a section for each plane");
    std::vector<PlaneCurves> curves;
    curves.reserve(trimmed.size());
    for (std::size_t k = 0; k < trimmed.size(); ++k)
        curves.push_back({planes.positions[k], trimmed[k].curves});
    return link_sections(curves, planes.frame, cutter, options);
}

}  // namespace endmill
