// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <span>
#include <vector>

#include "endmill/planning/detail/piece_links.h"

namespace endmill {

/// An order of pieces that changes to reduce its cost.
class PieceTour {
public:
    /// \param links  of the pieces; must outlive this.
    /// \param starts the tip at which each piece starts, in the order of the pieces.
    PieceTour(const PieceLinks& links, std::span<const unsigned> starts);

    /// Changes the order until no change helps; ends earlier for more than 1000 pieces.
    void improve();

    /// The tip at which each piece starts, in the order of the pieces.
    std::vector<unsigned> starts() const;

    double cost() const;  ///< sum of the costs of all links

private:
    // The sides of a piece. The next piece is after its exit.
    enum class Side { Entry, Exit };
    // Pieces to be moved, from `first` to `last` in the order.
    struct Run {
        unsigned first;
        unsigned last;
        unsigned length;
    };
    // A place to which a run may be moved, and the gain.
    struct Insertion {
        double gain = 0;
        unsigned after = PieceLinks::none;  // node before the run
        bool is_reversed = false;
        unsigned start = PieceLinks::none;  // of a run that is a closed piece
    };

    unsigned next(unsigned piece) const { return at(position_[piece] + 1); }
    unsigned previous(unsigned piece) const { return at(position_[piece] + nodes() - 1); }
    unsigned at(unsigned position) const
    {
        return order_[position < nodes() ? position : position - nodes()];
    }
    unsigned nodes() const { return static_cast<unsigned>(order_.size()); }
    unsigned steps(unsigned from, unsigned to) const;
    double link(unsigned from, unsigned to) const
    {
        return links_.cost(exit_[from], entry_[to]);
    }
    unsigned tip(unsigned node, Side side) const
    {
        return side == Side::Entry ? entry_[node] : exit_[node];
    }
    unsigned beside(unsigned node, Side side) const
    {
        return side == Side::Entry ? previous(node) : next(node);
    }
    bool is_closed(unsigned node) const;
    bool may_reverse(unsigned first, unsigned count) const;
    Run run_at(unsigned piece, Side side, unsigned length) const;
    Insertion best_insertion(const Run& run, Side side) const;
    Insertion insertion(const Run& run, Side side, const PieceLinks::Near& near,
                        Side other_side) const;

    bool improve_at(unsigned piece);
    bool restart(unsigned piece);
    bool reverse_at(unsigned piece, Side side);
    bool reverse(unsigned first, unsigned last);
    bool move_run_at(unsigned piece, Side side);
    bool move_gap();
    void move(const Run& run, const Insertion& insertion);
    void put(unsigned position, unsigned node);
    void turn(unsigned node);
    void queue(unsigned piece);

    const PieceLinks& links_;
    unsigned gap_;           // node between the last piece and the first one
    unsigned most_shifted_;  // nodes that a change may shift
    int rounds_;             // most rounds over all pieces
    unsigned one_way_ = 0;   // number of such pieces
    std::vector<unsigned> order_;
    std::vector<unsigned> position_;  // by node
    std::vector<unsigned> entry_;     // tips, by node
    std::vector<unsigned> exit_;
    std::deque<unsigned> waiting_;  // pieces beside which a change may help
    std::vector<char> is_waiting_;  // by node
};

}  // namespace endmill
