// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "cli/view_input.h"

namespace endmill {

/// Refuses a page where the build left out its script.
/// \throws DomainError
void require_page();

/// Writes the page of `options` to a file.
/// \return its summary.
/// \throws DomainError if the page was left out of the build; as find_view_input,
///         view_content and OutputFolder.
Json write_view(const ViewOptions& options, const std::filesystem::path& page);

/// Writes page.html into a folder of results that was published, if --html asks for it.
/// \throws as write_view.
void write_html(const std::filesystem::path& folder, const CommonOptions& options);

}  // namespace endmill
