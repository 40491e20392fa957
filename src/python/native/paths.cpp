// SPDX-License-Identifier: GPL-3.0-or-later
// endmill.ToolPath: tips, axes and moves as arrays.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.h"
#include "endmill/core/error.h"
#include "endmill/files/path_file.h"
#include "endmill/path/tool_path.h"
#include "module.h"

namespace endmill::python {
namespace {

// The words of all moves, in the order of the enumeration.
std::vector<std::string> move_words()
{
    std::vector<std::string> words;
    for (const Move move :
         {Move::Cut, Move::Link, Move::Rapid, Move::Plunge, Move::Retract})
        words.emplace_back(move_name(move));
    return words;
}

// Vectors that every point has, as a view.
py::array_t<double> vectors(const py::object& self, Vec3 CutterLocation::*member)
{
    const auto& path = self.cast<const ToolPath&>();
    const auto count = static_cast<py::ssize_t>(path.points.size());
    const double* data =
        count == 0 ? nullptr : (path.points.front().location.*member).data();
    return view(data, {count, 3}, {sizeof(PathPoint), sizeof(double)}, self);
}

// Integers that every point has, as a view.
py::array_t<int> integers(const py::object& self, int PathPoint::*member)
{
    const auto& path = self.cast<const ToolPath&>();
    const auto count = static_cast<py::ssize_t>(path.points.size());
    const int* data = count == 0 ? nullptr : &(path.points.front().*member);
    return view(data, {count}, {sizeof(PathPoint)}, self);
}

py::object moves(const ToolPath& path)
{
    py::array_t<std::uint8_t> numbers{static_cast<py::ssize_t>(path.points.size())};
    std::uint8_t* out = numbers.mutable_data();
    for (const PathPoint& point : path.points)
        *out++ = static_cast<std::uint8_t>(point.move);
    return py::array{py::cast(move_words())}[numbers];
}

// Vectors that some points have; NaN for the others.
template <typename Known>
py::array_t<double> known_vectors(const ToolPath& path, const Known& known)
{
    py::array_t<double> result{
        std::vector<py::ssize_t>{static_cast<py::ssize_t>(path.points.size()), 3}};
    double* out = result.mutable_data();
    for (const PathPoint& point : path.points) {
        const Vec3* vector = known(point);
        for (int k = 0; k < 3; ++k)
            *out++ = vector ? (*vector)[k] : std::numeric_limits<double>::quiet_NaN();
    }
    return result;
}

py::array_t<double> settings(const ToolPath& path,
                             std::optional<double> CuttingConditions::*member)
{
    py::array_t<double> result{static_cast<py::ssize_t>(path.points.size())};
    double* out = result.mutable_data();
    for (const PathPoint& point : path.points)
        *out++ =
            (point.conditions.*member).value_or(std::numeric_limits<double>::quiet_NaN());
    return result;
}

Move move_of(const std::string& word)
{
    if (const std::optional<Move> move = move_from_name(word))
        return *move;
    throw DomainError{"moves: found " + word +
                      "; expected cut, link, rapid, plunge or retract"};
}

py::value_error wrong_count(const std::string& name, py::ssize_t found, py::ssize_t count)
{
    return py::value_error(name + ": found " + std::to_string(found) +
                           " values; expected " + std::to_string(count) +
                           ", one for each tip");
}

// Rows of a vector for each of `count` points, or nothing.
std::optional<HeldDoubles> vectors_for(const py::object& values, const char* name,
                                       py::ssize_t count)
{
    if (values.is_none())
        return std::nullopt;
    HeldDoubles array = rows(values, name, 3);
    if (array.shape(0) != count)
        throw wrong_count(name, array.shape(0), count);
    return array;
}

int pass_number(double value)
{
    if (value != std::floor(value) || value < 0 ||
        value > std::numeric_limits<int>::max())
        throw DomainError{"passes: expected whole numbers from 0"};
    return static_cast<int>(value);
}

ToolPath path_of(const py::object& tips, const py::object& axes, const py::object& moves,
                 const py::object& passes, const py::object& feeds)
{
    const DoubleArray places = rows(tips, "tips", 3);
    const py::ssize_t count = places.shape(0);
    const auto directions = vectors_for(axes, "axes", count);
    const auto listed = [&](const py::object& values, const char* name) {
        std::optional<HeldDoubles> array;
        if (values.is_none())
            return array;
        array = numbers(values, name);
        if (array->shape(0) != count)
            throw wrong_count(name, array->shape(0), count);
        return array;
    };
    const std::optional<HeldDoubles> pass_numbers = listed(passes, "passes");
    const std::optional<HeldDoubles> speeds = listed(feeds, "feeds");
    py::list words;
    if (!moves.is_none()) {
        words = py::list(moves);
        if (static_cast<py::ssize_t>(words.size()) != count)
            throw wrong_count("moves", static_cast<py::ssize_t>(words.size()), count);
    }
    const bool has_moves = !moves.is_none();
    ToolPath path;
    path.points.reserve(static_cast<std::size_t>(count));
    int number = 0;
    for (py::ssize_t k = 0; k < count; ++k) {
        const auto row = [k](const DoubleArray& array, const char* name) {
            const double* at = array.data() + 3 * k;
            return Vec3{checked_length(at[0], name), checked_length(at[1], name),
                        checked_length(at[2], name)};
        };
        const Vec3 axis = directions ? row(*directions, "axes") : Vec3{Vec3::UnitZ()};
        constexpr double unit_tolerance = 1e-6;  // of files too
        if (std::abs(axis.norm() - 1) > unit_tolerance)
            throw DomainError{"axes: row " + std::to_string(k) +
                              " is no unit vector; expected the length 1 to 1e-6"};
        const int pass = pass_numbers ? pass_number(pass_numbers->data()[k]) : 0;
        number = k > 0 && path.points.back().pass == pass ? number + 1 : 0;
        PathPoint point{pass,
                        number,
                        has_moves ? move_of(py::str(words[k])) : Move::Cut,
                        0,
                        {row(places, "tips"), axis}};
        if (speeds && !std::isnan(speeds->data()[k])) {
            const double speed = speeds->data()[k];
            if (!(speed > 0 && std::isfinite(speed)))
                throw DomainError{
                    "feeds: expected finite numbers above 0 in mm/min, or NaN"};
            point.conditions.feed_mm_per_min = speed;
        }
        path.points.push_back(point);
    }
    return path;
}

py::dict totals(const ToolPath& path)
{
    const PathTotals found = path_totals(path);
    py::dict totals;
    totals["cut_mm"] = found.cut_mm;
    totals["link_mm"] = found.link_mm;
    totals["plunge_mm"] = found.plunge_mm;
    totals["rapid_mm"] = found.rapid_mm;
    totals["time_min"] = found.time_min;
    return totals;
}

}  // namespace

void add_paths(py::module_& module)
{
    py::class_<ToolPath>(
        module, "ToolPath", only_constructed(true),
        R"(A tool path: points in the order in which the cutter reaches them.

ToolPath(tips, axes=None, moves=None, passes=None, feeds=None)
    tips: (n, 3), mm, the lowest point of the cutter on its axis. axes: (n, 3), unit, from the
    tip to the spindle; default +z. moves: n words cut, link, rapid, plunge or retract, how the
    cutter comes to each point; default cut. passes: n whole numbers. feeds: n numbers in
    mm/min, NaN where unknown.)")
        .def(py::init(&path_of), py::arg("tips"), py::arg("axes") = py::none(),
             py::arg("moves") = py::none(), py::arg("passes") = py::none(),
             py::arg("feeds") = py::none())
        .def_property_readonly(
            "tips",
            [](const py::object& self) { return vectors(self, &CutterLocation::tip); },
            "Tips (n, 3) in mm; a view, read-only.")
        .def_property_readonly(
            "axes",
            [](const py::object& self) { return vectors(self, &CutterLocation::axis); },
            "Unit axes (n, 3); a view, read-only.")
        .def_property_readonly(
            "passes",
            [](const py::object& self) { return integers(self, &PathPoint::pass); },
            "Numbers (n,) of the passes; a view, read-only.")
        .def_property_readonly(
            "patches",
            [](const py::object& self) { return integers(self, &PathPoint::patch); },
            "Numbers (n,) of the surfaces; a view, read-only.")
        .def_property_readonly("moves", &moves,
                               "Words (n,): how the cutter comes to each point.")
        .def_property_readonly(
            "contacts",
            [](const ToolPath& path) {
                return known_vectors(path, [](const PathPoint& point) {
                    const SurfaceContact* contact = point.contact();
                    return contact ? &contact->contact.point : nullptr;
                });
            },
            "Contacts (n, 3) in mm; NaN where unknown.")
        .def_property_readonly(
            "normals",
            [](const ToolPath& path) {
                return known_vectors(
                    path, [](const PathPoint& point) { return point.normal(); });
            },
            "Unit normals (n, 3) at the contacts; NaN where unknown.")
        .def_property_readonly(
            "feeds",
            [](const ToolPath& path) {
                return settings(path, &CuttingConditions::feed_mm_per_min);
            },
            "Feeds (n,) in mm/min of the moves to the points; NaN where unknown.")
        .def_property_readonly(
            "spindle_speeds",
            [](const ToolPath& path) {
                return settings(path, &CuttingConditions::spindle_rpm);
            },
            "Spindle speeds (n,) in rpm; NaN where unknown.")
        .def("totals", &totals,
             "Lengths in mm along the tip, and the time in min or None.")
        .def(
            "csv",
            [](const ToolPath& path) {
                const py::gil_scoped_release release;
                return tool_path_csv(path);
            },
            "The text of the path as toolpath.csv.")
        .def("__len__", [](const ToolPath& path) { return path.points.size(); })
        .def("__repr__", [](const ToolPath& path) {
            return "<ToolPath of " + std::to_string(path.points.size()) + " points>";
        });
    module.attr("move_names") = py::cast(move_words());
    module.def(
        "_read_path",
        [](const std::filesystem::path& file) {
            const py::gil_scoped_release release;
            return read_program(file).path;
        },
        py::arg("file"));
}

}  // namespace endmill::python
