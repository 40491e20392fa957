// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/view_sphere.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/visibility_file.h"
#include "endmill/machine/feasible_directions.h"
#include "endmill/visibility/sphere_grid.h"

namespace endmill {
namespace {

// Visibility of more bits than this makes a page that is too large to open.
constexpr double most_visibility_bits = 4e8;
constexpr std::size_t bits_per_word = 32;  // JavaScript shifts words of 32 bits

void require_few_bits(const VisibilityMap& map, const std::string& file)
{
    if (static_cast<double>(map.facets()) * static_cast<double>(map.cells()) >
        most_visibility_bits)
        throw LimitError{file + ": " + counted(map.facets(), "facet") + " by " +
                         counted(map.cells(), "direction") +
                         " are more than a page can hold; expected a coarser grid"};
}

std::vector<std::uint32_t> columns_of(const VisibilityMap& map, std::size_t words)
{
    std::vector<std::uint32_t> columns;
    columns.reserve(words * map.cells());
    for (std::size_t cell = 0; cell < map.cells(); ++cell)
        for (std::size_t word = 0; word < words; ++word)
            columns.push_back(static_cast<std::uint32_t>(map.column(cell)[word / 2] >>
                                                         (bits_per_word * (word % 2))));
    return columns;
}

// The directions that the machine of a setup can take, in the frame of the part. Nothing for the
// summary of another command, or of a machine without tilts.
std::optional<FeasibleDirections> machine_directions(const Json& found)
{
    try {
        const auto vector = [&](const char* key) {
            return Vec3{found.at(key).at(0).get<double>(),
                        found.at(key).at(1).get<double>(),
                        found.at(key).at(2).get<double>()};
        };
        const auto range = [&](const char* key) {
            return RotaryRange{
                Angle::degrees(found.at(key).at(0).get<double>()).radians(),
                Angle::degrees(found.at(key).at(1).get<double>()).radians()};
        };
        const std::string type = found.at("type").get<std::string>();
        if (type != "CA" && type != "AB")
            return std::nullopt;
        return FeasibleDirections{
            {type == "CA" ? RotaryFamily::CA : RotaryFamily::AB, vector("tool_axis"),
             vector("r1_axis"), vector("r2_axis")},
            {range("limits_phi_deg"), range("limits_theta_deg")}};
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

}  // namespace

Json sphere_view(const ViewInput& input, const TriangleMesh* mesh,
                 const ReadLimits& limits, ViewFrame& frame)
{
    const StoredVisibility stored = parse_visibility(
        read_file(input.visibility, limits), shown_path(input.visibility), limits);
    const VisibilityMap& map = stored.visibility.map;
    if (!mesh || mesh->triangles().size() != map.facets())
        throw DomainError{
            input.visibility + ": a map of " + counted(map.facets(), "facet") + ", and " +
            (mesh ? "a part of " + counted(mesh->triangles().size(), "facet")
                  : std::string{"no part"}) +
            "; expected --part with the part of the setup"};
    require_few_bits(map, input.visibility);
    const SphereGrid grid = sphere_grid(stored.grid);
    const std::size_t words = (map.facets() + bits_per_word - 1) / bits_per_word;
    Json sphere{
        {"part", mesh_json(frame, *mesh, frame.origin)},
        {"cells", mesh_json(frame, TriangleMesh{grid.corners, grid.cells}, Vec3::Zero())},
        {"words_per_cell", words},
        {"bits", array_json(frame.numbers.add(columns_of(map, words)))},
        {"reachable", nullptr}};
    const ViewSummary* const beside = summary_beside(input, input.visibility);
    if (const auto directions =
            beside ? machine_directions(beside->content) : std::nullopt) {
        std::vector<std::uint8_t> reachable;
        for (const Vec3& centre : grid.centres)
            reachable.push_back(directions->contains(centre) ? 1 : 0);
        sphere["reachable"] = array_json(frame.numbers.add(reachable));
    }
    return sphere;
}

}  // namespace endmill
