// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "endmill/files/detail/strict_json.h"

namespace endmill {

/// The JSON of a file of one format, checked as far as its keys.
class FormatDocument {
public:
    /// What a format is called, and which keys its root may have.
    struct Format {
        std::string_view name;  ///< the whole word, "endmill-tool/1": '/' and a version
        std::span<const std::string_view> keys;
    };

    /// The key `format` is checked first of all, since a newer version may have other keys.
    /// \param path for messages.
    /// \throws FormatError E_FORMAT for what does not begin as JSON does, saying what it looks
    ///         like, and for another format; E_JSON if the format is missing or a newer
    ///         version's, and for other keys; FormatError and LimitError as `JsonDocument`.
    FormatDocument(std::string_view content, const std::filesystem::path& path,
                   const ReadLimits& limits, const Format& format);

    JsonValue root() const& { return document_.root(); }  ///< as of JsonDocument
    JsonValue root() const&& = delete;                    ///< it would dangle

private:
    JsonDocument document_;
};

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
