// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/files/read_file.h"

/// \file
/// Lists of facets, and the tool axes of the setups that `endmill setup` finds.

namespace endmill {

/// Reads a list of facets: one number on a line, from 0. A # begins a comment; empty lines
/// are skipped.
/// \param path   of the list.
/// \param facets number of facets of the mesh.
/// \return the numbers, ascending.
/// \throws FormatError, LimitError as `read_file`; FormatError E_FACET with the line of a
///         word that is no number below `facets`, or that repeats one; FormatError E_EMPTY
///         for a list without a number.
std::vector<std::size_t> read_facet_list(const std::filesystem::path& path,
                                         std::size_t facets,
                                         const ReadLimits& limits = {});

/// The directions along which the setups of a summary cut with all rotary axes at zero.
struct SetupDirections {
    std::string machine;     ///< word of the machine; empty if the summary names none
    std::vector<Vec3> axes;  ///< unit, from the part to the spindle; at least one
};

/// Reads the keys `setups` and `configuration` of a summary.json of `setup`. Without a list
/// of setups the key `tool_axis` counts as the only setup.
/// \throws FormatError, LimitError as `read_file` and `JsonDocument`; FormatError E_JSON
///         if there is no setup, or if an axis is off a unit vector by more than 1e-3.
SetupDirections read_setup_directions(const std::filesystem::path& path,
                                      const ReadLimits& limits = {});

/// The part for which `setup` wrote a summary.
struct SetupSubject {
    std::string name;                        ///< empty if the summary names none
    std::optional<std::size_t> facets = {};  ///< of its mesh, those without area included
};

/// Reads the keys `name` and `facets` of a summary.json of `setup`.
/// \throws FormatError, LimitError as `read_file` and `JsonDocument`.
SetupSubject read_setup_subject(const std::filesystem::path& path,
                                const ReadLimits& limits = {});

}  // namespace endmill
