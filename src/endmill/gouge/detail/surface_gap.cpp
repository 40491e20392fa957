// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/gouge/detail/surface_gap.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace endmill {
namespace {

// Halvings of a piece: 2^-40 of its size is below any resolution that rounding permits.
constexpr int most_halvings = 80;

constexpr double infinite = std::numeric_limits<double>::infinity();

// The point sought: the one with the smallest gap, or any below the limit.
enum class Aim { Least, Any };

// A branch-and-bound search over boxes, then over pieces, the nearest first. The smallest
// gap found so far is the limit. Lower bounds come from supporting planes of the cutter's
// core, upper bounds from the corners of pieces. A piece that both do not settle is
// halved.
class GapSearch {
public:
    GapSearch(const PieceTree& tree, const CutterCore& core, double resolution,
              FinerPieces& finer, Aim aim)
        : tree_{tree},
          core_{core},
          resolution_{resolution},
          finer_{finer},
          aim_{aim}
    {
    }

    std::optional<SurfaceGap> least(double enough)
    {
        least_ = enough;
        std::vector<std::int32_t> open{0};
        while (!open.empty()) {
            const PieceTree::Node& node = tree_.nodes()[open.back()];
            open.pop_back();
            if (box_bound(node.box) >= least_ - resolution_)
                continue;
            if (node.link < 0) {
                search_pieces(~node.link);
                continue;
            }
            const auto gap = [&](std::int32_t child) {
                return core_.gap(tree_.nodes()[child].box.center());
            };
            push_nearer_last(open, node.link, gap);
        }
        return found_;
    }

private:
    template <typename Gap>
    static void push_nearer_last(std::vector<std::int32_t>& open, std::int32_t first,
                                 const Gap& gap)
    {
        const bool swap = gap(first + 1) < gap(first);
        open.push_back(swap ? first : first + 1);
        open.push_back(swap ? first + 1 : first);
    }

    double box_bound(const Eigen::AlignedBox3d& box) const
    {
        const auto [normal, distance] = core_.nearest_plane(box.center());
        return distance - normal.cwiseAbs().dot(box.sizes()) / 2 - core_.corner_radius();
    }

    // A lower bound of the gap of a piece, by the supporting plane nearest to its middle.
    // If that is not sufficient, as near an edge of the core, the plane parallel to the
    // piece is tried as well.
    double piece_bound(const PieceTree::Piece& piece) const
    {
        const BezierPiece& bezier = piece.bezier;
        const double r = core_.corner_radius();
        const auto [normal, distance] = core_.nearest_plane(piece.middle);
        const double bound =
            bezier.least_height(normal, piece.middle - distance * normal) - r;
        if (bound >= least_ - resolution_)
            return bound;
        const Vec3 across = bezier.corner(1, 1) - bezier.corner(0, 0);
        const Vec3 other = bezier.corner(0, 1) - bezier.corner(1, 0);
        const Vec3 away = core_.turned_away(across.cross(other), piece.middle);
        const double least = bezier.least_height(away, Vec3::Zero());
        return std::max(bound, core_.distance_beyond(away, least) - r);
    }

    void search_pieces(std::int32_t patch)
    {
        std::vector<std::int32_t> open{patch};
        while (!open.empty()) {
            const std::int32_t number = open.back();
            const PieceTree::Piece& piece = tree_.pieces()[number];
            open.pop_back();
            if (piece.halves == 0)
                search_finer(number);
            else if (piece_bound(piece) < least_ - resolution_)
                push_nearer_last(open, piece.halves, [&](std::int32_t half) {
                    return core_.gap(tree_.pieces()[half].middle);
                });
        }
    }

    struct Halved {
        std::int32_t number;
        int halvings;
    };

