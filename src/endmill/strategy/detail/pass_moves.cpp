// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/pass_moves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "endmill/core/answer.h"
#include "endmill/planning/detail/segmentation.h"
#include "endmill/strategy/detail/reach.h"

namespace endmill {
namespace {

// Directions around a contact in which the border of what its ball covers is demanded. Two
// of them lie across the feed.
constexpr int demand_directions = 6;
using Demands = std::array<Vec3, demand_directions + 1>;

// The sines and cosines of these directions, from the feed.
struct DemandDirection {
    double sine;
    double cosine;
};

std::array<DemandDirection, demand_directions> directions_of_demands()
{
    std::array<DemandDirection, demand_directions> directions;
    for (int k = 0; k < demand_directions; ++k) {
        const double angle = 2 * std::numbers::pi * (k + 0.5) / demand_directions;
        directions[k] = {std::sin(angle), std::cos(angle)};
    }
    return directions;
}

// The points that a move past a contact must reach: the one above it, and some on the
// circle of the ball at the height to which it covers.
Demands demands_at(std::span<const PassContact> contacts, std::size_t k, double radius,
                   double height)
{
    const CutterContact& contact = contacts[k].at.contact;
    const Vec3& before = contacts[k > 0 ? k - 1 : k].at.contact.point;
    const Vec3& after = contacts[std::min(k + 1, contacts.size() - 1)].at.contact.point;
    const Vec3 feed = after - before;
    const Vec3 across =
        contact.normal.cross(feed.norm() > 0 ? feed : contact.normal.unitOrthogonal())
            .normalized();
    const Vec3 along = across.cross(contact.normal);
    const double circle = std::sqrt(height * (2 * radius - height));
    const Vec3 middle = contact.point + height * contact.normal;
    static const std::array directions = directions_of_demands();
    Demands demands;
    demands[0] = middle;
    for (int direction = 0; direction < demand_directions; ++direction) {
        const auto& [sine, cosine] = directions[direction];
        demands[direction + 1] = middle + circle * (sine * across + cosine * along);
    }
    return demands;
}

// Halvings of the way between two contacts of a pass in search of clear moves.
constexpr int most_halvings = 6;

// A move that enters a contact by more than the tolerance and this share of it is not clear.
// The share is far above rounding errors and as great as that within which tests of moves
// are undecided.
constexpr double sure_entry_share = 1e-3;

// Answers are remembered for moves over at most so many contacts. Longer ones are rare.
constexpr std::size_t most_remembered = 16;

// Contacts, and whether the step to each from the one before it is clear.
struct SteppedContacts {
    std::vector<PassContact> contacts;
    std::vector<char> is_clear_step;
};

// The contacts of a pass, with more of them where the step between two is not clear.
class ClearContacts {
public:
    ClearContacts(const PartSamples& samples, const CoveredPart& part,
                  MoveTestState& state)
        : samples_{&samples},
          part_{&part},
          state_{&state}
    {
    }

    SteppedContacts of(std::span<const PassContact> contacts)
    {
        stepped_ = {{contacts.front()}, {0}};
        for (const PassContact& contact : contacts.subspan(1))
            lead_to(contact, most_halvings);
        return std::move(stepped_);
    }

private:
    void lead_to(const PassContact& to, int halvings)
    {
        const PassContact from = stepped_.contacts.back();
        const bool is_clear =
            part_->is_clear(ball_centre(from.at, part_->cutter()),
                            ball_centre(to.at, part_->cutter()), *state_);
        if (!is_clear && halvings > 0 && samples_->is_joined(from, to)) {
            lead_to(samples_->between(from, to, 0.5), halvings - 1);
            lead_to(to, halvings - 1);
        } else {
            stepped_.contacts.push_back(to);
            stepped_.is_clear_step.push_back(is_clear ? 1 : 0);
        }
    }

    const PartSamples* samples_;
    const CoveredPart* part_;
    MoveTestState* state_;
    SteppedContacts stepped_;
};

// The moves between contacts of a stretch. The division asks for some moves again and again,
// and most of them are too long: answers are remembered, and simple tests come first.
class StretchMoves {
public:
    StretchMoves(std::span<const PassContact> contacts, const CoveredPart& part,
                 const MoveLimits& limits, MoveTestState& state)
        : contacts_{contacts},
          part_{part},
          limits_{limits},
          state_{state},
          answers_(contacts.size() * most_remembered, Answer::Undecided)
    {
        demands_.reserve(contacts.size());
        centres_.reserve(contacts.size());
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            demands_.push_back(
                demands_at(contacts, k, part.cutter().radius(), limits.covered_height));
            centres_.push_back(ball_centre(contacts[k].at, part.cutter()));
        }
    }

