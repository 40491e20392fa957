// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace endmill {
namespace {

// Largest number of elements and properties together; it bounds the memory of the header.
constexpr std::size_t most_properties = 1000;

// A name of a type. Every type has two names, an old one and one with its width.
struct TypeName {
    std::string_view name;
    PlyType type;
};

constexpr std::array type_names{
    TypeName{"char", PlyType::Int8},      TypeName{"int8", PlyType::Int8},
    TypeName{"uchar", PlyType::Uint8},    TypeName{"uint8", PlyType::Uint8},
    TypeName{"short", PlyType::Int16},    TypeName{"int16", PlyType::Int16},
    TypeName{"ushort", PlyType::Uint16},  TypeName{"uint16", PlyType::Uint16},
    TypeName{"int", PlyType::Int32},      TypeName{"int32", PlyType::Int32},
    TypeName{"uint", PlyType::Uint32},    TypeName{"uint32", PlyType::Uint32},
    TypeName{"float", PlyType::Float32},  TypeName{"float32", PlyType::Float32},
    TypeName{"double", PlyType::Float64}, TypeName{"float64", PlyType::Float64}};

// Least size of an item in bytes: a binary number has the width of its type, an ASCII
// number a digit and white space. A list may be empty and counts by its length only.
std::uint64_t least_item_bytes(const PlyElement& element, PlyEncoding encoding)
{
    std::uint64_t bytes = 0;
    for (const PlyProperty& property : element.properties)
        bytes += encoding == PlyEncoding::Ascii
                     ? 2
                     : size_of(property.count_type.value_or(property.type));
    return bytes;
}

// Reads the lines of a header in order.
class HeaderReader {
public:
    explicit HeaderReader(const MeshSource& source)
        : source_{source},
          scanner_{source.content, {source.file, "E_PLY_SYNTAX"}}
    {
    }

    // Reads the whole header and checks that its claims fit into the file.
    PlyHeader read()
    {
        expect_word("ply", next_statement());
        scanner_.expect_line_end();
        expect_word("format", next_statement());
        read_format();
        while (read_statement(next_statement()))
            ;
        header_.bytes = scanner_.bytes_up_to_line_end();
        header_.lines = scanner_.line();
        require_properties();
        require_room();
        return std::move(header_);
    }

private:
    // The first word of the next line that is no comment.
    std::string_view next_statement()
    {
        while (scanner_.next_line()) {
            const std::string_view word = scanner_.word();
            if (word != "comment" && word != "obj_info")
                return word;
        }
        return {};
    }

    // Checks that `word`, which was read, is `expected`.
    void expect_word(const std::string& expected, std::string_view word)
    {
        if (word != expected)
            throw scanner_.complaint_about(word, '"' + expected + '"');
    }

    // Reads the rest of the format line: the encoding and the version 1.0.
    void read_format()
    {
        const std::string_view word = scanner_.word();
        if (word == "ascii")
            header_.encoding = PlyEncoding::Ascii;
        else if (word == "binary_little_endian")
            header_.encoding = PlyEncoding::LittleEndian;
        else if (word == "binary_big_endian")
            header_.encoding = PlyEncoding::BigEndian;
        else
            throw scanner_.complaint_about(
                word, "\"ascii\", \"binary_little_endian\" or \"binary_big_endian\"");
        expect_word("1.0", scanner_.word());
        scanner_.expect_line_end();
    }

    // \return whether the header goes on.
    bool read_statement(std::string_view word)
    {
        if (word == "element")
            read_element();
        else if (word == "property")
            read_property();
        else if (word != "end_header")
            throw scanner_.complaint_about(word,
                                           "\"element\", \"property\" or \"end_header\"");
        scanner_.expect_line_end();
        return word != "end_header";
    }

    // Reads the rest of an element line: its name and the number of items.
    void read_element()
    {
        count_property();
        PlyElement element{scanner_.word(), 0, {}, scanner_.line()};
        if (element.name.empty())
            throw scanner_.complaint_about({}, "the name of an element");
        if (std::ranges::find(header_.elements, element.name, &PlyElement::name) !=
            header_.elements.end())
            throw scanner_.complaint_about(element.name, "every element once");
        element.count = read_count();
        header_.elements.push_back(std::move(element));
    }

