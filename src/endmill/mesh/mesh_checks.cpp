// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/mesh_checks.h"

#include <cmath>

#include <Eigen/Geometry>

#include "endmill/core/detail/disjoint_sets.h"
#include "endmill/mesh/detail/collinear.h"

namespace endmill {
namespace {

// A sum that carries its own rounding along (Neumaier's), and so does not depend on how
// many terms there are.
class CompensatedSum {
public:
    void add(double term)
    {
        const double sum = sum_ + term;
        rounding_ +=
            std::abs(sum_) >= std::abs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
        sum_ = sum;
    }

    double value() const { return sum_ + rounding_; }

private:
    double sum_ = 0;
    double rounding_ = 0;
};

struct Measures {
    std::size_t without_area = 0;
    std::size_t with_three_corners = 0;
    CompensatedSum doubled_area;    // mm^2
    CompensatedSum sixfold_volume;  // mm^3
};

Measures measures(const TriangleMesh& mesh)
{
    Measures sum;
    if (mesh.triangles().empty())
        return sum;
    const Vec3 origin = mesh.corners(0)[0];  // near the mesh, wherever that is
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        const auto [a, b, c] = mesh.corners(k);
        const Vec3 doubled = (b - a).cross(c - a);
        sum.doubled_area.add(doubled.norm());
        sum.sixfold_volume.add((a - origin).dot(doubled));
        sum.with_three_corners += !repeats_a_corner(mesh.triangles()[k]);
        sum.without_area += are_collinear(a, b, c);
    }
    return sum;
}

struct EdgeReport {
    std::size_t boundary = 0;
    std::size_t non_manifold = 0;
    std::optional<Edge> first_non_manifold;
    std::size_t inconsistent = 0;
    std::size_t joints = 0;  // that made one component of two
    bool all_even = true;
    bool all_balanced = true;
};

EdgeReport edge_report(const EdgeUses& edges, std::size_t triangles)
{
    EdgeReport report;
    DisjointSets components{triangles};
    edges.for_each([&](const Edge& edge, std::span<const EdgeUse> uses) {
        std::ptrdiff_t surplus = 0;  // of triangles that run forward
        for (const EdgeUse& use : uses) {
            surplus += use.is_forward() ? 1 : -1;
            report.joints += components.join(uses.front().triangle(), use.triangle());
        }
        report.boundary += uses.size() == 1;
        report.inconsistent += uses.size() == 2 && surplus != 0;
        report.all_even &= uses.size() % 2 == 0;
        report.all_balanced &= surplus == 0;
        if (uses.size() > 2) {
            ++report.non_manifold;
            if (!report.first_non_manifold)
                report.first_non_manifold = edge;
        }
    });
    return report;
}

}  // namespace

MeshReport mesh_report(const TriangleMesh& mesh)
{
    const EdgeUses uses{mesh};
    const Measures sum = measures(mesh);
    const EdgeReport edges = edge_report(uses, mesh.triangles().size());
    const bool has_edges = sum.with_three_corners > 0;
    MeshReport report{};
    report.boundary_edges = edges.boundary;
    report.non_manifold_edges = edges.non_manifold;
    report.first_non_manifold_edge = edges.first_non_manifold;
    report.inconsistent_edges = edges.inconsistent;
    report.components = sum.with_three_corners - edges.joints;
    report.degenerate_triangles = sum.without_area;
    report.duplicate_triangles = duplicate_triangles(mesh, uses).size();
    report.area = sum.doubled_area.value() / 2;
    report.closed = has_edges && edges.all_even;
    if (has_edges && edges.all_balanced)
        report.volume = sum.sixfold_volume.value() / 6;
    return report;
}

}  // namespace endmill
