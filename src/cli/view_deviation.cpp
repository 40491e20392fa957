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
#include "endmill/verification/verification.h"

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

std::optional<Vec3> vector_in(const Json& object, const char* key)
{
    const auto point = object.find(key);
    if (point == object.end() || !point->is_array() || point->size() != 3)
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

std::optional<Vec3> place_in(const Json& summary, const char* key)
{
    const auto place = summary.find(key);
    if (place == summary.end() || !place->is_object())
        return std::nullopt;
    return vector_in(*place, "point_mm");
}

// The rotation from the frame of the results of `verify`, in which the tool axis is +z, to the
// frame of the path.
Eigen::Matrix3d from_upright(const Json& summary)
{
    const std::optional<Vec3> axis = vector_in(summary, "upright_axis");
    if (!axis || !(axis->norm() > 0))
        return Eigen::Matrix3d::Identity();
    return upright_rotation(axis->normalized()).transpose();
}

// The places that the verdict names.
Json worst_places(const Json& summary, const Eigen::Matrix3d& rotation,
                  const Vec3& origin)
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
                 {"point_mm", vector_json(rotation * *at - origin)},
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
    const ViewSummary* const beside = summary_beside(input, input.deviation);
    const Json summary = beside ? beside->content : Json::object();
    const Eigen::Matrix3d rotation = from_upright(summary);
    for (const std::size_t k : chosen) {
        const float* const at = &deviation.point_mm[3 * k];
        const Vec3 point = rotation * Vec3{at[0], at[1], at[2]} - frame.origin;
        for (const double coordinate : point)
            points.push_back(static_cast<float>(coordinate));
        left.push_back(deviation.left_mm[k]);
    }
    Json view{{"points", array_json(frame.numbers.add(points))},
              {"left_mm", array_json(frame.numbers.add(left))},
              {"tolerance_mm", number_in(summary, "tolerance_mm")},
              {"scallop_mm", number_in(summary, "scallop_limit_mm")},
              {"mark_mm", mark_share * frame.size_mm},
              {"worst", worst_places(summary, rotation, frame.origin)}};
    std::string note = input.deviation_note;
    if (chosen.size() < deviation.left_mm.size())
        note += fmt::format(
            "{}"
            "The remaining stock is drawn at {} of {} points: of neighbours the least "
            "and "
            "the greatest.",
            note.empty() ? "" : " ", chosen.size(), deviation.left_mm.size());
    if (!note.empty())
        view["note"] = std::move(note);
    return view;
}

}  // namespace endmill
