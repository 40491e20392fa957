// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/piece_joining.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/strategy/detail/contact_link.h"

namespace endmill {
namespace {

// A piece becomes a detour of another one only if it is shorter than this, in widths of a
// strip.
constexpr double longest_detour = 4;
// By how much a detour may be longer than its piece, in widths of a strip. Each piece costs
// what the ball covers where it begins, and a link.
constexpr double piece_price = 2;
// Longest contact link, in widths of a strip. Parallel passes lie farther apart: a link between
// them would only make the cuts longer. Below pi / 4 a link makes them longer by less than one
// piece less raises the bound of their length, on a plane.
constexpr double paying_link = 0.6;
// Longest contact link where a straight link is not clear and would be lifted, in widths of a
// strip.
constexpr double longest_link = 2;
// Numbers of moves of the stretches that are straightened, in this order.
constexpr std::array<std::size_t, 3> straightened_moves{8, 4, 2};
// Two moves that are longer than the straight way by less than this are not straightened, in
// widths of a strip.
constexpr double least_bend_length = 0.004;
// Halvings of a move in search of the place to which it can be cut back.
constexpr int trimming_halvings = 5;
// Detours of a piece that are tried.
constexpr std::size_t tried_detours = 12;
// A straightened stretch has to become shorter by this part of what it would on a plane.
constexpr double least_gain_share = 0.5;
// Halvings of the way to the straight line in search of the place that can be reached.
constexpr int straightening_halvings = 3;

const Vec3& point(const PassContact& contact)
{
    return contact.at.contact.point;
}

double distance(const PassContact& a, const PassContact& b)
{
    return (point(a) - point(b)).norm();
}

// Numbers of the pieces that are not empty, the shortest first.
std::vector<std::size_t> by_length(std::span<const LaidPass> pieces)
{
    std::vector<std::size_t> numbers;
    std::vector<double> lengths;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        lengths.push_back(pieces[k].contacts.empty() ? 0 : pass_length(pieces[k]));
        if (!pieces[k].contacts.empty())
            numbers.push_back(k);
    }
    std::ranges::stable_sort(numbers, {}, [&](std::size_t k) { return lengths[k]; });
    return numbers;
}

using Box = Eigen::AlignedBox3d;

// The box around the contacts of a piece.
Box box_of(const LaidPass& piece)
{
    Box box;
    for (const PassContact& contact : piece.contacts)
        box.extend(point(contact));
    return box;
}

// A detour of a piece over contacts of another one.
struct Detour {
    double added;       // length, mm
    std::size_t piece;  // that makes the detour
    std::size_t move;   // number of its move
    double leaves;      // shares of the move at which the detour leaves it and returns
    double returns;
    std::vector<PassContact> over;  // contacts, in order
};

class PieceJoining {
public:
    PieceJoining(CoveringPieces& covering, const PartSamples& samples,
                 const CoveredPart& part, const MoveLimits& limits,
                 const StrategyOptions& options)
        : covering_{covering},
          samples_{samples},
          part_{part},
          limits_{limits},
          options_{options},
          width_{strip_width(part.cutter(), limits.covered_height)}
    {
    }

    void run()
    {
        shorten();
        join_neighbours();
        shorten();
    }

private:
    void shorten()
    {
        trim();
        // a detour may lead over its piece in the other direction
        if (options_.link.order != PassOrder::OneWay)
            make_detours();
        for (const std::size_t moves : straightened_moves)
            straighten(moves);
    }

    const LaidPass& piece(std::size_t number) const { return covering_.pieces()[number]; }

    bool is_clear(const PassContact& from, const PassContact& to)
    {
        return part_.is_clear(ball_centre(from.at, part_.cutter()),
                              ball_centre(to.at, part_.cutter()), state_);
    }

    // Leaves out pieces that are not needed, and cuts back the ends of others.
    void trim()
    {
        for (const std::size_t number : by_length(covering_.pieces()))
            if (!covering_.leave_out(number) && !piece(number).is_closed) {
                trim_end(number);
                covering_.reverse(number);
                trim_end(number);
                covering_.reverse(number);
            }
    }

    // Cuts back the end of a piece.
    void trim_end(std::size_t number)
    {
        const std::vector<PassContact>& contacts = piece(number).contacts;
        const auto shorten = [&](std::vector<PassContact> by) {
            return covering_.make(
                {number, contacts.size() - 1, contacts.size(), std::move(by)});
        };
        while (contacts.size() > 1 && shorten({})) {
        }
        if (contacts.size() < 2)
            return;
        const PassContact last = contacts.back();
        const PassContact before = contacts[contacts.size() - 2];
        if (!samples_.is_joined(before, last))
            return;
        double too_short = 0;
        double long_enough = 1;
        for (int halving = 0; halving < trimming_halvings; ++halving) {
            const double share = (too_short + long_enough) / 2;
            const PassContact end = samples_.between(before, last, share);
            (is_clear(before, end) && shorten({end}) ? long_enough : too_short) = share;
        }
    }

