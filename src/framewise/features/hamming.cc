// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/hamming.h"

#include <bit>
#include <cstring>

// No OpenCV and no Eigen in this file: code compiled for newer processors must not leak into shared inlines.
#if defined(__x86_64__) && defined(__GNUC__)
#define FRAMEWISE_AVX2 __attribute__((target("avx2")))
#include <immintrin.h>
#endif

namespace framewise {
namespace {

// Counts of bits are summed in bytes; a cell of nibbles adds at most 4 to each, so as many cells fit.
constexpr int kCellsInBytes = 62;

typedef std::uint32_t Four __attribute__((vector_size(16)));

void hamming_portable(const std::int32_t* row, const std::int32_t* blocks, int cells, int block_count,
                      Key* keys) {
  for (int b = 0; b < block_count; ++b, blocks += cells * kBlockRows) {
    for (int lane = 0; lane < kBlockRows; lane += 4, keys += 4) {
      Four sum = {};
      for (int begin = 0; begin < cells; begin += kCellsInBytes) {
        const int end = begin + kCellsInBytes < cells ? begin + kCellsInBytes : cells;
        Four bytes = {};
        for (int k = begin; k < end; k += 2) {
          Four x, upper;
          std::memcpy(&x, blocks + k * kBlockRows + lane, sizeof x);
          std::memcpy(&upper, blocks + (k + 1) * kBlockRows + lane, sizeof upper);
          x ^= static_cast<std::uint32_t>(row[k]);
          x |= (upper ^ static_cast<std::uint32_t>(row[k + 1])) << 4;
          x -= (x >> 1) & 0x55555555u;
          x = (x & 0x33333333u) + ((x >> 2) & 0x33333333u);
          bytes += (x + (x >> 4)) & 0x0f0f0f0fu;
        }
        const Four pairs = (bytes & 0x00ff00ffu) + ((bytes >> 8) & 0x00ff00ffu);
        sum += (pairs & 0xffffu) + (pairs >> 16);
      }
      std::memcpy(keys, &sum, sizeof sum);
    }
  }
}

#ifdef FRAMEWISE_AVX2

// Bits of a nibble by a table in a register: Mula, Kurz, Lemire, Faster population counts using AVX2
// instructions, The Computer Journal 2018.
FRAMEWISE_AVX2 void hamming_avx2(const std::int32_t* row, const std::int32_t* blocks, int cells,
                                 int block_count, Key* keys) {
  constexpr int kVectors = kBlockRows / 8;
  const __m256i bits_of_nibble = _mm256_setr_epi8(0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4,  //
                                                  0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4);
  const __m256i ones8 = _mm256_set1_epi8(1), ones16 = _mm256_set1_epi16(1);
  for (int b = 0; b < block_count; ++b, keys += kBlockRows) {
    __m256i sums[kVectors] = {};
    for (int begin = 0; begin < cells; begin += kCellsInBytes) {
      const int end = begin + kCellsInBytes < cells ? begin + kCellsInBytes : cells;
      __m256i bytes[kVectors] = {};
#pragma GCC unroll 4
      for (int k = begin; k < end; ++k, blocks += kBlockRows) {
        const __m256i cell1 = _mm256_set1_epi32(row[k]);
        for (int v = 0; v < kVectors; ++v) {
          const __m256i cell2 = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(blocks) + v);
          const __m256i x = _mm256_xor_si256(cell1, cell2);
          bytes[v] = _mm256_add_epi8(bytes[v], _mm256_shuffle_epi8(bits_of_nibble, x));
        }
      }
      for (int v = 0; v < kVectors; ++v)
        sums[v] = _mm256_add_epi32(sums[v], _mm256_madd_epi16(_mm256_maddubs_epi16(bytes[v], ones8), ones16));
    }
    for (int v = 0; v < kVectors; ++v) _mm256_storeu_si256(reinterpret_cast<__m256i*>(keys) + v, sums[v]);
  }
}

#endif

}  // namespace

BlockKernel hamming_kernel([[maybe_unused]] Instructions instructions) {
#ifdef FRAMEWISE_AVX2
  if (instructions == Instructions::kAvx2) return hamming_avx2;
#endif
  return hamming_portable;
}

void hamming_to_listed(const std::uint8_t* descriptor, const std::uint8_t* rows, std::int64_t stride,
                       int bytes, const int* listed, int count, Key* keys) {
  for (int i = 0; i < count; ++i) {
    const std::uint8_t* row = rows + listed[i] * stride;
    keys[i] = 0;
    for (int k = 0; k < bytes; ++k) keys[i] += std::popcount(static_cast<unsigned>(descriptor[k] ^ row[k]));
  }
}

}  // namespace framewise
