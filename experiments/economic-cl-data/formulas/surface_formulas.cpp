// SPDX-License-Identifier: GPL-3.0-or-later
#include "economic-cl-data/formulas/surface_formulas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "endmill/planning/detail/cross_section.h"
#include "endmill/planning/iso_parametric.h"
#include "endmill/planning/path_interval.h"
#include "endmill/planning/step_length.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

constexpr int samples = 17;  // along each parameter of a patch
constexpr int frames = 9;    // along each parameter of a surface, away from its borders

using Four = std::array<double, 4>;

void add_case(FormulaError& error, double difference)
{
    error.worst = std::max(error.worst, difference);
    ++error.cases;
}

// (1-t)^(3-i) t^i, the factor of the printed sum.
Four powers(double t)
{
    const double s = 1 - t;
    return {s * s * s, s * s * t, s * t * t, t * t * t};
}

Four bernstein(double t)
{
    Four values = powers(t);
    values[1] *= 3;
    values[2] *= 3;
    return values;
}

// U M, with `misprint` for the element in row 3, column 4 of M.
Four matrix_row(double t, double misprint)
{
    const double M[4][4] = {
        {1, 0, 0, 0}, {-3, 3, 0, 0}, {3, -6, 3, misprint}, {-1, 3, -3, 1}};
    Four values{};
    for (int column = 0; column < 4; ++column)
        values[column] =
            M[0][column] + t * (M[1][column] + t * (M[2][column] + t * M[3][column]));
    return values;
}

// Functions of Hermite: values at 0 and 1, then derivatives at 0 and 1.
Four hermite(double t)
{
    return {(1 + 2 * t) * (1 - t) * (1 - t), t * t * (3 - 2 * t), t * (1 - t) * (1 - t),
            t * t * (t - 1)};
}

Vec3 weighted(const BezierPatch& patch, const Four& along_u, const Four& along_v)
{
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            sum += along_u[i] * along_v[j] * patch.control_point(i, j);
    return sum;
}

Vec3 hermite_point(const FergusonPatch& patch, double u, double v)
{
    const Four along_u = hermite(u);
    const Four along_v = hermite(v);
    Vec3 sum = Vec3::Zero();
    for (int b = 0; b < 2; ++b)
        for (int a = 0; a < 2; ++a) {
            const FergusonPatch::Corner& corner = patch.corners[2 * b + a];
            sum += along_u[a] * along_v[b] * corner.point +
                   along_u[2 + a] * along_v[b] * corner.du +
                   along_u[a] * along_v[2 + b] * corner.dv +
                   along_u[2 + a] * along_v[2 + b] * corner.twist;
        }
    return sum;
}

double size_of(const BezierPatch& patch)
{
    double size = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            size = std::max(size, patch.control_point(i, j).cwiseAbs().maxCoeff());
    return size;
}

// Largest distance over the patch between its points and those of `formula`, as a share of its size.
FormulaError patch_error(const std::string& row, const BezierPatch& patch,
                         const std::function<Vec3(double, double)>& formula)
{
    FormulaError error{row, 0, 0};
    const double size = size_of(patch);
    for (int i = 0; i < samples; ++i)
        for (int j = 0; j < samples; ++j) {
            const double u = i / double(samples - 1);
            const double v = j / double(samples - 1);
            add_case(error, (formula(u, v) - patch.jet(u, v).point).norm() / size);
        }
    return error;
}

// A surface whose passes run along u, with the true curvature across the feed, positive where convex.
struct KnownSection {
    Surface surface;
    std::function<double(const FeedFrame&)> curvature;
    bool is_circle;  // the section across the feed is a circle
};

