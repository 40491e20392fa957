// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "support/named_cells.h"
#include "support/stated_loads.h"

namespace endmill {

/// `stated_loads` with the R_m of each move that its torque gives (PeakRule::Torque).
std::vector<CuttingLoads> torque_stated_loads(const std::vector<MilledMove>& moves,
                                              const MillingJob& job);

/// True peaks of moves over stated ones. Moves in air do not count.
class PeakRatios {
public:
    /// \param peaks of the turning flutes. \param stated by the expressions.
    PeakRatios(const std::vector<MilledMove>& moves,
               const std::vector<CuttingLoads>& peaks,
               const std::vector<CuttingLoads>& stated);

    /// Share of the length in percent on which true and stated force differ by at most
    /// `tolerance` of the stated one.
    double within_percent(double tolerance) const;

    /// Quantile of true over stated force, over the length.
    double force_quantile(double share) const;

    /// Whether the mean of true over stated thrust is larger where the feed goes down
    /// than where it goes up.
    bool is_thrust_understated_downhill() const;

    /// within_percent and ratio_5, ratio_50, ratio_95, ratio_greatest.
    NamedCells force_cells(double tolerance) const;

    /// thrust_downhill and thrust_uphill, means of true over stated thrust over the
    /// length, and thrust_understated_downhill.
    NamedCells thrust_cells() const;

private:
    double mean_thrust(bool is_downhill) const;

    std::vector<double> lengths_;  // mm
    std::vector<double> slopes_;   // lambda, rad
    std::vector<double> forces_;   // true over stated
    std::vector<double> thrusts_;  // true over stated
};

/// Share of the length in percent on which a true force peak exceeds the tool's limit by
/// more than 2 %.
double over_percent(const std::vector<MilledMove>& moves,
                    const std::vector<CuttingLoads>& peaks, const MillingJob& job);

/// What holds in every data set with one rule of R_m.
struct Extremes {
    double least_within = 100;   ///< least within_percent
    double greatest_over = 0;    ///< greatest over_percent
    bool is_understated = true;  ///< the thrust is understated downhill everywhere

    /// Adds a set.
    void add(const PeakRatios& ratios, double tolerance, double over);

    /// within_percent, over_percent and thrust_understated_downhill.
    NamedCells cells() const;
};

/// Adds the quantiles of the force in steps of one percent: row, share_percent, ratio and
/// set, the name.
void add_quantiles(CsvTable& table, const std::string& name, const PeakRatios& ratios);

}  // namespace endmill
