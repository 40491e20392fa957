// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/path_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <system_error>

// The functions of SHA-256 itself allocate nothing. Those that replace them since version 3
// initialise the whole library first, and crash if memory does not suffice for that.
#define OPENSSL_SUPPRESS_DEPRECATED
#include <openssl/sha.h>

#include "endmill/files/detail/csv_lines.h"
#include "endmill/files/detail/strict_json.h"
#include "endmill/files/detail/tool_path_reader.h"
#include "endmill/files/read_file.h"

// The summary.json beside a tool path is written by the commands that plan paths. Its
// reader takes only the keys that verification and feed planning need and ignores all
// others, because later versions may add keys. A wrong value of a known key is an error.

namespace endmill {
namespace {

// The value of `key`, unless it is missing or null.
std::optional<JsonValue> known_member(const JsonValue& object, std::string_view key)
{
    std::optional<JsonValue> value = object.find_member(key);
    return value && value->shown() != "null" ? value : std::nullopt;
}

// A positive number; nothing if the key is missing or null.
std::optional<double> positive_number(const JsonValue& object, std::string_view key)
{
    const std::optional<JsonValue> value = known_member(object, key);
    if (!value)
        return std::nullopt;
    const double number = value->number();
    if (!(number > 0))
        throw value->complaint(value->shown(), "a number above 0");
    return number;
}

// The same for a tolerance, which is 0 on the side to which a path must not deviate.
std::optional<double> tolerance(const JsonValue& object, std::string_view key)
{
    const std::optional<JsonValue> value = known_member(object, key);
    if (!value)
        return std::nullopt;
    const double number = value->number();
    if (!(number >= 0))
        throw value->complaint(value->shown(), "a number from 0");
    return number;
}

// A text; nothing if the key is missing or null.
std::optional<std::string> text(const JsonValue& object, std::string_view key)
{
    const std::optional<JsonValue> value = known_member(object, key);
    return value ? std::optional{value->text()} : std::nullopt;
}

// The cutter of a cutter word; nothing if the key is missing or null.
std::optional<Cutter> cutter(const JsonValue& object)
{
    const std::optional<JsonValue> value = known_member(object, "cutter");
    if (!value)
        return std::nullopt;
    const std::optional<Cutter> cutter = cutter_from_word(value->text());
    if (!cutter)
        throw value->complaint(value->shown(), expected_cutter(value->text()));
    return cutter;
}

// The enumerator whose name is under `key`. \pre the key is present.
template <typename Choice, std::size_t count>
Choice choice(const JsonValue& object, std::string_view key,
              const std::array<std::string_view, count>& names)
{
    const JsonValue value = *known_member(object, key);
    const auto found = std::ranges::find(names, value.text());
    if (found == names.end()) {
        std::string expected;
        for (const std::string_view name : names)
            expected += (expected.empty() ? "" : ", ") + std::string{name};
        throw value.complaint(value.shown(), "one of " + expected);
    }
    return static_cast<Choice>(found - names.begin());
}

// The number of rows of the path; nothing if the key is missing or null.
std::optional<std::size_t> row_count(const JsonValue& root)
{
    constexpr std::int64_t most = 1'000'000'000'000;
    const std::optional<JsonValue> value = known_member(root, "toolpath_points");
    if (!value)
        return std::nullopt;
    return static_cast<std::size_t>(value->whole_number(0, most));
}

// The part under `key`; its path in the file is relative to the folder of the summary.
std::optional<PartReference> part(const JsonValue& root, const std::string& key,
                                  const std::filesystem::path& folder)
{
    const std::optional<std::string> file = text(root, key);
    if (!file)
        return std::nullopt;
    const std::string units = key + "_units";
    const std::string up = key + "_up";
    PartReference part{.file = folder / *file};
    if (known_member(root, units))
        part.units = choice<LengthUnit>(root, units, length_unit_names);
    if (known_member(root, up))
        part.up = choice<UpAxis>(root, up, up_axis_names);
    return part;
}

// The file under `key`, relative to the folder of the summary.
std::optional<std::filesystem::path> file_beside(const JsonValue& root,
                                                 std::string_view key,
                                                 const std::filesystem::path& folder)
{
    const std::optional<std::string> file = text(root, key);
    return file ? std::optional{folder / *file} : std::nullopt;
}

// The numbers of the faces that are cut; none if the key is missing or null.
std::vector<int> cut_faces(const JsonValue& root)
{
    constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
    const std::optional<JsonValue> value = known_member(root, "cut_faces");
    std::vector<int> faces;
    for (std::size_t k = 0; value && k < value->size(); ++k)
        faces.push_back(static_cast<int>(value->item(k).whole_number(1, most)));
    std::ranges::sort(faces);
    return faces;
}

// Three numbers of an array.
Vec3 vector_in(const JsonValue& value)
{
    if (value.size() != 3)
        throw value.complaint(value.shown(), "[x, y, z]");
    Vec3 vector;
    for (std::size_t k = 0; k < 3; ++k)
        vector[static_cast<Eigen::Index>(k)] = value.item(k).number();
    return vector;
}

Vec3 vector_or_zero(const JsonValue& object, std::string_view key)
{
    const std::optional<JsonValue> value = known_member(object, key);
    return value ? vector_in(*value) : Vec3{0, 0, 0};
}

double number_or_zero(const JsonValue& object, std::string_view key)
{
    const std::optional<JsonValue> value = known_member(object, key);
    return value ? value->number() : 0;
}

// A rotation of three rows.
Eigen::Matrix3d rotation_in(const JsonValue& value)
{
    constexpr double rounding = 1e-6;
    if (value.size() != 3)
        throw value.complaint(value.shown(), "three rows of a rotation");
    Eigen::Matrix3d rotation;
    for (std::size_t k = 0; k < 3; ++k)
        rotation.row(static_cast<Eigen::Index>(k)) = vector_in(value.item(k)).transpose();
    const Eigen::Matrix3d off =
        rotation * rotation.transpose() - Eigen::Matrix3d::Identity();
    if (!(off.cwiseAbs().maxCoeff() <= rounding && rotation.determinant() > 0))
        throw value.complaint("three rows that are no rotation",
                              "unit vectors that are perpendicular and right-handed");
    return rotation;
}

// The machine of a path or a program. A summary of `feed` has the name of a file under the
// same key.
std::optional<MachineMotion> machine(const JsonValue& root)
{
    const auto word = text(root, "interpolation");
    const auto interpolation = word ? interpolation_from_name(*word) : std::nullopt;
    if (!interpolation || *interpolation == Interpolation::Linear)
        return std::nullopt;
    const std::optional<JsonValue> value = known_member(root, "machine");
    if (!value)
        throw root.complaint("no key machine",
                             "the machine of a path whose interpolation is " + *word);
    MachineMotion motion{.interpolation = *interpolation, .setup = {}, .positions = {}};
    Machine& of = motion.setup.machine;
    const JsonValue configuration = value->member("configuration");
    if (const auto fault = configuration_fault(configuration.text()))
        throw configuration.complaint(configuration.shown() + ": " + *fault,
                                      "a word such as W/caxyBz/T");
    of.configuration = configuration_from_word(configuration.text());
    of.rotary = widest_limits(of.configuration);
    of.pivot = number_or_zero(*value, "pivot_mm");
    of.table_offset = vector_or_zero(*value, "table_offset_mm");
    of.axis_offset = vector_or_zero(*value, "axis_offset_mm");
    motion.setup.tool_length = number_or_zero(*value, "tool_length_mm");
    motion.setup.clamp = vector_or_zero(*value, "clamp_mm");
    if (const auto rotation = known_member(*value, "part_to_machine"))
        motion.setup.part_to_machine = rotation_in(*rotation);
    if (const auto signs = known_member(*value, "word_sign"))
        for (std::size_t k = 0; k < of.configuration.rotary.size(); ++k) {
            const std::string letter(1, of.configuration.rotary[k].letter);
            const double sign = number_or_zero(*signs, letter);
            if (sign != 0)
                of.word_signs[k] = sign < 0 ? -1 : 1;
        }
    return motion;
}

std::optional<InaccessibleStock> inaccessible(const JsonValue& root)
{
    if (!known_member(root, "inaccessible"))
        return std::nullopt;
    return choice<InaccessibleStock>(root, "inaccessible", inaccessible_names);
}

}  // namespace

std::optional<double> PathSummary::tolerance_mm() const
{
    // an outer tolerance of 0 says that the scallop height limits all remaining stock
    const auto outer = outer_tolerance_mm == 0.0 ? std::nullopt : outer_tolerance_mm;
    std::optional<double> narrowest;
    for (const auto& tolerance : {chord_tolerance_mm, inner_tolerance_mm, outer})
        if (tolerance)
            narrowest = std::min(*tolerance, narrowest.value_or(*tolerance));
    return narrowest;
}

std::optional<PathSummary> read_path_summary(const std::filesystem::path& tool_path,
                                             const ReadLimits& limits)
{
    const std::filesystem::path path = tool_path.parent_path() / "summary.json";
    std::error_code error;
    const auto type = std::filesystem::status(path, error).type();
    if (type == std::filesystem::file_type::not_found)
        return std::nullopt;
    const JsonDocument document{read_file(path, limits), shown_path(path), limits};
    const JsonValue root = document.root();
    return PathSummary{text(root, "name"),
                       part(root, "part", tool_path.parent_path()),
                       cutter(root),
                       positive_number(root, "chord_tolerance_mm"),
                       tolerance(root, "inner_tolerance_mm"),
                       tolerance(root, "outer_tolerance_mm"),
                       positive_number(root, "scallop_mm"),
                       inaccessible(root),
                       positive_number(root, "feed_mm_per_min"),
                       positive_number(root, "spindle_rpm"),
                       row_count(root),
                       text(root, "toolpath_sha256"),
                       text(root, "program_sha256"),
                       part(root, "protected", tool_path.parent_path()),
                       machine(root),
                       file_beside(root, "skip_facets", tool_path.parent_path()),
                       cut_faces(root),
                       text(root, "part_sha256")};
}

ClampedPart read_clamped_part(const std::filesystem::path& path, const ReadLimits& limits)
{
    const JsonDocument document{read_file(path, limits), shown_path(path), limits};
    const JsonValue root = document.root();
    const std::optional<JsonValue> rotation = known_member(root, "part_to_machine");
    if (!rotation)
        throw root.complaint("no pose of the part (part_to_machine)",
                             "the summary.json of a setup that was found");
    return {rotation_in(*rotation), vector_or_zero(root, "clamp_mm")};
}

struct ContentSha256::State {
    SHA256_CTX context;
};

ContentSha256::ContentSha256() : state_{std::make_unique<State>()}
{
    SHA256_Init(&state_->context);
}

ContentSha256::~ContentSha256() = default;

void ContentSha256::add(std::string_view piece)
{
    SHA256_Update(&state_->context, piece.data(), piece.size());
}

std::string ContentSha256::word()
{
    std::array<unsigned char, SHA256_DIGEST_LENGTH> bytes{};
    SHA256_Final(bytes.data(), &state_->context);
    constexpr std::string_view digits = "0123456789abcdef";
    std::string word;
    for (const unsigned char byte : bytes) {
        word += digits[byte / 16];
        word += digits[byte % 16];
    }
    return word;
}

std::string content_sha256(std::string_view content)
{
    ContentSha256 sum;
    sum.add(content);
    return sum.word();
}

SummaryMatch summary_match(const PathSummary& summary, std::string_view content)
{
    if (!summary.toolpath_sha256 && !summary.program_sha256)
        return SummaryMatch::Unnamed;
    const std::string found = content_sha256(content);
    if (summary.program_sha256 == found)
        return SummaryMatch::Described;
    const bool is_counted = summary.toolpath_points && is_tool_path_csv(content);
    const bool has_other_count =
        is_counted && line_count(content) != *summary.toolpath_points + 1;
    return summary.toolpath_sha256 == found && !has_other_count ? SummaryMatch::Described
                                                                : SummaryMatch::Other;
}

}  // namespace endmill
