// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/surface_facts.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/arguments.h"
#include "cli/cad_files.h"
#include "cli/console.h"
#include "cli/progress.h"
#include "cli/shown_numbers.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/path_file.h"
#include "endmill/files/read_file.h"

namespace endmill {

void add_mesh_options(CLI::App& command, PartOptions& part)
{
    static constexpr std::array units{Choice<LengthUnit>{"mm", LengthUnit::Mm},
                                      Choice<LengthUnit>{"inch", LengthUnit::Inch}};
    static constexpr std::array axes{
        Choice<UpAxis>{"z", UpAxis::Z},       Choice<UpAxis>{"y", UpAxis::Y},
        Choice<UpAxis>{"x", UpAxis::X},       Choice<UpAxis>{"-x", UpAxis::MinusX},
        Choice<UpAxis>{"-y", UpAxis::MinusY}, Choice<UpAxis>{"-z", UpAxis::MinusZ}};
    add_choice<LengthUnit>(command, "--units", part.units, units,
                           "unit of a mesh file (default mm)");
    add_choice<UpAxis>(command, "--up", part.up, axes,
                       "axis of a mesh or CAD file that points upwards (default z)");
}

void add_surface_argument(CLI::App& command, std::string& path)
{
    command
        .add_option("SURFACE", path,
                    "surface file (endmill-surface/1), or CAD file of one face")
        ->required();
}

namespace {

// The notes with one line for all poles, of which a part may have dozens.
std::vector<std::string> shown_notes(std::span<const std::string> notes)
{
    const auto is_pole = [](const std::string& note) { return note.starts_with("pole"); };
    const auto poles = std::ranges::count_if(notes, is_pole);
    std::vector<std::string> shown;
    bool has_pole = false;
    for (const std::string& note : notes) {
        if (is_pole(note) && std::exchange(has_pole, true))
            continue;
        shown.push_back(note);
        if (is_pole(note) && poles > 1)
            shown.back() += fmt::format("; {} more like it", poles - 1);
    }
    return shown;
}

}  // namespace

PartFile part_file(const PartOptions& part, const CommonOptions& options)
{
    if (!cad_format(part.path))
        return read_part(part.path, {options.limits, part.units, part.up});
    if (part.units != LengthUnit::Mm)
        throw DomainError{part.path +
                          ": --units is for meshes; a CAD file states its own unit"};
    return part_of_cad(cad_part_for(part.path, part.keeps_import, options), part.path,
                       {options.limits, LengthUnit::Mm, part.up});
}

PartFile read_part_for(const PartOptions& part, const CommonOptions& options)
{
    PartFile file = [&] {
        const ProgressLine progress{"reading " + printable(part.path), options};
        return part_file(part, options);
    }();
    for (const std::string& note : shown_notes(file.notes))
        warn(options, fmt::format("{}: {}", part.path, note));
    return file;
}

void name_part(Json& summary, const PartOptions& part,
               const std::filesystem::path& folder, const std::string& key)
{
    std::error_code failed;
    const std::filesystem::path relative =
        std::filesystem::proximate(std::filesystem::absolute(part.path, failed),
                                   std::filesystem::absolute(folder), failed);
    summary[key] = printable(failed ? part.path : relative.generic_string());
    if (part.units != LengthUnit::Mm)
        summary[key + "_units"] = length_unit_names[static_cast<std::size_t>(part.units)];
    if (part.up != UpAxis::Z)
        summary[key + "_up"] = up_axis_names[static_cast<std::size_t>(part.up)];
}

void name_protected_part(Json& summary, const PartOptions& part,
                         const std::filesystem::path& folder, const ReadLimits& limits)
{
    name_part(summary, part, folder, "protected");
    summary["protected_sha256"] = content_sha256(read_file(part.path, limits));
}

namespace {

// Whether a file is a surface file by its name.
bool is_surface_name(const std::string& path)
{
    std::string extension = std::filesystem::path{path}.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) {
        return static_cast<char>(std::tolower(c));
    });
    return extension == ".json";
}

}  // namespace

PartPair part_pair(const PartOptions& part, const std::string& file)
{
    PartPair pair{part, {file, part.units, part.up}};
    if (cad_format(part.path).has_value() != cad_format(file).has_value())
        (cad_format(part.path) ? pair.part : pair.guard).units = LengthUnit::Mm;
    const bool is_surface = is_surface_name(part.path);
    if (is_surface == is_surface_name(file))
        return pair;
    PartOptions& own = is_surface ? pair.part : pair.guard;
    own = {own.path, LengthUnit::Mm, UpAxis::Z};
    return pair;
}

