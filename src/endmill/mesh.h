// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `mesh`.

#include "endmill/mesh/decimation.h"
#include "endmill/mesh/mesh_checks.h"
#include "endmill/mesh/mesh_repair.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/mesh/triangle_tree.h"
