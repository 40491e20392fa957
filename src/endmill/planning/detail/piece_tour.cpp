// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/piece_tour.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

// The order is a closed tour through all pieces and one more node, the gap, which costs
// nothing to reach. The tour is an array, so that the neighbours in the order are known and
// a part is reversed by its shorter side. Changes are tried at the pieces in a queue; after
// a change the pieces at its ends are queued again.

namespace endmill {
namespace {

// Least gain of a change, as a share of the links that it removes. Smaller gains may be
// rounding errors, which could make the search endless.
constexpr double least_gain = 1e-10;
// Most pieces that are moved together.
constexpr std::size_t longest_run = 3;
// Up to this number of pieces a change may shift all of them, and the search ends only when
// a round over all pieces changes nothing.
constexpr unsigned few_pieces = 1000;
// Most pieces that a change shifts if there are more. Each change then takes limited time.
constexpr unsigned most_shifted = 25000;
// Rounds over all pieces if there are more. Further ones shorten the links by less than 1 %.
constexpr int most_rounds = 3;

}  // namespace

PieceTour::PieceTour(const PieceLinks& links, std::span<const unsigned> starts)
    : links_{links},
      gap_{links.pieces()},
      most_shifted_{links.pieces() <= few_pieces ? few_pieces + 1 : most_shifted},
      rounds_{links.pieces() <= few_pieces ? std::numeric_limits<int>::max()
                                           : most_rounds},
      position_(links.pieces() + 1),
      entry_(links.pieces() + 1, PieceLinks::none),
      exit_(links.pieces() + 1, PieceLinks::none),
      is_waiting_(links.pieces() + 1)
{
    for (const unsigned start : starts) {
        const unsigned piece = links.piece_of(start);
        order_.push_back(piece);
        entry_[piece] = start;
        exit_[piece] = links.end_of(start);
        one_way_ += links.kind(piece) == PieceLinks::Kind::OneWay ? 1 : 0;
    }
    order_.push_back(gap_);
    for (unsigned k = 0; k < nodes(); ++k)
        position_[order_[k]] = k;
}

std::vector<unsigned> PieceTour::starts() const
{
    std::vector<unsigned> starts;
    for (unsigned piece = next(gap_); piece != gap_; piece = next(piece))
        starts.push_back(entry_[piece]);
    return starts;
}

double PieceTour::cost() const
{
    double sum = 0;
    for (unsigned piece = next(gap_); piece != gap_; piece = next(piece))
        sum += link(piece, next(piece));
    return sum;
}

void PieceTour::improve()
{
    bool improved = true;
    for (int round = 0; improved && round < rounds_; ++round) {
        improved = move_gap();
        for (unsigned piece = next(gap_); piece != gap_; piece = next(piece))
            queue(piece);
        while (!waiting_.empty()) {
            const unsigned piece = waiting_.front();
            waiting_.pop_front();
            is_waiting_[piece] = 0;
            if (improve_at(piece)) {
                improved = true;
                queue(piece);
            }
        }
    }
}

void PieceTour::queue(unsigned piece)
{
    if (piece == gap_ || is_waiting_[piece] != 0)
        return;
    is_waiting_[piece] = 1;
    waiting_.push_back(piece);
}

bool PieceTour::improve_at(unsigned piece)
{
    bool improved = is_closed(piece) && restart(piece);
    for (const Side side : {Side::Exit, Side::Entry})
        improved = improved || reverse_at(piece, side) || move_run_at(piece, side);
    return improved;
}

unsigned PieceTour::steps(unsigned from, unsigned to) const
{
    const unsigned a = position_[from];
    const unsigned b = position_[to];
    return b >= a ? b - a : b + nodes() - a;
}

bool PieceTour::is_closed(unsigned node) const
{
    return node != gap_ && links_.kind(node) == PieceLinks::Kind::Closed;
}

// Whether none of `count` nodes from `first` on is a piece that must not be reversed.
bool PieceTour::may_reverse(unsigned first, unsigned count) const
{
    if (one_way_ == 0)
        return true;
    for (unsigned k = 0; k < count; ++k) {
        const unsigned node = at((position_[first] + k) % nodes());
        if (node != gap_ && links_.kind(node) == PieceLinks::Kind::OneWay)
            return false;
    }
    return true;
}

// Starts a closed piece at the tip for which its two links cost least.
bool PieceTour::restart(unsigned piece)
{
    const unsigned from = exit_[previous(piece)];
    const unsigned to = entry_[next(piece)];
    const double old = links_.cost(from, entry_[piece]) + links_.cost(entry_[piece], to);
    double least = old * (1 - least_gain);
    unsigned best = entry_[piece];
    for (unsigned k = 0; k < links_.tips(piece); ++k) {
        const unsigned start = links_.first_tip(piece) + k;
        const double cost = links_.cost(from, start) + links_.cost(start, to);
        if (cost < least)
            least = cost, best = start;
    }
    if (best == entry_[piece])
        return false;
    entry_[piece] = exit_[piece] = best;
    queue(previous(piece));
    queue(next(piece));
    return true;
}

// 2-opt: links this side of a piece to the same side of another one.
bool PieceTour::reverse_at(unsigned piece, Side side)
{
    const Side facing = side == Side::Entry ? Side::Exit : Side::Entry;
    const unsigned own = tip(piece, side);
    const unsigned neighbour = beside(piece, side);
    const double old = links_.cost(own, tip(neighbour, facing));
    for (const PieceLinks::Near& near : links_.near(own)) {
        if (near.cost >= old)
            return false;
        const unsigned other = links_.piece_of(near.other);
        const unsigned others = tip(other, side);
        if (!is_closed(other) && others != near.other)
            continue;
        const unsigned beyond = beside(other, side);
        const double removed = old + links_.cost(others, tip(beyond, facing));
        const double added = links_.cost(own, others) +
                             links_.cost(tip(neighbour, facing), tip(beyond, facing));
        if (!(removed - added > least_gain * removed))
            continue;
        if (!(side == Side::Exit ? reverse(neighbour, other) : reverse(other, neighbour)))
            continue;
        for (const unsigned changed : {piece, other, neighbour, beyond})
            queue(changed);
        return true;
    }
    return false;
}

// Reverses the nodes from `first` to `last`, or all others, which gives the same tour
// backwards. Returns whether one of both is allowed.
bool PieceTour::reverse(unsigned first, unsigned last)
{
    struct Part {
        unsigned first;
        unsigned count;
    };
    const unsigned count = steps(first, last) + 1;
    std::array parts{Part{first, count}, Part{next(last), nodes() - count}};
    if (parts[1].count < parts[0].count)
        std::swap(parts[0], parts[1]);
    for (const Part& part : parts) {
        if (part.count > most_shifted_ || !may_reverse(part.first, part.count))
            continue;
        unsigned low = position_[part.first];
        unsigned high = low + part.count - 1;
        for (; low < high; ++low, --high) {
            const unsigned node = at(low);
            put(low, at(high));
            put(high, node);
            turn(at(low));
            turn(at(high));
        }
        if (low == high)
            turn(at(low));
        return true;
    }
    return false;
}

// Or-opt: moves up to three pieces, of which this is the first or the last one.
bool PieceTour::move_run_at(unsigned piece, Side side)
{
    Run best_run{};
    Insertion best;
    for (unsigned length = 1; length <= longest_run; ++length) {
        const Run run = run_at(piece, side, length);
        if (run.length == 0)
            break;
        const Insertion found = best_insertion(run, side);
        if (found.gain > best.gain)
            best_run = run, best = found;
    }
    if (best.after == PieceLinks::none)
        return false;
    for (const unsigned changed :
         {previous(best_run.first), best_run.first, best_run.last, next(best_run.last),
          best.after, next(best.after)})
        queue(changed);
    move(best_run, best);
    return true;
}

// The run of `length` pieces that `piece` begins (entry side) or ends; without length if
// the gap would be in it or hardly a piece beside it.
PieceTour::Run PieceTour::run_at(unsigned piece, Side side, unsigned length) const
{
    unsigned other = piece;
    for (unsigned k = 1; k < length && other != gap_; ++k)
        other = side == Side::Entry ? next(other) : previous(other);
    if (other == gap_ || nodes() < length + 2)
        return {};
    return side == Side::Entry ? Run{piece, other, length} : Run{other, piece, length};
}

// The best place for a run beside the neighbours of its entry or exit; without a gain if
// no place is better than its own.
PieceTour::Insertion PieceTour::best_insertion(const Run& run, Side side) const
{
    Insertion best;
    const unsigned own = side == Side::Entry ? entry_[run.first] : exit_[run.last];
    for (const PieceLinks::Near& near : links_.near(own)) {
        const unsigned other = links_.piece_of(near.other);
        if (steps(run.first, other) < run.length)
            continue;
        for (const Side other_side : {Side::Entry, Side::Exit}) {
            if (!is_closed(other) && tip(other, other_side) != near.other)
                continue;
            const Insertion found = insertion(run, side, near, other_side);
            if (found.gain > best.gain)
                best = found;
        }
    }
    return best;
}

// The gain of moving a run so that its `side` is linked to `other_side` of a neighbour.
PieceTour::Insertion PieceTour::insertion(const Run& run, Side side,
                                          const PieceLinks::Near& near,
                                          Side other_side) const
{
    const unsigned previous_node = previous(run.first);
    const unsigned next_node = next(run.last);
    const unsigned other = links_.piece_of(near.other);
    const unsigned after = other_side == Side::Exit ? other : previous(other);
    const unsigned before = other_side == Side::Exit ? next(other) : other;
    if (after == previous_node || before == next_node)
        return {};
    const bool is_closed_run = run.length == 1 && is_closed(run.first);
    const bool is_reversed = side == other_side && !is_closed_run;
    if (is_reversed && !may_reverse(run.first, run.length))
        return {};
    if (std::min(steps(run.last, after), steps(before, run.first)) > most_shifted_)
        return {};
    const unsigned entry = is_closed_run ? near.own : entry_[run.first];
    const unsigned exit = is_closed_run ? near.own : exit_[run.last];
    const unsigned beside_other = side == Side::Entry ? entry : exit;
    const unsigned away = side == Side::Entry ? exit : entry;
    const double removed =
        link(previous_node, run.first) + link(run.last, next_node) + link(after, before);
    const double added = links_.cost(tip(other, other_side), beside_other) +
                         (other_side == Side::Exit ? links_.cost(away, entry_[before])
                                                   : links_.cost(exit_[after], away)) +
                         link(previous_node, next_node);
    if (!(removed - added > least_gain * removed))
        return {};
    return {removed - added, after, is_reversed,
            is_closed_run ? near.own : PieceLinks::none};
}

// Shifts the nodes between a run and its new place, by the shorter way around the tour.
void PieceTour::move(const Run& run, const Insertion& insertion)
{
    std::array<unsigned, longest_run> nodes_of_run{};
    const unsigned begin = position_[run.first];
    for (unsigned k = 0; k < run.length; ++k)
        nodes_of_run[k] = at((begin + k) % nodes());
    const unsigned forwards = steps(run.last, insertion.after);
    const unsigned backwards = steps(next(insertion.after), run.first);
    unsigned new_begin = begin;
    if (forwards <= backwards) {
        for (unsigned k = 0; k < forwards; ++k)
            put(begin + k, at((begin + run.length + k) % nodes()));
        new_begin += forwards;
    } else {
        new_begin += nodes() - backwards;
        for (unsigned k = backwards; k-- > 0;)
            put(new_begin + run.length + k, at((new_begin + k) % nodes()));
    }
    for (unsigned k = 0; k < run.length; ++k) {
        const unsigned node =
            nodes_of_run[insertion.is_reversed ? run.length - 1 - k : k];
        put(new_begin + k, node);
        if (insertion.is_reversed)
            turn(node);
    }
    if (insertion.start != PieceLinks::none)
        entry_[run.first] = exit_[run.first] = insertion.start;
}

// Moves the gap into the most expensive link, if that costs more than the link that closes
// the path.
bool PieceTour::move_gap()
{
    unsigned best = gap_;
    double most = 0;
    for (unsigned piece = next(gap_); next(piece) != gap_; piece = next(piece))
        if (const double cost = link(piece, next(piece)); cost > most)
            best = piece, most = cost;
    if (best == gap_ || !(most - link(previous(gap_), next(gap_)) > least_gain * most))
        return false;
    move({gap_, gap_, 1}, {.after = best});
    return true;
}

void PieceTour::put(unsigned position, unsigned node)
{
    position %= nodes();
    order_[position] = node;
    position_[node] = position;
}

void PieceTour::turn(unsigned node)
{
    std::swap(entry_[node], exit_[node]);
}

}  // namespace endmill
