// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/detail/collinear.h"

#include <array>
#include <cmath>
#include <limits>

namespace endmill {
namespace {

// Shewchuk's ccwerrboundA: the rounding of the determinant below, as a share of the sum of
// its products' sizes.
constexpr double unit = std::numeric_limits<double>::epsilon() / 2;
constexpr double determinant_rounding = (3 + 16 * unit) * unit;
// Added to it where products may have lost digits because they are so small.
constexpr double underflow = std::numeric_limits<double>::min();

// A sum of doubles without rounding, as terms of which each is below the last digit of
// the next: zero only if all are.
class ExactSum {
public:
    void add_product(double a, double b)
    {
        const double product = a * b;
        add(std::fma(a, b, -product));
        add(product);
    }

    bool is_zero() const { return count_ == 0; }

private:
    // Shewchuk's GROW-EXPANSION, without the terms that are zero.
    void add(double term)
    {
        int kept = 0;
        for (int k = 0; k < count_; ++k) {
            const double sum = term + terms_[k];
            const double virtual_term = sum - terms_[k];
            const double rounding =
                (term - virtual_term) + (terms_[k] - (sum - virtual_term));
            term = sum;
            if (rounding != 0)
                terms_[kept++] = rounding;
        }
        if (term != 0)
            terms_[kept++] = term;
        count_ = kept;
    }

    std::array<double, 12> terms_{};  // six products
    int count_ = 0;
};

// Whether (b - a) x (c - a) has a component along the axis that i and j are not.
bool turns(const Vec3& a, const Vec3& b, const Vec3& c, int i, int j)
{
    const double u = b[i] - a[i];
    const double v = b[j] - a[j];
    const double s = c[i] - a[i];
    const double t = c[j] - a[j];
    const double left = u * t;
    const double right = v * s;
    if (std::abs(left - right) >
        determinant_rounding * (std::abs(left) + std::abs(right)) + underflow)
        return true;
    if ((u == 0 || t == 0) && (v == 0 || s == 0))
        return false;
    ExactSum determinant;
    determinant.add_product(b[i], c[j]);
    determinant.add_product(-b[j], c[i]);
    determinant.add_product(a[j], c[i]);
    determinant.add_product(-a[i], c[j]);
    determinant.add_product(a[i], b[j]);
    determinant.add_product(-a[j], b[i]);
    return !determinant.is_zero();
}

}  // namespace

bool are_collinear(const Vec3& a, const Vec3& b, const Vec3& c)
{
    return !turns(a, b, c, 0, 1) && !turns(a, b, c, 1, 2) && !turns(a, b, c, 2, 0);
}

}  // namespace endmill
