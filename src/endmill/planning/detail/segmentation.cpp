// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/segmentation.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "endmill/core/error.h"

// Samples are the nodes of a graph without cycles, and feasible moves are its edges. The
// search proceeds in layers: layer k holds the samples that k moves reach and k - 1 moves
// do not. The first layer that contains the end gives the least number of moves. Within a
// layer, each sample keeps the predecessor for which the longest move is least. This is
// sound because the first part of a path with the fewest moves has the fewest moves too.
//
// A closed pass is searched as an open one from each possible start to the same sample
// after one turn. In all layers, samples are counted from the start.

namespace endmill {
namespace {

constexpr auto unreached = static_cast<std::size_t>(-1);

// A quick search tests this many longer moves beyond an infeasible one, up to twice the
// length of the last feasible one. Without them one wavy curve in four is divided into
// more moves than by greedy steps, with them one in twenty.
constexpr std::size_t moves_beyond = 8;

// Largest number of bytes for remembered answers of the test.
constexpr std::size_t most_answers = std::size_t{1} << 30;

// The test of a closed pass asks for the same moves from each start.
class RememberedTest {
public:
    // `widest` is the most samples by which a move advances.
    RememberedTest(std::size_t samples, std::size_t widest, const MoveTest& is_feasible)
        : samples_{samples},
          widest_{widest},
          is_feasible_{is_feasible}
    {
        if (samples > most_answers / widest)
            throw LimitError{"fewest_moves: an exact search of a closed pass of " +
                             std::to_string(samples) +
                             " samples needs a smaller widest step, or kept candidates"};
        answers_.resize(samples * widest);
    }

    bool operator()(std::size_t from, std::size_t to)
    {
        const std::size_t step = (to + samples_ - from) % samples_;
        std::uint8_t& answer = answers_[from * widest_ + step - 1];
        if (answer == 0)
            answer = is_feasible_(from, to) ? 2 : 1;
        return answer == 2;
    }

private:
    std::size_t samples_;
    std::size_t widest_;
    const MoveTest& is_feasible_;
    std::vector<std::uint8_t> answers_;  // 0: not asked yet, 1: no, 2: yes
};

// Searches paths from sample `start` forwards over `end` samples.
class LayeredSearch {
public:
    // The sample numbers of `is_feasible` are taken modulo `samples`.
    LayeredSearch(std::size_t samples, std::size_t end, std::size_t widest,
                  const MoveTest& is_feasible)
        : samples_{samples},
          end_{end},
          widest_{widest},
          is_feasible_{is_feasible},
          reached_(end + 1)
    {
    }

    // Finds a path of at most `most_moves` moves. With `kept` > 0 the search is quick.
    bool run(std::size_t start, std::size_t most_moves, std::size_t kept)
    {
        start_ = start;
        std::ranges::fill(reached_, Reached{});
        reached_[0] = {0, 0, 0};
        std::vector<std::size_t> layer{0};
        typical_step_ = 1;
        for (std::size_t moves = 1; moves <= most_moves && !layer.empty(); ++moves) {
            layer =
                kept > 0 ? farthest_after(layer, moves, kept) : all_after(layer, moves);
            if (reached_[end_].moves == moves)
                return true;
        }
        return false;
    }

    std::size_t moves() const { return reached_[end_].moves; }
    std::size_t longest_move() const { return reached_[end_].longest; }

    // The vertices of the path in rising order, counted from the start.
    std::vector<std::size_t> vertices() const
    {
        std::vector<std::size_t> vertices{end_};
        while (vertices.back() != 0)
            vertices.push_back(reached_[vertices.back()].previous);
        std::ranges::reverse(vertices);
        return vertices;
    }

private:
    // The best path to a sample that was found.
    struct Reached {
        std::size_t moves = unreached;
        std::size_t longest = unreached;  // samples by which its longest move advances
        std::size_t previous = 0;
    };

    bool is_feasible(std::size_t from, std::size_t to) const
    {
        return is_feasible_((start_ + from) % samples_, (start_ + to) % samples_);
    }

    // The farthest sample to which a move from `from` may lead.
    std::size_t limit(std::size_t from) const
    {
        // A move around a whole closed pass would have no length.
        const std::size_t most = end_ == samples_ && from == 0 ? end_ - 1 : end_;
        return widest_ < most - from ? from + widest_ : most;
    }

    // Whether a move between these samples would give a better path of `moves` moves.
    bool improves(std::size_t from, std::size_t to, std::size_t moves) const
    {
        const Reached& known = reached_[to];
        return known.moves == unreached ||
               (known.moves == moves &&
                std::max(reached_[from].longest, to - from) < known.longest);
    }

