// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/stock_fronts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/stock/detail/removable_path.h"
#include "endmill/stock/detail/stock_patch.h"
#include "endmill/stock/detail/stock_probe.h"

namespace endmill {
namespace {

using std::numbers::pi;

constexpr int rim_azimuths = 256;

// Of the height of the highest engaged cell above the tip: below it by half a cell or so, the
// ring is engaged as its border says and not as its last cell does.
constexpr double rim_share = 1 - 1.0 / 32;

// Moves that are looked at side by side: enough that the threads part evenly, and no more than
// fit into this memory.
constexpr double most_batch_moves = 64;
constexpr double batch_bytes = 1 << 25;

// The frame of a BallFront in the middle of a move, Y to the right.
struct Frame {
    Vec3 centre;
    double radius;
    double feed_x;  // of X
    double feed_y;
    double lambda;
    std::vector<std::pair<double, double>> columns = {};  // cosine and sine of chi
};

void add_columns(Frame& frame, int count)
{
    for (int column = 0; column < count; ++column) {
        const double chi = (frame.lambda - pi / 2) * (1 - (column + 0.5) / count);
        frame.columns.emplace_back(std::cos(chi), std::sin(chi));
    }
}

Vec3 place(const Frame& frame, const Vec3& at)
{
    const double x = frame.feed_x * at.x() + frame.feed_y * at.y();
    const double y = frame.feed_y * at.x() - frame.feed_x * at.y();
    return frame.centre + frame.radius * Vec3{x, y, at.z()};
}

// How far the stock goes above a place, in mm; not above 0: it is free.
double covered(const StockPatch& stock, const Vec3& at)
{
    const auto height = height_under(stock, at.x(), at.y());
    return height && *height > stock.grid().bottom_z ? *height - at.z() : -1;
}

// What the cells and the shank's azimuths hold, by the side of the feed.
struct Look {
    double right = 0;
    double left = 0;
    double highest = -1;  // z of the highest engaged cell, in radii
};

void look_at_row(const StockPatch& stock, const Frame& frame, int row, BallFront& front,
                 Look& look)
{
    const double y = -1 + 2 * (row + 0.5) / front.rows;
    const double rho = std::sqrt(1 - y * y);
    for (int column = 0; column < front.columns; ++column) {
        const auto& [cosine, sine] = frame.columns[column];
        const Vec3 at{rho * cosine, y, rho * sine};
        if (covered(stock, place(frame, at)) <= 0)
            continue;
        front.engaged[static_cast<std::size_t>(row) * front.columns + column] = 1;
        (y > 0 ? look.right : look.left) += 1;
        look.highest = std::max(look.highest, at.z());
    }
}

void look_at_shank(const StockPatch& stock, const Frame& frame, BallFront& front,
                   Look& look)
{
    for (int k = 0; k < front.columns; ++k) {
        const double azimuth = pi * (k + 0.5) / front.columns;
        const Vec3 at{std::sin(azimuth), std::cos(azimuth), 0};
        const double height = covered(stock, place(frame, at)) / frame.radius;
        front.shank[k] = std::max(height, 0.0);
        (at.y() > 0 ? look.right : look.left) += front.rows * front.shank[k];
    }
}

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
        if (ahead > 0 && covered(stock, place(frame, at)) > 0)
            ++engaged;
    }
    return 2 * pi * engaged / rim_azimuths;
}

void mirror(BallFront& front)
{
    front.is_stock_right = !front.is_stock_right;
    std::ranges::reverse(front.shank);
    for (int row = 0; row < front.rows / 2; ++row)
        std::swap_ranges(front.engaged.begin() + row * front.columns,
                         front.engaged.begin() + (row + 1) * front.columns,
                         front.engaged.end() - (row + 1) * front.columns);
}

// A move, and the stock around its middle as it finds it.
struct FoundStock {
    std::size_t number;
    Vec3 from;
    Vec3 to;
    StockPatch patch;

    Vec3 middle() const { return (from + to) / 2; }
};

BallFront front_on(const FoundStock& found, const BallFrontTask& task)
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
    Look look;
    for (int row = 0; row < front.rows; ++row)
        look_at_row(found.patch, frame, row, front, look);
    look_at_shank(found.patch, frame, front, look);
    if (look.right + look.left > 0)
        front.rim_angle = rim_angle(found.patch, frame, front, look.highest);
    if (look.left > look.right)
        mirror(front);
    return front;
}

// Cuts along the path, and keeps what the moves find.
class StockWalk {
public:
    StockWalk(HeightStock& stock, const BallFrontTask& task)
        : stock_{stock},
          task_{task},
          most_{static_cast<std::size_t>(std::clamp(
              batch_bytes / StockPatch::bytes(stock.grid(), task.cutter.radius()), 1.0,
              most_batch_moves))}
    {
    }

    // What the next moves to be looked at find; none after the last, and all is cut.
    void go_on(std::vector<FoundStock>& batch)
    {
        const std::vector<PathPoint>& points = task_.path->points;
        batch.resize(std::min(most_, task_.points.size() - looked_at_));
        for (FoundStock& found : batch) {
            cut_up_to(task_.points[looked_at_]);
            found.number = looked_at_++;
            found.from = points[reached_ - 1].location.tip;
            found.to = points[reached_].location.tip;
            found.patch.copy(stock_, found.middle(), task_.cutter.radius());
        }
        if (batch.empty())
            cut_up_to(points.size());
    }

private:
    // All moves before the one to a point.
    void cut_up_to(std::size_t end)
    {
        const std::vector<PathPoint>& points = task_.path->points;
        for (; reached_ < end; ++reached_) {
            const Vec3& to = points[reached_].location.tip;
            if (reached_ > 0)
                take_swept(stock_, task_.cutter,
                           swept_move(points[reached_ - 1].location.tip, to));
            else if (cuts_at_start(*task_.path))
                take_swept(stock_, task_.cutter, swept_move(to, to));
        }
    }

    HeightStock& stock_;
    const BallFrontTask& task_;
    std::size_t most_;           // moves of a batch
    std::size_t looked_at_ = 0;  // of the task's points
    std::size_t reached_ = 0;    // of the path's points
};

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

}  // namespace

void for_each_ball_front(
    HeightStock& stock, const BallFrontTask& task,
    const std::function<void(std::size_t number, const BallFront& front)>& visit)
{
    require_sound(task);
    StockWalk walk{stock, task};
    std::vector<FoundStock> batch;
    std::vector<FoundStock> next;
    walk.go_on(batch);
    while (!batch.empty()) {
        // The removal goes ahead while the fronts are looked at: its moves are in order, and
        // wait for each other.
        parallel_for(batch.size() + 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                if (i == 0)
                    walk.go_on(next);
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

}  // namespace endmill
