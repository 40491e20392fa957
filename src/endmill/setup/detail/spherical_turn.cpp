// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/spherical_turn.h"

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Filtered_predicate.h>
#include <CGAL/determinant.h>

namespace endmill {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using KernelVector = Kernel::Vector_3;

template <class AnyKernel>
struct TurnAbout {
    using result_type = CGAL::Sign;  // NOLINT(readability-identifier-naming): CGAL's name
    using Vector = typename AnyKernel::Vector_3;

    result_type operator()(const Vector& p, const Vector& a, const Vector& b) const
    {
        return CGAL::sign_of_determinant(p.x(), p.y(), p.z(), a.x(), a.y(), a.z(), b.x(),
                                         b.y(), b.z());
    }
};

template <class AnyKernel>
struct TurnAlong {
    using result_type = CGAL::Sign;  // NOLINT(readability-identifier-naming): CGAL's name
    using Vector = typename AnyKernel::Vector_3;

    result_type operator()(const Vector& p, const Vector& a, const Vector& b,
                           const Vector& c) const
    {
        return TurnAbout<AnyKernel>{}(p, b - a, c - a);
    }
};

template <class AnyKernel>
struct OrderAlong {
    using result_type = CGAL::Sign;  // NOLINT(readability-identifier-naming): CGAL's name
    using Vector = typename AnyKernel::Vector_3;

    result_type operator()(const Vector& p, const Vector& line, const Vector& a,
                           const Vector& b) const
    {
        return TurnAbout<AnyKernel>{}(p, line, b - a);
    }
};

template <class AnyKernel>
struct SideOf {
    using result_type = CGAL::Sign;  // NOLINT(readability-identifier-naming): CGAL's name
    using Vector = typename AnyKernel::Vector_3;

    result_type operator()(const Vector& a, const Vector& b) const
    {
        return CGAL::sign(a * b);
    }
};

// Evaluates a predicate with intervals, and with rational numbers if the interval
// contains 0.
template <template <class> class Predicate>
using Exactly = CGAL::Filtered_predicate<Predicate<Kernel::Exact_kernel>,
                                         Predicate<Kernel::Approximate_kernel>,
                                         Kernel::C2E, Kernel::C2F>;

KernelVector kernel_vector(const Vec3& v)
{
    return {v.x(), v.y(), v.z()};
}

}  // namespace

int exact_turn_about(const Vec3& axis, const Vec3& a, const Vec3& b)
{
    return Exactly<TurnAbout>{}(kernel_vector(axis), kernel_vector(a), kernel_vector(b));
}

int exact_turn_along(const Vec3& axis, const Vec3& a, const Vec3& b, const Vec3& c)
{
    return Exactly<TurnAlong>{}(kernel_vector(axis), kernel_vector(a), kernel_vector(b),
                                kernel_vector(c));
}

int exact_order_along(const Vec3& axis, const Vec3& line, const Vec3& a, const Vec3& b)
{
    return Exactly<OrderAlong>{}(kernel_vector(axis), kernel_vector(line),
                                 kernel_vector(a), kernel_vector(b));
}

int exact_side_of(const Vec3& a, const Vec3& b)
{
    return Exactly<SideOf>{}(kernel_vector(a), kernel_vector(b));
}

}  // namespace endmill
