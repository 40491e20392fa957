// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/part_file.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/files/detail/file_format.h"
#include "endmill/files/read_file.h"
#include "endmill/files/surface_file.h"
#include "endmill/mesh/mesh_checks.h"
#include "endmill/mesh/mesh_repair.h"

// A mesh from a file may have triangles with inconsistent orientation, or closed pieces
// that are inside out. Every later step needs normals that point out of the material, so
// such meshes are corrected here, with a note. The check that a correction is needed is
// cheap; the correction is not, so the memory limit is checked in between.

namespace endmill {
namespace {

// Reads a surface file. Units and an upward axis are options of meshes only.
PartFile surface_part(const std::string& content, const std::filesystem::path& path,
                      const MeshReadOptions& options)
{
    SurfaceFile file = parse_surface(content, path, options.limits);
    if (options.units != LengthUnit::Mm || options.up != UpAxis::Z)
        throw DomainError{shown_path(path) +
                          ": --units and --up are for meshes; a surface file states its "
                          "own unit"};
    return {std::move(file.name), std::move(file.source), std::move(file.surfaces), {}, 0,
            std::nullopt,         std::move(file.notes)};
}

// "1 triangle was ", "2 triangles were ".
std::string counted_that_were(std::size_t count, const std::string& thing)
{
    return std::to_string(count) + ' ' + thing + (count == 1 ? " was " : "s were ");
}

// Whether `oriented` may have to turn triangles over. With several components, or bodies
// that touch along an edge, one may be inside out although the total volume is positive.
bool may_be_turned(const MeshReport& report)
{
    return report.inconsistent_edges > 0 || report.components > 1 ||
           report.non_manifold_edges > 0 || (report.volume && *report.volume < 0);
}

// Upper bound of the memory of `oriented` in bytes, including the mesh and its copy.
double bytes_to_orient(const TriangleMesh& mesh, const MeshReport& report)
{
    constexpr double bytes_per_point = 64;
    constexpr double bytes_per_triangle = 160;
    constexpr double bytes_per_piece = 700;
    // Pieces end at edges of more than two triangles, components do not: there are at
    // most two more pieces than components for each such edge.
    const auto pieces = std::min<std::size_t>(
        report.components + 2 * report.non_manifold_edges, mesh.triangles().size());
    return bytes_per_point * static_cast<double>(mesh.points().size()) +
           bytes_per_triangle * static_cast<double>(mesh.triangles().size()) +
           bytes_per_piece * static_cast<double>(pieces);
}

// Turns triangles over until neighbours agree and closed pieces face outwards, and adds
// notes. `report` on the mesh becomes that on the result.
void orient(MeshFile& file, MeshReport& report)
{
    OrientedMesh upright = oriented(file.mesh);
    file.mesh = std::move(upright.mesh);
    if (upright.turned_triangles > 0) {
        report = mesh_report(file.mesh);
        const bool is_solid = report.volume && *report.volume > 0;
        file.notes.push_back(
            counted_that_were(upright.turned_triangles, "triangle") +
            "turned over, so that " +
            (is_solid ? "all face outwards"
                      : "neighbours face the same side and closed pieces outwards"));
    }
    if (upright.unorientable > 0)
        file.notes.push_back(counted_that_were(upright.unorientable, "piece") +
                             "left as read, of one side only, like a Moebius strip");
}

// Whether two characters are equal without regard to case.
bool is_letter_case_apart(unsigned char a, unsigned char b)
{
    return std::tolower(a) == std::tolower(b);
}

// Whether the file is a surface file. A file named .json is read as one even if its
// content is damaged, so that the messages are about JSON.
bool is_surface(const std::string& content, const std::filesystem::path& path)
{
    const std::string extension = path.extension().string();
    return std::ranges::equal(extension, std::string_view{".json"},
                              is_letter_case_apart) ||
           recognized_format(content) == "JSON";
}

}  // namespace

// The orientation is examined first, because most meshes need no change and orienting takes
// much memory.
PartFile part_of_mesh(MeshFile mesh, const std::filesystem::path& path,
                      const ReadLimits& limits)
{
    MeshReport report = mesh_report(mesh.mesh);
    if (may_be_turned(report)) {
        require_memory(shown_path(path), bytes_to_orient(mesh.mesh, report), limits);
        orient(mesh, report);
    }
    return {std::move(mesh.name),  {},
            std::move(mesh.mesh),  std::move(mesh.degenerate_triangles),
            mesh.welded_points,    std::move(report),
            std::move(mesh.notes), std::move(mesh.face_numbers)};
}

PartFile read_part(const std::filesystem::path& path, const MeshReadOptions& options)
{
    std::string content = read_file(path, options.limits);
    return is_surface(content, path)
               ? surface_part(content, path, options)
               : part_of_mesh(parse_mesh(std::move(content), path, options), path,
                              options.limits);
}

}  // namespace endmill
