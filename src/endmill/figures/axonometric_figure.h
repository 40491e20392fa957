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

/// \file
/// Drawing in SVG: pictures in the plane (`SvgPicture`, lengths in px), and drawings in
/// space in parallel projection with title, axes and legend (`AxonometricFigure`, lengths
/// in mm). All other figures of this module use these two classes.
///
/// Implemented in `svg.cpp` (SvgPicture) and `axonometric_figure.cpp`.

namespace endmill {

/// A point in a picture, in px: x to the right, y down.
using PixelPoint = Eigen::Vector2d;

/// Style of a line.
struct LineStyle {
    std::string_view colour = "#000000";  ///< in the notation of SVG; never from a file
    double width_px = 1;                  ///< in px
    std::string_view dashes{};  ///< stroke-dasharray of SVG, in px; empty: a solid line
};

/// Style of a text.
struct TextStyle {
    double size_px = 14;                  ///< font size in px
    std::string_view colour = "#222222";  ///< in the notation of SVG; never from a file
    bool bold = false;                    ///< bold or regular
    bool centred = false;                 ///< placed by its middle or by its beginning
};

/// A rectangle with sides parallel to the axes of a picture, in whole px.
struct PixelBox {
    int x = 0;       ///< left side
    int y = 0;       ///< upper side
    int width = 1;   ///< in px
    int height = 1;  ///< in px
};

/// A picture in SVG 1.1 on a white ground. Elements are added one by one; later ones
/// cover earlier ones. Texts are escaped; numbers have at most two decimals.
class SvgPicture {
public:
    /// An empty picture.
    /// \param width_px,height_px size in px.
    /// \param title the title element, which screen readers read aloud.
    /// \throws DomainError unless both sizes are finite and positive.
    SvgPicture(double width_px, double height_px, std::string_view title);

    /// Adds straight lines between consecutive points; nothing if there are fewer than
    /// two. Points that are within 0.1 px of the line through the others are left out, so
    /// that the size of the file depends on the visible shape and not on the number of
    /// points.
    /// \throws DomainError if a coordinate is not finite; so do the functions below.
    void add_polyline(std::span<const PixelPoint> points, const LineStyle& style);

    /// Adds a filled polygon; nothing if there are fewer than three points.
    /// \param fill as LineStyle::colour.
    void add_polygon(std::span<const PixelPoint> points, std::string_view fill,
                     const LineStyle& outline);

    /// Adds rectangles of one colour as one element, without anti-aliasing: no gap is
    /// visible between rectangles that touch. Nothing is added if there are none.
    void add_boxes(std::span<const PixelBox> boxes, std::string_view fill);

    /// Adds a filled disc. \param radius_px in px.
    void add_disc(const PixelPoint& centre, double radius_px, std::string_view colour);

    /// Adds one line of text whose base line passes through `place`.
    void add_text(const PixelPoint& place, std::string_view text, const TextStyle& style);

    /// The whole SVG file.
    std::string text() const;

private:
    std::string text_;
};

/// `text` for use in XML: & < > " ' as entities, without control characters.
std::string xml_escaped(std::string_view text);

/// Title, size and view of a drawing in space.
struct FigureOptions {
    std::string title{};  ///< above the drawing; cut after 100 characters
    /// Lines below the title; cut after 150 characters.
    std::vector<std::string> captions{};
    double width_px = 900;                ///< of the whole picture, in px; at least 300
    Angle azimuth = Angle::degrees(-60);  ///< direction to the viewer, from +x towards +y
    Angle elevation = Angle::degrees(30);  ///< of the viewer above the xy plane
    std::array<std::string_view, 3> axis_names{"x", "y", "z"};  ///< at the axes' arrows
    bool has_length = true;  ///< whether the axis arrows are labelled with their length
    /// Whether axes with ticks in mm stand at the box around the drawing, in place of the
    /// arrows below it.
    bool has_ticks = false;
};

/// Directions of a parallel projection from space to a picture plane, mm to mm.
struct AxonometricView {
    Vec3 right;   ///< unit vector to the right in the picture
    Vec3 up;      ///< unit vector upwards in the picture
    Vec3 toward;  ///< unit vector to the viewer

    /// The view from the direction with this azimuth and elevation.
    AxonometricView(Angle azimuth, Angle elevation);
};

/// A drawing in space in parallel projection: title and captions, the drawing, and below
/// it the axes x, y, z with their length in mm and a legend. With ticks the axes are
/// beside the drawing instead.
class AxonometricFigure {
public:
    /// An empty drawing with its title and axes.
    /// \param extent points in mm for which the drawing has room.
    /// \throws DomainError if `extent` is empty or not finite, or the width is below 300.
    AxonometricFigure(const FigureOptions& options, std::span<const Vec3> extent);

    /// Adds straight lines between consecutive points, in mm.
    void add_curve(std::span<const Vec3> points, const LineStyle& style);

    /// Adds a filled polygon, in mm. It covers what was added before.
    void add_polygon(std::span<const Vec3> points, std::string_view fill,
                     const LineStyle& outline);

    /// Adds a disc at `point`, in mm. \param radius_px in px.
    void add_disc(const Vec3& point, double radius_px, std::string_view colour);

    /// Adds an arrow between two points, in mm, with its head at `to`. Nothing is added
    /// if the arrow appears shorter than its head.
    void add_arrow(const Vec3& from, const Vec3& to, const LineStyle& style);

    /// Adds a line of text that is centred at `point`, in mm, moved by `shift_px` to the
    /// right and down. \param colour as LineStyle::colour.
    void add_label(const Vec3& point, const PixelPoint& shift_px, std::string_view text,
                   std::string_view colour);

    /// Directions of the projection.
    const AxonometricView& view() const { return view_; }

    /// Adds a line to the legend, with a sample of the line style. A column has five
    /// lines. A picture of 900 px has room for three columns.
    void add_legend(std::string_view label, const LineStyle& style);

    /// Adds a line to the legend, with a disc.
    void add_disc_legend(std::string_view label, double radius_px,
                         std::string_view colour);

    /// The whole SVG file.
    std::string text() const { return picture_.text(); }

private:
    struct Layout {
        double width_px;
        double height_px;
        double footer_px;   ///< y at which the axes and the legend begin
        double scale;       ///< px per mm
        PixelPoint origin;  ///< of the point (0, 0, 0)
        double legend_px;   ///< x at which the legend begins
    };

    // An axis with ticks along an edge of the box around the drawing.
    struct TickedAxis {
        std::size_t number;  // 0 to 2: x, y, z
        Vec3 low;            // ends of the edge, in mm
        Vec3 high;           //
        PixelPoint outward;  // unit vector away from the drawing
        std::string_view name;
    };

    static Layout layout_for(const FigureOptions& options, const AxonometricView& view,
                             std::span<const Vec3> extent);
    PixelPoint pixels(const Vec3& point) const;
    std::vector<PixelPoint> pixels(std::span<const Vec3> points) const;
    void add_heading(const FigureOptions& options);
    bool add_pixel_arrow(const PixelPoint& from, const PixelPoint& to,
                         const LineStyle& style);
    void add_axes(const FigureOptions& options);
    void add_ticks(const FigureOptions& options, std::span<const Vec3> corners);
    void add_ticked_axis(const TickedAxis& axis);
    PixelPoint next_legend() const;  // where the sample of the next line begins
    void name_legend(std::string_view label);

    AxonometricView view_;
    Layout layout_;
    SvgPicture picture_;
    int legend_lines_ = 0;
};

}  // namespace endmill
