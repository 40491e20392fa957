// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/indexed_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/deviation/deviation.h"
#include "endmill/mesh/mesh_repair.h"
#include "endmill/orientation/axis_reach.h"
#include "endmill/orientation/detail/region_mesh.h"
#include "endmill/orientation/indexed_path.h"
#include "endmill/stock/height_stock.h"
#include "endmill/strategy/plan_frame.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

// A plan that is not judged good is made again for this share of the scallop height, up to so
// many trials.
constexpr double lowered_share = 0.8;
constexpr int most_trials = 3;
// A height of remaining stock that no part exceeds, mm.
constexpr double no_scallop_limit = 1e9;

void require_sound(const BallCutter& cutter, const IndexedOptions& options)
{
    const double radius = cutter.radius();
    require(0 < options.scallop_height && options.scallop_height < radius,
            "plan_indexed: need 0 < scallop height < cutter radius");
    require(0 < options.inner_tolerance && options.inner_tolerance < radius,
            "plan_indexed: need 0 < inner tolerance < cutter radius");
    require(std::isfinite(options.clearance) && options.clearance > 0,
            "plan_indexed: need a clearance above 0");
}

// Width of the strip that a pass leaves below the scallop height on a plane, mm.
double path_interval_on_plane(const BallCutter& cutter, double scallop_height)
{
    return 2 * std::sqrt(scallop_height * (2 * cutter.radius() - scallop_height));
}

// The height at which plans aim, mm. Beside walls they keep a quarter of the tolerance, which the
// verification of the whole path does not know. In the strip of this width what remains rises
// by at most the slope of a scallop.
double aimed_height(double radius, const IndexedOptions& options)
{
    constexpr double kept_share = 0.25;  // as ProtectedPart
    const double cosine = 1 - options.scallop_height / radius;
    const double slope = std::sqrt(1 - cosine * cosine) / cosine;
    const double rise = kept_share * options.inner_tolerance * slope;
    return std::max(options.scallop_height - rise, options.scallop_height / 2);
}

// The block around a part from which `verify` cuts, however deep the tips are: a tip is at most
// two radii below its contact.
Block widest_block(const Part& part, const Cutter& cutter)
{
    Block block = default_block(&part, {}, cutter);
    block.low.z() -= 2 * cutter.radius();
    return block;
}

// The ball around a block, by its diagonal.
ClearBall ball_around(const Block& block, double clearance)
{
    return {(block.low + block.high) / 2,
            (block.high - block.low).norm() / 2 + clearance};
}

// The greatest height of a block along an axis, mm.
double height_of(const Block& block, const Vec3& axis)
{
    double height = 0;
    for (int c = 0; c < 3; ++c)
        height += std::max(axis[c] * block.low[c], axis[c] * block.high[c]);
    return height;
}

// Plans the facets of one direction after the other.
class DirectionPlanner {
public:
    DirectionPlanner(const TriangleMesh& part, const BallCutter& cutter,
                     const IndexedOptions& options, const SetupRegions& regions)
        : part_{part},
          whole_{without_degenerate_or_duplicate(part).mesh},
          cutter_{Cutter::ball(cutter.radius())},
          options_{options},
          regions_{regions},
          width_{path_interval_on_plane(cutter, options.scallop_height)},
          block_{widest_block(whole_, cutter_)}
    {
    }

    // \param shared facets of other directions that are cut too.
    // \param from, to shares of the progress.
    IndexedCut cut_from(std::size_t direction, std::span<const std::size_t> shared,
                        double from, double to) const
    {
        IndexedCut cut{direction, regions_.facets_of(direction), {}, {}};
        std::vector<std::size_t> facets;
        facets.reserve(cut.facets.size() + shared.size());
        std::ranges::set_union(cut.facets, shared, std::back_inserter(facets));
        const Part region = region_mesh(
            part_, facets, {width_, [&](std::size_t facet) {
                                return regions_.seen.is_accessible(facet, direction) &&
                                       regions_.direction_of[facet].has_value();
                            }});
        try {
            StrategyOptions options = strategy_options(direction, from, to);
            for (int trial = 1; trial <= most_trials; ++trial) {
                BestPlan best = planned(direction, region, options);
                const bool is_good = best.plan.is_good();
                if (is_good || !cut.best)
                    cut.best = std::move(best);
                if (is_good)
                    break;
                options.scallop_height *= lowered_share;
                options.progress = {};
            }
        } catch (const GeometryError& error) {
            cut.refusal = error.what();
        }
        return cut;
    }

