// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/path_file.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "endmill/core/error.h"
#include "endmill/files/detail/csv_lines.h"
#include "endmill/files/detail/file_format.h"
#include "endmill/files/detail/tool_path_reader.h"
#include "endmill/files/read_file.h"
#include "endmill/post/apt.h"
#include "endmill/post/gcode_reader.h"

namespace endmill {
namespace {

using std::string_view_literals::operator""sv;

constexpr const char* expected =
    "a tool path: CSV with the columns tip_x_mm, tip_y_mm and tip_z_mm, G-code, APT CL "
    "data or the output of rs274 -g";
constexpr std::array gcode_extensions{".ngc"sv, ".nc"sv,  ".gcode"sv,
                                      ".tap"sv, ".cnc"sv, ".mpf"sv};
constexpr std::array apt_extensions{".apt"sv, ".cl"sv, ".cls"sv};

// The extension of the path, in lower case.
std::string lower_case_extension(const std::filesystem::path& path)
{
    std::string extension = path.extension().string();
    for (char& letter : extension)
        if ('A' <= letter && letter <= 'Z')
            letter = static_cast<char>(letter - 'A' + 'a');
    return extension;
}

template <class Words>
bool contains(const Words& words, std::string_view word)
{
    return std::ranges::find(words, word) != words.end();
}

// A description of the content if it clearly is not a tool path; else nothing.
std::optional<std::string> foreign_format(std::string_view content, bool is_gcode_name)
{
    constexpr std::size_t searched_bytes = 4096;  // for NUL bytes
    const auto format = recognized_format(content);
    // Lines such as "g 1" and "f 100" are valid in both G-code and OBJ.
    const bool is_doubtful = format == "OBJ" && is_gcode_name;
    if (format && format != "G-code" && format != "CSV" && !is_doubtful)
        return "content looks like " + std::string{*format};
    if (content.substr(0, searched_bytes).find('\0') != std::string_view::npos)
        return "content is binary";
    return std::nullopt;
}

// Whether the content begins like a G-code program: with %, a comment, a block delete, a
// parameter, a number of the program after a colon, or a letter and a number.
bool begins_as_gcode(std::string_view content)
{
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (content.starts_with(byte_order_mark))
        content.remove_prefix(byte_order_mark.size());
    constexpr auto blanks = " \t\r\n"sv;
    const auto next = [&](std::size_t from) {
        const std::size_t at = content.find_first_not_of(blanks, from);
        return at == std::string_view::npos ? '\0' : content[at];
    };
    const std::size_t begin = content.find_first_not_of(blanks);
    if (begin == std::string_view::npos)
        return false;
    const char first = content[begin];
    if ("%(;/#"sv.find(first) != std::string_view::npos)
        return true;
    if (first == ':')
        return "0123456789"sv.find(next(begin + 1)) != std::string_view::npos;
    const bool is_letter =
        ('A' <= first && first <= 'Z') || ('a' <= first && first <= 'z');
    const char second = next(begin + 1);
    return is_letter && "0123456789+-.#[<"sv.find(second) != std::string_view::npos;
}

}  // namespace

// The content decides where it is clear, because extensions may be wrong. The extension
// decides where the content is damaged, so that the reader of the format can report the
// place.
//
// 1. A header with a column of tips: CSV.
// 2. Content of a mesh, an image or another known format, or binary content: refused.
// 3. The extension .csv: CSV.
// 4. Content in the form of canonical commands or APT; the extensions of APT.
// 5. The extensions of G-code; content that begins like G-code.
PathFormat path_format(std::string_view content, const std::filesystem::path& path)
{
    const std::string extension = lower_case_extension(path);
    const bool is_gcode_name = contains(gcode_extensions, extension);
    if (is_tool_path_csv(content))
        return PathFormat::Csv;
    if (const auto foreign = foreign_format(content, is_gcode_name))
        throw FormatError{"E_FORMAT", {shown_path(path), "", *foreign, expected}};
    if (extension == ".csv")
        return PathFormat::Csv;
    if (is_canonical(content))
        return PathFormat::Canonical;
    if (is_apt(content) || contains(apt_extensions, extension))
        return PathFormat::Apt;
    if (is_gcode_name || begins_as_gcode(content))
        return PathFormat::Gcode;
    throw FormatError{"E_FORMAT",
                      {shown_path(path), "", "content is not recognised", expected}};
}

bool has_path_extension(const std::filesystem::path& path)
{
    const std::string extension = lower_case_extension(path);
    return contains(gcode_extensions, extension) || contains(apt_extensions, extension);
}

GcodeReadOptions gcode_reading(const PathReadOptions& options)
{
    GcodeReadOptions gcode = options.gcode;
    gcode.max_extent_mm = options.limits.max_extent_mm;
    gcode.most_points = points_within(options.limits.max_memory_gib);
    return gcode;
}

Program parse_program(std::string_view content, const std::filesystem::path& path,
                      const PathReadOptions& options)
{
    const std::string file = shown_path(path);
    const GcodeReadOptions gcode = gcode_reading(options);
    switch (path_format(content, path)) {
        case PathFormat::Csv:
            return parse_tool_path(content, file, options.limits, options.machine);
        case PathFormat::Canonical:
            return parse_canonical(content, file, gcode);
        case PathFormat::Apt:
            return parse_apt(
                content, file,
                {gcode.max_extent_mm, gcode.most_points, options.several_cutters});
        case PathFormat::Gcode:
            break;
    }
    return parse_gcode(content, file, gcode);
}

std::size_t line_of_row(std::string_view text, std::size_t row)
{
    CsvLines lines{text, {}};
    bool is_there = lines.next();  // the header
    for (std::size_t k = 0; is_there && k <= row; ++k)
        is_there = lines.next();
    return lines.line();
}

Program read_program(const std::filesystem::path& path, const PathReadOptions& options)
{
    return parse_program(read_file(path, options.limits), path, options);
}

}  // namespace endmill
