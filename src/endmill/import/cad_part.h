// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "endmill/files/part_file.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/surface/nurbs.h"

/// \file
/// The content of a STEP or IGES file, in mm.

namespace endmill {

/// A face of a CAD model.
struct CadFace {
    std::string
        kind;  ///< plane, cylinder, cone, sphere, torus, bezier, nurbs, revolution,
               ///< extrusion, offset or other
    bool is_trimmed;   ///< whether its outline is not that of its rectangle of parameters
    bool is_reversed;  ///< whether its normal is opposite to du x dv
    std::string name;  ///< as the file gives it; empty without one
    std::string colour;            ///< "#rrggbb"; empty without one
    std::optional<Nurbs> surface;  ///< the same geometry; only if it is not trimmed
};

/// The largest balls that the curvature of a face admits, mm; nothing where it sets no limit.
struct CadFaceBalls {
    std::optional<double> outside;  ///< on the outer side of the face
    std::optional<double> inside;   ///< on the other side
};

/// Measures of a CAD model by the integrals of the CAD library over its faces, accurate to about
/// 1e-5.
struct CadMeasures {
    std::vector<double> face_areas_mm2;  ///< of each face
    /// Of each trimmed face, at the points of its mesh and the middles of its triangles; nothing
    /// for other faces.
    std::vector<std::optional<CadFaceBalls>> trimmed_balls;
    double area_mm2;                   ///< of all faces
    std::optional<double> volume_mm3;  ///< of the solids; nothing without solids
    Vec3 centre_mm;  ///< centre of mass of the solids, or without solids of the faces
};

/// A CAD model: its faces and a mesh of all of them. Faces are numbered from 1 in messages and
/// files, as CAD programs do, and from 0 here.
struct CadPart {
    std::string unit;  ///< of lengths in the file, as it names it; empty if it names none
    bool is_sewn;      ///< whether separate faces of the file were sewn
    std::size_t lost_faces;                    ///< faces of the file that cannot be read
    std::size_t solids;                        ///< number of them
    std::size_t shells;                        ///< outside of solids
    TriangleMesh mesh;                         ///< of all faces
    std::vector<std::int32_t> triangle_faces;  ///< the face of each triangle, from 0
    std::vector<CadFace> faces;                ///< at least one
    std::vector<std::size_t> unmeshed_faces;   ///< those without triangles, from 0
    std::optional<CadMeasures> measures;       ///< only if they were asked for
    std::vector<std::string> notes;            ///< one sentence for each peculiarity
};

/// The side of the tool for a face: outside, or above if the part is a sheet.
ToolSide tool_side(const CadPart& part, const CadFace& face);

/// Checks a choice of faces.
/// \param chosen numbers from 1. \param file for the message.
/// \throws DomainError if a number is not that of a face.
void require_faces(std::span<const int> chosen, std::size_t faces,
                   const std::string& file);

/// The centre of mass of the inside of a closed mesh, or of a sheet, in mm.
Vec3 centre_of_mass(const TriangleMesh& mesh, bool is_solid);

/// The mesh of some faces with face numbers from 1, treated like that of a mesh file.
/// \param chosen numbers from 1; empty: all faces.
/// \param path   of the CAD file, for messages and the name.
/// \throws FormatError, LimitError as `treated_mesh`; DomainError as `require_faces`.
MeshFile mesh_of_faces(const CadPart& part, std::span<const int> chosen,
                       const std::filesystem::path& path,
                       const MeshReadOptions& options = {});

/// The CAD model as a part: the surface of its only face if that is an open sheet with a
/// surface, else its mesh. Notes of the model become notes of the part.
/// \throws as `mesh_of_faces` and `part_of_mesh`.
PartFile part_of_cad(const CadPart& part, const std::filesystem::path& path,
                     const MeshReadOptions& options = {});

}  // namespace endmill
