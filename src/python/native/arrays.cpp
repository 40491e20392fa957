// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill::python {
namespace {

std::string shape_text(const py::array& array)
{
    return py::str(array.attr("shape"));
}

py::array any_array(const py::handle& values, const std::string& name)
{
    const py::module_ numpy = py::module_::import("numpy");
    if (py::isinstance(values, numpy.attr("ma").attr("MaskedArray")))
        throw py::type_error(name +
                             ": found a masked array; expected numbers, all of them");
    try {
        return numpy.attr("asarray")(values).cast<py::array>();
    } catch (py::error_already_set& error) {
        if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_TypeError))
            throw;
        throw py::type_error(name + ": found values that are no array; expected numbers");
    }
}

}  // namespace

HeldDoubles double_array(const py::handle& values, const std::string& name)
{
    const py::array array = any_array(values, name);
    if (const char kind = array.dtype().kind(); kind != 'f' && kind != 'i' && kind != 'u')
        throw py::type_error(name + ": found values of the type " +
                             std::string{py::str(array.dtype())} + "; expected numbers");
    return HeldDoubles{DoubleArray{static_cast<const py::object&>(array)}};
}

HeldDoubles numbers(const py::handle& values, const std::string& name)
{
    HeldDoubles array = double_array(values, name);
    if (array.ndim() != 1)
        throw py::value_error(name + ": found the shape " + shape_text(array) +
                              "; expected (n,)");
    return array;
}

HeldDoubles rows(const py::handle& values, const std::string& name, py::ssize_t width)
{
    HeldDoubles array = double_array(values, name);
    if (array.ndim() != 2 || array.shape(1) != width)
        throw py::value_error(name + ": found the shape " + shape_text(array) +
                              "; expected (n, " + std::to_string(width) + ")");
    return array;
}

std::pair<HeldDoubles, HeldDoubles> same_shape(const py::handle& first,
                                               const std::string& first_name,
                                               const py::handle& second,
                                               const std::string& second_name)
{
    HeldDoubles a = double_array(first, first_name);
    HeldDoubles b = double_array(second, second_name);
    const bool is_same =
        a.ndim() == b.ndim() && std::equal(a.shape(), a.shape() + a.ndim(), b.shape());
    if (is_same)
        return {a, b};
    try {
        const py::sequence both =
            py::module_::import("numpy").attr("broadcast_arrays")(a, b);
        return {double_array(both[0], first_name), double_array(both[1], second_name)};
    } catch (py::error_already_set& error) {
        if (!error.matches(PyExc_ValueError))
            throw;
        throw py::value_error(first_name + ", " + second_name + ": found the shapes " +
                              shape_text(a) + " and " + shape_text(b) +
                              "; expected shapes that can be broadcast together");
    }
}

double checked_length(double value, const char* name)
{
    if (!(std::abs(value) <= most_length))
        throw DomainError{std::string{name} + ": found " + to_text(value) +
                          "; expected finite numbers up to " + to_text(most_length) +
                          " mm"};
    return value;
}

void require_follower(const py::object& follower)
{
    if (!follower.is_none() && PyCallable_Check(follower.ptr()) == 0)
        throw py::type_error("progress: expected a function of the finished share");
}

std::vector<py::ssize_t> shape_with(const py::array& array, py::ssize_t width)
{
    std::vector<py::ssize_t> shape{array.shape(), array.shape() + array.ndim()};
    shape.push_back(width);
    return shape;
}

namespace {

// The type of which this thread makes an object by calling it.
thread_local PyTypeObject* called_type = nullptr;

// The metaclass of pybind11's types; its call makes sure that a constructor ran.
PyTypeObject* made_by_call_only(PyTypeObject* of_pybind11)
{
    static PyTypeObject* made = nullptr;
    static ternaryfunc call = nullptr;
    if (made)
        return made;
    call = of_pybind11->tp_call;
    const ternaryfunc own_call = [](PyObject* type, PyObject* arguments,
                                    PyObject* keywords) -> PyObject* {
        called_type = reinterpret_cast<PyTypeObject*>(type);
        PyObject* object = call(type, arguments, keywords);
        called_type = nullptr;
        return object;
    };
    std::array<PyType_Slot, 2> slots{
        {{Py_tp_call, reinterpret_cast<void*>(own_call)}, {0, nullptr}}};
    PyType_Spec spec{"endmill._native.Type", 0, 0, Py_TPFLAGS_DEFAULT, slots.data()};
    const py::tuple bases =
        py::make_tuple(py::handle{reinterpret_cast<PyObject*>(of_pybind11)});
    PyObject* type = PyType_FromSpecWithBases(&spec, bases.ptr());
    if (!type)
        throw py::error_already_set();
    made = reinterpret_cast<PyTypeObject*>(type);
    return made;
}

}  // namespace

py::custom_type_setup only_constructed(bool has_constructor)
{
    // The functions of CPython's interface carry no data, so there is one for each case.
    static newfunc make = nullptr;
    const newfunc never = [](PyTypeObject* type, PyObject*, PyObject*) -> PyObject* {
        PyErr_Format(PyExc_TypeError, "%s: no constructor defined", type->tp_name);
        return nullptr;
    };
    const newfunc when_called = [](PyTypeObject* type, PyObject* arguments,
                                   PyObject* keywords) -> PyObject* {
        if (std::exchange(called_type, nullptr) == type)
            return make(type, arguments, keywords);
        PyErr_Format(PyExc_TypeError, "%s: expected a call of its constructor",
                     type->tp_name);
        return nullptr;
    };
    return py::custom_type_setup{[=](PyHeapTypeObject* heap_type) {
        PyTypeObject& type = heap_type->ht_type;
        PyTypeObject* metaclass = made_by_call_only(Py_TYPE(&type));
        Py_INCREF(metaclass);
        Py_SET_TYPE(&type, metaclass);
        make = type.tp_base->tp_new;
        type.tp_new = has_constructor ? when_called : never;
    }};
}

}  // namespace endmill::python
