// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/command.h"
#include "endmill/files/part_file.h"
#include "endmill/files/surface_file.h"
#include "endmill/surface/continuity.h"
#include "endmill/surface/largest_cutter.h"

namespace endmill {

/// The options that name a part and its unit and orientation.
struct PartOptions {
    std::string path;
    LengthUnit units = LengthUnit::Mm;
    UpAxis up = UpAxis::Z;
    bool keeps_import = true;  ///< whether an imported CAD file is kept beside the output
};

/// Adds the options --units and --up of meshes.
void add_mesh_options(CLI::App& command, PartOptions& part);

/// Adds the part to the summary of a path in `folder`. The part's file name is relative
/// to `folder`, so that both may be moved together.
/// \param key of the file name, with which the keys of unit and orientation begin.
void name_part(Json& summary, const PartOptions& part,
               const std::filesystem::path& folder, const std::string& key = "part");

/// Adds a protected part in the same way: protected and protected_sha256.
/// \throws FormatError as read_file.
void name_protected_part(Json& summary, const PartOptions& part,
                         const std::filesystem::path& folder, const ReadLimits& limits);

/// Two parts that are read with one --units and one --up: `part`, and the protected part in
/// `file`. The two options apply to meshes; a surface file beside a mesh keeps its own unit.
struct PartPair {
    PartOptions part;
    PartOptions guard;
};
PartPair part_pair(const PartOptions& part, const std::string& file);

/// Adds the argument SURFACE, for a command that does not accept a mesh.
void add_surface_argument(CLI::App& command, std::string& path);

/// Reads a part: a surface, mesh or CAD file.
/// \throws FormatError, LimitError, DomainError as `read_part` and `import_cad_with_cache`;
///         DomainError for --units with a CAD file, which states its own unit.
PartFile part_file(const PartOptions& part, const CommonOptions& options);

/// Reads the part of a command. Its notes become warnings.
/// \throws as part_file.
PartFile read_part_for(const PartOptions& part, const CommonOptions& options);

/// Reads the part of a command that accepts surfaces only.
/// \throws DomainError if the part is a mesh.
SurfaceFile read_surface_for(const std::string& path, const std::string& command,
                             const CommonOptions& options);

/// The folder for the results: --output, or ./NAME-COMMAND after the name of the input.
/// A file called toolpath takes the name of its folder, and also of the folder above if
/// its folder is u or v. For example, the results for results/u/toolpath.csv are in
/// ./results-u-verify.
std::string output_folder(const std::string& input, const std::string& command,
                          const CommonOptions& options);

/// A place with the keys u, v and point_mm, and with patch if it is given.
Json place_json(const SurfacePoint& at, const Vec3& point,
                std::optional<std::size_t> patch = std::nullopt);

/// `point` as an array.
Json vector_json(const Vec3& point);

/// Adds `continuity`, `worst_break_deg` and `worst_break_at` to a summary; null if no
/// border has a break.
/// \param several whether the part has several surfaces; a place then names its patch.
void add_continuity(Json& summary, const SurfaceContinuity& continuity, bool several);

/// Adds `max_cutter_radius_mm` and `max_cutter_radius_at`, null without a limit.
/// \param several whether the part has several surfaces; a place then names its patch.
void add_cutter_limit(Json& summary, const std::optional<CutterLimit>& limit,
                      bool several);

/// A sentence on the worst border between patches.
std::string break_text(const SurfaceContinuity& continuity);

/// Reports that --require g1 is not met by the surface of `file`.
ExitCode refuse_break(const std::string& file, const SurfaceContinuity& continuity,
                      const CommonOptions& options);

/// What a command requires of the borders between patches.
enum class RequiredContinuity {
    None,  ///< nothing; a break is a warning
    G1,    ///< all patches meet with a common tangent plane
};

/// Adds the option --require, whose only word is g1.
void add_require_option(CLI::App& command, RequiredContinuity& required);

/// Adds the option --axis. `axis` becomes a unit vector; the default is +z.
void add_axis_option(CLI::App& command, Vec3& axis);

}  // namespace endmill
