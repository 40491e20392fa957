// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/json_tree.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

// The JSON library parses; this file adds what it does not check.
//
// 1. OutlineReader passes over the text once. It counts brackets, commas and strings,
//    which bounds the memory of the tree, and refuses deep nesting and NUL bytes.
// 2. The memory bound is compared with the limit before the tree is built.
// 3. TreeBuilder receives the events of the parser and builds the tree. It refuses
//    repeated keys and numbers that underflow, and turns parser errors into FormatErrors
//    with line and column.

namespace endmill {
namespace {

using nlohmann::json;

// Far more than any format of this library needs; it bounds the recursion of destructors.
constexpr int deepest_nesting = 64;

// "LINE:COLUMN" of the character at `offset`, both from 1. Columns count characters, not
// bytes.
std::string line_and_column(std::string_view text, std::size_t offset)
{
    const std::string_view before = text.substr(0, offset);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::string_view in_line = before.substr(before.rfind('\n') + 1);
    const auto starts_character = [](char byte) {
        return (static_cast<unsigned char>(byte) & 0xc0U) != 0x80;
    };
    const auto column =
        std::count_if(in_line.begin(), in_line.end(), starts_character) + 1;
    return std::to_string(line) + ":" + std::to_string(column);
}

// Counts of brackets, commas and quotes, which bound the size of the tree.
struct Outline {
    std::size_t separators = 0;  // commas
    std::size_t arrays = 0;
    std::size_t objects = 0;
    std::size_t strings = 0;  // keys included
};

// Position after the closing quote of the string whose opening quote is at `begin`.
std::size_t end_of_string(std::string_view text, std::size_t begin)
{
    std::size_t at = begin + 1;
    while (at < text.size() && text[at] != '"')
        at += text[at] == '\\' ? 2 : 1;
    return std::min(at + 1, text.size());
}

// Reads the outline. It refuses nesting that would overflow the stack, and NUL bytes,
// which the parser takes for the end of the text.
class OutlineReader {
public:
    OutlineReader(std::string_view text, const std::string& file)
        : text_{text},
          file_{file}
    {
    }

    // Passes over the text. Strings are skipped as a whole, because brackets in them do
    // not count.
    Outline read()
    {
        for (std::size_t at = 0; at < text_.size();)
            at = text_[at] == '"' ? skip_string(at) : count(at);
        return outline_;
    }

private:
    // Counts a string. \return the position after it.
    std::size_t skip_string(std::size_t at)
    {
        ++outline_.strings;
        return end_of_string(text_, at);
    }

    // Counts the character at `at` and checks the nesting. \return the next position.
    std::size_t count(std::size_t at)
    {
        const char character = text_[at];
        outline_.separators += character == ',' ? 1 : 0;
        outline_.arrays += character == '[' ? 1 : 0;
        outline_.objects += character == '{' ? 1 : 0;
        depth_ += character == '[' || character == '{' ? 1 : 0;
        depth_ -= character == ']' || character == '}' ? 1 : 0;
        if (depth_ > deepest_nesting)
            refuse(at, "nested deeper than 64", "at most 64 levels");
        if (character == '\0')
            refuse(at, "a NUL byte", "text");
        return at + 1;
    }

    // Throws an error at the line and column of `at`.
    [[noreturn]] void refuse(std::size_t at, const char* found,
                             const char* expected) const
    {
        throw FormatError{"E_JSON", {file_, line_and_column(text_, at), found, expected}};
    }

    std::string_view text_;
    const std::string& file_;
    Outline outline_;
    int depth_ = 0;
};

// Upper bound of the memory of the tree while it grows, in bytes, on a 64-bit machine
// with the allocator of glibc. A value has 16 bytes and is stored in a vector that may
// have twice the capacity, plus half of it while the vector grows. An empty vector takes
// 32 bytes, a map 64, a map node 96, a string 48.
double tree_bytes(const Outline& outline, std::size_t text_bytes)
{
    const auto values =
        static_cast<double>(outline.separators + outline.arrays + outline.objects + 1);
    return static_cast<double>(text_bytes) + 48 * values +
           32 * static_cast<double>(outline.arrays) +
           64 * static_cast<double>(outline.objects) +
           144 * static_cast<double>(outline.strings);
}

// Whether a number is written as zero: all digits before the exponent are zero.
bool spells_zero(std::string_view number)
{
    const std::string_view digits = number.substr(0, number.find_first_of("eE"));
    return digits.find_first_of("123456789") == std::string_view::npos;
}

// The word around `offset`: letters, digits, signs and points.
std::string_view word_around(std::string_view text, std::size_t offset)
{
    constexpr std::string_view of_word =
        "0123456789+-.abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    const auto before = text.substr(0, offset).find_last_not_of(of_word);
    const auto begin = before == std::string_view::npos ? 0 : before + 1;
    const auto end = std::min(text.find_first_not_of(of_word, offset), text.size());
    return text.substr(begin, end - begin);
}

// Whether the word is infinity or NaN in the notation of other languages.
bool spells_no_finite_number(std::string_view word)
{
    if (word.starts_with('-') || word.starts_with('+'))
        word.remove_prefix(1);
    std::string lower{word};
    std::ranges::transform(lower, lower.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a')
                                              : letter;
    });
    return lower == "nan" || lower == "inf" || lower == "infinity";
}

// Builds the tree from the events of the parser, with additional checks.
class TreeBuilder final : public nlohmann::json_sax<json> {
public:
    TreeBuilder(std::string_view text, const std::string& file) : text_{text}, file_{file}
    {
    }

    json take() { return std::move(root_); }

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(value); }
    bool number_unsigned(number_unsigned_t value) override { return add(value); }
    bool string(string_t& value) override { return add(std::move(value)); }
    bool binary(binary_t& /*value*/) override { return false; }

