// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/view_content.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "build_facts.h"
#include "cli/cite.h"
#include "cli/shown_numbers.h"
#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/csv.h"
#include "endmill/files/path_file.h"
#include "endmill/files/visibility_file.h"
#include "endmill/files/vtk.h"
#include "endmill/machine/feasible_directions.h"
#include "endmill/mesh/decimation.h"
#include "endmill/page/reduction.h"
#include "endmill/surface/sampling.h"
#include "endmill/surface/tool_side.h"
#include "endmill/verification/verification.h"
#include "endmill/visibility/sphere_grid.h"

namespace endmill {
namespace {

// What a browser that draws by software turns fluently; see docs/guide/view.md.
constexpr std::size_t most_triangles = 60'000;
constexpr std::size_t most_path_points_drawn = 50'000;
constexpr std::size_t most_deviation_points_drawn = 100'000;
constexpr std::size_t most_plot_points = 4'000;
constexpr std::size_t most_section_points = 1'000'000;
// Visibility of more bits than this makes a page that is too large to open.
constexpr double most_visibility_bits = 4e8;

// In the order of the enumeration Move.
constexpr std::array move_names{"cut", "link", "rapid", "plunge", "retract"};

Json array_json(const PageArray& array)
{
    return {{"array", array.kind}, {"offset", array.offset}, {"length", array.length}};
}

Json vector_of(const Vec3& vector)
{
    return {vector.x(), vector.y(), vector.z()};
}

// Box of all that is shown.
struct Box {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = -low;

