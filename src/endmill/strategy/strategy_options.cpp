// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/strategy_options.h"

namespace endmill {

std::string_view strategy_name(Strategy strategy)
{
    switch (strategy) {
        case Strategy::IsoU:
            return "iso-u";
        case Strategy::IsoV:
            return "iso-v";
        case Strategy::Planar:
            return "planar";
        case Strategy::IsoScallop:
            return "iso-scallop";
        case Strategy::Field:
            return "field";
    }
    return "";
}

}  // namespace endmill
