// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/piece_links.h"

#include <algorithm>
#include <utility>

namespace endmill {
namespace {

// Tips of a closed piece from which its neighbours are searched.
constexpr unsigned searched_starts = 16;
// Spacing of the tips of a piece from which its neighbours are searched.
unsigned spacing(unsigned tips)
{
    return (tips + searched_starts - 1) / searched_starts;
}

}  // namespace

PieceLinks::PieceLinks(std::span<const PieceEnds> pieces, std::size_t neighbours,
                       LinkCost cost)
    : neighbours_{neighbours},
      cost_{std::move(cost)}
{
    unsigned groups = 0;
    first_tips_.push_back(0);
    for (const PieceEnds& piece : pieces) {
        if (const auto* open = std::get_if<OpenPiece>(&piece)) {
            kinds_.push_back(open->may_reverse ? Kind::Reversible : Kind::OneWay);
            places_.insert(places_.end(), {open->first, open->last});
            groups_.insert(groups_.end(), {groups, groups + 1});
            groups += 2;
        } else {
            const auto& starts = std::get<ClosedPiece>(piece).starts;
            kinds_.push_back(Kind::Closed);
            places_.insert(places_.end(), starts.begin(), starts.end());
            groups_.insert(groups_.end(), starts.size(), groups++);
        }
        piece_of_.resize(places_.size(), this->pieces() - 1);
        first_tips_.push_back(static_cast<unsigned>(places_.size()));
    }
    tree_ = TipTree{places_, groups_};
    add_near_links();
}

// Finds the links to the nearest pieces, between some tips of closed ones.
void PieceLinks::add_near_links()
{
    TipTree tree = tree_;
    for (unsigned piece = 0; piece < pieces(); ++piece)
        for (unsigned k = 0; k < tips(piece); ++k)
            if (k % spacing(tips(piece)) != 0)
                tree.remove(first_tip(piece) + k);
    first_near_.push_back(0);
    for (unsigned piece = 0; piece < pieces(); ++piece)
        if (kind(piece) == Kind::Closed)
            add_near(tree, first_tip(piece), tips(piece));
        else
            for (const unsigned end : {0U, 1U})
                add_near(tree, first_tip(piece) + end, 1);
}

// Appends the nearest links of a group of tips.
void PieceLinks::add_near(const TipTree& tree, unsigned first, unsigned count)
{
    std::vector<Near> found;
    for (unsigned own = first; own < first + count; own += spacing(count))
        // The piece itself has up to two groups.
        for (const auto& [distance, other] : tree.nearest(places_[own], neighbours_ + 2))
            if (piece_of(other) != piece_of(own))
                found.push_back({cost(own, other), own, other});
    std::ranges::stable_sort(found, {}, &Near::cost);
    std::vector<unsigned> added;
    for (const Near& link : found) {
        if (added.size() == neighbours_)
            break;
        if (std::ranges::find(added, groups_[link.other]) != added.end())
            continue;
        added.push_back(groups_[link.other]);
        near_.push_back(link);
    }
    first_near_.push_back(near_.size());
}

unsigned PieceLinks::end_of(unsigned start) const
{
    const unsigned piece = piece_of(start);
    return kind(piece) == Kind::Closed ? start : 2 * first_tip(piece) + 1 - start;
}

double PieceLinks::cost(unsigned from, unsigned to) const
{
    if (from == none || to == none)
        return 0;
    if (cost_)
        return cost_({piece_of(from), piece_of(to), places_[from], places_[to]});
    return (places_[to] - places_[from]).norm();
}

std::span<const PieceLinks::Near> PieceLinks::near(unsigned tip) const
{
    const unsigned group = groups_[tip];
    return std::span{near_}.subspan(first_near_[group],
                                    first_near_[group + 1] - first_near_[group]);
}

std::vector<unsigned> PieceLinks::possible_starts() const
{
    std::vector<unsigned> starts;
    for (unsigned piece = 0; piece < pieces(); ++piece) {
        starts.push_back(first_tip(piece));
        if (kind(piece) == Kind::Reversible)
            starts.push_back(first_tip(piece) + 1);
    }
    return starts;
}

std::vector<unsigned> PieceLinks::nearest_tour(unsigned start) const
{
    TipTree remaining = tree_;
    for (unsigned piece = 0; piece < pieces(); ++piece)
        if (kind(piece) == Kind::OneWay)
            remaining.remove(first_tip(piece) + 1);
    const std::size_t tried = cost_ ? neighbours_ : 1;
    std::vector<unsigned> starts{start};
    while (starts.size() < pieces()) {
        const unsigned piece = piece_of(starts.back());
        for (unsigned k = 0; k < tips(piece); ++k)
            remaining.remove(first_tip(piece) + k);
        const unsigned end = end_of(starts.back());
        const auto found = remaining.nearest(places_[end], tried);
        const auto nearest =
            std::ranges::min_element(found, {}, [&](const TipTree::Neighbour& neighbour) {
                return tried > 1 ? cost(end, neighbour.tip) : 0;
            });
        starts.push_back(nearest->tip);
    }
    return starts;
}

}  // namespace endmill
