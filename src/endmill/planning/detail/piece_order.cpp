// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/piece_order.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/planning/detail/piece_links.h"
#include "endmill/planning/detail/piece_tour.h"

namespace endmill {
namespace {

// Most tips of all pieces.
constexpr std::size_t most_tips = std::size_t{1} << 31;

// Number of tips times tours up to which several tours are tried.
constexpr std::size_t tips_of_all_tours = 4000;

// Throws DomainError unless the piece is valid. Returns the number of its tips.
std::size_t checked_tips(const PieceEnds& piece)
{
    if (const auto* open = std::get_if<OpenPiece>(&piece)) {
        require(open->first.allFinite() && open->last.allFinite(),
                "order_pieces: the ends of a piece must be finite");
        return 2;
    }
    const auto& starts = std::get<ClosedPiece>(piece).starts;
    require(!starts.empty(), "order_pieces: a closed piece needs a start");
    for (const Vec3& start : starts)
        require(start.allFinite(), "order_pieces: the starts of a piece must be finite");
    return starts.size();
}

PieceOrder order_of(const PieceTour& tour, const PieceLinks& links)
{
    PieceOrder order{{}, tour.cost()};
    for (const unsigned start : tour.starts()) {
        const unsigned piece = links.piece_of(start);
        const unsigned number = start - links.first_tip(piece);
        if (links.kind(piece) == PieceLinks::Kind::Closed)
            order.pieces.push_back({piece, false, number});
        else
            order.pieces.push_back({piece, number == 1, 0});
    }
    return order;
}

}  // namespace

PieceOrder order_pieces(std::span<const PieceEnds> pieces,
                        const PieceOrderOptions& options)
{
    require(options.tours >= 1 && options.neighbours >= 1,
            "order_pieces: need at least one tour and one neighbour");
    std::size_t tips = 0;
    for (const PieceEnds& piece : pieces)
        tips += checked_tips(piece);
    if (tips > most_tips)
        throw LimitError{"order_pieces: the pieces have more than 2^31 ends and starts"};
    if (pieces.empty())
        return {};
    const PieceLinks links{pieces, options.neighbours, options.cost};
    const std::vector<unsigned> starts = links.possible_starts();
    const std::size_t tours =
        std::min({std::max<std::size_t>(tips_of_all_tours / tips, 1), options.tours,
                  starts.size()});
    std::optional<PieceTour> best;
    for (std::size_t k = 0; k < tours; ++k) {
        PieceTour tour{links, links.nearest_tour(starts[k * starts.size() / tours])};
        tour.improve();
        if (!best || tour.cost() < best->cost())
            best.emplace(std::move(tour));
    }
    return order_of(*best, links);
}

}  // namespace endmill
