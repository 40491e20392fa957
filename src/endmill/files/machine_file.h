// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/files/read_file.h"
#include "endmill/machine/kinematics.h"
#include "endmill/process/milling_data.h"

namespace endmill {

/// How far an axis of a machine goes: of a rotary axis its own positions, the right-hand turns of
/// what it carries.
struct AxisTravel {
    char axis;    ///< 'x', 'y', 'z', linear; 'a', 'b', 'c', rotary about them
    double from;  ///< mm, or rad
    double to;    ///< mm, or rad; at least `from`

    /// Whether both say the same.
    friend bool operator==(const AxisTravel&, const AxisTravel&) = default;
};

/// A machine as its file describes it. What the file does not say is none.
struct MachineDescription {
    std::string name;
    std::string source = {};
    std::string configuration = "W/xyBz/T";  ///< axes from workpiece to tool, B the bed
    MachineLimits limits = {};               ///< of spindle and feed drives
    std::vector<AxisTravel> travels = {};    ///< of the axes, in the order x y z a b c
    std::optional<double> pivot_mm = {};
    std::optional<Vec3> table_offset_mm = {};
};

/// The machine in a file of format "endmill-machine/1": as far as it says so `name` (else the
/// file's), `source`, `configuration`, `limits` {`x_mm`, ..., `c_deg`: [min, max]},
/// `pivot_mm`, `table_offset_mm`, `spindle` {`max_rpm`, `max_power_w`, `max_torque_n_m`},
/// `max_feed_mm_per_min`, `acceleration_m_per_s2`.
/// \throws FormatError as `JsonDocument`, with the JSON pointer, for a key that is unknown;
///         E_MACHINE for a word that is no configuration, limits of an axis that the
///         configuration does not have, of which there are not two, in falling order, or
///         that `expected_rotary_range` objects to, and a value out of its range; E_FORMAT for another format; and as `read_file`.
MachineDescription read_machine(const std::filesystem::path& path,
                                const ReadLimits& limits = {});

/// The same from what the file holds; `path` is named in messages.
MachineDescription parse_machine(std::string_view content,
                                 const std::filesystem::path& path,
                                 const ReadLimits& limits = {});

/// The same as far as it moves: without a pivot or a table offset these are 0, axes without
/// limits are not limited. The rotary limits are of use for a valid configuration only.
/// \throws DomainError unless the configuration is one.
Machine moving_machine(const MachineDescription& description);

}  // namespace endmill