SurfaceFile read_surface_for(const std::string& path, const std::string& command,
                             const CommonOptions& options)
{
    PartFile file = read_part_for({path}, options);
    auto* surfaces = std::get_if<std::vector<Surface>>(&file.part);
    if (!surfaces)
        throw DomainError{path + ": found a mesh; " + command +
                          " expects a surface file (endmill-surface/1)"};
    return {std::move(file.name), std::move(file.source), std::move(*surfaces),
            std::move(file.notes)};
}

namespace {

// The name of the folder of `path`, if `path` contains it.
std::string folder_name(const std::filesystem::path& path)
{
    const std::string name = path.parent_path().filename().string();
    return name == ".." ? "" : name;
}

// The name of an input for its output folder. All plans call their path toolpath.csv
// and put it into a folder u or v if they have both directions, so the folders identify
// the path.
std::string input_name(const std::filesystem::path& input)
{
    std::string stem = input.stem().string();
    const std::filesystem::path path = input.lexically_normal();
    const std::string folder = folder_name(path);
    if (stem != "toolpath" || folder.empty())
        return stem;
    const std::string above = folder_name(path.parent_path());
    const bool is_direction = folder == "u" || folder == "v";
    return is_direction && !above.empty() ? above + "-" + folder : folder;
}

}  // namespace

std::string output_folder(const std::string& input, const std::string& command,
                          const CommonOptions& options)
{
    if (!options.output.empty())
        return options.output;
    return "./" + input_name(input) + "-" + command;
}

Json vector_json(const Vec3& point)
{
    return {point.x(), point.y(), point.z()};
}

Json place_json(const SurfacePoint& at, const Vec3& point,
                std::optional<std::size_t> patch)
{
    Json place{{"u", at.u}, {"v", at.v}, {"point_mm", vector_json(point)}};
    if (patch)
        place["patch"] = *patch;
    return place;
}

namespace {

std::optional<std::size_t> patch_if(bool several, std::size_t number)
{
    return several ? std::optional{number} : std::nullopt;
}

}  // namespace

void add_continuity(Json& summary, const SurfaceContinuity& continuity, bool several)
{
    const BorderBreak& worst = continuity.worst;
    const bool is_broken =
        worst.continuity != Continuity::G1 || worst.normals.radians() > 0;
    summary["continuity"] = continuity_name(continuity.continuity);
    summary["worst_break_deg"] = worst.normals.degrees();
    summary["worst_break_at"] =
        is_broken ? place_json(worst.at, worst.point, patch_if(several, worst.surface))
                  : Json(nullptr);
}

void add_cutter_limit(Json& summary, const std::optional<CutterLimit>& limit,
                      bool several)
{
    summary["max_cutter_radius_mm"] = limit ? Json(limit->radius_mm) : Json(nullptr);
    summary["max_cutter_radius_at"] =
        limit ? place_json(limit->at, limit->point, patch_if(several, limit->surface))
              : Json(nullptr);
}

std::string break_text(const SurfaceContinuity& continuity)
{
    if (continuity.continuity == Continuity::None)
        return fmt::format("patches meet with a gap of {} mm at {}; expected none",
                           shown(continuity.worst.gap_mm),
                           place_text(continuity.worst.at, continuity.worst.point));
    return fmt::format(
        "patches meet with a break of {} degrees at {}: the surface is {}; expected G1",
        shown_degrees(continuity.worst.normals.degrees()),
        place_text(continuity.worst.at, continuity.worst.point),
        continuity_name(continuity.continuity));
}

ExitCode refuse_break(const std::string& file, const SurfaceContinuity& continuity,
                      const CommonOptions& options)
{
    report_error("E_REQUIRE",
                 file + ": --require g1 is not met: " + break_text(continuity),
                 ExitCode::No, options.json_errors);
    return ExitCode::No;
}

void add_require_option(CLI::App& command, RequiredContinuity& required)
{
    static constexpr std::array choices{
        Choice<RequiredContinuity>{"g1", RequiredContinuity::G1}};
    add_choice<RequiredContinuity>(
        command, "--require", required, choices,
        "exit 1 unless all patches meet with a common tangent plane");
}

void add_axis_option(CLI::App& command, Vec3& axis)
{
    const auto take = [&axis](const std::string& text) {
        axis = vector_argument("--axis", text);
        if (!(axis.stableNorm() > 0))
            throw CLI::ValidationError(
                "--axis", "found \"" + text + "\"; expected a vector that is not zero");
        axis.stableNormalize();
    };
    command
        .add_option_function<std::string>(
            "--axis", take, "tool axis, from the tip to the spindle (default 0,0,1)")
        ->type_name("X,Y,Z");
}

}  // namespace endmill
