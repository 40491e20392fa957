// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "endmill/figures/axonometric_figure.h"
#include "small_xml.h"

namespace endmill {

/// The points of the data of a path element, "M x y l dx dy …", as defined by SVG.
inline std::vector<PixelPoint> points_of(const std::string& data)
{
    std::vector<PixelPoint> points;
    PixelPoint at{0, 0};
    std::vector<double> numbers;
    for (const char* text = data.c_str(); *text != '\0';) {
        char* end = nullptr;
        const double number = std::strtod(text, &end);
        if (end == text) {
            ++text;
            continue;
        }
        numbers.push_back(number);
        text = end;
    }
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
        at += PixelPoint{numbers[i], numbers[i + 1]};
        points.push_back(at);
    }
    return points;
}

/// Distance of `point` from the polyline through `line`, in px.
inline double distance(const PixelPoint& point, const std::vector<PixelPoint>& line)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < line.size(); ++i) {
        const PixelPoint along = line[i] - line[i - 1];
        const double length2 = along.squaredNorm();
        const double t =
            length2 > 0 ? std::clamp((point - line[i - 1]).dot(along) / length2, 0.0, 1.0)
                        : 0;
        least = std::min(least, (point - line[i - 1] - t * along).norm());
    }
    return least;
}

/// The polylines and polygons of a picture; if `colour` is given, only those with this
/// stroke.
inline std::vector<std::vector<PixelPoint>> lines_of(const std::string& svg,
                                                     const std::string& colour = "")
{
    std::vector<std::vector<PixelPoint>> lines;
    for (const XmlElement& element : SmallXml::parse(svg))
        if (element.name == "path" &&
            (colour.empty() || element.attributes.at("stroke") == colour))
            lines.push_back(points_of(element.attributes.at("d")));
    return lines;
}

}  // namespace endmill
