// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/dropped_path.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <variant>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/drop_cutter/drop_cutter.h"
#include "endmill/drop_cutter/mesh_sections.h"
#include "endmill/planning/detail/piece_order.h"
#include "endmill/planning/path_interval.h"
#include "endmill/surface/sampling.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

// How the inner tolerance is divided: the mesh may lie above the surface by one share, a
// chord may gouge the mesh by another, and thinning moves it by the rest.
constexpr double mesh_share = 0.2;
constexpr double chord_share = 0.5;
constexpr double thin_share = 0.3;
// Share of the inner tolerance that they take together. The rest is for the gouge of links.
constexpr double used_share = 0.8;
// Share of the scallop height that mesh, chords and thinning may take together.
constexpr double most_height_share = 0.2;
// Distance of planes on level ground in diameters, where the corner is so small that no
// scallop between planes reaches the height.
constexpr double level_share = 0.98;
// Dropped positions across a diameter, before chords are halved, and their number at most.
constexpr double positions_across = 16;
constexpr int most_positions = 200'000;
constexpr int least_positions = 20;
// Directions that are compared, over half a turn, and what their curves may deviate, as a
// share of the scallop height.
constexpr int directions = 36;
constexpr double half_turn_deg = 180;
constexpr double search_share = 0.5;
constexpr double searched_share = 0.5;  // of the work

// A pass that is cut in one go: tips.
using Tips = std::vector<Vec3>;

// How curves are made.
struct CurveLimits {
    double chord;    // mm, gouge of a chord
    double thin;     // mm
    double scallop;  // mm, between planes
};

TriangleMesh mesh_of(const Part& part, double chord_error)
{
    if (const auto* mesh = std::get_if<TriangleMesh>(&part))
        return *mesh;
    const auto& surfaces = std::get<std::vector<Surface>>(part);
    return sampled(surfaces, tool_side_signs(surfaces, Vec3::UnitZ()), chord_error).mesh;
}

double level_interval(const Cutter& cutter, double height)
{
    return height < 2 * cutter.corner_radius() ? level_path_interval(cutter, height)
                                               : level_share * 2 * cutter.radius();
}

int positions_along(const TriangleMesh& mesh, const DriveFrame& frame, double radius)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Vec3& point : mesh.points()) {
        low = std::min(low, frame.along(point));
        high = std::max(high, frame.along(point));
    }
    const double positions = (high - low) / (2 * radius) * positions_across;
    return static_cast<int>(
        std::clamp<double>(positions, least_positions, most_positions));
}

// The passes of one direction, plane by plane, all in the same sense.
std::vector<std::vector<Tips>> passes_along(const DropCutter& drop, Angle direction,
                                            const CurveLimits& limits)
{
    const DriveFrame frame{direction};
    const Cutter& cutter = drop.cutter();
    MeshSectionOptions sampling;
    sampling.samples = positions_along(drop.mesh(), frame, cutter.radius());
    sampling.tolerance = limits.chord;
    sampling.outer_tolerance = limits.chord;
    sampling.beyond_borders = true;
    const double interval = level_interval(cutter, limits.scallop);
    const MeshPasses found = mesh_passes(
        drop, drive_planes_by_pitch(frame, extent_across(drop.mesh(), frame), interval),
        {.height = limits.scallop, .level_interval = interval}, sampling);
    std::vector<std::vector<Tips>> passes(found.curves.size());
    for (std::size_t plane = 0; plane < passes.size(); ++plane)
        for (const SectionCurve& curve : found.curves[plane]) {
            Tips tips;
            for (const std::size_t k : thinned(curve.points, limits.thin))
                tips.push_back(frame.point(curve.points[k].x(),
                                           found.planes.positions[plane],
                                           curve.points[k].y() - cutter.corner_radius()));
            passes[plane].push_back(std::move(tips));
        }
    return passes;
}

double length(const std::vector<std::vector<Tips>>& passes)
{
    double sum = 0;
    for (const auto& plane : passes)
        for (const Tips& tips : plane)
            for (std::size_t k = 1; k < tips.size(); ++k)
                sum += (tips[k] - tips[k - 1]).norm();
    return sum;
}

