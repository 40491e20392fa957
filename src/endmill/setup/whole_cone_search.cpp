// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/whole_cone_search.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/setup/detail/axis_fit.h"
#include "endmill/setup/detail/axis_node.h"
#include "endmill/setup/detail/cone_set.h"
#include "endmill/setup/detail/first_fits.h"
#include "endmill/setup/detail/range_limits.h"

// Branch and bound over the axis of the range of tool directions.
//
// 1. `first_fit` finds a good pose. Its objective gives the target T = best / (1 + gap).
// 2. The sphere of axes is covered by triangles, the nodes. NodeBounder gives each node a
//    lower bound of the objective of all poses with their axis in the triangle. A node
//    whose bound reaches the target is dropped.
// 3. The centre of each remaining node is fitted exactly and improved by descent, which
//    may lower the best objective and the target.
// 4. The 64 nodes of least bound are split in four and bounded, until no node is left
//    below the target. The least bound of all nodes, dropped or not, is the lower bound
//    of the result.
// 5. Poses with a thin window are described by nodes of arcs. If one of these becomes too
//    small to split, the search starts again with a quarter of the thin width.

namespace endmill {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// rad; smaller nodes are not split. No machine resolves smaller changes of a pose.
constexpr double least_radius = 0.004 * degree;

/// Largest number of restarts with a quarter of the thin width. After three of them the
/// thin width is below 0.04 degrees with the default floor.
constexpr int most_retries = 3;

/// Nodes that are bounded before the best pose is updated. The number is fixed, so that
/// the result does not depend on the number of threads.
constexpr std::size_t nodes_per_round = 64;

/// rad or rad^2: a smaller objective counts as 0, so that no gap needs to be proved.
constexpr double negligible = 1e-9;

/// First step of the descent from a node's centre, in radii of the node.
constexpr double first_step = 0.5;

/// The final descent of the best fit, with more directions than pays off for the earlier
/// ones.
constexpr Descent last_descent{.from = 2 * degree, .directions = 36};

/// rad: nodes of this radius or less also try the cells in them as axes. About half a
/// cell.
constexpr double cell_sized = 3 * degree;

/// A node in the queue.
struct Waiting {
    AxisNode node;
    std::size_t created;  ///< its age: the number of nodes queued before it
};

bool comes_later(const Waiting& a, const Waiting& b)
{
    return a.node.bound != b.node.bound ? a.node.bound > b.node.bound
                                        : a.created > b.created;
}

/// A node after it was bounded.
struct Bounded {
    AxisNode node;
    std::optional<AxisFit> fit;      ///< a fit that is better than the best so far
    std::vector<std::size_t> tried;  ///< cells whose centres were tried as axes
};

class AxisSearch {
public:
    AxisSearch(const ConeFitting& fitting, const WholeConeSearchOptions& options)
        : fitting_{fitting},
          options_{options},
          is_tried_(fitting.centres.size(), 0)
    {
    }

    WholeConeSearchResult run(std::span<const Vec3> starts)
    {
        improve(first_fit(fitting_, starts));
        fitting_.thin_width = thin_width(fitting_.measure, below());
        for (int retries = 0; !resolves_arcs(retries < most_retries); ++retries)
            fitting_.thin_width /= 4;
        const double proved =
            target();  // no pose of a dropped node has a smaller objective
        if (best_) {
            AxisFitter fitter{fitting_};
            best_ = descend(fitter, *best_, last_descent);
        }
        return result(proved);
    }

    const std::optional<AxisFit>& best() const { return best_; }

private:
    double below() const
    {
        if (!best_)
            return infinity;
        return best_->objective;
    }
    double target() const
    {
        return below() > negligible ? below() / (1 + options_.gap) : 0;
    }

    /// Bounds nodes until the gap or the limit of nodes is reached. \return false if a
    /// node of arcs became too small to split and the search should start again:
    /// `may_retry` is set, and less than half of the nodes are used.
    bool resolves_arcs(bool may_retry)
    {
        queue_.clear();
        unresolved_.clear();
        bool has_small_arc = false;
        std::vector<AxisNode> fresh = root_nodes(fitting_);
        while (!fresh.empty()) {
            has_small_arc = bound(std::move(fresh)) || has_small_arc;
            report();
            if (has_small_arc && may_retry && 2 * result_.nodes < options_.max_nodes)
                return false;
            fresh = next_round();
        }
        return true;
    }

    void report() const
    {
        if (!options_.progress)
            return;
        WholeConeSearchProgress now{result_.nodes, std::nullopt, lower_bound(target())};
        if (best_)
            now.objective = best_->objective;
        options_.progress(now);
    }

    /// Lower bound of all poses, if `dropped` is one of the poses of dropped nodes.
    double lower_bound(double dropped) const
    {
        double bound = dropped;
        if (!queue_.empty())
            bound = std::min(bound, queue_.front().node.bound);
        for (const double unresolved : unresolved_)
            bound = std::min(bound, unresolved);
        return bound;
    }

    void improve(const std::optional<AxisFit>& fit)
    {
        if (fit && fit->objective < below())
            best_ = fit;
    }