    double safe_height(std::size_t direction) const
    {
        return height_of(block_, options_.directions[direction]) + options_.clearance;
    }

    ClearBall ball() const { return ball_around(block_, options_.clearance); }

private:
    // A plan, judged by the wanted scallop height whatever the height at which it aims.
    BestPlan planned(std::size_t direction, const Part& region,
                     const StrategyOptions& options) const
    {
        PlanFrame frame;
        frame.part_to_machine = upright_rotation(options_.directions[direction]);
        frame.protected_part = &whole_;
        BestPlan best = plan_in_frame(frame, options_.strategy, region, cutter_, options);
        StrategyPlan& plan = best.plan;
        const double tolerance = options_.inner_tolerance;
        const Verdict of_region =
            verdict(plan.deviation, {tolerance, options_.scallop_height});
        const Verdict of_whole =
            plan.of_protected ? verdict(*plan.of_protected, {tolerance, no_scallop_limit})
                              : Verdict::Clean;
        const bool whole_decides =
            of_whole == Verdict::Gouged || of_region == Verdict::Clean;
        plan.verdict = whole_decides ? of_whole : of_region;
        return best;
    }

    StrategyOptions strategy_options(std::size_t direction, double from, double to) const
    {
        StrategyOptions options;
        options.scallop_height = aimed_height(cutter_.radius(), options_);
        options.inner_tolerance = options_.inner_tolerance;
        options.distance = options_.distance;
        options.link.safe_height = safe_height(direction);
        options.most_points = options_.most_points;
        options.most_samples = options_.most_samples;
        if (options_.progress)
            options.progress = [this, from, to](double share) {
                options_.progress(std::lerp(from, to, share));
            };
        return options;
    }

    const TriangleMesh& part_;
    Part whole_;  // without degenerate and repeated triangles
    Cutter cutter_;
    const IndexedOptions& options_;
    const SetupRegions& regions_;
    double width_;
    Block block_;
};

// The directions that cut facets.
std::vector<std::size_t> used_directions(const SetupRegions& regions, std::size_t all)
{
    std::vector<char> is_used(all, 0);
    for (const auto& direction : regions.direction_of)
        if (direction)
            is_used[*direction] = 1;
    std::vector<std::size_t> used;
    for (std::size_t k = 0; k < all; ++k)
        if (is_used[k] != 0)
            used.push_back(k);
    return used;
}

// Assigns facets by what the ball reaches.
class ReachedFacets {
public:
    ReachedFacets(const TriangleMesh& part, const BallCutter& cutter,
                  const IndexedOptions& options)
        : part_{part},
          options_{options},
          whole_{without_degenerate_or_duplicate(part).mesh},
          reach_{whole_, Cutter::ball(cutter.radius()), options.directions},
          distance_{reached_share * options.scallop_height},
          spacing_{path_interval_on_plane(cutter, options.scallop_height) / 4}
    {
    }

    // The regions, by directions from which the ball reaches the middles of facets.
    SetupRegions regions(double cutter_radius) const
    {
        const Vec3 middle = Vec3::Constant(1.0 / 3);
        return setup_regions(part_, options_.directions,
                             {cutter_radius, std::span{options_.skipped},
                              [&](std::size_t facet, std::size_t direction) {
                                  return reaches(direction, facet, middle);
                              }});
    }

