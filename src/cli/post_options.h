// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <string>

#include "cli/path_options.h"
#include "endmill/post/control.h"
#include "endmill/post/machine_path.h"
#include "endmill/post/program.h"

namespace endmill {

/// The language of the written program.
enum class PostFormat { Gcode, Apt };

/// How the tool first descends to a pass.
enum class LeadIn { Straight, Ramp };

/// Options of `post --machine`.
struct MachinePostOptions {
    std::string tool_file;            ///< endmill-tool/1: cutter and length; may be empty
    std::optional<double> tolerance;  ///< mm; default: half of the path's, or 0.005
    int angle_decimals = 5;           ///< of rotary words
    std::optional<double> retract;    ///< mm; none: no retracts
    std::optional<double> rapid_feed;  ///< mm/min, of rapids that turn an axis
    std::optional<double> blend;       ///< mm, rounding of corners; none: exact path
    SingularRule singular = SingularRule::Exact;
    double singular_cone_deg = 0.1;
};

/// The options of `endmill post`. An empty option is taken from the path or its summary.
struct PostOptions {
    CommonOptions common;
    PathOptions path;
    PostFormat format = PostFormat::Gcode;
    std::string control = "linuxcnc";  ///< name or file
    std::optional<double> feed_mm_per_min;
    std::optional<double> plunge_feed_mm_per_min;
    std::optional<double> spindle_rpm;
    std::optional<double> safe_height;  ///< mm
    std::optional<int> tool;
    std::optional<int> decimals;
    std::optional<double> dwell_s;  ///< default: 2 s if the control has a dwell
    Coolant coolant = Coolant::Off;
    LeadIn lead_in = LeadIn::Straight;
    double ramp_angle_deg = 3;
    /// mm, height above the end of a descent down to which it is a rapid; none: not at all.
    std::optional<double> approach_distance;
    ProgramUnit unit = ProgramUnit::Mm;
    bool arcs = false;
    std::optional<double>
        arc_fit_tolerance_mm;  ///< default: the path's tolerance + 0.001
    bool multax = false;
    bool line_numbers = false;
    bool comments = true;
    MachinePostOptions machine = {};  ///< of programs with rotary axes
};

/// Adds every option of `post` to `command`.
void add_post_options(CLI::App& command, PostOptions& options);

/// The word of a format on the command line.
std::string word_of(PostFormat format);

/// The word of a rule for singular directions on the command line.
std::string word_of(SingularRule rule);

/// The word of a coolant on the command line.
std::string word_of(Coolant coolant);

/// Refuses options that need what the control does not have.
/// \throws DomainError naming the option and the control.
void require_possible(const PostOptions& options, const Control& control);

/// The control that `--control` names: a built-in one, or that of a file.
/// \throws DomainError if there is neither a control of this name nor such a file; as
///         `read_control`.
Control chosen_control(const PostOptions& options);

/// The extensions of the programs of all built-in controls, and of APT CL data.
std::set<std::string> program_extensions();

/// Refuses options of one format that were given for the other, and options without
/// effect.
/// \throws DomainError naming the option.
void refuse_idle_post_options(const PostOptions& options);

}  // namespace endmill
