// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "figure_files.h"

#include <librsvg/rsvg.h>

#include <memory>
#include <stdexcept>

#include "framewise/io/output_file.h"
#include "report_files.h"

namespace framewise::apps {
namespace {

constexpr double kPixelsPerUnit = 2;

template <typename T, auto Free>
using Owned = std::unique_ptr<T, decltype([](T* thing) { Free(thing); })>;

void draw_png(const std::filesystem::path& path, const std::string& svg) {
  const auto fail = [&] { throw std::runtime_error(path.string() + ": the figure could not be drawn"); };
  const Owned<RsvgHandle, g_object_unref> handle(
      rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), nullptr));
  double width = 0, height = 0;
  if (!handle || !rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height)) fail();
  width *= kPixelsPerUnit;
  height *= kPixelsPerUnit;
  const Owned<cairo_surface_t, cairo_surface_destroy> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height)));
  const Owned<cairo_t, cairo_destroy> context(cairo_create(surface.get()));
  const RsvgRectangle whole{0, 0, width, height};
  if (!rsvg_handle_render_document(handle.get(), context.get(), &whole, nullptr)) fail();
  if (cairo_surface_write_to_png(surface.get(), path.c_str()) != CAIRO_STATUS_SUCCESS) fail();
}

}  // namespace

void write_figures(const std::filesystem::path& folder,
                   const std::vector<std::pair<std::string, std::string>>& figures) {
  make_output_folder(folder, "--figures");
  for (const auto& [name, svg] : figures) {
    write_whole(folder / (name + ".svg"), svg, "--figures");
    draw_png(folder / (name + ".png"), svg);
  }
}

}  // namespace framewise::apps
