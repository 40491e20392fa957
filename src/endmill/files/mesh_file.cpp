// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <optional>
#include <utility>

#include "endmill/core/detail/units.h"
#include "endmill/core/error.h"
#include "endmill/core/orientation.h"
#include "endmill/core/text.h"
#include "endmill/files/detail/file_format.h"
#include "endmill/files/detail/obj.h"
#include "endmill/files/detail/off.h"
#include "endmill/files/detail/ply.h"
#include "endmill/files/detail/raw_mesh.h"
#include "endmill/files/detail/stl.h"
#include "endmill/files/read_file.h"
#include "endmill/mesh/detail/weld.h"

namespace endmill {
namespace {

// A mesh file becomes a MeshFile in these steps:
//
// 1. The extension selects the format; content of another known format is refused.
// 2. The reader of the format (detail/) parses the content. STL gives a triangle soup,
//    the other formats give an indexed mesh. Lengths are converted to mm.
// 3. Equal points are welded, exactly and without a tolerance. The text is released
//    first, because it is no longer needed and welding takes much memory.
// 4. Triangles without area, decided by the exact predicate `are_collinear`, and points
//    that no triangle uses are left out.
// 5. The upward axis is turned to +z.
//
// Every step that changes something adds a note.

constexpr std::array<std::string_view, 4> extensions{".stl", ".obj", ".ply", ".off"};

// Formats of other programs that are refused by name, by the extension of the file.
struct OtherFormat {
    std::string_view extension;
    std::string_view name;
};

constexpr std::array other_formats{
    OtherFormat{".3mf", "3MF"},   OtherFormat{".amf", "AMF"},
    OtherFormat{".step", "STEP"}, OtherFormat{".stp", "STEP"},
    OtherFormat{".iges", "IGES"}, OtherFormat{".igs", "IGES"},
};

// Upper bound of the memory that exact welding takes for each point (weld.h).
constexpr double bytes_per_welded_point = 72;

// ASCII letters in lower case.
std::string lower_case(std::string text)
{
    std::ranges::transform(text, text.begin(), [](unsigned char letter) {
        return static_cast<char>(std::tolower(letter));
    });
    return text;
}

// The extension of `path` in lower case, after a check that the content is of its format.
std::string checked_extension(std::string_view content, const std::string& file,
                              const std::filesystem::path& path)
{
    constexpr std::size_t longest_echo = 40;
    std::string extension = lower_case(path.extension().string());
    const auto format = recognized_format(content);
    const auto other =
        std::ranges::find(other_formats, extension, &OtherFormat::extension);
    if (other != other_formats.end())
        throw FormatError{"E_FORMAT",
                          {file, "", std::string{other->name} + " is not read here",
                           "the part as a mesh: .stl, .obj, .ply or .off"}};
    if (std::ranges::find(extensions, extension) == extensions.end()) {
        const std::string guess =
            format ? ", content looks like " + std::string{*format} : "";
        const std::string found =
            extension.empty()
                ? "no extension"
                : "unknown extension \"" + printable(extension, longest_echo) + '"';
        throw FormatError{"E_FORMAT",
                          {file, "", found + guess, one_of(extensions, extension)}};
    }
    if (format && '.' + lower_case(std::string{*format}) != extension)
        throw FormatError{"E_FORMAT",
                          {file, "", "content looks like " + std::string{*format},
                           "that of a " + extension + " file"}};
    return extension;
}

// The verb of a note about `count` things.
std::string_view was_or_were(std::size_t count)
{
    return count == 1 ? " was " : " were ";
}

// A mesh without equal points, and the notes about its reading.
struct ReadAndWelded {
    WeldedMesh welded;
    std::vector<std::string> notes;
    std::vector<std::int32_t> face_numbers;
};

// Checks that the mesh is not empty.
void require_triangles(std::size_t count, const MeshSource& source)
{
    if (count == 0)
        throw FormatError{"E_EMPTY",
                          {source.file, "", "mesh has no triangles", "at least one"}};
}

// Reads an STL file. `content` is released before welding to lower the peak memory.
ReadAndWelded read_soup(std::string& content, const MeshSource& source)
{
    const std::vector<std::array<Vec3, 3>> soup = parse_stl(source);
    std::string{}.swap(content);
    require_triangles(soup.size(), source);
    const auto triangles = static_cast<double>(soup.size());
    require_memory(
        source.file,
        triangles * (sizeof soup[0] + sizeof(Triangle) + 3 * bytes_per_welded_point),
        source.limits);
    return {weld(soup), {}, {}};
}

// Parses a mesh with indexed points.
RawMesh parse_indexed(const MeshSource& source, std::string_view extension)
{
    if (extension == ".obj")
        return parse_obj(source);
    return extension == ".ply" ? parse_ply(source) : parse_off(source);
}

// Welds a mesh with indexed points.
ReadAndWelded welded_with_notes(RawMesh raw, const MeshSource& source)
{
    require_triangles(raw.mesh.triangles().size(), source);
    const auto points = static_cast<double>(raw.mesh.points().size());
    const auto triangles = static_cast<double>(raw.mesh.triangles().size());
    require_memory(
        source.file,
        points * (sizeof(Vec3) + sizeof(std::int32_t) + bytes_per_welded_point) +
            triangles * 2 * sizeof(Triangle),
        source.limits);
    ReadAndWelded result{weld(raw.mesh), std::move(raw.notes),
                         std::move(raw.face_numbers)};
    const std::size_t welded = result.welded.welded_points;
    if (welded > 0)
        result.notes.push_back(counted(welded, "point") + " at the place of another" +
                               std::string{was_or_were(welded)} + "welded to it");
    if (raw.split_faces > 0)
        result.notes.push_back(
            counted(raw.split_faces, "face") + " of more than 3 corners" +
            std::string{was_or_were(raw.split_faces)} + "split into triangles, corners " +
            to_text(raw.out_of_plane_mm) + " mm out of plane at most");
    return result;
}

// Reads an OBJ, PLY or OFF file. `content` is released as in `read_soup`.
ReadAndWelded read_indexed(std::string& content, const MeshSource& source,
                           std::string_view extension)
{
    RawMesh raw = parse_indexed(source, extension);
    std::string{}.swap(content);
    return welded_with_notes(std::move(raw), source);
}

// Turns the axis `up` to +z by a quarter or half turn about x or y, which is exact.
// Subtraction from 0 keeps a zero coordinate from becoming -0.
Vec3 turned(const Vec3& point, UpAxis up)
{
    const double x = point.x();
    const double y = point.y();
    const double z = point.z();
    switch (up) {
        case UpAxis::X:
            return {0 - z, y, x};
        case UpAxis::Y:
            return {x, 0 - z, y};
        case UpAxis::MinusX:
            return {z, y, 0 - x};
        case UpAxis::MinusY:
            return {x, z, 0 - y};
        case UpAxis::MinusZ:
            return {x, 0 - y, 0 - z};
        default:
            return point;
    }
}

// The triangles of a mesh by whether they have an area.
struct SortedTriangles {
    std::vector<Triangle> sound;          // with an area
    std::vector<std::size_t> degenerate;  // indices of the others
};

// Divides the triangles by an exact test, so that the result does not depend on rounding.
SortedTriangles sorted_triangles(const TriangleMesh& mesh)
{
    SortedTriangles sorted;
    sorted.sound.reserve(mesh.triangles().size());
    constexpr std::size_t triangles_ahead = 12;
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
        mesh.prefetch_corners(i + triangles_ahead);
        const auto [a, b, c] = mesh.corners(i);
        if (are_collinear(a, b, c))
            sorted.degenerate.push_back(i);
        else
            sorted.sound.push_back(mesh.triangles()[i]);
    }
    return sorted;
}

// The points with `up` turned to +z.
std::vector<Vec3> all_points(std::span<const Vec3> points, UpAxis up)
{
    std::vector<Vec3> all;
    all.reserve(points.size());
    for (const Vec3& point : points)
        all.push_back(turned(point, up));
    return all;
}

// The points that the triangles use, with `up` turned to +z. The triangles are renumbered
// accordingly.
std::vector<Vec3> used_points(std::span<const Vec3> points,
                              std::vector<Triangle>& triangles, UpAxis up)
{
    constexpr std::int32_t unused = -1;
    std::vector<std::int32_t> numbers(points.size(), unused);
    for (const Triangle& triangle : triangles)
        for (const std::int32_t corner : triangle)
            numbers[corner] = 0;
    std::vector<Vec3> used;
    used.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (numbers[i] == unused)
            continue;
        numbers[i] = static_cast<std::int32_t>(used.size());
        used.push_back(turned(points[i], up));
    }
    for (Triangle& triangle : triangles)
        for (std::int32_t& corner : triangle)
            corner = numbers[corner];
    return used;
}

