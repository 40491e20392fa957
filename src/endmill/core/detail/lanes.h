// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>

#include <Eigen/Core>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace endmill {

/// \file
/// Eight floats at a time, for the inner loops of the drop cutter and of visibility.
///
/// `FloatLanes` stores eight floats in memory. `WideFloats` computes with them: it is one
/// vector of the compiler and uses the widest registers that the enclosing function is
/// compiled for (see ENDMILL_WIDEST_REGISTERS); Eigen chooses its registers once for the
/// whole program. `WideBits` is the result of a comparison, lane by lane. Everything is
/// inlined into the calling function, because a function of its own would be compiled for
/// other registers.

/// Number of floats that are processed at once: one register of eight or two of four.
constexpr int float_lanes = 8;
/// Eight floats in memory, aligned for registers of four.
using FloatLanes = Eigen::Array<float, float_lanes, 1>;

/// The smaller of two floats, as `WideFloats` computes it in each lane.
[[gnu::always_inline]] inline float smaller(float a, float b)
{
    return a < b ? a : b;
}

/// The larger of two floats, as `WideFloats` computes it in each lane.
[[gnu::always_inline]] inline float larger(float a, float b)
{
    return a > b ? a : b;
}

/// One bit for each lane: the lanes for which a condition holds.
class WideBits {
public:
    /// Vector of the compiler; a lane has either all bits set or none.
    using Vector = std::int32_t __attribute__((vector_size(float_lanes * sizeof(float))));

    /// \param set all bits of a lane, or none.
    [[gnu::always_inline]] explicit WideBits(const Vector& set) : set_{set} {}

    /// The lanes in which the eight `numbers` differ from `number`.
    [[gnu::always_inline]] WideBits(const std::int32_t* numbers, std::int32_t number)
    {
        std::memcpy(&set_, numbers, sizeof set_);
        set_ = set_ != Vector{} + number;
    }

    /// The lanes that are in both.
    [[gnu::always_inline]] friend WideBits operator&(const WideBits& a, const WideBits& b)
    {
        return WideBits{a.set_ & b.set_};
    }
    /// The lanes that are in one or both.
    [[gnu::always_inline]] friend WideBits operator|(const WideBits& a, const WideBits& b)
    {
        return WideBits{a.set_ | b.set_};
    }

    /// Whether the condition holds in any lane.
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

    /// The lanes as a number whose bit k stands for lane k.
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
        for (int k = 0; k < float_lanes; ++k)
            bits |= set_[k] != 0 ? 1U << k : 0U;
        return bits;
#endif
    }

private:
    Vector set_;
};

/// Eight floats in registers. All operators work lane by lane and round like single
/// floats.
class WideFloats {
public:
    /// Zero in all lanes.
    [[gnu::always_inline]] WideFloats() : values_{} {}
    /// The same value in all lanes.
    [[gnu::always_inline]] WideFloats(float value) : values_{Vector{} + value} {}
    /// The eight floats at `values`.
    [[gnu::always_inline]] explicit WideFloats(const float* values)
    {
        std::memcpy(&values_, values, sizeof values_);
    }
    /// The eight floats of `values`.
    [[gnu::always_inline]] explicit WideFloats(const FloatLanes& values)
        : WideFloats{values.data()}
    {
    }

    /// The eight floats in memory.
    [[gnu::always_inline]] FloatLanes lanes() const
    {
        FloatLanes lanes;
        std::memcpy(lanes.data(), &values_, sizeof values_);
        return lanes;
    }

    /// Writes the eight floats to `values`.
    [[gnu::always_inline]] void store(std::array<float, float_lanes>& values) const
    {
        std::memcpy(values.data(), &values_, sizeof values_);
    }

    /// Writes the floats, rounded towards zero, to `values`.
    /// \pre they are in the range of a 32-bit integer.
    [[gnu::always_inline]] void store_whole(
        std::array<std::int32_t, float_lanes>& values) const
    {
        const auto whole = __builtin_convertvector(values_, WideBits::Vector);
        std::memcpy(values.data(), &whole, sizeof whole);
    }

