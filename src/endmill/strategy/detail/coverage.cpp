// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/coverage.h"

#include <algorithm>
#include <array>

#include "endmill/strategy/detail/reach.h"

namespace endmill {

Coverage::Coverage(const PartSamples& samples, const BallCutter& cutter, double height)
    : samples_{&samples},
      cutter_{cutter},
      height_{height},
      gaps_(samples.size(), cutter.radius()),
      nearest_move_(samples.size(), -1),
      walk_{samples},
      first_watched_(samples.size(), -1)
{
    raised_.reserve(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        raised_.push_back(samples.point(i) + height * samples.normal(i));
        if (!samples.is_wanted(i))
            gaps_[i] = 0;
    }
}

void Coverage::watch(std::span<const SampleEdge> places)
{
    for (const std::int32_t i : watching_)
        first_watched_[i] = -1;
    watching_.clear();
    watched_.clear();
    for (const SampleEdge& place : places) {
        const std::int32_t i = place.share < 0.5 ? place.from : place.to;
        if (first_watched_[i] < 0)
            watching_.push_back(i);
        watched_.push_back(
            {(1 - place.share) * raised(place.from) + place.share * raised(place.to),
             first_watched_[i]});
        first_watched_[i] = static_cast<std::int32_t>(watched_.size() - 1);
    }
    watched_gaps_.assign(places.size(), cutter_.radius());
}

void Coverage::add_move(const PassContact& from, const PassContact& to)
{
    const double radius = cutter_.radius();
    const UprightSweep sweep{from.at.contact.point + radius * from.at.contact.normal,
                             to.at.contact.point + radius * to.at.contact.normal};
    const auto number = static_cast<std::int32_t>(moves_.size());
    moves_.push_back(sweep);
    walk_.from(std::array{from.near, to.near}, [&](std::int32_t i) {
        const double gap = beyond_reach(sweep.squared_distance(raised(i)), radius);
        if (gap < gaps_[i]) {
            changes_.push_back({i, gaps_[i], nearest_move_[i]});
            gaps_[i] = gap;
            nearest_move_[i] = number;
        }
        for (std::int32_t k = first_watched_[i]; k >= 0; k = watched_[k].next)
            watched_gaps_[k] = std::min(
                watched_gaps_[k],
                beyond_reach(sweep.squared_distance(watched_[k].raised), radius));
        return gap < 0;
    });
}

void Coverage::add(std::span<const PassContact> pass, bool is_closed)
{
    if (pass.size() == 1)
        add_move(pass.front(), pass.front());
    for (std::size_t k = 0; k + 1 < pass.size(); ++k)
        add_move(pass[k], pass[k + 1]);
    if (is_closed && pass.size() > 2)
        add_move(pass.back(), pass.front());
}

void Coverage::withdraw()
{
    for (std::size_t k = changes_.size(); k-- > 0;) {
        const auto& [sample, gap, move] = changes_[k];
        gaps_[sample] = gap;
        nearest_move_[sample] = move;
    }
    changes_.clear();
    moves_.erase(moves_.begin() + static_cast<std::ptrdiff_t>(accepted_moves_),
                 moves_.end());
    std::fill(watched_gaps_.begin(), watched_gaps_.end(), cutter_.radius());
}

std::vector<std::int32_t> Coverage::newly_covered(double slack) const
{
    std::vector<std::int32_t> covered;
    for (const auto& [i, before, move] : changes_)
        if (before > slack && gaps_[i] <= slack)
            covered.push_back(i);
    return covered;
}

double Coverage::gap_at(const SampleEdge& place) const
{
    const double radius = cutter_.radius();
    const Vec3 there =
        (1 - place.share) * raised(place.from) + place.share * raised(place.to);
    double gap = radius;
    for (const std::int32_t i : {place.from, place.to})
        if (const std::int32_t move = nearest_move_[i]; move >= 0)
            gap =
                std::min(gap, beyond_reach(moves_[move].squared_distance(there), radius));
    return gap;
}

namespace {

// A corner of a part of a triangle.
struct Corner {
    PassContact at;
    Vec3 raised;
};

// Halvings of the sides of a triangle in search of places that are not covered.
constexpr int missed_depth = 4;

}  // namespace

std::vector<MissedPlace> Coverage::missed(std::span<const std::int32_t> triangles,
                                          double slack) const
{
    const double radius = cutter_.radius();
    std::vector<MissedPlace> found;
    std::vector<std::int32_t> moves;
    const auto gap_to = [&](std::int32_t move, const Vec3& raised) {
        return beyond_reach(moves_[move].squared_distance(raised), radius);
    };
    const auto is_covered = [&](const std::array<Corner, 3>& corners) {
        return std::any_of(moves.begin(), moves.end(), [&](std::int32_t move) {
            return std::all_of(corners.begin(), corners.end(), [&](const Corner& corner) {
                return gap_to(move, corner.raised) <= slack;
            });
        });
    };
    const auto middle = [&](const Corner& a, const Corner& b) {
        const PassContact at = samples_->between(a.at, b.at, 0.5);
        const CutterContact& contact = at.at.contact;
        return Corner{at, samples_->is_straight()
                              ? Vec3{(a.raised + b.raised) / 2}
                              : Vec3{contact.point + height_ * contact.normal}};
    };
    const auto search = [&](const auto& self, const std::array<Corner, 3>& corners,
                            int depth) -> void {
        if (depth == 0 || is_covered(corners))
            return;
        const auto& [a, b, c] = corners;
        const std::array<Corner, 3> middles{middle(a, b), middle(b, c), middle(c, a)};
        for (const Corner& corner : middles) {
            double gap = radius;
            for (const std::int32_t move : moves)
                gap = std::min(gap, gap_to(move, corner.raised));
            if (gap > slack)
                found.push_back({corner.at, gap});
        }
        const auto& [ab, bc, ca] = middles;
        self(self, {a, ab, ca}, depth - 1);
        self(self, {ab, b, bc}, depth - 1);
        self(self, {ca, bc, c}, depth - 1);
        self(self, {ab, bc, ca}, depth - 1);
    };
    for (const std::int32_t number : triangles) {
        const Triangle& triangle = samples_->triangles()[number];
        std::array<Corner, 3> corners;
        moves.clear();
        bool is_whole = true;
        for (int k = 0; k < 3; ++k) {
            const std::int32_t i = triangle[k];
            is_whole = is_whole && gaps_[i] <= slack && samples_->is_wanted(i);
            corners[k] = {samples_->contact({i, i, 0}), raised_[i]};
            moves.push_back(nearest_move_[i]);
        }
        if (!is_whole || is_covered(corners))
            continue;
        for (const std::int32_t i : triangle)
            for (const std::int32_t neighbour : samples_->neighbours(i))
                if (nearest_move_[neighbour] >= 0)
                    moves.push_back(nearest_move_[neighbour]);
        std::sort(moves.begin(), moves.end());
        moves.erase(std::unique(moves.begin(), moves.end()), moves.end());
        search(search, corners, missed_depth);
    }
    return found;
}

}  // namespace endmill