    /// Bounds nodes and queues those that are not dropped. \return true if a node of arcs
    /// became too small to split.
    bool bound(std::vector<AxisNode> fresh)
    {
        std::vector<Bounded> bounded(fresh.size());
        parallel_for(fresh.size(), [&](std::size_t begin, std::size_t end) {
            NodeBounder bounder{fitting_};
            AxisFitter fitter{fitting_};
            for (std::size_t k = begin; k < end; ++k) {
                bounded[k].node = std::move(fresh[k]);
                bounder.bound(bounded[k].node, target());
                try_axes(fitter, bounded[k]);
            }
        });
        result_.nodes += bounded.size();
        bool has_small_arc = false;
        for (Bounded& one : bounded) {
            improve(one.fit);
            for (const std::size_t cell : one.tried)
                is_tried_[cell] = 1;
            const bool is_arc = one.node.kind == NodeKind::Arc;
            if (!one.node.boxes.empty() && !enqueue(std::move(one.node)))
                has_small_arc = has_small_arc || is_arc;
        }
        return has_small_arc;
    }

    /// Fits ranges about the node's centre, and about the cells in a small node. A cell
    /// has no azimuth about itself, so that the range about it may be better than those
    /// about all axes nearby. Without these fits the bounds of such nodes would never be
    /// reached.
    void try_axes(AxisFitter& fitter, Bounded& one) const
    {
        if (one.node.boxes.empty() || one.node.kind == NodeKind::Arc)
            return;
        const Vec3 middle = centre(one.node);
        const double size = radius(one.node);
        double least = below();
        auto attempt = [&](const Vec3& axis) {
            if (auto fit = fitter.best(axis, {least})) {
                one.fit = descend(fitter, *fit, {first_step * size});
                least = one.fit->objective;
            }
        };
        attempt(middle);
        if (size > cell_sized)
            return;
        const double chord2 = size * size;  // a chord is shorter than its arc
        for (std::size_t cell = 0; cell < fitting_.centres.size(); ++cell) {
            if (is_tried_[cell] != 0 ||
                (fitting_.centres[cell] - middle).squaredNorm() > chord2)
                continue;
            one.tried.push_back(cell);
            attempt(fitting_.centres[cell]);
        }
    }

    /// Queues a node. \return false if it is too small to split; its bound is then
    /// unresolved.
    bool enqueue(AxisNode&& node)
    {
        if (radius(node) < least_radius) {
            unresolved_.push_back(node.bound);
            return false;
        }
        queue_.push_back({std::move(node), created_++});
        std::push_heap(queue_.begin(), queue_.end(), comes_later);
        return true;
    }

    /// Takes the nodes of least bound from the queue. \return their parts.
    std::vector<AxisNode> next_round()
    {
        std::vector<AxisNode> parts;
        while (!queue_.empty() && parts.size() < nodes_per_round &&
               result_.nodes + parts.size() + 4 <= options_.max_nodes &&
               queue_.front().node.bound < target()) {
            std::pop_heap(queue_.begin(), queue_.end(), comes_later);
            for (int k = 0; k < 4; ++k)
                parts.push_back(part(queue_.back().node, k));
            queue_.pop_back();
        }
        return parts;
    }

    WholeConeSearchResult result(double proved)
    {
        result_.unresolved = static_cast<std::size_t>(
            std::ranges::count_if(unresolved_, [=](double b) { return b < proved; }));
        result_.lower_bound = lower_bound(proved);
        if (best_) {
            result_.machinable = Answer::Yes;
            result_.ranges = best_->ranges;
            result_.objective = best_->objective;
        } else if (queue_.empty() && unresolved_.empty()) {
            result_.machinable = Answer::No;
        }
        return result_;
    }

    ConeFitting fitting_;
    WholeConeSearchOptions options_;
    std::optional<AxisFit> best_;
    std::vector<Waiting> queue_;      ///< a heap, least bound first
    std::vector<double> unresolved_;  ///< bounds of nodes too small to split
    std::vector<char> is_tried_;      ///< by cell: 1 if its centre was tried as an axis
    std::size_t created_ = 0;
    WholeConeSearchResult result_;
};

/// The result without any cone: every pose fits, here the part stands upright.
WholeConeSearchResult nothing_to_reach(RotaryFamily family)
{
    WholeConeSearchResult result;
    result.machinable = Answer::Yes;
    const bool is_ca = family == RotaryFamily::CA;
    const SetupPose upright{Vec3::UnitZ(), is_ca ? Vec3::UnitZ() : Vec3::UnitX(),
                            is_ca ? Vec3::UnitX() : Vec3::UnitY()};
    result.pose = FittedPose{.pose = upright, .phi = {0, 0}, .theta = {0, 0}, .area = 0};
    return result;
}

}  // namespace

WholeConeSearchResult whole_cone_search(const SphereGrid& grid, const VisibilityMap& map,
                                        const WholeConeSearchOptions& options)
{
    require(map.cells() == grid.centres.size(),
            "whole_cone_search: map and grid differ in cells");
    require(options.floor_rad > 0, "whole_cone_search: need floor_rad > 0");
    require(options.gap > 0, "whole_cone_search: need gap > 0");
    const ConeSet cones{map};
    if (cones.facets().empty())
        return nothing_to_reach(options.family);
    std::vector<Vec3> centres;
    for (const std::size_t cell : cones.cells())
        centres.push_back(grid.centres[cell]);
    const ConeFitting fitting{&cones,
                              centres,
                              {options.family, options.objective, options.floor_rad},
                              RangeLimits{options.family, options.limits}};
    std::vector<Vec3> starts;
    for (const SetupPose& pose : options.starts)
        starts.push_back(options.family == RotaryFamily::CA ? pose.tool_axis
                                                            : pose.r1_axis);
    AxisSearch search{fitting, options};
    WholeConeSearchResult result = search.run(starts);
    if (search.best())
        result.pose = fitted_pose(*search.best(), options.family, options.limits);
    return result;
}

}  // namespace endmill
