// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/column_messages.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "cli/program_ranks.h"

namespace endmill {
namespace {

// Of a message. The receiver needs this memory besides the map.
constexpr std::size_t message_bytes = std::size_t{1} << 26;

std::size_t column_bytes(const VisibilityMap& map)
{
    return map.words() * sizeof(std::uint64_t);
}

}  // namespace

void send_columns(int to, const VisibilityMap& map)
{
    const std::size_t at_once =
        std::max<std::size_t>(1, message_bytes / column_bytes(map));
    for (std::size_t k = 0; k < map.cells(); k += at_once) {
        const std::size_t count = std::min(at_once, map.cells() - k);
        program_ranks().send(to, {reinterpret_cast<const char*>(map.column(k).data()),
                                  count * column_bytes(map)});
    }
}

void receive_columns(int from, VisibilityMap& map, const DirectionShare& share)
{
    const std::size_t bytes = column_bytes(map);
    const std::size_t count = share.count(map.cells());
    for (std::size_t k = 0; k < count;) {
        const std::string columns = program_ranks().receive_from(from).content;
        for (std::size_t at = 0; at < columns.size(); at += bytes, ++k)
            std::memcpy(map.column(share.direction(k)).data(), columns.data() + at,
                        bytes);
    }
}

}  // namespace endmill
