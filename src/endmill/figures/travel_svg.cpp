// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/travel_svg.h"

#include <algorithm>
#include <optional>

#include "endmill/figures/detail/stacked_chart.h"

namespace endmill {
namespace {

constexpr LineStyle contact_style{"#1d4f91", 1.5, ""};
constexpr LineStyle tip_style{"#d55e00", 1.5, ""};

}  // namespace

std::string direction_travel_svg(std::span<const DirectionTravel> travel,
                                 const TravelFigure& figure)
{
    std::vector<double> places;
    std::vector<std::optional<double>> contact;
    std::vector<std::optional<double>> tip;
    for (const DirectionTravel& one : travel) {
        places.push_back(one.direction.degrees());
        contact.emplace_back(one.contact_mm);
        tip.emplace_back(one.tip_mm);
    }
    ChartPanel lengths{"length, mm", {}};
    if (std::ranges::any_of(contact, [](const auto& one) { return one.has_value(); }))
        lengths.lines.push_back({"by contacts", contact_style, contact});
    lengths.lines.push_back({"by tips", tip_style, tip});
    const std::vector<ChartPanel> panels{lengths};
    return stacked_chart({figure.title, figure.captions, "direction of passes, degrees"},
                         places, panels);
}

}  // namespace endmill
