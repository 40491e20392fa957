// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/files/detail/mesh_source.h"

namespace endmill {

/// Encoding of the part of a PLY file after its header.
enum class PlyEncoding { Ascii, LittleEndian, BigEndian };

/// Type of a number in a PLY file.
enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

std::size_t size_of(PlyType type);  ///< size in a binary file, in bytes
bool is_whole(PlyType type);        ///< whether it is a type of whole numbers

/// A property of every item of an element: a number, or a list of numbers.
struct PlyProperty {
    std::string_view name;              ///< as in the header
    PlyType type;                       ///< of the number, or of the numbers in the list
    std::optional<PlyType> count_type;  ///< of the length of the list, if it is a list
};

/// A table of the file, such as the points.
struct PlyElement {
    std::string_view name;                ///< as in the header
    std::uint64_t count;                  ///< number of items that the header claims
    std::vector<PlyProperty> properties;  ///< at least one; their names differ
    std::size_t line;  ///< line of the header that declares the element
};

/// The header of a PLY file. Names are views into the content of the file.
struct PlyHeader {
    PlyEncoding encoding;              ///< of the items
    std::vector<PlyElement> elements;  ///< in the order of the file
    std::size_t bytes;                 ///< length of the header; the items follow
    std::size_t lines;                 ///< number of lines of the header
};

/// Parses a PLY header up to "end_header" and its line feed.
/// \throws FormatError E_PLY_SYNTAX for invalid syntax, an unknown type or version, and
///         repeated names; E_COUNT if the claimed items do not fit into the file; E_LIMIT
///         for more than 1000 elements and properties, or a line over 1 MiB.
PlyHeader parse_ply_header(const MeshSource& source);

}  // namespace endmill