    // Moves stretches of pieces towards the straight way between their ends.
    void straighten(std::size_t moves)
    {
        // a line of constant curvature is longer than its chord by the cube of its length
        const double least =
            least_bend_length * width_ * std::pow(static_cast<double>(moves) / 2, 3);
        for (std::size_t number = 0; number < covering_.pieces().size(); ++number)
            for (std::size_t k = 0; k + moves < piece(number).contacts.size();
                 k += std::max<std::size_t>(1, moves / 2))
                if (bend_length(number, k, k + moves) > least)
                    straighten(number, k, k + moves);
    }

    // By how much a stretch of a piece is longer than the straight way, mm.
    double bend_length(std::size_t number, std::size_t first, std::size_t last) const
    {
        const std::vector<PassContact>& contacts = piece(number).contacts;
        double length = 0;
        for (std::size_t k = first; k < last; ++k)
            length += distance(contacts[k], contacts[k + 1]);
        return length - distance(contacts[first], contacts[last]);
    }

    // Moves the contacts between two contacts of a piece as far towards the straight way
    // between these two as the coverage allows.
    void straighten(std::size_t number, std::size_t first, std::size_t last)
    {
        const std::vector<PassContact>& contacts = piece(number).contacts;
        const std::vector<PassContact> old(
            contacts.begin() + static_cast<std::ptrdiff_t>(first),
            contacts.begin() + static_cast<std::ptrdiff_t>(last) + 1);
        if (!samples_.is_joined(old.front(), old.back()))
            return;
        double too_far = 1;
        double far_enough = 0;
        for (int halving = 0; halving <= straightening_halvings && far_enough < 1;
             ++halving) {
            const double share = halving == 0 ? 1 : (too_far + far_enough) / 2;
            std::optional<std::vector<PassContact>> by;
            // On surfaces tests of moves take longer than those of the coverage, which most
            // stretches fail.
            if (const auto targets = moved_towards_straight(old, share);
                targets && (part_.surfaces().empty() ||
                            covering_.would_cover(
                                {number, first + 1, last, along_surface(*targets)})))
                by = linked(*targets);
            const std::size_t count = by ? by->size() : 0;
            if (by && shortens(old, *by, share) &&
                covering_.make({number, first + 1, last, std::move(*by)})) {
                far_enough = share;
                last = first + 1 + count;
            } else {
                too_far = share;
            }
        }
    }

    // Whether a stretch becomes shorter by enough. On a plane, a share of the way to the straight
    // line takes more than this share of what the stretch is longer. Beside creases of a mesh the
    // moves between the new contacts may be as long as the old ones.
    static bool shortens(std::span<const PassContact> old,
                         std::span<const PassContact> by, double share)
    {
        std::vector<PassContact> now{old.front()};
        now.insert(now.end(), by.begin(), by.end());
        now.push_back(old.back());
        const double before = pass_length({{old.begin(), old.end()}, false});
        const double bend = before - distance(old.front(), old.back());
        return before - pass_length({std::move(now), false}) >=
               least_gain_share * share * bend;
    }

    // The contacts of a stretch of a piece, moved by a share of the way to the straight one
    // between its ends; nothing if a seam lies between.
    std::optional<std::vector<PassContact>> moved_towards_straight(
        std::span<const PassContact> old, double share) const
    {
        double length = 0;
        for (std::size_t k = 0; k + 1 < old.size(); ++k)
            length += distance(old[k], old[k + 1]);
        std::vector<PassContact> moved{old.front()};
        moved.reserve(old.size());
        double so_far = 0;
        for (std::size_t k = 1; k + 1 < old.size(); ++k) {
            so_far += distance(old[k - 1], old[k]);
            const PassContact foot =
                samples_.between(old.front(), old.back(), so_far / length);
            if (share < 1 && !samples_.is_joined(old[k], foot))
                return std::nullopt;
            moved.push_back(share == 1 ? foot : samples_.between(old[k], foot, share));
        }
        moved.push_back(old.back());
        return moved;
    }

    // Contacts in short steps along the part through those of a stretch, without its ends.
    std::vector<PassContact> along_surface(std::span<const PassContact> stretch) const
    {
        std::vector<PassContact> dense;
        for (std::size_t k = 0; k + 1 < stretch.size(); ++k) {
            const std::vector<PassContact> steps =
                steps_along(stretch[k], stretch[k + 1], samples_);
            dense.insert(dense.end(), steps.begin() + 1, steps.end());
        }
        dense.pop_back();
        return dense;
    }

