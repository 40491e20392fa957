// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "endmill/core/error.h"
#include "endmill/core/vec.h"
#include "endmill/io/read_limits.h"
#include "endmill/io/text_scanner.h"

namespace endmill {

/// The content of a mesh file and how it is to be read.
struct MeshSource {
    std::string_view content;  ///< of the file, whole
    std::string file;          ///< its name for messages
    ReadLimits limits = {};    ///< on coordinates, after conversion, and memory
    double mm_per_unit = 1;    ///< mesh files carry no unit: what a 1 in it stands for
};

/// A place in a file, for complaints.
class FilePlace {
public:
    static FilePlace line(std::size_t number) { return {number, false}; }  ///< from 1
    static FilePlace byte(std::size_t offset) { return {offset, true}; }   ///< from 0

    /// As `FormatError::Complaint::place`: "LINE" or "@BYTE".
    std::string text() const { return (is_byte_ ? "@" : "") + std::to_string(number_); }

private:
    FilePlace(std::size_t number, bool is_byte) : number_{number}, is_byte_{is_byte} {}

    std::size_t number_;
    bool is_byte_;
};

/// A point in mm from the coordinates that stand in the file.
/// \throws FormatError E_NONFINITE or E_RANGE if one is not finite, or beyond the limit.
Vec3 point_mm(const MeshSource& source, const Vec3& coordinates, FilePlace place);

/// The next three words of a line as a point in mm.
/// \throws FormatError as `TextScanner::number` and `point_mm`.
Vec3 scan_point_mm(TextScanner& scanner, const MeshSource& source);

/// A number of a point, counted from 0.
/// \throws FormatError E_INDEX unless it is one of `points`.
std::int32_t point_number(const MeshSource& source, std::int64_t number,
                          std::size_t points, FilePlace place);

/// \throws LimitError if a mesh of so many points or triangles cannot be numbered: there
/// are more than 2^31 - 1.
void require_numbers(const MeshSource& source, std::uint64_t points_or_triangles);

/// An error with the file's name.
FormatError complaint(const MeshSource& source, const std::string& code, FilePlace place,
                      const std::string& found, const std::string& expected);

}  // namespace endmill
