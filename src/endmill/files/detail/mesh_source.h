// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "endmill/core/error.h"
#include "endmill/core/vec.h"
#include "endmill/files/detail/text_scanner.h"
#include "endmill/files/read_file.h"

/// \file
/// What the readers of all mesh formats share: their input, the checks of coordinates and
/// indices, and error messages with the place in the file.

namespace endmill {

/// The content of a mesh file and the parameters for reading it.
struct MeshSource {
    std::string_view content;  ///< of the whole file
    std::string file;          ///< name of the file for messages
    ReadLimits limits = {};    ///< on converted coordinates, and on memory
    double mm_per_unit = 1;    ///< mm per length unit of the file
};

/// A place in a file, for error messages: a line of a text, or a byte of a binary file.
class FilePlace {
public:
    static FilePlace line(std::size_t number) { return {number, false}; }  ///< from 1
    static FilePlace byte(std::size_t offset) { return {offset, true}; }   ///< from 0

    /// The text for `FormatError::Complaint::place`: "LINE" or "@BYTE".
    std::string text() const { return (is_byte_ ? "@" : "") + std::to_string(number_); }

private:
    FilePlace(std::size_t number, bool is_byte) : number_{number}, is_byte_{is_byte} {}

    std::size_t number_;
    bool is_byte_;
};

/// Converts the coordinates in the file to a point in mm.
/// \throws FormatError E_NONFINITE if a coordinate is not finite, E_RANGE if it is beyond
///         the limit.
Vec3 point_mm(const MeshSource& source, const Vec3& coordinates, FilePlace place);

/// Reads the next three words of a line as a point in mm.
/// \throws FormatError as `TextScanner::number` and `point_mm`.
Vec3 scan_point_mm(TextScanner& scanner, const MeshSource& source);

/// Checks the index of a point, counted from 0, and returns it.
/// \param points number of points in the mesh.
/// \throws FormatError E_INDEX unless 0 <= number < points.
std::int32_t point_number(const MeshSource& source, std::int64_t number,
                          std::size_t points, FilePlace place);

/// Checks that a mesh of this size can be indexed by 32-bit integers.
/// \throws LimitError if there are more than 2^31 - 1 points or triangles.
void require_numbers(const MeshSource& source, std::uint64_t points_or_triangles);

/// A FormatError with the name of the file.
/// \param code     such as "E_COUNT".
/// \param found    what the file has at `place`.
/// \param expected what it should have; may be empty.
FormatError complaint(const MeshSource& source, const std::string& code, FilePlace place,
                      const std::string& found, const std::string& expected);

}  // namespace endmill