    // Clear moves through the contacts of a stretch, without its ends; nothing if a move is
    // not clear.
    std::optional<std::vector<PassContact>> linked(
        std::span<const PassContact> stretch) const
    {
        std::vector<PassContact> by;
        for (std::size_t k = 0; k + 1 < stretch.size(); ++k) {
            const auto way =
                contact_link(stretch[k], stretch[k + 1], samples_, part_, limits_);
            if (!way)
                return std::nullopt;
            by.insert(by.end(), way->begin() + 1, way->end());
        }
        by.pop_back();
        return by;
    }

    // Short pieces become detours of the pieces beside them.
    void make_detours()
    {
        boxes_.clear();
        boxes_.reserve(covering_.pieces().size());
        for (const LaidPass& one : covering_.pieces())
            boxes_.push_back(box_of(one));
        for (const std::size_t number : by_length(covering_.pieces())) {
            if (piece(number).contacts.empty() || piece(number).is_closed)
                continue;
            const double length = pass_length(piece(number));
            if (length > longest_detour * width_)
                break;
            std::vector<Detour> detours = detours_over(number);
            std::ranges::stable_sort(detours, {}, &Detour::added);
            std::size_t tries = 0;
            for (const Detour& detour : detours) {
                if (detour.added > length + piece_price * width_ ||
                    tries++ == tried_detours)
                    break;
                if (make_detour(number, detour)) {
                    boxes_[detour.piece] = box_of(piece(detour.piece));
                    boxes_[number].setEmpty();
                    break;
                }
            }
        }
    }

    std::vector<Detour> detours_over(std::size_t number) const
    {
        const std::vector<PassContact>& own = piece(number).contacts;
        std::vector<std::vector<PassContact>> ways{{own[own.size() / 2]}};
        if (own.size() > 1) {
            ways.push_back(own);
            ways.push_back({own.rbegin(), own.rend()});
            ways.push_back({own.front()});
            ways.push_back({own.back()});
        }
        if (own.size() == 2 && samples_.is_joined(own[0], own[1]))
            ways.push_back({samples_.between(own[0], own[1], 0.5)});
        const double most = longest_way_to_detour();
        std::vector<Detour> detours;
        for (std::size_t other = 0; other < covering_.pieces().size(); ++other)
            if (other != number &&
                boxes_[other].squaredExteriorDistance(boxes_[number]) <= most * most)
                for (const auto& way : ways)
                    add_detours(other, way, detours);
        return detours;
    }

    // A detour whose ends are this far from its piece is longer than allowed, mm.
    double longest_way_to_detour() const
    {
        return (longest_detour + piece_price) * width_;
    }

    void add_detours(std::size_t other, const std::vector<PassContact>& way,
                     std::vector<Detour>& detours) const
    {
        const LaidPass& with = piece(other);
        const std::size_t count = with.contacts.size();
        const double own = pass_length({way, false});
        const double most = longest_way_to_detour();
        for (std::size_t k = 0; k + (with.is_closed ? 0 : 1) < count; ++k) {
            const Vec3& a = point(with.contacts[k]);
            const Vec3& b = point(with.contacts[(k + 1) % count]);
            const double length = (b - a).norm();
            const double least = (point(way.front()) - a).norm();
            if (least - length > most)
                continue;
            const auto share_of = [&](const Vec3& place) {
                return length > 0 ? std::clamp((place - a).dot(b - a) / (length * length),
                                               0.0, 1.0)
                                  : 0.0;
            };
            const double first = share_of(point(way.front()));
            const double last = share_of(point(way.back()));
            const auto add = [&](double leaves, double returns) {
                const Vec3 from = a + leaves * (b - a);
                const Vec3 to = a + returns * (b - a);
                const double added = (point(way.front()) - from).norm() + own +
                                     (to - point(way.back())).norm() -
                                     (returns - leaves) * length;
                detours.push_back({added, other, k, leaves, returns, way});
            };
            add(0, 1);
            const double spread = length > 0 ? width_ / 2 / length : 1;
            if (first <= last)
                add(std::max(0.0, first - spread), std::min(1.0, last + spread));
            add(first, first);
        }
    }

    bool make_detour(std::size_t number, const Detour& detour)
    {
        const LaidPass& with = piece(detour.piece);
        const std::size_t count = with.contacts.size();
        const PassContact& a = with.contacts[detour.move];
        const PassContact& b = with.contacts[(detour.move + 1) % count];
        const auto at = [&](double share) {
            return share == 0 ? a : share == 1 ? b : samples_.between(a, b, share);
        };
        const PassContact leaves = at(detour.leaves);
        const PassContact returns = at(detour.returns);
        if (!is_clear(a, leaves) || !is_clear(returns, b))
            return false;
        const auto out =
            contact_link(leaves, detour.over.front(), samples_, part_, limits_);
        if (!out)
            return false;
        const auto back =
            contact_link(detour.over.back(), returns, samples_, part_, limits_);
        if (!back)
            return false;
        std::vector<PassContact> by;
        const auto add = [&](const PassContact& contact) {
            if (!is_same_place(by.empty() ? a : by.back(), contact))
                by.push_back(contact);
        };
        for (const auto* some : {&*out, &detour.over, &*back})
            for (const PassContact& contact : *some)
                add(contact);
        if (!by.empty() && is_same_place(by.back(), b))
            by.pop_back();
        return covering_.make(
            {detour.piece, detour.move + 1, detour.move + 1, std::move(by), number});
    }

