// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh_remarks.h"

#include <fmt/format.h>

#include "endmill/core/text.h"
#include "endmill/mesh/mesh_checks.h"

namespace endmill {

std::string non_manifold_text(std::size_t edges, const std::string& first_edge)
{
    return fmt::format(
        "edges of more than two triangles: {}, the first between points {}", edges,
        first_edge);
}

std::vector<std::string> mesh_remarks(const CleanedMesh& cleaned)
{
    std::vector<std::string> remarks;
    const MeshReport report = mesh_report(cleaned.mesh);
    if (cleaned.duplicate_triangles > 0)
        remarks.push_back(
            "left out: " + counted(cleaned.duplicate_triangles, "triangle") +
            " that repeats another");
    if (report.boundary_edges > 0)
        remarks.push_back(fmt::format(
            "edges of one triangle only: {}; the mesh is a sheet or has holes",
            report.boundary_edges));
    if (const auto& first = report.first_non_manifold_edge)
        remarks.push_back(non_manifold_text(
            report.non_manifold_edges, fmt::format("[{},{}]", (*first)[0], (*first)[1])));
    if (report.inconsistent_edges > 0)
        remarks.push_back(
            fmt::format("edges between triangles of opposite orientation: {}",
                        report.inconsistent_edges));
    return remarks;
}

}  // namespace endmill
