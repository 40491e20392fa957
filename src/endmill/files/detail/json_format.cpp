// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/json_format.h"

#include <cstddef>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/detail/file_format.h"
#include "endmill/files/read_file.h"

namespace endmill {
namespace {

constexpr std::size_t longest_name = 200;
constexpr std::size_t longest_remark = 2000;

// A word in quotes, for messages.
std::string quoted(std::string_view word)
{
    return '"' + std::string{word} + '"';
}

// The version of a format, the number after '/'; nothing if that is not a number.
std::optional<double> version_of(std::string_view format)
{
    return number_from_text(format.substr(format.find('/') + 1));
}

// Refuses content that does not begin like JSON; the message names a recognised format.
void require_json(std::string_view content, const std::string& file,
                  std::string_view format)
{
    const auto found = recognized_format(content);
    if (found == "JSON")
        return;
    throw FormatError{
        "E_FORMAT",
        {file, "",
         found ? "content looks like " + std::string{*found} : "content is not JSON",
         "JSON of format " + quoted(format)}};
}

// Refuses another format, and reports a newer version of the same format as such.
void require_format(const JsonValue& root, std::string_view format)
{
    const JsonValue value = root.member("format");
    const std::string found = value.text();
    if (found == format)
        return;
    const std::string_view family = format.substr(0, format.find('/') + 1);
    if (found.starts_with(family))
        if (const auto version = version_of(found);
            version && version > version_of(format))
            throw value.complaint("made by a newer version: " + value.shown(),
                                  quoted(format));
    throw value.complaint(value.shown(), quoted(format), "E_FORMAT");
}

// Checks the content before it is parsed, because the parser could only report a syntax
// error in a mesh or a program.
std::string_view checked(std::string_view content, const std::string& file,
                         std::string_view format)
{
    require_json(content, file, format);
    return content;
}

}  // namespace

FormatDocument::FormatDocument(std::string_view content,
                               const std::filesystem::path& path,
                               const ReadLimits& limits, std::string_view format)
    : document_{checked(content, shown_path(path), format), shown_path(path), limits}
{
    require_format(document_.root(), format);
}

std::string name_or_stem(const JsonValue& root, const std::filesystem::path& path)
{
    const auto name = root.find_member("name");
    return name ? printable(name->text(), longest_name)
                : printable(path.stem().string(), longest_name);
}

std::string remark(const JsonValue& root, std::string_view key)
{
    const auto value = root.find_member(key);
    return value ? printable(value->text(), longest_remark) : std::string{};
}

// The message states the range in words, with "from" or "above" for the lower end.
double number_in(const JsonValue& value, const NumberRange& range)
{
    const double number = value.number();
    const bool is_above = range.from ? number >= range.above : number > range.above;
    if (is_above && number <= range.most)
        return number;
    throw value.complaint(value.shown(),
                          range.from ? "a number from " + to_text(range.above) + " to " +
                                           to_text(range.most)
                                     : "a number above " + to_text(range.above) +
                                           ", at most " + to_text(range.most),
                          std::string{range.code});
}

std::optional<double> find_number(const JsonValue& root, std::string_view key,
                                  const NumberRange& range)
{
    const auto value = root.find_member(key);
    return value ? std::optional{number_in(*value, range)} : std::nullopt;
}

}  // namespace endmill
