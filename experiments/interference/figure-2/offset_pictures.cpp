// SPDX-License-Identifier: GPL-3.0-or-later
#include "interference/figure-2/offset_pictures.h"

#include <array>
#include <cmath>
#include <numbers>

#include "endmill/core/text.h"
#include "endmill/cutter/plane_offset.h"
#include "endmill/figures/axonometric_figure.h"
#include "support/side_by_side.h"

namespace endmill {
namespace {

using Point = Eigen::Vector2d;

constexpr double picture_px = 640;
constexpr LineStyle part_style{"#222222", 2, ""};
// Of the ball, the bull-nose cutter and the flat end mill. They differ in brightness and
// dashes too.
constexpr std::array<LineStyle, 3> offset_styles{
    {{"#d55e00", 2, ""}, {"#009e73", 2, "9 4"}, {"#0072b2", 2, "2 3"}}};
constexpr std::array<LineStyle, 3> cutter_styles{
    {{"#d55e00", 1, ""}, {"#009e73", 1, ""}, {"#0072b2", 1, ""}}};
// Samples at which the cutters are drawn, as shares of the slope.
constexpr std::array<double, 3> cutter_places{0.2, 0.5, 0.8};

// A slope z = a cos(pi x / length) that falls all the way, so that no offset folds.
std::vector<ProfilePoint> slope()
{
    constexpr double length = 60;  // mm
    constexpr double height = 12;  // mm
    constexpr int samples = 240;
    std::vector<ProfilePoint> profile;
    for (int k = 1; k < samples; ++k) {
        const double x = length * k / samples;
        const double w = std::numbers::pi / length;
        profile.push_back({{x, height * std::cos(w * x)},
                           profile_normal(-height * w * std::sin(w * x))});
    }
    return profile;
}

std::vector<Vec3> placed(const std::vector<Point>& points)
{
    std::vector<Vec3> places;
    for (const Point& point : points)
        places.emplace_back(point.x(), 0, point.y());
    return places;
}

std::vector<Point> points_of(const std::vector<ProfilePoint>& profile)
{
    std::vector<Point> points;
    for (const ProfilePoint& at : profile)
        points.push_back(at.point);
    return points;
}

// The outline of the cutter with its reference point, and a short shank.
std::vector<Point> outline(const Cutter& cutter, const Point& reference)
{
    constexpr int pieces = 24;
    const double shank = 0.3 * cutter.radius();
    std::vector<Point> points{reference + Point{-cutter.radius(), shank}};
    for (int k = 0; k <= 2 * pieces + 1; ++k) {
        const bool is_left = k <= pieces;
        const double angle =
            std::numbers::pi / 2 * (is_left ? k : 2 * pieces + 1 - k) / pieces;
        const double out =
            cutter.flat_radius() + cutter.corner_radius() * std::cos(angle);
        points.push_back(reference + Point{is_left ? -out : out,
                                           -cutter.corner_radius() * std::sin(angle)});
    }
    points.push_back(reference + Point{cutter.radius(), shank});
    points.push_back(points.front());
    return points;
}

// The surface that `cutter` leaves while its reference points follow the ball's offset:
// p + (R - r) (n - e_x) on a falling slope. Source: docs/methods/interference.md,
// section 2.3.
std::vector<Point> left_by(const Cutter& cutter, const std::vector<ProfilePoint>& profile)
{
    std::vector<Point> points;
    for (const ProfilePoint& at : profile) {
        const Point point = at.point + cutter.flat_radius() * (at.normal - Point{1, 0});
        if (point.x() >= 0)
            points.push_back(point);
    }
    return points;
}

AxonometricFigure empty_picture(const std::string& title, const std::string& caption,
                                const std::vector<ProfilePoint>& profile, double radius)
{
    FigureOptions options;
    options.title = title;
    options.captions = {caption};
    options.width_px = picture_px;
    options.azimuth = Angle::degrees(-90);
    options.elevation = Angle::degrees(0);
    options.axis_names = {"x", "", "z"};
    const std::vector<Vec3> part = placed(points_of(profile));
    const Vec3 room{radius, 0, 1.4 * radius};
    AxonometricFigure picture{
        options, std::array<Vec3, 2>{part.front() + Vec3{-room.x(), 0, room.z()},
                                     part.back() + Vec3{1.5 * room.x(), 0, -2}}};
    picture.add_curve(part, part_style);
    picture.add_legend("part", part_style);
    return picture;
}

std::size_t place_of(std::size_t number, const std::vector<ProfilePoint>& profile)
{
    return static_cast<std::size_t>(cutter_places[number] *
                                    static_cast<double>(profile.size()));
}

std::string own_offsets(const std::vector<Cutter>& cutters,
                        const std::vector<ProfilePoint>& profile)
{
    AxonometricFigure picture =
        empty_picture("Each cutter on its own offset", "every cutter touches the part",
                      profile, cutters.front().radius());
    for (std::size_t k = 0; k < cutters.size(); ++k) {
        const auto offset = plane_offset(cutters[k], profile);
        picture.add_curve(placed(offset), offset_styles[k]);
        picture.add_legend("reference points of " + cutter_word(cutters[k]),
                           offset_styles[k]);
        const Point at = offset.at(place_of(k, profile));
        picture.add_curve(placed(outline(cutters[k], at)), cutter_styles[k]);
        picture.add_disc(placed({at}).front(), 3, cutter_styles[k].colour);
    }
    return picture.text();
}

std::string balls_offset(const std::vector<Cutter>& cutters,
                         const std::vector<ProfilePoint>& profile)
{
    const Cutter& ball = cutters.front();
    AxonometricFigure picture =
        empty_picture("All cutters on the ball's offset",
                      "the other cutters do not reach the part and leave stock", profile,
                      ball.radius());
    const auto offset = plane_offset(ball, profile);
    picture.add_curve(placed(offset), offset_styles[0]);
    picture.add_legend("reference points of " + cutter_word(ball), offset_styles[0]);
    for (std::size_t k = 1; k < cutters.size(); ++k) {
        picture.add_curve(placed(left_by(cutters[k], profile)), offset_styles[k]);
        picture.add_legend("surface that " + cutter_word(cutters[k]) + " leaves",
                           offset_styles[k]);
    }
    for (std::size_t k = 0; k < cutters.size(); ++k) {
        const Point at = offset.at(place_of(k, profile));
        picture.add_curve(placed(outline(cutters[k], at)), cutter_styles[k]);
        picture.add_disc(placed({at}).front(), 3, cutter_styles[k].colour);
    }
    return picture.text();
}

}  // namespace

std::string offset_pictures(const std::vector<Cutter>& cutters)
{
    const std::vector<ProfilePoint> profile = slope();
    return side_by_side(own_offsets(cutters, profile), balls_offset(cutters, profile));
}

}  // namespace endmill
