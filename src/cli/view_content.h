// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/progress.h"
#include "cli/view_input.h"
#include "endmill/page/page.h"

namespace endmill {

/// What a page shows: an object for the script of the page, and its arrays.
struct ViewContent {
    Json head;
    PageNumbers numbers;
};

/// Reads the files of a page, and reduces what is too large to be drawn smoothly. What was left
/// out stands in the notes of the content.
/// \throws FormatError, LimitError, DomainError as the readers of the files.
ViewContent view_content(const ViewInput& input, const ViewOptions& options,
                         ProgressLine& progress);

}  // namespace endmill