    // For each direction the facets of other directions that have a place that the ball reaches
    // from here, but not from the facet's own direction. Of several
    // directions the first one that sees the facet has it.
    std::vector<std::vector<std::size_t>> shared_facets(
        const SetupRegions& regions, std::span<const std::size_t> used) const
    {
        std::vector<std::vector<std::size_t>> shared(options_.directions.size());
        for (std::size_t facet = 0; facet < regions.direction_of.size(); ++facet) {
            if (!regions.direction_of[facet])
                continue;
            for (const Vec3& place : places_of(facet)) {
                if (reaches(*regions.direction_of[facet], facet, place))
                    continue;
                const auto other = std::ranges::find_if(used, [&](std::size_t k) {
                    return regions.seen.is_accessible(facet, k) &&
                           reaches(k, facet, place);
                });
                if (other != used.end() &&
                    (shared[*other].empty() || shared[*other].back() != facet))
                    shared[*other].push_back(facet);
            }
        }
        return shared;
    }

private:
    // Barycentric coordinates near the corners and the middles of the sides.
    static inline const std::array<Vec3, 6> outer_places{
        Vec3{0.9, 0.05, 0.05},    Vec3{0.05, 0.9, 0.05},    Vec3{0.05, 0.05, 0.9},
        Vec3{0.475, 0.475, 0.05}, Vec3{0.05, 0.475, 0.475}, Vec3{0.475, 0.05, 0.475}};

    // Places of a facet: near its outline, and if it is larger than a quarter of the path interval, in the
    // middles of parts of about this size.
    std::vector<Vec3> places_of(std::size_t facet) const
    {
        constexpr double most_parts = 50;  // of a side
        std::vector<Vec3> places(outer_places.begin(), outer_places.end());
        const auto [a, b, c] = part_.corners(facet);
        const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
        const auto parts =
            static_cast<int>(std::min(most_parts, std::ceil(longest / spacing_)));
        for (int i = 0; parts > 1 && i < parts; ++i)
            for (int j = 0; i + j < parts; ++j) {
                const Vec3 upright{i + 1 / 3.0, j + 1 / 3.0, parts - i - j - 2 / 3.0};
                places.emplace_back(upright / parts);
                const Vec3 inverted{i + 2 / 3.0, j + 2 / 3.0, parts - i - j - 4 / 3.0};
                if (i + j + 1 < parts)
                    places.emplace_back(inverted / parts);
            }
        return places;
    }

    bool reaches(std::size_t direction, std::size_t facet, const Vec3& place) const
    {
        const auto [a, b, c] = part_.corners(facet);
        const Vec3 normal = (b - a).cross(c - a).normalized();
        return reach_.reaches(
            direction, {place[0] * a + place[1] * b + place[2] * c, normal}, distance_);
    }

    const TriangleMesh& part_;
    const IndexedOptions& options_;
    TriangleMesh whole_;
    AxisReach reach_;
    double distance_;
    double spacing_;
};

}  // namespace

bool IndexedPlan::is_good() const
{
    return uncovered.empty() && std::ranges::all_of(cuts, [](const IndexedCut& cut) {
               return cut.best && cut.best->plan.is_good();
           });
}

IndexedPlan plan_indexed(const TriangleMesh& part, const BallCutter& cutter,
                         const IndexedOptions& options)
{
    require_sound(cutter, options);
    const ReachedFacets reached{part, cutter, options};
    const SetupRegions regions = reached.regions(cutter.radius());
    IndexedPlan plan;
    plan.uncovered = regions.uncovered;
    plan.joined_regions = regions.joined_regions;
    const std::vector<std::size_t> used =
        used_directions(regions, options.directions.size());
    if (used.empty())
        return plan;
    const auto shared = reached.shared_facets(regions, used);
    const DirectionPlanner planner{part, cutter, options, regions};
    std::vector<IndexedStretch> stretches;
    const auto count = static_cast<double>(used.size());
    for (std::size_t k = 0; k < used.size(); ++k) {
        const auto done = static_cast<double>(k);
        IndexedCut cut =
            planner.cut_from(used[k], shared[used[k]], done / count, (done + 1) / count);
        if (cut.best)
            stretches.push_back(
                {cut.best->plan.covering.path, planner.safe_height(cut.direction)});
        else
            plan.uncovered.insert(plan.uncovered.end(), cut.facets.begin(),
                                  cut.facets.end());
        plan.cuts.push_back(std::move(cut));
    }
    std::ranges::sort(plan.uncovered);
    plan.path = indexed_path(stretches, planner.ball());
    return plan;
}

}  // namespace endmill
