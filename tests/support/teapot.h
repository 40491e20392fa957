// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill::test {

/// Reads the teapot of 288 triangles, datasets/meshes/teapot-288.off, in mm. It has no
/// bottom, and its spout points to +x. The reader is independent of the module `files`,
/// so that the tests of modules below it can use it.
inline TriangleMesh teapot()
{
    std::ifstream file{ENDMILL_SOURCE_DIR "/datasets/meshes/teapot-288.off"};
    std::string word;
    std::size_t points = 0;
    std::size_t triangles = 0;
    file >> word >> points >> triangles >> word;
    std::vector<Vec3> places(points);
    for (Vec3& place : places)
        file >> place.x() >> place.y() >> place.z();
    std::vector<Triangle> facets(triangles);
    for (auto& [a, b, c] : facets)
        file >> word >> a >> b >> c;
    return {std::move(places), std::move(facets)};
}

}  // namespace endmill::test
