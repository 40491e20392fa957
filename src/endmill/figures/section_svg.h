// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"
#include "endmill/figures/axonometric_figure.h"
#include "endmill/trimming/trimming.h"

/// \file
/// Figures of trimming: a section before and after, the results of several methods, and
/// the trimmed curves in space.
///
/// Implemented in `section_svg.cpp` and `methods_chart_svg.cpp`.

namespace endmill {

/// The curves of one drive plane to be drawn. All coordinates are (s, z) in mm.
struct SectionDrawing {
    std::span<const SectionCurve> before;  ///< sections of the offset, reference points
    std::span<const TrimmedCurve> after;   ///< the same after trimming
    std::optional<Cutter> cutter{};        ///< drawn at a few crossings
    std::vector<std::vector<SectionPoint>> part{};  ///< sections of the part itself
};

/// A section before and after trimming, as an SVG file with s to the right and z upwards
/// at the same scale. Removed parts are red, the trimmed curves blue, the part black. The
/// cutter is drawn at the first three crossings. Without a crossing it is drawn at the
/// middle of the first trimmed curve.
/// Source: after [JangKimJeong, figs. 13 to 15].
/// \param figure title, captions and width; view and axis names are replaced.
/// \throws DomainError if there is no point, or one that is not finite.
std::string section_svg(const SectionDrawing& drawing, FigureOptions figure = {});

/// The trimmed curves of methods that left the same curves.
struct ComparedCurves {
    std::string label;                     ///< names of the methods, for the legend
    std::span<const TrimmedCurve> curves;  ///< of one plane
};

/// The curves that different methods left of one section.
struct ComparedSections {
    std::span<const SectionCurve> before;  ///< sections of the offset, reference points
    ComparedCurves exact;                  ///< the curves to compare with
    /// Curves that differ from the exact ones; at most four are drawn.
    std::vector<ComparedCurves> others;
    std::optional<Cutter> cutter{};      ///< drawn at `places`
    std::vector<SectionPoint> places{};  ///< reference points of the cutter
    /// Half the side in mm of the square about the first place that is drawn.
    double half_side = std::numeric_limits<double>::infinity();
    std::vector<std::vector<SectionPoint>> part{};  ///< sections of the part itself
};

/// A section with the curves that different methods left of it, as an SVG file with s to
/// the right and z upwards at the same scale. The exact curve is a broad band; other
/// curves are narrow lines, so that they show where they leave the band and the band shows
/// where they are missing.
/// \param figure title, captions and width; view and axis names are replaced.
/// \throws DomainError if there is no point, or one that is not finite.
std::string compared_sections_svg(const ComparedSections& drawing,
                                  FigureOptions figure = {});

/// A row of methods_chart_svg: the times and differences of one method.
struct MethodRow {
    std::string name;                  ///< of the method
    double median_ms = 0;              ///< median of the times
    double lower_ms = 0;               ///< lower quartile of the times
    double upper_ms = 0;               ///< upper quartile of the times
    std::vector<double> distances_mm;  ///< from the exact curve, one for each plane
    std::vector<bool> is_right;        ///< by the exact curve, one for each plane
};

/// Texts and limit of methods_chart_svg.
struct MethodsChart {
    std::string title{};                  ///< above the chart
    std::vector<std::string> captions{};  ///< lines below the title
    double tolerance_mm = 0.01;           ///< smaller differences are not drawn; > 0
};

/// Chart of trimming methods, one row a method, as an SVG file: to the left the median
/// time as a bar, with a line from the lower to the upper quartile; to the right the
/// distance from the exact curve in each plane, on a logarithmic scale, in another colour
/// where the result is wrong.
/// \throws DomainError unless there is a row, all rows have one distance and one verdict
///     for each plane, times are finite and not negative, distances are finite, and 0 <
///     tolerance_mm.
std::string methods_chart_svg(std::span<const MethodRow> rows, const MethodsChart& chart);

/// Curves in space in parallel projection, such as the trimmed sections of an offset, as
/// an SVG file.
/// Source: after [JangKimJeong, fig. 18].
/// \throws DomainError if there is no point, or one that is not finite.
std::string curves_svg(std::span<const std::vector<Vec3>> curves,
                       const FigureOptions& figure = {});

}  // namespace endmill
