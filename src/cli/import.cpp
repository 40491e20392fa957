// SPDX-License-Identifier: GPL-3.0-or-later
// endmill import: a STEP or IGES file as a mesh with face numbers and as NURBS surfaces.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "build_facts.h"
#include "cli/arguments.h"
#include "cli/cad_files.h"
#include "cli/console.h"
#include "cli/progress.h"
#include "cli/shown_numbers.h"
#include "cli/surface_facts.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "endmill/files/csv.h"
#include "endmill/files/output_folder.h"
#include "endmill/files/surface_file.h"
#include "endmill/mesh/mesh_checks.h"
#include "endmill/surface/largest_cutter.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

// Address space that endmill-cad needs to load its libraries, GiB.
constexpr double least_gib = 0.25;

struct ImportOptions {
    CommonOptions common;
    std::string path;
    CadImportOptions import;
    std::vector<int> faces;  // empty: all
};

std::string file_name_of(const ImportOptions& options)
{
    return printable(std::filesystem::path{options.path}.filename().string());
}

std::string surface_name(std::size_t face)
{
    return "surfaces/face-" + std::to_string(face + 1) + ".json";
}

// The largest ball for a face by its curvature, in words and as a radius.
struct FaceBall {
    std::string limit = "unknown";      // or limited or unlimited
    std::optional<double> radius = {};  // mm
};

// The same of a trimmed face, on the side of the tool.
FaceBall ball_of_trimmed(const CadPart& part, std::size_t number)
{
    const auto& balls = part.measures->trimmed_balls[number];
    if (!balls)
        return {};
    double rise = 0;  // twice the area of the face seen from above
    for (std::size_t k = 0; part.solids == 0 && k < part.triangle_faces.size(); ++k)
        if (static_cast<std::size_t>(part.triangle_faces[k]) == number) {
            const auto [a, b, c] = part.mesh.corners(k);
            rise += (b - a).cross(c - a).z();
        }
    const auto& limit = rise < 0 ? balls->inside : balls->outside;
    return limit ? FaceBall{"limited", limit} : FaceBall{"unlimited"};
}

FaceBall largest_ball(const CadPart& part, std::size_t number)
{
    const CadFace& face = part.faces[number];
    if (!face.surface)
        return ball_of_trimmed(part, number);
    if (face.kind == "plane")
        return {"unlimited"};
    const Surface surface = nurbs_surface(*face.surface, tool_side(part, face));
    const auto limit =
        largest_cutter_by_curvature(surface, tool_side_sign(surface, Vec3::UnitZ()));
    if (!limit)
        return {"unlimited"};
    return {"limited", limit->radius_mm};
}

// Numbers from 0 of the faces that are written.
std::vector<std::size_t> written_faces(const CadPart& part, const ImportOptions& options)
{
    std::vector<std::size_t> faces;
    for (const int number : options.faces)
        faces.push_back(static_cast<std::size_t>(number) - 1);
    if (options.faces.empty())
        for (std::size_t k = 0; k < part.faces.size(); ++k)
            faces.push_back(k);
    return faces;
}

std::string faces_csv(const CadPart& part, std::span<const std::size_t> faces)
{
    std::vector<FaceBall> balls(faces.size());
    parallel_for(faces.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            balls[k] = largest_ball(part, faces[k]);
    });
    CsvTable table{{"face", "kind", "area_mm2", "trimmed", "surface", "ball",
                    "max_cutter_radius_local_mm", "colour", "name"}};
    const auto optional_text = [](const std::string& text) {
        return text.empty() ? CsvCell{} : CsvCell{text};
    };
    for (std::size_t k = 0; k < faces.size(); ++k) {
        const CadFace& face = part.faces[faces[k]];
        const FaceBall& ball = balls[k];
        table.add_row({static_cast<std::int64_t>(faces[k] + 1), face.kind,
                       part.measures->face_areas_mm2[faces[k]],
                       face.is_trimmed ? "yes" : "no",
                       face.surface ? CsvCell{surface_name(faces[k])} : CsvCell{},
                       ball.limit, ball.radius ? CsvCell{*ball.radius} : CsvCell{},
                       optional_text(face.colour), optional_text(face.name)});
    }
    return table.text();
}

