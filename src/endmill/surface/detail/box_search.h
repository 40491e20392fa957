// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <Eigen/Core>

namespace endmill {

/// The least value that a search found, and its place.
struct BoxMinimum {
    Eigen::VectorXd at;  ///< place
    double value;        ///< value there
};

/// A box with sides along the axes.
struct SearchBox {
    Eigen::VectorXd low;   ///< lower ends
    Eigen::VectorXd high;  ///< upper ends
};

/// Minimises `function` by the simplex search of Nelder and Mead. Places outside the box
/// are moved onto it. The search is restarted with a smaller simplex until a restart
/// gains nothing.
///
/// It is a local search without derivatives. At a smooth minimum the value is accurate to
/// about 1e-14 of its size, and the place to about 1e-7.
/// Source: [NelderMead, pp. 308-313].
/// \param function to minimise.
/// \param box limits of the search.
/// \param start in the box.
/// \param step size of the first simplex, in the units of the box.
BoxMinimum minimize_in_box(const std::function<double(const Eigen::VectorXd&)>& function,
                           const SearchBox& box, const Eigen::VectorXd& start,
                           double step);

}  // namespace endmill