    void reach(std::size_t from, std::size_t to, std::size_t moves)
    {
        reached_[to] = {moves, std::max(reached_[from].longest, to - from), from};
    }

    // The samples that `moves` moves reach but no fewer, the farthest one first. `layer`
    // holds those that one move less reaches. If the end is among them, only the end.
    std::vector<std::size_t> all_after(const std::vector<std::size_t>& layer,
                                       std::size_t moves)
    {
        for (const std::size_t from : layer)
            if (limit(from) == end_ && improves(from, end_, moves) &&
                is_feasible(from, end_))
                reach(from, end_, moves);
        if (reached_[end_].moves == moves)
            return {end_};
        std::vector<std::size_t> next;
        for (const std::size_t from : layer) {
            const std::size_t last = std::min(limit(from), end_ - 1);
            for (std::size_t to = from + 1; to <= last; ++to)
                if (improves(from, to, moves) && is_feasible(from, to)) {
                    if (reached_[to].moves == unreached)
                        next.push_back(to);
                    reach(from, to, moves);
                }
        }
        std::ranges::sort(next, std::greater{});
        return next;
    }

    // Some of these samples, the farthest one first: the ends of long moves, and others
    // spread over the last move until there are `kept`.
    std::vector<std::size_t> farthest_after(const std::vector<std::size_t>& layer,
                                            std::size_t moves, std::size_t kept)
    {
        std::vector<std::size_t> next;
        std::size_t guess = layer.front() + typical_step_;
        for (const std::size_t from : layer) {
            const std::size_t to = far_move(from, guess);
            if (to == from || !improves(from, to, moves))
                continue;
            if (reached_[to].moves == unreached)
                next.push_back(to);
            reach(from, to, moves);
            guess = to;
        }
        if (next.empty())
            return next;
        std::ranges::sort(next, std::greater{});
        typical_step_ = next.front() - std::min(layer.front(), next.front() - 1);
        if (next.front() == end_)
            return {end_};
        add_before(next, layer, moves, kept);
        return next;
    }

    // The end of a long feasible move, or `from`: the end of the first stretch of feasible
    // moves around `guess`, or of a later stretch.
    std::size_t far_move(std::size_t from, std::size_t guess) const
    {
        const std::size_t most = limit(from);
        const std::size_t near = most == from ? from : end_of_stretch(from, guess, most);
        const std::size_t step = std::max<std::size_t>((near - from) / moves_beyond, 1);
        const std::size_t farthest = std::min(most, near + moves_beyond * step);
        std::size_t far = near;
        for (std::size_t to = near + step; to <= farthest && near > from; to += step)
            if (is_feasible(from, to))
                far = to;
        return far == near ? near
                           : last_feasible(from, far, std::min(far + step, most + 1));
    }

    // A feasible end `to` for which `to` + 1 is infeasible or beyond `most`; `from` if
    // there is none. Starting at `guess`, the end is shifted by doubled amounts until one
    // end is feasible and a later one is not.
    std::size_t end_of_stretch(std::size_t from, std::size_t guess,
                               std::size_t most) const
    {
        std::size_t feasible = from;
        std::size_t infeasible = most + 1;
        std::size_t to = std::clamp(guess, from + 1, most);
        for (std::size_t shift = 1; infeasible - feasible > 1; shift *= 2) {
            const bool is_sound = is_feasible(from, to);
            (is_sound ? feasible : infeasible) = to;
            if (infeasible <= most && feasible > from)
                break;
            to = is_sound ? std::min(to + shift, most)
                          : std::max(to - std::min(shift, to), from + 1);
        }
        return last_feasible(from, feasible, infeasible);
    }

    // Halves the difference of a feasible and an infeasible end until they are neighbours.
    std::size_t last_feasible(std::size_t from, std::size_t feasible,
                              std::size_t infeasible) const
    {
        while (infeasible - feasible > 1) {
            const std::size_t middle = feasible + (infeasible - feasible) / 2;
            (is_feasible(from, middle) ? feasible : infeasible) = middle;
        }
        return feasible;
    }