Json size_json(const TriangleMesh& mesh)
{
    Vec3 low = mesh.points().front();
    Vec3 high = low;
    for (const Vec3& point : mesh.points()) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    return vector_json(high - low);
}

// Measures of the mesh, beside those that OpenCASCADE integrated over the faces.
void add_measures(Json& summary, const CadPart& part, const MeshFile& mesh,
                  const MeshReport& report, bool is_whole)
{
    summary["size_mm"] = size_json(mesh.mesh);
    summary["area_mm2"] = report.area;
    summary["volume_mm3"] =
        is_whole && report.volume ? Json(*report.volume) : Json(nullptr);
    if (!is_whole)
        return;
    summary["centre_mm"] = vector_json(centre_of_mass(mesh.mesh, part.solids > 0));
    summary["of_faces"] = {
        {"area_mm2", part.measures->area_mm2},
        {"volume_mm3", finite_or_null(part.measures->volume_mm3.value_or(NAN))},
        {"centre_mm", vector_json(part.measures->centre_mm)}};
}

Json import_summary(const ImportOptions& options, const CadPart& part,
                    const MeshFile& mesh, std::span<const std::size_t> faces)
{
    const MeshReport report = mesh_report(mesh.mesh);
    const auto count_of = [&](auto is_counted) {
        return std::ranges::count_if(
            faces, [&](std::size_t k) { return is_counted(part.faces[k]); });
    };
    Json summary{
        {"name", mesh.name},
        {"file", file_name_of(options)},
        {"endmill", program_version},
        {"unit", part.unit.empty() ? Json(nullptr) : Json(part.unit)},
        {"sewn", part.is_sewn},
        {"lost_faces", part.lost_faces},
        {"solids", part.solids},
        {"shells", part.shells},
        {"faces", part.faces.size()},
        {"faces_written", faces.size()},
        {"trimmed_faces", count_of([](const CadFace& face) { return face.is_trimmed; })},
        {"surfaces",
         count_of([](const CadFace& face) { return face.surface.has_value(); })},
        {"chord_tolerance_mm", options.import.chord_tolerance_mm},
        {"angle_deg", options.import.angle_deg},
        {"triangles", mesh.mesh.triangles().size()},
        {"vertices", mesh.mesh.points().size()},
        {"boundary_edges", report.boundary_edges},
        {"non_manifold_edges", report.non_manifold_edges}};
    add_measures(summary, part, mesh, report, faces.size() == part.faces.size());
    summary["notes"] = part.notes;
    return summary;
}

std::string import_text(const Json& s, const OutputFolder& folder)
{
    const std::size_t faces = s["faces_written"];
    const std::size_t surfaces = s["surfaces"];
    const std::size_t open = s["boundary_edges"];
    return fmt::format(
        "{}: {} of {}, unit {}; {}, {}\n"
        "  mesh          {} triangles, within {} mm of the faces, {}\n"
        "  surfaces      {} of {} faces are NURBS; the other {} go on as mesh\n"
        "  size          {} x {} x {} mm, area {} mm2{}\n"
        "written to {}\n",
        s["name"].get<std::string>(), faces,
        counted(s["faces"].get<std::size_t>(), "face"),
        s["unit"].is_null() ? "not named, taken as mm" : s["unit"].get<std::string>(),
        counted(s["solids"].get<std::size_t>(), "solid"),
        counted(s["shells"].get<std::size_t>(), "open shell"),
        s["triangles"].get<std::size_t>(),
        shown_limit(s["chord_tolerance_mm"].get<double>()),
        open == 0 ? "closed" : fmt::format("{} open", counted(open, "edge")), surfaces,
        faces, faces - surfaces, shown(s["size_mm"][0].get<double>()),
        shown(s["size_mm"][1].get<double>()), shown(s["size_mm"][2].get<double>()),
        shown(s["area_mm2"].get<double>()),
        s["volume_mm3"].is_null()
            ? ""
            : fmt::format(", volume {} mm3", shown(s["volume_mm3"].get<double>())),
        printable(folder.path().string()));
}

