// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "endmill/strategy/detail/coverage.h"
#include "endmill/strategy/detail/front_march.h"
#include "endmill/strategy/detail/reach.h"

namespace endmill {

/// Length of a pass along its contacts, mm.
double pass_length(const LaidPass& pass);

/// A change of a piece.
struct PieceChange {
    std::size_t piece;  ///< number of the piece
    /// Contacts from `first` to before `last` are replaced; > 0 for a closed piece.
    std::size_t first;
    std::size_t last;             ///< at least `first`, at most the number of contacts
    std::vector<PassContact> by;  ///< contacts instead of them
    /// Number of another piece, which is taken away.
    std::optional<std::size_t> without = {};
};

/// Pieces of passes that cover a part together. They can be changed, also under the condition
/// that everything remains covered. Unlike Coverage, it knows all moves that cover a sample,
/// so that moves can be taken away, and each change costs as much as its moves.
///
/// A triangle of the net is covered if one move covers its corners with a margin for the
/// curvature between them; otherwise it is divided into four, again and again.
/// Source: docs/methods/iso-scallop.md, sections 1 and 6.
class CoveringPieces {
public:
    /// Covers nothing.
    /// \param samples of the part; they must outlive this object.
    /// \param cutter  the ball.
    /// \param height  up to which material may be left, mm.
    CoveringPieces(const PartSamples& samples, const BallCutter& cutter, double height);

    /// Adds a piece with straight moves between its contacts.
    /// \return its number.
    std::size_t add(LaidPass piece);

    /// Takes a piece away. Its number stays without contacts.
    void remove(std::size_t number);

    /// Takes a piece away if everything that is covered remains covered.
    /// \return whether it was taken away.
    bool leave_out(std::size_t number);

    /// Whether everything that is covered would remain covered after a change.
    bool would_cover(const PieceChange& change);

    /// Makes a change if everything that is covered remains covered.
    /// \return whether it was made.
    bool make(const PieceChange& change);

    /// Cuts a piece in the other direction.
    void reverse(std::size_t number);

    /// Has a closed piece begin and end at one of its contacts.
    void open(std::size_t number, std::size_t start);

    /// Appends another open piece to an open piece, at least one of them with two contacts.
    /// \param way contacts from the last one of the piece to the first one of `next`, without
    ///            these two.
    void append(std::size_t number, std::span<const PassContact> way, std::size_t next);

    /// All pieces by their numbers. Those that were taken away have no contacts.
    std::span<const LaidPass> pieces() const { return pieces_; }

    /// The worst of the places found in each triangle that is not covered, by the numbers of
    /// the triangles.
    std::vector<MissedPlace> missed();

private:
    class TriangleTest;

    // A straight move, and the samples around it.
    struct CoveringMove {
        UprightSweep sweep;
        std::vector<std::int32_t> covered;  // samples that it covers
        std::vector<std::int32_t> around;   // their neighbours that it does not cover
    };
    using MoveNumbers = std::vector<std::int32_t>;

    MoveNumbers moves_along(std::span<const PassContact> contacts);
    std::int32_t move_between(const PassContact& from, const PassContact& to);
    void enter(std::int32_t move);
    void leave(std::int32_t move);
    void release(std::span<const std::int32_t> moves);
    // The moves that a change takes away, those that it adds, and the place of the first.
    struct MoveExchange {
        MoveNumbers removed;
        MoveNumbers added;
        std::size_t first;
        std::size_t last;  // after those of the changed piece
    };
    MoveExchange exchange_for(const PieceChange& change);

    void swap_moves(std::span<const std::int32_t> removed,
                    std::span<const std::int32_t> added);
    bool exchange(std::span<const std::int32_t> removed,
                  std::span<const std::int32_t> added);
    bool remains_covered(std::span<const std::int32_t> without);
    void outdate(std::span<const std::int32_t> moves, bool also_covered);
    void update();

    const PartSamples& samples_;
    double radius_;
    double height_;
    std::vector<LaidPass> pieces_;
    std::vector<MoveNumbers> moves_of_pieces_;  // in their order
    std::vector<CoveringMove> moves_;
    MoveNumbers free_moves_;             // numbers of moves that no piece has
    std::vector<MoveNumbers> moves_at_;  // moves that cover each sample
    SampleWalk walk_;
    std::vector<std::uint32_t>
        tested_;  // by triangle: the change for which it was tested
    std::uint32_t change_ = 0;
    std::vector<std::int32_t>
        outdated_;                   // triangles that may have changed since `update`
    std::vector<char> is_outdated_;  // by triangle
    std::vector<char> is_missed_;    // by triangle
    std::map<std::int32_t, MissedPlace> missed_;
};

}  // namespace endmill
