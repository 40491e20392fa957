// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "endmill/core/error.h"
#include "endmill/files/read_file.h"

namespace endmill {

/// A value in a JSON document together with its place, so that a complaint can name both.
/// A view: it refers to its document and to the JsonValue that it was taken from, which
/// must both outlive it.
class JsonValue {
public:
    /// The root of a document that was read from `file`.
    JsonValue(const nlohmann::json& root, const std::string& file);

    /// The place as a JSON pointer: "" for the root, or such as "/control_points/3/0".
    std::string pointer() const;

    /// The value as a message shows it: shortened, arrays and objects by their size.
    std::string shown() const;

    /// The error that names this place, what was found there and what is expected.
    FormatError complaint(const std::string& found, const std::string& expected,
                          const std::string& code = "E_JSON") const;

    /// The value of `key`.
    /// \throws FormatError if this is no object or has no such key.
    JsonValue member(std::string_view key) const&;
    JsonValue member(std::string_view key) const&& = delete;  ///< it would dangle

    /// The value of `key`; none if this object has no such key.
    /// \throws FormatError if this is no object.
    std::optional<JsonValue> find_member(std::string_view key) const&;
    std::optional<JsonValue> find_member(std::string_view key) const&& =
        delete;  ///< ditto

    /// \throws FormatError if this object has a key outside `keys`, with a suggestion.
    void allow_only(std::span<const std::string_view> keys) const;

    /// Number of items. \throws FormatError if this is no array.
    std::size_t size() const;

    /// Item `index`, from 0. \pre index < size()
    JsonValue item(std::size_t index) const&;
    JsonValue item(std::size_t index) const&& = delete;  ///< it would dangle

    /// The string as it stands. \throws FormatError if this is none.
    std::string text() const;

    /// Which of `words` this string is. \throws FormatError, with a suggestion, if none.
    std::string_view word(std::span<const std::string_view> words) const;

    /// A whole number written as one: 3.0 is refused.
    /// \throws FormatError unless it is one in low … high.
    std::int64_t whole_number(std::int64_t low, std::int64_t high) const;

    /// A number, finite because the document is. \throws FormatError if this is none.
    double number() const;

private:
    JsonValue(const nlohmann::json& value, const JsonValue& parent, std::string_view key,
              std::size_t index);

    const nlohmann::json* value_;
    const std::string* file_;
    const JsonValue* parent_ = nullptr;
    std::string_view key_;   // in an object
    std::size_t index_ = 0;  // in an array
};

/// A JSON text, read strictly.
class JsonDocument {
public:
    /// \param file the name for messages.
    /// \throws FormatError and LimitError as `json_tree`.
    JsonDocument(std::string_view text, std::string file, const ReadLimits& limits = {});
    ~JsonDocument();                                        ///< ends all its JsonValues
    JsonDocument(const JsonDocument&) = delete;             ///< they refer to this one
    JsonDocument& operator=(const JsonDocument&) = delete;  ///< ditto

    JsonValue root() const&;            ///< the value that the text spells
    JsonValue root() const&& = delete;  ///< it would dangle

private:
    std::string file_;
    std::unique_ptr<const nlohmann::json> root_;
};

/// `text` as a JSON string with its quotes; what is not UTF-8 becomes U+FFFD.
std::string json_string(std::string_view text);

}  // namespace endmill