    bool is_clear(std::size_t from, std::size_t to)
    {
        return part_.is_clear(centres_[from], centres_[to], state_);
    }

    // Numbers of the contacts from `first` to `last` at which moves begin and end. Steps
    // from a contact to the next one are not tested.
    std::vector<std::size_t> divided(std::size_t first, std::size_t last)
    {
        const auto division = fewest_moves(
            last - first + 1, PassShape::Open, [&](std::size_t from, std::size_t to) {
                return to == from + 1 || is_sound(first + from, first + to);
            });
        std::vector<std::size_t> vertices = division->vertices;
        for (std::size_t& vertex : vertices)
            vertex += first;
        return vertices;
    }

    // Whether the moves of a division that are single steps are clear.
    bool are_steps_clear(std::span<const std::size_t> vertices)
    {
        for (std::size_t k = 0; k + 1 < vertices.size(); ++k)
            if (vertices[k + 1] == vertices[k] + 1 &&
                !is_clear(vertices[k], vertices[k + 1]))
                return false;
        return true;
    }

    std::vector<PassContact> at(std::span<const std::size_t> vertices) const
    {
        std::vector<PassContact> chosen;
        chosen.reserve(vertices.size());
        for (const std::size_t vertex : vertices)
            chosen.push_back(contacts_[vertex]);
        return chosen;
    }

private:
    // Whether a move over contacts reaches their demands and is clear.
    bool is_sound(std::size_t from, std::size_t to)
    {
        const auto test = [&] { return may_be_sound(from, to) && is_clear(from, to); };
        if (to - from > most_remembered)
            return test();
        Answer& answer = answers_[from * most_remembered + (to - from - 1)];
        if (answer == Answer::Undecided)
            answer = test() ? Answer::Yes : Answer::No;
        return answer == Answer::Yes;
    }

    // Whether a move reaches the demands and does not surely enter the contacts between its
    // ends.
    bool may_be_sound(std::size_t from, std::size_t to)
    {
        const UprightSweep sweep{centres_[from], centres_[to]};
        // the contact at which the last move failed is likely to fail again
        if (from < failed_ && failed_ < to && !is_good_at(failed_, sweep))
            return false;
        if (enters_contacts(from, to, sweep))
            return false;
        for (std::size_t k = from; k <= to; ++k)
            if (!reaches_demands(k, sweep)) {
                failed_ = k;
                return false;
            }
        return true;
    }

    bool is_good_at(std::size_t k, const UprightSweep& sweep) const
    {
        return !enters(k, sweep) && reaches_demands(k, sweep);
    }

    // Whether a move surely enters the contact k, a point of the part, by too much.
    bool enters(std::size_t k, const UprightSweep& sweep) const
    {
        const double least =
            part_.cutter().radius() - (1 + sure_entry_share) * part_.tolerance();
        return part_.has_contacts_on_part() && least > 0 &&
               sweep.squared_distance(contacts_[k].at.contact.point) < least * least;
    }

    // The same for the contacts between the ends of a move.
    bool enters_contacts(std::size_t from, std::size_t to, const UprightSweep& sweep)
    {
        for (std::size_t k = from + 1; k < to; ++k)
            if (enters(k, sweep)) {
                failed_ = k;
                return true;
            }
        return false;
    }

    bool reaches_demands(std::size_t k, const UprightSweep& sweep) const
    {
        return std::all_of(
            demands_[k].begin(), demands_[k].end(), [&](const Vec3& point) {
                return beyond_reach(sweep.squared_distance(point),
                                    part_.cutter().radius()) <= limits_.cover_slack;
            });
    }

