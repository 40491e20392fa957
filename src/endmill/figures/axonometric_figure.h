// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "endmill/core/angle.h"
#include "endmill/core/vec.h"

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

/// What surrounds a drawing in space, and from where it is seen.
struct FigureOptions {
    std::string title{};  ///< above the drawing; at most 100 characters show
    std::vector<std::string> captions{};  ///< lines below the title; 150 characters show
    double width_px = 900;                ///< of the whole picture, in px, at least 300
    Angle azimuth = Angle::degrees(-60);  ///< where the viewer stands, from +x towards +y
    Angle elevation = Angle::degrees(30);  ///< of the viewer over the xy plane
    std::array<std::string_view, 3> axis_names{"x", "y", "z"};  ///< at their arrows
    bool has_length = true;  ///< whether the length of the axes is told, in mm
};

/// Directions of a parallel projection: mm in space to mm in the picture.
struct AxonometricView {
    Vec3 right;   ///< unit, to the right in the picture
    Vec3 up;      ///< unit, upwards in the picture
    Vec3 toward;  ///< unit, to the viewer

    /// The view of somebody who stands in direction (azimuth, elevation) of the part.
    AxonometricView(Angle azimuth, Angle elevation);
};

/// A drawing in space, in parallel projection: title and captions, the drawing, and below
/// it the axes x, y, z with their length in mm, and a legend.
class AxonometricFigure {
public:
    /// \param extent points in mm that the drawing must have room for.
    /// \throws DomainError if `extent` is empty or not finite, or the width is below 300.
    AxonometricFigure(const FigureOptions& options, std::span<const Vec3> extent);

    /// A line through `points`, in mm.
    void add_curve(std::span<const Vec3> points, const LineStyle& style);

    /// A filled outline, in mm, over what was drawn before it.
    void add_polygon(std::span<const Vec3> points, std::string_view fill,
                     const LineStyle& outline);

    /// A small disc at `point`, in mm. \param radius_px in px.
    void add_disc(const Vec3& point, double radius_px, std::string_view colour);

    /// A straight line between two points, in mm, with a head at `to`; one that is seen from
    /// its end, and so shorter than its head, draws nothing.
    void add_arrow(const Vec3& from, const Vec3& to, const LineStyle& style);

    /// A line of text with its middle at `point`, in mm, moved by `shift_px` to the right and
    /// down: a name for what is drawn there. \param colour as LineStyle::colour.
    void add_label(const Vec3& point, const PixelPoint& shift_px, std::string_view text,
                   std::string_view colour);

    const AxonometricView& view() const { return view_; }  ///< from where it is seen

    /// A line of the legend, in the order added; after every five begins a column, of
    /// which a picture of 900 px has room for three.
    void add_legend(std::string_view label, const LineStyle& style);

    /// The same for discs.
    void add_disc_legend(std::string_view label, double radius_px,
                         std::string_view colour);

    /// The whole file, SVG 1.1.
    std::string text() const { return picture_.text(); }

private:
    struct Layout {
        double width_px;
        double height_px;
        double footer_px;   ///< y at which the axes and the legend begin
        double scale;       ///< px per mm
        PixelPoint origin;  ///< of the point (0, 0, 0)
    };

    static Layout layout_for(const FigureOptions& options, const AxonometricView& view,
                             std::span<const Vec3> extent);
    PixelPoint pixels(const Vec3& point) const;
    std::vector<PixelPoint> pixels(std::span<const Vec3> points) const;
    void add_heading(const FigureOptions& options);
    bool add_pixel_arrow(const PixelPoint& from, const PixelPoint& to,
                         const LineStyle& style);
    void add_axes(const FigureOptions& options);
    PixelPoint next_legend() const;  // where its sample begins
    void name_legend(std::string_view label);

    AxonometricView view_;
    Layout layout_;
    SvgPicture picture_;
    int legend_lines_ = 0;
};

}  // namespace endmill
