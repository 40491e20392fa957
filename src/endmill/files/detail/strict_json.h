// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "endmill/core/error.h"
#include "endmill/files/read_file.h"

/// \file
/// Access to a JSON document that checks every type and knows the place of every value,
/// so that error messages can state both.

namespace endmill {

/// A value in a JSON document together with its place. It is a view: the document and the
/// JsonValue from which it was obtained must outlive it.
class JsonValue {
public:
    /// The root of a document that was read from `file`.
    JsonValue(const nlohmann::json& root, const std::string& file);

    /// The place as a JSON pointer: "" for the root, else such as "/control_points/3/0".
    std::string pointer() const;

    /// The value as messages show it: shortened; arrays and objects by their size.
    std::string shown() const;

    /// An error at this place.
    /// \param found    what the file has there.
    /// \param expected what it should have; may be empty.
    FormatError complaint(const std::string& found, const std::string& expected,
                          const std::string& code = "E_JSON") const;

    /// The value of `key`.
    /// \throws FormatError if this is not an object or has no such key.
    JsonValue member(std::string_view key) const&;
    JsonValue member(std::string_view key) const&& = delete;  ///< would dangle

    /// The value of `key`; nothing if this object has no such key.
    /// \throws FormatError if this is not an object.
    std::optional<JsonValue> find_member(std::string_view key) const&;
    std::optional<JsonValue> find_member(std::string_view key) const&& =
        delete;  ///< would dangle

    /// Checks the keys of this object.
    /// \throws FormatError if this is not an object, or has a key outside `keys`; the
    ///         message suggests the closest key.
    void allow_only(std::span<const std::string_view> keys) const;

    /// The keys of this object in alphabetical order. They are views into the document.
    /// \throws FormatError if this is not an object.
    std::vector<std::string_view> keys() const;

    /// Whether this is an array.
    bool is_array() const;

    /// Number of items. \throws FormatError if this is not an array.
    std::size_t size() const;

    /// Item `index`, from 0. \pre index < size()
    JsonValue item(std::size_t index) const&;
    JsonValue item(std::size_t index) const&& = delete;  ///< would dangle

    /// Whether this is a string.
    bool is_text() const;

    /// The string, unchanged. \throws FormatError if this is not a string.
    std::string text() const;

    /// The one of `words` that this string equals.
    /// \throws FormatError, with a suggestion, if this is none of them.
    std::string_view word(std::span<const std::string_view> words) const;

    /// Whether this is true or false.
    bool is_truth() const;

    /// True or false. \throws FormatError if this is neither.
    bool truth() const;

    /// A number without fraction and exponent; 3.0 is refused.
    /// \throws FormatError unless it is one from `low` to `high`.
    std::int64_t whole_number(std::int64_t low, std::int64_t high) const;

    /// Whether this is a number.
    bool is_number() const;

    /// A number; finite, because `json_tree` refuses others.
    /// \throws FormatError if this is not a number.
    double number() const;

private:
    JsonValue(const nlohmann::json& value, const JsonValue& parent, std::string_view key,
              std::size_t index);

    const nlohmann::json* value_;
    const std::string* file_;
    const JsonValue* parent_ = nullptr;
    std::string_view key_;   // under which the parent has it, if that is an object
    std::size_t index_ = 0;  // at which the parent has it, if that is an array
};

/// A parsed JSON text.
class JsonDocument {
public:
    /// \param file name of the file for messages.
    /// \throws FormatError and LimitError as `json_tree`.
    JsonDocument(std::string_view text, std::string file, const ReadLimits& limits = {});
    ~JsonDocument();                             ///< invalidates its JsonValues
    JsonDocument(const JsonDocument&) = delete;  ///< JsonValues refer to it
    JsonDocument& operator=(const JsonDocument&) = delete;  ///< JsonValues refer to it

    JsonValue root() const&;            ///< the outermost value
    JsonValue root() const&& = delete;  ///< would dangle

private:
    std::string file_;
    std::unique_ptr<const nlohmann::json> root_;
};

}  // namespace endmill
