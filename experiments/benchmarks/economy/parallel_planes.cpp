// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/economy/parallel_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/offset/drive_planes.h"
#include "endmill/offset/section_curve.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

// Distance of the rays on which the search measures, mm. Between them a scallop of a ball of
// 7.5 mm rises by 0.003 mm.
constexpr double ray_pitch = 0.4;

constexpr int most_planes = 2000;

struct Extents {
    Interval along;
    Interval across;
};

Extents extents_of(const TriangleMesh& mesh, const DriveFrame& frame)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Extents extents{{infinity, -infinity}, {infinity, -infinity}};
    const auto extend = [](Interval& interval, double value) {
        interval = {std::min(interval.low, value), std::max(interval.high, value)};
    };
    for (const Vec3& point : mesh.points()) {
        extend(extents.along, frame.along(point));
        extend(extents.across, frame.across(point));
    }
    return extents;
}

// The numbers of positions between the first and the last at which the cutter touches the
// part inside its border, with one more at each end.
Interval kept_positions(const std::vector<std::optional<DropContact>>& contacts,
                        const DriveFrame& frame, const Extents& extents)
{
    constexpr double rounding = 1e-6;  // mm
    const auto is_inside = [](const Interval& interval, double value) {
        return interval.low + rounding < value && value < interval.high - rounding;
    };
    Interval kept{0, -1};
    for (std::size_t k = 0; k < contacts.size(); ++k)
        if (contacts[k] && is_inside(extents.along, frame.along(contacts[k]->point)) &&
            is_inside(extents.across, frame.across(contacts[k]->point))) {
            const auto place = static_cast<double>(k);
            if (kept.high < 0)
                kept.low = std::max(place - 1, 0.0);
            kept.high = place + 1;
        }
    return kept;
}

// The tips of one pass.
std::vector<Vec3> pass_of(const DropCutter& drop, const DriveFrame& frame,
                          const Extents& extents, double across,
                          const DroppedPlanes& options)
{
    const double radius = drop.cutter().radius();
    const Interval along{extents.along.low - radius, extents.along.high + radius};
    const int steps =
        std::max(1, static_cast<int>(std::ceil((along.high - along.low) / options.step)));
    std::vector<Eigen::Vector2d> positions;
    positions.reserve(steps + 1);
    for (int k = 0; k <= steps; ++k)
        positions.emplace_back(
            frame.point(std::lerp(along.low, along.high, double(k) / steps), across, 0)
                .head<2>());
    const auto contacts = drop.contacts(positions);
    const Interval kept = kept_positions(contacts, frame, extents);
    std::vector<SectionPoint> curve;
    for (int k = static_cast<int>(kept.low);
         k <= std::min(steps, static_cast<int>(kept.high)); ++k)
        if (contacts[k])
            curve.emplace_back(std::lerp(along.low, along.high, double(k) / steps),
                               contacts[k]->tip_z);
    std::vector<Vec3> tips;
    for (const std::size_t k : thinned(curve, options.thinning))
        tips.push_back(frame.point(curve[k].x(), across, curve[k].y()));
    return tips;
}

// Where planes may lie: the cutter touches the part also from beyond its border.
Interval widened(const Interval& across, double radius)
{
    return {across.low - radius, across.high + radius};
}

}  // namespace

ToolPath dropped_planes(const DropCutter& drop, const DroppedPlanes& options)
{
    const DriveFrame frame{options.direction};
    const Extents extents = extents_of(drop.mesh(), frame);
    ToolPath path;
    const auto add = [&](const Vec3& tip, Move move, int pass) {
        path.points.push_back({pass, 0, move, 0, {tip, Vec3::UnitZ()}});
    };
    const auto lifted = [&](const Vec3& tip) -> Vec3 {
        return {tip.x(), tip.y(), options.safe_height};
    };
    int pass = 0;
    for (const double across :
         drive_planes(frame, widened(extents.across, drop.cutter().radius()),
                      options.planes)
             .positions) {
        const auto tips = pass_of(drop, frame, extents, across, options);
        if (tips.empty())
            continue;
        if (!path.points.empty())
            add(lifted(path.points.back().location.tip), Move::Retract, pass);
        add(lifted(tips.front()), Move::Rapid, pass);
        add(tips.front(), Move::Plunge, pass);
        for (std::size_t k = 1; k < tips.size(); ++k)
            add(tips[k], Move::Cut, pass);
        ++pass;
    }
    return path;
}

JudgedPlanes fewest_planes(const Part& part, const DropCutter& drop,
                           DroppedPlanes options, double height, double tolerance)
{
    const DriveFrame frame{options.direction};
    const Extents extents = extents_of(drop.mesh(), frame);
    const Interval across = widened(extents.across, drop.cutter().radius());
    const double width = across.high - across.low;
    const auto planned = [&](int planes) {
        options.planes = planes;
        return dropped_planes(drop, options);
    };
    DeviationOptions on_rays{{tolerance, height}};
    on_rays.pitch = ray_pitch;
    on_rays.max_refine = 0;
    const auto leaves_more = [&](int planes) {
        return deviation_in_block(part, planned(planes), drop.cutter(), on_rays)
                   .max_scallop_mm > height;
    };
    // planes `too_few` leave more, those of `enough` do not
    int too_few = 0;
    const double radius = drop.cutter().radius();
    int enough = std::max(
        1, static_cast<int>(width / (2 * std::sqrt(height * (2 * radius - height)))));
    while (leaves_more(enough)) {
        if (enough > most_planes)
            throw LimitError{"fewest_planes: planes never leave so little"};
        too_few = enough;
        enough *= 2;
    }
    while (enough - too_few > 1) {
        const int middle = (too_few + enough) / 2;
        (leaves_more(middle) ? too_few : enough) = middle;
    }
    PathDeviationOptions judgement{{tolerance, height}};
    judgement.proof = LimitProof::GougeProved;
    for (;; ++enough) {
        const ToolPath path = planned(enough);
        const Deviation found = deviation_of_path(part, path, drop.cutter(), judgement);
        if (found.max_scallop_mm <= height)
            return {enough, width / enough, path_totals(path).cut_mm,
                    found.max_scallop_mm, found.max_gouge_mm};
    }
}

}  // namespace endmill
