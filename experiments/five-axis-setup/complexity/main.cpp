// SPDX-License-Identifier: GPL-3.0-or-later
// Time of visibility and of the searches for a setup against the triangles of the teapot and
// the directions of the sphere.
//
//   five-axis-setup-complexity OUTPUT_FOLDER
//
// About a minute; measures time, so nothing else should run. Columns: README.md beside this.

#include <cmath>
#include <cstdint>
#include <map>

#include "five-axis-setup/complexity/timed_setup.h"
#include "support/dataset_mesh.h"
#include "support/experiment.h"
#include "support/teapot_tessellations.h"

using namespace endmill;

namespace {

constexpr double budget_s = 0.05;  // time of one measurement

// The quantity whose exponent is computed.
double size_of(const StudiedPart& part, const std::string& sweep)
{
    return static_cast<double>(sweep == "triangles" ? part.visibility.map.facets()
                                                    : part.visibility.map.cells());
}

// Times in s of the paper's search for A,B, by row.
using PaperTimes = std::map<std::string, double>;

// Parts in ascending order of size.
struct Sweep {
    std::string name;  // the quantity that varies
    std::vector<StudiedPart> parts;
};

// Adds one row for each part of the sweep up to the size `most`.
void add_sweep(CsvTable& result, const Sweep& sweep, const SetupWork& work, double most,
               PaperTimes& paper)
{
    double last_size = 0;
    double last_s = 0;
    for (const StudiedPart& part : sweep.parts) {
        const double size = size_of(part, sweep.name);
        if (size > most)
            break;
        const double s = work_s(work, part, budget_s);
        CsvCell exponent;
        if (last_size > 0)
            exponent = std::log(s / last_s) / std::log(size / last_size);
        const auto pairs = static_cast<double>(part.visibility.map.facets() *
                                               part.visibility.map.cells());
        const auto count = static_cast<std::int64_t>(size);
        const std::string at = std::to_string(count) + " " + sweep.name;
        if (work.name == "paper AB")
            paper[at] = s;
        const auto reference = paper.find(at);
        const CsvCell ratio =
            reference == paper.end() ? CsvCell{} : CsvCell{s / reference->second};
        result.add_row({work.name + ", " + at, work.name, sweep.name, count,
                        1e9 * s / pairs, exponent, s, ratio});
        last_size = size;
        last_s = s;
    }
}

}  // namespace

int main(int argc, char** argv)
{
    const std::string name = "five-axis-setup/complexity";
    return run_experiment(argc, argv, name, [](Experiment& run) {
        const std::string grid = run.text("grid");
        const double most_for_set = run.number("most_triangles_for_set");
        const TriangleMesh teapot = dataset_mesh(run.text("mesh"));
        Sweep by_triangles{"triangles", {}};
        for (const double squares : run.numbers("squares_a_patch"))
            by_triangles.parts.push_back(
                studied_part(teapot_of_squares(static_cast<int>(squares) + 1, true), grid,
                             Angle::degrees(90)));
        Sweep by_directions{"directions", {}};
        for (const std::string& finer : run.texts("grids"))
            by_directions.parts.push_back(
                studied_part(teapot, finer, Angle::degrees(90)));

        CsvTable result{{"row", "work", "sweep", "size", "ns_a_pair", "exponent",
                         "seconds", "over_paper_ab"}};
        PaperTimes paper;
        for (const SetupWork& work : setup_works()) {
            const double most = work.name == "set AB" ? most_for_set : 1e9;
            add_sweep(result, by_triangles, work, most, paper);
            add_sweep(result, by_directions, work, 1e9, paper);
        }
        run.write_result(result);
    });
}
