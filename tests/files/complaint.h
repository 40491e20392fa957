// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/core/error.h"

namespace endmill {

/// "CODE message" of the complaint about a file, or that a limit is reached, which `read`
/// throws; "accepted" if it throws nothing.
template <class Read>
std::string complaint_of(const Read& read)
{
    try {
        read();
        return "accepted";
    } catch (const FormatError& error) {
        return error.code() + ' ' + error.what();
    } catch (const LimitError& error) {
        return error.code() + ' ' + error.what();
    }
}

/// `text` with the first `from` in it replaced by `to`; empty if there is none.
inline std::string replaced(std::string text, const std::string& from,
                            const std::string& to)
{
    const auto at = text.find(from);
    return at == std::string::npos ? "" : text.replace(at, from.size(), to);
}

}  // namespace endmill
