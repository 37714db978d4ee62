// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>

#include "framewise/simulation/color.h"

namespace framewise {

class ImageTexture;

enum class Texture {
  kPaint,      // mottled colour a
  kPlaster,    // rough wall
  kWallpaper,  // leaves of b on a
  kBrick,      // bricks a to b, mortar
  kPlanks,     // floor boards a to b
  kWood,       // one piece, grain from a to b
  kCarpet,     // woven motifs in a frame
  kFabric,     // weave
  kStriped,    // woven stripes of a and b
  kChecker,    // squares of a and b
  kSpine,      // back of a book
  kPages,      // edge of a book's paper
  kPrint,      // printed sheet: headline, columns of glyphs
  kAbstract,   // painting of discs and bars
  kLandscape,  // painting of hills
  kMosaic,     // painting of coloured tiles
  kCarton,     // cardboard box with label and tape
  kCeramic,    // glazed bands
  kMarble,     // veins
  kLeaf,       // veins on green
  kFruit,      // speckles
  kGlow,       // lamp shade that shines
  kRock,       // layers from a to b, cracks
  kConcrete,   // cast panels from a to b
  kGravel,     // stones from a to b
  kPatchwork,  // squares within squares around the mean of a and b
  kOutdoors,   // what is seen through the window
  kPlain,      // colour a and nothing else
  kImage,      // the image times a, width x height of it, then again
};

// Colours a and b, an own seed, and for patterns that fill their surface its size (m).
struct Material {
  Texture texture = Texture::kPaint;
  Color a, b;
  std::uint32_t seed = 0;
  float width = 1, height = 1;
  float emission = 0;  // above 0: the surface shines with this times its colour, whatever the light
  std::shared_ptr<const ImageTexture> image = nullptr;  // of kImage
};

// Diffuse reflectance at (u, v), metres along the surface, averaged over about the footprint (m) of a pixel.
// Pure.
Color albedo(const Material& material, float u, float v, float footprint);

}  // namespace framewise