    // The parser turns numbers that are too small into zero without an error. They are
    // refused, because a zero would be silently wrong.
    bool number_float(number_float_t value, const string_t& spelling) override
    {
        add(value);
        if (value == 0 && !spells_zero(spelling))
            refuse(printable(spelling, longest_echo) + " underflows to zero",
                   "a number that a double can hold");
        return true;
    }

    bool start_object(std::size_t /*size*/) override { return open(json::object()); }
    bool start_array(std::size_t /*size*/) override { return open(json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    // The library keeps the last of several equal keys; here a repeated key is an error.
    bool key(string_t& name) override
    {
        open_.back().key = std::move(name);
        if (open_.back().value->contains(open_.back().key))
            refuse("duplicate key \"" + printable(open_.back().key, longest_echo) + "\"",
                   "every key once");
        return true;
    }

    // NaN and infinity get a message of their own, because they are a common mistake.
    bool parse_error(std::size_t position, const std::string& /*last_token*/,
                     const json::exception& error) override
    {
        const std::size_t offset =
            std::min(std::max<std::size_t>(position, 1) - 1, text_.size());
        const std::string_view word = word_around(text_, offset);
        if (spells_no_finite_number(word))
            refuse_at(static_cast<std::size_t>(word.data() - text_.data()),
                      {std::string{word} + " is not a JSON number", "a finite number"});
        refuse_at(offset, without_preamble(error.what()));
    }

private:
    static constexpr std::size_t longest_echo = 40;

    // An object or array whose closing bracket has not been read.
    struct Container {
        json* value;
        string_t key;  // of the last member, if it is an object
    };

    // The two parts of an error message.
    struct Complaint {
        std::string found;
        std::string expected;
    };

    // Splits the message of the library, "[json.exception…] parse error at … - FOUND;
    // last read: '…'; expected EXPECTED". The last read token is left out, because the
    // message has line and column instead.
    static Complaint without_preamble(std::string message)
    {
        constexpr std::string_view before_echo = "; last read: '";
        constexpr std::string_view before_found = " - ";
        constexpr std::string_view before_expected = "; expected ";
        constexpr std::size_t longest_message = 160;
        if (const auto at = message.find(before_found); at != std::string::npos)
            message.erase(0, at + before_found.size());
        else if (const auto end = message.find("] "); end != std::string::npos)
            message.erase(0, end + 2);
        if (const auto echo = message.find(before_echo); echo != std::string::npos)
            message.erase(echo, message.rfind('\'') + 1 - echo);
        const auto split = message.rfind(before_expected);
        if (split == std::string::npos)
            return {printable(message, longest_message),
                    message.starts_with("number overflow") ? "a finite number"
                                                           : "valid JSON"};
        return {printable(message.substr(0, split), longest_message),
                printable(message.substr(split + before_expected.size()), longest_echo)};
    }

    // Throws an error at the line and column of `offset`.
    [[noreturn]] void refuse_at(std::size_t offset, const Complaint& complaint) const
    {
        throw FormatError{
            "E_JSON",
            {file_, line_and_column(text_, offset), complaint.found, complaint.expected}};
    }

    // Throws an error about the value or key that was added last.
    [[noreturn]] void refuse(const std::string& found, const std::string& expected) const
    {
        std::string pointer;
        for (const Container& container : open_)
            pointer += container.value->is_object()
                           ? json_pointer_step(container.key)
                           : "/" + std::to_string(container.value->size() - 1);
        throw FormatError{"E_JSON", {file_, pointer, found, expected}};
    }

    // Adds a value to the open array, or under the current key to the open object.
    template <class Value>
    json* place(Value&& value)
    {
        if (open_.empty()) {
            root_ = std::forward<Value>(value);
            return &root_;
        }
        json& container = *open_.back().value;
        if (container.is_array()) {
            container.push_back(std::forward<Value>(value));
            return &container.back();
        }
        return &(container[open_.back().key] = std::forward<Value>(value));
    }

    template <class Value>
    bool add(Value&& value)
    {
        place(json(std::forward<Value>(value)));
        return true;
    }

    // Adds an empty object or array and makes it the open one.
    bool open(json&& container)
    {
        open_.push_back({place(std::move(container)), {}});
        return true;
    }

    // Closes the open object or array.
    bool close()
    {
        open_.pop_back();
        return true;
    }

    std::string_view text_;
    const std::string& file_;
    json root_;
    std::vector<Container> open_;
};

// Some editors begin a UTF-8 file with a byte order mark, which RFC 8259 lets a reader
// ignore.
std::string_view without_byte_order_mark(std::string_view text)
{
    constexpr std::string_view mark = "\xef\xbb\xbf";
    if (text.starts_with(mark))
        text.remove_prefix(mark.size());
    return text;
}

}  // namespace

std::unique_ptr<const json> json_tree(std::string_view text, const std::string& file,
                                      const ReadLimits& limits)
{
    text = without_byte_order_mark(text);
    const Outline outline = OutlineReader{text, file}.read();
    require_memory(file, tree_bytes(outline, text.size()), limits);
    TreeBuilder builder{text, file};
    json::sax_parse(text.begin(), text.end(), &builder);
    return std::make_unique<const json>(builder.take());
}

// In a pointer, "~" is written "~0" and "/" is written "~1".
std::string json_pointer_step(std::string_view key)
{
    constexpr std::size_t longest_key = 64;
    std::string step = "/";
    for (const char character : printable(key, longest_key)) {
        if (character == '~')
            step += "~0";
        else if (character == '/')
            step += "~1";
        else
            step += character;
    }
    return step;
}

}  // namespace endmill
