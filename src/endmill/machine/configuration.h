// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// \file
/// Machine words such as W/caxyBz/T: their reading, the tool directions that their axes
/// allow, and the number of different words.
///
/// A word lists the axes of a machine from the workpiece W to the tool T. The letters x,
/// y, z are linear axes, a, b, c are rotary axes about +X, +Y, +Z, and B is the bed. Axes
/// before B move the part, axes after B move the tool. Upper and lower case differ: b is
/// an axis.
/// Source: [KangSuh, section 3]; docs/methods/five-axis-setup.md, section 2.

namespace endmill {

/// The two shapes that the tool directions of a five-axis machine form on the sphere.
/// Source: [KangSuh, section 3].
enum class RotaryFamily {
    CA,  ///< the first rotary axis is C: two opposite sectors about the pole
    AB  ///< A and B in either order: a rectangle between meridians and parallels about R1
};

/// The side of the bed on which an axis lies.
enum class MachineSide {
    Table,  ///< between workpiece and bed: the axis turns the part
    Head    ///< between bed and tool: the axis turns the tool
};

/// A rotary axis of a machine. Its direction holds while all other axes stand at zero.
struct RotaryAxis {
    char letter;       ///< 'a', 'b' or 'c': an axis about +X, +Y or +Z
    MachineSide side;  ///< of the bed

    /// Compares letter and side.
    friend bool operator==(const RotaryAxis&, const RotaryAxis&) = default;
};

/// The axes of a machine and the tool directions that they allow.
///
/// The tool axis is +Z if all axes are at zero. The possible directions do not depend on
/// linear axes or on the place of the bed.
/// Source: [KangSuh, section 3]; its list of words is corrected in
/// docs/methods/five-axis-setup.md, section 2.
struct MachineConfiguration {
    std::string word = "W/xyBz/T";  ///< the word that `configuration_from_word` read
    std::vector<RotaryAxis> rotary = {};  ///< R1, the axis nearest to the part, then R2
    int rank = 0;  ///< dimension of the set of tool directions: 0, 1 or 2
    std::optional<RotaryFamily> family{};  ///< set if rank is 2, and only then

    int axes() const { return 3 + static_cast<int>(rotary.size()); }  ///< 3, 4 or 5

    /// Returns true if every rotary axis adds one dimension to the set of tool
    /// directions.
    bool is_valid() const { return rank == axes() - 3; }
};

/// Finds the first error of a machine word.
///
/// A word reads W/, then the axes from workpiece to tool, then /T. It holds x, y, z and
/// the bed B once each, and at most two different letters of a, b, c.
/// \param word any text.
/// \return a message such as "B, the bed, is missing", or nothing if the word can be
///         read.
std::optional<std::string> configuration_fault(std::string_view word);

/// Reads a machine word. The machine may be valid or not; see
/// MachineConfiguration::is_valid.
/// \param word such as "W/caxyBz/T".
/// \throws DomainError if `configuration_fault` finds an error.
MachineConfiguration configuration_from_word(std::string_view word);

/// The machine that represents a family: "W/caBxyz/T" for C,A and "W/abBxyz/T" for A,B.
/// Both rotary axes carry the part.
MachineConfiguration configuration_of_family(RotaryFamily family);

/// Explains why a configuration is not valid.
/// \return one sentence, or an empty text if the configuration is valid.
std::string why_not_valid(const MachineConfiguration& configuration);

/// The 18 words of two different rotary axes and the bed, such as "caB", without linear
/// axes. They are ordered by the pair of axes (ab, ba, ca, cb, ac, bc), and within a pair
/// by the place of the bed: last, middle, first.
/// Source: [KangSuh, section 3]. The paper lists caB twice and lacks cbB; see
/// docs/methods/five-axis-setup.md, section 7.
std::vector<std::string> rotary_words();

/// Completes a rotary word with linear axes on the tool's side: "caB" becomes
/// "W/caBxyz/T".
/// \param rotary_word one of `rotary_words`.
/// \throws DomainError if it is not one of these.
std::string whole_word(const std::string& rotary_word);

/// Numbers of five-axis words, from all words down to the two families.
struct WordCounts {
    std::size_t words = 0;  ///< words of two different rotary axes, x, y, z and the bed
    std::size_t relative_motions = 0;  ///< different motions of tool against part
    std::size_t rotary_words = 0;      ///< words without the linear axes
    std::size_t valid = 0;             ///< rotary words with two degrees of freedom
    std::size_t families = 0;          ///< different shapes of these on the sphere
};

/// Counts by enumerating every word, in about 1 ms.
///
/// Two words have the same relative motion if they differ only by the place of the bed
/// and by the order of neighbouring linear axes, which commute. There are 162 relative
/// motions; the paper takes this number from Sakamoto and Inasaki without deriving it.
WordCounts count_words();

}  // namespace endmill