    void search_finer(std::int32_t leaf)
    {
        if (is_settled(tree_.pieces()[leaf]))
            return;
        std::vector<Halved> open;
        open_halves(open, finer_.halves_of_leaf(tree_, leaf), 1);
        while (!open.empty()) {
            const auto [number, halvings] = open.back();
            open.pop_back();
            if (!(piece_bound(finer_.piece(number)) < least_ - resolution_))
                continue;
            if (finer_.is_full())
                search_own(finer_.piece(number).bezier, halvings);
            else
                open_halves(open, finer_.halves_of(number), halvings + 1);
        }
    }

    struct OwnPiece {
        PieceTree::Piece piece;
        int halvings;
    };

    // The same search below one piece, in the same order, which keeps no halves: a search
    // among needles, as on a steep wall, makes millions of them.
    void search_own(const BezierPiece& whole, int halvings)
    {
        std::vector<OwnPiece> open;
        open_own_halves(open, whole, halvings + 1);
        while (!open.empty()) {
            const OwnPiece next = std::move(open.back());
            open.pop_back();
            if (piece_bound(next.piece) < least_ - resolution_)
                open_own_halves(open, next.piece.bezier, next.halvings + 1);
        }
    }

    void open_own_halves(std::vector<OwnPiece>& open, const BezierPiece& whole,
                         int halvings)
    {
        if (halvings > most_halvings)
            return;
        auto [low, high] = halves(whole, whole.wider());
        const Vec3 low_middle = low.middle();
        const Vec3 high_middle = high.middle();
        const std::size_t before = open.size();
        for (BezierPiece* half : {&low, &high}) {
            const Vec3 middle = half->middle();
            PieceTree::Piece piece{std::move(*half), middle};
            if (!is_settled(piece))
                open.push_back({std::move(piece), halvings});
        }
        if (open.size() == before + 2 && core_.gap(low_middle) < core_.gap(high_middle))
            std::swap(open[before], open[before + 1]);
    }

    void open_halves(std::vector<Halved>& open, std::int32_t first, int halvings)
    {
        if (halvings > most_halvings)
            return;
        const std::size_t before = open.size();
        for (const std::int32_t half : {first, first + 1})
            if (!is_settled(finer_.piece(half)))
                open.push_back({half, halvings});
        if (open.size() == before + 2 && core_.gap(finer_.piece(first).middle) <
                                             core_.gap(finer_.piece(first + 1).middle))
            std::swap(open[before], open[before + 1]);
    }

    // Whether the piece needs no halving. Its corners are tested first.
    bool is_settled(const PieceTree::Piece& piece)
    {
        const double bound = piece_bound(piece);
        if (bound >= least_ - resolution_)
            return true;
        for (const int end_u : {0, 1})
            for (const int end_v : {0, 1}) {
                const Vec3 corner = piece.bezier.corner(end_u, end_v);
                const double gap = core_.gap(corner);
                if (gap < least_) {
                    least_ = aim_ == Aim::Any ? -infinite : gap;
                    const BezierPiece& bezier = piece.bezier;
                    found_ = SurfaceGap{gap,
                                        corner,
                                        bezier.surface,
                                        {end_u == 0 ? bezier.low.u : bezier.high.u,
                                         end_v == 0 ? bezier.low.v : bezier.high.v}};
                }
            }
        return bound >= least_ - resolution_;
    }

    const PieceTree& tree_;
    const CutterCore& core_;
    double resolution_;
    FinerPieces& finer_;
    Aim aim_;
    double least_ = 0;
    std::optional<SurfaceGap> found_;
};

}  // namespace

std::optional<SurfaceGap> surface_gap(const PieceTree& tree, const CutterCore& core,
                                      double resolution, double enough,
                                      FinerPieces& finer)
{
    finer.limit_memory();
    return GapSearch{tree, core, resolution, finer, Aim::Least}.least(enough);
}

std::optional<SurfaceGap> gap_below(const PieceTree& tree, const CutterCore& core,
                                    double resolution, double limit, FinerPieces& finer)
{
    finer.limit_memory();
    return GapSearch{tree, core, resolution, finer, Aim::Any}.least(limit);
}

}  // namespace endmill
