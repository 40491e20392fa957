// SPDX-License-Identifier: GPL-3.0-or-later
// endmill.cutting_coefficients.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

#include "arrays.h"
#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/process/ball_engagement.h"
#include "endmill/process/cutting_coefficients.h"
#include "long_call.h"
#include "module.h"

namespace endmill::python {
namespace {

PreviousPass previous_of(const std::string& word)
{
    if (word == "pass")
        return PreviousPass::Beside;
    if (word == "none")
        return PreviousPass::None;
    if (word == "edge")
        return PreviousPass::Edge;
    throw DomainError{"previous: found " + word + "; expected pass, none or edge"};
}

ChipModel chip_of(const std::string& word)
{
    if (word == "paper")
        return ChipModel::Paper;
    if (word == "exact")
        return ChipModel::Exact;
    throw DomainError{"chip: found " + word + "; expected paper or exact"};
}

// Between blocks of this many cuts an interrupt ends the call.
constexpr std::size_t block = 1000;

py::array_t<double> coefficients(const py::object& mu_deg, const py::object& lambda_deg,
                                 const py::object& pick_feed_ratio,
                                 const py::object& depth_ratio,
                                 const std::string& previous, const std::string& chip,
                                 double accuracy)
{
    const std::array<std::pair<const py::object&, const char*>, 4> given{
        {{mu_deg, "mu_deg"},
         {lambda_deg, "lambda_deg"},
         {pick_feed_ratio, "pick_feed_ratio"},
         {depth_ratio, "depth_ratio"}}};
    py::list arrays;
    for (const auto& [values, name] : given)
        arrays.append(double_array(values, name));
    const py::sequence all =
        py::module_::import("numpy").attr("broadcast_arrays")(*arrays);
    const DoubleArray mu = double_array(all[0], "mu_deg");
    const DoubleArray lambda = double_array(all[1], "lambda_deg");
    const DoubleArray pick = double_array(all[2], "pick_feed_ratio");
    const DoubleArray depth = double_array(all[3], "depth_ratio");
    std::vector<BallEngagement> cuts(static_cast<std::size_t>(mu.size()));
    for (std::size_t k = 0; k < cuts.size(); ++k)
        cuts[k] = {Angle::degrees(mu.data()[k]).radians(),
                   Angle::degrees(lambda.data()[k]).radians(), pick.data()[k],
                   depth.data()[k], previous_of(previous)};
    const ChipModel model = chip_of(chip);
    std::vector<CuttingCoefficients> found;
    found.reserve(cuts.size());
    const std::span<const BallEngagement> all_cuts{cuts};
    const auto add = [&](std::size_t begin) {
        const auto part = cutting_coefficients(
            all_cuts.subspan(begin, std::min(block, cuts.size() - begin)), model,
            accuracy);
        found.insert(found.end(), part.begin(), part.end());
    };
    if (cuts.size() > block) {
        long_call(py::none(), [&](Progress& progress) {
            for (std::size_t begin = 0; begin < cuts.size(); begin += block) {
                add(begin);
                progress.report(0);
            }
        });
    } else if (!cuts.empty()) {
        const py::gil_scoped_release release;
        add(0);
    }
    return moved<double>(std::move(found), shape_with(mu, 8));
}

}  // namespace

void add_process(py::module_& module)
{
    module.def(
        "cutting_coefficients", &coefficients, py::arg("mu_deg"), py::arg("lambda_deg"),
        py::arg("pick_feed_ratio"), py::arg("depth_ratio"), py::arg("previous") = "pass",
        py::arg("chip") = "paper", py::arg("accuracy") = coefficient_accuracy,
        R"(Cutting action coefficients I1 to I8 of a ball-end mill, an array (..., 8).

mu_deg: slope of the pick feed, lambda_deg: slope of the feed, both within 90 degrees.
pick_feed_ratio and depth_ratio: in radii of the ball. The four are numbers or arrays that can
be broadcast together. previous: "pass" (a parallel pass), "none" (full slot) or "edge". chip:
"paper" or "exact". accuracy: 1e-12 to 1e-3, bound of the error of a coefficient.
Raises DomainError for values out of range.
Source: Park and Maeng, eq. (2), appendices A and B, misprints corrected.)");
}

}  // namespace endmill::python
