// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/machining_data.h"

#include <array>
#include <string>

#include "endmill/core/text.h"
#include "endmill/files/detail/json_format.h"
#include "endmill/files/read_file.h"

namespace endmill {
namespace {

constexpr std::string_view format_name = "endmill-material/1";

// Upper ends beyond every material. A larger number is a mistake of the unit.
constexpr NumberRange resistance_range{.above = 0, .most = 1e6};         // N/mm^2
constexpr NumberRange edge_range{.above = 0, .most = 10, .from = true};  // mm
constexpr NumberRange ratio_range{.above = 0, .most = 1000, .from = true};
constexpr NumberRange speed_range{.above = 0, .most = 1e6};  // m/min
constexpr NumberRange feed_range{.above = 0, .most = 1000};  // mm

// A required number.
double number(const JsonValue& root, std::string_view key, NumberRange range)
{
    range.code = "E_MATERIAL";
    const JsonValue value = root.member(key);
    return number_in(value, range);
}

// An optional number.
std::optional<double> optional_number(const JsonValue& root, std::string_view key,
                                      NumberRange range)
{
    range.code = "E_MATERIAL";
    return find_number(root, key, range);
}

// The exponent alpha of tool life. Both ends are excluded: at 1 the economic tool life,
// proportional to 1 / alpha - 1, would be 0.
double exponent(const JsonValue& root)
{
    const JsonValue value = root.member("alpha");
    const double alpha = value.number();
    if (!(alpha > 0 && alpha < 1))
        throw value.complaint(value.shown(), "a number between 0 and 1", "E_MATERIAL");
    return alpha;
}

// Checks that the largest feed per tooth is not below the least.
void require_order_of_feeds(const JsonValue& root, const CuttingMaterial& material)
{
    const auto& least = material.min_feed_per_tooth_mm;
    const auto& most = material.max_feed_per_tooth_mm;
    if (!least || !most || *least <= *most)
        return;
    const JsonValue value = root.member("max_feed_per_tooth_mm");
    throw value.complaint(value.shown(),
                          "at least min_feed_per_tooth_mm, " + to_text(*least),
                          "E_MATERIAL");
}

}  // namespace

CuttingMaterial read_material(const std::filesystem::path& path, const ReadLimits& limits)
{
    return parse_material(read_file(path, limits), path, limits);
}

CuttingMaterial parse_material(std::string_view content,
                               const std::filesystem::path& path,
                               const ReadLimits& limits)
{
    constexpr std::array<std::string_view, 13> keys{"format",
                                                    "name",
                                                    "specific_resistance_n_per_mm2",
                                                    "edge_thickness_mm",
                                                    "r1",
                                                    "r2",
                                                    "r3",
                                                    "r4",
                                                    "alpha",
                                                    "v1_m_per_min",
                                                    "max_feed_per_tooth_mm",
                                                    "min_feed_per_tooth_mm",
                                                    "source"};
    const FormatDocument document{content, path, limits, format_name};
    const JsonValue root = document.root();
    root.allow_only(keys);

    CuttingMaterial material{
        .specific_resistance_n_per_mm2 =
            number(root, "specific_resistance_n_per_mm2", resistance_range),
        .edge_thickness_mm = number(root, "edge_thickness_mm", edge_range),
        .r1 = number(root, "r1", ratio_range),
        .r2 = number(root, "r2", ratio_range),
        .r3 = number(root, "r3", ratio_range),
        .r4 = number(root, "r4", ratio_range),
        .alpha = exponent(root),
        .v1_m_per_min = number(root, "v1_m_per_min", speed_range),
        .max_feed_per_tooth_mm =
            optional_number(root, "max_feed_per_tooth_mm", feed_range),
        .min_feed_per_tooth_mm =
            optional_number(root, "min_feed_per_tooth_mm", feed_range),
        .name = name_or_stem(root, path),
        .source = remark(root, "source")};
    require_order_of_feeds(root, material);
    return material;
}

}  // namespace endmill
