// SPDX-License-Identifier: GPL-3.0-or-later
// Points of passes that are divided into straight moves by breadth-first search, exact and
// quick, and by the greedy method, with the same test of moves.
//
//   economy-segmentation OUTPUT_FOLDER
//
// Deterministic but for the times. Columns: README.md beside this.

#include <array>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "endmill/core/text.h"
#include "endmill/planning/detail/segmentation.h"
#include "endmill/strategy/detail/covered_part.h"
#include "endmill/strategy/detail/reach.h"
#include "endmill/surface/tool_side.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

// Shares of the scallop height: how high the ball of a pass covers beside it, and by how much
// a move may miss that. They are those with which the strategies divide.
constexpr double covered_share = 0.98;
constexpr double slack_share = 0.02;

// The places of the ball on one pass, and the points that it must reach at each.
struct DensePass {
    std::vector<Vec3> centres;
    std::vector<std::array<Vec3, 3>> demands;
};

// A parameter line, and at how many places it is sampled.
struct SampledLine {
    Parameter along;
    double share;  // of the range of the other parameter
    std::size_t samples;
};

// What passes are divided for.
struct Cut {
    BallCutter ball;
    double height;     // scallop height, mm
    double tolerance;  // inner tolerance, mm
};

struct Division {
    std::size_t moves = 0;
    std::size_t tested = 0;
    double seconds = 0;
};

double cpu_s()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// The parameter line in equal steps.
DensePass parameter_line(const Surface& surface, double side, const SampledLine& line,
                         const Cut& cut)
{
    const auto& [along, share, samples] = line;
    const double R = cut.ball.radius();
    const double covered = covered_share * cut.height;
    const double half_width = std::sqrt(covered * (2 * R - covered));
    const Interval us = surface.range(Parameter::U);
    const Interval vs = surface.range(Parameter::V);
    DensePass pass;
    for (std::size_t k = 0; k < samples; ++k) {
        const double way = static_cast<double>(k) / static_cast<double>(samples - 1);
        const bool is_u = along == Parameter::U;
        const SurfaceTangents at =
            surface.tangents(std::lerp(us.low, us.high, is_u ? way : share),
                             std::lerp(vs.low, vs.high, is_u ? share : way));
        const Vec3 normal = side * at.du.cross(at.dv).normalized();
        const Vec3 across = normal.cross(is_u ? at.du : at.dv).normalized();
        const Vec3 raised = at.point + covered * normal;
        pass.centres.push_back(at.point + R * normal);
        pass.demands.push_back(
            {raised, raised + half_width * across, raised - half_width * across});
    }
    return pass;
}

// Whether a move is clear and reaches the demands of all places that it passes.
class DivisionTest {
public:
    DivisionTest(const CoveredPart& part, const DensePass& pass, const Cut& cut)
        : part_{part},
          pass_{pass},
          radius_{cut.ball.radius()},
          slack_{slack_share * cut.height}
    {
    }

    bool is_feasible(std::size_t from, std::size_t to)
    {
        ++tested_;
        return reaches(from, to) &&
               part_.is_clear(pass_.centres[from], pass_.centres[to], state_);
    }

    std::size_t size() const { return pass_.centres.size(); }
    std::size_t tested() const { return tested_; }

private:
    bool reaches(std::size_t from, std::size_t to) const
    {
        const UprightSweep sweep{pass_.centres[from], pass_.centres[to]};
        for (std::size_t k = from; k <= to; ++k)
            for (const Vec3& point : pass_.demands[k])
                if (beyond_reach(sweep.squared_distance(point), radius_) > slack_)
                    return false;
        return true;
    }

    const CoveredPart& part_;
    const DensePass& pass_;
    double radius_;
    double slack_;
    MoveTestState state_;
    std::size_t tested_ = 0;
};

// Each move leads as far as the moves one sample longer remain feasible.
std::size_t greedy_moves(DivisionTest& test)
{
    std::size_t moves = 0;
    for (std::size_t at = 0; at + 1 < test.size(); ++moves) {
        std::size_t to = at + 1;
        while (to + 1 < test.size() && test.is_feasible(at, to + 1))
            ++to;
        at = to;
    }
    return moves;
}

// The fewest moves. Neighbouring samples are always joined.
std::size_t breadth_first_moves(DivisionTest& test, std::size_t kept)
{
    SegmentationOptions options;
    options.kept_candidates = kept;
    const auto division = fewest_moves(
        test.size(), PassShape::Open,
        [&](std::size_t from, std::size_t to) {
            return to == from + 1 || test.is_feasible(from, to);
        },
        options);
    return division.value().moves;
}

struct Method {
    const char* name;
    std::function<std::size_t(DivisionTest& test)> moves;
};

const std::array methods{
    Method{"greedy", greedy_moves},
    Method{"quick", [](DivisionTest& test) { return breadth_first_moves(test, 8); }},
    Method{"exact", [](DivisionTest& test) { return breadth_first_moves(test, 0); }}};

void add_surface(CsvTable& result, const std::string& name, const Cut& cut, int lines,
                 std::size_t samples)
{
    const std::vector<Surface> surfaces{dataset_surface(name)};
    const Part part = surfaces;
    const CoveredPart covered{part, cut.ball, {cut.tolerance, cut.height}};
    const double side = tool_side_signs(surfaces, Vec3::UnitZ()).front();
    std::array<Division, methods.size()> divisions;
    for (const Parameter along : {Parameter::U, Parameter::V})
        for (int line = 0; line < lines; ++line) {
            const DensePass pass = parameter_line(
                surfaces.front(), side, {along, (line + 0.5) / lines, samples}, cut);
            for (std::size_t k = 0; k < methods.size(); ++k) {
                DivisionTest test{covered, pass, cut};
                const double begin = cpu_s();
                divisions[k].moves += methods[k].moves(test);
                divisions[k].seconds += cpu_s() - begin;
                divisions[k].tested += test.tested();
            }
        }
    const auto greedy = static_cast<double>(divisions.front().moves);
    for (std::size_t k = 0; k < methods.size(); ++k) {
        const auto& [moves, tested, seconds] = divisions[k];
        result.add_row({name + " " + to_text(cut.tolerance) + " " + methods[k].name, name,
                        cut.tolerance, std::string{methods[k].name},
                        static_cast<std::int64_t>(moves),
                        100 * (1 - static_cast<double>(moves) / greedy),
                        static_cast<std::int64_t>(tested), seconds});
    }
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "economy/segmentation", [](Experiment& run) {
        const BallCutter ball{run.number("diameter_mm") / 2};
        const double height = run.number("scallop_mm");
        const std::vector<double> tolerances = run.numbers("inner_tolerances_mm");
        const int lines = static_cast<int>(run.number("lines"));
        const auto samples = static_cast<std::size_t>(run.number("samples_a_line"));
        CsvTable result{{"row", "surface", "inner_tolerance_mm", "method", "moves",
                         "saved_percent", "tested_moves", "cpu_s"}};
        for (const std::string& name : run.texts("surfaces"))
            for (const double tolerance : tolerances)
                add_surface(result, name, {ball, height, tolerance}, lines, samples);
        run.write_result(result);
    });
}
