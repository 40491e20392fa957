// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/detail/nearest_bounds.h"

#include <cstring>
#include <limits>

// A convex part is beyond every plane that is normal to a direction and passes through
// the part's first point along that direction. The bound is the distance to such a plane.
// It holds for every direction, and is close if the direction leads to the nearest point
// of the part: rounding of the direction does no harm.

// GCC compiles the bounds for processors with AVX2 too. All versions give the same bits.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#define ENDMILL_CHOOSES_REGISTERS
#endif

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// The least normal number, added to a squared length so that it is not 0.
constexpr double not_zero = std::numeric_limits<double>::min();
// Share by which a bound is reduced for the rounding of squares.
constexpr double rounding_share = 1e-13;
// (d - margin)^2 is at least d^2 - 2 d margin, and 2 d is at most d^2 / r + r for every r.
// Here r is margin / margin_share: many margins, so that the share of d^2 is small.
constexpr double margin_share = 1e-7;

// Four numbers in two registers of 16 bytes, which every processor has. Everything that uses
// them is inlined, so that it is compiled for the registers of the caller.
class FourInTwo {
public:
    [[gnu::always_inline]] FourInTwo(double value)
        : low_{value, value},
          high_{value, value}
    {
    }
    [[gnu::always_inline]] FourInTwo(double a, double b, double c, double d)
        : low_{a, b},
          high_{c, d}
    {
    }
    [[gnu::always_inline]] explicit FourInTwo(const Eigen::Array4f& floats)
        : FourInTwo{floats[0], floats[1], floats[2], floats[3]}
    {
    }

    [[gnu::always_inline]] std::array<double, 4> numbers() const
    {
        return {low_[0], low_[1], high_[0], high_[1]};
    }

    [[gnu::always_inline]] FourInTwo operator-() const { return {-low_, -high_}; }
    [[gnu::always_inline]] friend FourInTwo operator+(const FourInTwo& a,
                                                      const FourInTwo& b)
    {
        return {a.low_ + b.low_, a.high_ + b.high_};
    }
    [[gnu::always_inline]] friend FourInTwo operator-(const FourInTwo& a,
                                                      const FourInTwo& b)
    {
        return {a.low_ - b.low_, a.high_ - b.high_};
    }
    [[gnu::always_inline]] friend FourInTwo operator*(const FourInTwo& a,
                                                      const FourInTwo& b)
    {
        return {a.low_ * b.low_, a.high_ * b.high_};
    }
    [[gnu::always_inline]] friend FourInTwo operator/(const FourInTwo& a,
                                                      const FourInTwo& b)
    {
        return {a.low_ / b.low_, a.high_ / b.high_};
    }
    [[gnu::always_inline]] friend FourInTwo smaller(const FourInTwo& a,
                                                    const FourInTwo& b)
    {
        return {a.low_ < b.low_ ? a.low_ : b.low_, a.high_ < b.high_ ? a.high_ : b.high_};
    }
    // b where a is no number
    [[gnu::always_inline]] friend FourInTwo larger(const FourInTwo& a, const FourInTwo& b)
    {
        return {a.low_ > b.low_ ? a.low_ : b.low_, a.high_ > b.high_ ? a.high_ : b.high_};
    }

private:
    using Two = double __attribute__((vector_size(2 * sizeof(double))));

    [[gnu::always_inline]] FourInTwo(const Two& low, const Two& high)
        : low_{low},
          high_{high}
    {
    }

    Two low_;
    Two high_;
};

#ifdef ENDMILL_CHOOSES_REGISTERS
// The same in a register of 32 bytes. Without AVX2, GCC would compare them one by one.
class FourInOne {
public:
    [[gnu::always_inline]] FourInOne(double value) : values_{Vector{} + value} {}
    [[gnu::always_inline]] FourInOne(double a, double b, double c, double d)
        : values_{a, b, c, d}
    {
    }
    [[gnu::always_inline]] explicit FourInOne(const Eigen::Array4f& floats)
    {
        FloatVector values;
        std::memcpy(&values, floats.data(), sizeof values);
        values_ = __builtin_convertvector(values, Vector);
    }

    [[gnu::always_inline]] std::array<double, 4> numbers() const
    {
        std::array<double, 4> numbers;
        std::memcpy(numbers.data(), &values_, sizeof values_);
        return numbers;
    }

