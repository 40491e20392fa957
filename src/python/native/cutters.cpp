// SPDX-License-Identifier: GPL-3.0-or-later
// endmill.Cutter and endmill.DropCutter.

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/operators.h>
#include <pybind11/pybind11.h>

#include "arrays.h"
#include "endmill/core/error.h"
#include "endmill/cutter/cutter.h"
#include "endmill/drop_cutter/drop_cutter.h"
#include "long_call.h"
#include "module.h"

namespace endmill::python {
namespace {

Cutter cutter_of(const std::string& word)
{
    if (const auto cutter = cutter_from_word(word))
        return *cutter;
    throw DomainError{"Cutter: found " + word + "; expected " + expected_cutter(word)};
}

// Positions are copied, checked and lowered in blocks of this size, so that another thread may
// change them and no second array is needed.
constexpr std::size_t block = 65536;

void lower(const DropCutter& drop, const double* xy, std::size_t count, double* heights,
           Progress* progress)
{
    std::vector<Eigen::Vector2d> places;
    for (std::size_t begin = 0; begin < count; begin += block) {
        const std::size_t size = std::min(block, count - begin);
        places.clear();
        for (std::size_t k = begin; k < begin + size; ++k)
            places.emplace_back(checked_length(xy[2 * k], "places"),
                                checked_length(xy[2 * k + 1], "places"));
        std::ranges::copy(drop.tip_heights(places), heights + begin);
        if (progress)
            progress->report(static_cast<double>(begin + size) /
                             static_cast<double>(count));
    }
}

py::array_t<double> heights(const DropCutter& drop, const py::object& places,
                            const py::object& progress)
{
    require_follower(progress);
    const HeldDoubles xy = rows(places, "places", 2);
    const auto count = static_cast<std::size_t>(xy.shape(0));
    py::array_t<double> result{xy.shape(0)};
    const double* from = xy.data();
    double* to = result.mutable_data();
    if (count <= block && progress.is_none()) {
        const py::gil_scoped_release release;
        lower(drop, from, count, to, nullptr);
    } else {
        long_call(progress,
                  [&](Progress& shown) { lower(drop, from, count, to, &shown); });
    }
    return result;
}

}  // namespace

void add_cutters(py::module_& module)
{
    py::class_<Cutter>(module, "Cutter", only_constructed(true),
                       R"(An end mill. Lengths in mm.

Cutter("ball:10"), Cutter("flat:8") or Cutter("bull:10:2") (diameter, corner radius); the same
as on the command line.)")
        .def(py::init(&cutter_of), py::arg("word"))
        .def_property_readonly("radius", &Cutter::radius, "Radius, mm.")
        .def_property_readonly("corner_radius", &Cutter::corner_radius,
                               "Radius of the corner circle, mm.")
        .def("profile", &Cutter::profile, py::arg("distance"),
             "Height in mm of the cutter above its tip at a distance in mm from its "
             "axis; inf beyond its "
             "radius.")
        .def(py::self == py::self)
        .def("__hash__",
             [](const Cutter& cutter) { return py::hash(py::str(cutter_word(cutter))); })
        .def("__str__", &cutter_word)
        .def("__repr__", [](const Cutter& cutter) {
            return "Cutter('" + cutter_word(cutter) + "')";
        });
    py::class_<DropCutter>(module, "DropCutter", only_constructed(true),
                           R"(A cutter that is lowered along -z onto a mesh.

DropCutter(mesh, cutter). It is prepared once and then answers for any number of positions.)")
        .def(py::init([](const TriangleMesh& mesh, const py::object& cutter) {
                 const Cutter shape = py::isinstance<py::str>(cutter)
                                          ? cutter_of(cutter.cast<std::string>())
                                          : cutter.cast<Cutter>();
                 const py::gil_scoped_release release;
                 return std::make_unique<DropCutter>(mesh, shape);
             }),
             py::arg("mesh"), py::arg("cutter"), py::keep_alive<1, 2>())
        .def("heights", &heights, py::arg("places"), py::arg("progress") = py::none(),
             R"(Heights (n,) of the tip in mm where the cutter rests on the mesh.

places: (n, 2), x and y of the axis in mm. -inf where no triangle is below the cutter. An array
of doubles is used without a copy. progress: a function of the finished share.
Accuracy: 1e-9 mm. Raises DomainError for a position that is not finite.)");
}

}  // namespace endmill::python
