// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/image_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <string_view>
#include <vector>

#include "framewise/io/exr_file.h"
#include "framewise/io/input_error.h"

namespace framewise {
namespace {

using Bytes = std::vector<unsigned char>;

Bytes read_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file || std::filesystem::is_directory(path)) throw InputError(path, 0, "", "no file", "an image");
  const std::streamsize size = file.tellg();
  Bytes bytes(static_cast<std::size_t>(size));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(bytes.data()), size);
  if (file.gcount() != size) throw InputError(path, 0, "", "a file that cannot be read", "an image");
  if (bytes.empty()) throw InputError(path, 0, "", "an empty file", "an image");
  return bytes;
}

bool starts_with(const Bytes& bytes, std::string_view magic) {
  return bytes.size() >= magic.size() &&
         std::equal(magic.begin(), magic.end(), bytes.begin(),
                    [](char a, auto b) { return static_cast<unsigned char>(a) == b; });
}

bool contains_near_end(const Bytes& bytes, std::string_view mark) {
  const auto begin = bytes.size() > 4096 ? bytes.end() - 4096 : bytes.begin();
  return std::search(begin, bytes.end(), mark.begin(), mark.end(),
                     [](auto a, char b) { return a == static_cast<unsigned char>(b); }) != bytes.end();
}

// A TIFF's directory, whose place is in its first bytes, is as a rule written last.
bool lacks_tiff_directory(const Bytes& bytes) {
  const bool little = starts_with(bytes, std::string_view("II*\0", 4));
  if (!little && !starts_with(bytes, std::string_view("MM\0*", 4))) return false;
  if (bytes.size() < 8) return true;
  std::size_t place = 0;
  for (int k = 0; k < 4; ++k) place = place << 8 | bytes[little ? 7 - k : 4 + k];
  return place + 2 > bytes.size();
}

// Decoders fill what is missing with grey and report success, so the end mark is looked for first.
bool is_cut_short(const Bytes& bytes) {
  if (starts_with(bytes, "\x89PNG")) return !contains_near_end(bytes, "IEND");
  if (starts_with(bytes, "\xff\xd8\xff")) return !contains_near_end(bytes, "\xff\xd9");
  return lacks_tiff_directory(bytes);
}

cv::Mat decode(const std::filesystem::path& path, int flags) {
  const Bytes bytes = read_bytes(path);
  if (is_cut_short(bytes))
    throw InputError(path, 0, "", fmt::format("{} bytes without an end mark", bytes.size()), "a whole image");
  cv::Mat image;
  try {
    image = cv::imdecode(bytes, flags);
  } catch (const cv::Exception&) {
    image.release();
  }
  if (image.empty()) throw InputError(path, 0, "", "data that no image format explains", "an image");
  return image;
}

}  // namespace

cv::Mat read_gray(const std::filesystem::path& path) { return decode(path, cv::IMREAD_GRAYSCALE); }

cv::Mat read_image(const std::filesystem::path& path) {
  return is_exr_file(path) ? read_exr_depth(path) : decode(path, cv::IMREAD_UNCHANGED);
}

cv::Mat read_depth_file(const std::filesystem::path& path) {
  const cv::Mat image = read_image(path);
  if (image.type() != CV_16UC1 && image.type() != CV_32FC1)
    throw InputError(path, 0, "pixel type",
                     fmt::format("{} channel(s) of {} bits", image.channels(), 8 * image.elemSize1()),
                     "16-bit or float depth in one channel");
  return image;
}

void write_image(const std::filesystem::path& path, const cv::Mat& image) {
  bool written = false;
  try {
    written = cv::imwrite(path.string(), image, {cv::IMWRITE_PNG_COMPRESSION, 1});
  } catch (const cv::Exception&) {  // an ending that no format has
  }
  if (!written)
    throw InputError(path, 0, "", "an image file that cannot be written", "one to create, such as out.png");
}

}  // namespace framewise
