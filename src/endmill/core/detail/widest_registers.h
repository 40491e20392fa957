// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Written before a function, compiles it three times: for the baseline of the target,
/// for AVX2 and for AVX-512. The program chooses once, when it starts, by the processor
/// that it runs on. All versions give the same bits, because the build contracts no
/// multiplications and additions. It has no effect under sanitizers, which cannot follow a
/// choice that is made before main.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ENDMILL_WIDEST_REGISTERS \
    __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define ENDMILL_WIDEST_REGISTERS
#endif

/// Written before an inner loop of eight steps, keeps the compiler from unrolling it.
/// GCC 12 vectorises the unrolled steps across the outer loop and then spends half of the
/// time on permutations.
#if defined(__GNUC__) && !defined(__clang__)
#define ENDMILL_NOT_UNROLLED _Pragma("GCC unroll 1")
#else
#define ENDMILL_NOT_UNROLLED
#endif

/// Written before an inner loop of eight steps that do not depend on one another, and whose
/// arrays do not overlap: the compiler need not check that. It is not unrolled either.
#if defined(__GNUC__) && !defined(__clang__)
#define ENDMILL_INDEPENDENT _Pragma("GCC ivdep") _Pragma("GCC unroll 1")
#else
#define ENDMILL_INDEPENDENT
#endif

namespace endmill {

/// Chooses one of two numbers that are both computed, so that the compiler needs no
/// branch.
[[gnu::always_inline]] inline double select(bool is_first, double first, double second)
{
    return is_first ? first : second;
}

}  // namespace endmill