std::vector<KnownSection> known_sections(const ClosedFormSurfaces& surfaces)
{
    constexpr double sphere_radius = 25;
    constexpr double tube_radius = 15;
    constexpr double ring_radius = 40;
    constexpr double saddle_parameter = 32;
    const auto on_ring = [](const FeedFrame& frame) {
        const double from_axis = frame.jet.point.head<2>().norm();
        return (from_axis - ring_radius) / tube_radius / from_axis;
    };
    const auto on_saddle = [](const FeedFrame& frame) {
        const Vec3& along = frame.cross_feed;
        const double steep = std::hypot(1, frame.jet.point.x() / saddle_parameter,
                                        frame.jet.point.y() / saddle_parameter);
        return (along.y() * along.y() - along.x() * along.x()) /
               (saddle_parameter * steep);
    };
    const auto constant = [](double value) {
        return [value](const FeedFrame&) { return value; };
    };
    return {{surfaces.sphere, constant(1 / sphere_radius), true},
            {surfaces.torus, constant(1 / tube_radius), true},
            {transposed(surfaces.torus), on_ring, false},
            {surfaces.saddle, on_saddle, false},
            {transposed(surfaces.saddle), on_saddle, false}};
}

void for_frames(const Surface& surface, const std::function<void(const FeedFrame&)>& use)
{
    const double side = tool_side_sign(surface, Vec3::UnitZ());
    const Interval u = surface.range(Parameter::U);
    const Interval v = surface.range(Parameter::V);
    for (int i = 1; i <= frames; ++i)
        for (int j = 1; j <= frames; ++j) {
            const SurfacePoint at{std::lerp(u.low, u.high, i / (frames + 1.0)),
                                  std::lerp(v.low, v.high, j / (frames + 1.0))};
            use(feed_frame(at, surface.jet(at.u, at.v), side));
        }
}

// Eq. (6), (7) or (9), (10) at the point that satisfies them with T_c in the second equation, and with T_0
// there, as printed: the difference of the second equation's sides as a share of its right side.
void add_check_plane(FormulaError& printed, FormulaError& corrected,
                     const Surface& surface, const FeedFrame& frame, double distance)
{
    const CheckPlanePoint found = check_plane_point(surface, frame, distance);
    if (!found.converged)
        return;
    const Vec3 chord = surface.jet(found.at.u, found.at.v).point - frame.jet.point;
    add_case(printed, std::abs(chord.dot(frame.feed) - distance) / distance);
    add_case(corrected, std::abs(chord.dot(frame.cross_feed) - distance) / distance);
}

constexpr double eps = 0.5;  // mm, of eq. (7); the paper does not print its own

// Spread of the curvatures that eq. (8) gives to points that satisfy eq. (7) and not (6), on the cylinder
// z = -x^2 / 40 with feed along y: these two equations leave one unknown free.
FormulaError without_check_plane()
{
    FormulaError error{"points by eq. (7), (8)", 0, 0};
    const double height = eps * eps / 40;
    const auto curvature = [&](double along) {
        return 2 * height / (eps * eps + along * along + height * height);
    };
    for (int k = 1; k <= frames; ++k)
        add_case(error, 1 - curvature(k * eps / frames) / curvature(0));
    return error;
}

}  // namespace

FormulaErrors patch_formula_errors(const BezierPatch& patch)
{
    const FergusonPatch ferguson = ferguson_from_bezier(patch);
    const BezierPatch back = bezier_from_ferguson(ferguson);
    const auto by_matrix = [&patch](double misprint) {
        return [&patch, misprint](double u, double v) {
            return weighted(patch, matrix_row(u, misprint), matrix_row(v, misprint));
        };
    };
    FormulaErrors errors{
        patch_error(
            "Bezier sum, printed", patch,
            [&](double u, double v) { return weighted(patch, powers(u), powers(v)); }),
        patch_error("Bezier sum, corrected", patch,
                    [&](double u, double v) {
                        return weighted(patch, bernstein(u), bernstein(v));
                    }),
        patch_error("matrix M, printed", patch, by_matrix(1)),
        patch_error("matrix M, corrected", patch, by_matrix(0)),
        patch_error("Ferguson's form", patch,
                    [&](double u, double v) { return hermite_point(ferguson, u, v); }),
        patch_error("Ferguson's form and back", patch,
                    [&](double u, double v) { return back.jet(u, v).point; })};

    // The CL point on a sphere of radius a: the ball's centre lies at distance a + R from the sphere's.
    constexpr double a = 40;
    const BallCutter ball{7.5};
    FormulaError tip{"CL point", 0, 0};
    for (int k = 0; k < samples; ++k) {
        const double angle = k / double(samples - 1);  // rad, from the axis
        const Vec3 normal{std::sin(angle), 0, std::cos(angle)};
        for (const Vec3& axis : {Vec3{0, 0, 1}, Vec3{0.6, 0, 0.8}}) {
            const CutterLocation found = locate(ball, {a * normal, normal}, axis);
            const Vec3 centre = found.tip + ball.radius() * axis;
            add_case(tip, std::abs(centre.norm() / (a + ball.radius()) - 1));
            add_case(tip, (centre - (a + ball.radius()) * normal).norm() / a);
        }
    }
    errors.push_back(tip);
    return errors;
}

