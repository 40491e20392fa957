// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/command.h"
#include "cli/surface_facts.h"
#include "endmill/files/part_file.h"
#include "endmill/surface/continuity.h"

namespace endmill {

/// summary.json of a part that consists of surfaces.
/// \param axis tool axis, a unit vector from the tip to the spindle.
Json surface_summary(const PartFile& file, const SurfaceContinuity& continuity,
                     const Vec3& axis);

/// The report on the terminal.
std::string surface_text(const Json& summary);

/// summary.json of a part that is a mesh.
Json mesh_summary(const PartFile& file, const PartOptions& options);

/// The report on the terminal.
std::string mesh_text(const Json& summary);

}  // namespace endmill
