// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

/// \file
/// NumPy arrays as arguments and results.

namespace endmill::python {

namespace py = pybind11;

/// Doubles in the order of C, so that rows are contiguous.
using DoubleArray = py::array_t<double, py::array::c_style>;

/// Values as doubles. An array of doubles in the order of C is used as it is, anything else is
/// copied.
/// \param name of the argument, for messages.
/// \throws TypeError unless the values are numbers.
DoubleArray double_array(const py::handle& values, const std::string& name);

/// The same with `width` numbers in each row.
/// \throws ValueError for another shape.
DoubleArray rows(const py::handle& values, const std::string& name, py::ssize_t width);

/// Two arguments of the same shape, after NumPy's rules of broadcasting.
/// \throws ValueError if the shapes do not fit.
std::pair<DoubleArray, DoubleArray> same_shape(const py::handle& first,
                                               const std::string& first_name,
                                               const py::handle& second,
                                               const std::string& second_name);

/// Throws DomainError unless a value of an argument is finite.
void require_finite(double value, const char* name);

/// The shape of `array` with one more dimension of `width`.
std::vector<py::ssize_t> shape_with(const py::array& array, py::ssize_t width);

/// Elements of numbers of one type as an array that owns them; nothing is copied.
template <typename Number, typename Element>
py::array_t<Number> moved(std::vector<Element>&& elements, std::vector<py::ssize_t> shape)
{
    auto owner = std::make_unique<std::vector<Element>>(std::move(elements));
    const auto* data = reinterpret_cast<const Number*>(owner->data());
    const py::capsule keeper{
        owner.get(), [](void* kept) { delete static_cast<std::vector<Element>*>(kept); }};
    [[maybe_unused]] const auto* kept = owner.release();
    return py::array_t<Number>(std::move(shape), data, keeper);
}

/// Makes an array read-only, and returns it.
template <typename Array>
Array read_only(Array array)
{
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

/// Numbers in memory that `owner` keeps, as a read-only array; nothing is copied.
template <typename Number>
py::array_t<Number> view(const Number* data, std::vector<py::ssize_t> shape,
                         std::vector<py::ssize_t> strides, const py::handle& owner)
{
    return read_only(
        py::array_t<Number>(std::move(shape), std::move(strides), data, owner));
}

}  // namespace endmill::python
