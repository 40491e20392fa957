// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `orientation`.

#include "endmill/orientation/axis_field.h"
#include "endmill/orientation/inclination.h"
#include "endmill/orientation/oriented_options.h"
#include "endmill/orientation/oriented_path.h"