// Files of an earlier run that may have had more faces.
void remove_earlier_surfaces(OutputFolder& folder)
{
    std::error_code ignored;
    for (const auto& entry :
         std::filesystem::directory_iterator{folder.path() / "surfaces", ignored}) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with("face-") && name.ends_with(".json"))
            folder.remove_unless_written(std::filesystem::path{"surfaces"} / name);
    }
}

ExitCode run_import(const ImportOptions& options)
{
    ProgressLine progress{"importing " + printable(options.path), options.common};
    const CadPart part =
        import_cad(cad_program(), options.path, options.import, options.common.limits);
    const MeshFile mesh =
        mesh_of_faces(part, options.faces, options.path, {options.common.limits});
    const std::vector<std::size_t> faces = written_faces(part, options);
    OutputFolder folder{output_folder(options.path, "import", options.common),
                        options.common.full_folder};
    folder.protect(options.path);
    remove_earlier_surfaces(folder);
    progress.begin("measuring the faces");
    folder.write("faces.csv", faces_csv(part, faces));
    folder.write("mesh.ply",
                 mesh_text(mesh.mesh, MeshFormat::Ply, {}, mesh.face_numbers));
    for (const std::size_t k : faces)
        if (const CadFace& face = part.faces[k]; face.surface)
            folder.write(surface_name(k),
                         surface_text(*face.surface, tool_side(part, face),
                                      mesh.name + ", face " + std::to_string(k + 1),
                                      "imported from " + file_name_of(options)));
    const Json summary = import_summary(options, part, mesh, faces);
    folder.write("summary.json", summary.dump(2) + "\n");
    folder.publish();
    for (const auto* notes : {&part.notes, &mesh.notes})
        for (const std::string& note : *notes)
            warn(options.common, options.path + ": " + note);
    print_result(options.common, summary, import_text(summary, folder));
    return ExitCode::Yes;
}

void add_limits(CLI::App& command, CadImportOptions& options)
{
    add_number(
        command,
        {"--limit-seconds", "S", "time limit of endmill-cad, which reads the file"},
        options.limit_seconds);
    add_number(
        command,
        {"--limit-gib", "GIB", "memory limit of endmill-cad, which needs 0.25 to begin",
         NumberDomain::from_to(least_gib, most_of_machine)},
        options.limit_gib);
    add_whole_number(
        command,
        {"--max-faces", "refuse a file with more faces (default 100000)", 1,
         std::numeric_limits<int>::max()},
        [&options](int faces) { options.max_faces = static_cast<std::size_t>(faces); })
        ->type_name("N");
}

}  // namespace

void add_import_command(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand(
        "import", "turn a STEP or IGES file into mesh and surfaces");
    const auto options = std::make_shared<ImportOptions>();
    options->import.measures = true;
    command
        ->add_option("FILE", options->path,
                     "STEP or IGES file (.step, .stp, .iges, .igs)")
        ->required();
    add_number(*command,
               {"--chord-tolerance", "MM", "largest distance from the faces to the mesh"},
               options->import.chord_tolerance_mm);
    add_number(*command,
               {"--angle-deg", "DEG", "largest angle between neighbouring chords",
                NumberDomain::between(0, 180)},
               options->import.angle_deg);
    add_face_option(*command, options->faces,
                    "write these faces only, by their numbers from 1 (default: all)");
    add_limits(*command, options->import);
    add_common_options(*command, options->common);
    command->footer(
        "Writes to --output (default ./NAME-import):\n"
        "  mesh.ply       all faces; each triangle has its face_number\n"
        "  faces.csv      kind, area, largest ball, colour and name of each face\n"
        "  surfaces/      face-N.json for each face that is not trimmed, the same "
        "geometry\n"
        "                 as NURBS\n"
        "  summary.json   unit of the file, counts, area, volume, centre of mass\n\n"
        "plan, trim, setup, verify, feed, sample and info also take the file itself.\n\n"
        "Example:\n  endmill import datasets/cad/mould.step --chord-tolerance 0.05");
    command->callback(
        [options, &action] { action = [options] { return run_import(*options); }; });
}

}  // namespace endmill
