// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/cutter/tool.h"
#include "endmill/files/read_file.h"
#include "endmill/machine/kinematics.h"
#include "endmill/post/control.h"
#include "endmill/process/milling_data.h"

/// \file
/// Machine files ("endmill-machine/1"): the content of a file as data, and the kinematic
/// model that follows from it.
///
/// Readers of the files that describe a cut: the tool ("endmill-tool/1"), tables of tools
/// and the material of the workpiece ("endmill-material/1").
///
/// Reader of the files that describe a control ("endmill-control/1").
///
/// Implemented in `machine_file.cpp`, `tool_file.cpp`, `tool_table.cpp`,
/// `material_file.cpp` and `control_file.cpp`.

namespace endmill {

/// Travel range of one machine axis. A position of a rotary axis is the right-hand
/// rotation of the body that the axis carries.
struct AxisTravel {
    char axis;    ///< 'x', 'y', 'z': linear; 'a', 'b', 'c': rotary about x, y, z
    double from;  ///< mm for a linear axis, rad for a rotary one
    double to;    ///< same unit as `from`; at least `from`

    /// Member by member.
    friend bool operator==(const AxisTravel&, const AxisTravel&) = default;
};

/// The sign of a rotary axis in programs: the word is the position times the sign.
struct WordSign {
    char axis;  ///< 'a', 'b' or 'c'
    int sign;   ///< 1 or -1

    /// Member by member.
    friend bool operator==(const WordSign&, const WordSign&) = default;
};

/// Largest speed of one machine axis.
struct AxisRate {
    char axis;       ///< 'x', 'y', 'z', 'a', 'b' or 'c'
    double per_min;  ///< mm/min for a linear axis, rad/min for a rotary one; above 0

