// SPDX-License-Identifier: GPL-3.0-or-later
// The travel of the linear axes at the teapot's best setup on machines of both families.
// Kang & Suh leave linear axes to later work.
//
//   five-axis-setup-linear-travel OUTPUT_FOLDER
//
// Deterministic, under 5 s. Columns and verdicts: README.md beside this.

#include "endmill/files/machining_data.h"
#include "endmill/setup/setup.h"
#include "support/dataset_mesh.h"
#include "support/experiment.h"
#include "support/named_cells.h"
#include "support/studied_part.h"

using namespace endmill;

namespace {

CsvCell answer(Answer given)
{
    return given == Answer::Undecided ? CsvCell{} : word(given == Answer::Yes);
}

// The machine of a file with its travel, but without limits of the rotary axes, so that
// the setup is that of its family.
Machine with_free_rotation(const std::string& name)
{
    Machine machine = moving_machine(read_machine("datasets/machines/" + name + ".json"));
    machine.rotary = widest_limits(machine.configuration);
    return machine;
}

NamedCells travel_cells(const StudiedPart& part, const Machine& machine,
                        double tool_length)
{
    const PartWithCones cones{part.mesh, part.grid, part.visibility};
    const auto at = [&](const Vec3& clamp) {
        return machine_setup(cones, machine, {.mode = SetupMode::Paper},
                             Clamping{clamp, tool_length});
    };
    const MachineSetup at_zero = at({0, 0, 0});
    const Vec3 clamp = at_zero.travel.value().centred_clamp;
    const MachineSetup centred = at(clamp);
    const SetupTravel& travel = centred.travel.value();
    const Vec3 extent = travel.high - travel.low;
    return {{"machine", machine.configuration.word},
            {"travel_x_mm", extent.x()},
            {"travel_y_mm", extent.y()},
            {"travel_z_mm", extent.z()},
            {"clamp_x_mm", clamp.x()},
            {"clamp_y_mm", clamp.y()},
            {"clamp_z_mm", clamp.z()},
            {"within_at_zero", answer(at_zero.within_travel)},
            {"within_centred", answer(centred.within_travel)}};
}

}  // namespace

int main(int argc, char** argv)
{
    const std::string name = "five-axis-setup/linear-travel";
    return run_experiment(argc, argv, name, [](Experiment& run) {
        const double scale = run.number("mm_per_unit");
        const StudiedPart part = studied_part(
            moved(dataset_mesh(run.text("mesh")), scale * Eigen::Matrix3d::Identity()),
            run.text("grid"), Angle::degrees(90));
        CsvTable result{{"row", "machine", "travel_x_mm", "travel_y_mm", "travel_z_mm",
                         "clamp_x_mm", "clamp_y_mm", "clamp_z_mm", "within_at_zero",
                         "within_centred"}};
        for (const std::string& machine : run.texts("machines"))
            add_named(result, machine,
                      travel_cells(part, with_free_rotation(machine),
                                   run.number("tool_length_mm")));
        run.write_result(result);
    });
}
