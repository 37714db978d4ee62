// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/textures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "framewise/simulation/noise.h"

namespace framewise {
namespace {

Material material_of(Texture texture) { return {texture, srgb(0xc08050), srgb(0x304060), 7, 0.6f, 0.8f}; }

struct Moments {
  double mean = 0, deviation = 0;
};

// Of the green light over the middle of the surface.
Moments moments(const Material& material, float footprint) {
  double sum = 0, sum2 = 0;
  constexpr int kSide = 120;
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      const float u = 0.1f + 0.4f * (static_cast<float>(i) + 0.5f) / kSide,
                  v = 0.1f + 0.6f * (static_cast<float>(j) + 0.5f) / kSide;
      const double g = albedo(material, u, v, footprint).g;
      sum += g;
      sum2 += g * g;
    }
  }
  const double mean = sum / (kSide * kSide);
  return {mean, std::sqrt(std::max(0.0, sum2 / (kSide * kSide) - mean * mean))};
}

class EveryTexture : public testing::TestWithParam<int> {};

TEST_P(EveryTexture, ReflectsBetweenNothingAndABitMoreThanAll) {
  const Material material = material_of(static_cast<Texture>(GetParam()));
  for (float u = -0.5f; u < 1; u += 0.013f) {
    for (float v = -0.5f; v < 1; v += 0.017f) {
      const Color color = albedo(material, u, v, 0.002f);
      for (const float c : {color.r, color.g, color.b}) ASSERT_TRUE(c >= 0 && c < 1.6f) << c;
    }
  }
}

TEST_P(EveryTexture, FromFarAwayIsTheMeanOfWhatItIsNearby) {
  const Material material = material_of(static_cast<Texture>(GetParam()));
  const Moments near = moments(material, 0.001f), far = moments(material, 0.02f);
  EXPECT_NEAR(far.mean, near.mean, 0.035);
  EXPECT_LE(far.deviation, 1.05 * near.deviation) << "a larger footprint smooths";
}

TEST_P(EveryTexture, HasDetailAndDependsOnItsSeed) {
  Material material = material_of(static_cast<Texture>(GetParam()));
  EXPECT_GT(moments(material, 0.001f).deviation, 0.003);
  const double one = moments(material, 0.001f).mean;
  material.seed = 8;
  EXPECT_NE(moments(material, 0.001f).mean, one);
}

INSTANTIATE_TEST_SUITE_P(Textures, EveryTexture, testing::Range(0, static_cast<int>(Texture::kOutdoors) + 1));

TEST(Noise, IsCentredAndBoundedAndContinuous) {
  double sum = 0;
  for (int i = 0; i < 20000; ++i) {
    const float x = 0.0371f * static_cast<float>(i) - 300, y = 0.0113f * static_cast<float>(i) - 90;
    const float n = value_noise(x, y, 3);
    ASSERT_LE(std::abs(n), 1);
    ASSERT_NEAR(value_noise(x + 1e-3f, y, 3), n, 0.01);
    sum += n;
  }
  EXPECT_NEAR(sum / 20000, 0, 0.03);
}

TEST(Noise, OctavesAddUpEachTwiceAsFineAndTurned) {
  for (const float pixels : {2.0f, 11.0f, 300.0f, 5000.0f}) {
    float x = 0.37f, y = -1.23f, size = pixels, amplitude = 1, sum = 0;
    for (std::uint32_t k = 0; k < 10 && size > 1.5f; ++k) {
      sum += amplitude * visible(size, 1) * value_noise(x, y, 5 + k);
      const float turned = 1.6f * x - 1.2f * y;
      y = 1.2f * x + 1.6f * y;
      x = turned;
      size *= 0.5f;
      amplitude *= 0.7f;
    }
    EXPECT_NEAR(octaves_of_noise(0.37f, -1.23f, pixels, 0.7f, 5), sum, 2e-3) << pixels;
  }
  EXPECT_TRUE(std::isfinite(octaves_of_noise(3e7f, -2e8f, 1e9f, 0.7f, 5))) << "far out";
}

TEST(Noise, HashesSideBySideAreThoseOneByOne) {
  float values[19];
  hash01_of_each(19, 3, 77, values);
  for (std::uint32_t k = 0; k < 19; ++k) EXPECT_EQ(values[k], hash01(k, 3, 77));
}

}  // namespace
}  // namespace framewise
