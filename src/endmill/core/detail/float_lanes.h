// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>
#include <limits>

#include <Eigen/Core>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace endmill {

/// Floats that are dealt with at once: in two registers of four, which keeps a processor
/// busier than one would.
constexpr int float_lanes = 8;
using FloatLanes = Eigen::Array<float, float_lanes, 1>;  ///< see float_lanes

/// The same as one vector of the compiler, which takes as many at once as the registers hold
/// that a function is compiled for; Eigen has decided that before.
class WideLanes {
public:
    [[gnu::always_inline]] explicit WideLanes(const FloatLanes& values)
    {
        std::memcpy(&values_, values.data(), sizeof values_);
    }
    [[gnu::always_inline]] explicit WideLanes(float value) : values_{Vector{} + value} {}

    [[gnu::always_inline]] FloatLanes lanes() const
    {
        FloatLanes lanes;
        std::memcpy(lanes.data(), &values_, sizeof values_);
        return lanes;
    }

    [[gnu::always_inline]] friend WideLanes operator+(const WideLanes& one,
                                                      const WideLanes& other)
    {
        return WideLanes{one.values_ + other.values_};
    }
    [[gnu::always_inline]] friend WideLanes operator-(const WideLanes& one,
                                                      const WideLanes& other)
    {
        return WideLanes{one.values_ - other.values_};
    }
    [[gnu::always_inline]] friend WideLanes operator*(const WideLanes& one,
                                                      const WideLanes& other)
    {
        return WideLanes{one.values_ * other.values_};
    }
    [[gnu::always_inline]] friend WideLanes larger(const WideLanes& one,
                                                   const WideLanes& other)
    {
        return WideLanes{one.values_ > other.values_ ? one.values_ : other.values_};
    }
    [[gnu::always_inline]] friend WideLanes smaller(const WideLanes& one,
                                                    const WideLanes& other)
    {
        return WideLanes{one.values_ < other.values_ ? one.values_ : other.values_};
    }

private:
    using Vector = float __attribute__((vector_size(float_lanes * sizeof(float))));

    [[gnu::always_inline]] explicit WideLanes(const Vector& values) : values_{values} {}

    Vector values_;
};

/// Bit k for each k with values[k] >= limit.
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

/// Those of the values beside which `keys` are at most `limit`; minus infinity for others.
inline FloatLanes kept_up_to(float limit, const FloatLanes& keys,
                             const FloatLanes& values)
{
    constexpr float nothing = -std::numeric_limits<float>::infinity();
    FloatLanes kept;
#if defined(__SSE__)  // without the branches that Eigen's select makes
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
