// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/mesh_file.h"

#include "endmill/files/detail/obj.h"
#include "endmill/files/detail/off.h"
#include "endmill/files/detail/ply.h"
#include "endmill/files/detail/stl.h"

namespace endmill {

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

std::string mesh_text(const TriangleMesh& mesh, MeshFormat format)
{
    switch (format) {
        case MeshFormat::Stl:
            return stl_text(mesh);
        case MeshFormat::StlAscii:
            return stl_ascii_text(mesh);
        case MeshFormat::Obj:
            return obj_text(mesh);
        case MeshFormat::Ply:
            return ply_text(mesh);
        default:
            return off_text(mesh);
    }
}

}  // namespace endmill