// The direction whose passes are shortest, of equal steps over half a turn.
Angle best_direction(const DropCutter& drop, const CurveLimits& limits,
                     const StrategyOptions& options,
                     std::vector<ComparedDirection>& compared)
{
    Angle best = Angle::degrees(0);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < directions; ++k) {
        const Angle direction = Angle::degrees(half_turn_deg * k / directions);
        const auto passes = passes_along(drop, direction, limits);
        const double travel = length(passes);
        compared.push_back({direction, {}, travel, passes.size()});
        if (travel < least) {
            least = travel;
            best = direction;
        }
        if (options.progress)
            options.progress(searched_share * (k + 1) / directions);
    }
    return best;
}

// Joins passes to a path, with straight links where they are clear.
class TipLinking {
public:
    // \param link_tolerance greatest rise of the mesh into the cutter on a link, mm.
    TipLinking(const DropCutter& drop, const StrategyOptions& options,
               double link_tolerance)
        : drop_{drop},
          options_{options},
          link_tolerance_{link_tolerance}
    {
    }

    CoveringPath linked(const std::vector<Tips>& passes)
    {
        std::vector<PieceEnds> ends;
        ends.reserve(passes.size());
        for (const Tips& tips : passes)
            ends.emplace_back(OpenPiece{tips.front(), tips.back(),
                                        options_.link.order != PassOrder::OneWay});
        int number = 0;
        for (const OrderedPiece& place : order_pieces(ends).pieces) {
            Tips tips = passes[place.piece];
            if (place.is_reversed)
                std::reverse(tips.begin(), tips.end());
            approach(tips.front(), number);
            for (std::size_t k = 1; k < tips.size(); ++k)
                add(tips[k], Move::Cut, number);
            ++number;
        }
        return std::move(result_);
    }

private:
    void add(const Vec3& tip, Move move, int pass)
    {
        if (result_.path.points.size() >= options_.most_points)
            throw LimitError{"the path needs more points than allowed"};
        result_.path.points.push_back({pass, 0, move, 0, {tip, Vec3::UnitZ()}});
    }

    void lift(const Vec3& tip, Move move, int pass)
    {
        if (tip.z() > options_.link.safe_height)
            throw GeometryError{"the safe height " + to_text(options_.link.safe_height) +
                                " mm lies below the path, which reaches " +
                                to_text(tip.z()) + " mm"};
        add({tip.x(), tip.y(), options_.link.safe_height}, move, pass);
    }

    // Leads from the last point to the start of a pass.
    void approach(const Vec3& tip, int pass)
    {
        if (!result_.path.points.empty()) {
            const Vec3 last = result_.path.points.back().location.tip;
            if (options_.link.order == PassOrder::ZigZag &&
                drop_.is_clear(last, tip, link_tolerance_)) {
                add(tip, Move::Link, pass);
                return;
            }
            lift(last, Move::Retract, pass);
            lift(tip, Move::Rapid, pass);
            ++result_.lifted_links;
        }
        add(tip, Move::Plunge, pass);
    }

    const DropCutter& drop_;
    const StrategyOptions& options_;
    double link_tolerance_;
    CoveringPath result_;
};

}  // namespace

CoveringPath dropped_path(const Part& part, const Cutter& cutter,
                          const StrategyOptions& options)
{
    const double room = std::min(used_share * options.inner_tolerance,
                                 most_height_share * options.scallop_height);
    const TriangleMesh mesh = mesh_of(part, mesh_share * room);
    const DropCutter drop{mesh, cutter};
    const CurveLimits limits{chord_share * room, thin_share * room,
                             options.scallop_height - room};
    std::vector<ComparedDirection> compared;
    const double coarse = search_share * options.scallop_height;
    const Angle direction =
        options.direction
            ? *options.direction
            : best_direction(drop, {coarse, coarse, limits.scallop}, options, compared);
    std::vector<Tips> passes;
    for (auto& plane : passes_along(drop, direction, limits))
        for (Tips& tips : plane)
            passes.push_back(std::move(tips));
    CoveringPath result = TipLinking{drop, options, limits.chord}.linked(passes);
    result.passes = passes.size();
    result.pieces = passes.size();
    result.stray_mm = options.inner_tolerance;
    result.direction = direction;
    result.compared = std::move(compared);
    return result;
}

}  // namespace endmill
