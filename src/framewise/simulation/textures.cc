// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/textures.h"

#include "framewise/simulation/image_texture.h"
#include "framewise/simulation/texture_kit.h"

namespace framewise {

Color albedo(const Material& m, float u, float v, float footprint) {
  const texture::Point p{u, v, footprint};
  switch (m.texture) {
    case Texture::kPaint:
      return texture::paint(m, p);
    case Texture::kPlaster:
      return texture::plaster(m, p);
    case Texture::kWallpaper:
      return texture::wallpaper(m, p);
    case Texture::kBrick:
      return texture::brick(m, p);
    case Texture::kPlanks:
      return texture::planks(m, p);
    case Texture::kWood:
      return texture::wood(m, p);
    case Texture::kCarpet:
      return texture::carpet(m, p);
    case Texture::kFabric:
      return texture::fabric(m, p);
    case Texture::kStriped:
      return texture::striped(m, p);
    case Texture::kChecker:
      return texture::checker(m, p);
    case Texture::kSpine:
      return texture::spine(m, p);
    case Texture::kPages:
      return texture::pages(m, p);
    case Texture::kPrint:
      return texture::framed_print(m, p);
    case Texture::kAbstract:
      return texture::abstract(m, p);
    case Texture::kLandscape:
      return texture::landscape(m, p);
    case Texture::kMosaic:
      return texture::mosaic(m, p);
    case Texture::kCarton:
      return texture::carton(m, p);
    case Texture::kCeramic:
      return texture::ceramic(m, p);
    case Texture::kMarble:
      return texture::marble(m, p);
    case Texture::kLeaf:
      return texture::leaf(m, p);
    case Texture::kFruit:
      return texture::fruit(m, p);
    case Texture::kGlow:
      return texture::glow(m, p);
    case Texture::kRock:
      return texture::rock(m, p);
    case Texture::kConcrete:
      return texture::concrete(m, p);
    case Texture::kGravel:
      return texture::gravel(m, p);
    case Texture::kPatchwork:
      return texture::patchwork(m, p);
    case Texture::kOutdoors:
      return texture::outdoors(m, p);
    case Texture::kPlain:
      return m.a;
    case Texture::kImage:
      return m.image ? m.a * m.image->at(u / m.width, v / m.height, footprint / m.width) : m.a;
  }
  return {};
}

}  // namespace framewise
