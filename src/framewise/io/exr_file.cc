// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/exr_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfTestFile.h>
#include <fmt/format.h>

#include <cstdint>
#include <string>

#include "framewise/io/input_error.h"

namespace framewise {
namespace {

constexpr std::int64_t kMostPixels = 1 << 28;  // a damaged header may ask for any size

// The part of a channel's name after its layer's.
std::string last_part(const std::string& name) { return name.substr(name.rfind('.') + 1); }

std::string depth_channel(const std::filesystem::path& path, const Imf::ChannelList& channels) {
  for (const char* wanted : {"Z", "V"})
    for (auto channel = channels.begin(); channel != channels.end(); ++channel)
      if (last_part(channel.name()) == wanted) return channel.name();
  if (channels.begin() == channels.end())
    throw InputError(path, 0, "", "no channel", "an EXR file with depth");
  return channels.begin().name();
}

cv::Mat read_channel(const std::filesystem::path& path, Imf::InputFile& file) {
  const auto window = file.header().dataWindow();
  const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
  const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
  if (width < 1 || height < 1 || width > kMostPixels / height)
    throw InputError(path, 0, "dataWindow", fmt::format("{} x {}", width, height), "the size of an image");
  const std::string name = depth_channel(path, file.header().channels());
  const Imf::Channel* channel = file.header().channels().findChannel(name);
  if (channel->xSampling != 1 || channel->ySampling != 1)
    throw InputError(path, 0, name, "a subsampled channel", "a value for every pixel");
  if (!file.isComplete()) throw InputError(path, 0, "", "a file that was cut short", "a whole image");

  cv::Mat depth(static_cast<int>(height), static_cast<int>(width), CV_32F);
  // OpenEXR counts from the origin of the plane in which the data window lies.
  char* origin = reinterpret_cast<char*>(depth.data) -
                 static_cast<std::int64_t>(sizeof(float)) * (window.min.x + width * window.min.y);
  Imf::FrameBuffer pixels;
  pixels.insert(
      name, Imf::Slice(Imf::FLOAT, origin, sizeof(float), sizeof(float) * static_cast<std::size_t>(width)));
  file.setFrameBuffer(pixels);
  file.readPixels(window.min.y, window.max.y);
  return depth;
}

}  // namespace

bool is_exr_file(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error) && Imf::isOpenExrFile(path.string().c_str());
}

cv::Mat read_exr_depth(const std::filesystem::path& path) {
  try {
    Imf::InputFile file(path.string().c_str());
    return read_channel(path, file);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    std::string reason = error.what();
    for (char& c : reason)
      if (c == '\n') c = ' ';
    throw InputError(path, 0, "", reason, "a whole EXR file with plain pixels");
  }
}

}  // namespace framewise
