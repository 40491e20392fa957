// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/dataset_mesh.h"

#include <utility>
#include <vector>

#include <Eigen/LU>

#include "endmill/files/mesh_file.h"

namespace endmill {

TriangleMesh dataset_mesh(const std::string& file)
{
    return read_mesh("datasets/meshes/" + file).mesh;
}

TriangleMesh moved(const TriangleMesh& mesh, const Eigen::Matrix3d& motion)
{
    std::vector<Vec3> points;
    for (const Vec3& point : mesh.points())
        points.emplace_back(motion * point);
    std::vector<Triangle> triangles{mesh.triangles().begin(), mesh.triangles().end()};
    if (motion.determinant() < 0)
        for (Triangle& triangle : triangles)
            std::swap(triangle[1], triangle[2]);
    return {std::move(points), std::move(triangles)};
}

}  // namespace endmill
