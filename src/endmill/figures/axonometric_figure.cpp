// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/axonometric_figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

// The page has four parts from top to bottom: title and captions, the drawing, and a
// footer with the axes to the left and the legend to the right. The width of the page is
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
    const double room = options.width_px - 2 * margin;
    const Eigen::Vector2d size = box.sizes();
    const bool is_point = size.maxCoeff() <= 0;
    const double scale =
        is_point ? 1 : 1 / std::max(size.x() / room, size.y() / drawing_height);

    // The drawing is centred between the margins, the footer stands below it.
    const double top = heading_height(options) + drawing_gap;
    const double bottom = top + scale * size.y();
    const PixelPoint origin{options.width_px / 2 - scale * box.center().x(),
                            bottom + scale * box.min().y()};
    return {options.width_px, bottom + drawing_gap + footer_height, bottom + drawing_gap,
            scale, origin};
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
    return {margin + legend_offset + legend_column * column,
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

}  // namespace endmill
