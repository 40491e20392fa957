// SPDX-License-Identifier: GPL-3.0-or-later
// The lower bound by its grade, the spacing of its nodes, the tool, the length that is bounded
// and what a path may stray, with its cost.
//
//   economy-bound OUTPUT_FOLDER
//
// Deterministic but for the times. Columns: README.md beside this.

#include <ctime>
#include <string>
#include <utility>
#include <vector>

#include "endmill/bound/path_bound.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/surface/tool_side.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

// CPU time of all threads since it was made, s.
class CpuTimer {
public:
    double seconds() const
    {
        return static_cast<double>(std::clock() - begin_) / CLOCKS_PER_SEC;
    }

private:
    std::clock_t begin_ = std::clock();
};

// A surface and the problems that are solved on it.
class Study {
public:
    Study(CsvTable& table, std::string name, const BoundProblem& problem)
        : table_{table},
          name_{std::move(name)},
          surface_{dataset_surface(name_)},
          sides_{tool_side_signs({&surface_, 1}, Vec3::UnitZ())},
          problem_{problem}
    {
    }

    void add_grade(BoundGrade grade)
    {
        const std::string word{bound_grade_name(grade)};
        const CpuTimer timer;
        try {
            const PathBound bound =
                grade == BoundGrade::Certified
                    ? certified_bound({&surface_, 1}, sides_, problem_)
                : grade == BoundGrade::Estimated
                    ? estimated_bound({&surface_, 1}, sides_, problem_)
                    : path_bound({&surface_, 1}, sides_, problem_);
            add(word, problem_, bound, timer.seconds());
        } catch (const GeometryError& error) {
            std::vector<CsvCell> row(table_.columns().size());
            row[0] = name_ + " " + word;
            row[1] = name_;
            row.back() = std::string{error.what()};
            table_.add_row(row);
        }
    }

    // An estimate with another problem or other nodes.
    void add_estimate(const std::string& what, const BoundProblem& problem,
                      const EstimateOptions& options = {})
    {
        const CpuTimer timer;
        const PathBound bound = estimated_bound({&surface_, 1}, sides_, problem, options);
        add(what, problem, bound, timer.seconds());
    }

private:
    void add(const std::string& what, const BoundProblem& problem, const PathBound& bound,
             double seconds)
    {
        table_.add_row(
            {name_ + " " + what, name_, std::string{bound_grade_name(bound.grade)},
             std::string{problem.length == BoundedLength::Tip ? "tip" : "contact"},
             std::string{problem.tool == CoveringTool::Ball ? "ball" : "ball and flank"},
             problem.stray, bound.node_spacing_mm, bound.density_mm, bound.disc_mm,
             bound.greatest_inflow, static_cast<std::int64_t>(bound.boxes), seconds,
             std::string{}});
    }

    CsvTable& table_;
    std::string name_;
    Surface surface_;
    std::vector<double> sides_;
    BoundProblem problem_;
};

void add_problems(Study& study, const BoundProblem& usual,
                  const std::vector<double>& strays)
{
    for (const double stray : strays) {
        BoundProblem straying = usual;
        straying.stray = stray;
        study.add_estimate("stray " + to_text(stray), straying);
    }
    BoundProblem tips = usual;
    tips.length = BoundedLength::Tip;
    study.add_estimate("tips", tips);
}

// The ball alone, with nodes at several spacings.
void add_spacings(Study& study, BoundProblem problem, const std::vector<double>& spacings)
{
    problem.tool = CoveringTool::Ball;
    for (const double spacing : spacings) {
        EstimateOptions options;
        options.node_spacing = spacing;
        study.add_estimate("ball, nodes " + to_text(spacing), problem, options);
    }
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "economy/bound", [](Experiment& run) {
        const BoundProblem usual{BallCutter{run.number("diameter_mm") / 2},
                                 run.number("scallop_mm")};
        const std::vector<double> strays = run.numbers("strays_mm");
        CsvTable result{{"row", "surface", "grade", "length", "tool", "stray_mm",
                         "node_spacing_mm", "density_mm", "disc_mm", "greatest_inflow",
                         "boxes", "cpu_s", "refusal"}};
        for (const std::string& name : run.texts("surfaces")) {
            Study study{result, name, usual};
            study.add_grade(BoundGrade::Closed);
            study.add_grade(BoundGrade::Estimated);
            study.add_grade(BoundGrade::Certified);
            add_problems(study, usual, strays);
        }
        Study large{result, run.text("large_surface"), usual};
        large.add_grade(BoundGrade::Estimated);
        add_spacings(large, usual, run.numbers("node_spacings_mm"));
        run.write_result(result);
    });
}
