// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/gouge/gouge_test.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// Of the tolerance: what is nearer to it than that stays undecided.
constexpr double undecided_share = 1e-3;
constexpr double pieces_per_radius = 2;
// Halvings of a piece: 2^-40 of it is far below any resolution that rounding allows.
constexpr int most_halvings = 80;
constexpr std::size_t most_finer_pieces = 30'000;

// The search for points of the part that are nearer than `reach_` to the strip.
class NearSearch {
public:
    NearSearch(const PieceTree& tree, const CentreStrip& strip, double radius,
               FinerPieces& finer)
        : tree_{tree},
          strip_{strip},
          radius_{radius},
          finer_{finer}
    {
    }

    GougeAnswer test(double tolerance)
    {
        reach_ = radius_ - tolerance;
        resolution_ = undecided_share * tolerance;
        stops_at_first_ = true;
        run();
        if (found_)
            return {GougeVerdict::Gouges, found_};
        if (undecided_)
            return {GougeVerdict::Undecided, undecided_};
        return {GougeVerdict::Clear, std::nullopt};
    }

    std::optional<GougePlace> deepest(double resolution)
    {
        reach_ = radius_;
        resolution_ = resolution;
        run();
        return found_;
    }

private:
    void run()
    {
        std::vector<std::int32_t> open{0};
        while (!open.empty() && !is_over()) {
            const PieceTree::Node& node = tree_.nodes()[open.back()];
            open.pop_back();
            if (box_bound(node.box) >= limit())
                continue;
            if (node.link < 0) {
                search_pieces(~node.link);
                continue;
            }
            push_nearer_last(open, node.link, [&](std::int32_t child) {
                return tree_.nodes()[child].box.center();
            });
        }
    }

    // A patch and what it is halved into.
    void search_pieces(std::int32_t patch)
    {
        std::vector<std::int32_t> open{patch};
        while (!open.empty() && !is_over()) {
            const std::int32_t number = open.back();
            const PieceTree::Piece& piece = tree_.pieces()[number];
            open.pop_back();
            if (piece.halves == 0)
                search_finer(number);
            else if (piece_bound(piece.bezier, piece.middle) < limit())
                push_nearer_last(open, piece.halves, [&](std::int32_t half) {
                    return tree_.pieces()[half].middle;
                });
        }
    }

    // What the nearer of two holds may settle the other.
    template <class Middle>
    void push_nearer_last(std::vector<std::int32_t>& open, std::int32_t first,
                          const Middle& middle) const
    {
        const auto square = [&](std::int32_t number) {
            const Vec3 point = middle(number);
            return (point - strip_.nearest(point)).squaredNorm();
        };
        const bool swap = square(first + 1) < square(first);
        open.push_back(swap ? first : first + 1);
        open.push_back(swap ? first + 1 : first);
    }

    bool is_over() const { return stops_at_first_ && found_; }

    // What is no nearer than that is of no interest.
    double limit() const { return found_ ? reach_ - resolution_ : reach_; }

    double box_bound(const Eigen::AlignedBox3d& box) const
    {
        const Vec3 middle = box.center();
        const Vec3 nearest = strip_.nearest(middle);
        const Vec3 away = middle - nearest;
        const double distance = away.norm();
        if (distance == 0)
            return 0;
        return distance - away.cwiseAbs().dot(box.sizes()) / (2 * distance);
    }

    // A bound by the plane at the strip's point nearest to the piece's middle.
    double piece_bound(const BezierPiece& piece, const Vec3& middle) const
    {
        const Vec3 nearest = strip_.nearest(middle);
        const Vec3 away = middle - nearest;
        const double distance = away.norm();
        if (distance == 0)
            return 0;
        return piece.least_height(away / distance, nearest);
    }

    void search_finer(std::int32_t leaf)
    {
        if (is_settled(tree_.pieces()[leaf], 0))
            return;
        struct Halved {
            std::int32_t number;
            int halvings;
        };
        std::vector<Halved> open;
        const auto open_halves = [&](std::int32_t first, int halvings) {
            for (const std::int32_t half : {first + 1, first})
                if (!is_over() && !is_settled(finer_.piece(half), halvings))
                    open.push_back({half, halvings});
        };
        open_halves(finer_.halves_of_leaf(tree_, leaf), 1);
        while (!open.empty() && !is_over()) {
            const auto [number, halvings] = open.back();
            open.pop_back();
            open_halves(finer_.halves_of(number), halvings + 1);
        }
    }

