// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/dexel_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

// The file is a sequence of numbers of 8 bytes, but for the dexels, which are numbers of 4
// bytes in pairs. The reader takes them in order and checks each one. Memory is allocated
// only for as many items as the rest of the file can hold.

namespace endmill {
namespace {

static_assert(std::endian::native == std::endian::little,
              "numbers are copied between file and memory without conversion");

constexpr std::string_view magic = "EMILLDEX";
constexpr std::int64_t version = 1;
constexpr std::size_t word_bytes = 8;
// Longest word of a machine; real ones have below 20 letters.
constexpr std::int64_t longest_word = 64;
// Largest difference from 1 of the length of a tool axis, and of the rows of a rotation from
// unit vectors at right angles: above the rounding of all programs that write them.
constexpr double unit_tolerance = 1e-9;
// Least number of bytes per ray: the counts of both sets.
constexpr double least_bytes_a_ray = 8;
constexpr double doubles_a_pose = 6;
constexpr double doubles_a_position = 5;

template <typename Value>
void append(std::string& file, const Value& value)
{
    const auto* bytes = reinterpret_cast<const char*>(&value);
    file.append(bytes, sizeof value);
}

void append(std::string& file, const Vec3& place)
{
    for (int c = 0; c < 3; ++c)
        append(file, place[c]);
}

void append_machine(std::string& file, const PartOnMachine& setup)
{
    const std::string& word = setup.machine.configuration.word;
    append(file, static_cast<std::int64_t>(word.size()));
    std::string padded = word;
    padded.resize((word.size() + word_bytes - 1) / word_bytes * word_bytes, '\0');
    file += padded;
    append(file, setup.machine.pivot);
    append(file, setup.tool_length);
    append(file, setup.machine.table_offset);
    append(file, setup.machine.axis_offset);
    for (int row = 0; row < 3; ++row)
        append(file, Vec3{setup.part_to_machine.row(row).transpose()});
    append(file, setup.clamp);
}

std::int64_t interpolation_number(const EarlierTurningRun& run)
{
    if (!run.machine)
        return 0;
    return run.machine->interpolation == Interpolation::Tcp ? 1 : 2;
}

void append_run(std::string& file, const EarlierTurningRun& run)
{
    append(file, run.cutter.cutter().radius());
    append(file, run.cutter.cutter().corner_radius());
    append(file, run.cutter.length());
    append(file, std::int64_t{run.stands_at_first});
    append(file, interpolation_number(run));
    append(file, static_cast<std::int64_t>(run.poses.size()));
    if (!run.machine) {
        for (const CutterLocation& pose : run.poses) {
            append(file, pose.tip);
            append(file, pose.axis);
        }
        return;
    }
    append_machine(file, run.machine->setup);
    for (const AxisPositions& at : run.machine->positions) {
        append(file, at.rotary[0]);
        append(file, at.rotary[1]);
        append(file, at.xyz);
    }
}

void append_field(std::string& file, const DexelField& field)
{
    for (const auto set : {&DexelField::upper, &DexelField::lower}) {
        std::string counts;
        std::string intervals;
        std::uint32_t rays = 0;
        for (int row = 0; row < field.rows(); ++row)
            for (int column = 0; column < field.columns(); ++column) {
                const auto of_ray = (field.*set)(column, row);
                append(counts, static_cast<std::uint32_t>(of_ray.size()));
                ++rays;
                for (const DexelInterval& interval : of_ray) {
                    append(intervals, interval.from);
                    append(intervals, interval.to);
                }
            }
        if (rays % 2 == 1)
            append(counts, std::uint32_t{0});
        file += counts;
        file += intervals;
    }
}

// Reads and checks one file.
class DexelReader {
public:
    DexelReader(std::string_view content, std::string file, const ReadLimits& limits)
        : content_{content},
          file_{std::move(file)},
          limits_{limits}
    {
    }

