// SPDX-License-Identifier: GPL-3.0-or-later
// Searches for a surface that has the cells of both tables, and judges what was found.
//
//   economic-cl-data-lost-surface OUTPUT_FOLDER
//   economic-cl-data-lost-surface OUTPUT_FOLDER CASES.csv [NUMBER COUNT]
//
// The first form is the short run, under 20 s. The second form runs the searches of CASES.csv that have no
// result in OUTPUT_FOLDER yet, or every COUNT-th from NUMBER on; the form without NUMBER writes
// search.csv when all are done. Deterministic. Columns: README.md beside this.

#include <cstdio>
#include <exception>
#include <string>

#include "economic-cl-data/lost-surface/case_runner.h"
#include "economic-cl-data/lost-surface/short_run.h"
#include "endmill/files/output_folder.h"

using namespace endmill;

namespace {

const char* const name = "economic-cl-data/lost-surface";

int run_search(const std::filesystem::path& output, const std::filesystem::path& file,
               const CaseShard& shard)
{
    try {
        const std::vector<SearchCase> cases = read_cases(file);
        const std::filesystem::path folder = output / "cases";
        run_missing_cases(cases, shard, folder);
        if (shard.count == 1) {
            OutputFolder results{output, FullFolder::Accept};
            results.write("search.csv", collected_results(cases, folder).text());
            results.publish();
        }
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "economic-cl-data-lost-surface: error: %s\n", error.what());
        return 1;
    }
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc == 3)
        return run_search(argv[1], argv[2], {});
    if (argc == 5)
        return run_search(argv[1], argv[2], {std::stoi(argv[3]), std::stoi(argv[4])});
    return run_experiment(argc, argv, name, [](Experiment& run) {
        CsvTable result = short_result(run);
        add_best_surfaces(result, run,
                          std::filesystem::path{"experiments"} / name / "best.csv");
        run.write_result(result);
    });
}
