// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/l2.h"

#include <bit>
#include <cstring>

// No OpenCV and no Eigen in this file: code compiled for newer processors must not leak into shared inlines.
// It is compiled without contraction of products and sums (CMakeLists.txt): fused ones round differently.
#if defined(__x86_64__) && defined(__GNUC__)
#define FRAMEWISE_AVX2 __attribute__((target("avx2")))
#include <immintrin.h>
#endif

namespace framewise {
namespace {

typedef float Four __attribute__((vector_size(16)));

void l2_portable(const std::int32_t* row, const std::int32_t* blocks, int cells, int block_count, Key* keys) {
  constexpr int kVectors = kBlockRows / 4;
  for (int b = 0; b < block_count; ++b, keys += kBlockRows) {
    Four sums[kVectors] = {};
    for (int k = 0; k < cells; ++k, blocks += kBlockRows) {
      const float component = std::bit_cast<float>(row[k]);
      for (int v = 0; v < kVectors; ++v) {
        Four x;
        std::memcpy(&x, blocks + 4 * v, sizeof x);
        x -= component;
        sums[v] += x * x;
      }
    }
    std::memcpy(keys, sums, sizeof sums);
  }
}

#ifdef FRAMEWISE_AVX2

FRAMEWISE_AVX2 void l2_avx2(const std::int32_t* row, const std::int32_t* blocks, int cells, int block_count,
                            Key* keys) {
  constexpr int kVectors = kBlockRows / 8;
  for (int b = 0; b < block_count; ++b, keys += kBlockRows) {
    __m256 sums[kVectors] = {};
#pragma GCC unroll 4
    for (int k = 0; k < cells; ++k, blocks += kBlockRows) {
      const __m256 component = _mm256_set1_ps(std::bit_cast<float>(row[k]));
      for (int v = 0; v < kVectors; ++v) {
        const __m256 cell =
            _mm256_castsi256_ps(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(blocks) + v));
        const __m256 x = _mm256_sub_ps(cell, component);
        sums[v] = _mm256_add_ps(sums[v], _mm256_mul_ps(x, x));
      }
    }
    for (int v = 0; v < kVectors; ++v)
      _mm256_storeu_si256(reinterpret_cast<__m256i*>(keys) + v, _mm256_castps_si256(sums[v]));
  }
}

FRAMEWISE_AVX2 void l2_byte_avx2(const std::int32_t* row, const std::int32_t* blocks, int cells,
                                 int block_count, Key* keys) {
  constexpr int kVectors = kBlockRows / 8;
  const int pairs = cells - 1;
  const __m256i square_norm1 = _mm256_set1_epi32(row[pairs]);
  for (int b = 0; b < block_count; ++b, keys += kBlockRows, blocks += kBlockRows) {
    __m256i products[kVectors] = {};
#pragma GCC unroll 4
    for (int k = 0; k < pairs; ++k, blocks += kBlockRows) {
      const __m256i pair = _mm256_set1_epi32(row[k]);
      for (int v = 0; v < kVectors; ++v) {
        const __m256i cell = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(blocks) + v);
        products[v] = _mm256_add_epi32(products[v], _mm256_madd_epi16(pair, cell));
      }
    }
    for (int v = 0; v < kVectors; ++v) {
      const __m256i square_norm2 = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(blocks) + v);
      const __m256i squared =
          _mm256_sub_epi32(_mm256_add_epi32(square_norm1, square_norm2), _mm256_slli_epi32(products[v], 1));
      _mm256_storeu_si256(reinterpret_cast<__m256i*>(keys) + v,
                          _mm256_castps_si256(_mm256_cvtepi32_ps(squared)));
    }
  }
}

#endif

}  // namespace

BlockKernel l2_kernel([[maybe_unused]] Instructions instructions) {
#ifdef FRAMEWISE_AVX2
  if (instructions == Instructions::kAvx2) return l2_avx2;
#endif
  return l2_portable;
}

BlockKernel l2_byte_kernel([[maybe_unused]] Instructions instructions) {
#ifdef FRAMEWISE_AVX2
  if (instructions == Instructions::kAvx2) return l2_byte_avx2;
#endif
  return nullptr;
}

void l2_to_listed(const float* descriptor, const float* rows, std::int64_t stride, int components,
                  const int* listed, int count, Key* keys) {
  for (int i = 0; i < count; ++i) {
    const float* row = rows + listed[i] * stride;
    float sum = 0;
    for (int k = 0; k < components; ++k) {
      const float x = row[k] - descriptor[k];
      sum += x * x;
    }
    keys[i] = std::bit_cast<Key>(sum);
  }
}

}  // namespace framewise
