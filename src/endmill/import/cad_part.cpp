// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/import/cad_part.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

// Whether the model serves as a surface.
bool is_surface(const CadPart& part)
{
    return part.faces.size() == 1 && part.solids == 0 && part.faces.front().surface;
}

}  // namespace

ToolSide tool_side(const CadPart& part, const CadFace& face)
{
    if (part.solids == 0)
        return ToolSide::Up;
    return face.is_reversed ? ToolSide::DvCrossDu : ToolSide::DuCrossDv;
}

void require_faces(std::span<const int> chosen, std::size_t faces,
                   const std::string& file)
{
    for (const int number : chosen)
        if (number < 1 || static_cast<std::size_t>(number) > faces)
            throw DomainError{"--face " + std::to_string(number) + ": " + file + " has " +
                              counted(faces, "face") + "; expected 1" +
                              (faces == 1 ? "" : " to " + std::to_string(faces))};
}

Vec3 centre_of_mass(const TriangleMesh& mesh, bool is_solid)
{
    // Tetrahedra over the triangles from a corner of the mesh, or the triangles themselves.
    Vec3 sum = Vec3::Zero();
    double mass = 0;
    const Vec3 origin = mesh.points().empty() ? Vec3{0, 0, 0} : mesh.points().front();
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        const auto [a, b, c] = mesh.corners(k);
        const Vec3 cross = (b - a).cross(c - a);
        const double weight = is_solid ? cross.dot(a - origin) : cross.norm();
        sum += weight * (a + b + c - 3 * origin) / (is_solid ? 4 : 3);
        mass += weight;
    }
    return mass == 0 ? origin : Vec3{origin + sum / mass};
}

MeshFile mesh_of_faces(const CadPart& part, std::span<const int> chosen,
                       const std::filesystem::path& path, const MeshReadOptions& options)
{
    require_faces(chosen, part.faces.size(), shown_path(path));
    std::vector<char> is_chosen(part.faces.size(), chosen.empty() ? 1 : 0);
    for (const int number : chosen)
        is_chosen[static_cast<std::size_t>(number) - 1] = 1;
    std::vector<Triangle> triangles;
    std::vector<std::int32_t> numbers;
    for (std::size_t k = 0; k < part.triangle_faces.size(); ++k) {
        const std::int32_t face = part.triangle_faces[k];
        if (!is_chosen[static_cast<std::size_t>(face)])
            continue;
        triangles.push_back(part.mesh.triangles()[k]);
        numbers.push_back(face + 1);
    }
    const auto points = part.mesh.points();
    MeshFile file = treated_mesh({{points.begin(), points.end()}, std::move(triangles)},
                                 std::move(numbers), path, options);
    if (!chosen.empty())  // points of the other faces are no peculiarity
        std::erase_if(file.notes, [](const std::string& note) {
            return note.find("that no triangle uses") != std::string::npos;
        });
    return file;
}

PartFile part_of_cad(const CadPart& part, const std::filesystem::path& path,
                     const MeshReadOptions& options)
{
    PartFile file;
    if (is_surface(part) && options.up == UpAxis::Z) {
        file = {printable(path.stem().string()), {}, {}, {}, 0, std::nullopt, {}};
        const CadFace& face = part.faces.front();
        file.part =
            std::vector<Surface>{nurbs_surface(*face.surface, tool_side(part, face))};
    } else {
        file = part_of_mesh(mesh_of_faces(part, {}, path, options), path, options.limits);
    }
    file.notes.insert(file.notes.begin(), part.notes.begin(), part.notes.end());
    return file;
}

}  // namespace endmill
