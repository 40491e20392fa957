// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/visibility_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/read_file.h"
#include "endmill/visibility/sphere_grid.h"

namespace endmill {
namespace {

static_assert(std::endian::native == std::endian::little,
              "numbers are copied between file and memory without conversion");

constexpr std::string_view magic = "EMILLBSM";
constexpr std::uint32_t version = 1;
constexpr std::size_t longest_grid = 64;
constexpr std::size_t longest_tool = 1000;
constexpr std::size_t word_bytes = sizeof(std::uint64_t);

// A checksum of 64-bit words in order. Every step is invertible, so a change of a single
// word always changes the sum; random sequences have equal sums with a probability of
// 2^-64.
class WordChecksum {
public:
    // One step: exclusive or, product with an odd number, shift. Each part is invertible.
    void add(std::uint64_t word)
    {
        sum_ = (sum_ ^ word) * 0x9e3779b97f4a7c15U;  // odd: 2^64 over the golden ratio
        sum_ ^= sum_ >> 29U;
    }

    // Adds bytes as words in the order of the machine.
    // \throws DomainError unless their number is a multiple of 8.
    void add(std::string_view bytes)
    {
        require(bytes.size() % word_bytes == 0, "visibility_checksum: need whole words");
        for (std::size_t at = 0; at < bytes.size(); at += word_bytes) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes.data() + at, word_bytes);
            add(word);
        }
    }

    std::uint64_t sum() const { return sum_; }

private:
    std::uint64_t sum_ = 0x243f6a8885a308d3U;  // digits of pi: no words have a sum, too
};

// `bytes` rounded up to a multiple of 8.
constexpr std::size_t whole_words(std::size_t bytes)
{
    return (bytes + word_bytes - 1) / word_bytes * word_bytes;
}

// The header as bytes of the file; its layout has no gaps.
struct Header {
    std::array<char, 8> magic{};
    std::uint32_t version = 0;
    std::uint32_t kind = 0;
    std::uint64_t facets = 0;
    std::uint64_t cells = 0;
    double incidence = 0;
    std::uint64_t part = 0;
    std::uint32_t grid_bytes = 0;
    std::uint32_t tool_bytes = 0;
    std::uint32_t dropped = 0;
    std::uint32_t zero = 0;
};
static_assert(sizeof(Header) == 64);

constexpr std::size_t version_at = 8;
constexpr std::size_t kind_at = 12;
constexpr std::size_t facets_at = 16;
constexpr std::size_t cells_at = 24;
constexpr std::size_t incidence_at = 32;
constexpr std::size_t part_at = 40;
constexpr std::size_t grid_bytes_at = 48;
constexpr std::size_t tool_bytes_at = 52;
constexpr std::size_t dropped_at = 56;
constexpr std::size_t zero_at = 60;
constexpr std::size_t names_at = sizeof(Header);

// Mask of the bits in the last word of a column that stand for facets.
std::uint64_t last_word_mask(std::size_t facets)
{
    return facets % 64 == 0 ? ~std::uint64_t{0} : (std::uint64_t{1} << (facets % 64)) - 1;
}

template <typename Item>
std::string_view bytes_of(const Item* items, std::size_t count)
{
    return {reinterpret_cast<const char*>(items), count * sizeof(Item)};
}

// Writes parts of the file, each filled up to whole words, and their checksum.
class Writer {
public:
    explicit Writer(const OutputFolder::Sink& sink) : sink_{sink} {}

    // Writes a part of the file.
    void write(std::string_view bytes)
    {
        std::string piece{bytes};
        piece.resize(whole_words(bytes.size()), '\0');
        sum_.add(piece);
        sink_(piece);
    }

    // Writes the checksum of all parts.
    void write_sum()
    {
        const std::uint64_t sum = sum_.sum();
        sink_(bytes_of(&sum, 1));
    }

private:
    const OutputFolder::Sink& sink_;
    WordChecksum sum_;
};

// Reads and checks one file. The sizes in the header are checked against the length of
// the file before any memory is allocated; the checksum is compared before the content is
// used.
class Reader {
public:
    Reader(std::string_view content, const std::string& file)
        : content_{content},
          file_{file}
    {
    }

    // Reads the whole file. The order of the checks matters: sizes first, since they
    // protect the memory; then the checksum, since it protects everything else.
    StoredVisibility read(const ReadLimits& limits)
    {
        read_header();
        check_sizes();
        const std::size_t bits_at = content_.size() - word_bytes - column_bytes();
        check_sum();
        require_memory(file_, static_cast<double>(column_bytes()), limits);
        StoredVisibility stored;
        stored.grid = grid_;
        stored.incidence = Angle::radians(header_.incidence);
        stored.kind = header_.kind == 0 ? VisibilityKind::Local : VisibilityKind::Global;
        stored.tool = content_.substr(names_at + header_.grid_bytes, header_.tool_bytes);
        stored.part_checksum = header_.part;
        stored.visibility.dropped = dropped();
        stored.visibility.map = map(bits_at);
        return stored;
    }

private:
    // Throws an error at byte `at`.
    [[noreturn]] void refuse(std::size_t at, const std::string& found,
                             const std::string& expected) const
    {
        throw FormatError{"E_BSM", {file_, '@' + std::to_string(at), found, expected}};
    }

