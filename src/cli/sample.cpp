// SPDX-License-Identifier: GPL-3.0-or-later
// endmill sample: a triangle mesh of a surface.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "build_facts.h"
#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/progress.h"
#include "cli/shown_numbers.h"
#include "cli/surface_facts.h"
#include "endmill/core/text.h"
#include "endmill/files/mesh_file.h"
#include "endmill/files/output_folder.h"
#include "endmill/surface/sampling.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

// Memory for one triangle and its share of the points, until the file is written.
constexpr double bytes_per_triangle = 250;
// A warning is due if rounding to float exceeds this, in mm.
constexpr double negligible_float_error = 1e-4;

struct SampleOptions {
    CommonOptions common;
    std::string surface;
    std::optional<double> chord_tolerance;
    std::optional<int> lines;  // of a grid
    MeshFormat format = MeshFormat::Stl;
    Vec3 axis = Vec3::UnitZ();
};

struct Sampling {
    SampledSurface found;
    Json settings;  // sampling options, for the summary
};

Sampling sampled_as_asked(const SampleOptions& options, std::span<const Surface> surfaces)
{
    const std::vector<double> sides = tool_side_signs(surfaces, options.axis);
    const auto most = static_cast<std::size_t>(
        std::min(options.common.limits.max_memory_gib * one_gib / bytes_per_triangle,
                 double(most_possible_triangles)));
    if (options.lines)
        return {sampled_on_grid(surfaces, sides, *options.lines, most),
                {{"grid", *options.lines}, {"max_chord_error_is", "measured"}}};
    const double tolerance = options.chord_tolerance ? *options.chord_tolerance
                                                     : default_chord_tolerance(surfaces);
    return {sampled(surfaces, sides, tolerance, most),
            {{"chord_tolerance_mm", tolerance}, {"max_chord_error_is", "bound"}}};
}

// Half a unit in the last place of a float, along all three coordinates.
double float_rounding_mm(const TriangleMesh& mesh)
{
    double farthest = 0;
    for (const Vec3& point : mesh.points())
        farthest = std::max(farthest, point.lpNorm<Eigen::Infinity>());
    return std::sqrt(3.0) * 0x1p-24 * farthest;
}

std::string summary_text(const Json& s, const OutputFolder& folder)
{
    const bool is_grid = s.contains("grid");
    const std::string how =
        is_grid ? fmt::format("grid of {0} x {0} points", s["grid"].get<int>())
                : fmt::format("chord tolerance {} mm",
                              shown_limit(s["chord_tolerance_mm"].get<double>()));
    return fmt::format(
        "{}: {} triangles, {} points; {}\n"
        "  chord error   {}{} mm\n"
        "written to {}\n",
        s["name"].get<std::string>(), s["triangles"].get<std::size_t>(),
        s["vertices"].get<std::size_t>(), how, is_grid ? "" : "at most ",
        is_grid ? shown(s["max_chord_error_mm"].get<double>())
                : shown_bound(s["max_chord_error_mm"].get<double>()),
        printable(folder.path().string()));
}

ExitCode run_sample(const SampleOptions& options)
{
    const SurfaceFile file = read_surface_for(options.surface, "sample", options.common);
    Sampling sampling = [&] {
        const ProgressLine progress{"sampling", options.common};
        return sampled_as_asked(options, file.surfaces);
    }();
    if (options.format == MeshFormat::Stl) {
        const double stl_rounding = float_rounding_mm(sampling.found.mesh);
        if (stl_rounding > sampling.found.max_chord_error_mm &&
            stl_rounding > negligible_float_error)
            warn(options.common,
                 fmt::format(
                     "binary STL rounds these coordinates by up to {} mm; the other "
                     "formats do not",
                     shown_bound(stl_rounding)));
        sampling.found.max_chord_error_mm += stl_rounding;
    }
    const std::string name = "mesh" + std::string{mesh_extension(options.format)};
    Json summary{{"name", file.name},
                 {"source", file.source},
                 {"endmill", program_version},
                 {"triangles", sampling.found.mesh.triangles().size()},
                 {"vertices", sampling.found.mesh.points().size()},
                 {"max_chord_error_mm", sampling.found.max_chord_error_mm},
                 {"file", name}};
    summary.update(sampling.settings);
    summary["format"] = mesh_format_names[static_cast<std::size_t>(options.format)];

    OutputFolder folder{output_folder(options.surface, "sample", options.common),
                        options.common.full_folder};
    folder.protect(options.surface);
    folder.write(name,
                 mesh_text(sampling.found.mesh, options.format, sampling.found.normals));
    folder.write("summary.json", summary.dump(2) + "\n");
    for (const char* other : {"mesh.stl", "mesh.obj", "mesh.ply", "mesh.off"})
        folder.remove_unless_written(other);
    folder.publish();
    print_result(options.common, summary, summary_text(summary, folder));
    return ExitCode::Yes;
}

}  // namespace

void add_sample_command(CLI::App& program, Action& action)
{
    CLI::App* command =
        program.add_subcommand("sample", "write a triangle mesh of a surface");
    const auto options = std::make_shared<SampleOptions>();
    add_surface_argument(*command, options->surface);
    CLI::Option* tolerance = add_number(
        *command,
        {"--chord-tolerance", "MM",
         "largest distance from surface to mesh (default: longest side / 1000)"},
        options->chord_tolerance);
    add_whole_number(*command,
                     {"--grid", "sample N by N points of each surface instead", 2, 20000},
                     [options](int lines) { options->lines = lines; })
        ->type_name("N")
        ->excludes(tolerance);
    static constexpr std::array formats{
        Choice<MeshFormat>{"stl", MeshFormat::Stl},
        Choice<MeshFormat>{"stl-ascii", MeshFormat::StlAscii},
        Choice<MeshFormat>{"obj", MeshFormat::Obj},
        Choice<MeshFormat>{"ply", MeshFormat::Ply},
        Choice<MeshFormat>{"off", MeshFormat::Off}};
    add_choice<MeshFormat>(
        *command, "--format", options->format, formats,
        "format of the mesh file (default stl: binary, rounded to float)");
    add_axis_option(*command, options->axis);
    add_common_options(*command, options->common);
    command->footer(
        "Writes mesh.stl, mesh.obj, mesh.ply (with normals) or mesh.off, and\n"
        "summary.json, to --output (default ./NAME-sample).\n\n"
        "Example:\n  endmill sample datasets/surfaces/net_rot24_7D.json "
        "--chord-tolerance 0.05 --format ply");
    command->callback(
        [options, &action] { action = [options] { return run_sample(*options); }; });
}

}  // namespace endmill
