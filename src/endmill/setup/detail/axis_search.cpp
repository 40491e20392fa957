// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/axis_search.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "endmill/core/parallel.h"
#include "endmill/setup/detail/adaptive_fit.h"
#include "endmill/setup/detail/axis_fit.h"
#include "endmill/setup/detail/axis_node.h"
#include "endmill/setup/detail/cell_circles.h"
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
//    Of many cones only some are used at a time, see AdaptiveFitter.
//    Each node has its own: those of its parent, and those that the windows of its bound
//    or the range about its centre missed.
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

/// Most circles through two cells that a node tries. If there are more, its parts do.
constexpr std::size_t most_circles = 16;

/// Relative, if only some cones are in use: the search for better ranges about the centres
/// of nodes may miss those that are better by less. The final descent finds them.
constexpr double small_gain = 0.02;

/// Most cones that the parts of a node inherit. They fill four words.
constexpr std::ptrdiff_t cones_inherited = 256;

/// Most times that the first range is searched for with cones that the last one missed.
constexpr int first_rounds = 3;

/// A node with the cones for which it is bounded.
struct ConeNode {
    AxisNode axes;
    std::vector<std::size_t> cones;  ///< numbers of minimal cones
};

/// A node that waits to be split.
struct QueuedNode {
    ConeNode node;
    std::size_t created;  ///< its age: the number of nodes queued before it
};

bool comes_later(const QueuedNode& a, const QueuedNode& b)
{
    return a.node.axes.bound != b.node.axes.bound ? a.node.axes.bound > b.node.axes.bound
                                                  : a.created > b.created;
}

/// A node after it was bounded.
struct BoundedNode {
    ConeNode node;
    std::optional<AxisFit> fit;      ///< a fit that is better than the best so far
    std::vector<std::size_t> tried;  ///< cells whose centres were tried as axes
};

/// Improves a range that meets all cones by descent.
AxisFit descended(AdaptiveFitter& fitter, const AxisFit& fit, const Descent& descent)
{
    auto best = [&fitter](const Vec3& axis, const FitRequest& request) {
        return fitter.best(axis, request);
    };
    return descend(best, fit, descent);
}

class AxisSearch {
public:
    AxisSearch(const MinimalCones& cones, std::vector<std::size_t> first_cones,
               const ConeFitting& fitting, const WholeConeSearchOptions& options)
        : cones_{cones},
          first_cones_{std::move(first_cones)},
          fitting_{fitting},
          options_{options},
          is_tried_(fitting.centres.size(), 0)
    {
    }

