// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/facet_list.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>
#include <variant>

#include "cli/surface_facts.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/setup_file.h"

namespace endmill {

void add_skip_facets_option(CLI::App& command, std::string& list, const std::string& help)
{
    command
        .add_option("--skip-facets", list,
                    "text file with facet numbers of a mesh, one on a line, from 0, # "
                    "begins a comment: " +
                        help)
        ->type_name("FILE");
}

TriangleMesh mesh_with_file_numbers(const PartFile& part)
{
    const auto& mesh = std::get<TriangleMesh>(part.part);
    const std::vector<std::size_t>& degenerate = part.degenerate_triangles;
    std::vector<Triangle> triangles;
    const std::size_t count = mesh.triangles().size() + degenerate.size();
    triangles.reserve(count);
    std::size_t next = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const bool is_degenerate = next < degenerate.size() && degenerate[next] == i;
        triangles.push_back(is_degenerate ? Triangle{0, 0, 0}
                                          : mesh.triangles()[i - next]);
        next += is_degenerate ? 1 : 0;
    }
    return {{mesh.points().begin(), mesh.points().end()}, std::move(triangles)};
}

std::vector<std::size_t> skipped_facets(const std::string& list, const PartFile& part,
                                        const CommonOptions& options)
{
    if (list.empty())
        return {};
    const auto* mesh = std::get_if<TriangleMesh>(&part.part);
    if (!mesh)
        throw DomainError{
            "--skip-facets " + printable(list) +
            ": the part is a surface, which has no facets; expected a mesh"};
    return read_facet_list(list,
                           mesh->triangles().size() + part.degenerate_triangles.size(),
                           options.limits);
}

std::vector<std::size_t> facets_of_other_faces(std::span<const int> chosen,
                                               const PartFile& part,
                                               const std::string& file)
{
    const std::vector<std::int32_t>& numbers = part.face_numbers;
    if (numbers.empty())
        throw DomainError{"--face: " + printable(file) +
                          " has no face numbers; expected a STEP or IGES file of several "
                          "faces, or the mesh.ply that endmill import made of one"};
    for (const int number : chosen)
        if (std::ranges::find(numbers, number) == numbers.end())
            throw DomainError{"--face " + std::to_string(number) + ": " +
                              printable(file) +
                              " has no triangles of this face; its highest face is " +
                              std::to_string(*std::ranges::max_element(numbers))};
    std::vector<std::size_t> others;
    std::size_t left_out = 0;  // degenerate facets so far
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        while (left_out < part.degenerate_triangles.size() &&
               part.degenerate_triangles[left_out] == k + left_out)
            ++left_out;
        if (!std::ranges::binary_search(chosen, numbers[k]))
            others.push_back(k + left_out);
    }
    return others;
}

std::vector<std::size_t> facets_in_mesh(std::span<const std::size_t> facets,
                                        const PartFile& part)
{
    const std::vector<std::size_t>& degenerate = part.degenerate_triangles;
    std::vector<std::size_t> found;
    found.reserve(facets.size());
    for (const std::size_t facet : facets) {
        const auto before = std::ranges::lower_bound(degenerate, facet);
        if (before == degenerate.end() || *before != facet)
            found.push_back(facet - static_cast<std::size_t>(
                                        std::distance(degenerate.begin(), before)));
    }
    return found;
}

TriangleMesh without_facets(const TriangleMesh& mesh, std::span<const std::size_t> facets)
{
    std::vector<Triangle> kept;
    kept.reserve(mesh.triangles().size());
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k)
        if (!std::binary_search(facets.begin(), facets.end(), k))
            kept.push_back(mesh.triangles()[k]);
    return {{mesh.points().begin(), mesh.points().end()}, std::move(kept)};
}

}  // namespace endmill