    [[gnu::always_inline]] FourInOne operator-() const { return FourInOne{-values_}; }
    [[gnu::always_inline]] friend FourInOne operator+(const FourInOne& a,
                                                      const FourInOne& b)
    {
        return FourInOne{a.values_ + b.values_};
    }
    [[gnu::always_inline]] friend FourInOne operator-(const FourInOne& a,
                                                      const FourInOne& b)
    {
        return FourInOne{a.values_ - b.values_};
    }
    [[gnu::always_inline]] friend FourInOne operator*(const FourInOne& a,
                                                      const FourInOne& b)
    {
        return FourInOne{a.values_ * b.values_};
    }
    [[gnu::always_inline]] friend FourInOne operator/(const FourInOne& a,
                                                      const FourInOne& b)
    {
        return FourInOne{a.values_ / b.values_};
    }
    [[gnu::always_inline]] friend FourInOne smaller(const FourInOne& a,
                                                    const FourInOne& b)
    {
        return FourInOne{a.values_ < b.values_ ? a.values_ : b.values_};
    }
    // b where a is no number
    [[gnu::always_inline]] friend FourInOne larger(const FourInOne& a, const FourInOne& b)
    {
        return FourInOne{a.values_ > b.values_ ? a.values_ : b.values_};
    }

private:
    using Vector = double __attribute__((vector_size(4 * sizeof(double))));
    using FloatVector = float __attribute__((vector_size(4 * sizeof(float))));

    [[gnu::always_inline]] explicit FourInOne(const Vector& values) : values_{values} {}

    Vector values_;
};
#endif

// Four points or directions, by coordinate.
template <typename Four>
struct FourVectors {
    std::array<Four, 3> of{0, 0, 0};  // along each axis
};

template <typename Four>
[[gnu::always_inline]] inline Four dot(const FourVectors<Four>& a,
                                       const FourVectors<Four>& b)
{
    return a.of[0] * b.of[0] + a.of[1] * b.of[1] + a.of[2] * b.of[2];
}

// The squared distance to planes. \param along product of the direction and the vector
// from the place to the first point; `square` of the direction's length.
template <typename Four>
[[gnu::always_inline]] inline Four square_to_plane(const Four& along, const Four& square,
                                                   double margin)
{
    const Four ahead = larger(along, 0);
    return (1 - rounding_share - margin_share) * (ahead * (ahead / (square + not_zero))) -
           margin / margin_share * margin;
}

// Boxes, seen from a place.
template <typename Four>
struct SeenBoxes {
    FourVectors<Four> low;
    FourVectors<Four> high;
};

template <typename Four>
[[gnu::always_inline]] inline Four squares_to_boxes(const SeenBoxes<Four>& seen)
{
    Four squares = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const Four away = larger(larger(seen.low.of[axis], -seen.high.of[axis]), 0);
        squares = squares + away * away;
    }
    return (1 - rounding_share) * squares;
}

// The direction leads from the place to its foot on the slab, moved into the box. It is
// the sum of a multiple of the slab's normal, along which the slab limits the part, and a
// rest, along which the box does.
template <typename Four>
[[gnu::always_inline]] inline Four squares_to_slabs(const FourEnclosures& parts,
                                                    const SeenBoxes<Four>& seen,
                                                    const Vec3& place, double margin)
{
    FourVectors<Four> normal;
    for (int axis = 0; axis < 3; ++axis)
        normal.of[axis] = Four{parts.normal[axis]};
    const Four height =
        normal.of[0] * place.x() + normal.of[1] * place.y() + normal.of[2] * place.z();
    const Four low = Four{parts.slab_low} - height;
    const Four high = Four{parts.slab_high} - height;
    const Four to_slab = larger(low, smaller(high, 0));
    FourVectors<Four> direction;
    for (int axis = 0; axis < 3; ++axis)
        direction.of[axis] = smaller(larger(to_slab * normal.of[axis], seen.low.of[axis]),
                                     seen.high.of[axis]);
    const Four share = dot(direction, normal);
    Four along = smaller(share * low, share * high);
    for (int axis = 0; axis < 3; ++axis) {
        const Four rest = direction.of[axis] - share * normal.of[axis];
        along = along + smaller(rest * seen.low.of[axis], rest * seen.high.of[axis]);
    }
    return square_to_plane(along, dot(direction, direction), margin);
}

// One corner of four triangles, seen from a place.
template <typename Four>
[[gnu::always_inline]] inline FourVectors<Four> corners(
    std::span<const Vec3> points, const std::array<Triangle, 4>& triangles, int corner,
    const Vec3& place)
{
    const Vec3& a = points[triangles[0][corner]];
    const Vec3& b = points[triangles[1][corner]];
    const Vec3& c = points[triangles[2][corner]];
    const Vec3& d = points[triangles[3][corner]];
    FourVectors<Four> seen;
    for (int axis = 0; axis < 3; ++axis)
        seen.of[axis] = Four{a[axis], b[axis], c[axis], d[axis]} - place[axis];
    return seen;
}