    // Adds samples before the farthest one of `next`, spread over the last move, until
    // there are `kept`.
    void add_before(std::vector<std::size_t>& next, const std::vector<std::size_t>& layer,
                    std::size_t moves, std::size_t kept)
    {
        const std::size_t spacing = std::max<std::size_t>(typical_step_ / kept, 1);
        std::size_t misses = 0;
        for (std::size_t to = next.front();
             to > layer.front() + spacing && next.size() < kept && misses < kept;) {
            to -= spacing;
            if (reached_[to].moves != unreached)
                continue;
            const auto from = std::ranges::find_if(layer, [&](std::size_t sample) {
                return to <= limit(sample) && is_feasible(sample, to);
            });
            if (from == layer.end()) {
                ++misses;
                continue;
            }
            reach(*from, to, moves);
            next.push_back(to);
        }
        std::ranges::sort(next, std::greater{});
    }

    std::size_t samples_;
    std::size_t end_;
    std::size_t widest_;
    const MoveTest& is_feasible_;
    std::vector<Reached> reached_;
    std::size_t start_ = 0;
    std::size_t typical_step_ = 1;
};

// The sample numbers of `search`, which started at `start`.
std::vector<std::size_t> sample_numbers(const LayeredSearch& search, std::size_t start,
                                        std::size_t samples)
{
    std::vector<std::size_t> numbers = search.vertices();
    for (std::size_t& number : numbers)
        number = (start + number) % samples;
    return numbers;
}

std::optional<Segmentation> open_division(std::size_t samples, std::size_t widest,
                                          const MoveTest& is_feasible, std::size_t kept)
{
    LayeredSearch search{samples, samples - 1, widest, is_feasible};
    if (!search.run(0, unreached - 1, kept))
        return std::nullopt;
    return Segmentation{search.vertices(), search.moves(), search.longest_move(), 0,
                        kept == 0};
}

// Samples one of which is a vertex of every division of a closed pass: the ends of the
// feasible moves that lead across the end of the list of samples.
std::vector<std::size_t> exact_starts(std::size_t samples, std::size_t widest,
                                      const MoveTest& is_feasible)
{
    std::vector<std::size_t> starts;
    for (std::size_t to = 0; to < widest; ++to)
        for (std::size_t from = samples - 1; from >= samples + to - widest; --from)
            if (is_feasible(from, to)) {
                starts.push_back(to);
                break;
            }
    return starts;
}

// At most `count` samples, spread over the first move of a search from sample 0.
std::vector<std::size_t> spread_starts(LayeredSearch& search, std::size_t count)
{
    std::vector<std::size_t> starts{0};
    if (!search.run(0, unreached - 1, count))
        return starts;
    const std::size_t first_move = search.vertices()[1];
    for (std::size_t k = 1; k < std::min(count, first_move); ++k)
        starts.push_back(k * first_move / std::min(count, first_move));
    return starts;
}

std::optional<Segmentation> closed_division(std::size_t samples, std::size_t widest,
                                            const MoveTest& is_feasible, std::size_t kept)
{
    LayeredSearch search{samples, samples, widest, is_feasible};
    std::optional<Segmentation> best;
    for (const std::size_t start : kept > 0
                                       ? spread_starts(search, kept)
                                       : exact_starts(samples, widest, is_feasible)) {
        if (!search.run(start, best ? best->moves : unreached - 1, kept))
            continue;
        if (best && std::pair{best->moves, best->longest_move} <=
                        std::pair{search.moves(), search.longest_move()})
            continue;
        std::vector<std::size_t> vertices = sample_numbers(search, start, samples);
        vertices.pop_back();
        std::ranges::sort(vertices);
        best = Segmentation{std::move(vertices), search.moves(), search.longest_move(), 0,
                            kept == 0};
    }
    return best;
}

}  // namespace

std::optional<Segmentation> fewest_moves(std::size_t samples, PassShape shape,
                                         const MoveTest& is_feasible,
                                         const SegmentationOptions& options)
{
    require(samples >= 2, "fewest_moves: need at least two samples");
    const std::size_t widest = options.widest_step == 0
                                   ? samples - 1
                                   : std::min(options.widest_step, samples - 1);
    const std::size_t kept = options.kept_candidates;
    std::size_t tested_moves = 0;
    const MoveTest counted = [&](std::size_t from, std::size_t to) {
        ++tested_moves;
        return is_feasible(from, to);
    };
    std::optional<Segmentation> division;
    if (shape == PassShape::Open) {
        division = open_division(samples, widest, counted, kept);
    } else if (kept > 0) {
        division = closed_division(samples, widest, counted, kept);
    } else {
        division = closed_division(samples, widest,
                                   RememberedTest{samples, widest, counted}, kept);
    }
    if (division)
        division->tested_moves = tested_moves;
    return division;
}

}  // namespace endmill