    std::span<const PassContact> contacts_;
    const CoveredPart& part_;
    const MoveLimits& limits_;
    MoveTestState& state_;
    std::vector<Demands> demands_;
    std::vector<Vec3> centres_;
    std::vector<Answer> answers_;  // by the first contact of a move and its length
    std::size_t failed_ = 0;       // the contact at which a move failed last
};

// Divides a stretch step by step: it is interrupted where no step is clear.
std::vector<StretchPiece> divided_by_steps(std::span<const PassContact> stretch,
                                           const PartSamples& samples,
                                           const CoveredPart& part,
                                           const MoveLimits& limits, MoveTestState& state)
{
    const auto [contacts, is_clear_step] =
        ClearContacts{samples, part, state}.of(stretch);
    StretchMoves moves{contacts, part, limits, state};
    std::vector<StretchPiece> pieces;
    for (std::size_t first = 0; first < contacts.size();) {
        // the longest run of clear steps
        std::size_t last = first;
        while (last + 1 < contacts.size() && is_clear_step[last + 1] != 0)
            ++last;
        StretchPiece piece{{contacts[first]}, first == 0, last + 1 == contacts.size()};
        if (last > first)
            piece.contacts = moves.at(moves.divided(first, last));
        // a run of several contacts consists of clear moves
        if (last > first || moves.is_clear(first, first))
            pieces.push_back(std::move(piece));
        first = last + 1;
    }
    return pieces;
}

// Divides a stretch: contacts of which only the first and the last may be required. Its
// steps are tested one by one only if a move of the division is not clear.
std::vector<StretchPiece> divided_stretch(std::span<const PassContact> stretch,
                                          const PartSamples& samples,
                                          const CoveredPart& part,
                                          const MoveLimits& limits, MoveTestState& state)
{
    if (stretch.size() > 1) {
        StretchMoves moves{stretch, part, limits, state};
        const std::vector<std::size_t> vertices = moves.divided(0, stretch.size() - 1);
        if (moves.are_steps_clear(vertices))
            return {{moves.at(vertices), true, true}};
    }
    return divided_by_steps(stretch, samples, part, limits, state);
}

// Adds the pieces of a stretch to those of the stretch before it.
void append(const std::vector<StretchPiece>& stretch, std::vector<StretchPiece>& pieces)
{
    for (const StretchPiece& piece : stretch) {
        const bool continues =
            piece.has_first && !pieces.empty() && pieces.back().has_last;
        if (!continues) {
            pieces.push_back(piece);
            continue;
        }
        StretchPiece& whole = pieces.back();
        whole.contacts.insert(whole.contacts.end(), piece.contacts.begin() + 1,
                              piece.contacts.end());
        whole.has_last = piece.has_last;
    }
    if (stretch.empty() && !pieces.empty())
        pieces.back().has_last = false;
}

}  // namespace

const std::vector<StretchPiece>& PassDivision::pieces_of(
    std::span<const PassContact> stretch, MoveTestState& state)
{
    StretchKey key{static_cast<double>(stretch.size())};
    auto value = key.begin() + 1;
    for (const PassContact* end : {&stretch.front(), &stretch.back()})
        for (const Vec3* vector : {&end->at.contact.point, &end->at.contact.normal})
            value = std::copy(vector->begin(), vector->end(), value);
    const auto [known, is_new] = known_.try_emplace(key);
    if (is_new)
        known->second = divided_stretch(stretch, *samples_, *part_, limits_, state);
    return known->second;
}

std::vector<LaidPass> PassDivision::pieces_of(const LaidPass& pass, MoveTestState& state)
{
    std::vector<PassContact> contacts = pass.contacts;
    if (pass.is_closed && contacts.size() > 2)
        contacts.push_back(contacts.front());
    std::vector<StretchPiece> joined;
    for (std::size_t first = 0; first < contacts.size();) {
        std::size_t last = first + 1;
        while (last + 1 < contacts.size() && !contacts[last].is_required)
            ++last;
        last = std::min(last, contacts.size() - 1);
        append(pieces_of(std::span{contacts}.subspan(first, last - first + 1), state),
               joined);
        first = last + 1 < contacts.size() ? last : contacts.size();
    }
    std::vector<LaidPass> pieces;
    pieces.reserve(joined.size());
    for (StretchPiece& piece : joined) {
        const bool is_whole = joined.size() == 1 && piece.has_first && piece.has_last;
        const bool is_closed = pass.is_closed && is_whole && piece.contacts.size() > 3;
        if (is_closed)
            piece.contacts.pop_back();
        pieces.push_back({std::move(piece.contacts), is_closed});
    }
    return pieces;
}

std::vector<LaidPass> divided_into_moves(const LaidPass& pass, const PartSamples& samples,
                                         const CoveredPart& part,
                                         const MoveLimits& limits)
{
    MoveTestState state;
    return PassDivision{samples, part, limits}.pieces_of(pass, state);
}

}  // namespace endmill
