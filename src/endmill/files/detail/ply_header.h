// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/files/mesh_file.h"

namespace endmill {

/// How the part of a PLY file after its header is written.
enum class PlyEncoding { Ascii, LittleEndian, BigEndian };

/// The type of a number in a PLY file.
enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

std::size_t size_of(PlyType type);  ///< bytes in a binary file
bool is_whole(PlyType type);        ///< not a type of real numbers

/// What each item of an element has: a number, or a list of numbers.
struct PlyProperty {
    std::string_view name;
    PlyType type;                       ///< of the number, or of the list's numbers
    std::optional<PlyType> count_type;  ///< of the list's length, if it is a list
};

/// A table of the file, such as the points.
struct PlyElement {
    std::string_view name;
    std::uint64_t count;                  ///< items that follow, as the file claims
    std::vector<PlyProperty> properties;  ///< at least one, no name twice
    std::size_t line;                     ///< of the header, that names it
};

/// The header of a PLY file. Names are views into the file.
struct PlyHeader {
    PlyEncoding encoding;
    std::vector<PlyElement> elements;  ///< in the order in which they follow
    std::size_t bytes;                 ///< of the header, after which the items follow
    std::size_t lines;                 ///< ditto
};

/// Reads a PLY header, up to "end_header" and its line feed.
/// \throws FormatError E_PLY_SYNTAX for what is no header, for a type or version that does
///         not exist and for names that stand twice; E_COUNT if the items that it claims
///         do not fit into the file; E_LIMIT for over 1000 properties, or a line over
///         1 MiB.
PlyHeader parse_ply_header(const MeshSource& source);

}  // namespace endmill
