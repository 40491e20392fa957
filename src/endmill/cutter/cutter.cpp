// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/cutter.h"

#include <cmath>
#include <limits>

#include "endmill/core/error.h"
#include "endmill/core/numbers.h"

namespace endmill {

Cutter::Cutter(double radius, double corner_radius)
    : radius_{radius},
      corner_radius_{corner_radius}
{
    require(std::isfinite(radius) && radius > 0, "Cutter: need 0 < radius");
    require(0 <= corner_radius && corner_radius <= radius,
            "Cutter: need 0 <= corner radius <= radius");
}

double Cutter::profile(double distance) const
{
    if (distance > radius_)
        return std::numeric_limits<double>::infinity();
    const double across = distance - flat_radius();  // from the corner's centre
    if (across <= 0)
        return 0;
    // The difference r - sqrt(r^2 - a^2), without its cancellation.
    const double r = corner_radius_;
    return across * across / (r + std::sqrt((r - across) * (r + across)));
}

std::string cutter_word(const Cutter& cutter)
{
    const std::string diameter = to_text(2 * cutter.radius());
    if (cutter.is_ball())
        return "ball:" + diameter;
    if (cutter.is_flat())
        return "flat:" + diameter;
    return "bull:" + diameter + ":" + to_text(cutter.corner_radius());
}

std::optional<Cutter> cutter_from_word(std::string_view word)
{
    const auto after = [&](std::string_view name) -> std::optional<std::string_view> {
        return word.starts_with(name) ? std::optional{word.substr(name.size())}
                                      : std::nullopt;
    };
    const auto valid = [](double radius, double corner_radius) -> std::optional<Cutter> {
        if (radius > 0 && corner_radius >= 0 && corner_radius <= radius)
            return Cutter{radius, corner_radius};
        return std::nullopt;
    };
    if (const auto text = after("ball:"))
        if (const auto diameter = number_from_text(*text))
            return valid(*diameter / 2, *diameter / 2);
    if (const auto text = after("flat:"))
        if (const auto diameter = number_from_text(*text))
            return valid(*diameter / 2, 0);
    if (const auto text = after("bull:")) {
        const std::size_t colon = text->find(':');
        if (colon == std::string_view::npos)
            return std::nullopt;
        const auto diameter = number_from_text(text->substr(0, colon));
        const auto corner_radius = number_from_text(text->substr(colon + 1));
        if (diameter && corner_radius)
            return valid(*diameter / 2, *corner_radius);
    }
    return std::nullopt;
}

}  // namespace endmill
