// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/pass_moves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "endmill/planning/segmentation.h"
#include "endmill/strategy/detail/reach.h"

namespace endmill {
namespace {

using Demands = std::array<Vec3, 3>;

// The points that a move past this contact must reach: they lie on the ball, in the middle
// of the strip that it covers and on both of its borders.
Demands demands_at(std::span<const PassContact> contacts, std::size_t k, double radius,
                   double height)
{
    const CutterContact& contact = contacts[k].at.contact;
    const Vec3& before = contacts[k > 0 ? k - 1 : k].at.contact.point;
    const Vec3& after = contacts[std::min(k + 1, contacts.size() - 1)].at.contact.point;
    const Vec3 centre = contact.point + radius * contact.normal;
    const Vec3 across = contact.normal.cross(after - before);
    const double length = across.norm();
    const double cosine = (radius - height) / radius;
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const Vec3 side = length > 0 ? Vec3{(radius * sine / length) * across} : Vec3{Vec3::Zero()};
    const Vec3 down = centre - radius * cosine * contact.normal;
    return {contact.point + height * contact.normal, down + side, down - side};
}

// Halvings of the way between two contacts of a pass in search of clear moves.
constexpr int most_halvings = 6;

// The contacts of a pass, with more of them where the move between two is not clear.
class ClearContacts {
public:
    ClearContacts(const PartSamples& samples, const ClearMoves& clear)
        : samples_{&samples},
          clear_{&clear}
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
        if (can_halve && !clear_->is_clear({ball_centre(from.at, clear_->cutter()),
                                            ball_centre(to.at, clear_->cutter())},
                                           finer_)) {
            lead_to(samples_->contact({(from.at.u + to.at.u) / 2, (from.at.v + to.at.v) / 2},
                                      from.near),
                    halvings - 1);
            lead_to(to, halvings - 1);
        } else {
            contacts_.push_back(to);
        }
    }

    const PartSamples* samples_;
    const ClearMoves* clear_;
    FinerPieces finer_;
    std::vector<PassContact> contacts_;
};

}  // namespace

std::vector<LaidPass> divided_into_moves(const LaidPass& pass, const PartSamples& samples,
                                         const ClearMoves& clear, const MoveLimits& limits)
{
    const double radius = clear.cutter().radius();
    const std::vector<PassContact> contacts = ClearContacts{samples, clear}.of(pass);
    std::vector<Demands> demands;
    demands.reserve(contacts.size());
    for (std::size_t k = 0; k < contacts.size(); ++k)
        demands.push_back(demands_at(contacts, k, radius, limits.covered_height));
    FinerPieces finer;
    const auto centre = [&](std::size_t k) {
        return ball_centre(contacts[k].at, clear.cutter());
    };
    const auto is_clear = [&](std::size_t from, std::size_t to) {
        return clear.is_clear({centre(from), centre(to)}, finer);
    };
    const auto reaches_demands = [&](std::size_t from, std::size_t to) {
        const UprightSweep sweep{centre(from), centre(to)};
        for (std::size_t k = from; k <= to; ++k)
            for (const Vec3& point : demands[k])
                if (beyond_reach(sweep.squared_distance(point), radius) > limits.cover_slack)
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
                    return to == from + 1 || (reaches_demands(first + from, first + to) &&
                                              is_clear(first + from, first + to));
                });
            piece.contacts.clear();
            for (const std::size_t vertex : divided->vertices)
                piece.contacts.push_back(contacts[first + vertex]);
        }
        pieces.push_back(std::move(piece));
        first = last + 1;
    }
    return pieces;
}

}  // namespace endmill
