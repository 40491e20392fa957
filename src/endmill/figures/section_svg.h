// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"
#include "endmill/figures/axonometric_figure.h"
#include "endmill/trimming/trimming.h"

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

/// Curves in space in parallel projection, such as the trimmed sections of an offset, as
/// an SVG file.
/// Source: after [JangKimJeong, fig. 18].
/// \throws DomainError if there is no point, or one that is not finite.
std::string curves_svg(std::span<const std::vector<Vec3>> curves,
                       const FigureOptions& figure = {});

}  // namespace endmill
