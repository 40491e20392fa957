// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace endmill {

/// A work of the bibliography as "authors: title". \param key in paper/references.bib.
std::string cited_work(std::string_view key);

}  // namespace endmill
