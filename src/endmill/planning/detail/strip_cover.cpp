// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/strip_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "endmill/core/answer.h"
#include "endmill/core/tolerance.h"
#include "endmill/planning/detail/patch_offset.h"
#include "endmill/planning/detail/segment_distance.h"

// A cell is a rectangle of parameters within one rectangle of the bounds. It is covered
// if all of its raised points r + h N lie within R of the centres of one move.
// 1. The distance from a straight move is a convex function. On the bilinear patch
//    through the raised corners of a cell it is therefore greatest at a corner.
// 2. The raised surface deviates from that patch by at most the deviation d of
//    OffsetBends. If all corners of the cell lie within R - d of one move, the cell is
//    covered.
// 3. If the raised middle of the cell lies further than R from all moves nearby, the cell
//    is not covered, and its middle is the answer.
// 4. Otherwise the cell is halved across its wider side. Cells wider than R are halved at
//    once. A cell that becomes smaller than 1e-5 R counts as not covered.

namespace endmill {
namespace {

// Width, as a share of the radius, below which cells are not halved.
constexpr double least_cell = 1e-5;
// Width, as a share of the radius, from which cells are halved without a test, because
// hardly any move covers them.
constexpr double widest_cell = 1;
// Most cells in one rectangle of the bounds. More are needed only if the distance is so
// close to R over a large region that the bounds cannot decide.
constexpr int most_cells = 200'000;

// A rectangle of parameters.
struct Cell {
    SurfacePoint low;
    SurfacePoint high;
    // Of the offset, in the order (low u, low v), (high u, low v), (low u, high v), (high
    // u, high v).
    std::array<Vec3, 4> corners;
};

// Finds the nearest move of a pass by descent from the move at a parameter.
class NearMoves {
public:
    explicit NearMoves(const SweptPass& pass) : pass_{pass} {}

    // Number of the move to which the descent from the move at `u` leads: a local minimum
    // of the distance from `point`.
    std::size_t nearest(double u, const Vec3& point) const
    {
        const auto after = std::ranges::upper_bound(pass_, u, {}, &SweptSegment::from_u);
        std::size_t best = after == pass_.begin() ? 0 : after - pass_.begin() - 1;
        double least = distance(best, point);
        for (const int step : {1, -1})
            while (true) {
                const std::size_t next = best + step;  // wraps to a huge number below 0
                if (next >= pass_.size() || distance(next, point) >= least)
                    break;
                best = next;
                least = distance(best, point);
            }
        return best;
    }

    double distance(std::size_t number, const Vec3& point) const
    {
        return segment_distance(point, pass_[number].start, pass_[number].end);
    }

    bool empty() const { return pass_.empty(); }
    std::size_t size() const { return pass_.size(); }

private:
    const SweptPass& pass_;
};

// The search in one rectangle of the bounds.
class StripSearch {
public:
    StripSearch(const MarchedSurface& marched, const OffsetBends& bends, double height,
                double radius)
        : offset_{marched,
                  {(bends.low.u + bends.high.u) / 2, (bends.low.v + bends.high.v) / 2},
                  height},
          bends_{bends},
          height_{height},
          radius_{radius}
    {
    }

    // Searches the cell from `low` to `high` for a place that is not proved to be
    // covered.
    std::optional<SurfacePoint> find(const SurfacePoint& low, const SurfacePoint& high,
                                     std::span<const NearMoves> passes)
    {
        open_.clear();
        if (const auto bad = open_cell(low, high))
            return bad;
        for (int cells = 0; !open_.empty(); ++cells) {
            const Cell cell = open_.back();
            open_.pop_back();
            const SurfacePoint middle{(cell.low.u + cell.high.u) / 2,
                                      (cell.low.v + cell.high.v) / 2};
            const Answer covered = judged(cell, middle, passes);
            if (covered == Answer::Yes)
                continue;
            if (covered == Answer::No || cells == most_cells)
                return middle;
            if (const auto bad = open_halves(cell, middle))
                return bad;
        }
        return std::nullopt;
    }

private:
    // Whether the cell is covered. Undecided means that its halves are to be judged.
    Answer judged(const Cell& cell, const SurfacePoint& middle,
                  std::span<const NearMoves> passes) const
    {
        const double widest =
            std::max(width(cell, Parameter::U), width(cell, Parameter::V));
        if (widest >= widest_cell * radius_)
            return Answer::Undecided;
        const Answer covered = is_covered(cell, middle, passes);
        if (covered == Answer::Undecided && widest < least_cell * radius_)
            return Answer::No;
        return covered;
    }

    // Adds the halves of a cell. Returns a place that ends the search, if there is one.
    std::optional<SurfacePoint> open_halves(const Cell& cell, const SurfacePoint& middle)
    {
        const bool across_u = width(cell, Parameter::U) >= width(cell, Parameter::V);
        const SurfacePoint first_high{across_u ? middle.u : cell.high.u,
                                      across_u ? cell.high.v : middle.v};
        const SurfacePoint second_low{across_u ? middle.u : cell.low.u,
                                      across_u ? cell.low.v : middle.v};
        if (!(first_high.u > cell.low.u) || !(first_high.v > cell.low.v))
            return middle;  // the cell is as narrow as rounding
        if (const auto bad = open_cell(second_low, cell.high))
            return bad;
        return open_cell(cell.low, first_high);
    }

