// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `post`.

#include "endmill/post/apt.h"
#include "endmill/post/control.h"
#include "endmill/post/fed_gcode.h"
#include "endmill/post/gcode_reader.h"
#include "endmill/post/gcode_writer.h"
#include "endmill/post/machine_gcode.h"
#include "endmill/post/machine_path.h"
#include "endmill/post/program.h"
