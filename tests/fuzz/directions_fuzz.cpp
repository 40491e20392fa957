// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "endmill/core/angle.h"
#include "endmill/files/input_csv.h"
#include "endmill/setup/pose_search.h"
#include "fuzz_program.h"

namespace endmill {
namespace {

/// The rotary limits of the machine, in rad.
constexpr RotaryLimits some_limits{{-0.5, 1.9}, {-0.7, 0.6}};

/// Largest number of directions; the slowest fit then takes some ms.
constexpr std::size_t most_fitted = 40;

void check_range(const RotaryRange& range)
{
    constexpr double angle_rounding = 1e-12;
    program_must(range.from <= 0 && range.to >= 0);
    program_must(range.to - range.from <= 2 * std::numbers::pi + angle_rounding);
}

void check_fit(const FittedPose& fit)
{
    program_must(std::isfinite(fit.area) && fit.area >= 0);
    check_range(fit.phi);
    check_range(fit.theta);
    for (const Vec3& axis : {fit.pose.tool_axis, fit.pose.r1_axis, fit.pose.r2_axis})
        program_must(std::abs(axis.norm() - 1) < 1e-9);
}

// The steps of `endmill setup --points`.
void fit_all(const std::vector<Vec3>& directions)
{
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB})
        for (const RotaryLimits& limits : {RotaryLimits{}, some_limits}) {
            double least = std::numeric_limits<double>::infinity();
            for (const SetupMode mode :
                 {SetupMode::PaperLiteral, SetupMode::Paper, SetupMode::Corrected}) {
                const PoseSearchResult search =
                    pose_fit(Vec3::UnitZ(), directions, {family, mode, limits});
                program_must(!search.feasible || search.least);
                program_must(search.least || mode != SetupMode::Corrected);
                if (search.least)
                    check_fit(*search.least);
                if (search.feasible)
                    check_fit(*search.feasible);
                if (mode == SetupMode::Paper && search.least)
                    least = search.least->area;
                if (mode == SetupMode::Corrected)
                    program_must(search.least->area <= least * (1 + 1e-7) + 1e-12);
            }
        }
}

}  // namespace
}  // namespace endmill

// Directions that are read are unit vectors, and every mode fits them; the range of the
// corrected mode is never larger than that of the paper's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace endmill;
    const std::string_view text{reinterpret_cast<const char*>(bytes), size};
    try {
        std::vector<Vec3> directions = parse_directions(text, "f.csv");
        for (const Vec3& direction : directions)
            program_must(std::abs(direction.norm() - 1) < 1e-9);
        directions.resize(std::min(directions.size(), most_fitted));
        fit_all(directions);
    } catch (const FormatError& error) {
        program_must(error.file() == "f.csv" && is_fit_for_a_terminal(error.what()));
    } catch (const LimitError&) {
    }
    return 0;
}
