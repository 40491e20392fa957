// SPDX-License-Identifier: GPL-3.0-or-later
// endmill.Mesh: triangles over shared points.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "arrays.h"
#include "endmill/core/error.h"
#include "endmill/files/mesh_file.h"
#include "endmill/mesh/mesh_checks.h"
#include "endmill/mesh/triangle_mesh.h"
#include "module.h"

namespace endmill::python {
namespace {

std::vector<Vec3> points_of(const py::handle& values)
{
    const DoubleArray array = rows(values, "points", 3);
    const auto* data = reinterpret_cast<const Vec3*>(array.data());
    std::vector<Vec3> points{data, data + array.shape(0)};
    for (const Vec3& point : points)
        for (const double coordinate : point)
            checked_length(coordinate, "points");
    return points;
}

std::vector<Triangle> triangles_of(const py::handle& values)
{
    const DoubleArray array = rows(values, "triangles", 3);
    std::vector<Triangle> triangles(static_cast<std::size_t>(array.shape(0)));
    const double* data = array.data();
    for (std::size_t k = 0; k < 3 * triangles.size(); ++k) {
        const double number = data[k];
        if (number != std::floor(number) || number < 0 ||
            number > std::numeric_limits<std::int32_t>::max())
            throw DomainError{"triangles: expected whole numbers of points, from 0"};
        triangles[k / 3][k % 3] = static_cast<std::int32_t>(number);
    }
    return triangles;
}

py::array_t<double> points(const py::object& self)
{
    const auto& mesh = self.cast<const TriangleMesh&>();
    return view(reinterpret_cast<const double*>(mesh.points().data()),
                {static_cast<py::ssize_t>(mesh.points().size()), 3},
                {sizeof(Vec3), sizeof(double)}, self);
}

py::array_t<std::int32_t> triangles(const py::object& self)
{
    const auto& mesh = self.cast<const TriangleMesh&>();
    return view(reinterpret_cast<const std::int32_t*>(mesh.triangles().data()),
                {static_cast<py::ssize_t>(mesh.triangles().size()), 3},
                {sizeof(Triangle), sizeof(std::int32_t)}, self);
}

py::dict report(const TriangleMesh& mesh)
{
    const MeshReport found = [&] {
        const py::gil_scoped_release release;
        return mesh_report(mesh);
    }();
    py::dict report;
    report["area_mm2"] = found.area;
    report["volume_mm3"] = found.volume;
    report["is_closed"] = found.closed;
    report["components"] = found.components;
    report["boundary_edges"] = found.boundary_edges;
    report["non_manifold_edges"] = found.non_manifold_edges;
    report["degenerate"] = found.degenerate_triangles;
    report["duplicates"] = found.duplicate_triangles;
    return report;
}

}  // namespace

void add_meshes(py::module_& module)
{
    py::class_<TriangleMesh>(
        module, "Mesh", only_constructed(true),
        R"(Triangles over shared points. A value that does not change.

Mesh(points, triangles)
    points: numbers (n, 3), mm. triangles: whole numbers (m, 3) of points, from 0,
    counter-clockwise seen from outside. Both are copied.
    Raises DomainError for a number that is not finite or out of range.)")
        .def(py::init([](const py::object& points, const py::object& triangles) {
                 return TriangleMesh{points_of(points), triangles_of(triangles)};
             }),
             py::arg("points"), py::arg("triangles"))
        .def_property_readonly("points", &points, "Array (n, 3), mm; a view, read-only.")
        .def_property_readonly("triangles", &triangles,
                               "Array (m, 3) of int32; a view, read-only.")
        .def("report", &report,
             "Area in mm2, volume in mm3 (None if open), and numbers of the topology.")
        .def("_text",
             [](const TriangleMesh& mesh) {
                 const py::gil_scoped_release release;
                 return mesh_text(mesh, MeshFormat::Off);
             })
        .def("__repr__", [](const TriangleMesh& mesh) {
            return "<Mesh of " + std::to_string(mesh.triangles().size()) +
                   " triangles and " + std::to_string(mesh.points().size()) + " points>";
        });
}

}  // namespace endmill::python
