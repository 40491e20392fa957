// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verify_files.h"

#include <fmt/format.h>

#include "cli/console.h"
#include "cli/path_facts.h"
#include "cli/shown_numbers.h"
#include "endmill/core/text.h"
#include "endmill/figures/deviation_svg.h"
#include "endmill/files/dexel_file.h"
#include "endmill/files/mesh_file.h"
#include "endmill/files/path_file.h"
#include "endmill/files/read_file.h"
#include "endmill/files/result_csv.h"
#include "endmill/files/vtk.h"
#include "endmill/stock/mesh_stock.h"
#include "endmill/stock/stock_engagement.h"

namespace endmill {
namespace {

void replace_earlier_run(OutputFolder& folder)
{
    for (const char* name :
         {"summary.json", "removal.csv", "deviation.vtp", "deviation.svg",
          "histogram.csv", "engagement.csv", "stock.vti", "stock.dexels", "rest.stl"})
        folder.remove_unless_written(name);
}

std::string stock_text(const VerifyResult& result)
{
    const Block& block = result.input.stock.block;
    const std::string box =
        fmt::format("{:g},{:g},{:g},{:g},{:g},{:g}", block.low.x(), block.low.y(),
                    block.low.z(), block.high.x(), block.high.y(), block.high.z());
    return result.input.stock.file.empty() ? "block " + box
                                           : result.options.stock + " within " + box;
}

// Captions with the cutter, the resolution, the bounds and the broken rules.
std::vector<std::string> figure_captions(const VerifyResult& result)
{
    const Deviation& deviation = result.verification.on_part->deviation;
    const auto [gouge, scallop] = refined_bounds(deviation, result.input.limits);
    std::string between = "; not refined, since a gouge is certain";
    if (gouge)
        between = fmt::format(
            ", refined where in doubt; between rays a gouge is at most {:.3g} mm deeper",
            deviation.gouge_bound_mm);
    if (gouge && scallop)
        between += fmt::format(", a scallop at most {:.3g} mm higher",
                               deviation.scallop_bound_mm);
    std::vector<std::string> captions{fmt::format(
        "{}; rays {:g} mm apart{}", cutter_words(result.task.cutter, result.input.tools),
        result.options.resolution, between)};
    if (deviation.inaccessible_area_mm2 > 0)
        captions.push_back(fmt::format(
            "not judged: {} mm2 that the cutter cannot touch, with up to {} mm remaining",
            shown(deviation.inaccessible_area_mm2),
            shown(deviation.max_inaccessible_mm)));
    for (const std::string& rule : broken_rules(result.verification))
        captions.push_back("verdict " +
                           std::string{verdict_name(result.verification.verdict)} + ": " +
                           rule);
    return captions;
}

void write_deviation(const VerifyResult& result, const PartCharts& charts,
                     OutputFolder& folder)
{
    const Deviation& deviation = result.verification.on_part->deviation;
    folder.write("deviation.vtp", deviation_vtp(charts, deviation));
    DeviationFigure figure;
    figure.title = result.input.name + ": deviation after the cut, seen along -z";
    figure.captions = figure_captions(result);
    figure.limits = result.input.limits;
    folder.write("deviation.svg", deviation_svg(charts, deviation, figure));
    folder.write("histogram.csv",
                 deviation_histogram_csv(deviation, result.input.limits));
}

// Cuts the stock a second time, since the engagement of a move needs the stock before it.
void write_engagement(const VerifyResult& result, const OutputFolder::Sink& sink)
{
    const VerifyStock& before = result.input.stock;
    HeightStock stock = before.kept ? before.kept->heights
                                    : block_stock(before.block, result.task.resolution);
    EngagementCsv csv{sink};
    for_each_engagement(stock, *result.task.path, result.task.cutter,
                        [&](std::size_t number, const Engagement& engagement) {
                            csv.add(number, engagement);
                        });
    csv.finish();
}

void write_dexels(const VerificationTask& task, const DexelStock& dexels,
                  OutputFolder& folder)
{
    // A stock whose moves are not known is refused before the removal.
    if (const auto history = turning_history_of_rest(task))
        folder.write("stock.dexels", dexel_file(dexels, *history));
}

// Adds what identifies the path that was judged, and how it was read.
void add_judged_path(Json& summary, const VerifyInput& input,
                     const VerifyOptions& options)
{
    summary["toolpath_sha256"] =
        content_sha256(read_file(options.path.file, options.common.limits));
    add_reading(summary, options.path);
    if (!options.path.rotary.wrapped.empty())
        summary["wrapped"] = printable(options.path.rotary.wrapped);
    if (!options.path.tools.empty())
        summary["tool_table"] = printable(options.path.tools);
    if (input.machine)
        add_machine_motion(summary, *input.machine);
    if (input.upright_axis)
        summary["upright_axis"] = vector_json(*input.upright_axis);
}

}  // namespace

Json write_verification(const VerifyResult& result, OutputFolder& folder)
{
    const auto& [input, options, task, verification, of_protected] = result;
    replace_earlier_run(folder);
    std::optional<PartCharts> charts;
    if (verification.on_part) {
        charts.emplace(judged_charts(task));
        write_deviation(result, *charts, folder);
    }
    folder.write("removal.csv", removal_csv(verification.removal, input.program.path));
    if (options.engagement)
        folder.write_pieces("engagement.csv", [&](const OutputFolder::Sink& sink) {
            write_engagement(result, sink);
        });
    if (const auto* heights = std::get_if<HeightStock>(&verification.rest)) {
        if (options.write_stock)
            folder.write("stock.vti", stock_vti(*heights, history_of_rest(task)));
        if (options.write_mesh)
            folder.write("rest.stl", mesh_text(stock_mesh(*heights), MeshFormat::Stl));
    }
    if (const auto* dexels = std::get_if<DexelStock>(&verification.rest)) {
        if (options.write_stock)
            write_dexels(task, *dexels, folder);
        if (options.write_mesh)
            folder.write("rest.stl", mesh_text(stock_mesh(*dexels), MeshFormat::Stl));
    }
    Json summary =
        verify_summary({input.name, printable(input.part_path), stock_text(result),
                        task.cutter, input.limits, input.program, input.tools},
                       options, verification, charts ? &*charts : nullptr);
    add_judged_path(summary, input, options);
    if (of_protected) {
        summary["protected"] = printable(input.guard_path);
        summary["protected_max_gouge_mm"] = of_protected->max_gouge_mm;
        summary["protected_gouge_bound_mm"] =
            finite_or_null(of_protected->gouge_bound_mm);
    }
    if (!input.skip_file.empty())
        summary["skip_facets"] = printable(input.skip_file);
    if (!input.cut_faces.empty())
        summary["cut_faces"] = input.cut_faces;
    if (!input.skip_file.empty() || !input.cut_faces.empty())
        summary["skipped"] = input.skipped.size();
    folder.write("summary.json", summary.dump(2) + "\n");
    return summary;
}

}  // namespace endmill
