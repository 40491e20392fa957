// SPDX-License-Identifier: GPL-3.0-or-later
// The Python module endmill._native: the library's values and functions with NumPy arrays.

#include "module.h"

#include <exception>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"

namespace endmill::python {
namespace {

namespace py = pybind11;

// Raises the Python exception `name` of endmill.errors.
void raise_python_error(const char* name, const Error& error, const char* file = "",
                        const char* place = "")
{
    const py::object type = py::module_::import("endmill.errors").attr(name);
    const py::object raised = type(error.what(), error.code(), file, place);
    PyErr_SetObject(type.ptr(), raised.ptr());
}

void translate(std::exception_ptr thrown)
{
    try {
        if (thrown)
            std::rethrow_exception(thrown);
    } catch (const DomainError& error) {
        raise_python_error("DomainError", error);
    } catch (const FormatError& error) {
        raise_python_error("FormatError", error, error.file().c_str(),
                           error.place().c_str());
    } catch (const GeometryError& error) {
        raise_python_error("GeometryError", error);
    } catch (const OutputError& error) {
        raise_python_error("OutputError", error);
    } catch (const LimitError& error) {
        raise_python_error("LimitError", error);
    } catch (const Error& error) {
        raise_python_error("Error", error);
    }
}

}  // namespace
}  // namespace endmill::python

PYBIND11_MODULE(_native, module)
{
    using namespace endmill::python;
    pybind11::options options;
    options.disable_function_signatures();
    pybind11::register_exception_translator(&translate);
    module.def("set_thread_count", &endmill::set_thread_count, pybind11::arg("count"),
               "Limit the threads of this process to ``count``, 1 to 1024.");
    add_meshes(module);
    add_surfaces(module);
    add_cutters(module);
    add_paths(module);
    add_trimming(module);
    add_process(module);
    add_visibility(module);
    add_machines(module);
}
