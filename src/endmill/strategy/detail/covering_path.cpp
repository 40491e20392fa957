// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/covering_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/strategy/detail/coverage.h"
#include "endmill/strategy/detail/covering_pieces.h"
#include "endmill/strategy/detail/pass_moves.h"
#include "endmill/strategy/detail/piece_joining.h"
#include "endmill/strategy/detail/reach.h"

namespace endmill {
namespace {

// Share of the scallop height by which moves may miss what the rolling balls cover.
constexpr double move_share = 0.01;
// Share of the scallop height at which places count as missed. The rest is for the error of
// places between samples.
constexpr double mend_share = 0.996;
// Rounds in which passes are bent towards places that their moves miss.
constexpr int mending_rounds = 8;
// The round from which short passes that were left out are laid again, and the one from which
// places that bends do not cover get passes of their own.
constexpr int restoring_round = 4;
constexpr int adding_round = 6;
// Passes shorter than this share of the width of a strip are left out where bends of other
// passes can cover what they cover.
constexpr double short_pass_share = 0.4;
// A bend exceeds its first-order value by this factor in the first round, and by more in
// each further one.
constexpr double first_excess = 1.5;
constexpr double excess_growth = 0.3;
// Least distance of two places at which a pass is bent in a round, in half widths of a strip.
constexpr double bend_distance = 1;
// Least gap that a pass is bent to close, as a share of the scallop height.
constexpr double least_bend = 0.002;

// How far passes are bent.
struct BendSize {
    double height;  // scallop height, mm
    double excess;  // by what factor the bend exceeds its first-order value
    bool restores;  // whether passes that were left out are laid again where they help
    bool adds;      // whether places get passes of their own
};

// Passes with the pieces into which they are divided.
class DividedPasses {
public:
    DividedPasses(std::vector<LaidPass> passes, const PartSamples& samples,
                  const CoveredPart& part, double height)
        : samples_{samples},
          part_{part},
          limits_{layout_share * height, move_share * height},
          passes_{std::move(passes)},
          numbers_(passes_.size()),
          divisions_(passes_.size(), PassDivision{samples, part, limits_}),
          is_changed_(passes_.size(), 1),
          is_dropped_(passes_.size(), 0)
    {
    }

    std::span<const LaidPass> passes() const { return passes_; }
    bool is_dropped(std::size_t number) const { return is_dropped_[number] != 0; }

    // Leaves out the passes that are shorter than `length` mm.
    void drop_shorter_than(double length)
    {
        for (std::size_t k = 0; k < passes_.size(); ++k)
            is_dropped_[k] = pass_length(passes_[k]) < length ? 1 : 0;
    }
    void restore(std::size_t number)
    {
        is_dropped_[number] = 0;
        is_changed_[number] = 1;
    }

    void add(LaidPass pass)
    {
        passes_.push_back(std::move(pass));
        numbers_.emplace_back();
        divisions_.emplace_back(samples_, part_, limits_);
        is_changed_.push_back(1);
        is_dropped_.push_back(0);
    }

    // The pass `number`, which is divided again.
    LaidPass& changed_pass(std::size_t number)
    {
        is_changed_[number] = 1;
        return passes_[number];
    }

    // Divides the passes that were changed.
    void divide(CoveringPieces& covering)
    {
        std::vector<std::vector<LaidPass>> pieces(passes_.size());
        parallel_for(passes_.size(), [&](std::size_t begin, std::size_t end) {
            MoveTestState state;
            for (std::size_t k = begin; k < end; ++k)
                if (is_changed_[k] != 0 && !is_dropped(k))
                    pieces[k] = divisions_[k].pieces_of(passes_[k], state);
        });
        for (std::size_t k = 0; k < passes_.size(); ++k) {
            if (std::exchange(is_changed_[k], 0) == 0)
                continue;
            for (const std::size_t number : std::exchange(numbers_[k], {}))
                covering.remove(number);
            for (LaidPass& piece : pieces[k])
                numbers_[k].push_back(covering.add(std::move(piece)));
        }
    }

private:
    const PartSamples& samples_;
    const CoveredPart& part_;
    MoveLimits limits_;
    std::vector<LaidPass> passes_;
    std::vector<std::vector<std::size_t>> numbers_;  // of the pieces of each pass
    std::vector<PassDivision> divisions_;
    std::vector<char> is_changed_;
    std::vector<char> is_dropped_;
};

// The pieces in an order with short links.
std::vector<PassPiece> in_cutting_order(std::span<const LaidPass> pieces,
                                        const BallCutter& cutter,
                                        const LinkOptions& options)
{
    std::vector<PassPiece> ordered;
    ordered.reserve(pieces.size());
    for (const OrderedPiece& place : cutting_order(pieces, cutter, options)) {
        PassPiece piece{static_cast<int>(ordered.size()), {}};
        for (const PassContact& contact : contacts_in_order(pieces[place.piece], place))
            piece.contacts.push_back(contact.at);
        ordered.push_back(std::move(piece));
    }
    return ordered;
}

// A contact of a list of passes.
struct ContactNumber {
    std::size_t pass;
    std::size_t contact;
};

// The contacts of passes, by the samples beside them.
class ContactsBySample {
public:
    ContactsBySample(std::span<const LaidPass> passes, const PartSamples& samples)
        : samples_{samples},
          walk_{samples},
          first_(samples.size(), -1)
    {
        for (std::size_t pass = 0; pass < passes.size(); ++pass)
            for (std::size_t k = 0; k < passes[pass].contacts.size(); ++k) {
                std::int32_t& first = first_[passes[pass].contacts[k].near];
                entries_.push_back({{pass, k}, first});
                first = static_cast<std::int32_t>(entries_.size() - 1);
            }
    }

