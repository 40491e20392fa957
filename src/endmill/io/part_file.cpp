// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/io/part_file.h"

#include <utility>

#include "endmill/core/error.h"
#include "endmill/io/file_format.h"
#include "endmill/io/read_file.h"
#include "endmill/io/surface_file.h"
#include "endmill/mesh/mesh_checks.h"
#include "endmill/mesh/mesh_repair.h"

namespace endmill {
namespace {

PartFile surface_part(const std::string& content, const std::filesystem::path& path,
                      const MeshReadOptions& options)
{
    SurfaceFile file = parse_surface(content, path, options.limits);
    if (options.units != LengthUnit::Mm || options.up != UpAxis::Z)
        throw DomainError{shown_path(path) +
                          ": --units and --up are for meshes; a surface file says its "
                          "unit itself"};
    return {std::move(file.name), std::move(file.source), std::move(file.surfaces), 0, 0,
            std::move(file.notes)};
}

PartFile mesh_part(std::string content, const std::filesystem::path& path,
                   const MeshReadOptions& options)
{
    MeshFile file = parse_mesh(std::move(content), path, options);
    const MeshReport report = mesh_report(file.mesh);
    if (report.inconsistent_edges > 0 || (report.volume && *report.volume < 0)) {
        OrientedMesh upright = oriented(file.mesh);
        file.mesh = std::move(upright.mesh);
        if (upright.turned_triangles > 0)
            file.notes.push_back(
                std::to_string(upright.turned_triangles) +
                " triangles were turned over, so that all face outwards");
    }
    return {std::move(file.name), {},
            std::move(file.mesh), file.degenerate_triangles,
            file.welded_points,   std::move(file.notes)};
}

// A file named for a surface is read as one, so that its faults are told as such.
bool is_surface(const std::string& content, const std::filesystem::path& path)
{
    return path.extension() == ".json" || recognized_format(content) == "JSON";
}

}  // namespace

PartFile read_part(const std::filesystem::path& path, const MeshReadOptions& options)
{
    std::string content = read_file(path, options.limits);
    return is_surface(content, path) ? surface_part(content, path, options)
                                     : mesh_part(std::move(content), path, options);
}

}  // namespace endmill
