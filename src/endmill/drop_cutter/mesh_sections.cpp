// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/mesh_sections.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/drop_cutter/detail/scallop_passes.h"
#include "endmill/drop_cutter/detail/triangle_drop.h"

namespace endmill {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr std::size_t most_points = 5'000'000;  // of a plane: about 100 MB
// Accuracy of the ends of curves beyond the border, as a share of the tolerance.
constexpr double end_share = 0.25;

// A sampled position of a plane: the height of the tip, if any point of the mesh is below
// the cutter.
struct Sample {
    double s;
    std::optional<double> tip_z;
    std::size_t triangle = 0;  // that the cutter touches, if any
};

// Samples stretches of one plane in the direction of s.
class PlaneWalk {
public:
    PlaneWalk(const DropCutter& drop_cutter, const DriveFrame& frame, double position,
              const MeshSectionOptions& options)
        : drop_cutter_{drop_cutter},
          triangle_drop_{drop_cutter.cutter()},
          frame_{frame},
          position_{position},
          tolerance_{options.tolerance},
          outer_tolerance_{options.outer_tolerance}
    {
    }

    // Where the contact of a cutter that leaves the mesh at `border` reaches the border.
    double end_beyond(double border, double direction) const
    {
        const auto is_at_border = [&](double s) {
            const auto found = drop_cutter_.contact(place(s));
            return !found ||
                   direction * (frame_.along(found->point) - border) >= -border_rounding;
        };
        double outside = border;
        double inside = border;
        if (!is_at_border(border))
            outside += direction * drop_cutter_.cutter().radius();
        while (std::abs(outside - inside) > end_share * tolerance_) {
            const double middle = inside + (outside - inside) / 2;
            (is_at_border(middle) ? outside : inside) = middle;
        }
        return outside;
    }

    // Adds the curves of one stretch.
    void add_stretch(const Interval& along, int samples)
    {
        Sample last = sample(along.low);
        add(last);
        for (int k = 1; k < samples; ++k) {
            const double share = k / (samples - 1.0);
            const Sample next = sample(along.low + share * (along.high - along.low));
            if (next.s > last.s)
                go_on(last, next);
            last = next;
        }
        end_curve();
    }

    std::vector<SectionCurve> take() { return std::move(curves_); }

private:
    Sample sample(double s)
    {
        const auto found = drop_cutter_.contact(place(s), hint_);
        if (!found)
            return {s, std::nullopt};
        hint_ = found->triangle;
        return {s, found->tip_z, found->triangle};
    }

    Vec2 place(double s) const { return frame_.point(s, position_, 0).head<2>(); }

    Vec3 tip(const Sample& sample) const
    {
        return frame_.point(sample.s, position_, *sample.tip_z);
    }

    // Adds the samples behind `from` up to `to`, halving the step until it is fine
    // enough.
    void go_on(const Sample& from, const Sample& to)
    {
        const double middle = from.s + (to.s - from.s) / 2;
        if (is_fine(from, to) || !(from.s < middle && middle < to.s)) {
            add(to);
            return;
        }
        const Sample between = sample(middle);
        go_on(from, between);
        go_on(between, to);
    }

    bool is_fine(const Sample& from, const Sample& to) const
    {
        if (to.s - from.s <= tolerance_)
            return true;
        if (from.tip_z && to.tip_z)
            return is_low(from, to) &&
                   drop_cutter_.is_clear(tip(from), tip(to), tolerance_);
        return !from.tip_z && !to.tip_z;
    }

    // Whether the chord lies at most the outer tolerance above the curve. The height of the
    // tip on the triangle that the cutter touches at one end is a concave function of s and a
    // lower bound of the curve. It equals the chord at this end and lies a gap below it at the
    // other end. With gaps a and b of both triangles, the chord is nowhere more than
    // ab / (a + b) above the curve.
    bool is_low(const Sample& from, const Sample& to) const
    {
        if (!std::isfinite(outer_tolerance_) || from.triangle == to.triangle)
            return true;
        const double a = gap_at(to, from.triangle);
        const double b = gap_at(from, to.triangle);
        if (!std::isfinite(a) || !std::isfinite(b))
            return std::min(a, b) <= outer_tolerance_;
        return a * b <= outer_tolerance_ * (a + b);
    }

    // The height of the tip at a sample above its height on one triangle; infinite where the
    // cutter does not reach the triangle.
    double gap_at(const Sample& sample, std::size_t triangle) const
    {
        const Vec2 at = place(sample.s);
        const double height =
            triangle_drop_(drop_cutter_.mesh().corners(triangle), at.x(), at.y()).tip_z;
        return std::max(0.0, *sample.tip_z - height);
    }

    void add(const Sample& sample)
    {
        if (!sample.tip_z) {
            end_curve();
            return;
        }
        if (++count_ > most_points)
            throw LimitError{
                "mesh_sections: a plane takes over 5 million points; a larger "
                "tolerance takes fewer"};
        const double r = drop_cutter_.cutter().corner_radius();
        curve_.points.emplace_back(sample.s, *sample.tip_z + r);
    }

