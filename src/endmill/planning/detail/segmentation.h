// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

/// \file
/// Divides a densely sampled pass into as few straight moves as its tolerances allow.

namespace endmill {

/// Whether the last sample of a pass is followed by the first one.
enum class PassShape {
    Open,    ///< leads from the first sample to the last one
    Closed,  ///< returns to the sample at which it starts
};

/// Returns whether the straight move from sample `from` to sample `to` is feasible: it
/// keeps all tolerances between these samples. On an open pass from < to. On a closed
/// pass `to` < `from` denotes a move across the end of the list of samples. A part of a
/// feasible move need not be feasible. The answer must depend on `from` and `to` only.
using MoveTest = std::function<bool(std::size_t from, std::size_t to)>;

/// Options for the division of a pass.
struct SegmentationOptions {
    /// Most samples by which a move may advance; 0: no limit. On a closed pass a move
    /// never advances by all samples.
    std::size_t widest_step = 0;
    /// Vertices from which the search continues, of those that equally many moves reach.
    /// 0: all, which makes the result exact.
    std::size_t kept_candidates = 8;
};

/// A pass divided into moves.
struct Segmentation {
    /// Numbers of the samples at the ends of moves, in rising order. On an open pass the
    /// first is 0 and the last is n - 1. On a closed pass another move leads from the last
    /// vertex to the first.
    std::vector<std::size_t> vertices;
    std::size_t moves;         ///< number of moves
    std::size_t longest_move;  ///< most samples by which a move advances
    std::size_t tested_moves;  ///< calls of the test
    bool is_exact;             ///< whether the search was exact: no division has fewer
};

/// Divides a pass of n samples into moves between samples, each of which is feasible.
///
/// With `kept_candidates` = 0 no division at these samples has fewer moves. Among the
/// divisions with this number of moves the result has the least `longest_move`. Of
/// several such divisions a fixed rule chooses one.
///
/// Otherwise the search is quick but not exact. From each kept vertex it finds a long
/// move by doubling and halving steps, and a few tests beyond. It keeps the ends of these
/// moves, and others spread over the last move. A closed pass is tried from at most
/// `kept_candidates` starts.
/// Source: paper/notes/fewest-moves.md, sections 1 to 3.
///
/// \param samples     n, at least 2.
/// \param shape       whether the pass is closed.
/// \param is_feasible tests a move; it is not called twice for one move in exact mode.
/// \param options     as above.
/// \return no value if the search finds no division; in exact mode there is none. In
///         quick mode it finds one if all moves between neighbouring samples are
///         feasible.
/// \throws DomainError unless n >= 2.
/// \throws LimitError if the pass is closed, the search exact and n s above 2^30.
///
/// With s the widest step, or n - 1, exact mode tests at most n s moves in O(n s) time on
/// an open pass. A closed pass takes O(n s r) time and n s bytes, where r is the longest
/// feasible move. Quick mode with 8 candidates tests about 120 moves for each move of the
/// result, and 8 times as many on a closed pass. On wavy curves it needed 2 % more moves
/// than exact mode. Memory is 24 n bytes.
std::optional<Segmentation> fewest_moves(std::size_t samples, PassShape shape,
                                         const MoveTest& is_feasible,
                                         const SegmentationOptions& options = {});

}  // namespace endmill
