// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/command.h"
#include "endmill/io/surface_file.h"
#include "endmill/surface/continuity.h"

namespace endmill {

/// summary.json of a surface whose continuity is known.
/// \param axis of the tool, unit, from the tip to the spindle.
Json info_summary(const SurfaceFile& file, const SurfaceContinuity& continuity,
                  const Vec3& axis);

/// The same for a person.
std::string info_text(const Json& summary);

}  // namespace endmill