    // Finishes the current curve; a single point is dropped.
    void end_curve()
    {
        if (curve_.points.size() > 1)
            curves_.push_back(std::move(curve_));
        curve_ = {};
    }

    const DropCutter& drop_cutter_;
    TriangleDrop triangle_drop_;
    const DriveFrame& frame_;
    double position_;
    double tolerance_;
    double outer_tolerance_;
    std::optional<std::size_t> hint_;
    std::size_t count_ = 0;
    SectionCurve curve_;
    std::vector<SectionCurve> curves_;
};

Interval extent_along(const TriangleMesh& mesh, const DriveFrame& frame)
{
    Interval extent{std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
    for (const Vec3& point : mesh.points()) {
        const double s = frame.along(point);
        extent = {std::min(extent.low, s), std::max(extent.high, s)};
    }
    return extent;
}

void check(const DrivePlanes& planes, const MeshSectionOptions& options)
{
    require(options.samples >= 2, "mesh_sections: need at least 2 samples");
    require(options.tolerance > 0 && std::isfinite(options.tolerance),
            "mesh_sections: need 0 < tolerance");
    require(options.outer_tolerance > 0, "mesh_sections: need 0 < outer tolerance");
    for (const double position : planes.positions)
        require(std::isfinite(position), "mesh_sections: need finite positions");
}

// A plane with the stretches of s over which its curves are wanted.
struct PlaneStretches {
    double position;
    std::vector<Interval> stretches;
};

// The curves of one plane. `along` is the extent of the mesh, over which the samples are
// distributed.
std::vector<SectionCurve> curves_of(PlaneWalk walk, const PlaneStretches& plane,
                                    const Interval& along,
                                    const MeshSectionOptions& options)
{
    const double whole = along.high - along.low;
    for (Interval stretch : plane.stretches) {
        if (options.beyond_borders && stretch.low <= along.low)
            stretch.low = walk.end_beyond(along.low, -1);
        if (options.beyond_borders && stretch.high >= along.high)
            stretch.high = walk.end_beyond(along.high, 1);
        const double share = whole > 0 ? (stretch.high - stretch.low) / whole : 1;
        const double steps = std::ceil((options.samples - 1) * share);
        walk.add_stretch(stretch, static_cast<int>(std::max(1.0, steps)) + 1);
    }
    return walk.take();
}

// The curves over all stretches, on all threads.
std::vector<std::vector<SectionCurve>> curves_over(const DropCutter& drop_cutter,
                                                   const DriveFrame& frame,
                                                   const Interval& along,
                                                   std::span<const PlaneStretches> planes,
                                                   const MeshSectionOptions& options)
{
    std::vector<std::vector<SectionCurve>> sections(planes.size());
    std::atomic<std::size_t> done = 0;
    parallel_for(sections.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            sections[k] =
                curves_of(PlaneWalk{drop_cutter, frame, planes[k].position, options},
                          planes[k], along, options);
            if (options.progress)
                options.progress(static_cast<double>(++done) /
                                 static_cast<double>(sections.size()));
        }
    });
    return sections;
}

}  // namespace

std::vector<std::vector<SectionCurve>> mesh_sections(const DropCutter& drop_cutter,
                                                     const DrivePlanes& planes,
                                                     const MeshSectionOptions& options)
{
    check(planes, options);
    const TriangleMesh& mesh = drop_cutter.mesh();
    if (mesh.triangles().empty())
        return std::vector<std::vector<SectionCurve>>(planes.positions.size());
    const Interval along = extent_along(mesh, planes.frame);
    std::vector<PlaneStretches> all;
    for (const double position : planes.positions)
        all.push_back({position, {along}});
    return curves_over(drop_cutter, planes.frame, along, all, options);
}

MeshPasses mesh_passes(const DropCutter& drop_cutter, const DrivePlanes& planes,
                       const ScallopLimit& limit, const MeshSectionOptions& options)
{
    check(planes, options);
    MeshPasses passes{{planes.frame, {}}, {}};
    const TriangleMesh& mesh = drop_cutter.mesh();
    const Interval along =
        mesh.triangles().empty() ? Interval{0, 0} : extent_along(mesh, planes.frame);
    std::vector<PlaneStretches> all;
    for (const double position : planes.positions)
        all.push_back({position, {along}});
    if (!mesh.triangles().empty())
        for (AddedPass& added :
             added_passes(drop_cutter, planes, along,
                          {limit.height, limit.level_interval, limit.allowance,
                           options.samples, options.beyond_borders}))
            all.push_back({added.position, std::move(added.stretches)});
    std::vector<std::vector<SectionCurve>> curves(all.size());
    if (!mesh.triangles().empty())
        curves = curves_over(drop_cutter, planes.frame, along, all, options);
    // An added plane at the end of a wall may have a single place, which is no curve.
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < all.size(); ++k)
        if (k < planes.positions.size() || !curves[k].empty())
            order.push_back(k);
    passes.added_planes = order.size() - planes.positions.size();
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return all[k].position; });
    for (const std::size_t k : order) {
        passes.planes.positions.push_back(all[k].position);
        passes.curves.push_back(std::move(curves[k]));
    }
    return passes;
}

}  // namespace endmill
