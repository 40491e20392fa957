// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace endmill {

/// Floats that are dealt with at once.
constexpr int wide_lanes = 8;

/// The same as of `WideFloats`, for one.
[[gnu::always_inline]] inline float smaller(float a, float b)
{
    return a < b ? a : b;
}

/// The same as of `WideFloats`, for one.
[[gnu::always_inline]] inline float larger(float a, float b)
{
    return a > b ? a : b;
}

/// Which lanes something holds for.
class WideBits {
public:
    /// Vector of the compiler: all bits of a lane set, or none.
    using Vector = std::int32_t __attribute__((vector_size(wide_lanes * sizeof(float))));

    [[gnu::always_inline]] explicit WideBits(const Vector& set) : set_{set} {}

    /// Where eight numbers differ from `number`.
    [[gnu::always_inline]] WideBits(const std::int32_t* numbers, std::int32_t number)
    {
        std::memcpy(&set_, numbers, sizeof set_);
        set_ = set_ != Vector{} + number;
    }

    [[gnu::always_inline]] friend WideBits operator&(const WideBits& a, const WideBits& b)
    {
        return WideBits{a.set_ & b.set_};
    }
    [[gnu::always_inline]] friend WideBits operator|(const WideBits& a, const WideBits& b)
    {
        return WideBits{a.set_ | b.set_};
    }

    /// Whether there is any.
    [[gnu::always_inline]] bool any() const
    {
#if defined(__SSE__)
        __m128 low;
        __m128 high;
        std::memcpy(&low, &set_, sizeof low);
        std::memcpy(&high, reinterpret_cast<const char*>(&set_) + sizeof low,
                    sizeof high);
        return _mm_movemask_ps(_mm_or_ps(low, high)) != 0;
#else
        return bits() != 0;
#endif
    }

    /// Bit k for lane k.
    [[gnu::always_inline]] unsigned bits() const
    {
#if defined(__SSE__)
        __m128 low;
        __m128 high;
        std::memcpy(&low, &set_, sizeof low);
        std::memcpy(&high, reinterpret_cast<const char*>(&set_) + sizeof low,
                    sizeof high);
        return static_cast<unsigned>(_mm_movemask_ps(low)) |
               static_cast<unsigned>(_mm_movemask_ps(high)) << 4U;
#else
        unsigned bits = 0;
        for (int k = 0; k < wide_lanes; ++k)
            bits |= set_[k] != 0 ? 1U << k : 0U;
        return bits;
#endif
    }

private:
    Vector set_;
};

/// Floats in one vector of the compiler, which takes as many at once as the registers hold
/// that a function is compiled for.
class WideFloats {
public:
    /// All zero.
    [[gnu::always_inline]] WideFloats() : values_{} {}
    /// The same in all lanes.
    [[gnu::always_inline]] WideFloats(float value) : values_{Vector{} + value} {}
    /// Eight values, one a lane.
    [[gnu::always_inline]] explicit WideFloats(const float* values)
    {
        std::memcpy(&values_, values, sizeof values_);
    }

    /// Writes a value for each lane.
    [[gnu::always_inline]] void store(std::array<float, wide_lanes>& values) const
    {
        std::memcpy(values.data(), &values_, sizeof values_);
    }

    /// The same, rounded towards zero. \pre they fit.
    [[gnu::always_inline]] void store_whole(
        std::array<std::int32_t, wide_lanes>& values) const
    {
        const auto whole = __builtin_convertvector(values_, WideBits::Vector);
        std::memcpy(values.data(), &whole, sizeof whole);
    }

    [[gnu::always_inline]] WideFloats operator-() const { return WideFloats{-values_}; }
    [[gnu::always_inline]] friend WideFloats operator+(const WideFloats& a,
                                                       const WideFloats& b)
    {
        return WideFloats{a.values_ + b.values_};
    }
    [[gnu::always_inline]] friend WideFloats operator-(const WideFloats& a,
                                                       const WideFloats& b)
    {
        return WideFloats{a.values_ - b.values_};
    }
    [[gnu::always_inline]] friend WideFloats operator*(const WideFloats& a,
                                                       const WideFloats& b)
    {
        return WideFloats{a.values_ * b.values_};
    }
    [[gnu::always_inline]] friend WideFloats operator/(const WideFloats& a,
                                                       const WideFloats& b)
    {
        return WideFloats{a.values_ / b.values_};
    }
    [[gnu::always_inline]] friend WideBits operator>(const WideFloats& a,
                                                     const WideFloats& b)
    {
        return WideBits{a.values_ > b.values_};
    }
    [[gnu::always_inline]] friend WideBits operator>=(const WideFloats& a,
                                                      const WideFloats& b)
    {
        return WideBits{a.values_ >= b.values_};
    }
    [[gnu::always_inline]] friend WideFloats smaller(const WideFloats& a,
                                                     const WideFloats& b)
    {
        return WideFloats{a.values_ < b.values_ ? a.values_ : b.values_};
    }
    [[gnu::always_inline]] friend WideFloats larger(const WideFloats& a,
                                                    const WideFloats& b)
    {
        return WideFloats{a.values_ > b.values_ ? a.values_ : b.values_};
    }
    /// 1 or, below 0, -1.
    [[gnu::always_inline]] friend WideFloats sign_of(const WideFloats& a)
    {
        return WideFloats{a.values_ < 0 ? Vector{} - 1 : Vector{} + 1};
    }

private:
    using Vector = float __attribute__((vector_size(wide_lanes * sizeof(float))));

    [[gnu::always_inline]] explicit WideFloats(const Vector& values) : values_{values} {}

    Vector values_;
};

}  // namespace endmill