    /// Member by member.
    friend bool operator==(const AxisRate&, const AxisRate&) = default;
};

/// A machine as its file describes it. A value that the file does not state is empty.
struct MachineDescription {
    std::string name;                          ///< from the file, or the file's stem
    std::string source = {};                   ///< origin of the numbers
    std::string configuration = "W/xyBz/T";    ///< axes from workpiece to tool, B the bed
    MachineLimits limits = {};                 ///< of spindle and feed drives
    std::vector<AxisTravel> travels = {};      ///< of the axes, in the order x y z a b c
    std::optional<double> pivot_mm = {};       ///< as `Machine::pivot`
    std::optional<Vec3> table_offset_mm = {};  ///< as `Machine::table_offset`
    std::optional<Vec3> axis_offset_mm = {};   ///< as `Machine::axis_offset`
    std::vector<WordSign> word_signs = {};     ///< of rotary axes, in the order a b c
    std::vector<AxisRate> rates = {};          ///< of the axes, in the order x y z a b c
};

/// Reads a file of format "endmill-machine/1". Every key is optional: `name`, `source`,
/// `configuration`, `limits` {`x_mm`, ..., `c_deg`: [min, max]}, `pivot_mm`,
/// `table_offset_mm`, `axis_offset_mm`, `word_sign` {`a`, `b`, `c`: 1 or -1}, `max_rate`
/// {`x_mm_per_min`, ..., `c_deg_per_min`}, `spindle` {`max_rpm`, `max_power_w`,
/// `max_torque_n_m`}, `max_feed_mm_per_min`, `acceleration_m_per_s2`.
/// \throws FormatError as `JsonDocument` and, with the JSON pointer, for an unknown key.
///         E_MACHINE for an invalid configuration; for limits of an axis that the
///         configuration lacks, limits that are not a rising pair, and rotary limits
///         that do not contain 0; for an axis offset unless two rotary axes are on one
///         side of the bed; for a sign or a rate of an axis that the configuration lacks;
///         for a value out of its range. E_FORMAT for another format. Also as `read_file`.
MachineDescription read_machine(const std::filesystem::path& path,
                                const ReadLimits& limits = {});

/// Parses the content of a machine file as `read_machine` does.
/// \param path used in messages and for the default name.
MachineDescription parse_machine(std::string_view content,
                                 const std::filesystem::path& path,
                                 const ReadLimits& limits = {});

/// The kinematic model of the machine. A missing pivot or offset is 0; an axis without
/// limits is unlimited, a missing sign is 1. The rotary limits are set for a valid five-axis
/// configuration only.
/// \throws DomainError if `description.configuration` is invalid.
Machine moving_machine(const MachineDescription& description);

/// Reads a file of format "endmill-tool/1". The key `cutter` is a cutter word as on the
/// command line. Optional keys: `name`, `source`, `flutes`, `helix_deg`, `length_mm`,
/// `limits` {`cutting_force_n`, `thrust_n`, `torque_n_m`}, and `shank` and `holder`,
/// lists of cylinders {`diameter_mm`, `from_mm`, `to_mm`} whose heights count from the
/// tip.
/// \throws FormatError as `JsonDocument` and, with the JSON pointer, for an unknown key
///         or a value out of its range; E_FORMAT for another format; also as `read_file`.
Tool read_tool(const std::filesystem::path& path, const ReadLimits& limits = {});

/// Parses the content of a tool file as `read_tool` does.
/// \param path used in messages and for the default name.
Tool parse_tool(std::string_view content, const std::filesystem::path& path,
                const ReadLimits& limits = {});

/// A row of a tool table.
struct NumberedTool {
    int number;  ///< as after the letter T in a program
    Tool tool;   ///< the cutter, and what is known of its shank and holder
};

/// Limits for reading a tool table, and what its file does not state.
struct ToolTableOptions {
    ReadLimits limits = {};  ///< of coordinates and memory
    /// mm, length of the unit of a table of LinuxCNC, which does not state it.
    std::optional<double> unit_mm = {};
};

/// Reads a tool table: a file of format "endmill-tools/1", or a table of LinuxCNC (.tbl).
///
/// "endmill-tools/1" has the required key `tools`, a list of {`number`, `tool`}, and the
/// optional keys `name` and `source`. `tool` is a cutter word, or an object with the keys
/// of a tool file, whose key `format` may be missing.
///
/// A table of LinuxCNC has a row for each tool: words such as T1 P1 D6 Z40, then a
/// comment after a semicolon. A comment that begins with a cutter word names the cutter;
/// one that begins with the word ball names a ball of diameter D. Every other row with a
/// diameter D is a flat end mill. Rows without a diameter are left out.
/// \return the tools, ascending by number.
/// \throws FormatError as `read_tool` for "endmill-tools/1"; E_TOOLS for a number that
///         occurs twice, a table without a tool, and in a table of LinuxCNC, with the
///         line, for an unknown or wrong word or a comment that contradicts D.
/// \throws DomainError if a diameter D has no unit.
std::vector<NumberedTool> read_tool_table(const std::filesystem::path& path,
                                          const ToolTableOptions& options = {});

/// Parses the content of a tool table as `read_tool_table` does.
/// \param path used in messages.
std::vector<NumberedTool> parse_tool_table(std::string_view content,
                                           const std::filesystem::path& path,
                                           const ToolTableOptions& options = {});

/// Reads a file of format "endmill-material/1". Required keys:
/// `specific_resistance_n_per_mm2`, `edge_thickness_mm`, `r1` to `r4`, `alpha`,
/// `v1_m_per_min`. Optional keys: `name` (default: the file's stem), `source`,
/// `max_feed_per_tooth_mm`, `min_feed_per_tooth_mm`.
/// \throws FormatError as `JsonDocument` and, with the JSON pointer, for an unknown or
///         missing key; E_MATERIAL for a value out of its range and for a largest feed
///         per tooth below the least; E_FORMAT for another format; also as `read_file`.
CuttingMaterial read_material(const std::filesystem::path& path,
                              const ReadLimits& limits = {});

/// Parses the content of a material file as `read_material` does.
/// \param path used in messages and for the default name.
CuttingMaterial parse_material(std::string_view content,
                               const std::filesystem::path& path,
                               const ReadLimits& limits = {});

/// Reads a file of format "endmill-control/1". Required keys: `extension`, `start` and
/// `end`. Optional keys, named as the members of `Control`: `name` (default: the file's
/// stem), `source`, `percent` (true), `program_number`, `comments` ("parentheses"),
/// `capital_comments` (false), `path_control` ("none"), `tool_change`, `tool_length`,
/// `dwell` ("s" or "ms"), `flood`, `mist`, `coolant_off` ("M9"), `arcs` ("none"),
/// `decimals_mm` (4), `decimals_inch` (5), `speed_decimals`, `always_point` (false),
/// `line_end` ("lf"), `longest_line`, `largest_line_number` (99999). A missing word means
/// that the control has none.
/// \throws FormatError as `JsonDocument` and, with the JSON pointer, for an unknown or
///         missing key; E_CONTROL for text that is not made of words such as G90, and for
///         a start block that does more than set modes; E_FORMAT for another format; also
///         as `read_file`.
Control read_control(const std::filesystem::path& path, const ReadLimits& limits = {});

/// Parses the content of a control file as `read_control` does.
/// \param path used in messages and for the default name.
Control parse_control(std::string_view content, const std::filesystem::path& path,
                      const ReadLimits& limits = {});

}  // namespace endmill
