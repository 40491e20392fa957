// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/bound_problem.h"

#include <cmath>

#include "endmill/core/error.h"

namespace endmill {

void require_valid(const BoundProblem& problem)
{
    const double R = problem.cutter.radius();
    require(0 < problem.scallop_height && problem.scallop_height < R,
            "BoundProblem: need 0 < scallop height < cutter radius");
    require(0 <= problem.stray && problem.stray <= R,
            "BoundProblem: need 0 <= stray <= cutter radius");
    require(problem.most_pieces >= 1, "BoundProblem: need at least one piece");
}

double plane_half_width(const BoundProblem& problem)
{
    const double h = problem.scallop_height;
    const double gamma = problem.stray;
    return std::sqrt((gamma + h) * (2 * problem.cutter.radius() + gamma - h));
}

}  // namespace endmill
