// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Before a function: compiled for several instruction sets, of which the program takes the best there is when
// it starts. Only in files that CMakeLists.txt lists under SEVERAL_INSTRUCTION_SETS and that include neither
// Eigen nor OpenCV: code for newer processors must not leak into shared inline functions.
#if defined(__x86_64__) && defined(__GNUC__)
#define FRAMEWISE_CHOSEN_AT_RUN_TIME __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define FRAMEWISE_CHOSEN_AT_RUN_TIME
#endif

// What such a function calls becomes part of it, and so of each of its versions.
#define FRAMEWISE_INLINE inline __attribute__((always_inline))