    WholeConeSearchResult run(std::span<const Vec3> starts)
    {
        improve_from(starts);
        fitting_.thin_width =
            std::min(thin_width(fitting_.measure, below()), fitting_.limits.widest());
        // A smaller thin width does not help if it is the limit.
        const int most =
            fitting_.thin_width < fitting_.limits.widest() ? most_retries : 0;
        for (int retries = 0; !search_with_thin_width(retries < most); ++retries)
            fitting_.thin_width /= 4;
        const double proved =
            target();  // no pose of a dropped node has a smaller objective
        if (best_) {
            AdaptiveFitter fitter{cones_, fitting_};
            fitter.begin_with(first_cones_);
            best_ = descended(fitter, *best_, last_descent);
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
    bool search_with_thin_width(bool may_retry)
    {
        queue_.clear();
        unresolved_.clear();
        bool has_small_arc = false;
        std::vector<ConeNode> fresh;
        for (AxisNode& node : root_nodes(fitting_))
            fresh.push_back({std::move(node), first_cones_});
        while (!fresh.empty()) {
            has_small_arc = bound_all(std::move(fresh)) || has_small_arc;
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
            bound = std::min(bound, queue_.front().node.axes.bound);
        for (const double unresolved : unresolved_)
            bound = std::min(bound, unresolved);
        return bound;
    }

    /// Takes a fit if it is better than the best one.
    void keep_better(const std::optional<AxisFit>& fit)
    {
        if (fit && fit->objective < below())
            best_ = fit;
    }

    /// Finds a first range that meets all cones, and the set of cones of the first nodes.
    void improve_from(std::span<const Vec3> starts)
    {
        AdaptiveFitter fitter{cones_, fitting_};
        fitter.begin_with(first_cones_);
        if (!is_complete())
            for (const Vec3& axis : starts)
                keep_better(fitter.best(axis, {below()}));
        for (int round = 0; round < (is_complete() ? 1 : first_rounds); ++round) {
            const std::size_t cones = fitter.set().size();
            improve(first_fit(fitter.fitting(), starts), fitter);
            if (fitter.set().size() == cones)
                break;
        }
    }

    /// Improves the best range by one for the cones of the fitter, which grow.
    void improve(const std::optional<AxisFit>& fit, AdaptiveFitter& fitter)
    {
        if (is_complete())
            keep_better(fit);
        else if (fit)
            keep_better(fitter.best(fit->axis, {below()}));
        if (best_ && !is_complete())
            best_ = descended(fitter, *best_, last_descent);
    }

    bool is_complete() const { return first_cones_.size() == cones_.size(); }

    /// Bounds nodes and queues those that are not dropped. \return true if a node of arcs
    /// became too small to split.
    bool bound_all(std::vector<ConeNode> fresh)
    {
        std::vector<BoundedNode> bounded(fresh.size());
        parallel_for(fresh.size(), [&](std::size_t begin, std::size_t end) {
            AdaptiveFitter fitter{cones_, fitting_};
            NodeBounder bounder{fitter.fitting()};
            for (std::size_t k = begin; k < end; ++k) {
                bounded[k].node = std::move(fresh[k]);
                bound_one(bounder, fitter, bounded[k]);
            }
        });
        result_.nodes += bounded.size();
        bool has_small_arc = false;
        for (BoundedNode& one : bounded) {
            keep_better(one.fit);
            for (const std::size_t cell : one.tried)
                is_tried_[cell] = 1;
            const bool is_arc = one.node.axes.kind == NodeKind::Arc;
            if (!one.node.axes.boxes.empty() && !enqueue(std::move(one.node)))
                has_small_arc = has_small_arc || is_arc;
        }
        return has_small_arc;
    }

    /// Bounds a node for its cones, and for those that turn out to be missed. Its parts
    /// begin with the last of these cones.
    void bound_one(NodeBounder& bounder, AdaptiveFitter& fitter, BoundedNode& one) const
    {
        fitter.begin_with(one.node.cones);
        GrowCones grow;
        if (!is_complete())
            grow = [&](std::span<const std::uint32_t> cells) {
                return fitter.grow(cells);
            };
        bounder.bound(one.node.axes, target(), grow);
        const std::size_t bounded_for = fitter.set().size();
        fit_about_axes(fitter, one);
        if (fitter.set().size() > bounded_for)
            bounder.bound(one.node.axes, target(), grow);
        const auto set = fitter.set();
        one.node.cones.assign(is_complete() || std::ssize(set) <= cones_inherited
                                  ? set.begin()
                                  : set.end() - cones_inherited,
                              set.end());
    }

    /// Fits ranges about axes in the node that may have better ranges than all axes nearby.
    /// Without these fits the bounds of such nodes would never be reached.
    void fit_about_axes(AdaptiveFitter& fitter, BoundedNode& one) const
    {
        if (one.node.axes.boxes.empty())
            return;
        if (one.node.axes.kind == NodeKind::Arc) {
            fit_along_circles(fitter, one);
            return;
        }
        fit_about(fitter, one, centre(one.node.axes));
        fit_about_circles(fitter, one);
        fit_about_cells(fitter, one);
    }

    /// Fits a range about an axis, and improves it if it is better than the best one.
    void fit_about(AdaptiveFitter& fitter, BoundedNode& one, const Vec3& axis) const
    {
        const double least = one.fit ? one.fit->objective : below();
        const double slack = is_complete() ? 0 : small_gain;
        if (auto fit = fitter.best(axis, {least, slack}))
            one.fit = descended(fitter, *fit, {first_step * radius(one.node.axes)});
    }

    /// Fits ranges about the cells in a small node. A cell has no azimuth about itself.
    void fit_about_cells(AdaptiveFitter& fitter, BoundedNode& one) const
    {
        const Vec3 middle = centre(one.node.axes);
        const double size = radius(one.node.axes);
        if (size > cell_sized)
            return;
        const double chord2 = size * size;  // a chord is shorter than its arc
        for (std::size_t cell = 0; cell < fitting_.centres.size(); ++cell) {
            if (is_tried_[cell] != 0 ||
                (fitting_.centres[cell] - middle).squaredNorm() > chord2)
                continue;
            one.tried.push_back(cell);
            fit_about(fitter, one, fitting_.centres[cell]);
        }
    }

    /// Normals in the node of circles through two cells.
    std::vector<Vec3> circles(const AxisNode& node) const
    {
        return cell_circles(fitting_.centres, centre(node), radius(node), most_circles);
    }

    /// A,B: if the limits of the latitudes are narrower than the node, fits ranges about
    /// the normals of circles through two cells. With limits of zero width no other axis
    /// has a range.
    void fit_about_circles(AdaptiveFitter& fitter, BoundedNode& one) const
    {
        const AxisNode& node = one.node.axes;
        if (fitting_.measure.family == RotaryFamily::AB &&
            fitting_.limits.highest() < radius(node))
            for (const Vec3& normal : circles(node))
                fit_about(fitter, one, normal);
    }

    /// If the limit of the window is narrower than the node of arcs, fits ranges about
    /// axes on circles through two cells. With a limit of zero width no other axis has a
    /// range, unless the range is a single direction.
    void fit_along_circles(AdaptiveFitter& fitter, BoundedNode& one) const
    {
        const AxisNode& node = one.node.axes;
        if (fitting_.limits.widest() >= radius(node))
            return;
        ConeFitting arcs = arc_fitting(fitter.fitting(), fitting_.limits.width / 2);
        arcs.limits.width = std::min(fitting_.limits.highest(), arcs.limits.width);
        AxisFitter arc_fitter{arcs};
        for (const Vec3& normal : circles(node)) {
            std::size_t cones = 0;
            do {  // until the shortest arc is one for all cones
                cones = fitter.set().size();
                const double least = one.fit ? one.fit->objective : below();
                if (const auto arc = arc_fitter.best(normal, {least}))
                    fit_about(fitter, one, axis_on_arc(*arc, fitting_));
            } while (fitter.set().size() > cones);
        }
    }

    /// Queues a node. \return false if it is too small to split; its bound is then
    /// unresolved.
    bool enqueue(ConeNode&& node)
    {
        if (radius(node.axes) < least_radius) {
            unresolved_.push_back(node.axes.bound);
            return false;
        }
        queue_.push_back({std::move(node), created_++});
        std::push_heap(queue_.begin(), queue_.end(), comes_later);
        return true;
    }

    /// Takes the nodes of least bound from the queue. \return their parts.
    std::vector<ConeNode> next_round()
    {
        std::vector<ConeNode> parts;
        while (!queue_.empty() && parts.size() < nodes_per_round &&
               result_.nodes + parts.size() + 4 <= options_.max_nodes &&
               queue_.front().node.axes.bound < target()) {
            std::pop_heap(queue_.begin(), queue_.end(), comes_later);
            for (int k = 0; k < 4; ++k)
                parts.push_back(
                    {part(queue_.back().node.axes, k), queue_.back().node.cones});
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

    const MinimalCones& cones_;
    std::vector<std::size_t> first_cones_;  ///< of the nodes with which the search begins
    ConeFitting fitting_;
    WholeConeSearchOptions options_;
    std::optional<AxisFit> best_;
    std::vector<QueuedNode> queue_;   ///< a heap, least bound first
    std::vector<double> unresolved_;  ///< bounds of nodes too small to split
    std::vector<char> is_tried_;      ///< by cell: 1 if its centre was tried as an axis
    std::size_t created_ = 0;
    WholeConeSearchResult result_;
};

}  // namespace

WholeConeSearchResult axis_search(const SphereGrid& grid, const MinimalCones& cones,
                                  std::vector<std::size_t> first_cones,
                                  const WholeConeSearchOptions& options)
{
    std::vector<Vec3> centres;
    for (const std::size_t cell : cones.cells())
        centres.push_back(grid.centres[cell]);
    const ConeFitting fitting{nullptr,
                              centres,
                              {options.family, options.objective, options.floor_rad},
                              RangeLimits{options.family, options.limits}};
    std::vector<Vec3> starts;
    for (const SetupPose& pose : options.starts)
        starts.push_back(options.family == RotaryFamily::CA ? pose.tool_axis
                                                            : pose.r1_axis);
    AxisSearch search{cones, std::move(first_cones), fitting, options};
    WholeConeSearchResult result = search.run(starts);
    if (search.best())
        result.pose = fitted_pose(*search.best(), options.family, options.limits);
    return result;
}

}  // namespace endmill