    // Reads the number of items, which must not be negative.
    std::uint64_t read_count()
    {
        const std::int64_t count = scanner_.whole_number();
        if (count < 0)
            throw complaint(source_, "E_COUNT", FilePlace::line(scanner_.line()),
                            "header claims " + std::to_string(count) + " items",
                            "0 or more");
        return static_cast<std::uint64_t>(count);
    }

    // Reads the rest of a property line, of a number or a list, for the last element.
    void read_property()
    {
        count_property();
        if (header_.elements.empty())
            throw scanner_.complaint("a property before any element",
                                     "an element before it");
        std::optional<PlyType> count_type;
        std::string_view word = scanner_.word();
        if (word == "list") {
            count_type = type(scanner_.word());
            if (!is_whole(*count_type))
                throw scanner_.complaint("the length of a list is not a whole number",
                                         "a type of whole numbers");
            word = scanner_.word();
        }
        const PlyType number_type = type(word);
        add_property({scanner_.word(), number_type, count_type});
    }

    // Adds a property to the last element; its name must be new there.
    void add_property(const PlyProperty& property)
    {
        std::vector<PlyProperty>& properties = header_.elements.back().properties;
        if (property.name.empty())
            throw scanner_.complaint_about({}, "the name of a property");
        if (std::ranges::find(properties, property.name, &PlyProperty::name) !=
            properties.end())
            throw scanner_.complaint_about(property.name,
                                           "every property of an element once");
        properties.push_back(property);
    }

    // Counts elements and properties together, to bound the memory of the header.
    void count_property()
    {
        if (++properties_ > most_properties)
            throw complaint(source_, "E_LIMIT", FilePlace::line(scanner_.line()),
                            "over 1000 elements and properties", "at most 1000");
    }

    // The type with this name.
    PlyType type(std::string_view word) const
    {
        const auto found = std::ranges::find(type_names, word, &TypeName::name);
        if (found == type_names.end())
            throw scanner_.complaint_about(
                word, "a type: char, uchar, short, ushort, int, uint, float or double");
        return found->type;
    }

    // An element without properties would have items of no bytes, whose number is
    // unlimited.
    void require_properties() const
    {
        for (const PlyElement& element : header_.elements)
            if (element.properties.empty())
                throw complaint(source_, "E_PLY_SYNTAX", FilePlace::line(element.line),
                                "an element without properties", "at least one");
    }

    // Checks that the claimed items fit into the file, element by element, before memory
    // is allocated for them.
    void require_room() const
    {
        std::uint64_t bytes = source_.content.size() - header_.bytes;
        if (header_.encoding == PlyEncoding::Ascii)
            ++bytes;  // the last line may lack its line feed
        for (const PlyElement& element : header_.elements) {
            const std::uint64_t each = least_item_bytes(element, header_.encoding);
            if (element.count > bytes / each)
                throw complaint(
                    source_, "E_COUNT", FilePlace::line(element.line),
                    "header claims " + std::to_string(element.count) +
                        " items, file of " + std::to_string(source_.content.size()) +
                        " bytes can hold at most " + std::to_string(bytes / each),
                    "");
            bytes -= element.count * each;
        }
    }

    const MeshSource& source_;
    TextScanner scanner_;
    PlyHeader header_{};
    std::size_t properties_ = 0;
};

}  // namespace

std::size_t size_of(PlyType type)
{
    switch (type) {
        case PlyType::Int8:
        case PlyType::Uint8:
            return 1;
        case PlyType::Int16:
        case PlyType::Uint16:
            return 2;
        case PlyType::Int32:
        case PlyType::Uint32:
        case PlyType::Float32:
            return 4;
        case PlyType::Float64:
            return 8;
    }
    return 0;
}

bool is_whole(PlyType type)
{
    return type != PlyType::Float32 && type != PlyType::Float64;
}

PlyHeader parse_ply_header(const MeshSource& source)
{
    return HeaderReader{source}.read();
}

}  // namespace endmill