    // The contacts within a distance of a place, in a fixed order.
    std::vector<ContactNumber> near(const PassContact& place, double distance)
    {
        std::vector<ContactNumber> found;
        walk_.from(std::array{place.near}, [&](std::int32_t i) {
            for (std::int32_t k = first_[i]; k >= 0; k = entries_[k].next)
                found.push_back(entries_[k].number);
            return (samples_.point(i) - place.at.contact.point).norm() < distance;
        });
        return found;
    }

private:
    struct Entry {
        ContactNumber number;
        std::int32_t next;  // at the same sample, or -1
    };

    const PartSamples& samples_;
    SampleWalk walk_;
    std::vector<std::int32_t> first_;  // at each sample, or -1
    std::vector<Entry> entries_;
};

// A contact that is added to a pass after one of its contacts.
struct AddedContact {
    ContactNumber after;
    PassContact contact;
};

// Changes passes so that their moves reach places that they miss. Where a ball on a pass
// reaches the place, its moves have to pass through there. Otherwise the pass is bent towards
// the place just so far that its ball reaches it.
class PassMending {
public:
    PassMending(DividedPasses& divided, const PartSamples& samples,
                const BallCutter& cutter, const BendSize& size)
        : divided_{divided},
          samples_{samples},
          radius_{cutter.radius()},
          size_{size},
          half_width_{strip_width(cutter, size.height) / 2},
          contacts_{divided.passes(), samples}
    {
    }

    void mend(std::vector<MissedPlace> places)
    {
        std::stable_sort(
            places.begin(), places.end(),
            [](const MissedPlace& a, const MissedPlace& b) { return a.gap > b.gap; });
        for (const MissedPlace& place : places)
            if (size_.adds)
                add_pass(contact_at(samples_, place));
            else if (place.gap <= size_.height)
                mend(contact_at(samples_, place));
        add_contacts();
        for (const PassContact& contact : own_)
            divided_.add({{contact}, false});
    }

private:
    const PassContact& at(const ContactNumber& number) const
    {
        return divided_.passes()[number.pass].contacts[number.contact];
    }

    // The contact after a contact of a pass, or the last one.
    ContactNumber after(const ContactNumber& number) const
    {
        const LaidPass& pass = divided_.passes()[number.pass];
        const std::size_t next = number.contact + 1;
        if (next < pass.contacts.size())
            return {number.pass, next};
        return {number.pass, pass.is_closed ? 0 : number.contact};
    }

    Vec3 centre(const ContactNumber& number) const
    {
        const CutterContact& contact = at(number).at.contact;
        return contact.point + radius_ * contact.normal;
    }

    void mend(const PassContact& place)
    {
        const CutterContact& aim = place.at.contact;
        const Vec3 raised = aim.point + size_.height * aim.normal;
        std::optional<ContactNumber> best;
        double least = size_.height;
        std::optional<std::size_t> dropped;
        for (const ContactNumber& number : contacts_.near(place, 2 * half_width_)) {
            const UprightSweep sweep{centre(number), centre(after(number))};
            const double gap = beyond_reach(sweep.squared_distance(raised), radius_);
            if (divided_.is_dropped(number.pass)) {
                if (gap <= 0 && (!dropped || number.pass < *dropped))
                    dropped = number.pass;
            } else if (gap < least) {
                least = gap;
                best = number;
            }
        }
        if (dropped && (size_.restores || !best)) {
            divided_.restore(*dropped);
            return;
        }
        if (!best)
            return;
        if (least <= 0 && !(at(*best).is_required && at(after(*best)).is_required)) {
            require(*best);
            require(after(*best));
        } else {
            bend(*best, place, std::max(least, least_bend * size_.height));
        }
    }

    void add_pass(const PassContact& place)
    {
        const Vec3& point = place.at.contact.point;
        if (std::none_of(own_.begin(), own_.end(), [&](const PassContact& other) {
                return (other.at.contact.point - point).norm() < half_width_ / 2;
            }))
            own_.push_back(place);
    }

    void require(const ContactNumber& number)
    {
        divided_.changed_pass(number.pass).contacts[number.contact].is_required = true;
    }

