// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/view_content.h"

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "build_facts.h"
#include "cli/cite.h"
#include "cli/shown_numbers.h"
#include "cli/surface_facts.h"
#include "cli/view_deviation.h"
#include "cli/view_frame.h"
#include "cli/view_path.h"
#include "cli/view_sections.h"
#include "cli/view_sphere.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/path_file.h"
#include "endmill/files/vtk.h"
#include "endmill/mesh/decimation.h"
#include "endmill/surface/sampling.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

// What a browser that draws by software turns smoothly; see docs/guide/view.md.
constexpr std::size_t most_triangles = 60'000;

// A chord tolerance at which the part has few enough triangles.
SampledSurface sampled_for_view(std::span<const Surface> surfaces)
{
    const std::vector<double> sides = tool_side_signs(surfaces, Vec3::UnitZ());
    double tolerance = default_chord_tolerance(surfaces);
    while (true) {
        try {
            return sampled(surfaces, sides, tolerance, most_triangles);
        } catch (const LimitError&) {
            tolerance *= 2;
            if (!std::isfinite(tolerance))
                throw;
        }
    }
}

class ContentMaker {
public:
    ContentMaker(const ViewInput& input, const ViewOptions& options,
                 ProgressLine& progress)
        : input_{input},
          options_{options},
          progress_{progress}
    {
    }

    ViewContent run()
    {
        read();
        frame_.origin = box_.centre();
        frame_.size_mm = box_.size();
        Json head{{"title", input_.title},
                  {"origin_mm", vector_json(frame_.origin)},
                  {"size_mm", frame_.size_mm}};
        add_views(head);
        head["summaries"] = summaries();
        head["provenance"] = provenance();
        head["citations"] = citations();
        head["pictures"] = pictures();
        return {std::move(head), std::move(frame_.numbers)};
    }

private:
    void add_views(Json& head)
    {
        if (mesh_) {
            head["part"] = mesh_json(frame_, *mesh_, frame_.origin);
            if (!part_note_.empty())
                head["part"]["note"] = part_note_;
        }
        if (path_) {
            progress_.begin("reducing the path");
            add_path_view(head, *path_, input_, limits(), frame_);
        }
        if (deviation_)
            head["deviation"] = deviation_view(*deviation_, input_, frame_);
        if (!input_.sections.empty() && !input_.trimmed.empty()) {
            progress_.begin("reading the sections");
            head["sections"] = sections_view(input_, limits(), frame_);
        }
        if (!input_.visibility.empty()) {
            progress_.begin("reading the visibility");
            head["sphere"] =
                sphere_view(input_, mesh_ ? &*mesh_ : nullptr, limits(), frame_);
        }
    }

    void read()
    {
        if (!input_.toolpath.empty()) {
            progress_.begin("reading the path");
            path_ = read_view_path(input_, options_);
            for (const PathPoint& point : path_->program.path.points)
                box_.add(point.location.tip);
        }
        if (!input_.part.path.empty()) {
            progress_.begin("reading the part");
            read_mesh_of_part();
            for (const Vec3& point : mesh_->points())
                box_.add(point);
        }
        if (!input_.deviation.empty()) {
            deviation_ = read_deviation_points(input_.deviation, limits());
            const std::vector<float>& points = deviation_->point_mm;
            for (std::size_t k = 0; k + 2 < points.size(); k += 3)
                box_.add({points[k], points[k + 1], points[k + 2]});
        }
    }

    void read_mesh_of_part()
    {
        PartFile file = read_part_for(input_.part, options_.common);
        if (const auto* surfaces = std::get_if<std::vector<Surface>>(&file.part)) {
            SampledSurface found = sampled_for_view(*surfaces);
            mesh_ = std::move(found.mesh);
            part_note_ = fmt::format("The part is drawn as {} triangles within {} mm.",
                                     mesh_->triangles().size(),
                                     shown_bound(found.max_chord_error_mm));
            return;
        }
        auto& mesh = std::get<TriangleMesh>(file.part);
        if (mesh.triangles().size() > most_triangles && input_.visibility.empty()) {
            progress_.begin("reducing the part");
            part_note_ = fmt::format(
                "The part is drawn with about {} of its {} triangles; flat regions have "
                "lost most.",
                most_triangles, mesh.triangles().size());
            mesh = decimated(mesh, most_triangles).mesh;
        }
        mesh_ = std::move(mesh);
    }

