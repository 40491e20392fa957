// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "endmill/trimming/detail/wrong_curves.h"
#include "support/experiment.h"

namespace endmill {

/// The counts of each family, and below them the reference counts of
/// docs/methods/interference.md, section 9, which params.json lists.
class FamilyTable {
public:
    explicit FamilyTable(Experiment& run);

    /// Adds the family `name`. \param stated the reference counts in params.json.
    void add(const std::string& name, std::span<const TrimmingTrial> trials,
             const std::string& stated);

    /// The same for the methods as printed, without the sentence that + - + is a twist.
    void add_without_three_runs(const std::string& name,
                                std::span<const TrimmingTrial> trials,
                                const std::string& stated);

    const CsvTable& table() const { return table_; }

private:
    void add_stated(const std::string& name, const std::string& stated);

    Experiment& run_;
    CsvTable table_;
};

}  // namespace endmill