    /// The negated values.
    [[gnu::always_inline]] WideFloats operator-() const { return WideFloats{-values_}; }
    /// The sums.
    [[gnu::always_inline]] friend WideFloats operator+(const WideFloats& a,
                                                       const WideFloats& b)
    {
        return WideFloats{a.values_ + b.values_};
    }
    /// The differences.
    [[gnu::always_inline]] friend WideFloats operator-(const WideFloats& a,
                                                       const WideFloats& b)
    {
        return WideFloats{a.values_ - b.values_};
    }
    /// The products.
    [[gnu::always_inline]] friend WideFloats operator*(const WideFloats& a,
                                                       const WideFloats& b)
    {
        return WideFloats{a.values_ * b.values_};
    }
    /// The quotients.
    [[gnu::always_inline]] friend WideFloats operator/(const WideFloats& a,
                                                       const WideFloats& b)
    {
        return WideFloats{a.values_ / b.values_};
    }
    /// The lanes in which a > b.
    [[gnu::always_inline]] friend WideBits operator>(const WideFloats& a,
                                                     const WideFloats& b)
    {
        return WideBits{a.values_ > b.values_};
    }
    /// The lanes in which a >= b.
    [[gnu::always_inline]] friend WideBits operator>=(const WideFloats& a,
                                                      const WideFloats& b)
    {
        return WideBits{a.values_ >= b.values_};
    }
    /// The smaller of the two values in each lane.
    [[gnu::always_inline]] friend WideFloats smaller(const WideFloats& a,
                                                     const WideFloats& b)
    {
        return WideFloats{a.values_ < b.values_ ? a.values_ : b.values_};
    }
    /// The larger of the two values in each lane.
    [[gnu::always_inline]] friend WideFloats larger(const WideFloats& a,
                                                    const WideFloats& b)
    {
        return WideFloats{a.values_ > b.values_ ? a.values_ : b.values_};
    }
    /// -1 where the value is below 0, else 1.
    [[gnu::always_inline]] friend WideFloats sign_of(const WideFloats& a)
    {
        return WideFloats{a.values_ < 0 ? Vector{} - 1 : Vector{} + 1};
    }

private:
    using Vector = float __attribute__((vector_size(float_lanes * sizeof(float))));

    [[gnu::always_inline]] explicit WideFloats(const Vector& values) : values_{values} {}

    Vector values_;
};

/// A number whose bit k is set where values[k] >= limit.
inline unsigned lanes_not_below(float limit, const FloatLanes& values)
{
    unsigned lanes = 0;
#if defined(__SSE__)
    const __m128 all = _mm_set1_ps(limit);
    for (int k = 0; k < float_lanes; k += 4)
        lanes |= static_cast<unsigned>(
                     _mm_movemask_ps(_mm_cmpge_ps(_mm_load_ps(&values[k]), all)))
                 << k;
#else
    for (int k = 0; k < float_lanes; ++k)
        lanes |= values[k] >= limit ? 1U << k : 0U;
#endif
    return lanes;
}

/// The lanes values[k] where keys[k] <= limit, minus infinity in the others.
inline FloatLanes kept_up_to(float limit, const FloatLanes& keys,
                             const FloatLanes& values)
{
    constexpr float nothing = -std::numeric_limits<float>::infinity();
    FloatLanes kept;
#if defined(__SSE__)  // Eigen's select compiles to branches, which are slower here
    const __m128 all = _mm_set1_ps(limit);
    for (int k = 0; k < float_lanes; k += 4) {
        const __m128 is_kept = _mm_cmple_ps(_mm_load_ps(&keys[k]), all);
        _mm_store_ps(&kept[k], _mm_or_ps(_mm_and_ps(is_kept, _mm_load_ps(&values[k])),
                                         _mm_andnot_ps(is_kept, _mm_set1_ps(nothing))));
    }
#else
    for (int k = 0; k < float_lanes; ++k)
        kept[k] = keys[k] <= limit ? values[k] : nothing;
#endif
    return kept;
}

}  // namespace endmill
