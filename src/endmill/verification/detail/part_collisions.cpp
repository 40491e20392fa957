// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/part_collisions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"
#include "endmill/stock/detail/sweep_tree.h"
#include "endmill/stock/stock_history.h"
#include "endmill/surface/sampling.h"
#include "endmill/surface/tool_side.h"
#include "endmill/verification/detail/body_contacts.h"

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Ratio of the tolerances of consecutive samplings; the number of triangles grows by the
// same factor.
constexpr double finer = 8;
// mm. Half the slack, so that a body that rests on the part stays below the slack.
constexpr double finest_chord_error = part_contact_slack / 2;
// Memory of a triangle: three corner numbers, and half a point with its normal.
constexpr double bytes_a_triangle = 36;

// Highest z of a mesh, mm.
double top_of(const TriangleMesh& mesh)
{
    double top = -infinite;
    for (const Vec3& point : mesh.points())
        top = std::max(top, point.z());
    return top;
}

// Tests the open moves against a mesh from which the part deviates by at most
// `chord_error`.
void test_moves(const TriangleMesh& mesh, double chord_error,
                std::span<const BodyCylinder> body, BodyMoves& moves)
{
    const std::vector<StraightSweep> sweeps = moves.open_sweeps();
    const double top = top_of(mesh) + chord_error;
    double lowest = infinite;
    for (const StraightSweep& sweep : sweeps)
        lowest = std::min({lowest, sweep.from().z(), sweep.to().z()});
    const SweepTree tree{sweeps};
    moves.begin_pass();
    for (const BodyCylinder& cylinder : body)
        if (lowest + cylinder.above < top)
            find_contacts({mesh, chord_error, cylinder, tree}, moves);
    moves.end_pass(chord_error);
}

// Tests the open moves against ever finer triangles. Coarse triangles decide most moves;
// fine ones are needed for few.
void test_moves(std::span<const Surface> surfaces, double most_bytes,
                std::span<const BodyCylinder> body, BodyMoves& moves)
{
    const auto most_triangles = static_cast<std::size_t>(
        std::clamp(most_bytes / bytes_a_triangle, 1.0, double(most_sampled_triangles)));
    const std::vector<double> sides = tool_side_signs(surfaces, Vec3::UnitZ());
    double tolerance = std::max(default_chord_tolerance(surfaces), finest_chord_error);
    while (true) {
        try {
            const SampledSurface sample =
                sampled(surfaces, sides, tolerance, most_triangles);
            test_moves(sample.mesh, sample.max_chord_error_mm, body, moves);
        } catch (const LimitError&) {
            return;
        }
        if (tolerance <= finest_chord_error || !moves.has_open())
            return;
        tolerance = std::max(tolerance / finer, finest_chord_error);
    }
}

}  // namespace

bool reaches_out(const ToolCylinder& cylinder, const Cutter& cutter)
{
    const double radius = cylinder.diameter / 2;
    return radius > cutter.radius() || cylinder.from < cutter.profile(radius);
}

PartCollisions part_collisions(const Part& part, const ToolPath& path,
                               const Cutter& cutter, std::span<const ToolCylinder> body,
                               double most_bytes)
{
    std::vector<BodyCylinder> cylinders;
    double widest = 0;
    for (const ToolCylinder& cylinder : body)
        if (reaches_out(cylinder, cutter)) {
            cylinders.push_back({cylinder.diameter / 2, cylinder.from});
            widest = std::max(widest, cylinder.diameter / 2);
        }
    if (cylinders.empty())
        return {};
    const std::vector<StraightSweep> sweeps = path_sweeps(path, Cutter::flat(widest));
    BodyMoves moves{sweeps};
    if (const auto* mesh = std::get_if<TriangleMesh>(&part))
        test_moves(*mesh, 0, cylinders, moves);
    else
        test_moves(std::get<std::vector<Surface>>(part), most_bytes, cylinders, moves);
    return moves.found(path.points.size() - sweeps.size());
}

}  // namespace endmill