    // Reads the header and checks each value that does not depend on another.
    void read_header()
    {
        if (!content_.starts_with(magic))
            refuse(0, "does not begin as a visibility file",
                   '"' + std::string{magic} + '"');
        if (content_.size() < sizeof header_)
            refuse(content_.size(), "ends within the header",
                   counted(sizeof header_, "byte"));
        std::memcpy(&header_, content_.data(), sizeof header_);
        if (header_.version != version)
            refuse(version_at,
                   "version " + std::to_string(header_.version) +
                       (header_.version > version ? ", made by a newer version" : ""),
                   "version " + std::to_string(version));
        if (header_.kind > 1)
            refuse(kind_at, "kind " + std::to_string(header_.kind), "0 or 1");
        if (!(header_.incidence > 0 && header_.incidence <= std::numbers::pi / 2))
            refuse(incidence_at, "an incidence outside its range",
                   "above 0, at most 90 degrees");
        if (header_.grid_bytes > longest_grid)
            refuse(grid_bytes_at, counted(header_.grid_bytes, "byte") + " of a name",
                   "at most " + std::to_string(longest_grid));
        if (header_.tool_bytes > longest_tool)
            refuse(tool_bytes_at, counted(header_.tool_bytes, "byte") + " of a name",
                   "at most " + std::to_string(longest_tool));
        if (header_.zero != 0)
            refuse(zero_at, std::to_string(header_.zero), "0");
    }

    // Size of the two names with their padding, in bytes.
    std::size_t name_bytes() const
    {
        return whole_words(std::size_t{header_.grid_bytes} + header_.tool_bytes);
    }

    // Size of the list of facets without area with its padding, in bytes.
    std::size_t dropped_bytes() const
    {
        return whole_words(std::size_t{header_.dropped} * sizeof(std::uint32_t));
    }

    // \pre check_sizes has passed.
    std::size_t column_bytes() const
    {
        return header_.cells * ((header_.facets + 63) / 64) * word_bytes;
    }

    // Checks the counts in the header against each other, the length of the file and the
    // grid.
    void check_sizes()
    {
        constexpr std::uint64_t most_facets = (std::uint64_t{1} << 31U) - 1;
        constexpr std::uint64_t most_cells = 10'000'000;
        if (header_.facets > most_facets)
            refuse(facets_at, counted(header_.facets, "facet"),
                   "at most " + std::to_string(most_facets));
        if (header_.cells > most_cells)
            refuse(cells_at, counted(header_.cells, "cell"),
                   "at most " + std::to_string(most_cells));
        if (header_.dropped > header_.facets)
            refuse(dropped_at, counted(header_.dropped, "facet") + " without area",
                   "at most " + std::to_string(header_.facets));
        // At most 2^31 / 64 * 10^7 * 8 bytes, which does not overflow.
        const std::size_t needed =
            names_at + name_bytes() + dropped_bytes() + column_bytes() + word_bytes;
        if (content_.size() != needed)
            refuse(std::min(content_.size(), needed),
                   "file has " + counted(content_.size(), "byte"),
                   std::to_string(needed) + " for " + counted(header_.facets, "facet") +
                       " and " + counted(header_.cells, "cell"));
        grid_ = content_.substr(names_at, header_.grid_bytes);
        std::size_t cells = 0;
        try {
            cells = sphere_grid_cells(grid_);
        } catch (const DomainError&) {
            refuse(names_at, "sphere grid \"" + printable(grid_, longest_grid) + '"',
                   "a name such as hex:10");
        }
        if (cells != header_.cells)
            refuse(cells_at, counted(header_.cells, "cell"),
                   std::to_string(cells) + " of " + grid_);
    }

    // Compares the stored checksum with that of the content.
    void check_sum() const
    {
        const std::size_t at = content_.size() - word_bytes;
        std::uint64_t stored = 0;
        std::memcpy(&stored, content_.data() + at, word_bytes);
        if (stored != visibility_checksum(content_.substr(0, at)))
            refuse(at, "the checksum does not match the content", "an undamaged file");
    }

    // Checks the zeros that fill a part up to whole words.
    void check_zeros(std::size_t begin, std::size_t end) const
    {
        for (std::size_t at = begin; at < end; ++at)
            if (content_[at] != '\0')
                refuse(at, "a byte without meaning", "zero");
    }