    void add(const Vec3& point)
    {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    bool is_empty() const { return !(low.x() <= high.x()); }
    Vec3 centre() const
    {
        return is_empty() ? Vec3{Vec3::Zero()} : Vec3{(low + high) / 2};
    }
    double size() const { return is_empty() ? 0 : (high - low).norm(); }
};

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
        origin_ = box_.centre();
        Json& head = content_.head;
        head["title"] = input_.title;
        head["origin_mm"] = vector_of(origin_);
        if (mesh_)
            head["part"] = part();
        if (program_)
            head["path"] = path();
        if (deviation_)
            head["deviation"] = deviation();
        if (!input_.sections.empty() && !input_.trimmed.empty())
            head["sections"] = sections();
        if (!input_.visibility.empty())
            head["sphere"] = sphere();
        head["summaries"] = summaries();
        head["provenance"] = provenance();
        head["citations"] = citations();
        head["pictures"] = pictures();
        return std::move(content_);
    }

private:
    void read()
    {
        if (!input_.toolpath.empty()) {
            progress_.begin("reading the path");
            const auto summary = read_path_summary(input_.toolpath, limits());
            PathReadOptions reading;
            reading.limits = limits();
            if (summary)
                reading.machine = summary->machine;
            program_ = read_program(input_.toolpath, reading);
            cutter_ = summary ? summary->cutter : std::nullopt;
            for (const PathPoint& point : program_->path.points)
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
        whole_facets_ = mesh.triangles().size();
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

    // A point relative to the origin of the page, in single precision.
    void push(std::vector<float>& numbers, const Vec3& point) const
    {
        for (int c = 0; c < 3; ++c)
            numbers.push_back(static_cast<float>(point[c] - origin_[c]));
    }

    Json mesh_json(const TriangleMesh& mesh, const Vec3& origin)
    {
        std::vector<float> points;
        points.reserve(3 * mesh.points().size());
        for (const Vec3& point : mesh.points())
            for (int c = 0; c < 3; ++c)
                points.push_back(static_cast<float>(point[c] - origin[c]));
        std::vector<std::uint32_t> triangles;
        triangles.reserve(3 * mesh.triangles().size());
        for (const Triangle& triangle : mesh.triangles())
            for (const std::int32_t corner : triangle)
                triangles.push_back(static_cast<std::uint32_t>(corner));
        return {{"points", array_json(content_.numbers.add(points))},
                {"triangles", array_json(content_.numbers.add(triangles))}};
    }

    Json part()
    {
        Json part = mesh_json(*mesh_, origin_);
        part["note"] = part_note_;
        return part;
    }

    Json path()
    {
        progress_.begin("reducing the path");
        const ToolPath& whole = program_->path;
        const ReducedPath reduced = reduced_path(whole, most_path_points_drawn);
        Json path;
        add_geometry(path, whole, reduced);
        add_kinds(path, whole, reduced);
        if (reduced.points.size() < whole.points.size())
            path["note"] = fmt::format(
                "The path is drawn with {} of its {} points; no tip is farther than {} "
                "mm "
                "from the lines.",
                reduced.points.size(), whole.points.size(),
                shown_bound(reduced.tolerance_mm));
        if (cutter_)
            path["cutter"] = {{"radius_mm", cutter_->radius()},
                              {"corner_radius_mm", cutter_->corner_radius()},
                              {"word", cutter_word(*cutter_)}};
        if (!input_.engagement.empty())
            add_engagement(path, whole, reduced);
        if (whole.machine && whole.machine->positions.size() == whole.points.size())
            add_machine(path, whole, reduced);
        return path;
    }

    void add_geometry(Json& path, const ToolPath& whole, const ReducedPath& reduced)
    {
        std::vector<float> tips;
        std::vector<float> axes;
        std::vector<float> way;
        std::vector<std::uint32_t> numbers;
        std::vector<double> ways(whole.points.size());
        for (std::size_t k = 1; k < ways.size(); ++k)
            ways[k] =
                ways[k - 1] +
                (whole.points[k].location.tip - whole.points[k - 1].location.tip).norm();
        const std::optional<Vec3> fixed = fixed_axis(whole);
        for (const std::size_t k : reduced.points) {
            push(tips, whole.points[k].location.tip);
            way.push_back(static_cast<float>(ways[k]));
            numbers.push_back(static_cast<std::uint32_t>(k));
            for (int c = 0; !fixed && c < 3; ++c)
                axes.push_back(static_cast<float>(whole.points[k].location.axis[c]));
        }
        path["tips"] = array_json(content_.numbers.add(tips));
        path["way_mm"] = array_json(content_.numbers.add(way));
        path["numbers"] = array_json(content_.numbers.add(numbers));
        if (fixed)
            path["axis"] = vector_of(*fixed);
        else
            path["axes"] = array_json(content_.numbers.add(axes));
    }

    void add_kinds(Json& path, const ToolPath& whole, const ReducedPath& reduced)
    {
        std::vector<std::uint8_t> moves;
        std::vector<std::uint32_t> passes;
        std::vector<std::uint32_t> pieces;
        std::vector<float> feeds;
        bool has_feeds = false;
        std::vector<std::uint32_t> piece_of(whole.points.size());
        std::uint32_t piece = 0;  // a run of cuts; other moves belong to the next one
        for (std::size_t k = 1; k < whole.points.size(); ++k) {
            piece += whole.points[k - 1].move == Move::Cut &&
                     whole.points[k].move != Move::Cut;
            piece_of[k] = piece;
        }
        for (const std::size_t k : reduced.points) {
            const PathPoint& point = whole.points[k];
            moves.push_back(static_cast<std::uint8_t>(point.move));
            passes.push_back(static_cast<std::uint32_t>(std::max(point.pass, 0)));
            pieces.push_back(piece_of[k]);
            const std::optional<double>& feed = point.conditions.feed_mm_per_min;
            has_feeds = has_feeds || feed.has_value();
            feeds.push_back(feed ? static_cast<float>(*feed)
                                 : std::numeric_limits<float>::quiet_NaN());
        }
        path["move_names"] = move_names;
        path["moves"] = array_json(content_.numbers.add(moves));
        path["passes"] = array_json(content_.numbers.add(passes));
        path["pieces"] = array_json(content_.numbers.add(pieces));
        if (has_feeds)
            path["feeds"] = array_json(content_.numbers.add(feeds));
    }

    // Limits of the feed at the points that are drawn, and plots of the cut along the whole path.
    void add_engagement(Json& path, const ToolPath& whole, const ReducedPath& reduced)
    {
        progress_.begin("reading the engagement");
        const CsvTable table = read_csv(input_.engagement, limits());
        std::map<std::pair<int, int>, std::size_t> rows;
        for (std::size_t row = 0; row < table.rows(); ++row)
            rows[{static_cast<int>(table.number(row, "pass").value_or(-1)),
                  static_cast<int>(table.number(row, "point").value_or(-1))}] = row;
        std::vector<std::string> names{""};
        std::vector<std::uint8_t> limit_numbers;
        const auto row_of = [&](std::size_t k) {
            return rows.find({whole.points[k].pass, whole.points[k].point});
        };
        for (const std::size_t k : reduced.points) {
            const auto found = row_of(k);
            const std::string word =
                found == rows.end() ? "" : table.cell(found->second, "limit");
            const auto known = std::ranges::find(names, word);
            limit_numbers.push_back(static_cast<std::uint8_t>(known - names.begin()));
            if (known == names.end() && names.size() < 255)
                names.push_back(word);
        }
        for (std::string& name : names)
            std::ranges::replace(name, '_', ' ');
        path["limit_names"] = names;
        path["limits"] = array_json(content_.numbers.add(limit_numbers));
        add_plots(whole, table, row_of, rows.end());
    }

    template <typename RowOf, typename End>
    void add_plots(const ToolPath& whole, const CsvTable& table, const RowOf& row_of,
                   const End& end)
    {
        constexpr std::array<std::pair<const char*, const char*>, 4> shown_columns{
            {{"cutting_force_n", "cutting force, N"},
             {"thrust_n", "thrust, N"},
             {"torque_n_m", "torque, N m"},
             {"power_w", "power, W"}}};
        const float unknown = std::numeric_limits<float>::quiet_NaN();
        std::vector<float> feeds;
        std::vector<float> way;
        std::vector<std::size_t> table_rows;  // or the number of rows where there is none
        double at = 0;
        for (std::size_t k = 0; k < whole.points.size(); ++k) {
            if (k > 0)
                at += (whole.points[k].location.tip - whole.points[k - 1].location.tip)
                          .norm();
            way.push_back(static_cast<float>(at));
            const auto& feed = whole.points[k].conditions.feed_mm_per_min;
            feeds.push_back(feed ? static_cast<float>(*feed) : unknown);
            const auto found = row_of(k);
            table_rows.push_back(found == end ? table.rows() : found->second);
        }
        const std::vector<std::size_t> chosen = extremes(feeds, most_plot_points);
        const auto picked = [&](const auto& value) {
            std::vector<float> values;
            for (const std::size_t k : chosen)
                values.push_back(value(k));
            return array_json(content_.numbers.add(values));
        };
        Json series = Json::array();
        series.push_back({{"name", "feed, mm/min"},
                          {"values", picked([&](std::size_t k) { return feeds[k]; })}});
        for (const auto& [column, name] : shown_columns)
            series.push_back(
                {{"name", name}, {"values", picked([&](std::size_t k) {
                                      const std::size_t row = table_rows[k];
                                      const auto value = row < table.rows()
                                                             ? table.number(row, column)
                                                             : std::optional<double>{};
                                      return value ? static_cast<float>(*value) : unknown;
                                  })}});
        content_.head["plots"] = {
            {"along_mm", picked([&](std::size_t k) { return way[k]; })},
            {"series", std::move(series)}};
    }

    void add_machine(Json& path, const ToolPath& whole, const ReducedPath& reduced)
    {
        const MachineMotion& motion = *whole.machine;
        std::vector<float> positions;
        for (const std::size_t k : reduced.points) {
            const AxisPositions& at = motion.positions[k];
            for (int c = 0; c < 3; ++c)
                positions.push_back(static_cast<float>(at.xyz[c]));
            for (const double turn : at.rotary)
                positions.push_back(static_cast<float>(Angle::radians(turn).degrees()));
        }
        path["positions"] = array_json(content_.numbers.add(positions));
        const MachineConfiguration& machine = motion.setup.machine.configuration;
        Json rotary = Json::array();
        for (const RotaryAxis& axis : machine.rotary)
            rotary.push_back(
                {{"letter", std::string{axis.letter}},
                 {"side", axis.side == MachineSide::Table ? "table" : "head"}});
        // Points of the page are relative to its origin, in the part and on the machine.
        const Eigen::Matrix3d& turn = motion.setup.part_to_machine;
        const Vec3 shift = turn * origin_ + motion.setup.clamp;
        Json columns = Json::array();
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i)
                columns.push_back(j < 3 && i < 3    ? turn(i, j)
                                  : j == 3 && i < 3 ? shift[i]
                                                    : (i == j ? 1.0 : 0.0));
        content_.head["machine"] = {{"word", machine.word},
                                    {"rotary", std::move(rotary)},
                                    {"part_to_machine", std::move(columns)}};
    }

    Json deviation()
    {
        const std::vector<std::size_t> chosen =
            extremes(deviation_->left_mm, most_deviation_points_drawn);
        std::vector<float> points;
        std::vector<float> left;
        for (const std::size_t k : chosen) {
            const float* at = deviation_->point_mm.data() + 3 * k;
            push(points, {at[0], at[1], at[2]});
            left.push_back(deviation_->left_mm[k]);
        }
        Json shown{{"points", array_json(content_.numbers.add(points))},
                   {"left_mm", array_json(content_.numbers.add(left))},
                   {"tolerance_mm", number_in_summaries("tolerance_mm")},
                   {"scallop_mm", number_in_summaries("scallop_limit_mm")},
                   {"mark_mm", box_.size() / 150},
                   {"worst", worst_places()}};
        if (chosen.size() < deviation_->left_mm.size())
            shown["note"] = fmt::format(
                "The remaining stock is drawn at {} of {} points: of neighbours the "
                "least "
                "and the greatest.",
                chosen.size(), deviation_->left_mm.size());
        return shown;
    }

    // The places that the verdict names.
    Json worst_places() const
    {
        constexpr std::array<std::array<const char*, 3>, 2> kinds{
            {{"max_gouge_at", "max_gouge_mm", "deepest gouge"},
             {"max_scallop_at", "max_scallop_mm", "most remaining stock"}}};
        Json places = Json::array();
        for (const ViewSummary& summary : input_.summaries)
            for (const auto& [at, depth, words] : kinds) {
                const auto place = summary.content.find(at);
                const auto value = summary.content.find(depth);
                if (place == summary.content.end() || !place->is_object() ||
                    value == summary.content.end() || !value->is_number())
                    continue;
                const auto point = place->find("point_mm");
                if (point == place->end() || !point->is_array() || point->size() != 3)
                    continue;
                Vec3 found;
                for (int c = 0; c < 3; ++c)
                    found[c] = (*point)[static_cast<std::size_t>(c)].is_number()
                                   ? (*point)[static_cast<std::size_t>(c)].get<double>()
                                   : 0;
                places.push_back({{"point_mm", vector_of(found - origin_)},
                                  {"text", fmt::format("{}: {} mm", words,
                                                       shown(value->get<double>()))}});
            }
        return places;
    }

    double number_in_summaries(const char* key) const
    {
        for (const ViewSummary& summary : input_.summaries)
            if (const auto found = summary.content.find(key);
                found != summary.content.end() && found->is_number())
                return found->get<double>();
        return 0;
    }

    // The curves of each plane of a table of sections.
    std::vector<std::vector<std::vector<float>>> planes_of(const std::string& file)
    {
        const CsvTable table = read_csv(file, limits());
        if (table.rows() > most_section_points)
            throw LimitError{file + ": " + std::to_string(table.rows()) +
                             " points; a page shows at most " +
                             std::to_string(most_section_points)};
        std::vector<std::vector<std::vector<float>>> planes;
        std::optional<double> last_curve;
        for (std::size_t row = 0; row < table.rows(); ++row) {
            const double plane = table.number(row, "plane").value_or(-1);
            const double curve = table.number(row, "curve").value_or(-1);
            if (!(plane >= 0 && plane < 1e7))
                throw FormatError{"E_CSV",
                                  {file, std::to_string(row + 2), "no plane",
                                   "a number of a plane from 0"}};
            const auto number = static_cast<std::size_t>(plane);
            if (number >= planes.size())
                planes.resize(number + 1);
            if (planes[number].empty() || last_curve != curve)
                planes[number].emplace_back();
            last_curve = curve;
            for (const char* column : {"s_mm", "z_mm"})
                planes[number].back().push_back(
                    static_cast<float>(table.number(row, column).value_or(0)));
        }
        return planes;
    }

    Json sections()
    {
        progress_.begin("reading the sections");
        auto before = planes_of(input_.sections);
        auto after = planes_of(input_.trimmed);
        const std::size_t count = std::max(before.size(), after.size());
        before.resize(count);
        after.resize(count);
        const auto json = [&](const auto& planes) {
            Json list = Json::array();
            for (const auto& curves : planes) {
                Json plane = Json::array();
                for (const auto& curve : curves)
                    plane.push_back(array_json(content_.numbers.add(curve)));
                list.push_back(std::move(plane));
            }
            return list;
        };
        if (count == 0)
            throw FormatError{"E_EMPTY", {input_.sections, "", "no curve", "a section"}};
        return {{"before", json(before)},
                {"after", json(after)},
                {"positions_mm", nullptr},
                {"note", ""}};
    }

    Json sphere()
    {
        progress_.begin("reading the visibility");
        const StoredVisibility stored =
            parse_visibility(read_file(input_.visibility, limits()),
                             shown_path(input_.visibility), limits());
        const VisibilityMap& map = stored.visibility.map;
        if (!mesh_ || mesh_->triangles().size() != map.facets())
            throw DomainError{
                input_.visibility + ": a map of " + counted(map.facets(), "facet") +
                ", and " +
                (mesh_ ? "a part of " + counted(mesh_->triangles().size(), "facet")
                       : std::string{"no part"}) +
                "; expected --part with the part of the setup"};
        const double bits =
            static_cast<double>(map.facets()) * static_cast<double>(map.cells());
        if (bits > most_visibility_bits)
            throw LimitError{input_.visibility + ": " + counted(map.facets(), "facet") +
                             " by " + counted(map.cells(), "direction") +
                             " are more than a page can hold; expected a coarser grid"};
        const SphereGrid grid = sphere_grid(stored.grid);
        const std::size_t words = (map.facets() + 31) / 32;
        std::vector<std::uint32_t> columns;
        columns.reserve(words * map.cells());
        for (std::size_t cell = 0; cell < map.cells(); ++cell)
            for (std::size_t word = 0; word < words; ++word)
                columns.push_back(static_cast<std::uint32_t>(map.column(cell)[word / 2] >>
                                                             (32 * (word % 2))));
        Json sphere{
            {"part", mesh_json(*mesh_, origin_)},
            {"cells", mesh_json(TriangleMesh{grid.corners, grid.cells}, Vec3::Zero())},
            {"words_per_cell", words},
            {"bits", array_json(content_.numbers.add(columns))},
            {"reachable", nullptr}};
        if (const auto directions = machine_directions()) {
            std::vector<std::uint8_t> reachable;
            for (const Vec3& centre : grid.centres)
                reachable.push_back(directions->contains(centre) ? 1 : 0);
            sphere["reachable"] = array_json(content_.numbers.add(reachable));
        }
        return sphere;
    }

    // The directions that the machine of a setup can take, in the frame of the part.
    std::optional<FeasibleDirections> machine_directions() const
    {
        for (const ViewSummary& summary : input_.summaries) {
            const Json& found = summary.content;
            try {
                const auto vector = [&](const char* key) {
                    return Vec3{found.at(key).at(0).get<double>(),
                                found.at(key).at(1).get<double>(),
                                found.at(key).at(2).get<double>()};
                };
                const auto range = [&](const char* key) {
                    return RotaryRange{
                        Angle::degrees(found.at(key).at(0).get<double>()).radians(),
                        Angle::degrees(found.at(key).at(1).get<double>()).radians()};
                };
                const std::string type = found.at("type").get<std::string>();
                if (type != "CA" && type != "AB")
                    continue;
                return FeasibleDirections{
                    {type == "CA" ? RotaryFamily::CA : RotaryFamily::AB,
                     vector("tool_axis"), vector("r1_axis"), vector("r2_axis")},
                    {range("limits_phi_deg"), range("limits_theta_deg")}};
            } catch (const Json::exception&) {
                continue;  // the summary of another command, or of a machine without tilts
            }
        }
        return std::nullopt;
    }

    static std::string text_of(const Json& value)
    {
        if (value.is_string())
            return value.get<std::string>();
        if (value.is_number_float())
            return fmt::format("{:.6g}", value.get<double>());
        if (value.is_null())
            return "none";
        if (value.is_boolean())
            return value.get<bool>() ? "yes" : "no";
        return value.dump();
    }

    Json summaries() const
    {
        constexpr std::size_t longest = 300;
        Json list = Json::array();
        for (const ViewSummary& summary : input_.summaries) {
            Json rows = Json::array();
            for (const auto& [key, value] : summary.content.items()) {
                const std::string text = text_of(value);
                if (text.size() <= longest)
                    rows.push_back({printable(key), printable(text)});
            }
            list.push_back({{"title", shown_path(summary.file)}, {"rows", rows}});
        }
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
        add("trimmed sections", input_.trimmed);
        add("visibility", input_.visibility);
        add("engagement", input_.engagement);
        return rows;
    }

    Json citations() const
    {
        Json list = Json::array();
        const std::array<std::pair<bool, const char*>, 4> works{
            {{program_.has_value(), "KimChoi"},
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
    ViewContent content_;
    std::optional<Program> program_;
    std::optional<Cutter> cutter_;
    std::optional<TriangleMesh> mesh_;
    std::string part_note_;
    std::size_t whole_facets_ = 0;
    std::optional<DeviationPoints> deviation_;
    Box box_;
    Vec3 origin_ = Vec3::Zero();
};

}  // namespace

ViewContent view_content(const ViewInput& input, const ViewOptions& options,
                         ProgressLine& progress)
{
    return ContentMaker{input, options, progress}.run();
}

}  // namespace endmill
