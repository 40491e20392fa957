// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/axonometric_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/figures/detail/round_ticks.h"

// The page has four parts from top to bottom: title and captions, the drawing, and a
// footer with the axes to the left and the legend to the right. Axes with ticks are not in
// the footer but at three edges of the box around the drawing, and the drawing leaves room
// for their numbers. The width of the page is
// given; the height follows from the drawing, which is as wide as the page but at most
// 640 px high.

namespace endmill {
namespace {

// Layout of the page, in px.
constexpr double least_width = 300;
constexpr double margin = 32;
constexpr double title_size = 21;
constexpr double title_line = 34;
constexpr double caption_size = 14;
constexpr double caption_line = 22;
constexpr double drawing_gap = 26;
constexpr double drawing_height = 640;
constexpr double footer_height = 138;
constexpr double axis_arm = 58;
constexpr double legend_line = 24;
constexpr double legend_sample = 38;
constexpr double legend_offset = 190;
constexpr double legend_column = 222;
constexpr int legend_column_lines = 5;  // the footer has room for five
constexpr double tick_room = 48;        // beside and below the drawing, for numbers
constexpr double tick_size = 12;        // of the font
constexpr double tick_length = 5;
constexpr double tick_distance = 45;  // of neighbouring ticks, at least about
constexpr double least_axis = 30;     // a shorter axis has no ticks

// Largest numbers of characters; longer texts would be too small to read.
constexpr std::size_t longest_title = 100;
constexpr std::size_t longest_caption = 150;

constexpr std::string_view axis_colour = "#444444";

// Upper bound of the average width of a letter in a sans-serif font, as a share of its
// size.
constexpr double letter_width = 0.62;

// The largest font size up to `size_px` at which `text` fits into `room_px`.
double fitting_size(std::string_view text, double size_px, double room_px)
{
    const double width = letter_width * static_cast<double>(text.size());
    return std::min(size_px, room_px / std::max(width, 1.0));
}

// The projection of `point` to the picture plane, in mm, y upwards.
Eigen::Vector2d projected(const AxonometricView& view, const Vec3& point)
{
    return {view.right.dot(point), view.up.dot(point)};
}

// The largest of 1, 2, 5 times a power of ten that is at most `length`.
double round_length(double length)
{
    const double power = std::pow(10, std::floor(std::log10(length)));
    for (const double step : {5, 2})
        if (step * power <= length)
            return step * power;
    return power;
}

// The corners of the box around points; corner k has the high x, y, z for its bits 0, 1, 2.
std::array<Vec3, 8> corners_around(std::span<const Vec3> points)
{
    Eigen::AlignedBox3d box;
    for (const Vec3& point : points)
        box.extend(point);
    std::array<Vec3, 8> corners;
    for (std::size_t k = 0; k < corners.size(); ++k)
        corners[k] = {((k & 1) != 0 ? box.max() : box.min()).x(),
                      ((k & 2) != 0 ? box.max() : box.min()).y(),
                      ((k & 4) != 0 ? box.max() : box.min()).z()};
    return corners;
}

// Height of the title and captions with the margin, in px.
double heading_height(const FigureOptions& options)
{
    const double title = options.title.empty() ? 0 : title_line;
    return margin + title + caption_line * static_cast<double>(options.captions.size());
}

}  // namespace

AxonometricView::AxonometricView(Angle azimuth, Angle elevation)
    : right{-std::sin(azimuth.radians()), std::cos(azimuth.radians()), 0},
      up{-std::sin(elevation.radians()) * std::cos(azimuth.radians()),
         -std::sin(elevation.radians()) * std::sin(azimuth.radians()),
         std::cos(elevation.radians())},
      toward{right.cross(up)}
{
}

AxonometricFigure::AxonometricFigure(const FigureOptions& options,
                                     std::span<const Vec3> extent)
    : view_{options.azimuth, options.elevation},
      layout_{layout_for(options, view_, extent)},
      picture_{layout_.width_px, layout_.height_px, options.title}
{
    add_heading(options);
    if (options.has_ticks)
        add_ticks(options, corners_around(extent));
    else
        add_axes(options);
}

// The scale is the largest at which the drawing fits into the width and the largest
// height. A drawing that is a single point has the scale 1.
AxonometricFigure::Layout AxonometricFigure::layout_for(const FigureOptions& options,
                                                        const AxonometricView& view,
                                                        std::span<const Vec3> extent)
{
    require(!extent.empty(), "AxonometricFigure: nothing to draw");
    require(options.width_px >= least_width, "AxonometricFigure: need a width of 300 px");
    Eigen::AlignedBox2d box;
    for (const Vec3& point : extent) {
        require(point.allFinite(), "AxonometricFigure: a point is not finite");
        box.extend(projected(view, point));
    }
    if (options.has_ticks)
        for (const Vec3& corner : corners_around(extent))
            box.extend(projected(view, corner));
    const double beside = options.has_ticks ? tick_room : 0;
    const double room = options.width_px - 2 * (margin + beside);
    const Eigen::Vector2d size = box.sizes();
    const bool is_point = size.maxCoeff() <= 0;
    const double scale =
        is_point ? 1 : 1 / std::max(size.x() / room, size.y() / drawing_height);

    // The drawing is centred between the margins, the footer stands below it.
    const double top = heading_height(options) + drawing_gap;
    const double bottom = top + scale * size.y();
    const PixelPoint origin{options.width_px / 2 - scale * box.center().x(),
                            bottom + scale * box.min().y()};
    const double footer = bottom + drawing_gap + beside;
    return {options.width_px, footer + footer_height,
            footer,           scale,
            origin,           margin + (options.has_ticks ? 0 : legend_offset)};
}

// The place of a point in the picture, in px.
PixelPoint AxonometricFigure::pixels(const Vec3& point) const
{
    const Eigen::Vector2d place = layout_.scale * projected(view_, point);
    return layout_.origin + PixelPoint{place.x(), -place.y()};
}

std::vector<PixelPoint> AxonometricFigure::pixels(std::span<const Vec3> points) const
{
    std::vector<PixelPoint> places;
    places.reserve(points.size());
    for (const Vec3& point : points)
        places.push_back(pixels(point));
    return places;
}

void AxonometricFigure::add_curve(std::span<const Vec3> points, const LineStyle& style)
{
    picture_.add_polyline(pixels(points), style);
}

void AxonometricFigure::add_polygon(std::span<const Vec3> points, std::string_view fill,
                                    const LineStyle& outline)
{
    picture_.add_polygon(pixels(points), fill, outline);
}

void AxonometricFigure::add_disc(const Vec3& point, double radius_px,
                                 std::string_view colour)
{
    picture_.add_disc(pixels(point), radius_px, colour);
}

// Draws an arrow between two places in px. \return false if it would be shorter than its
// head, and is not drawn.
bool AxonometricFigure::add_pixel_arrow(const PixelPoint& from, const PixelPoint& to,
                                        const LineStyle& style)
{
    constexpr double head_length = 6;  // px
    constexpr double head_half_width = 3;
    if ((to - from).norm() < head_length)
        return false;
    const PixelPoint along = (to - from).normalized();
    const PixelPoint across = head_half_width * PixelPoint{-along.y(), along.x()};
    const PixelPoint neck = to - head_length * along;
    picture_.add_polyline(std::array{from, to}, style);
    picture_.add_polyline(std::array<PixelPoint, 3>{neck + across, to, neck - across},
                          {style.colour, style.width_px, ""});
    return true;
}

void AxonometricFigure::add_arrow(const Vec3& from, const Vec3& to,
                                  const LineStyle& style)
{
    add_pixel_arrow(pixels(from), pixels(to), style);
}

void AxonometricFigure::add_label(const Vec3& point, const PixelPoint& shift_px,
                                  std::string_view text, std::string_view colour)
{
    const PixelPoint base{0, 0.36 * caption_size};  // centres the letters vertically
    picture_.add_text(pixels(point) + shift_px + base, text,
                      {caption_size, colour, false, true});
}

void AxonometricFigure::add_legend(std::string_view label, const LineStyle& style)
{
    const PixelPoint begin = next_legend();
    picture_.add_polyline(
        std::array<PixelPoint, 2>{begin, begin + PixelPoint{legend_sample, 0}}, style);
    name_legend(label);
}

void AxonometricFigure::add_disc_legend(std::string_view label, double radius_px,
                                        std::string_view colour)
{
    picture_.add_disc(next_legend() + PixelPoint{legend_sample / 2, 0}, radius_px,
                      colour);
    name_legend(label);
}

// Lines of the legend fill a column before the next one begins.
PixelPoint AxonometricFigure::next_legend() const
{
    const int column = legend_lines_ / legend_column_lines;
    const int line = legend_lines_ % legend_column_lines;
    return {layout_.legend_px + legend_column * column,
            layout_.footer_px + legend_line * (line + 1)};
}

// Writes the label beside the sample that was just drawn.
void AxonometricFigure::name_legend(std::string_view label)
{
    picture_.add_text(next_legend() + PixelPoint{legend_sample + 10, 0.36 * caption_size},
                      label, {caption_size});
    ++legend_lines_;
}

// Long titles and captions get a smaller font, so that they fit between the margins.
void AxonometricFigure::add_heading(const FigureOptions& options)
{
    const double room = options.width_px - 2 * margin;
    const PixelPoint middle{options.width_px / 2, margin};
    double line = 0;
    if (!options.title.empty()) {
        const std::string title = printable(options.title, longest_title);
        picture_.add_text(middle + PixelPoint{0, 0.6 * title_size}, title,
                          {fitting_size(title, title_size, room), "#111111", true, true});
        line += title_line;
    }
    for (const std::string& whole : options.captions) {
        const std::string caption = printable(whole, longest_caption);
        line += caption_line;
        picture_.add_text(
            middle + PixelPoint{0, line - 0.4 * caption_line}, caption,
            {fitting_size(caption, caption_size, room), "#333333", false, true});
    }
}

// The arms of the axes have a round length in mm that is at most about 58 px. An axis
// that points to the viewer is left out.
void AxonometricFigure::add_axes(const FigureOptions& options)
{
    const double arm_mm = round_length(axis_arm / layout_.scale);
    const PixelPoint corner{margin + axis_arm + 10, layout_.footer_px + axis_arm + 18};
    for (int c = 0; c < 3; ++c) {
        const Eigen::Vector2d arm =
            layout_.scale * arm_mm * projected(view_, Vec3::Unit(c));
        const PixelPoint tip = corner + PixelPoint{arm.x(), -arm.y()};
        if (!add_pixel_arrow(corner, tip, {axis_colour, 1.4, ""}))
            continue;
        const PixelPoint along = (tip - corner).normalized();
        picture_.add_text(tip + 11 * along + PixelPoint{0, 0.33 * caption_size},
                          options.axis_names[static_cast<std::size_t>(c)],
                          {caption_size, axis_colour, false, true});
    }
    if (options.has_length)
        picture_.add_text({margin, layout_.footer_px + footer_height - 16},
                          "each arm " + to_text(arm_mm) + " mm",
                          {0.9 * caption_size, axis_colour});
}

// The axes x and y are at the lower edges of the box that are nearest to the viewer, z at
// the edge that is farthest to the left.
void AxonometricFigure::add_ticks(const FigureOptions& options,
                                  std::span<const Vec3> corners)
{
    const std::size_t near_x = view_.toward.x() > 0 ? 1 : 0;
    const std::size_t near_y = view_.toward.y() > 0 ? 2 : 0;
    const auto outward = [&](const Vec3& direction) -> PixelPoint {
        const Eigen::Vector2d seen = projected(view_, direction);
        const double length = seen.norm();
        if (length < 0.1 || seen.y() > 0.01)  // seen along the view, or pointing upwards
            return {0, 1};
        return {seen.x() / length, -seen.y() / length};
    };
    const Vec3 out_of_x{0, near_y != 0 ? 1.0 : -1.0, 0};
    const Vec3 out_of_y{near_x != 0 ? 1.0 : -1.0, 0, 0};
    add_ticked_axis({0, corners[near_y], corners[near_y + 1], outward(out_of_x),
                     options.axis_names[0]});
    add_ticked_axis({1, corners[near_x], corners[near_x + 2], outward(out_of_y),
                     options.axis_names[1]});
    const auto leftmost = std::ranges::min_element(
        corners.first(4), {},
        [this](const Vec3& corner) { return view_.right.dot(corner); });
    const auto edge = static_cast<std::size_t>(leftmost - corners.begin());
    add_ticked_axis(
        {2, corners[edge], corners[edge + 4], {-1, 0}, options.axis_names[2]});
}

// Draws an axis, its ticks and numbers, and its name with the unit: below the middle of x
// and y, above the end of z.
void AxonometricFigure::add_ticked_axis(const TickedAxis& axis)
{
    const LineStyle style{axis_colour, 1, ""};
    const PixelPoint from = pixels(axis.low);
    const PixelPoint to = pixels(axis.high);
    const double length = (to - from).norm();
    if (length < least_axis)
        return;
    picture_.add_polyline(std::array{from, to}, style);
    const auto coordinate = static_cast<Eigen::Index>(axis.number);
    const std::vector<double> ticks =
        ticks_within(axis.low[coordinate], axis.high[coordinate],
                     std::max(1, static_cast<int>(length / tick_distance)));
    const PixelPoint base{0, 0.36 * tick_size};  // centres the letters vertically
    const bool is_upright = axis.number == 2;
    for (const double tick : ticks) {
        Vec3 point = axis.low;
        point[coordinate] = tick;
        const PixelPoint at = pixels(point);
        const std::string number = tick_text(tick, step_of(ticks));
        const double half_width =
            0.5 * letter_width * tick_size * static_cast<double>(number.size());
        const double shift = tick_length + 3 + half_width * std::abs(axis.outward.x()) +
                             0.7 * tick_size * std::abs(axis.outward.y());
        picture_.add_polyline(
            std::array<PixelPoint, 2>{at, at + tick_length * axis.outward}, style);
        picture_.add_text(at + shift * axis.outward + base, number,
                          {tick_size, axis_colour, false, true});
    }
    const double name_shift = tick_size * (2.8 + 1.6 * std::abs(axis.outward.x()));
    PixelPoint name_at = (from + to) / 2 + name_shift * axis.outward;
    if (is_upright)
        name_at = to + PixelPoint{0, -tick_size};
    picture_.add_text(name_at + base, std::string{axis.name} + ", mm",
                      {tick_size, axis_colour, true, true});
}

}  // namespace endmill
