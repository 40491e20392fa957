// SPDX-License-Identifier: GPL-3.0-or-later
#include "economic-cl-data/formulas/circle_formulas.h"

#include <algorithm>
#include <functional>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>

namespace endmill {
namespace {

using Decimal = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>,
                                              boost::multiprecision::et_off>;

// The triangle of the circle's centre, a ball centre and the peak of the scallop, and the lengths of the
// appendix that follow from its angle alpha.
struct Triangle {
    Decimal R, h, rho;
    Decimal alpha;
    Decimal H, q;
};

// Half the angle between neighbouring contacts: the ball through the peak has its centre at distance R.
Decimal half_angle(const Decimal& R, const Decimal& h, const Decimal& rho)
{
    const Decimal centre = abs(rho + R);
    const Decimal peak = abs(rho + h);
    Decimal low = 0;
    Decimal high = boost::math::constants::pi<Decimal>();
    constexpr int halvings = 190;  // 57 decimal digits
    for (int k = 0; k < halvings; ++k) {
        const Decimal middle = (low + high) / 2;
        const Decimal x = centre * sin(middle);
        const Decimal y = centre * cos(middle) - peak;
        (x * x + y * y < R * R ? low : high) = middle;
    }
    return low;
}

Triangle triangle(const ScallopSection& at)
{
    Triangle t{at.radius, at.scallop_height, at.section_radius, {}, {}, {}};
    t.alpha = half_angle(t.R, t.h, t.rho);
    t.H = t.h + t.rho - t.rho * cos(t.alpha);
    t.q = t.H * cos(t.alpha) - t.rho * sin(t.alpha) * sin(t.alpha);
    return t;
}

Decimal true_interval(const Triangle& t)
{
    return 2 * abs(t.rho) * sin(t.alpha);
}

Decimal true_projection(const Triangle& t)
{
    return abs(t.rho) * sin(2 * t.alpha);
}

Decimal interval_of_radicand(const Triangle& t, const Decimal& radicand)
{
    return abs(t.rho) * sqrt(radicand) / ((t.R + t.rho) * (t.h + t.rho));
}

// Eq. (4) as printed.
Decimal interval_4(const Triangle& t)
{
    const Decimal sides = t.rho * t.rho + 2 * t.R * t.rho + (t.h + t.rho) * (t.h + t.rho);
    const Decimal product = (t.R + t.rho) * (t.h + t.rho);
    return interval_of_radicand(t, 4 * product * product - sides * sides);
}

// The formula before eq. (15), with `last` for the term that the print has as 4 R^2 h^3.
Decimal interval_15(const Triangle& t, const Decimal& last)
{
    const auto& [R, h, rho, alpha, H, q] = t;
    return interval_of_radicand(
        t, (8 * R * h - 4 * h * h) * rho * rho +
               (8 * R * R * h + 4 * R * h * h - 4 * h * h * h) * rho + last -
               h * h * h * h);
}

// Eq. (5) as printed, with the sign of rho.
Decimal projection_5(const Triangle& t)
{
    const Decimal l = true_interval(t);
    return l * sqrt(4 * t.rho * t.rho - l * l) / (2 * t.rho);
}

// Half the distance of the two points in which the ball meets the plane through the peak.
Decimal true_s(const Triangle& t)
{
    return sqrt(2 * t.R * t.q - t.q * t.q);
}

Decimal sin2(const Triangle& t)
{
    return sin(t.alpha) * sin(t.alpha);
}

// Eq. (12) as printed.
Decimal s_12(const Triangle& t)
{
    const Decimal printed = t.H * cos(t.alpha) - t.q * sin2(t);
    return sqrt(2 * t.R * printed - printed * printed);
}

enum class Shape { Convex, Concave, Any };

struct Formula {
    const char* row;
    Shape shape;
    std::function<Decimal(const Triangle&)> printed;
    std::function<Decimal(const Triangle&)> truth;
};

// The right side of eq. (13) and (14) is zero. Both sides get one more term, so that their difference is
// relative to it.
const Formula formulas[] = {
    {"eq. (4), convex", Shape::Convex, interval_4, true_interval},
    {"eq. (4), concave", Shape::Concave, interval_4, true_interval},
    {"eq. (5), convex", Shape::Convex, projection_5, true_projection},
    {"eq. (5), concave", Shape::Concave, projection_5, true_projection},
    {"q before eq. (11)", Shape::Any,
     [](const Triangle& t) {
         return (t.H - t.rho * sin(t.alpha) * tan(t.alpha)) * cos(t.alpha);
     },
     [](const Triangle& t) { return t.q; }},
    {"eq. (11), first form", Shape::Convex,
     [](const Triangle& t) { return (t.rho + t.q) * tan(t.alpha); }, true_s},
    {"eq. (11)", Shape::Convex,
     [](const Triangle& t) { return (t.H + t.rho * cos(t.alpha)) * sin(t.alpha); },
     true_s},
    {"S before eq. (12)", Shape::Any,
     [](const Triangle& t) {
         const Decimal cosine = (t.R - t.q) / t.R;
         return t.R * sqrt(1 - cosine * cosine);
     },
     true_s},
    {"eq. (12), printed", Shape::Convex, s_12, true_s},
    {"eq. (13)", Shape::Any,
     [](const Triangle& t) {
         return (t.rho * t.rho + 2 * t.R * t.rho) * sin2(t) -
                2 * t.R * t.H * cos(t.alpha) + t.H * t.H + t.rho * t.rho * sin2(t);
     },
     [](const Triangle& t) { return t.rho * t.rho * sin2(t); }},
    {"eq. (14)", Shape::Any,
     [](const Triangle& t) {
         return t.rho * t.rho + 2 * t.R * t.rho + (t.h + t.rho) * (t.h + t.rho);
     },
     [](const Triangle& t) { return 2 * (t.R + t.rho) * (t.h + t.rho) * cos(t.alpha); }},
    {"formula before eq. (15), printed", Shape::Convex,
     [](const Triangle& t) { return interval_15(t, 4 * t.R * t.R * t.h * t.h * t.h); },
     true_interval},
    {"formula before eq. (15), corrected", Shape::Convex,
     [](const Triangle& t) { return interval_15(t, 4 * t.R * t.R * t.h * t.h); },
     true_interval},
    {"eq. (16)", Shape::Concave,
     [](const Triangle& t) { return -(t.H + t.rho * cos(t.alpha)) * sin(t.alpha); },
     true_s},
    {"eq. (17), printed", Shape::Concave,
     [](const Triangle& t) { return true_s(t) / (t.q * t.q); }, true_s},
    {"eq. (17), corrected", Shape::Concave,
     [](const Triangle& t) {
         const Decimal q = t.H * cos(t.alpha) - t.rho * sin2(t);
         return sqrt(2 * t.R * q - q * q);
     },
     true_s},
};

bool has_shape(const ScallopSection& at, Shape shape)
{
    return shape == Shape::Any || (at.section_radius > 0) == (shape == Shape::Convex);
}

double relative_difference(const Decimal& value, const Decimal& truth)
{
    return Decimal{abs(value - truth) / abs(truth)}.convert_to<double>();
}

// Largest difference of eq. (4) from the interval on a plane, on sections that are nearly flat.
FormulaError plane_limit(std::span<const ScallopSection> sections)
{
    FormulaError error{"limit of eq. (4) on a plane", 0, 0};
    constexpr double nearly_flat = 1e16;  // mm; the difference is about R / rho
    for (const ScallopSection& at : sections) {
        const Triangle flat{at.radius, at.scallop_height, nearly_flat, {}, {}, {}};
        const Decimal plane = 2 * sqrt(2 * flat.R * flat.h - flat.h * flat.h);
        error.worst = std::max(error.worst, relative_difference(interval_4(flat), plane));
        ++error.cases;
    }
    return error;
}

}  // namespace

FormulaErrors interval_formula_errors(std::span<const ScallopSection> sections)
{
    FormulaErrors errors;
    for (const Formula& formula : formulas) {
        FormulaError error{formula.row, 0, 0};
        for (const ScallopSection& at : sections) {
            if (!has_shape(at, formula.shape))
                continue;
            const Triangle t = triangle(at);
            error.worst = std::max(
                error.worst, relative_difference(formula.printed(t), formula.truth(t)));
            ++error.cases;
        }
        errors.push_back(error);
    }
    errors.push_back(plane_limit(sections));
    return errors;
}

FormulaErrors step_formula_errors(std::span<const StepCase> steps)
{
    FormulaError chord{"eq. (1)", 0, 0};
    FormulaError projected{"eq. (2)", 0, 0};
    FormulaError sagitta{"sagitta of eq. (1)", 0, 0};
    for (const StepCase& step : steps) {
        const Decimal rho = step.curve_radius;
        const Decimal delta = step.chord_tolerance;
        const Decimal L = 2 * sqrt(2 * rho * delta - delta * delta);
        const Decimal D = L * (1 - delta / rho);
        // The circle touches the x axis at the start of the step and has its centre at (0, rho).
        const Decimal angle = 2 * acos(1 - delta / rho);
        const Decimal x = rho * sin(angle);
        const Decimal y = rho * (1 - cos(angle));
        chord.worst = std::max(chord.worst, relative_difference(L, sqrt(x * x + y * y)));
        projected.worst = std::max(projected.worst, relative_difference(D, x));
        const Decimal depth = rho - sqrt(rho * rho - L * L / 4);
        sagitta.worst = std::max(sagitta.worst, relative_difference(depth, delta));
        ++chord.cases;
        ++projected.cases;
        ++sagitta.cases;
    }
    return {chord, projected, sagitta};
}

}  // namespace endmill
