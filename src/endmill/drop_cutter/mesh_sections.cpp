// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/mesh_sections.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"

namespace endmill {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr std::size_t most_points = 5'000'000;  // of a plane: about 100 MB

// A sampled position of a plane: the height of the tip, if any point of the mesh is below
// the cutter.
struct Sample {
    double s;
    std::optional<double> tip_z;
};

// Samples one plane from its lowest s to its highest.
class PlaneWalk {
public:
    PlaneWalk(const DropCutter& drop_cutter, const DriveFrame& frame, double position,
              double tolerance)
        : drop_cutter_{drop_cutter},
          frame_{frame},
          position_{position},
          tolerance_{tolerance}
    {
    }

    std::vector<SectionCurve> curves(double low, double high, int samples)
    {
        Sample last = sample(low);
        add(last);
        for (int k = 1; k < samples; ++k) {
            const double share = k / (samples - 1.0);
            const Sample next = sample(low + share * (high - low));
            if (next.s > last.s)
                go_on(last, next);
            last = next;
        }
        end_curve();
        return std::move(curves_);
    }

private:
    Sample sample(double s)
    {
        const auto found = drop_cutter_.contact(place(s), hint_);
        if (!found)
            return {s, std::nullopt};
        hint_ = found->triangle;
        return {s, found->tip_z};
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
            return drop_cutter_.is_clear(tip(from), tip(to), tolerance_);
        return !from.tip_z && !to.tip_z;
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
    const DriveFrame& frame_;
    double position_;
    double tolerance_;
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
    for (const double position : planes.positions)
        require(std::isfinite(position), "mesh_sections: need finite positions");
}

}  // namespace

std::vector<std::vector<SectionCurve>> mesh_sections(const DropCutter& drop_cutter,
                                                     const DrivePlanes& planes,
                                                     const MeshSectionOptions& options)
{
    check(planes, options);
    std::vector<std::vector<SectionCurve>> sections(planes.positions.size());
    const TriangleMesh& mesh = drop_cutter.mesh();
    if (mesh.triangles().empty())
        return sections;
    const Interval extent = extent_along(mesh, planes.frame);
    parallel_for(sections.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            PlaneWalk walk{drop_cutter, planes.frame, planes.positions[k],
                           options.tolerance};
            sections[k] = walk.curves(extent.low, extent.high, options.samples);
        }
    });
    return sections;
}

}  // namespace endmill
