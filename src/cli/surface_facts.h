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
};

/// The argument PART and the options --units and --up, which are for meshes.
void add_part_options(CLI::App& command, PartOptions& part);

/// Those two options alone.
void add_mesh_options(CLI::App& command, PartOptions& part);

/// Writes into the summary of a path in `folder` which part it is for, as seen from there,
/// so that both may move together.
void name_part(Json& summary, const PartOptions& part,
               const std::filesystem::path& folder);

/// The argument SURFACE, for a command that a mesh cannot serve.
void add_surface_argument(CLI::App& command, std::string& path);

/// Reads the part of a command. Its notes become warnings.
/// \throws FormatError, LimitError, DomainError as read_part.
PartFile read_part_for(const PartOptions& part, const CommonOptions& options);

/// The same where only surfaces serve.
/// \throws DomainError if the part is a mesh.
SurfaceFile read_surface_for(const std::string& path, const std::string& command,
                             const CommonOptions& options);

/// The folder for the results: --output, or ./NAME-COMMAND after the input's name. That of
/// a file called toolpath is its folder's, with the one above if that is u or v:
/// results/u/toolpath.csv is verified into ./results-u-verify.
std::string output_folder(const std::string& input, const std::string& command,
                          const CommonOptions& options);

/// {"u", "v", "point_mm"}, and "patch" if that is given.
Json place_json(const SurfacePoint& at, const Vec3& point,
                std::optional<std::size_t> patch = std::nullopt);

/// `point` as an array.
Json vector_json(const Vec3& point);

/// Adds `continuity`, `worst_break_deg` and `worst_break_at` to a summary; null if no
/// border has a break.
/// \param several surfaces make the part: a place then names its patch.
void add_continuity(Json& summary, const SurfaceContinuity& continuity, bool several);

/// Adds `max_cutter_radius_mm` and `max_cutter_radius_at`, null without a limit.
/// \param several as above.
void add_cutter_limit(Json& summary, const std::optional<CutterLimit>& limit,
                      bool several);

/// A sentence on the worst border between patches.
std::string break_text(const SurfaceContinuity& continuity);

/// Reports that --require g1 is not met by the surface of `file`.
ExitCode refuse_break(const std::string& file, const SurfaceContinuity& continuity,
                      const CommonOptions& options);

/// The option --require, whose one word is g1.
void add_require_option(CLI::App& command, bool& g1_is_required);

/// The option --axis, as a unit vector; +z by default.
void add_axis_option(CLI::App& command, Vec3& axis);

}  // namespace endmill
