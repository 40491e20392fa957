// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/stl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

// Binary and ASCII STL cannot be told apart by the first word, because many binary files
// begin with "solid". The length of the file decides first: a binary file of n triangles
// has 84 + 50 n bytes. Otherwise a file that begins with "solid" and has no NUL byte near
// its beginning is read as ASCII, and everything else is a damaged binary file.

namespace endmill {
namespace {

static_assert(std::endian::native == std::endian::little,
              "numbers are copied between file and memory without conversion");

using Soup = std::vector<std::array<Vec3, 3>>;

constexpr std::size_t count_at = 80;  // of the number of triangles, after a free text
constexpr std::size_t header_bytes = 84;
constexpr std::size_t triangle_bytes = 50;  // normal, three corners, attributes
constexpr std::size_t normal_bytes = 12;
constexpr std::size_t corner_bytes = 12;

// The shortest facet in ASCII; it bounds the number of triangles in a file.
constexpr std::string_view shortest_facet =
    "facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 0 0 vertex 0 0 0 endloop "
    "endfacet ";

// The number of triangles in the header. \pre the content has a whole header.
std::uint32_t claimed_triangles(std::string_view content)
{
    std::uint32_t count = 0;
    std::memcpy(&count, content.data() + count_at, sizeof count);
    return count;
}

// Size of a binary file in bytes.
std::uint64_t binary_size(std::uint64_t triangles)
{
    return header_bytes + triangle_bytes * triangles;
}

// Whether `a` is the lower-case letter `lower` or its capital.
bool is_letter_case_apart(char a, char lower)
{
    return a == lower || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == lower);
}

// Compares without regard to case, because some programs write keywords in capitals.
bool is_keyword(std::string_view word, std::string_view keyword)
{
    return std::ranges::equal(word, keyword, is_letter_case_apart);
}

constexpr std::size_t binary_start = header_bytes + triangle_bytes;

bool begins_with_solid(std::string_view content)
{
    TextScanner scanner{content.substr(0, binary_start), {}};
    return is_keyword(scanner.word_across_lines(), "solid");
}

// Whether the content begins like an ASCII file: with "solid", and without a NUL byte in
// the length of a binary header and one triangle. Binary files have NUL bytes there.
bool looks_ascii(std::string_view content)
{
    return begins_with_solid(content) &&
           content.substr(0, binary_start).find('\0') == std::string_view::npos;
}

// Reports a binary file whose length contradicts its header, or that is too short to have
// one.
[[noreturn]] void refuse_size(const MeshSource& source)
{
    const std::size_t size = source.content.size();
    const bool may_be_text = begins_with_solid(source.content);
    if (size < header_bytes && may_be_text)
        throw complaint(source, "E_STL_SIZE", FilePlace::byte(source.content.find('\0')),
                        "a zero byte after \"solid\", in a file of " +
                            std::to_string(size) + " bytes",
                        "text without zero bytes, or at least 84 bytes of a binary STL");
    if (size < header_bytes)
        throw FormatError{"E_STL_SIZE",
                          {source.file, "",
                           "file has " + std::to_string(size) +
                               " bytes and does not begin with \"solid\"",
                           "at least 84 bytes of a binary STL"}};
    const std::uint32_t count = claimed_triangles(source.content);
    throw complaint(
        source, "E_STL_SIZE", FilePlace::byte(count_at),
        "header says " + std::to_string(count) + " triangles (" +
            std::to_string(binary_size(count)) + " bytes), file has " +
            std::to_string(size),
        may_be_text ? "a binary STL of that size, or text without zero bytes" : "");
}

// An empty soup with memory for `most_triangles`, after a check of the limits.
Soup empty_soup(const MeshSource& source, std::uint64_t most_triangles)
{
    require_numbers(source, 3 * most_triangles);
    require_memory(source.file,
                   static_cast<double>(source.content.size() +
                                       sizeof(Soup::value_type) * most_triangles),
                   source.limits);
    Soup soup;
    soup.reserve(most_triangles);
    return soup;
}

// The length of the file has been checked, so every triangle is within the content.
Soup read_binary(const MeshSource& source)
{
    const std::uint32_t count = claimed_triangles(source.content);
    Soup soup = empty_soup(source, count);
    for (std::uint32_t i = 0; i < count; ++i) {
        std::size_t at = header_bytes + triangle_bytes * i + normal_bytes;
        std::array<Vec3, 3>& corners = soup.emplace_back();
        for (Vec3& corner : corners) {
            std::array<float, 3> numbers;
            std::memcpy(numbers.data(), source.content.data() + at, corner_bytes);
            corner = point_mm(source, {numbers[0], numbers[1], numbers[2]},
                              FilePlace::byte(at));
            at += corner_bytes;
        }
    }
    return soup;
}

// Reads ASCII STL word by word; line breaks have no meaning except after a name.
class AsciiReader {
public:
    explicit AsciiReader(const MeshSource& source)
        : source_{source},
          scanner_{source.content, {source.file, "E_STL_SYNTAX"}},
          soup_{empty_soup(source, 1 + source.content.size() / shortest_facet.size())}
    {
    }

