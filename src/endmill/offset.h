// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `offset`.

#include "endmill/offset/drive_planes.h"
#include "endmill/offset/offset_contact.h"
#include "endmill/offset/offset_mesh.h"
#include "endmill/offset/section_curve.h"
#include "endmill/offset/slicer.h"
