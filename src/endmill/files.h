// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `files`.

#include "endmill/files/csv.h"
#include "endmill/files/dexel_file.h"
#include "endmill/files/input_csv.h"
#include "endmill/files/machining_data.h"
#include "endmill/files/mesh_file.h"
#include "endmill/files/output_folder.h"
#include "endmill/files/part_file.h"
#include "endmill/files/path_file.h"
#include "endmill/files/read_file.h"
#include "endmill/files/result_csv.h"
#include "endmill/files/setup_file.h"
#include "endmill/files/surface_file.h"
#include "endmill/files/visibility_file.h"
#include "endmill/files/vtk.h"
