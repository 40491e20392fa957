// SPDX-License-Identifier: GPL-3.0-or-later
// endmill.Machine: positions of the axes for poses of the tool, and poses for positions.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <system_error>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/files/machining_data.h"
#include "endmill/machine/configuration.h"
#include "endmill/machine/kinematics.h"
#include "module.h"

namespace endmill::python {
namespace {

constexpr int axis_words = 5;  // x, y, z, r1, r2

Machine machine_of(const py::object& source)
{
    const std::string text = py::str(py::module_::import("os").attr("fspath")(source));
    std::error_code ignored;
    if (text.ends_with(".json") || std::filesystem::exists(text, ignored))
        return moving_machine(read_machine(text));
    if (const auto fault = configuration_fault(text))
        throw DomainError{"Machine: " + text +
                          " is neither a file nor a word: " + *fault};
    Machine machine;
    machine.configuration = configuration_from_word(text);
    return machine;
}

Vec3 vector_of(const py::handle& values, const std::string& name)
{
    const DoubleArray array = double_array(values, name);
    if (array.size() != 3)
        throw py::value_error(name + ": expected three numbers");
    return {checked_length(array.data()[0], name.c_str()),
            checked_length(array.data()[1], name.c_str()),
            checked_length(array.data()[2], name.c_str())};
}

PartOnMachine setup_of(const Machine& machine, double tool_length,
                       const py::object& clamp, const py::object& part_to_machine)
{
    PartOnMachine setup{machine, checked_length(tool_length, "tool_length")};
    if (!clamp.is_none())
        setup.clamp = vector_of(clamp, "clamp");
    if (!part_to_machine.is_none()) {
        const DoubleArray matrix = rows(part_to_machine, "part_to_machine", 3);
        if (matrix.shape(0) != 3)
            throw py::value_error("part_to_machine: expected the shape (3, 3)");
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                setup.part_to_machine(i, j) = matrix.at(i, j);
        constexpr double rotation_tolerance = 1e-6;
        const Eigen::Matrix3d& m = setup.part_to_machine;
        if (!((m * m.transpose() - Eigen::Matrix3d::Identity()).norm() <
              rotation_tolerance) ||
            m.determinant() < 0)
            throw DomainError{"part_to_machine: expected a rotation"};
    }
    return setup;
}

// Rows of tips and axes.
struct Poses {
    const double* tips;
    const double* axes;
    py::ssize_t count;
};

// Both solutions of each pose; NaN where there is none.
void find_positions(const PartOnMachine& setup, const Poses& poses, double* out,
                    bool* is_within)
{
    const py::gil_scoped_release release;
    std::fill_n(out, poses.count * 2 * axis_words,
                std::numeric_limits<double>::quiet_NaN());
    std::fill_n(is_within, poses.count * 2, false);
    for (py::ssize_t k = 0; k < poses.count; ++k) {
        const double* tip = poses.tips + 3 * k;
        const double* axis = poses.axes + 3 * k;
        const Vec3 at{checked_length(tip[0], "tips"), checked_length(tip[1], "tips"),
                      checked_length(tip[2], "tips")};
        const Vec3 direction{axis[0], axis[1], axis[2]};
        constexpr double unit_tolerance = 1e-6;  // of ToolPath too
        if (!(std::abs(direction.norm() - 1) <= unit_tolerance))
            throw DomainError{"axes: row " + std::to_string(k) +
                              " is no unit vector; expected the length 1 to 1e-6"};
        double* row = out + 2 * k * axis_words;
        bool* within = is_within + 2 * k;
        for (const RotarySolution& solution : rotary_solutions(setup, direction)) {
            const AxisPositions reached = axis_positions(setup, solution.positions, at);
            std::copy_n(reached.xyz.data(), 3, row);
            row[3] = Angle::radians(reached.rotary[0]).degrees();
            row[4] = Angle::radians(reached.rotary[1]).degrees();
            *within++ =
                solution.is_within_limits && is_within_travel(setup.machine, reached);
            row += axis_words;
        }
    }
}

void find_poses(const PartOnMachine& setup, const double* row, py::ssize_t count,
                double* tip, double* axis)
{
    const py::gil_scoped_release release;
    for (py::ssize_t k = 0; k < count; ++k, row += axis_words) {
        for (int i = 0; i < axis_words; ++i)
            checked_length(row[i], "positions");
        const CutterLocation at = tool_location(
            setup, {{Angle::degrees(row[3]).radians(), Angle::degrees(row[4]).radians()},
                    {row[0], row[1], row[2]}});
        std::copy_n(at.tip.data(), 3, tip + 3 * k);
        std::copy_n(at.axis.data(), 3, axis + 3 * k);
    }
}

py::tuple positions(const Machine& machine, const py::object& tips,
                    const py::object& axes, double tool_length, const py::object& clamp,
                    const py::object& part_to_machine)
{
    const HeldDoubles places = rows(tips, "tips", 3);
    const HeldDoubles directions = rows(axes, "axes", 3);
    if (places.shape(0) != directions.shape(0))
        throw py::value_error("tips, axes: expected as many axes as tips");
    const PartOnMachine setup = setup_of(machine, tool_length, clamp, part_to_machine);
    const py::ssize_t count = places.shape(0);
    py::array_t<double> found{std::vector<py::ssize_t>{count, 2, axis_words}};
    py::array_t<bool> within{std::vector<py::ssize_t>{count, 2}};
    find_positions(setup, {places.data(), directions.data(), count}, found.mutable_data(),
                   within.mutable_data());
    return py::make_tuple(found, within);
}

py::tuple poses(const Machine& machine, const py::object& positions, double tool_length,
                const py::object& clamp, const py::object& part_to_machine)
{
    const HeldDoubles array = rows(positions, "positions", axis_words);
    const PartOnMachine setup = setup_of(machine, tool_length, clamp, part_to_machine);
    const py::ssize_t count = array.shape(0);
    py::array_t<double> tips{std::vector<py::ssize_t>{count, 3}};
    py::array_t<double> axes{std::vector<py::ssize_t>{count, 3}};
    find_poses(setup, array.data(), count, tips.mutable_data(), axes.mutable_data());
    return py::make_tuple(tips, axes);
}

}  // namespace

void add_machines(py::module_& module)
{
    const py::arg_v tool_length{"tool_length", 0.0};
    const py::arg_v clamp{"clamp", py::none()};
    const py::arg_v turn{"part_to_machine", py::none()};
    py::class_<Machine>(module, "Machine", only_constructed(true),
                        R"(The axes of a machine of three to five axes.

Machine(text): a file endmill-machine/1, or a word such as "W/caxyBz/T" without offsets and
limits. The part's origin is clamped at ``clamp`` in mm, and the rows of ``part_to_machine`` are
the machine's X, Y and Z in the part. ``tool_length`` in mm counts from the spindle nose to the
tip. Positions are rows x, y, z in mm and r1, r2 in degrees, the rotary axis nearest to the part
first.)")
        .def(py::init(&machine_of), py::arg("text"))
        .def_property_readonly(
            "word", [](const Machine& machine) { return machine.configuration.word; },
            "The axes from the workpiece W to the tool T; B is the bed.")
        .def_property_readonly(
            "axes", [](const Machine& machine) { return machine.configuration.axes(); },
            "Number of axes, 3 to 5.")
        .def_property_readonly(
            "is_valid",
            [](const Machine& machine) { return machine.configuration.is_valid(); },
            "Whether every rotary axis tilts or turns the tool.")
        .def(
            "positions", &positions, py::arg("tips"), py::arg("axes"), tool_length, clamp,
            turn,
            R"(Inverse kinematics: positions (n, 2, 5) and whether they are within limits (n, 2).

tips: (n, 3) in mm, axes: (n, 3), unit to 1e-6, both in the part. A pose has up to two solutions; the rows of
a missing one are NaN. Raises DomainError for a machine that is not valid.)")
        .def("poses", &poses, py::arg("positions"), tool_length, clamp, turn,
             R"(Forward kinematics: tips (n, 3) in mm and unit axes (n, 3) in the part.

positions: (n, 5), x, y, z in mm, r1 and r2 in degrees.)")
        .def("__repr__", [](const Machine& machine) {
            return "<Machine " + machine.configuration.word + ">";
        });
}

}  // namespace endmill::python
