// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/stock_engagement.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/stock/detail/removable_path.h"
#include "endmill/stock/detail/stock_patch.h"
#include "endmill/stock/detail/stock_probe.h"

// Removal and evaluation run in parallel as a pipeline of batches.
// 1. One thread (`StockReplay`) cuts the path up to the next moves of the task, in order,
//    and copies the stock around the middle of each (`MoveSnapshot`).
// 2. Meanwhile the other threads evaluate the copies of the batch before.
// A front is a grid over the quarter sphere in front of the feed, in the frame X along
// the feed, Y to the right, Z up, scaled by the radius: `rows` strips of equal width in
// y, and in each strip `columns` angles chi about the Y axis. Fronts with more stock on
// the left are mirrored.

namespace endmill {
namespace {

using std::numbers::pi;

// Azimuths at which the rim is sampled.
constexpr int rim_azimuths = 256;

// The rim is sampled at this share of the height of the highest engaged cell above the
// tip: about half a cell lower, where the border of the region decides and not its last
// cell.
constexpr double rim_share = 1 - 1.0 / 32;

// Number of moves in a batch: enough for an even load of the threads, and no more than
// fit into this memory.
constexpr double most_batch_moves = 64;
constexpr double batch_bytes = 1 << 25;

// The frame of a `BallFront` in the middle of a move.
struct Frame {
    Vec3 centre;
    double radius;
    double feed_x;  // x of the direction X
    // Component y of the direction X.
    double feed_y;
    // Angle of the move above the horizontal, rad.
    double lambda;
    std::vector<std::pair<double, double>> columns = {};  // cosine and sine of chi
};

// Adds the angles chi of the columns. They cover the quarter sphere from the horizontal
// direction of the cutter's front to the boundary of the half that faces the move.
void add_columns(Frame& frame, int count)
{
    for (int column = 0; column < count; ++column) {
        const double chi = (frame.lambda - pi / 2) * (1 - (column + 0.5) / count);
        frame.columns.emplace_back(std::cos(chi), std::sin(chi));
    }
}

// Converts a place in the frame to mm.
Vec3 place(const Frame& frame, const Vec3& at)
{
    const double x = frame.feed_x * at.x() + frame.feed_y * at.y();
    const double y = frame.feed_y * at.x() - frame.feed_x * at.y();
    return frame.centre + frame.radius * Vec3{x, y, at.z()};
}

// Returns the height of the stock above a place in mm. It is 0 or less where the place is
// free.
double stock_above(const StockPatch& stock, const Vec3& at)
{
    const auto height = interpolated_height(stock, at.x(), at.y());
    return height && *height > stock.grid().bottom_z ? *height - at.z() : -1;
}

// Sums over the engaged region: the amount on each side of the feed, in cells, and its
// highest z in radii.
struct EngagedAmount {
    double right = 0;
    double left = 0;
    double highest = -1;  // in radii
};

// Marks the engaged cells of a row.
void mark_row(const StockPatch& stock, const Frame& frame, int row, BallFront& front,
              EngagedAmount& amount)
{
    const double y = -1 + 2 * (row + 0.5) / front.rows;
    const double rho = std::sqrt(1 - y * y);
    for (int column = 0; column < front.columns; ++column) {
        const auto& [cosine, sine] = frame.columns[column];
        const Vec3 at{rho * cosine, y, rho * sine};
        if (stock_above(stock, place(frame, at)) <= 0)
            continue;
        front.engaged[static_cast<std::size_t>(row) * front.columns + column] = 1;
        (y > 0 ? amount.right : amount.left) += 1;
        amount.highest = std::max(amount.highest, at.z());
    }
}

// Stores how far the stock stands above the ball's centre along the shank.
void measure_shank(const StockPatch& stock, const Frame& frame, BallFront& front,
                   EngagedAmount& amount)
{
    for (int k = 0; k < front.columns; ++k) {
        const double azimuth = pi * (k + 0.5) / front.columns;
        const Vec3 at{std::sin(azimuth), std::cos(azimuth), 0};
        const double height = stock_above(stock, place(frame, at)) / frame.radius;
        front.shank[k] = std::max(height, 0.0);
        (at.y() > 0 ? amount.right : amount.left) += front.rows * front.shank[k];
    }
}

// Returns the angle in rad over which the rim of the engaged region extends.
double rim_angle(const StockPatch& stock, const Frame& frame, const BallFront& front,
                 double highest)
{
    const auto in_shank =
        std::ranges::count_if(front.shank, [](double height) { return height > 0; });
    if (in_shank > 0)
        return pi * static_cast<double>(in_shank) / front.columns;
    const double z = rim_share * (1 + highest) - 1;
    const double radius = std::sqrt(1 - z * z);
    int engaged = 0;
    for (int k = 0; k < rim_azimuths; ++k) {
        const double azimuth = 2 * pi * (k + 0.5) / rim_azimuths;
        const Vec3 at{radius * std::sin(azimuth), radius * std::cos(azimuth), z};
        const double ahead = at.x() * std::cos(frame.lambda) + z * std::sin(frame.lambda);
        if (ahead > 0 && stock_above(stock, place(frame, at)) > 0)
            ++engaged;
    }
    return 2 * pi * engaged / rim_azimuths;
}

// Exchanges left and right.
void mirror(BallFront& front)
{
    front.stock_side =
        front.stock_side == FeedSide::Right ? FeedSide::Left : FeedSide::Right;
    std::ranges::reverse(front.shank);
    for (int row = 0; row < front.rows / 2; ++row)
        std::swap_ranges(front.engaged.begin() + row * front.columns,
                         front.engaged.begin() + (row + 1) * front.columns,
                         front.engaged.end() - (row + 1) * front.columns);
}

// A move and a copy of the stock around its middle, before the move.
struct MoveSnapshot {
    std::size_t number;
    Vec3 from;
    Vec3 to;
    StockPatch patch;

