// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/history_arrays.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

// Layout of the arrays, each with its size in bytes as UInt64 in front:
//
//     block_mm        6 doubles: low x, y, z, high x, y, z
//     run_cutters_mm  2 doubles for each run: radius, corner radius
//     run_tips        2 int64 for each run: number of tips; 1 if the cutter stands at the
//                     first tip, else 0
//     tips_mm         3 doubles for each tip, run by run

namespace endmill {
namespace {

static_assert(std::endian::native == std::endian::little,
              "the file declares LittleEndian and holds the numbers as memory does");

using Size = std::uint64_t;  // number of bytes, in front of each array

constexpr std::string_view runs_key =
    "Name=\"run_tips\" NumberOfComponents=\"2\" NumberOfTuples=\"";
constexpr std::string_view tips_key =
    "Name=\"tips_mm\" NumberOfComponents=\"3\" NumberOfTuples=\"";
constexpr double bytes_a_run = 4 * sizeof(double);
constexpr double bytes_a_tip = 3 * sizeof(double);
constexpr double bytes_of_block = 6 * sizeof(double);
constexpr double arrays = 4;

template <typename Value>
void append_bytes(std::string& file, const Value& value)
{
    const auto* bytes = reinterpret_cast<const char*>(&value);
    file.append(bytes, sizeof value);
}

// The number after a key; 0, which no history has, if the text there is not a number.
std::optional<std::int64_t> named_count(std::string_view head, std::string_view key)
{
    const std::size_t begin = head.find(key);
    if (begin == std::string_view::npos)
        return std::nullopt;
    const std::string_view text = head.substr(begin + key.size());
    std::int64_t count = 0;
    std::from_chars(text.data(), text.data() + text.size(), count);
    return count;
}

// Reads the arrays in order: block, cutters of the runs, tip counts of the runs, tips.
class HistoryReader {
public:
    // Starts at byte `at`, where the size of the first array stands.
    HistoryReader(std::string_view content, std::size_t at, const std::string& file,
                  const ReadLimits& limits)
        : content_{content},
          at_{at},
          file_{file},
          limits_{limits}
    {
    }

    // Reads all four arrays. Numbers of tips are checked against the rest before memory
    // is allocated for the tips of a run, so a damaged count cannot exhaust the memory.
    StockHistory history(const HistoryCounts& counts)
    {
        begin_array(bytes_of_block);
        const Vec3 low = vec();
        const Vec3 high = vec();
        if (!(low.array() < high.array()).all())
            throw complaint("E_RANGE", "a block whose corners are exchanged",
                            "low below high along x, y and z");
        StockHistory history{{low, high}, {}};
        const auto runs = static_cast<std::size_t>(counts.runs);
        begin_array(bytes_a_run / 2 * static_cast<double>(runs));
        for (std::size_t k = 0; k < runs; ++k)
            history.runs.push_back({cutter(), false, {}});
        begin_array(bytes_a_run / 2 * static_cast<double>(runs));
        const std::size_t at_runs = at_;
        std::int64_t left = counts.tips;
        for (EarlierRun& run : history.runs)
            left -= read_run(run, left);
        if (left != 0)
            throw complaint("E_VTI", "more tips than the runs have", "equal numbers",
                            at_runs);
        begin_array(bytes_a_tip * static_cast<double>(counts.tips));
        for (EarlierRun& run : history.runs)
            for (Vec3& tip : run.tips)
                tip = vec();
        return history;
    }

private:
    // An error at byte `at`, by default at the current position.
    FormatError complaint(const std::string& code, const std::string& found,
                          const std::string& expected,
                          std::optional<std::size_t> at = {}) const
    {
        return {code, {file_, "@" + std::to_string(at.value_or(at_)), found, expected}};
    }

    template <typename Value>
    Value next()
    {
        Value value;
        std::memcpy(&value, content_.data() + at_, sizeof value);
        at_ += sizeof value;
        return value;
    }

    // Reads the size in front of an array and compares it with the expected size.
    void begin_array(double bytes)
    {
        const std::size_t before = at_;
        if (static_cast<double>(next<Size>()) != bytes)
            throw complaint("E_VTI", "an array of another length than the head states",
                            to_text(bytes) + " bytes", before);
    }

    // The next number, a finite coordinate or length within the limit.
    double coordinate()
    {
        const std::size_t before = at_;
        const auto value = next<double>();
        if (!std::isfinite(value))
            throw complaint("E_NONFINITE", "a coordinate that is not finite",
                            "a number of mm", before);
        if (!(std::abs(value) <= limits_.max_extent_mm))
            throw complaint("E_RANGE", "a coordinate of " + to_text(value) + " mm",
                            "at most " + to_text(limits_.max_extent_mm) + " mm", before);
        return value;
    }

    // The next three numbers. They are read one after the other, because the order of
    // evaluation of arguments is not defined.
    Vec3 vec()
    {
        const double x = coordinate();
        const double y = coordinate();
        const double z = coordinate();
        return {x, y, z};
    }

