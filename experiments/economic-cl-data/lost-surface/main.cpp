// SPDX-License-Identifier: GPL-3.0-or-later
// Searches for a surface that has the cells of both tables, and judges what it finds.
//
//   economic-cl-data-lost-surface OUTPUT_FOLDER
//   economic-cl-data-lost-surface OUTPUT_FOLDER CASES.csv [NUMBER COUNT]
//
// The first form is the short run. The second form runs the searches of CASES.csv that have no result in
// OUTPUT_FOLDER yet, or every COUNT-th from NUMBER on, and writes search.csv when all are done.
// Deterministic. Columns: README.md beside this.

#include <cstdio>
#include <cstdlib>
#include <exception>

#include "economic-cl-data/lost-surface/case_runner.h"
#include "endmill/files/output_folder.h"

using namespace endmill;

namespace {

int run_search(const std::filesystem::path& output, const std::filesystem::path& file,
               const Shard& shard)
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
        return run_search(argv[1], argv[2], {std::atoi(argv[3]), std::atoi(argv[4])});
    return 2;
}
