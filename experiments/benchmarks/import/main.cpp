// SPDX-License-Identifier: GPL-3.0-or-later
// Time of an import beside that of OpenCASCADE's own reader and mesher, with the bar.
//
//   benchmarks-import OUTPUT_FOLDER
//
// About 20 s; measures time, so nothing else should run. Columns: README.md beside this.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <BRepMesh_IncrementalMesh.hxx>
#include <STEPControl_Reader.hxx>

#include <sys/resource.h>

#include "benchmarks/import/model_of_faces.h"
#include "endmill/core/error.h"
#include "endmill/import/cad_import.h"
#include "endmill/job/child_process.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

// Processor time in s of this process and of its children that have ended.
double processor_seconds()
{
    double sum = 0;
    for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage used{};
        getrusage(who, &used);
        for (const timeval& time : {used.ru_utime, used.ru_stime})
            sum += static_cast<double>(time.tv_sec) +
                   1e-6 * static_cast<double>(time.tv_usec);
    }
    return sum;
}

template <typename Work>
double seconds_of(const Work& work)
{
    const double begin = processor_seconds();
    work();
    return processor_seconds() - begin;
}

// OpenCASCADE by itself, in this process.
void read_and_mesh(const std::string& file, const CadImportOptions& options)
{
    STEPControl_Reader reader;
    if (reader.ReadFile(file.c_str()) != IFSelect_RetDone)
        throw OutputError{"OpenCASCADE does not read " + file};
    reader.TransferRoots();
    const BRepMesh_IncrementalMesh mesh{reader.OneShape(), options.chord_tolerance_mm,
                                        Standard_False,
                                        options.angle_deg * std::numbers::pi / 180};
}

void import_faces(const std::string& file, const CadImportOptions& options)
{
    const CadPart part = import_cad(ENDMILL_CAD_PROGRAM, file, options);
    require(part.faces.size() == ModelOfFaces::faces,
            "benchmarks/import: need all faces");
    part_of_cad(part, file);
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "benchmarks/import", [](Experiment& run) {
        const PrivateFolder folder{run.output()};
        const std::string file = (folder.path() / "faces.step").string();
        ModelOfFaces::write(file);
        CadImportOptions options;
        options.chord_tolerance_mm = run.number("chord_tolerance_mm");
        CadImportOptions measured = options;
        measured.measures = true;
        const auto rounds = static_cast<int>(run.number("rounds"));

        double alone = HUGE_VAL;
        double part = HUGE_VAL;
        double imported = HUGE_VAL;
        double whole = HUGE_VAL;
        const std::string tolerance = run.text("chord_tolerance_text");
        for (int k = 0; k < rounds; ++k) {
            alone = std::min(alone, seconds_of([&] { read_and_mesh(file, options); }));
            part = std::min(part, seconds_of([&] { import_faces(file, options); }));
            imported =
                std::min(imported, seconds_of([&] { import_faces(file, measured); }));
            whole = std::min(
                whole, seconds_of([&] {
                    run_child(
                        {.program = ENDMILL_PROGRAM,
                         .arguments = {"import", file, "--chord-tolerance", tolerance,
                                       "-o", (folder.path() / "out").string(), "--force"},
                         .environment = minimal_environment(folder.path())});
                }));
        }
        CsvTable result{{"row", "measured", "unit", "bar_at_most"}};
        result.add_row({"OpenCASCADE's reader and mesher", alone, "s", {}});
        result.add_row({"import as a part", part, "s", {}});
        result.add_row({"import with measures of the faces", imported, "s", {}});
        result.add_row({"a part, by OpenCASCADE", part / alone, "times", 1.5});
        result.add_row({"with measures, by OpenCASCADE", imported / alone, "times", 1.5});
        result.add_row({"endmill import with all its files", whole, "s", {}});
        run.write_result(result);
    });
}
