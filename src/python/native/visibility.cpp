// SPDX-License-Identifier: GPL-3.0-or-later
// endmill.DirectionGrid, endmill.VisibilityMap and endmill.visibility.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.h"
#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/files/read_file.h"
#include "endmill/files/visibility_file.h"
#include "endmill/visibility/sphere_grid.h"
#include "endmill/visibility/visibility.h"
#include "long_call.h"
#include "module.h"

namespace endmill::python {
namespace {

VisibilityKind kind_of(const std::string& word)
{
    if (word == "global")
        return VisibilityKind::Global;
    if (word == "local")
        return VisibilityKind::Local;
    throw DomainError{"kind: found " + word + "; expected global or local"};
}

std::vector<Vec3> directions_of(const py::object& values)
{
    const DoubleArray array = rows(values, "directions", 3);
    const auto* data = reinterpret_cast<const Vec3*>(array.data());
    return {data, data + array.shape(0)};
}

VisibilityMap visibility(const TriangleMesh& mesh, const py::object& directions,
                         double incidence_deg, const std::string& kind,
                         const py::object& progress)
{
    require_follower(progress);
    const std::vector<Vec3> copied = directions_of(directions);
    VisibilityOptions options;
    options.incidence = Angle::degrees(incidence_deg);
    options.kind = kind_of(kind);
    return long_call(progress, [&](Progress& shown) {
        options.progress = [&](std::size_t done) {
            shown.report(static_cast<double>(done) / static_cast<double>(copied.size()));
        };
        return part_visibility(mesh, copied, options).map;
    });
}

py::array_t<std::uint64_t> words(const py::object& self)
{
    const auto& map = self.cast<const VisibilityMap&>();
    const auto cells = static_cast<py::ssize_t>(map.cells());
    const auto count = static_cast<py::ssize_t>(map.words());
    const std::uint64_t* data = cells == 0 ? nullptr : map.column(0).data();
    return view(
        data, {cells, count},
        {count * static_cast<py::ssize_t>(sizeof(std::uint64_t)), sizeof(std::uint64_t)},
        self);
}

py::array_t<bool> accessible(const VisibilityMap& map)
{
    py::array_t<bool> result{std::vector<py::ssize_t>{
        static_cast<py::ssize_t>(map.facets()), static_cast<py::ssize_t>(map.cells())}};
    bool* out = result.mutable_data();
    {
        const py::gil_scoped_release release;
        for (std::size_t facet = 0; facet < map.facets(); ++facet)
            for (std::size_t cell = 0; cell < map.cells(); ++cell)
                *out++ = map.is_accessible(facet, cell);
    }
    return result;
}

py::array_t<double> numbers(const py::object& self, const std::vector<Vec3>& vectors)
{
    return view(reinterpret_cast<const double*>(vectors.data()),
                {static_cast<py::ssize_t>(vectors.size()), 3},
                {sizeof(Vec3), sizeof(double)}, self);
}

}  // namespace

void add_visibility(py::module_& module)
{
    py::class_<SphereGrid>(module, "DirectionGrid", only_constructed(true),
                           R"(The sphere of directions, divided into cells.

DirectionGrid("hex:10"): 12 F^2 cells of "hex:F" or "cube:F", 2 N (M - 1) of "latlong:NxM",
20 * 4^L of "ico:L".)")
        .def(py::init([](const std::string& name) { return sphere_grid(name); }),
             py::arg("name"))
        .def_readonly("name", &SphereGrid::name, "The name of the grid.")
        .def_property_readonly(
            "centres",
            [](const py::object& self) {
                return numbers(self, self.cast<const SphereGrid&>().centres);
            },
            "Unit centres (m, 3) of the cells; a view, read-only.")
        .def_property_readonly(
            "solid_angles_sr",
            [](const py::object& self) {
                const auto& angles = self.cast<const SphereGrid&>().solid_angles_sr;
                return view(angles.data(), {static_cast<py::ssize_t>(angles.size())},
                            {sizeof(double)}, self);
            },
            "Solid angle (m,) of each cell in sr; a view, read-only.")
        .def("__len__", [](const SphereGrid& grid) { return grid.centres.size(); })
        .def("__repr__",
             [](const SphereGrid& grid) { return "DirectionGrid('" + grid.name + "')"; });

    py::class_<VisibilityMap>(module, "VisibilityMap", only_constructed(false),
                              R"(The visibility cones of the facets of a part, as bits.)")
        .def_property_readonly("facets", &VisibilityMap::facets, "Number of facets.")
        .def_property_readonly("cells", &VisibilityMap::cells, "Number of directions.")
        .def_property_readonly("words", &words,
                               R"(Array (cells, words) of uint64; a view, read-only.

Bit j % 64 of word j / 64 is 1 where facet j is accessible along the direction of the cell.)")
        .def("accessible", &accessible,
             "Array (facets, cells) of bool: whether a facet is accessible along a "
             "direction.")
        .def("__repr__", [](const VisibilityMap& map) {
            return "<VisibilityMap of " + std::to_string(map.facets()) +
                   " facets along " + std::to_string(map.cells()) + " directions>";
        });
    module.def("visibility", &visibility, py::arg("mesh"), py::arg("directions"),
               py::arg("incidence_deg") = 90.0, py::arg("kind") = "global",
               py::arg("progress") = py::none(),
               R"(The visibility cones of the facets of a Mesh, a VisibilityMap.

directions: unit vectors (m, 3), from the part towards the spindle, such as
DirectionGrid("hex:10").centres. incidence_deg: largest angle of direction and normal, at most
90. kind: "global" (facets hide each other, decided exactly) or "local". progress: a function
of the finished share. Raises DomainError for values out of range.
Source: Kang and Suh, section 2.)");
    module.def(
        "read_visibility",
        [](const std::filesystem::path& file) {
            const py::gil_scoped_release release;
            return parse_visibility(read_file(file), file.string()).visibility.map;
        },
        py::arg("file"), "Read the VisibilityMap of a file visibility.bsm.");
}

}  // namespace endmill::python
