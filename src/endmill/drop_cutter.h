// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `drop_cutter`.

#include "endmill/drop_cutter/clearance.h"
#include "endmill/drop_cutter/drop_cutter.h"
#include "endmill/drop_cutter/mesh_sections.h"