    // The radius and the corner radius of a cutter.
    Cutter cutter()
    {
        const std::size_t before = at_;
        const double radius = coordinate();
        const double corner = coordinate();
        if (!(0 < radius && 0 <= corner && corner <= radius))
            throw complaint("E_RANGE",
                            "a cutter of radius " + to_text(radius) +
                                " mm and corner radius " + to_text(corner) + " mm",
                            "0 < radius, 0 <= corner radius <= radius", before);
        return {radius, corner};
    }

    // Reads the number of tips of a run, at most `most`, and whether it stands at the
    // first.
    std::int64_t read_run(EarlierRun& run, std::int64_t most)
    {
        const std::size_t before = at_;
        const auto tips = next<std::int64_t>();
        const auto stands = next<std::int64_t>();
        if (!(1 <= tips && tips <= most) || (stands != 0 && stands != 1))
            throw complaint("E_VTI", "a run without tips, or with more than the file has",
                            "1 to " + std::to_string(most) + ", and 0 or 1", before);
        run.tips.resize(static_cast<std::size_t>(tips));
        run.stands_at_first = stands == 1;
        return tips;
    }

    std::string_view content_;
    std::size_t at_;
    const std::string& file_;
    const ReadLimits& limits_;
};

}  // namespace

HistoryCounts counts_of(const StockHistory& history)
{
    HistoryCounts counts{static_cast<std::int64_t>(history.runs.size()), 0};
    for (const EarlierRun& run : history.runs)
        counts.tips += static_cast<std::int64_t>(run.tips.size());
    return counts;
}

// Searches the head for the two elements with counts. Other content of the head is
// compared byte for byte by the caller.
std::optional<HistoryCounts> named_history(std::string_view head)
{
    const auto runs = named_count(head, runs_key);
    const auto tips = named_count(head, tips_key);
    if (!runs || !tips)
        return std::nullopt;
    return HistoryCounts{*runs, *tips};
}

// The arrays follow each other without gaps; each has its size in front.
std::string history_elements(const HistoryCounts& counts, std::uint64_t offset)
{
    const std::string runs = std::to_string(counts.runs);
    const auto element = [&](std::string_view type, const std::string& what) {
        return "   <DataArray type=\"" + std::string{type} + "\" " + what +
               "\" format=\"appended\" offset=\"" + std::to_string(offset) + "\"/>\n";
    };
    const auto pass = [&](double bytes) {
        offset += sizeof(Size) + static_cast<std::uint64_t>(bytes);
    };
    const double of_runs = bytes_a_run / 2 * static_cast<double>(counts.runs);
    std::string text = element("Float64", "Name=\"block_mm\" NumberOfTuples=\"6");
    pass(bytes_of_block);
    text += element("Float64",
                    "Name=\"run_cutters_mm\" NumberOfComponents=\"2\" "
                    "NumberOfTuples=\"" +
                        runs);
    pass(of_runs);
    text += element("Int64", std::string{runs_key} + runs);
    pass(of_runs);
    return text + element("Float64", std::string{tips_key} + std::to_string(counts.tips));
}

double history_bytes(const HistoryCounts& counts)
{
    return arrays * sizeof(Size) + bytes_of_block +
           bytes_a_run * static_cast<double>(counts.runs) +
           bytes_a_tip * static_cast<double>(counts.tips);
}

// Writes the arrays in the order of `history_elements`.
void append_history(std::string& file, const StockHistory& history)
{
    const HistoryCounts counts = counts_of(history);
    const auto vec = [&](const Vec3& place) {
        for (int c = 0; c < 3; ++c)
            append_bytes(file, place[c]);
    };
    append_bytes(file, static_cast<Size>(bytes_of_block));
    vec(history.block.low);
    vec(history.block.high);
    const auto of_runs =
        static_cast<Size>(bytes_a_run / 2 * static_cast<double>(counts.runs));
    append_bytes(file, of_runs);
    for (const EarlierRun& run : history.runs) {
        append_bytes(file, run.cutter.radius());
        append_bytes(file, run.cutter.corner_radius());
    }
    append_bytes(file, of_runs);
    for (const EarlierRun& run : history.runs) {
        append_bytes(file, static_cast<std::int64_t>(run.tips.size()));
        append_bytes(file, std::int64_t{run.stands_at_first});
    }
    append_bytes(file, static_cast<Size>(bytes_a_tip * static_cast<double>(counts.tips)));
    for (const EarlierRun& run : history.runs)
        for (const Vec3& tip : run.tips)
            vec(tip);
}

StockHistory parse_history(std::string_view content, std::size_t at,
                           const HistoryCounts& counts, const std::string& file,
                           const ReadLimits& limits)
{
    return HistoryReader{content, at, file, limits}.history(counts);
}

}  // namespace endmill