    void bend(const ContactNumber& number, const PassContact& place, double gap)
    {
        const Vec3& point = at(number).at.contact.point;
        const double distance = (place.at.contact.point - point).norm();
        const bool is_bent =
            std::any_of(added_.begin(), added_.end(), [&](const AddedContact& other) {
                return other.after.pass == number.pass &&
                       (other.contact.at.contact.point - point).norm() <
                           bend_distance * half_width_;
            });
        if (is_bent || !(distance > 0) || !samples_.is_joined(at(number), place))
            return;
        // the gap decreases by about half_width / R per mm of bend
        const double way = size_.excess * gap * radius_ / half_width_;
        added_.push_back(
            {number, samples_.between(at(number), place, std::min(1.0, way / distance))});
        added_.back().contact.is_required = true;
    }

    // Adds contacts from the last one on, so that the numbers of the others stay valid.
    void add_contacts()
    {
        std::sort(added_.begin(), added_.end(),
                  [](const AddedContact& a, const AddedContact& b) {
                      return a.after.pass != b.after.pass
                                 ? a.after.pass > b.after.pass
                                 : a.after.contact > b.after.contact;
                  });
        for (const AddedContact& one : added_) {
            std::vector<PassContact>& own =
                divided_.changed_pass(one.after.pass).contacts;
            own.insert(own.begin() + static_cast<std::ptrdiff_t>(one.after.contact) + 1,
                       one.contact);
        }
    }

    DividedPasses& divided_;
    const PartSamples& samples_;
    double radius_;
    BendSize size_;
    double half_width_;
    ContactsBySample contacts_;
    std::vector<AddedContact> added_;
    std::vector<PassContact> own_;  // contacts of passes of their own
};

BendSize mending_size(double height, int round)
{
    return {height, first_excess + excess_growth * round, round >= restoring_round,
            round >= adding_round};
}

// The greatest distance in mm at which a contact is held off its surface.
double greatest_hold(std::span<const LaidPass> pieces, std::span<const Surface> surfaces)
{
    double greatest = 0;
    if (surfaces.empty())
        return greatest;
    for (const LaidPass& piece : pieces)
        for (const PassContact& contact : piece.contacts) {
            const auto& [u, v, held] = contact.at;
            const Vec3 point = surfaces[contact.surface].tangents(u, v).point;
            greatest = std::max(greatest, (held.point - point).norm());
        }
    return greatest;
}

double area(const PartSamples& samples, std::int32_t triangle)
{
    const auto& [a, b, c] = samples.triangles()[triangle];
    return (samples.point(b) - samples.point(a))
               .cross(samples.point(c) - samples.point(a))
               .norm() /
           2;
}

}  // namespace

CoveringPath covering_path(LaidPasses laid, const CoveredPart& part,
                           const BallCutter& cutter, const StrategyOptions& options)
{
    const double height = options.scallop_height;
    const std::size_t passes = laid.passes.size();
    DividedPasses divided{std::move(laid.passes), laid.samples, part, height};
    divided.drop_shorter_than(short_pass_share * strip_width(cutter, height));
    CoveringPieces covering{laid.samples, cutter, mend_share * height};
    std::vector<MissedPlace> uncovered;
    for (int round = 0;; ++round) {
        divided.divide(covering);
        uncovered = covering.missed();
        if (uncovered.empty() || round == mending_rounds)
            break;
        if (options.progress)
            options.progress((round + 1.0) / mending_rounds);
        PassMending{divided, laid.samples, cutter,
                    mending_size(mend_share * height, round)}
            .mend(std::move(uncovered));
    }
    join_pieces(covering, laid.samples, part,
                {layout_share * height, move_share * height}, options);
    uncovered = covering.missed();
    std::vector<LaidPass> pieces;
    for (const LaidPass& piece : covering.pieces())
        if (!piece.contacts.empty())
            pieces.push_back(piece);

    CoveringPath plan;
    plan.passes = passes;
    plan.pieces = pieces.size();
    plan.unreached_mm2 = laid.samples.unwanted_area();
    // a lift by t takes t cos(a) from the reach of the points around a contact
    plan.stray_mm =
        std::max(options.inner_tolerance,
                 move_share * height * cutter.radius() / (cutter.radius() - height));
    if (options.protected_part)
        plan.stray_mm += greatest_hold(pieces, part.surfaces());
    for (const MissedPlace& place : uncovered) {
        const PassContact at = contact_at(laid.samples, place);
        plan.uncovered_mm2 += area(laid.samples, place.triangle);
        plan.uncovered.push_back({at.surface, {at.at.u, at.at.v}, at.at.contact.point});
    }
    const auto is_clear = [&](const Vec3& from, const Vec3& to) {
        MoveTestState state;
        return part.is_clear(from, to, state);
    };
    LinkOptions linking = options.link;
    linking.barred = BarredLink::Arched;
    LinkedPath linked =
        link_pieces(in_cutting_order(pieces, cutter, linking), cutter, linking, is_clear);
    plan.path = std::move(linked.path);
    plan.lifted_links = linked.lifted_links;
    plan.arched_links = linked.arched_links;
    if (plan.path.points.empty())
        throw GeometryError{
            "the ball fits nowhere on the part without entering it by more "
            "than the inner tolerance"};
    return plan;
}

}  // namespace endmill