    // Reads all solids of the file into one soup.
    Soup read()
    {
        expect("solid");
        do
            read_solid();
        while (another_solid());
        return std::move(soup_);
    }

private:
    // Reads a solid after its keyword: the name, the facets, and the name again.
    void read_solid()
    {
        scanner_.skip_line();  // the name of the solid
        for (;;) {
            const std::string_view word = scanner_.word_across_lines();
            if (is_keyword(word, "endsolid"))
                break;
            if (!is_keyword(word, "facet"))
                throw scanner_.complaint_about(word, "\"facet\" or \"endsolid\"");
            read_facet();
        }
        scanner_.skip_line();  // the name again
    }

    // Whether another solid follows. Anything else after a solid is an error.
    bool another_solid()
    {
        const std::string_view word = scanner_.word_across_lines();
        if (!word.empty() && !is_keyword(word, "solid"))
            throw scanner_.complaint_about(word, "\"solid\" or the end of the file");
        return !word.empty();
    }

    // Reads a facet after its keyword. The normal is read and ignored: the order of the
    // corners determines the orientation.
    void read_facet()
    {
        expect("normal");
        for (int c = 0; c < 3; ++c)
            scanner_.number();
        expect("outer");
        expect("loop");
        std::array<Vec3, 3>& corners = soup_.emplace_back();
        for (Vec3& corner : corners) {
            expect("vertex");
            corner = scan_point_mm(scanner_, source_);
        }
        expect("endloop");
        expect("endfacet");
    }

    // Reads the next word, which must be `keyword`.
    void expect(std::string_view keyword)
    {
        const std::string_view word = scanner_.word_across_lines();
        if (!is_keyword(word, keyword))
            throw scanner_.complaint_about(word, '"' + std::string{keyword} + '"');
    }

    const MeshSource& source_;
    TextScanner scanner_;
    Soup soup_;
};

// Unit normal of a triangle; zero if the triangle has no area.
Vec3 facet_normal(const std::array<Vec3, 3>& corners)
{
    // Half the edges, divided by the longest component, so that the cross product neither
    // overflows nor underflows.
    const Vec3 a = corners[1] / 2 - corners[0] / 2;
    const Vec3 b = corners[2] / 2 - corners[0] / 2;
    const double size =
        std::max(a.lpNorm<Eigen::Infinity>(), b.lpNorm<Eigen::Infinity>());
    if (size == 0)
        return Vec3::Zero();
    return (a / size).cross(b / size).stableNormalized();
}

// Appends three coordinates as floats.
void append_floats(std::string& text, const Vec3& vector)
{
    for (int c = 0; c < 3; ++c) {
        require(std::abs(vector[c]) <= std::numeric_limits<float>::max(),
                "stl_text: a coordinate is beyond the range of float");
        const auto number = static_cast<float>(vector[c]);
        std::array<char, sizeof number> bytes;
        std::memcpy(bytes.data(), &number, sizeof number);
        text.append(bytes.data(), bytes.size());
    }
}

// Appends a line with a keyword and three numbers.
void append_numbers(std::string& text, const char* keyword, const Vec3& vector)
{
    text += keyword;
    for (int c = 0; c < 3; ++c) {
        text += ' ';
        append_text(text, vector[c]);
    }
    text += '\n';
}

}  // namespace

bool is_binary_stl(std::string_view content)
{
    return content.size() >= header_bytes &&
           content.size() == binary_size(claimed_triangles(content));
}

std::vector<std::array<Vec3, 3>> parse_stl(const MeshSource& source)
{
    if (is_binary_stl(source.content))
        return read_binary(source);
    if (looks_ascii(source.content))
        return AsciiReader{source}.read();
    refuse_size(source);
}

std::string stl_text(const TriangleMesh& mesh)
{
    const std::size_t count = mesh.triangles().size();
    const auto count_in_header = static_cast<std::uint32_t>(count);
    std::string text = "binary STL in mm, written by endmill";
    text.reserve(binary_size(count));
    text.resize(header_bytes);
    std::memcpy(text.data() + count_at, &count_in_header, sizeof count_in_header);
    for (std::size_t i = 0; i < count; ++i) {
        const std::array<Vec3, 3> corners = mesh.corners(i);
        append_floats(text, facet_normal(corners));
        for (const Vec3& corner : corners)
            append_floats(text, corner);
        text.append(2, '\0');  // no attributes
    }
    return text;
}

std::string stl_ascii_text(const TriangleMesh& mesh)
{
    std::string text = "solid endmill\n";
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
        const std::array<Vec3, 3> corners = mesh.corners(i);
        append_numbers(text, "facet normal", facet_normal(corners));
        text += "outer loop\n";
        for (const Vec3& corner : corners)
            append_numbers(text, "vertex", corner);
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid endmill\n";
}

}  // namespace endmill
