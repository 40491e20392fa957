// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

/// \file
/// The parts of the Python module `endmill._native`, a function each.

namespace endmill::python {

void add_surfaces(pybind11::module_& module);    ///< Surface, Part, read_part
void add_meshes(pybind11::module_& module);      ///< Mesh
void add_cutters(pybind11::module_& module);     ///< Cutter, DropCutter
void add_paths(pybind11::module_& module);       ///< ToolPath, read_path
void add_trimming(pybind11::module_& module);    ///< trim_curves, compare_trimming
void add_process(pybind11::module_& module);     ///< cutting_coefficients
void add_visibility(pybind11::module_& module);  ///< DirectionGrid, VisibilityMap
void add_machines(pybind11::module_& module);    ///< Machine

}  // namespace endmill::python
