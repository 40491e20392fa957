// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/post_options.h"
#include "endmill/files/machining_data.h"
#include "endmill/files/path_file.h"
#include "endmill/post/machine_path.h"
#include "endmill/post/program.h"

namespace endmill {

/// What moving a path onto a machine with rotary axes did.
struct PostedMotion {
    MachineMotion machine;               ///< without positions
    std::size_t rows;                    ///< points of the path
    double tolerance_mm;                 ///< of the motion
    MachinePathReport report;            ///< of the motions
    TipBox xyz_range;                    ///< mm, of the program
    std::array<MinMax, 2> rotary_range;  ///< rad, of R1 and R2
    double rounding_tip_mm;              ///< mm, by the decimals of the program
};

/// A path, its known properties, and the written program.
struct PostedPath {
    std::string name;
    PathSummary known;  ///< completed by the options
    const Program& read;
    WrittenProgram written;
    std::string file;                 ///< its name in the output folder
    std::optional<Control> control;   ///< of G-code; nothing for APT CL data
    std::vector<NumberedTool> tools;  ///< of the table of --tools that the path uses
    std::optional<PostedMotion> motion = {};  ///< of a program with rotary axes
};

/// summary.json of `post`. It has the keys of the path's own summary, so that `verify`
/// judges the program by the limits for which the path was planned.
Json post_summary(const PostedPath& posted, const PostOptions& options);

/// The report on the terminal: at most four lines.
/// \param summary of `posted`.
std::string post_text(const Json& summary, const PostedPath& posted,
                      const PostOptions& options);

}  // namespace endmill
