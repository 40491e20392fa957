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

/// Aligned doubles in the order of C, so that rows are contiguous.
using DoubleArray = py::array_t<double, int{py::array::c_style} |
                                            int{py::detail::npy_api::NPY_ARRAY_ALIGNED_}>;

/// An array that another thread may change but not resize while this object exists.
class HeldDoubles : public DoubleArray {
public:
    explicit HeldDoubles(DoubleArray doubles)
        : DoubleArray{std::move(doubles)},
          hold_{*this}
    {
    }

private:
    py::weakref hold_;  // NumPy resizes no array that has one
};

/// Values as doubles. An array of aligned doubles in the order of C is used as it is, anything
/// else is copied.
/// \param name of the argument, for messages.
/// \throws TypeError unless the values are numbers, none of them masked.
HeldDoubles double_array(const py::handle& values, const std::string& name);

/// The same in one dimension. \throws ValueError for another shape.
HeldDoubles numbers(const py::handle& values, const std::string& name);

/// The same with `width` numbers in each row. \throws ValueError for another shape.
HeldDoubles rows(const py::handle& values, const std::string& name, py::ssize_t width);

/// Two arguments of the same shape, after NumPy's rules of broadcasting.
/// \throws ValueError if the shapes do not fit.
std::pair<HeldDoubles, HeldDoubles> same_shape(const py::handle& first,
                                               const std::string& first_name,
                                               const py::handle& second,
                                               const std::string& second_name);

/// Largest magnitude of a coordinate in mm.
inline constexpr double most_length = 1e9;

/// Returns a coordinate or length in mm.
/// \throws DomainError unless it is finite and within `most_length`.
double checked_length(double value, const char* name);

/// Throws TypeError unless a function that follows progress can be called or is None.
void require_follower(const py::object& follower);

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

/// Refuses an object that is made without its constructor, as by `Type.__new__(Type)` or a
/// copy: it would hold no value.
/// \param has_constructor whether Python may make objects, from one argument or more.
py::custom_type_setup only_constructed(bool has_constructor);

}  // namespace endmill::python
