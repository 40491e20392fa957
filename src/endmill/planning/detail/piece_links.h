// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <variant>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/planning/detail/tip_tree.h"

namespace endmill {

/// A piece of a path that is cut from one end to the other.
struct OpenPiece {
    Vec3 first;               ///< mm, tip at which it starts
    Vec3 last;                ///< mm, tip at which it ends
    bool may_reverse = true;  ///< whether it may be cut from `last` to `first`
};

/// A piece of a path that returns to the tip at which it starts.
struct ClosedPiece {
    /// mm, at least one; the tips at which it may start, each only once.
    std::vector<Vec3> starts;
};

/// A piece, as far as the order of pieces depends on it.
using PieceEnds = std::variant<OpenPiece, ClosedPiece>;

/// A link from the end of a piece to the start of the next one.
struct PieceLink {
    std::size_t from_piece;  ///< number of the piece that it leaves
    std::size_t to_piece;    ///< number of the piece to which it leads
    Vec3 from;               ///< mm, tip
    Vec3 to;                 ///< mm, tip
};

/// Cost of a link, finite and at least 0. It must not depend on the direction of the link.
using LinkCost = std::function<double(const PieceLink& link)>;

/// The tips of pieces, and the links near them, in which an order is searched.
class PieceLinks {
public:
    static constexpr unsigned none = static_cast<unsigned>(-1);  ///< no tip

    /// How a piece may be cut.
    enum class Kind : char { OneWay, Reversible, Closed };

    /// A link to a tip of another piece.
    struct Near {
        double cost;     ///< of the link
        unsigned own;    ///< tip of the piece
        unsigned other;  ///< tip of the other piece
    };

    /// \param pieces     all must be valid.
    /// \param neighbours links that are kept of each tip of an open piece and of each
    ///                   closed one, at least 1.
    /// \param cost       of a link; empty: its length in mm.
    PieceLinks(std::span<const PieceEnds> pieces, std::size_t neighbours,
               LinkCost cost = {});
    PieceLinks(const PieceLinks&) = delete;
    PieceLinks& operator=(const PieceLinks&) = delete;

    unsigned pieces() const { return static_cast<unsigned>(kinds_.size()); }  ///< m
    Kind kind(unsigned piece) const { return kinds_[piece]; }  ///< how it may be cut

    /// Tips are numbered piece by piece. An open piece has two, the first one first.
    unsigned first_tip(unsigned piece) const { return first_tips_[piece]; }
    /// Number of tips of a piece.
    unsigned tips(unsigned piece) const
    {
        return first_tips_[piece + 1] - first_tips_[piece];
    }
    /// Number of the piece to which a tip belongs.
    unsigned piece_of(unsigned tip) const { return piece_of_[tip]; }
    /// The tip at which a piece ends that starts at `start`.
    unsigned end_of(unsigned start) const;

    /// Cost of the link between two tips; 0 if one of them is `none`.
    double cost(unsigned from, unsigned to) const;

    /// Links from a tip of an open piece, or from all tips of a closed one, to the nearest
    /// other pieces; the least cost first.
    std::span<const Near> near(unsigned tip) const;

    /// The tips at which a tour may begin; one of each closed piece.
    std::vector<unsigned> possible_starts() const;

    /// The tips at which the pieces start if the tour begins at tip `start` and leads to
    /// the nearest remaining piece each time.
    std::vector<unsigned> nearest_tour(unsigned start) const;

private:
    void add_near_links();
    void add_near(const TipTree& tree, unsigned first, unsigned count);

    std::size_t neighbours_;
    LinkCost cost_;
    std::vector<Kind> kinds_;
    std::vector<unsigned> first_tips_;  // and the number of all tips
    std::vector<Vec3> places_;          // of the tips
    std::vector<unsigned> piece_of_;    // by tip
    std::vector<unsigned> groups_;  // by tip: an end of an open piece, or a closed piece
    std::vector<Near> near_;
    std::vector<std::size_t> first_near_;  // by group, and the number of all
    TipTree tree_{{}, {}};
};

}  // namespace endmill
