// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/ray_blocking.h"

#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Geometry>

#include <CGAL/Exact_rational.h>

#include "endmill/core/answer.h"

namespace endmill {
namespace {

// How a ray is tested: a filter in doubles, and rational numbers where the filter fails.
//
// The ray meets the inside of the facet if the facet's corners turn about the direction
// in one sense, and if the facet lies ahead of the centroid: four signs of determinants.
// The filter computes each sign with a bound of its error. If a sign is uncertain,
// `exact_answer` computes all of them by rational numbers. It also decides the special
// cases in which a sign is 0: the ray meets an edge or a corner, lies in the facet's
// plane, or starts in it.

using Rational = CGAL::Exact_rational;
using ExactVector = std::array<Rational, 3>;
using Corners = std::array<Vec3, 3>;

// Half a unit in the last place of 1.
constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

// A vector with a bound of the error of each component.
struct RoundedVector {
    Vec3 value;
    double error;

    double size() const { return value.cwiseAbs().maxCoeff() + error; }
};

// The sign of the determinant of three vectors, or nothing if it is uncertain.
//
// The determinant has six products of three components. The errors of the factors change
// each product by at most the term in brackets. Each product passes 2 multiplications, 1
// subtraction and 2 additions, which is 5 roundings of at most 6 X Y Z. The factors 6 and
// 30 are rounded up to 8 and 40.
std::optional<int> certain_sign(const RoundedVector& x, const RoundedVector& y,
                                const RoundedVector& z)
{
    const double X = x.size();
    const double Y = y.size();
    const double Z = z.size();
    const double determinant = x.value.dot(y.value.cross(z.value));
    const double doubt = 8 * (x.error * Y * Z + X * y.error * Z + X * Y * z.error) +
                         40 * unit_roundoff * X * Y * Z +
                         std::numeric_limits<double>::min();
    if (!std::isfinite(determinant))  // overflow: the sign means nothing
        return {};
    if (determinant > doubt)
        return 1;
    if (determinant < -doubt)
        return -1;
    return {};
}

// The answer by signs that rounding cannot have changed. The vectors from the centroid to
// the corners are multiplied by 3, which avoids the division.
Answer certain_answer(const Corners& from, const Vec3& direction, const Corners& facet)
{
    const Vec3 sum = from[0] + from[1] + from[2];
    double largest = 0;
    for (int k = 0; k < 3; ++k)
        largest = std::max(
            {largest, from[k].cwiseAbs().maxCoeff(), facet[k].cwiseAbs().maxCoeff()});
    // In roundings of `largest`: 3 for 3 a, 2 + 3 for the sum, 6 for their difference.
    const double error = 16 * unit_roundoff * largest;
    std::array<RoundedVector, 3> to;
    for (int k = 0; k < 3; ++k)
        to[k] = {3 * facet[k] - sum, error};

    int around = 0;
    for (int k = 0; k < 3; ++k) {
        const std::optional<int> side =
            certain_sign({direction, 0}, to[k], to[(k + 1) % 3]);
        if (!side)
            return Answer::Undecided;
        around += *side;
    }
    if (around != 3 && around != -3)
        return Answer::No;
    const std::optional<int> depth =
        certain_sign(to[0], {facet[1] - facet[0], error}, {facet[2] - facet[0], error});
    if (!depth)
        return Answer::Undecided;
    return answer_of(*depth * around > 0);
}

ExactVector exact(const Vec3& vector)
{
    return {Rational{vector.x()}, Rational{vector.y()}, Rational{vector.z()}};
}

ExactVector difference(const ExactVector& a, const ExactVector& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

ExactVector cross(const ExactVector& a, const ExactVector& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0]};
}

Rational dot(const ExactVector& a, const ExactVector& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

int sign(const Rational& value)
{
    return static_cast<int>(CGAL::sign(value));
}

// Tests whether the ray along `direction` meets the side from a to b. Ray and side lie in
// a plane with this normal, and a and b are offsets from the origin of the ray.
bool meets_side(const ExactVector& direction, const ExactVector& normal,
                const ExactVector& a, const ExactVector& b)
{
    const auto turn = [&](const ExactVector& from, const ExactVector& to) {
        return sign(dot(normal, cross(from, to)));
    };
    const int side_a = turn(direction, a);
    const int side_b = turn(direction, b);
    if (side_a * side_b > 0)
        return false;
    if (side_a == 0 && side_b == 0)
        return sign(dot(direction, a)) >= 0 || sign(dot(direction, b)) >= 0;
    const ExactVector along = difference(b, a);
    return turn(a, along) * turn(direction, along) >= 0;
}

bool exact_answer(const Corners& from, const Vec3& direction, const Corners& facet)
{
    const ExactVector along = exact(direction);
    std::array<ExactVector, 3> to;
    for (int k = 0; k < 3; ++k)
        for (int axis = 0; axis < 3; ++axis)
            to[k][axis] = 3 * Rational{facet[k][axis]} - Rational{from[0][axis]} -
                          Rational{from[1][axis]} - Rational{from[2][axis]};
    bool is_left = false;
    bool is_right = false;
    for (int k = 0; k < 3; ++k) {
        const int side = sign(dot(along, cross(to[k], to[(k + 1) % 3])));
        is_left = is_left || side > 0;
        is_right = is_right || side < 0;
    }
    if (is_left && is_right)
        return false;
    const ExactVector normal = cross(difference(to[1], to[0]), difference(to[2], to[0]));
    // All three sides are 0: the ray lies in the facet's plane.
    if (!is_left && !is_right)
        return meets_side(along, normal, to[0], to[1]) ||
               meets_side(along, normal, to[1], to[2]) ||
               meets_side(along, normal, to[2], to[0]);
    return sign(dot(to[0], normal)) * (is_left ? 1 : -1) >= 0;
}

}  // namespace

bool blocks_ray(const Corners& from, const Vec3& direction, const Corners& facet)
{
    const Answer answer = certain_answer(from, direction, facet);
    return answer == Answer::Undecided ? exact_answer(from, direction, facet)
                                       : answer == Answer::Yes;
}

}  // namespace endmill
