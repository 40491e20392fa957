// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/file_format.h"

#include <algorithm>
#include <array>

#include "endmill/files/detail/stl.h"

namespace endmill {
namespace {

using std::string_view_literals::operator""sv;

// First characters of a text, after blanks, and the format that they indicate. The first
// match counts, so longer beginnings stand before their prefixes.
struct Beginning {
    std::string_view text;
    std::string_view format;
};

constexpr std::array beginnings{
    Beginning{"\xff\xfe"sv, "UTF-16 text"},
    Beginning{"\xfe\xff"sv, "UTF-16 text"},
    Beginning{"{"sv, "JSON"},
    Beginning{"["sv, "JSON"},
    Beginning{"solid"sv, "STL"},
    Beginning{"OFF"sv, "OFF"},
    Beginning{"COFF"sv, "OFF"},
    Beginning{"NOFF"sv, "OFF"},
    Beginning{"CNOFF"sv, "OFF"},
    Beginning{"STOFF"sv, "OFF"},
    Beginning{"ply"sv, "PLY"},
    Beginning{"ISO-10303-21"sv, "STEP"},
    Beginning{"# vtk DataFile"sv, "VTK"},
    Beginning{"<VTKFile"sv, "VTK"},
    Beginning{"<"sv, "XML"},
    Beginning{"%"sv, "G-code"},
    Beginning{"pass,point,move"sv, "CSV"},
    Beginning{"tip_x_mm,"sv, "CSV"},
};

// The first line that is neither empty nor a comment, without leading blanks.
std::string_view first_statement(std::string_view content)
{
    while (!content.empty()) {
        const std::string_view line = content.substr(0, content.find('\n'));
        if (const auto begin = line.find_first_not_of(" \t\r");
            begin != std::string_view::npos && line[begin] != '#')
            return line.substr(begin);
        content.remove_prefix(std::min(line.size() + 1, content.size()));
    }
    return {};
}

// Whether the first statement is one of OBJ. OBJ files have no signature.
bool is_obj(std::string_view content)
{
    constexpr std::array words{"v "sv, "vn "sv, "vt "sv,    "f "sv,
                               "o "sv, "g "sv,  "mtllib "sv};
    return std::ranges::any_of(words, [&](std::string_view word) {
        return first_statement(content).starts_with(word);
    });
}

}  // namespace

std::optional<std::string_view> recognized_format(std::string_view content)
{
    // The header of a binary STL is arbitrary, but the length of the file is not.
    if (is_binary_stl(content))
        return "STL";
    std::string_view text = content;
    constexpr auto byte_order_mark = "\xef\xbb\xbf"sv;
    if (text.starts_with(byte_order_mark))
        text.remove_prefix(byte_order_mark.size());
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    for (const Beginning& beginning : beginnings)
        if (text.starts_with(beginning.text))
            return beginning.format;
    if (is_obj(text))
        return "OBJ";
    return std::nullopt;
}

}  // namespace endmill
