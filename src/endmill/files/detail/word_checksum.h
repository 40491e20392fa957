// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "endmill/core/error.h"

namespace endmill {

/// A checksum of 64-bit words in their order. A change of any one word changes it; sequences at
/// random share it once in 2^64 pairs. It finds damage, and does not withstand intent.
class WordChecksum {
public:
    static constexpr std::size_t word_bytes = sizeof(std::uint64_t);  ///< of a word

    /// One more word. Each step can be undone, so that no change of a single word is lost.
    void add(std::uint64_t word)
    {
        sum_ = (sum_ ^ word) * 0x9e3779b97f4a7c15U;  // odd: 2^64 by the golden ratio
        sum_ ^= sum_ >> 29U;
    }

    /// The words that these bytes are, in the machine's order.
    /// \throws DomainError unless they are a multiple of 8.
    void add(std::string_view bytes)
    {
        require(bytes.size() % word_bytes == 0, "WordChecksum: need whole words");
        for (std::size_t at = 0; at < bytes.size(); at += word_bytes) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes.data() + at, word_bytes);
            add(word);
        }
    }

    std::uint64_t sum() const { return sum_; }  ///< of the words so far

private:
    std::uint64_t sum_ = 0x243f6a8885a308d3U;  // of pi: nothing has a checksum, too
};

/// So many bytes, and what it takes to make them whole words.
constexpr std::size_t whole_words(std::size_t bytes)
{
    constexpr std::size_t word = WordChecksum::word_bytes;
    return (bytes + word - 1) / word * word;
}

}  // namespace endmill
