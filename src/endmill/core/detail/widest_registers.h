// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Before a function: compiles it also for the widest registers of the machine at hand. Without
/// contraction the bits are the same. Sanitizers cannot follow the choice, which is made
/// before main.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ENDMILL_WIDEST_REGISTERS __attribute__((target_clones("avx2", "default")))
#else
#define ENDMILL_WIDEST_REGISTERS
#endif
