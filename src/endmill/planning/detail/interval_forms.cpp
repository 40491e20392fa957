// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/interval_forms.h"

#include <cmath>

#include <boost/multiprecision/cpp_dec_float.hpp>

namespace endmill {
namespace {

template <typename Number>
Number radicand(Number R, Number h, Number rho, IntervalForm form)
{
    const Number sides = rho * rho + 2 * R * rho + (h + rho) * (h + rho);
    const Number twice_product = 2 * (R + rho) * (h + rho);
    switch (form) {
        case IntervalForm::Printed:
            return 4 * ((R + rho) * (R + rho)) * ((h + rho) * (h + rho)) - sides * sides;
        case IntervalForm::Squares:
            return twice_product * twice_product - sides * sides;
        case IntervalForm::Factors:
            return (twice_product - sides) * (twice_product + sides);
        case IntervalForm::Expanded:
            break;
    }
    return (8 * R * h - 4 * h * h) * rho * rho +
           (8 * R * R * h + 4 * R * h * h - 4 * h * h * h) * rho + 4 * R * R * h * h -
           h * h * h * h;
}

template <typename Number>
Number interval(const IntervalCase& at, IntervalForm form)
{
    using std::sqrt;
    const Number R{static_cast<Number>(at.radius)};
    const Number h{static_cast<Number>(at.scallop_height)};
    const Number rho{static_cast<Number>(at.section_radius)};
    return rho * sqrt(radicand(R, h, rho, form)) / ((R + rho) * (h + rho));
}

}  // namespace

double printed_interval(const IntervalCase& at, IntervalForm form, Precision precision)
{
    return precision == Precision::Single ? interval<float>(at, form)
                                          : interval<double>(at, form);
}

double interval_in_50_digits(const IntervalCase& at)
{
    using Decimal =
        boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>,
                                      boost::multiprecision::et_off>;
    return interval<Decimal>(at, IntervalForm::Printed).convert_to<double>();
}

}  // namespace endmill
