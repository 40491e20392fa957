// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/plan_files.h"

namespace endmill {

/// Plans a mesh from the directions of --setups, and writes path, picture and summary into
/// `folder`. The files of an earlier run are replaced.
/// \param task its part is for the picture.
/// \param mesh the part with the facets of its file.
/// \throws FormatError, LimitError as read_setup_directions; as plan_indexed.
PlanResult write_setups_plan(const PlanTask& task, const TriangleMesh& mesh,
                             OutputFolder& folder);

}  // namespace endmill
