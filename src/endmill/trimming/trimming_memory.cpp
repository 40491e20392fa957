// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/trimming_memory.h"

#include <cmath>
#include <string>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

constexpr double bytes_per_gib = 0x1p30;
// Of an offset's vertex: the sheet, the mesh and its links; twice that while strips are laid.
constexpr double bytes_a_vertex = 95;
constexpr double bytes_a_vertex_with_strips = 190;
// Of a section's point: itself, what is left of it, the path, and the text of the files.
constexpr double bytes_a_section_point = 230;
// Sections cross each line of a grid once, and what they fold again; strips add arcs that are
// sampled to 1.25e-4 mm.
constexpr double points_a_grid_line = 2;
constexpr double points_of_strips = 950;

}  // namespace

double trimming_bytes(const TrimmingSize& size)
{
    const bool has_strips = size.boundary == BoundaryContact::Contact;
    const double lines = size.grid_lines;
    const auto surfaces = static_cast<double>(size.surfaces);
    const double vertices = surfaces * lines * lines *
                            (has_strips ? bytes_a_vertex_with_strips : bytes_a_vertex);
    const double a_plane =
        points_a_grid_line * lines + (surfaces > 0 && has_strips ? points_of_strips : 0);
    return vertices + static_cast<double>(size.planes) * a_plane * bytes_a_section_point;
}

void require_trimming_memory(const TrimmingSize& size, double memory_gib)
{
    const double bytes = trimming_bytes(size);
    if (bytes / 2 <= memory_gib * bytes_per_gib)
        return;
    throw LimitError{
        std::to_string(size.planes) + " planes over a grid of " +
        std::to_string(size.grid_lines) + " lines would need about " +
        to_text(std::ceil(bytes / bytes_per_gib * 10) / 10) + " GiB; expected at most " +
        to_text(memory_gib) +
        " GiB (--max-memory), with fewer planes (--planes) or a coarser --grid"};
}

}  // namespace endmill
