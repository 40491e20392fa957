// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/surface/bezier_patch.h"

namespace endmill::test {

/// The patch with its degree in u raised by one.
inline BezierPatch elevated_in_u(const BezierPatch& patch)
{
    const int degree = patch.degree(Parameter::U) + 1;
    std::vector<Eigen::Vector4d> net;
    for (int j = 0; j <= patch.degree(Parameter::V); ++j)
        for (int i = 0; i <= degree; ++i) {
            const double share = i / double(degree);
            Eigen::Vector4d point = Eigen::Vector4d::Zero();
            if (i > 0)
                point += share * patch.homogeneous_point(i - 1, j);
            if (i < degree)
                point += (1 - share) * patch.homogeneous_point(i, j);
            net.push_back(point);
        }
    return BezierPatch::from_homogeneous(degree, patch.degree(Parameter::V), net,
                                         patch.is_rational());
}

/// The same patch represented with higher degrees. Control points are accurate to a few
/// roundings.
inline BezierPatch elevated(const BezierPatch& patch, int degree_u, int degree_v)
{
    BezierPatch result = patch;
    while (result.degree(Parameter::U) < degree_u)
        result = elevated_in_u(result);
    result = transposed(result);
    while (result.degree(Parameter::U) < degree_v)
        result = elevated_in_u(result);
    return transposed(result);
}

}  // namespace endmill::test
