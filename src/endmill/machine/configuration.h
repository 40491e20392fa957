// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/machine/rotary_limits.h"

namespace endmill {

/// On which side of the bed an axis is.
enum class MachineSide {
    Table,  ///< the part's: it turns the part
    Head    ///< the tool's: it turns the tool
};

/// A rotary axis of a machine, all others at zero.
struct RotaryAxis {
    char letter;       ///< 'a', 'b' or 'c': about +X, +Y or +Z
    MachineSide side;  ///< what it turns

    /// Whether both say the same.
    friend bool operator==(const RotaryAxis&, const RotaryAxis&) = default;
};

/// The axes of a machine in their order from workpiece to tool, and what they can do with the
/// tool axis, which stands at +Z when all are at zero. Linear axes and the bed's place do not
/// change directions. Source: [KangSuh, section 3], its list of words corrected.
struct MachineConfiguration {
    std::string word = "W/xyBz/T";         ///< as `configuration_from_word` reads it
    std::vector<RotaryAxis> rotary = {};   ///< R1, the nearest to the part, then R2
    int rank = 0;                          ///< dimension of the set of tool directions
    std::optional<RotaryFamily> family{};  ///< of two rotary axes, none if not valid

    int axes() const { return 3 + static_cast<int>(rotary.size()); }  ///< 3, 4 or 5

    /// Whether every rotary axis adds a dimension to the tool's directions.
    bool is_valid() const { return rank == axes() - 3; }
};

/// What is wrong with `word`, as in "B, the bed, is missing"; nothing if it reads
/// W/, the axes from workpiece to tool, /T: x, y, z and the bed B once each, and at most two of
/// the rotary a, b, c. Upper and lower case differ: b is an axis.
std::optional<std::string> configuration_fault(std::string_view word);

/// The machine of `word`, valid or not.
/// \throws DomainError unless `configuration_fault` finds nothing.
MachineConfiguration configuration_from_word(std::string_view word);

/// Why a configuration is no machine of its number of axes; empty if it is valid.
std::string why_not_valid(const MachineConfiguration& configuration);

/// The 18 words of two different rotary axes and the bed, such as "caB", by the pair of axes
/// (ab, ba, ca, cb, ac, bc), then the bed last, in the middle and first.
/// Source: [KangSuh, section 3], whose list of the C,A words has caB twice and lacks cbB.
std::vector<std::string> rotary_words();

/// The whole word of one of them, the linear axes on the tool's side: "W/caBxyz/T".
/// \throws DomainError unless `rotary_word` is one of `rotary_words`.
std::string whole_word(const std::string& rotary_word);

/// How many words of five axes there are, and how few of them differ.
struct WordCounts {
    std::size_t words = 0;             ///< of two rotary axes, x, y, z and the bed
    std::size_t relative_motions = 0;  ///< of tool against part: see `count_words`
    std::size_t rotary_words = 0;      ///< without the linear axes
    std::size_t valid = 0;             ///< of those, with two degrees of freedom
    std::size_t families = 0;          ///< of those, shapes on the sphere
};

/// Counts by writing out every word. Two have one relative motion if they differ by the place
/// of the bed and by the order of neighbouring linear axes, which commute; these are the 162
/// kinds that the paper takes from Sakamoto and Inasaki. Some 1 ms.
WordCounts count_words();

}  // namespace endmill
