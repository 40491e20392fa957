// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/pass_moves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "endmill/planning/detail/segmentation.h"
#include "endmill/strategy/detail/reach.h"

namespace endmill {
namespace {

// Directions around a contact in which the border of what its ball covers is demanded. Two
// of them lie across the feed.
constexpr int demand_directions = 6;
using Demands = std::array<Vec3, demand_directions + 1>;

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
    Demands demands;
    demands[0] = middle;
    for (int direction = 0; direction < demand_directions; ++direction) {
        const double angle = 2 * std::numbers::pi * (direction + 0.5) / demand_directions;
        demands[direction + 1] =
            middle + circle * (std::sin(angle) * across + std::cos(angle) * along);
    }
    return demands;
}

// Halvings of the way between two contacts of a pass in search of clear moves.
constexpr int most_halvings = 6;

// The contacts of a pass, with more of them where the move between two is not clear.
class ClearContacts {
public:
    ClearContacts(const PartSamples& samples, const CoveredPart& part)
        : samples_{&samples},
          part_{&part}
    {
    }

    std::vector<PassContact> of(const LaidPass& pass)
    {
        contacts_ = {pass.contacts.front()};
        for (std::size_t k = 1; k < pass.contacts.size(); ++k)
            lead_to(pass.contacts[k], most_halvings);
        if (pass.is_closed && pass.contacts.size() > 2)
            lead_to(pass.contacts.front(), most_halvings);
        return std::move(contacts_);
    }

private:
    void lead_to(const PassContact& to, int halvings)
    {
        const PassContact from = contacts_.back();
        const bool can_halve = halvings > 0 && samples_->is_joined(from, to);
        if (can_halve && !part_->is_clear(ball_centre(from.at, part_->cutter()),
                                          ball_centre(to.at, part_->cutter()), state_)) {
            lead_to(samples_->between(from, to, 0.5), halvings - 1);
            lead_to(to, halvings - 1);
        } else {
            contacts_.push_back(to);
        }
    }

    const PartSamples* samples_;
    const CoveredPart* part_;
    MoveTestState state_;
    std::vector<PassContact> contacts_;
};

}  // namespace

std::vector<LaidPass> divided_into_moves(const LaidPass& pass, const PartSamples& samples,
                                         const CoveredPart& part,
                                         const MoveLimits& limits)
{
    const double radius = part.cutter().radius();
    const std::vector<PassContact> contacts = ClearContacts{samples, part}.of(pass);
    std::vector<Demands> demands;
    demands.reserve(contacts.size());
    for (std::size_t k = 0; k < contacts.size(); ++k)
        demands.push_back(demands_at(contacts, k, radius, limits.covered_height));
    MoveTestState state;
    const auto centre = [&](std::size_t k) {
        return ball_centre(contacts[k].at, part.cutter());
    };
    const auto is_clear = [&](std::size_t from, std::size_t to) {
        return part.is_clear(centre(from), centre(to), state);
    };
    const auto passes_required = [&](std::size_t from, std::size_t to) {
        return std::any_of(
            contacts.begin() + static_cast<std::ptrdiff_t>(from) + 1,
            contacts.begin() + static_cast<std::ptrdiff_t>(to),
            [](const PassContact& contact) { return contact.is_required; });
    };
    const auto reaches_demands = [&](std::size_t from, std::size_t to) {
        const UprightSweep sweep{centre(from), centre(to)};
        for (std::size_t k = from; k <= to; ++k)
            for (const Vec3& point : demands[k])
                if (beyond_reach(sweep.squared_distance(point), radius) >
                    limits.cover_slack)
                    return false;
        return true;
    };
    std::vector<LaidPass> pieces;
    for (std::size_t first = 0; first < contacts.size();) {
        if (!is_clear(first, first)) {
            ++first;
            continue;
        }
        // the longest run whose neighbours are joined by clear moves
        std::size_t last = first;
        while (last + 1 < contacts.size() && is_clear(last, last + 1))
            ++last;
        LaidPass piece{{contacts[first]}, false};
        if (last > first) {
            const auto divided = fewest_moves(
                last - first + 1, PassShape::Open, [&](std::size_t from, std::size_t to) {
                    return to == from + 1 ||
                           (!passes_required(first + from, first + to) &&
                            reaches_demands(first + from, first + to) &&
                            is_clear(first + from, first + to));
                });
            piece.contacts.clear();
            for (const std::size_t vertex : divided->vertices)
                piece.contacts.push_back(contacts[first + vertex]);
        }
        const bool is_whole = first == 0 && last + 1 == contacts.size();
        if (pass.is_closed && is_whole && piece.contacts.size() > 2) {
            piece.contacts.pop_back();
            piece.is_closed = true;
        }
        pieces.push_back(std::move(piece));
        first = last + 1;
    }
    return pieces;
}

}  // namespace endmill
