// SPDX-License-Identifier: GPL-3.0-or-later
// Random paths that cover five surfaces, against the lower bound of their length.
//
//   economy-bound-attack OUTPUT_FOLDER
//
// Deterministic. Columns: README.md beside this.

#include <algorithm>
#include <limits>
#include <string>

#include "economy/bound-attack/covering_paths.h"
#include "endmill/bound/path_bound.h"
#include "endmill/core/parallel.h"
#include "endmill/surface/tool_side.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

// The ratios of all paths of a kind to the bound.
struct Ratios {
    double least = std::numeric_limits<double>::infinity();
    double sum = 0;
    std::int64_t shorter = 0;

    void add(double ratio)
    {
        least = std::min(least, ratio);
        sum += ratio;
        shorter += ratio < 1 ? 1 : 0;
    }
};

struct Attack {
    std::string name;
    const CoverTask& task;
    PathBound contact;
    PathBound tip;
};

PathBound bound_of(const Surface& surface, BoundProblem problem, BoundedLength length)
{
    problem.length = length;
    return path_bound({&surface, 1}, tool_side_signs({&surface, 1}, Vec3::UnitZ()),
                      problem);
}

// What a path is compared with: the bound for its own number of pieces.
double least_length(const PathBound& bound, std::int64_t pieces)
{
    return bound.density_mm - static_cast<double>(pieces) * bound.disc_mm;
}

std::vector<RandomCover> random_covers(const CoverTask& task, PathKind kind,
                                       std::size_t count, std::uint64_t seed)
{
    std::vector<RandomCover> covers(count);
    parallel_for(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            std::mt19937_64 engine{seed + 1000 * static_cast<std::uint64_t>(kind) + k};
            covers[k] = task.random_cover(kind, engine);
        }
    });
    return covers;
}

void add_kind(CsvTable& paths, CsvTable& result, const Attack& attack, PathKind kind,
              const std::vector<RandomCover>& covers)
{
    const std::string word{path_kind_name(kind)};
    Ratios contact;
    Ratios tip;
    double over_density = std::numeric_limits<double>::infinity();
    for (const RandomCover& cover : covers) {
        const double by_contact = least_length(attack.contact, cover.pieces);
        const double by_tip = least_length(attack.tip, cover.pieces);
        contact.add(cover.contact_mm / by_contact);
        tip.add(cover.tip_mm / by_tip);
        over_density =
            std::min(over_density, cover.contact_mm / attack.contact.density_mm);
        paths.add_row({attack.name, word, cover.pitch_mm, cover.pieces, cover.contact_mm,
                       by_contact, cover.contact_mm / by_contact, cover.tip_mm, by_tip,
                       cover.tip_mm / by_tip});
    }
    const auto count = static_cast<double>(covers.size());
    result.add_row({attack.name + " " + word, attack.name, word,
                    static_cast<std::int64_t>(covers.size()),
                    std::string{bound_grade_name(attack.contact.grade)}, contact.shorter,
                    contact.least, contact.sum / count, over_density, tip.shorter,
                    tip.least, tip.sum / count});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "economy/bound-attack", [](Experiment& run) {
        const BoundProblem problem{BallCutter{run.number("diameter_mm") / 2},
                                   run.number("scallop_mm")};
        const auto count = static_cast<std::size_t>(run.number("paths_of_a_kind"));
        const auto seed = static_cast<std::uint64_t>(run.number("seed"));
        CsvTable paths{{"surface", "kind", "pitch_mm", "pieces", "contact_mm",
                        "contact_bound_mm", "contact_over_bound", "tip_mm",
                        "tip_bound_mm", "tip_over_bound"}};
        CsvTable result{{"row", "surface", "kind", "paths", "grade", "shorter_by_contact",
                         "least_contact_over_bound", "mean_contact_over_bound",
                         "least_contact_over_density", "shorter_by_tip",
                         "least_tip_over_bound", "mean_tip_over_bound"}};
        for (const std::string& name : run.texts("surfaces")) {
            const Surface surface = dataset_surface(name);
            const CoverTask task{surface, problem.cutter, problem.scallop_height};
            const Attack attack{name, task,
                                bound_of(surface, problem, BoundedLength::Contact),
                                bound_of(surface, problem, BoundedLength::Tip)};
            for (const PathKind kind : every_path_kind)
                add_kind(paths, result, attack, kind,
                         random_covers(task, kind, count, seed));
        }
        run.write("paths.csv", paths.text());
        run.write_result(result);
    });
}
