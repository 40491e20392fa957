// SPDX-License-Identifier: GPL-3.0-or-later
// The visibility cones and the best setups of the teapot with the shank and the holder of
// a tool. Kang & Suh leave the volume of the tool to later work.
//
//   five-axis-setup-tool-volume OUTPUT_FOLDER
//
// Deterministic, under 20 s. Columns and verdicts: README.md beside this.

#include <cmath>
#include <string>
#include <vector>

#include "endmill/files/machining_data.h"
#include "five-axis-setup/tool-volume/body_cells.h"
#include "support/dataset_mesh.h"
#include "support/experiment.h"
#include "support/studied_part.h"

using namespace endmill;

namespace {

// A part of the tool that must not touch the part.
struct Body {
    std::string name;
    std::vector<ToolCylinder> cylinders;
};

std::vector<Body> bodies_of(const Tool& tool)
{
    return {
        {"no body", {}}, {"shank", tool.shank}, {"shank and holder", tool_body(tool)}};
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "five-axis-setup/tool-volume", [](Experiment& run) {
        CsvTable result{{"row", "accessible_entries", "lost_percent", "empty_cones",
                         "left_by_best_direction", "ca_area_deg2", "ab_area_deg2"}};
        const TriangleMesh teapot = dataset_mesh(run.text("mesh"));
        const Tool tool = read_tool("datasets/tools/" + run.text("tool"));
        const std::string grid = run.text("grid");
        for (const double scale : run.numbers("mm_per_unit")) {
            const StudiedPart bare =
                studied_part(moved(teapot, scale * Eigen::Matrix3d::Identity()), grid,
                             Angle::degrees(90));
            const std::string at = std::to_string(std::lround(scale)) + " mm a unit, ";
            for (const Body& body : bodies_of(tool)) {
                StudiedPart part = bare;
                if (!body.cylinders.empty())
                    keep_reachable(part.visibility, part.mesh, part.grid.centres,
                                   body.cylinders);
                add_named(result, at + body.name, body_cells(part, bare));
            }
        }
        run.write_result(result);
    });
}
