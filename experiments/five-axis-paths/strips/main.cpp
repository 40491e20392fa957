// SPDX-License-Identifier: GPL-3.0-or-later
// The strip that a leaning cutter cuts on a plane: by curvature, by the section of the
// cutter, and by simulated removal.
//
//   five-axis-paths-strips OUTPUT_FOLDER
//
// Deterministic, about 20 s. Columns and verdicts: README.md beside this.

#include <cmath>
#include <string>

#include "endmill/core/text.h"
#include "endmill/cutter/cutter.h"
#include "endmill/orientation/inclination.h"
#include "endmill/path/tool_path.h"
#include "endmill/surface/nurbs.h"
#include "endmill/verification/verification.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

// Half the strip: what the section of the cutter across the feed reaches at the height h.
// The bottom circle of radius c = R - r, seen along the feed, is an ellipse of half axes c and
// c sin(lead), which the corner thickens by r.
double half_strip(const Cutter& cutter, double lead, double height)
{
    const double c = cutter.flat_radius();
    const double r = cutter.corner_radius();
    const double rise = c * std::sin(lead);
    const auto y_at = [&](double turn) {
        // outward normal of the ellipse at this place
        const Vec3 normal = Vec3{0, rise * std::sin(turn), -c * std::cos(turn)};
        const double length = normal.norm();
        const Vec3 place{0, c * std::sin(turn), rise * (1 - std::cos(turn)) + r};
        return length > 0 ? Vec3{place + r / length * normal} : place;
    };
    if (c == 0)
        return std::sqrt(height * (2 * r - height));
    double low = 0;
    double high = std::acos(0.0);
    for (int step = 0; step < 100; ++step) {
        const double middle = (low + high) / 2;
        (y_at(middle).z() < height ? low : high) = middle;
    }
    return y_at(low).y();
}

// Passes along x over a plane, at the given distance; the tool is lifted between them.
ToolPath passes(const Cutter& cutter, double lead, double apart, int count)
{
    constexpr double length = 24;
    const Vec3 lift{0, 0, 20};
    const Vec3 axis{std::sin(lead), 0, std::cos(lead)};
    ToolPath path;
    const auto add = [&](int pass, Move move, const Vec3& tip) {
        path.points.push_back({.pass = pass,
                               .point = static_cast<int>(path.points.size()),
                               .move = move,
                               .location = {tip, axis}});
    };
    for (int pass = 0; pass < count; ++pass) {
        const double y = (pass - (count - 1) / 2.0) * apart;
        const auto tip_at = [&](double x) {
            return control_point(cutter, {{x, y, 0}, Vec3::UnitZ()}, ControlPoint::Tip,
                                 axis);
        };
        add(pass, Move::Rapid, tip_at(0) + lift);
        add(pass, Move::Plunge, tip_at(0));
        add(pass, Move::Cut, tip_at(length));
        add(pass, Move::Retract, tip_at(length) + lift);
    }
    return path;
}

// What passes leave on a plane, by simulated removal.
struct Left {
    double least;  // mm, for certain
    double most;   // mm
};

Left simulated(const Cutter& cutter, double lead, double apart, double height)
{
    const ToolPath path = passes(cutter, lead, apart, 5);
    const Part part = std::vector<Surface>{
        nurbs_surface({{1, {0, 0, 1, 1}},
                       {1, {0, 0, 1, 1}},
                       {{11, -apart, 0}, {13, -apart, 0}, {11, apart, 0}, {13, apart, 0}},
                       {}})};
    VerificationTask task{.path = &path,
                          .cutter = cutter,
                          .judged = JudgedPart{&part, {0.01, height * 1.01}},
                          .stock = Block{{5, -3 * apart, -1}, {19, 3 * apart, 1}}};
    task.resolution = apart / 16;
    task.engine = RemovalEngine::FiveAxis;
    const Deviation found = verify_path(task).on_part.value().deviation;
    return {found.max_scallop_mm, found.max_scallop_mm + found.scallop_bound_mm};
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "five-axis-paths/strips", [](Experiment& run) {
        CsvTable result{{"row", "cutter", "lead_deg", "scallop_mm", "curvature_mm",
                         "exact_mm", "error_percent", "simulated_mm",
                         "simulated_most_mm"}};
        const double radius = run.number("radius_mm");
        const double simulated_height = run.number("simulated_scallop_mm");
        for (const double corner : run.numbers("corner_radii_mm"))
            for (const double lead_deg : run.numbers("leads_deg"))
                for (const double height : run.numbers("scallops_mm")) {
                    const Cutter cutter{radius, corner};
                    const Angle lead = Angle::degrees(lead_deg);
                    const double by_curvature =
                        strip_width(cutter, {}, {.lead = lead}, height).value();
                    const double exact = 2 * half_strip(cutter, lead.radians(), height);
                    CsvCell least;
                    CsvCell most;
                    if (height == simulated_height) {
                        const Left left =
                            simulated(cutter, lead.radians(), exact, height);
                        least = left.least;
                        most = left.most;
                    }
                    const std::string name = cutter_word(cutter);
                    result.add_row({name + ", lead " + to_text(lead_deg) + ", scallop " +
                                        to_text(height),
                                    name, lead_deg, height, by_curvature, exact,
                                    100 * (by_curvature / exact - 1), least, most});
                }
        run.write_result(result);
    });
}
