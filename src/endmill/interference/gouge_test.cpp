// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/gouge_test.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// Of the tolerance: what is nearer to it than that stays undecided.
constexpr double undecided_share = 1e-3;
constexpr double pieces_per_radius = 4;
// Halvings of a piece: 2^-40 of it is far below any resolution that rounding allows.
constexpr int most_halvings = 80;

struct HalvedPiece {
    BezierPiece piece;
    int halvings;
};

// The search for points of the part that are nearer than `reach_` to the strip.
class NearSearch {
public:
    NearSearch(const PieceTree& tree, const CentreStrip& strip, double radius)
        : tree_{tree},
          strip_{strip},
          radius_{radius}
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
                search_piece(tree_.pieces()[~node.link]);
                continue;
            }
            // The nearer child first: what it holds may settle the other.
            const std::int32_t first = node.link;
            const auto square = [&](std::int32_t child) {
                const Vec3 middle = tree_.nodes()[child].box.center();
                return (middle - strip_.nearest(middle)).squaredNorm();
            };
            const bool swap = square(first + 1) < square(first);
            open.push_back(swap ? first : first + 1);
            open.push_back(swap ? first + 1 : first);
        }
    }

    bool is_over() const { return stops_at_first_ && (found_ || undecided_); }

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
    double piece_bound(const BezierPiece& piece, const std::array<Vec3, 4>& corners) const
    {
        const Vec3 middle = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
        const Vec3 nearest = strip_.nearest(middle);
        const Vec3 away = middle - nearest;
        const double distance = away.norm();
        if (distance == 0)
            return 0;
        return piece.least_height(away / distance, nearest);
    }

    void search_piece(const BezierPiece& whole)
    {
        if (is_settled(whole, 0))
            return;
        std::vector<HalvedPiece> open{{whole, 0}};
        while (!open.empty() && !is_over()) {
            const HalvedPiece next = std::move(open.back());
            open.pop_back();
            auto [low, high] = halves(next.piece, next.piece.wider());
            for (BezierPiece* half : {&high, &low})
                if (!is_settled(*half, next.halvings + 1))
                    open.push_back({std::move(*half), next.halvings + 1});
        }
    }

    // Whether nothing of interest is in the piece, but for what it has just told.
    bool is_settled(const BezierPiece& piece, int halvings)
    {
        const std::array corners{piece.corner(0, 0), piece.corner(1, 0),
                                 piece.corner(0, 1), piece.corner(1, 1)};
        const double bound = piece_bound(piece, corners);
        if (bound >= limit())
            return true;
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
            if (stops_at_first_)
                undecided_ = place;
            return true;
        }
        return false;
    }

    const PieceTree& tree_;
    const CentreStrip& strip_;
    double radius_;
    double reach_ = 0;
    double resolution_ = 0;
    bool stops_at_first_ = false;
    std::optional<GougePlace> found_;
    std::optional<GougePlace> undecided_;
};

}  // namespace

GougeTest::GougeTest(std::span<const Surface> surfaces, const BallCutter& cutter,
                     const Vec3& axis)
    : cutter_{cutter},
      axis_{axis},
      tree_{surfaces, cutter.radius() / pieces_per_radius}
{
}

GougeAnswer GougeTest::test(const BallMove& move, double tolerance) const
{
    require(0 < tolerance && tolerance < cutter_.radius(),
            "GougeTest: need 0 < tolerance < cutter radius");
    const CentreStrip strip{move, axis_};
    return NearSearch{tree_, strip, cutter_.radius()}.test(tolerance);
}

std::optional<GougePlace> GougeTest::deepest(const BallMove& move,
                                             double resolution) const
{
    require(resolution > 0, "GougeTest: need 0 < resolution");
    const CentreStrip strip{move, axis_};
    return NearSearch{tree_, strip, cutter_.radius()}.deepest(resolution);
}

}  // namespace endmill