    static std::string text_of(const Json& value)
    {
        if (value.is_string())
            return value.get<std::string>();
        if (value.is_number_float())
            return fmt::format("{:.6g}", value.get<double>());
        if (value.is_null() || value.empty())
            return "none";
        if (value.is_boolean())
            return value.get<bool>() ? "yes" : "no";
        return value.dump();
    }

    // Adds a table with a row for each value. Keys within an object follow its key and a point;
    // a large object gets a table of its own, which the page folds.
    static void add_table(Json& list, const std::string& title, const Json& object,
                          bool is_folded)
    {
        constexpr std::size_t large = 24;  // values within an object
        const std::size_t place = list.size();
        list.push_back({{"title", title}, {"is_folded", is_folded}});
        Json rows = Json::array();
        const auto add_rows = [&](const auto& self, const std::string& outer,
                                  const Json& values) -> void {
            constexpr std::size_t longest = 300;  // characters of a value
            for (const auto& [key, value] : values.items()) {
                const std::string name = outer + printable(key);
                if (value.is_object() && value.flatten().size() > large)
                    add_table(list, fmt::format("{}: {}", title, name), value, true);
                else if (value.is_object() && !value.empty())
                    self(self, name + ".", value);
                else
                    rows.push_back({name, printable(text_of(value), longest)});
            }
        };
        add_rows(add_rows, "", object);
        list[place]["rows"] = std::move(rows);
    }

    Json summaries() const
    {
        Json list = Json::array();
        for (const ViewSummary& summary : input_.summaries)
            add_table(list, shown_path(summary.file), summary.content, false);
        return list;
    }

    Json provenance() const
    {
        Json rows = Json::array();
        rows.push_back({"program", "endmill " + std::string{program_version}});
        const auto add = [&](const char* what, const std::string& file) {
            if (!file.empty())
                rows.push_back({what, shown_path(file) + ", SHA-256 " +
                                          content_sha256(read_file(file, limits()))});
        };
        add("part", input_.part.path);
        add("path", input_.toolpath);
        add("remaining stock", input_.deviation);
        add("sections", input_.sections);
        for (const TrimmedSections& trimmed : input_.trimmed)
            add("trimmed sections", trimmed.file);
        add("visibility", input_.visibility);
        add("engagement", input_.engagement);
        return rows;
    }

    Json citations() const
    {
        Json list = Json::array();
        const std::array<std::pair<bool, const char*>, 4> works{
            {{path_.has_value(), "KimChoi"},
             {!input_.sections.empty(), "JangKimJeong"},
             {!input_.visibility.empty(), "KangSuh"},
             {!input_.engagement.empty(), "ParkMaeng"}}};
        for (const auto& [is_used, key] : works)
            if (is_used)
                list.push_back(cited_work(key));
        return list;
    }

    Json pictures() const
    {
        Json list = Json::array();
        for (const std::filesystem::path& file : input_.pictures)
            list.push_back(
                {{"name", shown_path(file)}, {"svg", read_file(file, limits())}});
        return list;
    }

    const ReadLimits& limits() const { return options_.common.limits; }

    const ViewInput& input_;
    const ViewOptions& options_;
    ProgressLine& progress_;
    ViewFrame frame_;
    std::optional<ViewPath> path_;
    std::optional<TriangleMesh> mesh_;
    std::string part_note_;
    std::optional<DeviationPoints> deviation_;
    ViewBox box_;
};

}  // namespace

ViewContent view_content(const ViewInput& input, const ViewOptions& options,
                         ProgressLine& progress)
{
    return ContentMaker{input, options, progress}.run();
}

}  // namespace endmill
