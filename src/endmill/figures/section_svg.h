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

/// What is drawn of one drive plane.
struct SectionDrawing {
    std::span<const SectionCurve> before;  ///< the offset's curves, reference points
    std::span<const TrimmedCurve> after;   ///< what is left of them
    std::optional<Cutter> cutter{};        ///< drawn where curves cross, if known
    std::vector<std::vector<SectionPoint>> part{};  ///< lines of the part itself, (s, z)
};

/// A section before and after trimming as an SVG file, s to the right and z upwards in one
/// scale: what is cut out red, what is left blue, the part black; the cutter stands at the
/// first few crossings, or at the middle of the first curve that is left.
/// Source: the manner of [JangKimJeong, figs. 13 to 15].
/// \param figure title, captions and width; view and axes are this function's.
/// \throws DomainError if there is no point to draw, or one that is not finite.
std::string section_svg(const SectionDrawing& drawing, FigureOptions figure = {});

/// Curves in space as an SVG file in parallel projection, as what is left of an offset.
/// Source: the manner of [JangKimJeong, fig. 18].
/// \throws DomainError as above.
std::string curves_svg(std::span<const std::vector<Vec3>> curves,
                       const FigureOptions& figure = {});

}  // namespace endmill
