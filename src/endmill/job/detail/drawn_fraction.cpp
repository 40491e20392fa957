// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/drawn_fraction.h"

#include <charconv>
#include <cmath>
#include <string>

#include "endmill/files/path_file.h"

namespace endmill {

double drawn_fraction(std::uint64_t seed, std::string_view key, std::uint64_t number)
{
    constexpr std::size_t digits = 16;  // of 64 bits
    constexpr unsigned surplus_bits = 11;
    const std::string text =
        std::to_string(seed) + '/' + std::string{key} + '/' + std::to_string(number);
    const std::string hash = content_sha256(text);
    std::uint64_t bits = 0;
    std::from_chars(hash.data(), hash.data() + digits, bits, 16);
    return static_cast<double>(bits >> surplus_bits) * 0x1p-53;
}

// With share = b1 / 2 + b2 / 4 + … the power is the product of those roots r^(1/2), r^(1/4),
// … whose bit is set.
double geometric_between(double low, double high, double share)
{
    double result = low;
    double root = high / low;
    for (double rest = share; rest > 0 && root > 1;) {
        root = std::sqrt(root);
        rest *= 2;
        if (rest >= 1) {
            result *= root;
            rest -= 1;
        }
    }
    return result;
}

}  // namespace endmill