    // Adds a cell, or returns a corner of it that has no normal.
    std::optional<SurfacePoint> open_cell(const SurfacePoint& low,
                                          const SurfacePoint& high)
    {
        Cell cell{low, high, {}};
        for (int k = 0; k < 4; ++k) {
            const SurfacePoint at{k % 2 == 0 ? low.u : high.u, k < 2 ? low.v : high.v};
            const auto corner = offset_.at(at.u, at.v);
            if (!corner)
                return at;
            cell.corners[k] = *corner;
        }
        open_.push_back(cell);
        return std::nullopt;
    }

    // The width in mm that halving across a parameter would reduce: the mean length of
    // two opposite sides, plus the deviation along them. The latter dominates at a pole,
    // where the sides are short.
    double width(const Cell& cell, Parameter across) const
    {
        const auto& c = cell.corners;
        if (across == Parameter::U)
            return ((c[1] - c[0]).norm() + (c[3] - c[2]).norm()) / 2 +
                   bends_.deviation(cell.high.u - cell.low.u, 0, height_);
        return ((c[2] - c[0]).norm() + (c[3] - c[1]).norm()) / 2 +
               bends_.deviation(0, cell.high.v - cell.low.v, height_);
    }

    // The test of a cell by its corners, then by its middle; see the steps 2 and 3 above.
    Answer is_covered(const Cell& cell, const SurfacePoint& middle,
                      std::span<const NearMoves> passes) const
    {
        const double deviation =
            bends_.deviation(cell.high.u - cell.low.u, cell.high.v - cell.low.v, height_);
        const double reach = radius_ * (1 + radius_rounding_share);
        const Vec3 mean =
            (cell.corners[0] + cell.corners[1] + cell.corners[2] + cell.corners[3]) / 4;
        double nearest = std::numeric_limits<double>::infinity();
        for (const NearMoves& pass : passes) {
            if (pass.empty())
                continue;
            const std::size_t best = pass.nearest(middle.u, mean);
            nearest = std::min(nearest, pass.distance(best, mean));
            if (nearest > reach + deviation)
                continue;
            // The nearest move and its neighbours; each has to cover the cell alone.
            const std::size_t first = best == 0 ? 0 : best - 1;
            for (std::size_t k = first; k < std::min(best + 2, pass.size()); ++k)
                if (std::ranges::all_of(cell.corners, [&](const Vec3& corner) {
                        return pass.distance(k, corner) + deviation <= reach;
                    }))
                    return Answer::Yes;
        }
        if (nearest > reach) {
            const auto at_middle = offset_.at(middle.u, middle.v);
            if (!at_middle || std::ranges::all_of(passes, [&](const NearMoves& pass) {
                    return pass.empty() ||
                           pass.distance(pass.nearest(middle.u, *at_middle), *at_middle) >
                               reach;
                }))
                return Answer::No;
        }
        return Answer::Undecided;
    }

    PatchOffset offset_;
    const OffsetBends& bends_;
    double height_;
    double radius_;
    std::vector<Cell> open_;
};

}  // namespace

StripCover::StripCover(const MarchedSurface& marched, const OffsetBounds& bounds,
                       const BallCutter& cutter, double height)
    : marched_{&marched},
      bounds_{&bounds},
      radius_{cutter.radius()},
      height_{std::min(height, cutter.radius())}
{
}

std::optional<SurfacePoint> StripCover::find_uncovered(Interval v, const SweptPass& below,
                                                       const SweptPass& above) const
{
    const std::array passes{NearMoves{below}, NearMoves{above}};
    for (const OffsetBends& bends : bounds_->across(v)) {
        StripSearch search{*marched_, bends, height_, radius_};
        const SurfacePoint low{bends.low.u, std::max(bends.low.v, v.low)};
        const SurfacePoint high{bends.high.u, std::min(bends.high.v, v.high)};
        if (const auto found = search.find(low, high, passes))
            return found;
    }
    return std::nullopt;
}

// Halves the line beside the move, as find_uncovered halves cells, until the bounds prove
// that it is covered. The line is first divided at the borders of the rectangles of the
// bounds.
bool StripCover::covers_line(const SweptSegment& move, double v) const
{
    struct Part {
        double low;
        double high;
    };
    const double reach = radius_ * (1 + radius_rounding_share);
    const double least_width = least_cell * (move.to_u - move.from_u);
    double from = move.from_u;
    while (from < move.to_u) {
        const OffsetBends& bends = bounds_->at(from, v);
        const double to = std::min(move.to_u, bends.high.u);
        const PatchOffset offset{*marched_, {(from + to) / 2, v}, height_};
        const auto distance = [&](double u) {
            const auto point = offset.at(u, v);
            return point ? segment_distance(*point, move.start, move.end)
                         : std::numeric_limits<double>::infinity();
        };
        std::vector<Part> open{{from, to}};
        while (!open.empty()) {
            const auto [low, high] = open.back();
            open.pop_back();
            const double greatest = std::max(distance(low), distance(high));
            if (greatest > reach)
                return false;
            if (greatest + bends.deviation(high - low, 0, height_) <= reach)
                continue;
            if (high - low < least_width)
                return false;
            const double middle = (low + high) / 2;
            open.push_back({middle, high});
            open.push_back({low, middle});
        }
        if (!(to > from))
            return false;
        from = to;
    }
    return true;
}

}  // namespace endmill