    Vec3 middle() const { return (from + to) / 2; }
};

// Evaluates the front of a move.
BallFront front_on(const MoveSnapshot& found, const BallFrontTask& task)
{
    const double radius = task.cutter.radius();
    BallFront front{.rows = task.rows, .columns = task.columns};
    front.engaged.resize(static_cast<std::size_t>(front.rows) * front.columns);
    front.shank.resize(front.columns);
    const Vec3 way = found.to - found.from;
    const double level = std::hypot(way.x(), way.y());
    if (level == 0)
        return front;
    front.lambda = std::atan2(way.z(), level);
    Frame frame{found.middle() + radius * Vec3::UnitZ(), radius, way.x() / level,
                way.y() / level, front.lambda};
    add_columns(frame, front.columns);
    EngagedAmount amount;
    for (int row = 0; row < front.rows; ++row)
        mark_row(found.patch, frame, row, front, amount);
    measure_shank(found.patch, frame, front, amount);
    if (amount.right + amount.left > 0)
        front.rim_angle = rim_angle(found.patch, frame, front, amount.highest);
    if (amount.left > amount.right)
        mirror(front);
    return front;
}

// Cuts along the path and copies the stock before the moves of the task.
class StockReplay {
public:
    StockReplay(HeightStock& stock, const BallFrontTask& task)
        : stock_{stock},
          task_{task},
          most_{static_cast<std::size_t>(std::clamp(
              batch_bytes / StockPatch::bytes(stock.grid(), task.cutter.radius()), 1.0,
              most_batch_moves))}
    {
    }

    // Copies the stock for the next batch of moves. After the last move the batch is
    // empty and the whole path is cut.
    void next_batch(std::vector<MoveSnapshot>& batch)
    {
        const std::vector<PathPoint>& points = task_.path->points;
        batch.resize(std::min(most_, task_.points.size() - done_));
        for (MoveSnapshot& found : batch) {
            cut_up_to(task_.points[done_]);
            found.number = done_++;
            found.from = points[reached_ - 1].location.tip;
            found.to = points[reached_].location.tip;
            found.patch.copy(stock_, found.middle(), task_.cutter.radius());
        }
        if (batch.empty())
            cut_up_to(points.size());
    }

private:
    // Removes all moves before the one to point `end`.
    void cut_up_to(std::size_t end)
    {
        const std::vector<PathPoint>& points = task_.path->points;
        for (; reached_ < end; ++reached_) {
            const Vec3& to = points[reached_].location.tip;
            if (reached_ > 0)
                remove_swept(stock_, task_.cutter,
                             swept_move(points[reached_ - 1].location.tip, to));
            else if (cuts_at_start(*task_.path))
                remove_swept(stock_, task_.cutter, swept_move(to, to));
        }
    }

