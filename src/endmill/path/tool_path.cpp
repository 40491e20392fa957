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

}  // namespace endmill
