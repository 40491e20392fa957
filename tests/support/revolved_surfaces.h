// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "endmill/surface/nurbs.h"
#include "random.h"

// Rational surfaces with closed-form geometry, and random patches.
namespace endmill::test {

/// A rational quadratic arc of the unit circle: the cosines and sines of its control
/// points.
struct UnitArc {
    std::vector<Eigen::Vector2d> points;
    std::vector<double> weights;
    std::vector<double> knots;
};

/// The arc from angle `from` to `to` in rad, in `pieces` pieces of less than half a turn
/// each.
inline UnitArc unit_arc(double from, double to, int pieces = 1)
{
    UnitArc arc{{}, {}, {0, 0, 0}};
    const double half = (to - from) / (2 * pieces);
    for (int k = 0; k <= 2 * pieces; ++k) {
        const double angle = from + k * half;
        const double weight = k % 2 == 0 ? 1 : std::cos(half);
        arc.points.emplace_back(std::cos(angle) / weight, std::sin(angle) / weight);
        arc.weights.push_back(weight);
        if (k % 2 == 1 && k + 1 < 2 * pieces)
            arc.knots.insert(arc.knots.end(), 2, k / 2 + 1.0);
    }
    arc.knots.insert(arc.knots.end(), 3, pieces);
    return arc;
}

/// The ranges in rad of the two angles of a piece of a torus.
struct TorusPiece {
    double around_from;  ///< angle about the axis of revolution
    double around_to;
    double tube_from;  ///< angle about the centre of the tube, from outside upwards
    double tube_to;
    int pieces = 1;  ///< number of patches along each parameter
};

/// A piece of a torus about the z axis: the points ((R + r cos t) cos a, (R + r cos t)
/// sin a, r sin t), where u runs along a and v along t. R = 0 gives a sphere.
inline Nurbs torus(double R, double r, const TorusPiece& piece)
{
    const UnitArc around = unit_arc(piece.around_from, piece.around_to, piece.pieces);
    const UnitArc tube = unit_arc(piece.tube_from, piece.tube_to, piece.pieces);
    Nurbs nurbs{{2, around.knots}, {2, tube.knots}, {}, {}};
    for (std::size_t j = 0; j < tube.points.size(); ++j)
        for (std::size_t i = 0; i < around.points.size(); ++i) {
            const double radius = R + r * tube.points[j].x();
            nurbs.control_points.emplace_back(radius * around.points[i].x(),
                                              radius * around.points[i].y(),
                                              r * tube.points[j].y());
            nurbs.weights.push_back(around.weights[i] * tube.weights[j]);
        }
    return nurbs;
}

/// The cylinder (x, r cos t, r sin t) over 0 <= x <= length; u runs along x and v along
/// t.
inline Nurbs cylinder(double r, double length, double from, double to, int pieces = 1)
{
    const UnitArc arc = unit_arc(from, to, pieces);
    Nurbs nurbs{{1, {0, 0, 1, 1}}, {2, arc.knots}, {}, {}};
    for (std::size_t j = 0; j < arc.points.size(); ++j)
        for (const double x : {0.0, length}) {
            nurbs.control_points.emplace_back(x, r * arc.points[j].x(),
                                              r * arc.points[j].y());
            nurbs.weights.push_back(arc.weights[j]);
        }
    return nurbs;
}

/// A random patch of the given degrees around a regular grid of spacing 10 mm; a rational
/// one has weights from 0.5 to 2.
inline BezierPatch random_patch(unsigned seed, int degree_u, int degree_v, bool rational,
                                double disorder = 4)
{
    Random random{seed};
    std::vector<Vec3> net;
    std::vector<double> weights;
    for (int j = 0; j <= degree_v; ++j)
        for (int i = 0; i <= degree_u; ++i) {
            const double x = 10 * i + random.uniform(-disorder, disorder);
            const double y = 10 * j + random.uniform(-disorder, disorder);
            net.emplace_back(x, y, random.uniform(-disorder, disorder));
            if (rational)
                weights.push_back(random.uniform(0.5, 2));
        }
    return BezierPatch{degree_u, degree_v, net, weights};
}

}  // namespace endmill::test
