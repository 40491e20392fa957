// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/section_runs.h"

#include <array>
#include <cmath>
#include <utility>

#include "endmill/core/error.h"

namespace endmill {

double dead_band(std::span<const SectionPoint> points)
{
    constexpr double share_of_extent = 1e-10;
    // independent minima, so that one need not wait for the other
    constexpr std::size_t lanes = 4;
    require(points.size() >= 2, "a section curve needs two points");
    std::array<SectionPoint, lanes> low;
    low.fill(points[0]);
    std::array<SectionPoint, lanes> high = low;
    std::array<SectionPoint, lanes> zero_if_finite;
    zero_if_finite.fill(SectionPoint::Zero());
    const auto include = [&](const SectionPoint& point, std::size_t lane) {
        low[lane] = low[lane].cwiseMin(point);
        high[lane] = high[lane].cwiseMax(point);
        zero_if_finite[lane] += 0 * point;
    };
    std::size_t i = 0;
    for (; i + lanes <= points.size(); i += lanes) {
        for (std::size_t lane = 0; lane < lanes; ++lane)
            include(points[i + lane], lane);
    }
    for (; i < points.size(); ++i)
        include(points[i], 0);
    for (std::size_t lane = 1; lane < lanes; ++lane) {
        include(low[lane], 0);
        include(high[lane], 0);
        zero_if_finite[0] += zero_if_finite[lane];
    }
    require(zero_if_finite[0].isZero(0),
            "a section curve has a point that is not finite");
    return share_of_extent * (high[0] - low[0]).maxCoeff();
}

RunReader::RunReader(const SectionChain& chain, RunAxis axis, double dead_band,
                     std::int32_t from)
    : chain_{chain},
      axis_{axis == RunAxis::S ? 0 : 1},
      dead_band_{dead_band},
      from_{from},
      vertex_{from}
{
}

std::int32_t RunReader::following(std::int32_t vertex) const
{
    return vertex == from_ ? chain_.next(vertex) : vertex + 1;
}

std::optional<SectionRun> RunReader::next()
{
    const std::int32_t end = chain_.last();
    double change = 0;
    for (; vertex_ != end; vertex_ = following(vertex_)) {
        change = chain_.at(following(vertex_))[axis_] - chain_.at(vertex_)[axis_];
        if (std::abs(change) > dead_band_)
            break;
    }
    if (vertex_ == end)
        return std::nullopt;

    const double sign = change > 0 ? 1 : -1;
    const SectionPoint* points = chain_.input().data();
    std::int32_t vertex = following(vertex_);
    while (vertex != end &&
           sign * (points[vertex + 1][axis_] - points[vertex][axis_]) >= -dead_band_)
        ++vertex;
    return SectionRun{std::exchange(vertex_, vertex), vertex, sign > 0};
}

int backward_runs(std::span<const TrimmedPoint> points, double dead_band)
{
    int runs = 0;
    bool is_backward = false;
    for (std::size_t k = 1; k < points.size(); ++k) {
        const double change = points[k].at.x() - points[k - 1].at.x();
        if (std::abs(change) <= dead_band)
            continue;
        runs += change < 0 && !is_backward;
        is_backward = change < 0;
    }
    return runs;
}

}  // namespace endmill
