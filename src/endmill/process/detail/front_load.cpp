// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/front_load.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "endmill/core/error.h"
#include "endmill/core/vec.h"

// A front states which cells of the ball's front are in the stock, and how high the stock
// reaches along the shank. Everything here is a midpoint rule over these data:
// - `front_coefficients` sums over the cells, which have equal areas, and over the
//   azimuths of the shank.
// - FrontPattern follows each helical edge upwards in small steps of height, at 180
//   azimuths within the period of the flutes, and adds the steps whose cell is engaged.

namespace endmill {
namespace {

using std::numbers::pi;

// Number of azimuths within the period of the flutes, and of height steps per radius of
// the ball. Both are finer than the cells of a front, whose width limits the accuracy of
// the sums.
constexpr int turns = 180;
constexpr int edge_steps = 64;

// A point of the ball or the shank. Lengths are in radii of the ball.
struct Place {
    double sine;       // sine of the azimuth from Y
    double cosine;     // cosine of the azimuth from Y
    double radius;     // distance from the axis
    double thickness;  // chip thickness over the feed per tooth, for an element of height
};

// The point of the ball at `at`. The exact thickness is the component of the feed normal
// to the ball.
Place ball_place(const Vec3& at, const BallFront& front, ChipModel chip)
{
    const double radius = std::hypot(at.x(), at.y());
    const double sine = at.x() / radius;
    const double ahead =
        at.x() * std::cos(front.lambda) + at.z() * std::sin(front.lambda);
    return {sine, at.y() / radius, radius,
            chip == ChipModel::Exact ? ahead / radius : std::abs(sine)};
}

// The point of the shank at an azimuth.
Place shank_place(double azimuth, const BallFront& front, ChipModel chip)
{
    const double sine = std::sin(azimuth);
    return {sine, std::cos(azimuth), 1,
            chip == ChipModel::Exact ? std::cos(front.lambda) * sine : std::abs(sine)};
}

// Adds an element to I1 to I8. The chip terms have the factor thickness, the edge terms
// 1.
void add(CuttingCoefficients& sum, const Place& at, double weight)
{
    sum.I1 += weight * at.thickness * at.cosine;
    sum.I2 += weight * at.thickness * at.sine;
    sum.I3 += weight * at.cosine;
    sum.I4 += weight * at.sine;
    sum.I5 += weight * at.thickness;
    sum.I6 += weight;
    sum.I7 += weight * at.thickness * at.radius;
    sum.I8 += weight * at.radius;
}

// Middle of a cell of the front.
Vec3 cell_middle(const BallFront& front, int row, int column)
{
    const double y = -1 + 2 * (row + 0.5) / front.rows;
    const double rho = std::sqrt(1 - y * y);
    const double chi = (front.lambda - pi / 2) * (1 - (column + 0.5) / front.columns);
    return {rho * std::cos(chi), y, rho * std::sin(chi)};
}

// Whether the cell at a point of the ball is in the stock.
bool is_engaged(const BallFront& front, const Vec3& at)
{
    const double chi = std::atan2(at.z(), at.x());
    const double from = front.lambda - pi / 2;
    if (chi <= from)
        return false;
    const int row =
        std::clamp(static_cast<int>((at.y() + 1) / 2 * front.rows), 0, front.rows - 1);
    const int column = std::clamp(static_cast<int>((1 - chi / from) * front.columns), 0,
                                  front.columns - 1);
    return front.engaged[static_cast<std::size_t>(row) * front.columns + column] != 0;
}

// Height in radii to which the shank is engaged at an azimuth.
double shank_height(const BallFront& front, double azimuth)
{
    const double turned = azimuth - 2 * pi * std::floor(azimuth / (2 * pi));
    if (turned >= pi)
        return 0;
    const auto count = static_cast<double>(front.shank.size());
    return front
        .shank[static_cast<std::size_t>(std::min(turned / pi * count, count - 1))];
}

// Adds an element of an edge of this height.
void add(EdgeSums& sums, const Place& at, double height)
{
    sums.chip += at.thickness * height;
    sums.edge += height;
    sums.chip_torque += at.radius * at.thickness * height;
    sums.edge_torque += at.radius * height;
}

// A helical edge in a front.
struct Edge {
    const BallFront& front;
    ChipModel chip;
    double tangent;  // tan(helix)
    double top;      // height of the stock above the ball centre

