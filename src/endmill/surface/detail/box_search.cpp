// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/box_search.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace endmill {
namespace {

using Function = std::function<double(const Eigen::VectorXd&)>;

constexpr int most_moves = 2000;
constexpr int most_restarts = 8;
// Width of the simplex, in the units of the box, at which the search stops: the values at
// its corners no longer differ.
constexpr double least_width = 1e-11;
// A restart that gains less than this share is the last one.
constexpr double least_gain = 1e-13;

// The simplex of Nelder and Mead. A move reflects the worst corner at the centre of the
// others. If the new corner is the best one, a step of double length is tried; if it is
// again the worst one, the simplex is contracted at this corner, or as a whole.
class Simplex {
public:
    Simplex(const Function& function, const SearchBox& box)
        : function_{function},
          box_{box}
    {
    }

    BoxMinimum minimize(const Eigen::VectorXd& start, double step)
    {
        corners_ = {evaluate(start)};
        for (Eigen::Index axis = 0; axis < start.size(); ++axis) {
            Eigen::VectorXd corner = start;
            const bool inwards = start[axis] + step <= box_.high[axis];
            corner[axis] += inwards ? step : -step;
            corners_.push_back(evaluate(corner));
        }
        for (int move = 0; move < most_moves; ++move) {
            std::ranges::stable_sort(corners_, {}, &BoxMinimum::value);
            if (width() < least_width)
                break;
            move_worst_corner();
        }
        return *std::ranges::min_element(corners_, {}, &BoxMinimum::value);
    }

private:
    BoxMinimum evaluate(const Eigen::VectorXd& at) const
    {
        Eigen::VectorXd inside = at.cwiseMax(box_.low).cwiseMin(box_.high);
        const double value = function_(inside);
        return {std::move(inside), value};
    }

    double width() const
    {
        double width = 0;
        for (const BoxMinimum& corner : corners_)
            width =
                std::max(width, (corner.at - corners_[0].at).lpNorm<Eigen::Infinity>());
        return width;
    }

    void move_worst_corner()
    {
        BoxMinimum& worst = corners_.back();
        const double second_worst = corners_[corners_.size() - 2].value;
        Eigen::VectorXd centre = Eigen::VectorXd::Zero(worst.at.size());
        for (std::size_t k = 0; k + 1 < corners_.size(); ++k)
            centre += corners_[k].at;
        centre /= static_cast<double>(corners_.size() - 1);

        const auto beyond = [&](double factor) {
            return evaluate(centre + factor * (centre - worst.at));
        };
        BoxMinimum reflected = beyond(1);
        if (reflected.value < corners_[0].value) {
            BoxMinimum expanded = beyond(2);
            worst = std::move(expanded.value < reflected.value ? expanded : reflected);
        } else if (reflected.value < second_worst) {
            worst = std::move(reflected);
        } else {
            BoxMinimum contracted = beyond(reflected.value < worst.value ? 0.5 : -0.5);
            if (contracted.value < std::min(reflected.value, worst.value))
                worst = std::move(contracted);
            else
                shrink();
        }
    }

    void shrink()
    {
        for (std::size_t k = 1; k < corners_.size(); ++k)
            corners_[k] = evaluate((corners_[k].at + corners_[0].at) / 2);
    }

    const Function& function_;
    const SearchBox& box_;
    std::vector<BoxMinimum> corners_;
};

}  // namespace

BoxMinimum minimize_in_box(const Function& function, const SearchBox& box,
                           const Eigen::VectorXd& start, double step)
{
    Simplex simplex{function, box};
    BoxMinimum best = simplex.minimize(start, step);
    for (int restart = 0; restart < most_restarts; ++restart) {
        step /= 4;
        const BoxMinimum again = simplex.minimize(best.at, step);
        const double gain = best.value - again.value;
        if (gain > 0)
            best = again;
        if (!(gain > least_gain * std::abs(best.value)))
            break;
    }
    return best;
}

}  // namespace endmill
