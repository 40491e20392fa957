// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/view_deviation.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "cli/shown_numbers.h"
#include "cli/surface_facts.h"
#include "endmill/page/reduction.h"

namespace endmill {
namespace {

// What a browser that draws by software turns smoothly; see docs/guide/view.md.
constexpr std::size_t most_deviation_points_drawn = 100'000;
constexpr double mark_share = 1.0 / 150;  // radius of a mark over the size of the page

double number_in(const Json& summary, const char* key)
{
    const auto found = summary.find(key);
    return found != summary.end() && found->is_number() ? found->get<double>() : 0;
}

std::optional<Vec3> place_in(const Json& summary, const char* key)
{
    const auto place = summary.find(key);
    if (place == summary.end() || !place->is_object())
        return std::nullopt;
    const auto point = place->find("point_mm");
    if (point == place->end() || !point->is_array() || point->size() != 3)
        return std::nullopt;
    Vec3 found;
    for (int c = 0; c < 3; ++c) {
        const Json& number = (*point)[static_cast<std::size_t>(c)];
        if (!number.is_number())
            return std::nullopt;
        found[c] = number.get<double>();
    }
    return found;
}

// The places that the verdict names.
Json worst_places(const Json& summary, const Vec3& origin)
{
    struct Kind {
        const char* name;
        const char* place;
        const char* depth;
        const char* words;
    };
    constexpr std::array<Kind, 2> kinds{
        {{"gouge", "max_gouge_at", "max_gouge_mm", "deepest gouge"},
         {"stock", "max_scallop_at", "max_scallop_mm", "most remaining stock"}}};
    Json places = Json::array();
    for (const Kind& kind : kinds)
        if (const std::optional<Vec3> at = place_in(summary, kind.place))
            places.push_back(
                {{"kind", kind.name},
                 {"point_mm", vector_json(*at - origin)},
                 {"text", fmt::format("{}: {} mm", kind.words,
                                      shown(number_in(summary, kind.depth)))}});
    return places;
}

}  // namespace

Json deviation_view(const DeviationPoints& deviation, const ViewInput& input,
                    ViewFrame& frame)
{
    const std::vector<std::size_t> chosen =
        extremes(deviation.left_mm, most_deviation_points_drawn);
    std::vector<float> points;
    std::vector<float> left;
    for (const std::size_t k : chosen) {
        for (std::size_t c = 0; c < 3; ++c)
            points.push_back(static_cast<float>(double{deviation.point_mm[3 * k + c]} -
                                                frame.origin[static_cast<int>(c)]));
        left.push_back(deviation.left_mm[k]);
    }
    const ViewSummary* const beside = summary_beside(input, input.deviation);
    const Json summary = beside ? beside->content : Json::object();
    Json view{{"points", array_json(frame.numbers.add(points))},
              {"left_mm", array_json(frame.numbers.add(left))},
              {"tolerance_mm", number_in(summary, "tolerance_mm")},
              {"scallop_mm", number_in(summary, "scallop_limit_mm")},
              {"mark_mm", mark_share * frame.size_mm},
              {"worst", worst_places(summary, frame.origin)}};
    if (chosen.size() < deviation.left_mm.size())
        view["note"] = fmt::format(
            "The remaining stock is drawn at {} of {} points: of neighbours the least "
            "and "
            "the greatest.",
            chosen.size(), deviation.left_mm.size());
    return view;
}

}  // namespace endmill