    HeightStock& stock_;
    const BallFrontTask& task_;
    std::size_t most_;         // moves per batch
    std::size_t done_ = 0;     // number of the task's points that are done
    std::size_t reached_ = 0;  // number of the path's points that are cut
};

// Checks the task.
void require_sound(const BallFrontTask& task)
{
    require(task.path != nullptr && task.cutter.is_ball(),
            "for_each_ball_front: need a path and a ball");
    require(task.rows >= 2 && task.rows % 2 == 0 && task.columns >= 1,
            "for_each_ball_front: need even rows and a column");
    require(std::ranges::is_sorted(task.points, std::less_equal<>{}) &&
                (task.points.empty() || (task.points.front() > 0 &&
                                         task.points.back() < task.path->points.size())),
            "for_each_ball_front: need rising points of the path, after its first");
    require_removable(*task.path);
}

// Distance of a number from an interval; 0 inside.
double beyond(double at, double low, double high)
{
    return std::max({low - at, at - high, 0.0});
}

// Distance between the block and the part of the cutter's axis above the ball's centre.
double axis_distance(const Vec3& centre, const Block& block)
{
    return std::hypot(beyond(centre.x(), block.low.x(), block.high.x()),
                      beyond(centre.y(), block.low.y(), block.high.y()),
                      std::max(centre.z() - block.high.z(), 0.0));
}

// Returns the least distance along a move. The distance is a convex function of the
// position, so ternary search converges to its minimum.
double least_axis_distance(const Vec3& from, const Vec3& to, const Block& block)
{
    constexpr int steps = 40;  // (2/3)^40 < 1e-7
    double low = 0;
    double high = 1;
    const auto at = [&](double share) {
        return axis_distance(from + share * (to - from), block);
    };
    for (int k = 0; k < steps; ++k) {
        const double left = low + (high - low) / 3;
        const double right = high - (high - low) / 3;
        if (at(left) <= at(right))
            high = right;
        else
            low = left;
    }
    return std::min({at(0), at((low + high) / 2), at(1)});
}

}  // namespace

void for_each_ball_front(
    HeightStock& stock, const BallFrontTask& task,
    const std::function<void(std::size_t number, const BallFront& front)>& visit)
{
    require_sound(task);
    StockReplay replay{stock, task};
    std::vector<MoveSnapshot> batch;
    std::vector<MoveSnapshot> next;
    replay.next_batch(batch);
    while (!batch.empty()) {
        // Removal of the next batch and evaluation of this one run at the same time. The
        // removal is one task of the loop, because its moves must stay in order.
        parallel_for(batch.size() + 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                if (i == 0)
                    replay.next_batch(next);
                else
                    visit(batch[i - 1].number, front_on(batch[i - 1], task));
            }
        });
        if (task.progress)
            task.progress(static_cast<double>(batch.back().number + 1) /
                          static_cast<double>(task.points.size()));
        std::swap(batch, next);
    }
}

double stock_gap(const ToolPath& path, std::span<const std::size_t> points,
                 const Cutter& cutter, const Block& block)
{
    require(cutter.is_ball(), "stock_gap: need a ball-end mill");
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t point : points) {
        require(point > 0 && point < path.points.size(),
                "stock_gap: need points of the path after its first");
        const Vec3 up = cutter.radius() * Vec3::UnitZ();
        least = std::min(
            least, least_axis_distance(path.points[point - 1].location.tip + up,
                                       path.points[point].location.tip + up, block));
    }
    return std::max(least - cutter.radius(), 0.0);
}

}  // namespace endmill