// The note about things that were left out.
std::string left_out(std::size_t count, const std::string& thing, const char* kind)
{
    return counted(count, thing) + ' ' + kind + std::string{was_or_were(count)} +
           "left out";
}

// Notes about conversions that the options asked for.
std::vector<std::string> option_notes(const MeshReadOptions& options)
{
    std::vector<std::string> notes;
    if (options.units == LengthUnit::Inch)
        notes.emplace_back("lengths were converted from inch to mm");
    if (options.up != UpAxis::Z)
        notes.push_back("the axis " +
                        std::string{up_axis_names[static_cast<int>(options.up)]} +
                        " of the file was turned to +z");
    return notes;
}

// Removes the items with these indices, which rise; nothing if there are no items.
void leave_out(std::vector<std::int32_t>& items, std::span<const std::size_t> indices)
{
    if (items.empty() || indices.empty())
        return;
    std::size_t next = 0;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (next < indices.size() && indices[next] == i)
            ++next;
        else
            items[kept++] = items[i];
    }
    items.resize(kept);
}

// Whether every point of a mesh is a corner, as those of separate triangles are.
enum class AreAllPointsUsed { No, Yes };

// Leaves out what has no area or is not used, and turns the upward axis.
MeshFile finished(ReadAndWelded read, const std::filesystem::path& path,
                  const MeshReadOptions& options,
                  AreAllPointsUsed used = AreAllPointsUsed::No)
{
    const std::string file = shown_path(path);
    auto& [welded, notes, face_numbers] = read;
    const TriangleMesh& all = welded.mesh;
    auto [triangles, without_area] = sorted_triangles(all);
    const std::size_t degenerate = without_area.size();
    if (triangles.empty())
        throw FormatError{
            "E_DEGENERATE",
            {file, "",
             degenerate == 1
                 ? "the only triangle has no area"
                 : "none of the " + counted(degenerate, "triangle") + " has an area",
             "triangles whose corners are not on one line"}};
    const bool are_all_used = used == AreAllPointsUsed::Yes && degenerate == 0;
    std::vector<Vec3> points = are_all_used
                                   ? all_points(all.points(), options.up)
                                   : used_points(all.points(), triangles, options.up);
    const std::size_t unused = all.points().size() - points.size();
    if (degenerate > 0)
        notes.push_back(left_out(degenerate, "triangle", "without an area"));
    if (unused > 0)
        notes.push_back(left_out(unused, "point", "that no triangle uses"));
    std::ranges::copy(option_notes(options), std::back_inserter(notes));
    leave_out(face_numbers, without_area);
    return {printable(path.stem().string()),
            {std::move(points), std::move(triangles)},
            welded.welded_points,
            std::move(without_area),
            std::move(notes),
            std::move(face_numbers)};
}

}  // namespace

