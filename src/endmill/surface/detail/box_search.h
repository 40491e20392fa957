// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <Eigen/Core>

namespace endmill {

/// Least value that a search found, and where.
struct BoxMinimum {
    Eigen::VectorXd at;
    double value;
};

/// A box with sides along the axes.
struct SearchBox {
    Eigen::VectorXd low;
    Eigen::VectorXd high;
};

/// Minimises `function` from `start` by the simplex search of Nelder and Mead, steps
/// outside `box` being pulled back onto it; restarted until a restart gains nothing.
/// A local search: it needs no derivatives, and where the minimum is smooth its value is
/// right to about 1e-14 of its size, its place to about 1e-7.
///
/// \param step size of the first simplex, in the units of the box.
BoxMinimum minimize_in_box(const std::function<double(const Eigen::VectorXd&)>& function,
                           const SearchBox& box, const Eigen::VectorXd& start,
                           double step);

}  // namespace endmill
