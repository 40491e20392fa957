// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <Eigen/Core>

namespace endmill {

/// A place in a picture, in px: x to the right, y down.
using PixelPoint = Eigen::Vector2d;

/// How a line is drawn.
struct LineStyle {
    std::string_view colour = "#000000";  ///< as SVG writes it; never from a file
    double width_px = 1;                  ///< in px
    std::string_view dashes{};  ///< SVG's stroke-dasharray in px; empty: unbroken
};

/// How a line of text is set.
struct TextStyle {
    double size_px = 14;                  ///< height of the letters' em, in px
    std::string_view colour = "#222222";  ///< as SVG writes it; never from a file
    bool bold = false;                    ///< bold or regular
    bool centred = false;  ///< its middle or its beginning at the place given
};

/// An upright rectangle in a picture, in whole px.
struct PixelBox {
    int x = 0;  ///< of its left side
    int y = 0;  ///< of its upper side
    int width = 1;
    int height = 1;
};

/// A picture in SVG 1.1 on white, built element by element. All text is escaped; all
/// numbers have at most two decimals.
class SvgPicture {
public:
    /// \param title what a screen reader says. \param width_px, height_px in px.
    /// \throws DomainError unless both are finite and positive.
    SvgPicture(double width_px, double height_px, std::string_view title);

    /// Points joined by straight lines; fewer than two draw nothing. Those that the rest
    /// passes within 0.1 px are left out, so that the size follows what can be seen.
    void add_polyline(std::span<const PixelPoint> points, const LineStyle& style);

    /// A filled outline, closed from its last point to its first. \param fill as
    /// LineStyle::colour. Fewer than three points draw nothing.
    void add_polygon(std::span<const PixelPoint> points, std::string_view fill,
                     const LineStyle& outline);

    /// Rectangles of one colour, as one element, with sharp sides: between two that touch
    /// nothing shows through. None draw nothing.
    void add_boxes(std::span<const PixelBox> boxes, std::string_view fill);

    /// A filled disc. \param radius_px in px.
    void add_disc(const PixelPoint& centre, double radius_px, std::string_view colour);

    /// One line of text on the base line through `place`.
    void add_text(const PixelPoint& place, std::string_view text, const TextStyle& style);

    /// The whole file.
    std::string text() const;

private:
    std::string text_;
};

/// `text` for XML: & < > " ' as entities, without control characters.
std::string xml_escaped(std::string_view text);

}  // namespace endmill