    KeptDexels read()
    {
        if (!content_.starts_with(magic))
            throw complaint("E_FORMAT", "content that is not a file of dexels",
                            "a stock.dexels of endmill");
        at_ = magic.size();
        if (const auto found = whole(); found != version)
            throw complaint("E_DEXELS", "version " + std::to_string(found),
                            "version " + std::to_string(version));
        const Block block = read_block();
        const double pitch = coordinate();
        check("E_RANGE", pitch > 0, "a pitch of " + to_text(pitch) + " mm",
              "a number above 0");
        TurningHistory history{block, {}};
        const std::int64_t runs = whole();
        check("E_DEXELS", runs >= 0, std::to_string(runs) + " runs", "0 or more");
        for (std::int64_t k = 0; k < runs; ++k)
            history.runs.push_back(read_run());
        check_memory(block, pitch);
        DexelStock dexels{block, pitch};
        for (int axis = 0; axis < 3; ++axis)
            read_field(dexels.field(axis), dexels.units(axis));
        check("E_DEXELS", at_ == content_.size(), "bytes behind the last dexel",
              "the end of the file");
        return {std::move(dexels), std::move(history)};
    }

private:
    // An error at the number that was read last.
    FormatError complaint(const std::string& code, const std::string& found,
                          const std::string& expected) const
    {
        return {code, {file_, "@" + std::to_string(last_), found, expected}};
    }

    void check(const std::string& code, bool holds, const std::string& found,
               const std::string& expected) const
    {
        if (!holds)
            throw complaint(code, found, expected);
    }

    double bytes_left() const { return static_cast<double>(content_.size() - at_); }

    // Checks that the rest of the file can hold this many bytes. Conditions that are checked
    // for each number make no text unless they fail.
    void require_bytes(double bytes) const
    {
        if (bytes <= bytes_left())
            return;
        const double least = static_cast<double>(at_) + bytes;
        throw complaint(
            "E_DEXELS",
            "a file that ends after " + std::to_string(content_.size()) + " bytes",
            std::isfinite(least) ? "at least " + to_text(least) + " bytes"
                                 : "a file for the number of rays that the pitch gives");
    }

    template <typename Value>
    Value next()
    {
        last_ = at_;
        require_bytes(sizeof(Value));
        Value value;
        std::memcpy(&value, content_.data() + at_, sizeof value);
        at_ += sizeof value;
        return value;
    }

    std::int64_t whole() { return next<std::int64_t>(); }

    // A finite number.
    double number()
    {
        const auto value = next<double>();
        if (!std::isfinite(value))
            throw complaint("E_NONFINITE", "a number that is not finite",
                            "a finite number");
        return value;
    }

    // A finite coordinate or length within the limit.
    double coordinate()
    {
        const double value = number();
        if (!(std::abs(value) <= limits_.max_extent_mm))
            throw complaint("E_RANGE", "a coordinate of " + to_text(value) + " mm",
                            "at most " + to_text(limits_.max_extent_mm) + " mm");
        return value;
    }

    // Infinity stands for a cutter that cuts over its whole length, without an end.
    double cutting_length(double corner)
    {
        const auto length = next<double>();
        if (length == std::numeric_limits<double>::infinity())
            return length;
        check("E_NONFINITE", std::isfinite(length), "a cutting length that is not finite",
              "a finite number, or infinity");
        check("E_RANGE", length > 0 && length >= corner,
              "a cutting length of " + to_text(length) + " mm",
              "a number above 0, at least the corner radius");
        return length;
    }

    // Three numbers, read one after the other, because the order of evaluation of
    // arguments is not defined.
    Vec3 place()
    {
        const double x = coordinate();
        const double y = coordinate();
        const double z = coordinate();
        return {x, y, z};
    }

    Block read_block()
    {
        const Vec3 low = place();
        const Vec3 high = place();
        check("E_RANGE", (low.array() < high.array()).all(),
              "a block without material or with exchanged corners",
              "low below high along x, y and z");
        return {low, high};
    }

