// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/axonometric_figure.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

// Tenths of a pixel cannot be seen: what a polyline may move by when points are dropped.
constexpr double invisible_px = 0.1;
// The same across a segment and beyond its end, which together make invisible_px.
constexpr double leeway_px = 0.7 * invisible_px;

double cross(const PixelPoint& a, const PixelPoint& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

// The directions in which a segment from its apex passes all points so far within
// `leeway_px`, none of them further beyond its end.
class Sleeve {
public:
    explicit Sleeve(const PixelPoint& apex) : apex_{apex} {}

    // Whether a segment to `point` serves all points so far; if so, `point` joins them.
    bool take(const PixelPoint& point)
    {
        const PixelPoint arm = point - apex_;
        const double length = arm.norm();
        if (length < reach_ - leeway_px)
            return false;
        if (open_ && (cross(low_, arm) < 0 || cross(arm, high_) < 0 || low_.dot(arm) < 0))
            return false;
        reach_ = std::max(reach_, length);
        if (length > leeway_px)
            narrow(arm / length, leeway_px / length);
        return true;
    }

private:
    void narrow(const PixelPoint& direction, double sine)
    {
        const double cosine = std::sqrt(1 - sine * sine);
        const PixelPoint across{-direction.y(), direction.x()};
        const PixelPoint low = cosine * direction - sine * across;
        const PixelPoint high = cosine * direction + sine * across;
        if (!open_ || cross(low_, low) > 0)
            low_ = low;
        if (!open_ || cross(high, high_) > 0)
            high_ = high;
        open_ = true;
    }

    PixelPoint apex_;
    PixelPoint low_{0, 0};   // clockwise end of the directions
    PixelPoint high_{0, 0};  // counter-clockwise end
    double reach_ = 0;
    bool open_ = false;  // whether low_ and high_ are set
};

// The points that must stay; each dropped one is within `invisible_px` of the rest.
std::vector<PixelPoint> visible_points(std::span<const PixelPoint> points)
{
    std::vector<PixelPoint> kept{points.front()};
    Sleeve sleeve{points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (sleeve.take(points[i]))
            continue;
        kept.push_back(points[i - 1]);
        sleeve = Sleeve{points[i - 1]};
        sleeve.take(points[i]);
    }
    kept.push_back(points.back());
    return kept;
}

long hundredths(double value)
{
    require(std::isfinite(value), "SvgPicture: a coordinate is not finite");
    return std::lround(100 * value);
}

// A number of hundredths as a decimal without needless digits.
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

void append_attribute(std::string& text, std::string_view name, double value)
{
    text += ' ';
    text += name;
    text += "=\"";
    append_hundredths(text, hundredths(value));
    text += '"';
}

void append_attribute(std::string& text, std::string_view name, std::string_view value)
{
    text += ' ';
    text += name;
    text += "=\"" + xml_escaped(value) + "\"";
}

// The attributes of a line; its colours are ours, so nothing of a file gets in here.
void append_style(std::string& text, const LineStyle& line, std::string_view fill)
{
    append_attribute(text, "fill", fill);
    append_attribute(text, "stroke", line.colour);
    append_attribute(text, "stroke-width", line.width_px);
    append_attribute(text, "stroke-linejoin", "round");
    if (!line.dashes.empty())
        append_attribute(text, "stroke-dasharray", line.dashes);
}

// The data of a path, each point relative to the rounded one before, so that roundings
// do not add up.
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
