// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace endmill {

static_assert(std::endian::native == std::endian::little,
              "the files declare LittleEndian and hold the numbers as memory does");

/// The value of the XML attribute "type" for an array of `Number`.
template <class Number>
constexpr std::string_view vtk_type;
template <>
constexpr inline std::string_view vtk_type<double> = "Float64";
template <>
constexpr inline std::string_view vtk_type<float> = "Float32";
template <>
constexpr inline std::string_view vtk_type<std::int64_t> = "Int64";
template <>
constexpr inline std::string_view vtk_type<std::int32_t> = "Int32";
template <>
constexpr inline std::string_view vtk_type<std::uint8_t> = "UInt8";

/// The raw arrays at the end of a VTK XML file. In front of each array stands the number
/// of its bytes as UInt64.
class AppendedArrays {
public:
    /// Appends an array.
    /// \param components number of values for each point or cell.
    /// \return the XML element that refers to the array, with its line end.
    template <class Number>
    std::string append(std::string_view name, int components,
                       const std::vector<Number>& numbers)
    {
        std::string element{"    <DataArray type=\""};
        element += vtk_type<Number>;
        element += "\" Name=\"" + std::string{name};
        element += "\" NumberOfComponents=\"" + std::to_string(components);
        element += "\" format=\"appended\" offset=\"" + std::to_string(bytes_.size());
        element += "\"/>\n";
        const std::uint64_t size = sizeof(Number) * numbers.size();
        append_bytes(&size, sizeof size);
        append_bytes(numbers.data(), size);
        return element;
    }

    /// All arrays in the order of `append`.
    const std::string& bytes() const { return bytes_; }

private:
    void append_bytes(const void* first, std::size_t count)
    {
        const std::size_t before = bytes_.size();
        bytes_.resize(before + count);
        if (count > 0)
            std::memcpy(bytes_.data() + before, first, count);
    }

    std::string bytes_;
};

}  // namespace endmill
