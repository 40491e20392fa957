// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "endmill/core/error.h"
#include "endmill/core/orientation.h"
#include "endmill/files/mesh_file.h"

namespace endmill {

/// Aborts, which the fuzzer reports as a finding, unless `holds`.
inline void must(bool holds)
{
    if (!holds)
        std::abort();
}

inline bool are_same(const TriangleMesh& a, const TriangleMesh& b)
{
    return std::ranges::equal(a.points(), b.points()) &&
           std::ranges::equal(a.triangles(), b.triangles());
}

/// Parses the bytes as the content of the file `path`. The mesh is valid and survives
/// writing and reading, or the reader throws a documented error.
inline int fuzz_mesh(const std::uint8_t* bytes, std::size_t size, const char* path)
{
    const MeshReadOptions options{.limits = {.max_memory_gib = 0.25}};
    try {
        const TriangleMesh mesh =
            parse_mesh({reinterpret_cast<const char*>(bytes), size}, path, options).mesh;
        must(!mesh.triangles().empty());
        for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
            const auto [a, b, c] = mesh.corners(i);
            must(!are_collinear(a, b, c));
        }
        for (const MeshFormat format : {MeshFormat::Ply, MeshFormat::Off}) {
            const std::string name = "f" + std::string{mesh_extension(format)};
            must(are_same(parse_mesh(mesh_text(mesh, format), name).mesh, mesh));
        }
        const TriangleMesh ascii =
            parse_mesh(mesh_text(mesh, MeshFormat::StlAscii), "f.stl").mesh;
        must(ascii.triangles().size() == mesh.triangles().size());
    } catch (const FormatError& error) {
        must(std::string{error.what()}.find_first_of("\n\x1b") == std::string::npos);
    } catch (const LimitError&) {
    }
    return 0;
}

}  // namespace endmill
