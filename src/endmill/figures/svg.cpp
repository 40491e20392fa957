// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/axonometric_figure.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

// Polylines are simplified while they are written (`visible_points`). From a start point
// the algorithm keeps the sector of directions in which a straight segment passes all
// points so far within a tolerance. Each further point narrows the sector. A point
// outside the sector, or one that turns back, ends the segment at the point before and
// starts a new sector there. Every point is examined once, so the time is linear.
//
// Coordinates are written as whole hundredths of a pixel, relative to the rounded point
// before, so rounding errors do not accumulate along a path.

namespace endmill {
namespace {

// Largest distance of a dropped point from the simplified polyline: invisible on a
// screen.
constexpr double invisible_px = 0.1;
// Tolerance across a segment and beyond its end; the two together are below invisible_px.
constexpr double leeway_px = 0.7 * invisible_px;

// Cross product of two vectors in the plane.
double cross(const PixelPoint& a, const PixelPoint& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

// The sector of directions in which a segment from the apex passes all points so far
// within `leeway_px`.
class DirectionSector {
public:
    explicit DirectionSector(const PixelPoint& apex) : apex_{apex} {}

    // Adds `point` if a segment to it passes all points so far. \return whether it does.
    bool take(const PixelPoint& point)
    {
        const PixelPoint arm = point - apex_;
        const double length = arm.norm();
        if (length < reach_ - leeway_px)
            return false;
        if (has_bounds_ &&
            (cross(low_, arm) < 0 || cross(arm, high_) < 0 || low_.dot(arm) < 0))
            return false;
        reach_ = std::max(reach_, length);
        if (length > leeway_px)
            narrow(arm / length, leeway_px / length);
        return true;
    }

private:
    // Intersects the sector with the directions that pass the point within the tolerance.
    // `sine` is the tolerance over the distance of the point.
    void narrow(const PixelPoint& direction, double sine)
    {
        const double cosine = std::sqrt(1 - sine * sine);
        const PixelPoint across{-direction.y(), direction.x()};
        const PixelPoint low = cosine * direction - sine * across;
        const PixelPoint high = cosine * direction + sine * across;
        if (!has_bounds_ || cross(low_, low) > 0)
            low_ = low;
        if (!has_bounds_ || cross(high, high_) > 0)
            high_ = high;
        has_bounds_ = true;
    }

    PixelPoint apex_;
    PixelPoint low_{0, 0};   // clockwise end of the directions
    PixelPoint high_{0, 0};  // counter-clockwise end
    double reach_ = 0;
    bool has_bounds_ = false;  // false while all directions are allowed
};

// The points of the simplified polyline. Every dropped point is within `invisible_px` of
// it.
std::vector<PixelPoint> visible_points(std::span<const PixelPoint> points)
{
    std::vector<PixelPoint> kept{points.front()};
    DirectionSector sector{points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (sector.take(points[i]))
            continue;
        kept.push_back(points[i - 1]);
        sector = DirectionSector{points[i - 1]};
        sector.take(points[i]);
    }
    kept.push_back(points.back());
    return kept;
}

// A coordinate in whole hundredths of a pixel.
long hundredths(double value)
{
    require(std::isfinite(value), "SvgPicture: a coordinate is not finite");
    return std::lround(100 * value);
}

// Appends a number of hundredths as a decimal without trailing zeros.
void append_hundredths(std::string& text, long number)
{
    if (number < 0)
        text += '-';
    const long magnitude = std::labs(number);
    const long fraction = magnitude % 100;
    if (magnitude >= 100 || fraction == 0)
        text += std::to_string(magnitude / 100);
    if (fraction == 0)
        return;
    text += '.';
    text += static_cast<char>('0' + fraction / 10);
    if (fraction % 10 != 0)
        text += static_cast<char>('0' + fraction % 10);
}

// Appends an attribute with a number.
void append_attribute(std::string& text, std::string_view name, double value)
{
    text += ' ';
    text += name;
    text += "=\"";
    append_hundredths(text, hundredths(value));
    text += '"';
}

// Appends an attribute with an escaped text.
void append_attribute(std::string& text, std::string_view name, std::string_view value)
{
    text += ' ';
    text += name;
    text += "=\"" + xml_escaped(value) + "\"";
}

// Appends the attributes of a line. Colours come from the program and never from a file.
void append_style(std::string& text, const LineStyle& line, std::string_view fill)
{
    append_attribute(text, "fill", fill);
    append_attribute(text, "stroke", line.colour);
    append_attribute(text, "stroke-width", line.width_px);
    append_attribute(text, "stroke-linejoin", "round");
    if (!line.dashes.empty())
        append_attribute(text, "stroke-dasharray", line.dashes);
}

// The data of a path element, with each point relative to the rounded point before.
std::string path_data(std::span<const PixelPoint> points)
{
    std::string data = "M";
    long x = 0;
    long y = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const long next_x = hundredths(points[i].x());
        const long next_y = hundredths(points[i].y());
        data += i == 0 ? "" : i == 1 ? "l" : next_x < x ? "" : " ";
        append_hundredths(data, next_x - x);
        data += next_y < y ? "" : " ";
        append_hundredths(data, next_y - y);
        x = next_x;
        y = next_y;
    }
    return data;
}

// The XML entity of a character; empty if it needs none.
std::string_view entity(char character)
{
    switch (character) {
        case '&':
            return "&amp;";
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        case '"':
            return "&quot;";
        case '\'':
            return "&#39;";
        default:
            return {};
    }
}

}  // namespace

SvgPicture::SvgPicture(double width_px, double height_px, std::string_view title)
{
    require(std::isfinite(width_px) && std::isfinite(height_px) && width_px > 0 &&
                height_px > 0,
            "SvgPicture: need a finite size above 0");
    std::string width;
    std::string height;
    append_hundredths(width, hundredths(width_px));
    append_hundredths(height, hundredths(height_px));
    text_ = "<svg xmlns=\"http://www.w3.org/2000/svg\"";
    append_attribute(text_, "width", width);
    append_attribute(text_, "height", height);
    append_attribute(text_, "viewBox", "0 0 " + width + " " + height);
    text_ += " font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\">\n<title>" +
             xml_escaped(title) + "</title>\n";
    text_ += "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
}

void SvgPicture::add_polyline(std::span<const PixelPoint> points, const LineStyle& style)
{
    if (points.size() < 2)
        return;
    text_ += "<path";
    append_style(text_, style, "none");
    text_ += " d=\"" + path_data(visible_points(points)) + "\"/>\n";
}

void SvgPicture::add_polygon(std::span<const PixelPoint> points, std::string_view fill,
                             const LineStyle& outline)
{
    if (points.size() < 3)
        return;
    text_ += "<path";
    append_style(text_, outline, fill);
    text_ += " d=\"" + path_data(visible_points(points)) + "z\"/>\n";
}

// All boxes are one path element, which keeps maps with many squares small.
void SvgPicture::add_boxes(std::span<const PixelBox> boxes, std::string_view fill)
{
    if (boxes.empty())
        return;
    text_ += "<path";
    append_attribute(text_, "fill", fill);
    append_attribute(text_, "stroke", "none");
    append_attribute(text_, "shape-rendering", "crispEdges");
    text_ += " d=\"";
    for (const PixelBox& box : boxes) {
        text_ += "M" + std::to_string(box.x) + " " + std::to_string(box.y);
        text_ += "h" + std::to_string(box.width) + "v" + std::to_string(box.height);
        text_ += "h" + std::to_string(-box.width) + "z";
    }
    text_ += "\"/>\n";
}

void SvgPicture::add_disc(const PixelPoint& centre, double radius_px,
                          std::string_view colour)
{
    text_ += "<circle";
    append_attribute(text_, "cx", centre.x());
    append_attribute(text_, "cy", centre.y());
    append_attribute(text_, "r", radius_px);
    append_attribute(text_, "fill", colour);
    text_ += "/>\n";
}

// xml:space keeps blanks in the text as they are.
void SvgPicture::add_text(const PixelPoint& place, std::string_view text,
                          const TextStyle& style)
{
    text_ += "<text xml:space=\"preserve\"";
    append_attribute(text_, "x", place.x());
    append_attribute(text_, "y", place.y());
    append_attribute(text_, "font-size", style.size_px);
    append_attribute(text_, "fill", style.colour);
    if (style.bold)
        append_attribute(text_, "font-weight", "bold");
    if (style.centred)
        append_attribute(text_, "text-anchor", "middle");
    text_ += ">" + xml_escaped(text) + "</text>\n";
}

std::string SvgPicture::text() const
{
    return text_ + "</svg>\n";
}

std::string xml_escaped(std::string_view text)
{
    std::string escaped;
    for (const char character : printable(text)) {
        const std::string_view name = entity(character);
        if (name.empty())
            escaped += character;
        else
            escaped += name;
    }
    return escaped;
}

}  // namespace endmill
