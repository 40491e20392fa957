// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/cutter/cutter.h"
#include "endmill/cutter/tool.h"
#include "endmill/orientation/axis_field.h"
#include "endmill/orientation/inclination.h"
#include "endmill/planning/linking.h"
#include "endmill/strategy/strategy_options.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// How the tool leans at each contact.
enum class AxisMode {
    Fixed,  ///< by the given lead and tilt
    /// By the least lead at which the cutter does not gouge, but one degree more, and at least
    /// the given one. The tilt is the given one.
    Lead,
    /// By an axis field over the whole path, on the passes of `Lead`. It wants the inclination
    /// of `Lead`, for a cutter that is no ball with a lead of at least one degree.
    Field,
};

/// How passes are laid on a mesh.
struct MeshPassOptions {
    /// Planar, IsoScallop or Field. Passes are those of a ball of the cutter's radius along +z.
    Strategy strategy = Strategy::IsoScallop;
    std::optional<Angle> direction = {};  ///< of planar passes; nothing: the best
    /// Triangles that are not cut, ascending. The tool keeps off them.
    std::vector<std::size_t> skipped_facets = {};
    std::size_t most_samples = 20'000'000;  ///< a part that needs more throws LimitError
};

/// How an oriented path is planned.
struct OrientedOptions {
    AxisMode mode = AxisMode::Lead;        ///< how the tool leans
    Inclination inclination = {};          ///< given lead and tilt
    Parameter along = Parameter::U;        ///< the parameter along passes of surfaces
    double scallop_height = 0.05;          ///< mm along the normal, above 0
    double inner_tolerance = 0.01;         ///< mm, greatest depth of a gouge; above 0
    PassOrder order = PassOrder::ZigZag;   ///< direction of neighbouring passes
    double safe_height = 0;                ///< mm, z of lifted tools; above the part
    std::size_t most_points = 40'000'000;  ///< a longer path throws LimitError
    MeshPassOptions mesh_passes = {};      ///< of a mesh
    /// Of mode Field: ranges and machine, which must outlive the options.
    AxisFieldOptions field = {};
    /// Shank and holder, which mode Field keeps off the part.
    std::vector<ToolCylinder> tool_body = {};
    /// If set, it is called with the finished share, 0 to 1.
    std::function<void(double share)> progress = {};
};

/// \throws DomainError unless scallop height and inner tolerance are above 0 and below the
///         radius of the cutter, and the safe height is finite.
void require_sound(const OrientedOptions& options, const Cutter& cutter);

}  // namespace endmill
