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

std::optional<InaccessibleStock> inaccessible(const JsonValue& root)
{
    if (!known_member(root, "inaccessible"))
        return std::nullopt;
    return choice<InaccessibleStock>(root, "inaccessible", inaccessible_names);
}

}  // namespace

std::optional<double> PathSummary::tolerance_mm() const
{
    std::optional<double> narrowest;
    for (const auto& tolerance :
         {chord_tolerance_mm, inner_tolerance_mm, outer_tolerance_mm})
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
                       part(root, "protected", tool_path.parent_path())};
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
