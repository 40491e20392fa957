// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh_remarks.h"

#include <utility>

#include <fmt/format.h>

#include "endmill/core/text.h"
#include "endmill/mesh/mesh_checks.h"
#include "endmill/mesh/mesh_repair.h"

namespace endmill {

std::string non_manifold_text(std::size_t edges, const std::string& first_edge)
{
    return fmt::format(
        "edges of more than two triangles: {}, the first between points {}", edges,
        first_edge);
}

RemarkedMesh remarked(TriangleMesh mesh)
{
    RemarkedMesh result{std::move(mesh), {}};
    MeshReport report = mesh_report(result.mesh);
    if (const std::size_t count = report.duplicate_triangles) {
        result.mesh = without_degenerate_or_duplicate(result.mesh).mesh;
        report = mesh_report(result.mesh);
        result.remarks.push_back("left out: " + counted(count, "triangle") +
                                 " that repeats another");
    }
    if (report.boundary_edges > 0)
        result.remarks.push_back(fmt::format(
            "edges of one triangle only: {}; the mesh is a sheet or has holes",
            report.boundary_edges));
    if (const auto& first = report.first_non_manifold_edge)
        result.remarks.push_back(non_manifold_text(
            report.non_manifold_edges, fmt::format("[{},{}]", (*first)[0], (*first)[1])));
    if (report.inconsistent_edges > 0)
        result.remarks.push_back(
            fmt::format("edges between triangles of opposite orientation: {}",
                        report.inconsistent_edges));
    return result;
}

}  // namespace endmill