FormulaErrors section_formula_errors(const ClosedFormSurfaces& surfaces)
{
    FormulaError exact{"KN1 of the second fundamental form", 0, 0};
    FormulaError circles{"eq. (8), circles", 0, 0};
    FormulaError printed_7{"eq. (6), (7), printed", 0, 0};
    FormulaError corrected_7{"eq. (6), (7), corrected", 0, 0};
    FormulaError printed_10{"eq. (9), (10), printed", 0, 0};
    FormulaError corrected_10{"eq. (9), (10), corrected", 0, 0};
    const BallCutter ball{7.5};
    constexpr double scallop = 0.5;
    for (const KnownSection& known : known_sections(surfaces))
        for_frames(known.surface, [&](const FeedFrame& frame) {
            const double truth = known.curvature(frame);
            // Curvatures may vanish, so the greatest one of the surfaces is the unit: 1/15 per mm.
            add_case(exact, 15 * std::abs(cross_curvature(frame) - truth));
            if (known.is_circle)
                add_case(circles, 15 * std::abs(cross_curvature_by_chord(known.surface,
                                                                         frame, eps) -
                                                truth));
            add_check_plane(printed_7, corrected_7, known.surface, frame, eps);
            add_check_plane(printed_10, corrected_10, known.surface, frame,
                            path_interval(ball, truth, scallop).projected);
        });
    return {exact,
            circles,
            printed_7,
            corrected_7,
            printed_10,
            corrected_10,
            without_check_plane()};
}

double order_of_chord_curvature(const ClosedFormSurfaces& surfaces)
{
    double coarse = 0;
    double fine = 0;
    for (const KnownSection& known : known_sections(surfaces))
        for_frames(known.surface, [&](const FeedFrame& frame) {
            if (known.is_circle)
                return;
            const double truth = known.curvature(frame);
            const auto error = [&](double step) {
                return std::abs(cross_curvature_by_chord(known.surface, frame, step) -
                                truth);
            };
            coarse += error(0.1);  // mm
            fine += error(0.05);
        });
    return std::log2(coarse / fine);
}

FormulaError next_point_error(const Surface& surface)
{
    IsoParametricOptions options;
    options.link.order =
        PassOrder::OneWay;  // each pass in the order in which it was marched
    options.link.safe_height = default_safe_height({&surface, 1}, options.link.axis);
    const BallCutter ball{7.5};
    const ToolPath path = plan_iso_parametric(surface, ball, options).path;
    const double end = surface.range(Parameter::U).high;
    FormulaError error{"eq. (3)", 0, 0};
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        const SurfaceContact* to = path.points[k].contact();
        if (path.points[k].move != Move::Cut || to->u == end)
            continue;  // the end of a pass is no root of eq. (3)
        const SurfaceContact& from = *path.points[k - 1].contact();
        const SurfaceJet jet = surface.jet(from.u, from.v);
        const double step =
            step_length(curve_curvature(jet.du, jet.duu), options.chord_tolerance)
                .projected;
        const Vec3 chord = to->contact.point - from.contact.point;
        add_case(error,
                 std::abs(chord.dot(jet.du.normalized()) - step) / surface.diagonal());
    }
    return error;
}

}  // namespace endmill
