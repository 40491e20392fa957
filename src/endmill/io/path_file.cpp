// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/io/path_file.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "endmill/core/error.h"
#include "endmill/io/file_format.h"
#include "endmill/io/read_file.h"
#include "endmill/io/tool_path_reader.h"
#include "endmill/post/apt_reader.h"
#include "endmill/post/canonical_reader.h"
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

// The kind of the content if it is plainly no tool path.
std::optional<std::string> foreign_format(std::string_view content, bool is_gcode_name)
{
    constexpr std::size_t looked_at = 4096;
    const auto format = recognized_format(content);
    // In small letters and with blanks, G and F words begin as the lines of an OBJ file.
    const bool is_doubtful = format == "OBJ" && is_gcode_name;
    if (format && format != "G-code" && format != "CSV" && !is_doubtful)
        return "content looks like " + std::string{*format};
    if (content.substr(0, looked_at).find('\0') != std::string_view::npos)
        return "content is binary";
    return std::nullopt;
}

// Whether a program may begin so: %, a comment, a skipped block, or a letter and a number.
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
    const bool is_letter =
        ('A' <= first && first <= 'Z') || ('a' <= first && first <= 'z');
    const char second = next(begin + 1);
    return is_letter && "0123456789+-.#[<"sv.find(second) != std::string_view::npos;
}

}  // namespace

// Content decides where it is plain, since names lie; the name decides where content is
// damaged, so that the reader of that kind can say where.
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
            return parse_tool_path(content, file, options.limits);
        case PathFormat::Canonical:
            return parse_canonical(content, file, gcode);
        case PathFormat::Apt:
            return parse_apt(content, file, {gcode.max_extent_mm, gcode.most_points});
        case PathFormat::Gcode:
            break;
    }
    return parse_gcode(content, file, gcode);
}

Program read_program(const std::filesystem::path& path, const PathReadOptions& options)
{
    return parse_program(read_file(path, options.limits), path, options);
}

}  // namespace endmill
