// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "endmill/files/detail/strict_json.h"

/// \file
/// What all JSON formats of this module share: the check of the format and its version,
/// names and remarks, and numbers within a range.

namespace endmill {

/// The JSON document of a file, whose key `format` has been checked.
class FormatDocument {
public:
    /// Parses the content and checks its format before all other keys, since a newer
    /// version may have other keys.
    /// \param path   for messages.
    /// \param format name and version, such as "endmill-tool/1".
    /// \throws FormatError E_FORMAT if the content is not JSON (the message names a
    ///         recognised format) or of another format; E_JSON if the format is missing
    ///         or of a newer version. FormatError and LimitError as `JsonDocument`.
    FormatDocument(std::string_view content, const std::filesystem::path& path,
                   const ReadLimits& limits, std::string_view format);

    JsonValue root() const& { return document_.root(); }  ///< as of JsonDocument
    JsonValue root() const&& = delete;                    ///< would dangle

private:
    JsonDocument document_;
};

/// The text of the key `name`, or else the stem of the file; `printable` and shortened.
std::string name_or_stem(const JsonValue& root, const std::filesystem::path& path);

/// The text of a key, `printable` and shortened; empty if the key is missing.
std::string remark(const JsonValue& root, std::string_view key);

/// An interval of numbers, and the error code for numbers outside.
struct NumberRange {
    double above = 0;                  ///< lower end; it belongs to the range if `from`
    double most = 0;                   ///< upper end; it belongs to the range
    bool from = false;                 ///< whether the lower end belongs to the range
    std::string_view code = "E_JSON";  ///< of the FormatError
};

/// The number in `value`. \throws FormatError unless it is a number in `range`.
double number_in(const JsonValue& value, const NumberRange& range);

/// The number under `key`; nothing if the key is missing.
/// \throws FormatError unless it is a number in `range`.
std::optional<double> find_number(const JsonValue& root, std::string_view key,
                                  const NumberRange& range);

}  // namespace endmill
