// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace endmill {

/// The largest difference of a printed formula from what it stands for.
struct FormulaError {
    std::string row;     ///< name of the formula, `printed` or `corrected`
    std::int64_t cases;  ///< number of cases
    double worst;        ///< largest relative difference
};

using FormulaErrors = std::vector<FormulaError>;

}  // namespace endmill
