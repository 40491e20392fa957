// SPDX-License-Identifier: GPL-3.0-or-later
// A rank other than 0 sends the checksum of its part, then its columns.

#include "cli/setup_visibility.h"

#include <string>
#include <vector>

#include "cli/column_messages.h"
#include "cli/program_ranks.h"
#include "cli/progress.h"
#include "endmill/core/error.h"
#include "endmill/files/visibility_file.h"

namespace endmill {
namespace {

DirectionShare share_of(int rank)
{
    return {static_cast<std::size_t>(rank),
            static_cast<std::size_t>(program_ranks().count())};
}

std::string checksum_word(const SetupInput& input)
{
    return std::to_string(part_checksum(input.mesh));
}

// The share of the visibility along `directions`, with the tool kept clear of the part.
PartVisibility visibility_share(const SetupInput& input, std::span<const Vec3> directions,
                                const DirectionShare& share,
                                const SetupCommandOptions& options)
{
    ProgressLine progress{"casting rays", options.common};
    const auto show = [&](std::size_t done, std::size_t count) {
        progress.show(static_cast<double>(done) / static_cast<double>(count));
        check_ranks();
    };
    VisibilityOptions visibility;
    visibility.incidence = Angle::degrees(options.incidence_deg);
    visibility.kind = options.visibility;
    visibility.share = share;
    visibility.progress = [&](std::size_t done) {
        show(done, share.count(directions.size()));
    };
    PartVisibility found = part_visibility(input.mesh, directions, visibility);
    if (!body_text(input.tool).empty()) {
        progress.begin("clearing shank and holder");
        keep_reachable(found, input.mesh, directions, tool_body(*input.tool),
                       [&](std::size_t done) { show(done, directions.size()); });
    }
    return found;
}

// Takes the columns of another rank into the map.
void receive_visibility(int rank, const std::string& checksum, VisibilityMap& map)
{
    if (program_ranks().receive_from(rank).content != checksum)
        throw DomainError{"rank " + std::to_string(rank) +
                          " read another part; expected the same files on all machines"};
    receive_columns(rank, map, share_of(rank));
}

}  // namespace

PartVisibility divided_visibility(const SetupInput& input,
                                  const SetupCommandOptions& options)
{
    PartVisibility found =
        visibility_share(input, input.grid.centres, share_of(0), options);
    if (program_ranks().count() == 1)
        return found;
    ProgressLine progress{"gathering the visibility of all ranks", options.common};
    const std::string checksum = checksum_word(input);
    for (int rank = 1; rank < program_ranks().count(); ++rank) {
        receive_visibility(rank, checksum, found.map);
        progress.show(static_cast<double>(rank) / program_ranks().count());
    }
    return found;
}

void send_visibility(const SetupCommandOptions& options)
{
    if (options.part.path.empty() || !options.from_visibility.empty())
        return;
    Ranks& ranks = program_ranks();
    const SetupInput input = read_setup_input(options);
    const DirectionShare share = share_of(ranks.rank());
    std::vector<Vec3> directions(share.count(input.grid.centres.size()));
    for (std::size_t k = 0; k < directions.size(); ++k)
        directions[k] = input.grid.centres[share.direction(k)];
    const VisibilityMap map = visibility_share(input, directions, {}, options).map;
    ranks.send(0, checksum_word(input));
    send_columns(0, map);
}

}  // namespace endmill
