// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/cutter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

// The numbers of a cutter word in mm, before their ranges are checked.
struct CutterSizes {
    double radius;
    double corner_radius;
};

// The numbers of `word`; nothing if it does not have the form of a cutter word.
std::optional<CutterSizes> sizes_of(std::string_view word)
{
    const std::size_t first = std::min(word.find(':'), word.size());
    const std::string_view name = word.substr(0, first);
    const std::string_view numbers = word.substr(std::min(first + 1, word.size()));
    if (name == "bull") {
        const std::size_t second = std::min(numbers.find(':'), numbers.size());
        const auto diameter = number_from_text(numbers.substr(0, second));
        const auto corner_radius =
            number_from_text(numbers.substr(std::min(second + 1, numbers.size())));
        if (!diameter || !corner_radius)
            return std::nullopt;
        return CutterSizes{*diameter / 2, *corner_radius};
    }
    const auto diameter = number_from_text(numbers);
    if (!diameter || (name != "ball" && name != "flat"))
        return std::nullopt;
    return CutterSizes{*diameter / 2, name == "ball" ? *diameter / 2 : 0};
}

// The word without "mm" after its numbers, which is a frequent mistake.
std::string without_units(std::string_view word)
{
    constexpr std::string_view unit = "mm";
    std::string plain{word};
    for (std::size_t at = plain.find(unit); at != std::string::npos;
         at = plain.find(unit))
        plain.erase(at, unit.size());
    return plain;
}

}  // namespace

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
    // from the centre of the corner circle
    const double across = distance - flat_radius();
    if (across <= 0)
        return 0;
    // Equal to r - sqrt(r^2 - across^2), without the cancellation of that difference.
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
    const auto sizes = sizes_of(word);
    if (!sizes || !(sizes->radius > 0) ||
        !(0 <= sizes->corner_radius && sizes->corner_radius <= sizes->radius))
        return std::nullopt;
    return Cutter{sizes->radius, sizes->corner_radius};
}

std::string expected_cutter(std::string_view word)
{
    const auto sizes = sizes_of(word);
    if (const std::string plain = without_units(word); !sizes && cutter_from_word(plain))
        return "numbers in mm without a unit, as in " + plain;
    if (!sizes)
        return "ball:DIAMETER, flat:DIAMETER or bull:DIAMETER:CORNER_RADIUS in mm, such "
               "as ball:10";
    if (!(sizes->radius > 0))
        return "a diameter above 0 mm";
    return "a corner radius from 0 to " + to_text(sizes->radius) +
           " mm, half the diameter";
}

Cutter with_allowance(const Cutter& cutter, double allowance)
{
    require(std::isfinite(allowance) && allowance >= 0,
            "with_allowance: need 0 <= allowance");
    return {cutter.radius() + allowance, cutter.corner_radius() + allowance};
}

BallCutter::BallCutter(double radius) : radius_{radius}
{
    require(std::isfinite(radius) && radius > 0, "BallCutter: need 0 < radius");
}

CutterLocation locate(const BallCutter& cutter, const CutterContact& contact,
                      const Vec3& axis)
{
    if (axis.dot(contact.normal) <= 0)
        throw GeometryError{"locate: the contact is on or above the equator of the ball"};
    const Cutter ball = Cutter::ball(cutter.radius());
    return {control_point(ball, contact, ControlPoint::Tip, axis), axis};
}

}  // namespace endmill
