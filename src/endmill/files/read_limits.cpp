// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/read_file.h"

#include <array>
#include <cstdio>

#include "endmill/core/error.h"

namespace endmill {
namespace {

constexpr double bytes_per_gib = 1024.0 * 1024 * 1024;

std::string two_digits(double value)
{
    std::array<char, 32> buffer{};
    const int length = std::snprintf(buffer.data(), buffer.size(), "%.2g", value);
    return {buffer.data(), static_cast<std::size_t>(length)};
}

}  // namespace

void require_memory(const std::string& file, double bytes, const ReadLimits& limits)
{
    const double gib = bytes / bytes_per_gib;
    if (gib > limits.max_memory_gib)
        throw LimitError{file + ": reading it needs about " + two_digits(gib) +
                         " GiB; the limit is " + two_digits(limits.max_memory_gib) +
                         " GiB (--max-memory)"};
}

}  // namespace endmill
