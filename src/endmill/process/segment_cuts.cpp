// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/segment_cuts.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/process/detail/cut_moves.h"
#include "endmill/process/detail/move_contacts.h"
#include "endmill/process/detail/pass_index.h"

// Each cut is described in two steps:
// 1. PassIndex finds the nearest earlier pass on each side of the move. The nearer one
//    determines the side of the stock, the pick feed, and whether the move belongs to a
//    first pass.
// 2. The slope mu and the pick feed follow from the contact with the part
//    (`set_by_contact`), or from the line between the ball centres (`set_by_passes`) if
//    there is no usable contact.
// Contacts by projection on a part are computed for all moves beforehand, because the pick
// feed needs the contact of the neighbouring move too. Those that the path states are
// computed for each move, which saves their memory.

namespace endmill {
namespace {

// Tolerance in mm that accepts every foot: the foot of the ball at a neighbouring
// crossing is searched only from the foot at the middle of the neighbouring move, which
// is near.
constexpr double any_distance = 1e300;

void require_sound(const SegmentCutOptions& options)
{
    require(std::isfinite(options.radius) && options.radius > 0,
            "segment_cuts: need 0 < radius");
    require(std::isfinite(options.stock_top), "segment_cuts: need a finite stock top");
    require(options.first_pass != PreviousPass::Beside,
            "segment_cuts: need a first pass in a slot or on an edge");
    require(std::isfinite(options.contact_tolerance) && options.contact_tolerance > 0,
            "segment_cuts: need 0 < contact tolerance");
}

// The earlier pass beside a move, and its side.
struct Neighbour {
    PassCrossing crossing;
    bool is_left;
};

std::optional<Neighbour> nearest(const NeighbouringPasses& passes)
{
    const auto& [left, right] = passes;
    if (left && (!right || left->distance <= right->distance))
        return Neighbour{*left, true};
    if (right)
        return Neighbour{*right, false};
    return std::nullopt;
}

}  // namespace

// Describes the cuts of a path. Constant after construction, so that threads may share
// it.
class SegmentCutFinder::Implementation {
public:
    Implementation(const ToolPath& path, const SegmentCutOptions& options)
        : path_{path},
          options_{options},
          moves_{cut_moves(path)},
          passes_{moves_},
          zero_length_{zero_length_cuts(path)}
    {
        require_ball(path, moves_, {options.radius, options.contact_tolerance});
        if (options.source != CutSource::Passes && !options.part.empty())
            projected_ = projected_contacts(path, moves_, part_.emplace(options.part),
                                            {options.radius, options.contact_tolerance});
    }

    const std::vector<CutMove>& moves() const { return moves_; }
    const ToolPath& path() const { return path_; }
    const SegmentCutOptions& options() const { return options_; }
    std::size_t zero_length() const { return zero_length_; }

    // The earlier passes beside a move. `nearby` are those beside a move nearby.
    NeighbouringPasses passes(std::size_t i, const NeighbouringPasses& nearby) const
    {
        return passes_.beside(i, 2 * options_.radius, nearby);
    }

    // `is_by_contact` is set to 1 if the geometry comes from the contact.
    SegmentCut cut(std::size_t i, const NeighbouringPasses& passes,
                   char& is_by_contact) const
    {
        const CutMove& move = moves_[i];
        const MoveSlope slope = move_slope(move.from(), move.to(), options_.stock_top);
        SegmentCut cut{.pass = move.pass(),
                       .point = path_.points[move.point].point,
                       .length_mm = move.length_mm,
                       .lambda = slope.lambda,
                       .depth_mm = slope.depth_mm,
                       .previous = options_.first_pass};
        const std::optional<Neighbour> neighbour = nearest(passes);
        if (neighbour) {
            cut.previous = PreviousPass::Beside;
            cut.milling = neighbour->is_left ? Milling::Down : Milling::Up;
            cut.has_two_neighbours = passes.left && passes.right;
        }
        const std::optional<MoveContact> at = contact(i);
        is_by_contact = at && set_by_contact(i, *at, neighbour, cut) ? 1 : 0;
        if (is_by_contact == 0 && neighbour)
            set_by_passes(move, neighbour->crossing, cut);
        return cut;
    }

private:
    std::optional<MoveContact> contact(std::size_t i) const
    {
        if (options_.source == CutSource::Passes)
            return std::nullopt;
        return part_ ? projected_[i] : stated_contact(path_, moves_[i]);
    }

    // The line between the ball centres is the pick feed of the model.
    // Source: docs/methods/ball-end-milling.md, section 12.
    static void set_by_passes(const CutMove& move, const PassCrossing& crossing,
                              SegmentCut& cut)
    {
        const Vec3 direction = move.direction();
        const Vec3 left = Vec3{-direction.y(), direction.x(), 0}.normalized();
        const double across = std::abs(crossing.offset.dot(left));
        const double rise = crossing.offset.dot(direction.cross(left));
        cut.mu = std::atan2(rise, across);
        cut.pick_feed_mm = crossing.distance;
        cut.pick_feed_horizontal_mm = across;
    }

