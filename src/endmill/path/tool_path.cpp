// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/path/tool_path.h"

namespace endmill {

std::string_view move_name(Move move)
{
    switch (move) {
        case Move::Cut:
            return "cut";
        case Move::Link:
            return "link";
        case Move::Rapid:
            return "rapid";
        case Move::Plunge:
            return "plunge";
        case Move::Retract:
            return "retract";
    }
    return {};
}

std::optional<Move> move_from_name(std::string_view name)
{
    for (const Move move :
         {Move::Cut, Move::Link, Move::Rapid, Move::Plunge, Move::Retract})
        if (move_name(move) == name)
            return move;
    return std::nullopt;
}

PathLengths path_lengths(const ToolPath& path)
{
    PathLengths lengths;
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        const PathPoint& point = path.points[k];
        const bool is_at_feed = point.move == Move::Cut || point.move == Move::Link;
        (is_at_feed ? lengths.at_feed_mm : lengths.lifted_mm) +=
            (point.location.tip - path.points[k - 1].location.tip).norm();
    }
    return lengths;
}

std::optional<double> entry_height(const ToolPath& path)
{
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        const PathPoint& point = path.points[k];
        if (point.move == Move::Rapid || point.move == Move::Retract)
            continue;
        const double from = path.points[k - 1].location.tip.z();
        return from > point.location.tip.z() ? std::optional{from} : std::nullopt;
    }
    return std::nullopt;
}

}  // namespace endmill
