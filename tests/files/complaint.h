// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/core/error.h"

namespace endmill {

/// "CODE message" of the FormatError or LimitError that `read` throws; "accepted" if it
/// throws nothing.
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

/// `text` with its first `from` replaced by `to`; empty if it has none.
inline std::string replaced(std::string text, const std::string& from,
                            const std::string& to)
{
    const auto at = text.find(from);
    return at == std::string::npos ? "" : text.replace(at, from.size(), to);
}

}  // namespace endmill