    // Whether nothing of interest is in the piece, but for what it has just told.
    bool is_settled(const PieceTree::Piece& whole, int halvings)
    {
        const BezierPiece& piece = whole.bezier;
        const double bound = piece_bound(piece, whole.middle);
        if (bound >= limit())
            return true;
        const std::array corners{piece.corner(0, 0), piece.corner(1, 0),
                                 piece.corner(0, 1), piece.corner(1, 1)};
        double nearest = std::numeric_limits<double>::infinity();
        std::size_t nearest_corner = 0;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const double distance = (corners[k] - strip_.nearest(corners[k])).norm();
            if (distance < nearest) {
                nearest = distance;
                nearest_corner = k;
            }
        }
        const GougePlace place{piece.surface,
                               {nearest_corner % 2 == 0 ? piece.low.u : piece.high.u,
                                nearest_corner < 2 ? piece.low.v : piece.high.v},
                               corners[nearest_corner],
                               radius_ - nearest};
        if (nearest < reach_) {
            found_ = place;
            if (stops_at_first_)
                return true;
            reach_ = nearest;
        }
        if (bound >= limit())
            return true;
        if (nearest - bound < resolution_ || halvings == most_halvings) {
            if (stops_at_first_ && !undecided_)
                undecided_ = place;
            return true;
        }
        return false;
    }

    const PieceTree& tree_;
    const CentreStrip& strip_;
    double radius_;
    FinerPieces& finer_;
    double reach_ = 0;
    double resolution_ = 0;
    bool stops_at_first_ = false;
    std::optional<GougePlace> found_;
    std::optional<GougePlace> undecided_;
};

}  // namespace

std::int32_t FinerPieces::halves_of_leaf(const PieceTree& tree, std::int32_t leaf)
{
    const auto [place, is_new] = of_leaves_.try_emplace(leaf, 0);
    if (is_new)
        place->second = add_halves(tree.pieces()[leaf].bezier);
    return place->second;
}

std::int32_t FinerPieces::halves_of(std::int32_t number)
{
    PieceTree::Piece& piece = pieces_[number];
    if (piece.halves == 0)
        piece.halves = add_halves(piece.bezier);
    return piece.halves;
}

std::int32_t FinerPieces::add_halves(const BezierPiece& whole)
{
    const auto first = static_cast<std::int32_t>(pieces_.size());
    auto [low, high] = halves(whole, whole.wider());
    for (BezierPiece* half : {&low, &high}) {
        const Vec3 middle = half->middle();
        pieces_.push_back({std::move(*half), middle});
    }
    return first;
}

void FinerPieces::limit_memory()
{
    if (pieces_.size() < most_finer_pieces)
        return;
    of_leaves_.clear();
    pieces_.resize(1);
}

GougeTest::GougeTest(std::span<const Surface> surfaces, const BallCutter& cutter,
                     const Vec3& axis)
    : cutter_{cutter},
      axis_{axis},
      tree_{surfaces, cutter.radius() / pieces_per_radius}
{
}

GougeAnswer GougeTest::test(const BallMove& move, double tolerance) const
{
    FinerPieces finer;
    return test(move, tolerance, finer);
}

GougeAnswer GougeTest::test(const BallMove& move, double tolerance,
                            FinerPieces& finer) const
{
    require(0 < tolerance && tolerance < cutter_.radius(),
            "GougeTest: need 0 < tolerance < cutter radius");
    const CentreStrip strip{move, axis_};
    finer.limit_memory();
    return NearSearch{tree_, strip, cutter_.radius(), finer}.test(tolerance);
}

std::optional<GougePlace> GougeTest::deepest(const BallMove& move,
                                             double resolution) const
{
    require(resolution > 0, "GougeTest: need 0 < resolution");
    const CentreStrip strip{move, axis_};
    FinerPieces finer;
    return NearSearch{tree_, strip, cutter_.radius(), finer}.deepest(resolution);
}

}  // namespace endmill