template <typename Four>
[[gnu::always_inline]] inline std::array<double, 4> squares(const FourEnclosures& parts,
                                                            const Vec3& place,
                                                            double margin, double limit)
{
    SeenBoxes<Four> seen;
    for (int axis = 0; axis < 3; ++axis) {
        seen.low.of[axis] = Four{parts.low[axis]} - place[axis];
        seen.high.of[axis] = Four{parts.high[axis]} - place[axis];
    }
    const Four to_boxes = squares_to_boxes(seen);
    const std::array<double, 4> bounds = to_boxes.numbers();
    int near = 0;
    for (const double bound : bounds)
        near += bound <= limit && bound < infinity ? 1 : 0;
    if (near < 2)
        return bounds;
    // no number for missing parts
    const Four to_slabs = squares_to_slabs(parts, seen, place, margin);
    return larger(to_slabs, to_boxes).numbers();
}

// The direction leads to the centre of a triangle. The box is the better bound for a
// triangle that is large for its distance.
template <typename Four>
[[gnu::always_inline]] inline std::array<double, 4> squares(
    std::span<const Vec3> points, const std::array<Triangle, 4>& triangles,
    const Vec3& place, double margin)
{
    const FourVectors<Four> a = corners<Four>(points, triangles, 0, place);
    const FourVectors<Four> b = corners<Four>(points, triangles, 1, place);
    const FourVectors<Four> c = corners<Four>(points, triangles, 2, place);
    FourVectors<Four> centre;
    Four to_boxes = 0;
    for (int axis = 0; axis < 3; ++axis) {
        centre.of[axis] = a.of[axis] + b.of[axis] + c.of[axis];
        const Four low = smaller(smaller(a.of[axis], b.of[axis]), c.of[axis]);
        const Four high = larger(larger(a.of[axis], b.of[axis]), c.of[axis]);
        const Four away = larger(larger(low, -high) - margin, 0);
        to_boxes = to_boxes + away * away;
    }
    const Four along = smaller(smaller(dot(centre, a), dot(centre, b)), dot(centre, c));
    const Four to_triangles = larger(square_to_plane(along, dot(centre, centre), margin),
                                     (1 - rounding_share) * to_boxes);
    return to_triangles.numbers();
}

#ifdef ENDMILL_CHOOSES_REGISTERS
[[gnu::target("avx2")]] std::array<double, 4> wide_squares(const FourEnclosures& parts,
                                                           const Vec3& place,
                                                           double margin, double limit)
{
    return squares<FourInOne>(parts, place, margin, limit);
}

[[gnu::target("avx2")]] std::array<double, 4> wide_squares(
    std::span<const Vec3> points, const std::array<Triangle, 4>& triangles,
    const Vec3& place, double margin)
{
    return squares<FourInOne>(points, triangles, place, margin);
}

const bool has_wide_registers = __builtin_cpu_supports("avx2") != 0;
#endif

}  // namespace

FourEnclosures::FourEnclosures()
    : slab_low{Eigen::Array4f::Zero()},
      slab_high{Eigen::Array4f::Zero()}
{
    constexpr float none = std::numeric_limits<float>::infinity();
    low.fill(Eigen::Array4f::Constant(none));
    high.fill(Eigen::Array4f::Constant(-none));
    normal.fill(Eigen::Array4f::Zero());
}

Eigen::AlignedBox3d FourEnclosures::box_of(Eigen::Index part) const
{
    return {Vec3{low[0][part], low[1][part], low[2][part]},
            Vec3{high[0][part], high[1][part], high[2][part]}};
}

Vec3 FourEnclosures::normal_of(Eigen::Index part) const
{
    return {normal[0][part], normal[1][part], normal[2][part]};
}

std::array<double, 4> bound_squares(const FourEnclosures& parts, const Vec3& place,
                                    double margin, double limit)
{
#ifdef ENDMILL_CHOOSES_REGISTERS
    if (has_wide_registers)
        return wide_squares(parts, place, margin, limit);
#endif
    return squares<FourInTwo>(parts, place, margin, limit);
}

std::array<double, 4> bound_squares(std::span<const Vec3> points,
                                    const std::array<Triangle, 4>& triangles,
                                    const Vec3& place, double margin)
{
#ifdef ENDMILL_CHOOSES_REGISTERS
    if (has_wide_registers)
        return wide_squares(points, triangles, place, margin);
#endif
    return squares<FourInTwo>(points, triangles, place, margin);
}

}  // namespace endmill
