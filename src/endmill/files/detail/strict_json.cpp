// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/strict_json.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include <nlohmann/json.hpp>

#include "endmill/core/text.h"
#include "endmill/files/detail/json_tree.h"

// A JsonValue is a pointer into the tree of the JSON library and a pointer to the
// JsonValue of its parent. The chain of parents gives the JSON pointer for error messages
// without storing a path for each value. The price is that a parent must outlive its
// children; deleted overloads for temporaries catch most violations at compile time.

namespace endmill {

using nlohmann::json;

JsonValue::JsonValue(const json& root, const std::string& file)
    : value_{&root},
      file_{&file}
{
}

JsonValue::JsonValue(const json& value, const JsonValue& parent, std::string_view key,
                     std::size_t index)
    : value_{&value},
      file_{parent.file_},
      parent_{&parent},
      key_{key},
      index_{index}
{
}

// The path is built only for messages, from the chain of parents.
std::string JsonValue::pointer() const
{
    if (parent_ == nullptr)
        return {};
    return parent_->pointer() + (parent_->value_->is_object()
                                     ? json_pointer_step(key_)
                                     : "/" + std::to_string(index_));
}

// Numbers and words are shown unchanged. Arrays and objects may be as long as the file
// and are shown by their kind only.
std::string JsonValue::shown() const
{
    constexpr std::size_t longest_echo = 40;
    if (value_->is_array())
        return "an array of " + std::to_string(value_->size());
    if (value_->is_object())
        return "an object";
    return printable(value_->dump(), longest_echo);
}

FormatError JsonValue::complaint(const std::string& found, const std::string& expected,
                                 const std::string& code) const
{
    return FormatError{code, {*file_, pointer(), found, expected}};
}

// A missing key is not an error here; a value that is not an object is.
std::optional<JsonValue> JsonValue::find_member(std::string_view key) const&
{
    if (!value_->is_object())
        throw complaint(shown(), "an object");
    const auto found = value_->find(key);
    if (found == value_->end())
        return std::nullopt;
    // The key of the document, not `key`: the view must outlive the caller's text.
    return JsonValue{*found, *this, found.key(), 0};
}

JsonValue JsonValue::member(std::string_view key) const&
{
    const auto found = find_member(key);
    if (!found)
        throw complaint("key \"" + std::string{key} + "\" is missing",
                        "a value under this key");
    return *found;
}

// The error is placed at the unknown key itself.
void JsonValue::allow_only(std::span<const std::string_view> keys) const
{
    if (!value_->is_object())
        throw complaint(shown(), "an object");
    for (const auto& [key, value] : value_->items())
        if (std::find(keys.begin(), keys.end(), key) == keys.end())
            throw JsonValue{value, *this, key, 0}.complaint("unknown key",
                                                            one_of(keys, key));
}

std::vector<std::string_view> JsonValue::keys() const
{
    if (!value_->is_object())
        throw complaint(shown(), "an object");
    std::vector<std::string_view> all;
    for (auto member = value_->begin(); member != value_->end(); ++member)
        all.emplace_back(member.key());
    return all;
}

bool JsonValue::is_array() const
{
    return value_->is_array();
}

std::size_t JsonValue::size() const
{
    if (!value_->is_array())
        throw complaint(shown(), "an array");
    return value_->size();
}

JsonValue JsonValue::item(std::size_t index) const&
{
    assert(index < size());
    return {(*value_)[index], *this, {}, index};
}

bool JsonValue::is_text() const
{
    return value_->is_string();
}

std::string JsonValue::text() const
{
    if (!value_->is_string())
        throw complaint(shown(), "a string");
    return value_->get<std::string>();
}

std::string_view JsonValue::word(std::span<const std::string_view> words) const
{
    const std::string given = text();
    const auto found = std::find(words.begin(), words.end(), given);
    if (found == words.end())
        throw complaint(shown(), one_of(words, given));
    return *found;
}

bool JsonValue::is_truth() const
{
    return value_->is_boolean();
}

bool JsonValue::truth() const
{
    if (!value_->is_boolean())
        throw complaint(shown(), "true or false");
    return value_->get<bool>();
}

std::int64_t JsonValue::whole_number(std::int64_t low, std::int64_t high) const
{
    // The library stores 2^63 and above as unsigned; `get` would wrap them to negative.
    const bool too_large = value_->is_number_unsigned() &&
                           !std::in_range<std::int64_t>(value_->get<std::uint64_t>());
    const bool whole = value_->is_number_integer() && !too_large;
    const std::int64_t number = whole ? value_->get<std::int64_t>() : low - 1;
    if (!whole || number < low || number > high)
        throw complaint(shown(), "a whole number from " + std::to_string(low) + " to " +
                                     std::to_string(high));
    return number;
}

bool JsonValue::is_number() const
{
    return value_->is_number();
}

double JsonValue::number() const
{
    if (!value_->is_number())
        throw complaint(shown(), "a number");
    return value_->get<double>();
}

JsonDocument::JsonDocument(std::string_view text, std::string file,
                           const ReadLimits& limits)
    : file_{std::move(file)},
      root_{json_tree(text, file_, limits)}
{
}

JsonDocument::~JsonDocument() = default;

JsonValue JsonDocument::root() const&
{
    return JsonValue{*root_, file_};
}

}  // namespace endmill
