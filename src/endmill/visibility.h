// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `visibility`.

#include "endmill/visibility/sphere_grid.h"
#include "endmill/visibility/visibility.h"
