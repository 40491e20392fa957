// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to io
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "endmill/io/strict_json.h"

namespace endmill {

/// \throws FormatError E_FORMAT unless `content` begins as JSON does: what it looks like.
/// \param file the name for messages. \param format the whole word, "endmill-tool/1".
void require_json(std::string_view content, const std::string& file,
                  std::string_view format);

/// Checks the key `format`, first of all since a newer version may have other keys.
/// \param format the whole word, which ends in '/' and a version.
/// \throws FormatError E_JSON if it is missing or names a newer version; E_FORMAT if it
///         is another format.
void require_format(const JsonValue& root, std::string_view format);

/// The name that the file gives itself in `name`, or that of the file, fit for a terminal.
std::string name_or_stem(const JsonValue& root, const std::filesystem::path& path);

/// The text of `key` fit for a terminal, shortened; empty if there is none.
std::string remark(const JsonValue& root, std::string_view key);

/// A range of numbers, and what breaking it is called.
struct NumberRange {
    double above = 0;                  ///< open lower end, or closed if `from`
    double most = 0;                   ///< closed upper end
    bool from = false;                 ///< whether `above` itself belongs to it
    std::string_view code = "E_JSON";  ///< of the FormatError
};

/// The number that `value` holds. \throws FormatError unless it is one in `range`.
double number_in(const JsonValue& value, const NumberRange& range);

/// The same of the member `key`; none if there is none.
std::optional<double> find_number(const JsonValue& root, std::string_view key,
                                  const NumberRange& range);

}  // namespace endmill