    // Returns false where the model does not describe the contact: the normal does not
    // point upwards, or the part is too concave for the ball.
    bool set_by_contact(std::size_t i, const MoveContact& at,
                        const std::optional<Neighbour>& neighbour, SegmentCut& cut) const
    {
        const CutMove& move = moves_[i];
        const Vec3 direction = move.direction();
        const Vec3& stated = at.normal;
        // The normal without its component along the feed, which is 0 in the model.
        const Vec3 normal = (stated - stated.dot(direction) * direction).normalized();
        if (!(normal.z() > 0))
            return false;
        // Direction across the feed on the part, towards the stock.
        const double to_stock = cut.milling == Milling::Down ? 1 : -1;
        const Vec3 across = to_stock * direction.cross(normal);
        const auto feed = neighbour ? pick_feed(i, at, neighbour->crossing, across)
                                    : std::optional<double>{0};
        if (!feed)
            return false;
        cut.mu = std::atan2(across.z(), normal.z());
        if (neighbour) {
            cut.pick_feed_mm = *feed;
            cut.pick_feed_horizontal_mm = *feed * std::cos(*cut.mu);
        }
        return true;
    }

    // The pick feed by eq. (13), or the distance of the ball centres without a part.
    std::optional<double> pick_feed(std::size_t i, const MoveContact& at,
                                    const PassCrossing& crossing,
                                    const Vec3& across) const
    {
        const std::optional<BallFoot>& foot = at.foot;
        if (!foot)
            return crossing.distance;
        const auto curvature = part_->curvature(foot->at, across);
        if (!curvature || !(1 + options_.radius * *curvature > 0))
            return std::nullopt;
        const Vec3 centre =
            moves_[i].middle() - crossing.offset + options_.radius * Vec3::UnitZ();
        const BallFoot beside = part_->foot(centre, projected_[crossing.move]->foot->at,
                                            options_.radius, any_distance);
        const double distance =
            (foot->point - beside.point).cross(moves_[i].direction()).norm();
        return distance * (1 + options_.radius * *curvature);
    }

    const ToolPath& path_;
    SegmentCutOptions options_;
    std::vector<CutMove> moves_;
    PassIndex passes_;
    std::size_t zero_length_;
    std::optional<ContactSearch> part_;
    std::vector<std::optional<MoveContact>>
        projected_;  // one per move, if there is a part
};

namespace {

// Checks that every cut was described by its contact.
void require_contacts(const ToolPath& path, const SegmentCuts& cuts,
                      const std::vector<char>& by_contact)
{
    for (std::size_t i = 0; i < by_contact.size(); ++i)
        if (by_contact[i] == 0) {
            const PathPoint& point = path.points[cuts.points[i]];
            throw GeometryError{"no contact with the part on the move to point " +
                                std::to_string(point.point) + " of pass " +
                                std::to_string(point.pass) +
                                "; expected a path with normals at both ends, and a ball "
                                "that fits the part"};
        }
}

}  // namespace

MoveSlope move_slope(const Vec3& from, const Vec3& to, double stock_top)
{
    const Vec3 direction = (to - from) / (to - from).norm();
    const Vec3 middle = (from + to) / 2;
    return {std::asin(direction.z()), stock_top - middle.z()};
}

SegmentCutFinder::SegmentCutFinder(const ToolPath& path, const SegmentCutOptions& options)
{
    require_sound(options);
    implementation_ = std::make_unique<const Implementation>(path, options);
}

SegmentCutFinder::~SegmentCutFinder() = default;

std::size_t SegmentCutFinder::size() const
{
    return implementation_->moves().size();
}

std::size_t SegmentCutFinder::zero_length() const
{
    return implementation_->zero_length();
}

std::size_t SegmentCutFinder::point(std::size_t number) const
{
    return implementation_->moves()[number].point;
}

bool SegmentCutFinder::has_depth() const
{
    const double top = implementation_->options().stock_top;
    return std::ranges::any_of(implementation_->moves(), [&](const CutMove& move) {
        return move_slope(move.from(), move.to(), top).depth_mm > 0;
    });
}

SegmentCuts SegmentCutFinder::cuts(std::size_t first, std::size_t count) const
{
    SegmentCuts cuts;
    cuts.cuts.resize(count);
    std::vector<char> by_contact(count);
    parallel_for(count, [&](std::size_t begin, std::size_t end) {
        NeighbouringPasses passes;
        for (std::size_t i = begin; i < end; ++i) {
            passes = implementation_->passes(first + i, passes);
            cuts.cuts[i] = implementation_->cut(first + i, passes, by_contact[i]);
        }
    });
    cuts.points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        cuts.points.push_back(point(first + i));
        ++(by_contact[i] != 0 ? cuts.by_contact : cuts.by_passes);
    }
    if (implementation_->options().source == CutSource::Contact)
        require_contacts(implementation_->path(), cuts, by_contact);
    return cuts;
}

SegmentCuts segment_cuts(const ToolPath& path, const SegmentCutOptions& options)
{
    const SegmentCutFinder finder{path, options};
    SegmentCuts cuts = finder.cuts(0, finder.size());
    cuts.zero_length = finder.zero_length();
    return cuts;
}

}  // namespace endmill