    // Adds the sums of the edge when its tip stands at an azimuth.
    void add_to(EdgeSums& sums, double tip_azimuth) const
    {
        const double step = 1.0 / edge_steps;
        for (int k = 0; (k + 0.5) * step < 1 + top; ++k) {
            const double height = (k + 0.5) * step;
            const double azimuth = tip_azimuth - height * tangent;
            if (height > 1) {
                if (height - 1 < shank_height(front, azimuth))
                    add(sums, shank_place(azimuth, front, chip), step);
                continue;
            }
            const double radius = std::sqrt(height * (2 - height));
            const Vec3 at{radius * std::sin(azimuth), radius * std::cos(azimuth),
                          height - 1};
            if (is_engaged(front, at))
                add(sums, ball_place(at, front, chip), step);
        }
    }
};

// Replaces `least` by `bound` if that is smaller. A missing bound does not bind.
void keep_smaller(std::optional<double>& least, const std::optional<double>& bound)
{
    if (bound && (!least || *bound < *least))
        least = bound;
}

}  // namespace

void require_sound(const BallFront& front)
{
    require(
        front.rows > 0 && front.columns > 0 &&
            front.engaged.size() == static_cast<std::size_t>(front.rows) * front.columns,
        "BallFront: need a value for each of its cells");
    require(std::abs(front.lambda) < pi / 2, "BallFront: need a slope below 90 degrees");
    require(std::ranges::all_of(front.shank,
                                [](double h) { return std::isfinite(h) && h >= 0; }),
            "BallFront: need heights from 0");
}

CuttingCoefficients front_coefficients(const BallFront& front, ChipModel chip)
{
    require_sound(front);
    CuttingCoefficients sum{};
    const double cell = 2.0 / front.rows * (pi / 2 - front.lambda) / front.columns;
    for (int row = 0; row < front.rows; ++row)
        for (int column = 0; column < front.columns; ++column)
            if (front.engaged[static_cast<std::size_t>(row) * front.columns + column] !=
                0)
                add(sum, ball_place(cell_middle(front, row, column), front, chip),
                    cell / (2 * pi));
    const auto azimuths = static_cast<double>(front.shank.size());
    for (std::size_t k = 0; k < front.shank.size(); ++k)
        add(sum, shank_place(pi * (static_cast<double>(k) + 0.5) / azimuths, front, chip),
            front.shank[k] / azimuths / 2);
    return sum;
}

FrontPattern::FrontPattern(const BallFront& front, ChipModel chip,
                           const MillingTool& tool)
{
    require_sound(front);
    require_sound(tool);
    const double top = front.shank.empty() ? 0 : std::ranges::max(front.shank);
    const Edge edge{front, chip, std::tan(tool.helix), top};
    const double period = 2 * pi / tool.flutes;
    for (int k = 0; k < turns; ++k) {
        EdgeSums sums;
        for (int flute = 0; flute < tool.flutes; ++flute)
            edge.add_to(sums, period * (flute + static_cast<double>(k) / turns));
        sums_.push_back(sums);
    }
}

EdgeSums FrontPattern::mean() const
{
    EdgeSums mean;
    for (const EdgeSums& sums : sums_) {
        mean.chip += sums.chip / turns;
        mean.edge += sums.edge / turns;
        mean.chip_torque += sums.chip_torque / turns;
        mean.edge_torque += sums.edge_torque / turns;
    }
    return mean;
}

double FrontPattern::peak_factor() const
{
    const double mean_torque = mean().chip_torque;
    if (!(mean_torque > 0))
        return 1;
    return std::ranges::max(sums_, {}, &EdgeSums::chip_torque).chip_torque / mean_torque;
}

FeedBounds FrontPattern::direct_bounds(const LoadModel& model,
                                       const LoadLimits& limits) const
{
    FeedBounds least;
    for (const EdgeSums& sums : sums_) {
        const FeedBounds bounds = feed_bounds(model, sums, limits);
        keep_smaller(least.cutting_force, bounds.cutting_force);
        keep_smaller(least.thrust, bounds.thrust);
        keep_smaller(least.torque, bounds.torque);
    }
    return least;
}

CuttingLoads FrontPattern::largest_loads(const LoadModel& model,
                                         double feed_per_tooth_mm) const
{
    CuttingLoads largest;
    for (const EdgeSums& sums : sums_) {
        const CuttingLoads loads = cutting_loads(model, sums, feed_per_tooth_mm);
        largest.cutting_force_n =
            std::max(largest.cutting_force_n, loads.cutting_force_n);
        largest.thrust_n = std::max(largest.thrust_n, loads.thrust_n);
        largest.torque_n_m = std::max(largest.torque_n_m, loads.torque_n_m);
    }
    return largest;
}

}  // namespace endmill
