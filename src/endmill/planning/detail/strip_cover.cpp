// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/strip_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "endmill/core/tolerance.h"
#include "endmill/planning/detail/patch_offset.h"
#include "endmill/planning/detail/segment_distance.h"

namespace endmill {
namespace {

// Of the radius: smaller cells are not halved.
constexpr double least_cell = 1e-5;
// Of the radius: wider cells are halved at once, since no move would cover them.
constexpr double widest_cell = 1;
// In a rectangle: where it takes more, hardly anything is left between what is covered and
// what has to be.
constexpr int most_cells = 200'000;

struct Cell {
    SurfacePoint low;
    SurfacePoint high;
    std::array<Vec3, 4> corners;  // of the offset: low u first, low v first
};

// The moves of a pass, searched from the one beside a place.
class NearMoves {
public:
    explicit NearMoves(const SweptPass& pass) : pass_{pass} {}

    // The move nearest to `point` of those downhill from the one at `u`.
    std::size_t nearest(double u, const Vec3& point) const
    {
        const auto after = std::ranges::upper_bound(pass_, u, {}, &SweptSegment::from_u);
        std::size_t best = after == pass_.begin() ? 0 : after - pass_.begin() - 1;
        double least = distance(best, point);
        for (const int step : {1, -1})
            while (true) {
                const std::size_t next = best + step;  // beyond all if below 0
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

    // A place of `low` … `high`, within the rectangle, that is not known to be covered.
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
            const std::optional<bool> covered = judged(cell, middle, passes);
            if (covered && *covered)
                continue;
            if (covered || cells == most_cells)
                return middle;
            if (const auto bad = open_halves(cell, middle))
                return bad;
        }
        return std::nullopt;
    }

private:
    // Nothing where the halves are to be judged.
    std::optional<bool> judged(const Cell& cell, const SurfacePoint& middle,
                               std::span<const NearMoves> passes) const
    {
        const double widest =
            std::max(width(cell, Parameter::U), width(cell, Parameter::V));
        if (widest >= widest_cell * radius_)
            return std::nullopt;
        const std::optional<bool> covered = is_covered(cell, middle, passes);
        if (!covered && widest < least_cell * radius_)
            return false;
        return covered;
    }

    // Adds the halves of a cell; a place comes back that ends the search.
    std::optional<SurfacePoint> open_halves(const Cell& cell, const SurfacePoint& middle)
    {
        const bool across_u = width(cell, Parameter::U) >= width(cell, Parameter::V);
        const SurfacePoint first_high{across_u ? middle.u : cell.high.u,
                                      across_u ? cell.high.v : middle.v};
        const SurfacePoint second_low{across_u ? middle.u : cell.low.u,
                                      across_u ? cell.low.v : middle.v};
        if (!(first_high.u > cell.low.u) || !(first_high.v > cell.low.v))
            return middle;  // no wider than rounding
        if (const auto bad = open_cell(second_low, cell.high))
            return bad;
        return open_cell(cell.low, first_high);
    }

    // Adds a cell; a corner without a normal comes back instead.
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

    // What halving across a parameter would lessen, in mm: the mean of two sides and, where
    // they are short beside their bound as at a pole, what that makes of the stray.
    double width(const Cell& cell, Parameter across) const
    {
        const auto& c = cell.corners;
        if (across == Parameter::U)
            return ((c[1] - c[0]).norm() + (c[3] - c[2]).norm()) / 2 +
                   bends_.stray(cell.high.u - cell.low.u, 0, height_);
        return ((c[2] - c[0]).norm() + (c[3] - c[1]).norm()) / 2 +
               bends_.stray(0, cell.high.v - cell.low.v, height_);
    }

    // Nothing where one has to look closer.
    std::optional<bool> is_covered(const Cell& cell, const SurfacePoint& middle,
                                   std::span<const NearMoves> passes) const
    {
        const double stray =
            bends_.stray(cell.high.u - cell.low.u, cell.high.v - cell.low.v, height_);
        const double reach = radius_ * (1 + radius_rounding_share);
        const Vec3 mean =
            (cell.corners[0] + cell.corners[1] + cell.corners[2] + cell.corners[3]) / 4;
        double nearest = std::numeric_limits<double>::infinity();
        for (const NearMoves& pass : passes) {
            if (pass.empty())
                continue;
            const std::size_t best = pass.nearest(middle.u, mean);
            nearest = std::min(nearest, pass.distance(best, mean));
            if (nearest > reach + stray)
                continue;
            // Distance from a move is convex: greatest at a corner of the hull.
            const std::size_t first = best == 0 ? 0 : best - 1;
            for (std::size_t k = first; k < std::min(best + 2, pass.size()); ++k)
                if (std::ranges::all_of(cell.corners, [&](const Vec3& corner) {
                        return pass.distance(k, corner) + stray <= reach;
                    }))
                    return true;
        }
        if (nearest > reach) {
            const auto at_middle = offset_.at(middle.u, middle.v);
            if (!at_middle || std::ranges::all_of(passes, [&](const NearMoves& pass) {
                    return pass.empty() ||
                           pass.distance(pass.nearest(middle.u, *at_middle), *at_middle) >
                               reach;
                }))
                return false;
        }
        return std::nullopt;
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
            if (greatest + bends.stray(high - low, 0, height_) <= reach)
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