    // Joins pieces that follow each other in a good order, if their ends are near.
    void join_neighbours()
    {
        std::vector<std::size_t> numbers;
        std::vector<LaidPass> own;
        for (std::size_t k = 0; k < covering_.pieces().size(); ++k)
            if (!piece(k).contacts.empty()) {
                numbers.push_back(k);
                own.push_back(piece(k));
            }
        std::optional<std::size_t> last;
        std::size_t last_start = 0;  // of a closed piece
        for (const OrderedPiece& place :
             cutting_order(own, part_.cutter(), options_.link)) {
            const std::size_t next = numbers[place.piece];
            if (place.is_reversed)
                covering_.reverse(next);
            if (!last || !join(*last, last_start, next, place.start)) {
                last = next;
                last_start = place.start;
            }
        }
    }

    // Joins the piece `next` to the end of the piece `last` by a contact link, if it pays or
    // saves a lift. Closed pieces begin and end at their starts.
    bool join(std::size_t last, std::size_t last_start, std::size_t next,
              std::size_t next_start)
    {
        const bool is_closed = piece(last).is_closed;
        const PassContact& from =
            is_closed ? piece(last).contacts[last_start] : piece(last).contacts.back();
        const PassContact& to = piece(next).contacts[next_start];
        const double length = distance(from, to);
        const bool saves_lifts = options_.distance == TravelKind::Contact;
        if (length > longest_link * width_ ||
            (length > paying_link * width_ && (!saves_lifts || is_clear(from, to))))
            return false;
        const bool is_touching = is_same_place(from, to);
        if (is_touching &&
            std::max(piece(last).contacts.size(), piece(next).contacts.size()) < 2)
            return false;
        std::optional<std::vector<PassContact>> way;
        if (!is_touching && !(way = contact_link(from, to, samples_, part_, limits_)))
            return false;
        if (is_closed)
            covering_.open(last, last_start);
        if (piece(next).is_closed)
            covering_.open(next, next_start);
        covering_.append(
            last,
            way ? std::span{*way}.subspan(1, way->size() - 2) : std::span<PassContact>{},
            next);
        return true;
    }

    CoveringPieces& covering_;
    const PartSamples& samples_;
    const CoveredPart& part_;
    MoveLimits limits_;
    const StrategyOptions& options_;
    double width_;            // of a strip, mm
    std::vector<Box> boxes_;  // around the contacts of each piece
    MoveTestState state_;
};

}  // namespace

void join_pieces(CoveringPieces& covering, const PartSamples& samples,
                 const CoveredPart& part, const MoveLimits& limits,
                 const StrategyOptions& options)
{
    PieceJoining{covering, samples, part, limits, options}.run();
}

std::vector<OrderedPiece> cutting_order(std::span<const LaidPass> pieces,
                                        const BallCutter& cutter,
                                        const LinkOptions& options)
{
    const auto tip = [&](const PassContact& contact) {
        return locate(cutter, contact.at.contact, options.axis).tip;
    };
    std::vector<PieceEnds> ends;
    ends.reserve(pieces.size());
    for (const LaidPass& piece : pieces) {
        if (piece.is_closed) {
            ClosedPiece closed;
            closed.starts.reserve(piece.contacts.size());
            for (const PassContact& contact : piece.contacts)
                closed.starts.push_back(tip(contact));
            ends.emplace_back(std::move(closed));
        } else {
            ends.emplace_back(OpenPiece{tip(piece.contacts.front()),
                                        tip(piece.contacts.back()),
                                        options.order != PassOrder::OneWay});
        }
    }
    return order_pieces(ends).pieces;
}

std::vector<PassContact> contacts_in_order(const LaidPass& piece,
                                           const OrderedPiece& order)
{
    std::vector<PassContact> contacts = piece.contacts;
    if (piece.is_closed) {
        std::rotate(contacts.begin(),
                    contacts.begin() + static_cast<std::ptrdiff_t>(order.start),
                    contacts.end());
        contacts.push_back(contacts.front());
    }
    if (order.is_reversed)
        std::ranges::reverse(contacts);
    return contacts;
}

}  // namespace endmill
