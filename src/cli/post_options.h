// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "cli/path_options.h"

namespace endmill {

/// The language of the written program.
enum class PostFormat { Gcode, Apt };

/// The word of a format on the command line, and the extension of its files.
struct PostFormatNames {
    std::string word;
    std::string extension;
};
/// The word and extension of `format`.
PostFormatNames names_of(PostFormat format);

/// The options of `endmill post`. An empty option is taken from the path or its summary.
struct PostOptions {
    CommonOptions common;
    PathOptions path;
    PostFormat format = PostFormat::Gcode;
    std::optional<double> feed_mm_per_min;
    std::optional<double> spindle_rpm;
    std::optional<double> safe_height;  ///< mm
    std::optional<int> tool;
    int decimals = 4;
    bool line_numbers = false;
    bool comments = true;
};

/// Adds every option of `post` to `command`.
void add_post_options(CLI::App& command, PostOptions& options);

}  // namespace endmill
