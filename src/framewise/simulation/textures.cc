// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/textures.h"

#include "framewise/simulation/texture_kit.h"

namespace framewise {

Color albedo(const Material& m, float u, float v, float footprint) {
  const texture::Point p{u, v, footprint};
  switch (m.texture) {
    case Texture::paint:
      return texture::paint(m, p);
    case Texture::plaster:
      return texture::plaster(m, p);
    case Texture::wallpaper:
      return texture::wallpaper(m, p);
    case Texture::brick:
      return texture::brick(m, p);
    case Texture::planks:
      return texture::planks(m, p);
    case Texture::wood:
      return texture::wood(m, p);
    case Texture::carpet:
      return texture::carpet(m, p);
    case Texture::fabric:
      return texture::fabric(m, p);
    case Texture::striped:
      return texture::striped(m, p);
    case Texture::checker:
      return texture::checker(m, p);
    case Texture::spine:
      return texture::spine(m, p);
    case Texture::pages:
      return texture::pages(m, p);
    case Texture::print:
      return texture::framed_print(m, p);
    case Texture::abstract:
      return texture::abstract(m, p);
    case Texture::landscape:
      return texture::landscape(m, p);
    case Texture::mosaic:
      return texture::mosaic(m, p);
    case Texture::carton:
      return texture::carton(m, p);
    case Texture::ceramic:
      return texture::ceramic(m, p);
    case Texture::marble:
      return texture::marble(m, p);
    case Texture::leaf:
      return texture::leaf(m, p);
    case Texture::fruit:
      return texture::fruit(m, p);
    case Texture::glow:
      return texture::glow(m, p);
    case Texture::outdoors:
      return texture::outdoors(m, p);
  }
  return {};
}

}  // namespace framewise