    // The facets without area, which must be rising and within the part.
    std::vector<std::size_t> dropped() const
    {
        const std::size_t begin = names_at + name_bytes();
        check_zeros(names_at + header_.grid_bytes + header_.tool_bytes, begin);
        check_zeros(begin + header_.dropped * sizeof(std::uint32_t),
                    begin + dropped_bytes());
        std::vector<std::size_t> facets;
        for (std::size_t k = 0; k < header_.dropped; ++k) {
            const std::size_t at = begin + k * sizeof(std::uint32_t);
            std::uint32_t facet = 0;
            std::memcpy(&facet, content_.data() + at, sizeof facet);
            if (facet >= header_.facets || (k > 0 && facet <= facets.back()))
                refuse(at, "facet " + std::to_string(facet) + " without area",
                       "rising numbers below " + std::to_string(header_.facets));
            facets.push_back(facet);
        }
        return facets;
    }

    // The map. The file has 0 for accessible, as the paper has, and the map has 1, so
    // words are inverted; the bits beyond the last facet must be zero in both.
    VisibilityMap map(std::size_t bits_at) const
    {
        VisibilityMap map{header_.facets, header_.cells};
        const std::uint64_t mask = last_word_mask(map.facets());
        for (std::size_t cell = 0; cell < map.cells() && map.words() > 0; ++cell) {
            const std::span column = map.column(cell);
            const std::size_t at = bits_at + cell * column.size_bytes();
            std::memcpy(column.data(), content_.data() + at, column.size_bytes());
            if ((column.back() & ~mask) != 0)
                refuse(at + column.size_bytes() - word_bytes,
                       "bits beyond the last facet", "zeros");
            for (std::uint64_t& word : column)
                word = ~word;
            column.back() &= mask;
        }
        return map;
    }

    std::string_view content_;
    const std::string& file_;
    Header header_;
    std::string grid_;
};

}  // namespace

// The number of points is included, so that points and triangles cannot be confused.
std::uint64_t part_checksum(const TriangleMesh& part)
{
    WordChecksum sum;
    sum.add(part.points().size());
    for (const Vec3& point : part.points())
        for (const double coordinate : point)
            sum.add(std::bit_cast<std::uint64_t>(coordinate + 0.0));  // -0 becomes 0
    for (const auto& [a, b, c] : part.triangles()) {
        sum.add(static_cast<std::uint64_t>(a) << 32U | static_cast<std::uint32_t>(b));
        sum.add(static_cast<std::uint64_t>(c));
    }
    return sum.sum();
}

std::uint64_t visibility_checksum(std::string_view bytes)
{
    WordChecksum sum;
    sum.add(bytes);
    return sum.sum();
}

void write_visibility(const StoredVisibility& stored, const OutputFolder::Sink& sink)
{
    const VisibilityMap& map = stored.visibility.map;
    require(sphere_grid_cells(stored.grid) == map.cells() &&
                stored.grid.size() <= longest_grid,
            "write_visibility: the grid's name must be that of the map's cells");
    require(stored.tool.size() <= longest_tool,
            "write_visibility: the tool's name is longer than 1000 bytes");
    Header header;
    std::ranges::copy(magic, header.magic.begin());
    header.version = version;
    header.kind = stored.kind == VisibilityKind::Local ? 0 : 1;
    header.facets = map.facets();
    header.cells = map.cells();
    header.incidence = stored.incidence.radians();
    header.part = stored.part_checksum;
    header.grid_bytes = static_cast<std::uint32_t>(stored.grid.size());
    header.tool_bytes = static_cast<std::uint32_t>(stored.tool.size());
    header.dropped = static_cast<std::uint32_t>(stored.visibility.dropped.size());

    Writer writer{sink};
    writer.write(bytes_of(&header, 1));
    writer.write(stored.grid + stored.tool);
    const std::vector<std::uint32_t> dropped(stored.visibility.dropped.begin(),
                                             stored.visibility.dropped.end());
    writer.write(bytes_of(dropped.data(), dropped.size()));
    const std::uint64_t mask = last_word_mask(map.facets());
    std::vector<std::uint64_t> column(map.words());
    for (std::size_t cell = 0; cell < map.cells() && map.words() > 0; ++cell) {
        std::ranges::transform(map.column(cell), column.begin(), std::bit_not<>{});
        column.back() &= mask;
        writer.write(bytes_of(column.data(), column.size()));
    }
    writer.write_sum();
}

StoredVisibility parse_visibility(std::string_view content, const std::string& file,
                                  const ReadLimits& limits)
{
    return Reader{content, file}.read(limits);
}

StoredVisibility read_visibility(const std::filesystem::path& path,
                                 const TriangleMesh& part, const ReadLimits& limits)
{
    const std::string file = shown_path(path);
    StoredVisibility stored = parse_visibility(read_file(path, limits), file, limits);
    if (stored.visibility.map.facets() != part.triangles().size() ||
        stored.part_checksum != part_checksum(part))
        throw FormatError{
            "E_BSM",
            {file, '@' + std::to_string(part_at),
             "the visibility of another part, of " +
                 counted(stored.visibility.map.facets(), "facet"),
             "that of this one, of " + counted(part.triangles().size(), "facet")}};
    return stored;
}

}  // namespace endmill