MeshFile read_mesh(const std::filesystem::path& path, const MeshReadOptions& options)
{
    return parse_mesh(read_file(path, options.limits), path, options);
}

MeshFile parse_mesh(std::string content, const std::filesystem::path& path,
                    const MeshReadOptions& options)
{
    const std::string file = shown_path(path);
    const std::string extension = checked_extension(content, file, path);
    const double unit = options.units == LengthUnit::Inch ? mm_per_inch : 1;
    const MeshSource source{content, file, options.limits, unit};
    if (extension == ".stl")
        return finished(read_soup(content, source), path, options, AreAllPointsUsed::Yes);
    return finished(read_indexed(content, source, extension), path, options);
}

MeshFile treated_mesh(TriangleMesh mesh, std::vector<std::int32_t> face_numbers,
                      const std::filesystem::path& path, const MeshReadOptions& options)
{
    const MeshSource source{{}, shown_path(path), options.limits};
    return finished(
        welded_with_notes({std::move(mesh), 0, 0, {}, std::move(face_numbers)}, source),
        path, options);
}
std::string_view mesh_extension(MeshFormat format)
{
    switch (format) {
        case MeshFormat::Obj:
            return ".obj";
        case MeshFormat::Ply:
            return ".ply";
        case MeshFormat::Off:
            return ".off";
        default:
            return ".stl";
    }
}

std::string mesh_text(const TriangleMesh& mesh, MeshFormat format,
                      std::span<const Vec3> normals,
                      std::span<const std::int32_t> face_numbers)
{
    switch (format) {
        case MeshFormat::Stl:
            return stl_text(mesh);
        case MeshFormat::StlAscii:
            return stl_ascii_text(mesh);
        case MeshFormat::Obj:
            return obj_text(mesh);
        case MeshFormat::Ply:
            return ply_text(mesh, normals, face_numbers);
        default:
            return off_text(mesh);
    }
}

}  // namespace endmill
