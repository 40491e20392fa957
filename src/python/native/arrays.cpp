// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"

#include <cmath>

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
    try {
        return py::module_::import("numpy").attr("asarray")(values).cast<py::array>();
    } catch (py::error_already_set& error) {
        if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_TypeError))
            throw;
        throw py::type_error(name + ": found values that are no array; expected numbers");
    }
}

}  // namespace

DoubleArray double_array(const py::handle& values, const std::string& name)
{
    const py::array array = any_array(values, name);
    if (const char kind = array.dtype().kind(); kind != 'f' && kind != 'i' && kind != 'u')
        throw py::type_error(name + ": found values of the type " +
                             std::string{py::str(array.dtype())} + "; expected numbers");
    auto doubles = DoubleArray::ensure(array);
    if (!doubles)
        throw py::error_already_set();
    return doubles;
}

DoubleArray rows(const py::handle& values, const std::string& name, py::ssize_t width)
{
    DoubleArray array = double_array(values, name);
    if (array.ndim() != 2 || array.shape(1) != width)
        throw py::value_error(name + ": found the shape " + shape_text(array) +
                              "; expected (n, " + std::to_string(width) + ")");
    return array;
}

std::pair<DoubleArray, DoubleArray> same_shape(const py::handle& first,
                                               const std::string& first_name,
                                               const py::handle& second,
                                               const std::string& second_name)
{
    DoubleArray a = double_array(first, first_name);
    DoubleArray b = double_array(second, second_name);
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

void require_finite(double value, const char* name)
{
    if (!std::isfinite(value))
        throw DomainError{std::string{name} + ": found " + to_text(value) +
                          "; expected finite numbers"};
}

std::vector<py::ssize_t> shape_with(const py::array& array, py::ssize_t width)
{
    std::vector<py::ssize_t> shape{array.shape(), array.shape() + array.ndim()};
    shape.push_back(width);
    return shape;
}

}  // namespace endmill::python
