// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "cli/command.h"
#include "endmill/files/part_file.h"

namespace endmill {

/// Adds the option --skip-facets. \param help what the command does with these facets.
void add_skip_facets_option(CLI::App& command, std::string& list,
                            const std::string& help);

/// The mesh of a part with the degenerate triangles that its reader left out, so that facets
/// have the numbers of the file. Such triangles have three equal corners.
/// \pre the part is a mesh.
TriangleMesh mesh_with_file_numbers(const PartFile& part);

/// The facets of --skip-facets, by their numbers in the file of the part; ascending.
/// \param list file name; empty: none.
/// \throws DomainError if the part is a surface; FormatError, LimitError as read_facet_list.
std::vector<std::size_t> skipped_facets(const std::string& list, const PartFile& part,
                                        const CommonOptions& options);

/// The facets of faces other than the chosen ones, by their numbers in the file of the part;
/// ascending.
/// \param chosen numbers of faces, from 1. \param file name of the part for messages.
/// \throws DomainError if the part has no face numbers or no face of a chosen number.
std::vector<std::size_t> facets_of_other_faces(std::span<const int> chosen,
                                               const PartFile& part,
                                               const std::string& file);

/// The numbers that these facets of the file have in the mesh of the part; degenerate ones
/// are left out.
std::vector<std::size_t> facets_in_mesh(std::span<const std::size_t> facets,
                                        const PartFile& part);

/// A mesh without some of its triangles. \param facets ascending.
TriangleMesh without_facets(const TriangleMesh& mesh,
                            std::span<const std::size_t> facets);

}  // namespace endmill