    CuttingBody read_cutter()
    {
        const double radius = coordinate();
        const double corner = coordinate();
        check("E_RANGE", 0 < radius && 0 <= corner && corner <= radius,
              "a cutter of radius " + to_text(radius) + " mm and corner radius " +
                  to_text(corner) + " mm",
              "0 < radius, 0 <= corner radius <= radius");
        return CuttingBody{Cutter{radius, corner}, cutting_length(corner)};
    }

    PartOnMachine read_machine()
    {
        const std::int64_t length = whole();
        check("E_DEXELS", 0 < length && length <= longest_word,
              "a machine word of " + std::to_string(length) + " letters",
              "1 to " + std::to_string(longest_word));
        const auto bytes = static_cast<std::size_t>(length);
        const std::size_t padded = (bytes + word_bytes - 1) / word_bytes * word_bytes;
        require_bytes(static_cast<double>(padded));
        last_ = at_;
        const std::string_view word = content_.substr(at_, bytes);
        const std::string_view rest = content_.substr(at_ + bytes, padded - bytes);
        at_ += padded;
        const auto fault = configuration_fault(word);
        check("E_RANGE", !fault, "the machine word " + printable(word),
              fault ? "one without this fault: " + *fault : "");
        check("E_DEXELS", rest.find_first_not_of('\0') == std::string_view::npos,
              "a letter behind the machine word", "zeros");
        PartOnMachine setup;
        setup.machine.configuration = configuration_from_word(word);
        setup.machine.pivot = coordinate();
        setup.tool_length = coordinate();
        setup.machine.table_offset = place();
        setup.machine.axis_offset = place();
        for (int row = 0; row < 3; ++row)
            setup.part_to_machine.row(row) = place().transpose();
        const Eigen::Matrix3d& rotation = setup.part_to_machine;
        check("E_RANGE",
              (rotation * rotation.transpose() - Eigen::Matrix3d::Identity())
                          .cwiseAbs()
                          .maxCoeff() <= unit_tolerance &&
                  rotation.determinant() > 0,
              "a matrix of the part that is not a rotation", "a rotation");
        setup.clamp = place();
        return setup;
    }

    void read_poses(EarlierTurningRun& run, std::size_t count)
    {
        run.poses.reserve(count);
        for (std::size_t k = 0; k < count; ++k) {
            const Vec3 tip = place();
            const Vec3 axis = place();
            if (!(std::abs(axis.norm() - 1) <= unit_tolerance))
                throw complaint("E_RANGE",
                                "a tool axis of length " + to_text(axis.norm()),
                                "a unit vector");
            run.poses.push_back({tip, axis});
        }
    }

    void read_positions(EarlierTurningRun& run, std::size_t count)
    {
        MachineMotion& motion = *run.machine;
        motion.setup = read_machine();
        motion.positions.reserve(count);
        run.poses.reserve(count);
        for (std::size_t k = 0; k < count; ++k) {
            AxisPositions at;
            at.rotary[0] = number();
            at.rotary[1] = number();
            at.xyz = place();
            motion.positions.push_back(at);
            run.poses.push_back(tool_location(motion.setup, at));
        }
    }

    EarlierTurningRun read_run()
    {
        EarlierTurningRun run{read_cutter(), false, {}};
        const std::int64_t stands = whole();
        check("E_DEXELS", stands == 0 || stands == 1, std::to_string(stands),
              "0, or 1 if the cutter stands at its first pose");
        run.stands_at_first = stands == 1;
        const std::int64_t interpolation = whole();
        check("E_DEXELS", 0 <= interpolation && interpolation <= 2,
              "interpolation " + std::to_string(interpolation),
              "0 (linear), 1 (tcp) or 2 (joint)");
        const std::int64_t count = whole();
        const double bytes =
            sizeof(double) * (interpolation == 0 ? doubles_a_pose : doubles_a_position);
        check("E_DEXELS", count >= 1, std::to_string(count) + " poses of a run",
              "at least 1");
        require_bytes(bytes * static_cast<double>(count));
        if (interpolation == 0) {
            read_poses(run, static_cast<std::size_t>(count));
            return run;
        }
        run.machine = MachineMotion{};
        run.machine->interpolation =
            interpolation == 1 ? Interpolation::Tcp : Interpolation::Joint;
        read_positions(run, static_cast<std::size_t>(count));
        return run;
    }

