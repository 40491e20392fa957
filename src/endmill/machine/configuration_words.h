// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace endmill {

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
