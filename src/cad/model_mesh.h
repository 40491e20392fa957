// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cad/cad_model.h"

namespace endmill::cad {

/// How finely a shape is meshed.
struct MeshTolerances {
    double chord;      ///< greatest distance of a chord from a curve or a surface, mm
    double angle_rad;  ///< greatest angle between neighbouring chords
};

/// The mesh of all faces of a model.
struct ModelMesh {
    std::vector<std::array<double, 3>> points;  ///< mm
    std::vector<std::array<std::int32_t, 3>>
        triangles;                             ///< counter-clockwise from outside
    std::vector<std::int32_t> triangle_faces;  ///< face of each triangle, from 0
    std::vector<std::int32_t> unmeshed;        ///< faces without triangles, from 0
};

/// Meshes a model. Faces that share an edge share the points on it, so that the mesh is closed
/// where the model is.
/// \param model its shape receives the triangulations.
/// \throws Limit if there are more than 2^31 - 1 points.
ModelMesh mesh_of(const Model& model, const MeshTolerances& tolerances);

}  // namespace endmill::cad
