// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/command.h"
#include "cli/surface_facts.h"
#include "endmill/files/part_file.h"
#include "endmill/surface/continuity.h"

namespace endmill {

/// summary.json of a part that is made of surfaces, whose continuity is known.
/// \param axis of the tool, unit, from the tip to the spindle.
Json surface_summary(const PartFile& file, const SurfaceContinuity& continuity,
                     const Vec3& axis);

/// The same for a person.
std::string surface_text(const Json& summary);

/// summary.json of a part that is a mesh.
Json mesh_summary(const PartFile& file, const PartOptions& options);

/// The same for a person.
std::string mesh_text(const Json& summary);

}  // namespace endmill
