// SPDX-License-Identifier: GPL-3.0-or-later
// endmill.Surface and endmill.Part: surfaces from arrays and files, and their geometry.

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "endmill/files/part_file.h"
#include "endmill/files/surface_file.h"
#include "endmill/surface/curvature.h"
#include "endmill/surface/largest_cutter.h"
#include "endmill/surface/nurbs.h"
#include "endmill/surface/sampling.h"
#include "endmill/surface/surface.h"
#include "endmill/surface/tool_side.h"
#include "long_call.h"
#include "module.h"

namespace endmill::python {
namespace {

const Vec3 up = Vec3::UnitZ();

ToolSide side_of(const std::string& word)
{
    if (word == "up")
        return ToolSide::Up;
    if (word == "du_cross_dv")
        return ToolSide::DuCrossDv;
    if (word == "dv_cross_du")
        return ToolSide::DvCrossDu;
    throw DomainError{"tool_side: found " + word +
                      "; expected up, du_cross_dv or dv_cross_du"};
}

// A net of control points, and its numbers of columns (u) and rows (v).
struct Net {
    std::vector<Vec3> points;
    int columns;
    int rows;
};

Net net_of(const py::handle& values)
{
    const DoubleArray array = double_array(values, "control_points");
    if (array.ndim() != 3 || array.shape(2) != 3)
        throw py::value_error("control_points: found the shape " +
                              std::string{py::str(array.attr("shape"))} +
                              "; expected (rows along v, points along u, 3)");
    const auto* data = reinterpret_cast<const Vec3*>(array.data());
    Net net{{data, data + array.shape(0) * array.shape(1)},
            static_cast<int>(array.shape(1)),
            static_cast<int>(array.shape(0))};
    for (const Vec3& point : net.points)
        for (const double coordinate : point)
            checked_length(coordinate, "control_points");
    return net;
}

std::vector<double> numbers_of(const py::handle& values, const std::string& name)
{
    const DoubleArray array = numbers(values, name);
    return {array.data(), array.data() + array.size()};
}

Surface bezier(const py::object& control_points, const std::string& tool_side)
{
    const Net net = net_of(control_points);
    if (net.columns < 4 || net.columns % 3 != 1 || net.rows < 4 || net.rows % 3 != 1)
        throw DomainError{"control_points: found " + std::to_string(net.rows) + " by " +
                          std::to_string(net.columns) +
                          " points; expected 3 m + 1 by 3 n + 1 for m by n patches"};
    return composite_bezier((net.columns - 1) / 3, (net.rows - 1) / 3, net.points,
                            side_of(tool_side));
}

Surface nurbs(int degree_u, int degree_v, const py::object& knots_u,
              const py::object& knots_v, const py::object& control_points,
              const py::object& weights, const std::string& tool_side)
{
    Net net = net_of(control_points);
    Nurbs given{{degree_u, numbers_of(knots_u, "knots_u")},
                {degree_v, numbers_of(knots_v, "knots_v")},
                std::move(net.points),
                {}};
    if (given.u.points() != net.columns || given.v.points() != net.rows)
        throw DomainError{"knots: found knots for " + std::to_string(given.v.points()) +
                          " by " + std::to_string(given.u.points()) +
                          " control points; expected " + std::to_string(net.rows) +
                          " by " + std::to_string(net.columns)};
    if (!weights.is_none()) {
        const DoubleArray array = double_array(weights, "weights");
        if (array.ndim() != 2 || array.shape(0) != net.rows ||
            array.shape(1) != net.columns)
            throw py::value_error("weights: found the shape " +
                                  std::string{py::str(array.attr("shape"))} +
                                  "; expected (points along v, points along u)");
        given.weights.assign(array.data(), array.data() + array.size());
    }
    return nurbs_surface(given, side_of(tool_side));
}

Surface heights(const py::object& x, const py::object& y, const py::object& z,
                const std::string& tool_side)
{
    const std::vector<double> columns = numbers_of(x, "x");
    const std::vector<double> lines = numbers_of(y, "y");
    const DoubleArray values = double_array(z, "z");
    if (values.ndim() != 2 || values.shape(0) != static_cast<py::ssize_t>(lines.size()) ||
        values.shape(1) != static_cast<py::ssize_t>(columns.size()))
        throw py::value_error("z: found the shape " +
                              std::string{py::str(values.attr("shape"))} +
                              "; expected (length of y, length of x)");
    return height_grid(columns, lines,
                       {values.data(), static_cast<std::size_t>(values.size())},
                       side_of(tool_side));
}

// Calls work(k, u, v) for all parameters, which must lie within the ranges of the surface. The
// parameters are read once, since another thread may change them meanwhile.
template <typename Work>
void for_each_place(const Surface& surface, const DoubleArray& u, const DoubleArray& v,
                    const Work& work)
{
    const double* us = u.data();
    const double* vs = v.data();
    const auto count = static_cast<std::size_t>(u.size());
    const auto checked = [](double value, const Interval& range, const char* name) {
        if (!(range.low <= value && value <= range.high))
            throw DomainError{std::string{name} + ": found " + to_text(value) +
                              "; expected numbers from " + to_text(range.low) + " to " +
                              to_text(range.high)};
        return value;
    };
    const Interval range_u = surface.range(Parameter::U);
    const Interval range_v = surface.range(Parameter::V);
    const auto part = [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            work(k, checked(us[k], range_u, "u"), checked(vs[k], range_v, "v"));
    };
    constexpr std::size_t worth_threads = 2000;
    constexpr std::size_t long_count = 200'000;  // takes some hundredths of a second
    if (count > long_count) {
        long_call(py::none(), [&](Progress& progress) {
            for (std::size_t begin = 0; begin < count; begin += long_count) {
                const std::size_t size = std::min(long_count, count - begin);
                parallel_for(size, [&](std::size_t from, std::size_t to) {
                    part(begin + from, begin + to);
                });
                progress.report(static_cast<double>(begin + size) /
                                static_cast<double>(count));
            }
        });
        return;
    }
    const py::gil_scoped_release release;
    if (count < worth_threads)
        part(0, count);
    else
        parallel_for(count, part);
}

// A vector of three numbers for each place.
template <typename Vector>
py::array_t<double> vectors(const Surface& surface, const py::object& u,
                            const py::object& v, const Vector& vector)
{
    const auto [us, vs] = same_shape(u, "u", v, "v");
    py::array_t<double> result{shape_with(us, 3)};
    double* out = result.mutable_data();
    for_each_place(surface, us, vs, [&](std::size_t k, double at_u, double at_v) {
        const Vec3 found = vector(at_u, at_v);
        std::copy(found.data(), found.data() + 3, out + 3 * k);
    });
    return result;
}

py::array_t<double> point(const Surface& surface, const py::object& u,
                          const py::object& v)
{
    return vectors(surface, u, v, [&](double at_u, double at_v) {
        return surface.tangents(at_u, at_v).point;
    });
}

py::array_t<double> normal(const Surface& surface, const py::object& u,
                           const py::object& v)
{
    const double side = tool_side_sign(surface, up);
    return vectors(surface, u, v, [&](double at_u, double at_v) {
        return Vec3{side * unit_normal(surface.tangents(at_u, at_v))};
    });
}

py::array_t<double> curvature(const Surface& surface, const py::object& u,
                              const py::object& v)
{
    const auto [us, vs] = same_shape(u, "u", v, "v");
    const double side = tool_side_sign(surface, up);
    py::array_t<double> result{shape_with(us, 2)};
    double* out = result.mutable_data();
    for_each_place(surface, us, vs, [&](std::size_t k, double at_u, double at_v) {
        const PrincipalCurvatures found =
            principal_curvatures(fundamental_forms(surface.jet(at_u, at_v), side));
        out[2 * k] = found.least;
        out[2 * k + 1] = found.greatest;
    });
    return result;
}

py::tuple derivatives(const Surface& surface, const py::object& u, const py::object& v)
{
    const auto part = [&](Vec3 SurfaceJet::*member) {
        return vectors(surface, u, v, [&, member](double at_u, double at_v) {
            return surface.jet(at_u, at_v).*member;
        });
    };
    return py::make_tuple(part(&SurfaceJet::du), part(&SurfaceJet::dv),
                          part(&SurfaceJet::duu), part(&SurfaceJet::duv),
                          part(&SurfaceJet::dvv));
}

TriangleMesh sample(const Surface& surface, std::optional<double> chord_tolerance)
{
    const py::gil_scoped_release release;
    const std::span surfaces{&surface, 1};
    const double tolerance = chord_tolerance.value_or(default_chord_tolerance(surfaces));
    return sampled(surfaces, tool_side_signs(surfaces, up), tolerance).mesh;
}

std::optional<double> largest_ball(const Surface& surface)
{
    const py::gil_scoped_release release;
    const auto limit = largest_cutter(surface, tool_side_sign(surface, up));
    return limit ? std::optional{2 * limit->radius_mm} : std::nullopt;
}

py::tuple range(const Surface& surface, Parameter along)
{
    const Interval range = surface.range(along);
    return py::make_tuple(range.low, range.high);
}

PartFile part_from_file(const std::filesystem::path& path, const std::string& units,
                        const std::string& axis)
{
    MeshReadOptions options;
    if (units != "mm" && units != "inch")
        throw DomainError{"units: found " + units + "; expected mm or inch"};
    options.units = units == "inch" ? LengthUnit::Inch : LengthUnit::Mm;
    const auto* const known = std::ranges::find(up_axis_names, axis);
    if (known == up_axis_names.end())
        throw DomainError{"up: found " + axis + "; expected x, y, z, -x, -y or -z"};
    options.up = static_cast<UpAxis>(known - up_axis_names.begin());
    const py::gil_scoped_release release;
    return read_part(path, options);
}

py::object surfaces_of(const PartFile& part)
{
    const auto* surfaces = std::get_if<std::vector<Surface>>(&part.part);
    return surfaces ? py::cast(*surfaces) : py::list();
}

py::object mesh_of(const py::object& self)
{
    const auto& part = self.cast<const PartFile&>();
    const auto* mesh = std::get_if<TriangleMesh>(&part.part);
    return mesh ? py::cast(mesh, py::return_value_policy::reference_internal, self)
                : py::none();
}

}  // namespace

void add_surfaces(py::module_& module)
{
    const py::arg_v side{"tool_side", "up"};
    py::class_<Surface>(
        module, "Surface", only_constructed(false),
        R"(A surface in mm, as Bezier patches. A value that does not change.

Make one with Surface.bezier, Surface.nurbs or Surface.height_grid, or read a file with
read_part. tool_side is "up" (the side above), "du_cross_dv" or "dv_cross_du". Methods take
parameters u and v as numbers or as arrays that can be broadcast together; they raise
DomainError for a parameter outside the ranges.)")
        .def_static("bezier", &bezier, py::arg("control_points"), side,
                    R"(A net of bicubic Bezier patches.

control_points: (3 m + 1, 3 n + 1, 3) for m patches along v and n along u, in mm. u runs from
0 to n, v from 0 to m.)")
        .def_static("nurbs", &nurbs, py::arg("degree_u"), py::arg("degree_v"),
                    py::arg("knots_u"), py::arg("knots_v"), py::arg("control_points"),
                    py::arg("weights") = py::none(), side,
                    R"(A NURBS surface over its knot range.

control_points: (points along v, points along u, 3) in mm; weights: (points along v, points
along u), above 0, or None. There are degree + 1 more knots than points.)")
        .def_static(
            "height_grid", &heights, py::arg("x"), py::arg("y"), py::arg("z"), side,
            R"(The bicubic spline through heights: z[j, i] at (x[i], y[j]), in mm.)")
        .def("point", &point, py::arg("u"), py::arg("v"), "Points (..., 3) in mm.")
        .def("normal", &normal, py::arg("u"), py::arg("v"),
             R"(Unit normals (..., 3) on the tool's side.

Raises GeometryError where there is no normal, such as at a pole.)")
        .def("curvature", &curvature, py::arg("u"), py::arg("v"),
             R"(Principal curvatures (..., 2) in 1/mm: the least and the greatest.

Positive where the part is convex. Raises GeometryError where there is no normal.)")
        .def("derivatives", &derivatives, py::arg("u"), py::arg("v"),
             "Partial derivatives du, dv, duu, duv, dvv, five arrays (..., 3) in mm.")
        .def("sample", &sample, py::arg("chord_tolerance") = py::none(),
             R"(A Mesh no farther from the surface than chord_tolerance in mm.

Default: a thousandth of the longest side of its box, rounded down to one digit.)")
        .def(
            "largest_ball", &largest_ball,
            R"(Diameter in mm of the largest ball that fits everywhere; None if every ball fits.)")
        .def_property_readonly(
            "range_u", [](const Surface& s) { return range(s, Parameter::U); },
            "First and last u.")
        .def_property_readonly(
            "range_v", [](const Surface& s) { return range(s, Parameter::V); },
            "First and last v.")
        .def_property_readonly(
            "patches",
            [](const Surface& s) {
                return py::make_tuple(s.patches(Parameter::U), s.patches(Parameter::V));
            },
            "Numbers of patches along u and along v.")
        .def("_text",
             [](const Surface& surface, const std::string& name) {
                 return surface_text(nurbs_of(surface), surface.tool_side(), name, "");
             })
        .def("__repr__", [](const Surface& surface) {
            return "<Surface of " + std::to_string(surface.patches(Parameter::U)) +
                   " by " + std::to_string(surface.patches(Parameter::V)) + " patches>";
        });

    py::class_<PartFile>(module, "Part", py::dynamic_attr(), only_constructed(false),
                         R"(A part that read_part has read: surfaces, or a mesh.)")
        .def_readonly("name", &PartFile::name,
                      "Name in the file, or the file's own name.")
        .def_readonly("source", &PartFile::source, "Origin of the numbers, or empty.")
        .def_readonly("notes", &PartFile::notes, "A sentence for each peculiarity.")
        .def_property_readonly("surfaces", &surfaces_of,
                               "List of Surface; empty for a mesh.")
        .def_property_readonly("mesh", &mesh_of, "The Mesh; None for surfaces.")
        .def("__repr__", [](const PartFile& part) {
            const auto* surfaces = std::get_if<std::vector<Surface>>(&part.part);
            return "<Part " + part.name + ": " +
                   (surfaces ? counted(surfaces->size(), "surface") : "a mesh") + ">";
        });
    module.def("_read_part", &part_from_file, py::arg("path"), py::arg("units"),
               py::arg("up"));
}

}  // namespace endmill::python
