// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace endmill {

/// The answer to a question that a computation of bounded accuracy or effort may leave
/// undecided. Every function of the library that can end without a proof returns this
/// type, or an enum of its own if the answers have names in the field (such as a verdict
/// on a path).
enum class Answer : std::uint8_t {
    No,         ///< proved: it does not hold
    Yes,        ///< proved: it holds
    Undecided,  ///< neither was proved at the accuracy or within the effort allowed
};

/// The answer `Yes` if `holds`, else `No`.
constexpr Answer answer_of(bool holds)
{
    return holds ? Answer::Yes : Answer::No;
}

}  // namespace endmill
