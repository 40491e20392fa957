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
    centres_.reserve(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        raised_.push_back(samples.point(i) + height * samples.normal(i));
        centres_.push_back(samples.centre(i, cutter.radius()));
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
        watched_.push_back({raised(place), first_watched_[i]});
        first_watched_[i] = static_cast<std::int32_t>(watched_.size() - 1);
    }
    watched_gaps_.assign(places.size(), cutter_.radius());
}

double Coverage::gap_at(const SampleEdge& place) const
{
    const Vec3 point = raised(place);
    double gap = cutter_.radius();
    for (const std::int32_t i : {place.from, place.to})
        if (const std::int32_t move = nearest_move_[i]; move >= 0)
            gap = std::min(gap, beyond_reach(moves_[move].squared_distance(point),
                                             cutter_.radius()));
    return gap;
}

Coverage::MoveEnd Coverage::end_at(const PassContact& contact) const
{
    const CutterContact& at = contact.at.contact;
    return {at.point + cutter_.radius() * at.normal, contact.near};
}

Coverage::MoveEnd Coverage::end_at(const SampleEdge& place) const
{
    return {samples_->near_centre(place, cutter_.radius()),
            place.share < 0.5 ? place.from : place.to};
}

void Coverage::add_move(const MoveEnd& from, const MoveEnd& to)
{
    const double radius = cutter_.radius();
    const UprightSweep sweep{from.centre, to.centre};
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

template <typename Place>
void Coverage::add_moves(std::span<const Place> pass, bool is_closed)
{
    const MoveEnd first = end_at(pass.front());
    if (pass.size() == 1)
        add_move(first, first);
    MoveEnd last = first;
    for (const Place& place : pass.subspan(1)) {
        const MoveEnd next = end_at(place);
        add_move(last, next);
        last = next;
    }
    if (is_closed && pass.size() > 2)
        add_move(last, first);
}

void Coverage::add(std::span<const PassContact> pass, bool is_closed)
{
    add_moves(pass, is_closed);
}

void Coverage::add(std::span<const SampleEdge> pass, bool is_closed)
{
    add_moves(pass, is_closed);
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

std::int32_t sample_beside(const PartSamples& samples, const MissedPlace& place)
{
    const auto heaviest = std::max_element(place.weights.begin(), place.weights.end());
    return samples.triangles()[place.triangle][heaviest - place.weights.begin()];
}

PassContact contact_at(const PartSamples& samples, const MissedPlace& place)
{
    const Triangle& triangle = samples.triangles()[place.triangle];
    const auto corner = [&](int k) {
        return samples.contact({triangle[k], triangle[k], 0});
    };
    const auto& [a, b, c] = place.weights;
    if (a + b == 0)
        return corner(2);
    const PassContact side = b == 0 ? corner(0)
                             : a == 0
                                 ? corner(1)
                                 : samples.between(corner(0), corner(1), b / (a + b));
    return c == 0 ? side : samples.between(side, corner(2), c);
}

namespace {

// Searches a triangle for places that the moves near it miss.
class MissedSearch {
public:
    MissedSearch(const Coverage& coverage, std::span<const UprightSweep> moves,
                 double slack, int halvings)
        : samples_{coverage.samples()},
          moves_{moves},
          halvings_{halvings},
          radius_{coverage.cutter().radius()},
          height_{coverage.height()},
          slack_{slack}
    {
    }

    // Whether one of some moves covers a triangle.
    bool is_covered(const std::array<Vec3, 3>& raised,
                    std::span<const std::int32_t> moves) const
    {
        return std::any_of(moves.begin(), moves.end(), [&](std::int32_t move) {
            return std::all_of(raised.begin(), raised.end(), [&](const Vec3& point) {
                return gap_to(move, point) <= slack_;
            });
        });
    }

    // The moves by which a triangle may be covered.
    std::vector<std::int32_t>& moves_near() { return near_; }

    // Adds what is missed in a triangle.
    void run(std::int32_t number, const std::array<CutterContact, 3>& contacts,
             std::vector<MissedPlace>& found)
    {
        number_ = number;
        found_ = &found;
        std::sort(near_.begin(), near_.end());
        near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
        // They are about a dozen. Without the rest a place may count as missed, never as
        // covered.
        near_.resize(std::min(near_.size(), most_near));
        rows_.clear();
        for (const std::int32_t move : near_)
            rows_.add(moves_[move]);
        search({corner(contacts[0], {1, 0, 0}), corner(contacts[1], {0, 1, 0}),
                corner(contacts[2], {0, 0, 1})},
               halvings_);
    }

private:
    struct Corner {
        CutterContact contact;
        Vec3 raised;
        std::array<double, 3> weights;
        std::uint64_t covering;  // bit k is set if the move k of near_ covers it
    };

    static constexpr std::size_t most_near = 64;

    double gap_to(std::int32_t move, const Vec3& raised) const
    {
        return beyond_reach(moves_[move].squared_distance(raised), radius_);
    }

    // The gaps of a point by the moves near the triangle, until the next call.
    std::span<const double> gaps_to_near(const Vec3& raised)
    {
        const std::span gaps = std::span{gaps_}.first(rows_.size());
        rows_.gaps_at(raised, radius_, gaps);
        return gaps;
    }

    Corner corner(const CutterContact& contact, const std::array<double, 3>& weights)
    {
        Corner result{contact, contact.point + height_ * contact.normal, weights, 0};
        const std::span<const double> gaps = gaps_to_near(result.raised);
        for (std::size_t k = 0; k < gaps.size(); ++k)
            result.covering |= std::uint64_t{gaps[k] <= slack_ ? 1U : 0U} << k;
        return result;
    }

    Corner middle(const Corner& a, const Corner& b)
    {
        std::array<double, 3> weights{};
        for (int k = 0; k < 3; ++k)
            weights[k] = (a.weights[k] + b.weights[k]) / 2;
        return corner(samples_.near_place(a.contact, b.contact, 0.5), weights);
    }

    void note(const Corner& corner)
    {
        if (corner.covering != 0)
            return;
        double gap = radius_;
        for (const double own : gaps_to_near(corner.raised))
            gap = std::min(gap, own);
        if (gap > slack_)
            found_->push_back({number_, corner.weights, gap});
    }

    void search(const std::array<Corner, 3>& corners, int depth)
    {
        const auto& [a, b, c] = corners;
        if (depth == 0 || (a.covering & b.covering & c.covering) != 0)
            return;
        const Corner ab = middle(a, b);
        const Corner bc = middle(b, c);
        const Corner ca = middle(c, a);
        note(ab);
        note(bc);
        note(ca);
        search({a, ab, ca}, depth - 1);
        search({ab, b, bc}, depth - 1);
        search({ca, bc, c}, depth - 1);
        search({ab, bc, ca}, depth - 1);
    }

    const PartSamples& samples_;
    std::span<const UprightSweep> moves_;
    int halvings_;
    double radius_;
    double height_;
    double slack_;
    std::vector<std::int32_t> near_;
    SweepRows rows_;  // of the moves of near_
    std::array<double, most_near> gaps_{};
    std::int32_t number_ = 0;
    std::vector<MissedPlace>* found_ = nullptr;
};

}  // namespace

std::vector<MissedPlace> Coverage::missed(std::span<const std::int32_t> triangles,
                                          double slack, int halvings) const
{
    std::vector<MissedPlace> found;
    MissedSearch search{*this, moves_, slack, halvings};
    for (const std::int32_t number : triangles) {
        const auto& [a, b, c] = samples_->triangles()[number];
        if (!samples_->is_wanted(a) || !samples_->is_wanted(b) ||
            !samples_->is_wanted(c) || gaps_[a] > slack || gaps_[b] > slack ||
            gaps_[c] > slack ||
            search.is_covered(
                {raised_[a], raised_[b], raised_[c]},
                std::array{nearest_move_[a], nearest_move_[b], nearest_move_[c]}))
            continue;
        search.moves_near().clear();
        for (const std::int32_t corner : {a, b, c})
            for (const std::int32_t i : samples_->neighbours(corner))
                if (nearest_move_[i] >= 0)
                    search.moves_near().push_back(nearest_move_[i]);
        search.run(number,
                   {samples_->place_at(a), samples_->place_at(b), samples_->place_at(c)},
                   found);
    }
    return found;
}

}  // namespace endmill