    // Checks the memory of the dexels, and that the file may hold them. Counted in doubles:
    // block and pitch are not to be trusted yet.
    void check_memory(const Block& block, double pitch) const
    {
        // Slightly fewer than `DexelField` makes.
        const Vec3 cells =
            ((block.high - block.low) / pitch * (1 - 1e-11)).array().ceil().max(1.0);
        const double rays =
            cells[0] * cells[1] + cells[1] * cells[2] + cells[2] * cells[0];
        require_bytes(rays * least_bytes_a_ray);
        require_memory(
            file_,
            static_cast<double>(content_.size()) + required_dexel_bytes(block, pitch),
            limits_);
    }

    // Reads one set of all rays.
    void read_set(std::vector<Dexel>& dexels, std::vector<DexelInterval> Dexel::*set,
                  std::int32_t units)
    {
        std::vector<std::uint32_t> counts(dexels.size());
        double all = 0;
        for (std::uint32_t& count : counts) {
            count = next<std::uint32_t>();
            all += count;
        }
        if (counts.size() % 2 == 1)
            check("E_DEXELS", next<std::uint32_t>() == 0, "a count without a ray", "0");
        require_bytes(all * sizeof(DexelInterval));
        for (std::size_t ray = 0; ray < dexels.size(); ++ray) {
            std::vector<DexelInterval>& of = dexels[ray].*set;
            of.reserve(counts[ray]);
            std::int32_t below = 0;
            for (std::uint32_t k = 0; k < counts[ray]; ++k) {
                const auto from = next<std::int32_t>();
                const auto to = next<std::int32_t>();
                if (!(below <= from && from < to && to <= units))
                    throw complaint("E_RANGE",
                                    "an interval from " + std::to_string(from) + " to " +
                                        std::to_string(to),
                                    "ascending intervals from " + std::to_string(below) +
                                        " to " + std::to_string(units));
                of.push_back({from, to});
                below = to;
            }
        }
    }

    void read_field(DexelField& field, std::int32_t units)
    {
        std::vector<Dexel> dexels(static_cast<std::size_t>(field.columns()) *
                                  field.rows());
        read_set(dexels, &Dexel::upper, units);
        read_set(dexels, &Dexel::lower, units);
        field.assign(dexels);
    }

    std::string_view content_;
    std::string file_;
    ReadLimits limits_;
    std::size_t at_ = 0;
    std::size_t last_ = 0;
};

}  // namespace

std::string dexel_file(const DexelStock& dexels, const TurningHistory& history)
{
    std::string file{magic};
    append(file, version);
    append(file, dexels.block().low);
    append(file, dexels.block().high);
    append(file, dexels.pitch());
    append(file, static_cast<std::int64_t>(history.runs.size()));
    for (const EarlierTurningRun& run : history.runs)
        append_run(file, run);
    for (int axis = 0; axis < 3; ++axis)
        append_field(file, dexels.field(axis));
    return file;
}

KeptDexels read_dexels(const std::filesystem::path& path, const ReadLimits& limits)
{
    return parse_dexels(read_file(path, limits), path, limits);
}

KeptDexels parse_dexels(std::string_view content, const std::filesystem::path& path,
                        const ReadLimits& limits)
{
    return DexelReader{content, shown_path(path), limits}.read();
}

}  // namespace endmill
