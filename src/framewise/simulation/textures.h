// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "framewise/simulation/color.h"

namespace framewise {

enum class Texture {
  paint,      // mottled colour a
  plaster,    // rough wall
  wallpaper,  // leaves of b on a
  brick,      // bricks a to b, mortar
  planks,     // floor boards a to b
  wood,       // one piece, grain from a to b
  carpet,     // woven motifs in a frame
  fabric,     // weave
  striped,    // woven stripes of a and b
  checker,    // squares of a and b
  spine,      // back of a book
  pages,      // edge of a book's paper
  print,      // printed sheet: headline, columns of glyphs
  abstract,   // painting of discs and bars
  landscape,  // painting of hills
  mosaic,     // painting of coloured tiles
  carton,     // cardboard box with label and tape
  ceramic,    // glazed bands
  marble,     // veins
  leaf,       // veins on green
  fruit,      // speckles
  glow,       // lamp shade that shines
  outdoors,   // what is seen through the window
};

// Colours a and b, an own seed, and for patterns that fill their surface its size (m).
struct Material {
  Texture texture = Texture::paint;
  Color a, b;
  std::uint32_t seed = 0;
  float width = 1, height = 1;
  float emission = 0;  // above 0: the surface shines with this times its colour, whatever the light
};

// Diffuse reflectance at (u, v), metres along the surface, averaged over about the footprint (m) of a pixel.
// Pure.
Color albedo(const Material& material, float u, float v, float footprint);

}  // namespace framewise
