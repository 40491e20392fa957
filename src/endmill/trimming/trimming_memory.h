// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "endmill/offset/offset_mesh.h"

namespace endmill {

/// What a trim is made of.
struct TrimmingSize {
    std::size_t surfaces;  ///< each of them sampled; 0: a mesh
    int grid_lines;        ///< along each parameter; of a mesh, samples along each plane
    std::size_t planes;
    BoundaryContact boundary = BoundaryContact::Contact;
};

/// Memory in bytes that offset, sections and their files take at most together, good to a
/// factor of two: measured on one surface, with folds and without, over grids from 20 to
/// 9000 lines and 10 to 20 000 planes.
double trimming_bytes(const TrimmingSize& size);

/// Refuses, before the work, a trim that would not fit `memory_gib` if it took half of
/// `trimming_bytes`.
/// \throws LimitError that names grid, planes, need and limit.
void require_trimming_memory(const TrimmingSize& size, double memory_gib);

}  // namespace endmill
