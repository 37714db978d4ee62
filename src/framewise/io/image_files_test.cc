// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/image_files.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "framewise/io/exr_file.h"
#include "framewise/io/input_error.h"
#include "framewise/io/test_files_for_tests.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

cv::Mat ramp() {
  cv::Mat image(24, 32, CV_32F);
  for (int v = 0; v < image.rows; ++v)
    for (int u = 0; u < image.cols; ++u)
      image.at<float>(v, u) = 0.5f + 0.25f * static_cast<float>(u) + static_cast<float>(v);
  return image;
}

// An EXR file whose channels hold multiples of the image: the first once, the second twice, and so on.
void write_exr(const fs::path& path, const cv::Mat& image, const std::vector<std::string>& channels,
               Imf::PixelType type, Imf::Compression compression = Imf::ZIP_COMPRESSION) {
  Imf::Header header(image.cols, image.rows);
  header.compression() = compression;
  std::vector<std::vector<float>> floats;
  std::vector<std::vector<half>> halves;
  Imf::FrameBuffer pixels;
  for (std::size_t k = 0; k < channels.size(); ++k) {
    header.channels().insert(channels[k], Imf::Channel(type));
    const cv::Mat values = image * static_cast<double>(k + 1);
    floats.emplace_back(values.begin<float>(), values.end<float>());
    halves.emplace_back(floats.back().begin(), floats.back().end());
  }
  for (std::size_t k = 0; k < channels.size(); ++k) {
    const bool is_half = type == Imf::HALF;
    char* data =
        is_half ? reinterpret_cast<char*>(halves[k].data()) : reinterpret_cast<char*>(floats[k].data());
    const std::size_t step = is_half ? sizeof(half) : sizeof(float);
    pixels.insert(channels[k], Imf::Slice(type, data, step, step * image.cols));
  }
  Imf::OutputFile file(path.string().c_str(), header);
  file.setFrameBuffer(pixels);
  file.writePixels(image.rows);
}

bool same_values(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && std::equal(a.datastart, a.dataend, b.datastart);
}

// Every length of the file that is less than whole is refused, and never read as something.
void expect_cut_short_is_refused(const fs::path& path) {
  std::ifstream whole(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(whole), {}};
  whole.close();
  for (std::size_t size = 0; size + 16 < bytes.size(); size += std::max<std::size_t>(1, bytes.size() / 31)) {
    std::ofstream(path, std::ios::binary | std::ios::trunc)
        .write(bytes.data(), static_cast<std::streamsize>(size));
    try {
      read_depth_file(path);
      ADD_FAILURE() << size << " of " << bytes.size() << " bytes were read as an image";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(path.filename().string()));
      EXPECT_THAT(error.what(), testing::Not(HasSubstr("\n")));
    }
  }
}

TEST(ReadDepthFile, Reads16BitPngAsStored) {
  cv::Mat raw;
  ramp().convertTo(raw, CV_16U, 1000);
  write_image(test_file("depth.png"), raw);
  EXPECT_TRUE(same_values(read_depth_file(test_file("depth.png")), raw));
  expect_cut_short_is_refused(test_file("depth.png"));
}

TEST(ReadDepthFile, ReadsTiffOfFloatsAndOf16Bits) {
  write_image(test_file("depth.tiff"), ramp());
  EXPECT_TRUE(same_values(read_depth_file(test_file("depth.tiff")), ramp()));
  cv::Mat raw;
  ramp().convertTo(raw, CV_16U, 1000);
  write_image(test_file("raw.tiff"), raw);
  EXPECT_TRUE(same_values(read_depth_file(test_file("raw.tiff")), raw));
  expect_cut_short_is_refused(test_file("depth.tiff"));
}

TEST(ReadDepthFile, ReadsExrOfFloatsAndHalves) {
  for (const Imf::PixelType type : {Imf::FLOAT, Imf::HALF})
    for (const Imf::Compression compression :
         {Imf::NO_COMPRESSION, Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION}) {
      write_exr(test_file("depth.exr"), ramp(), {"Y"}, type, compression);
      EXPECT_TRUE(
          same_values(read_depth_file(test_file("depth.exr")), ramp()));  // quarters are exact in halves
      expect_cut_short_is_refused(test_file("depth.exr"));
    }
}

TEST(ReadDepthFile, TakesTheChannelOfDepthFromAnExrOfSeveral) {
  const auto factor = [](const std::vector<std::string>& channels) {
    write_exr(test_file("depth.exr"), ramp(), channels, Imf::FLOAT);
    return read_depth_file(test_file("depth.exr")).at<float>(0, 0) / ramp().at<float>(0, 0);
  };
  EXPECT_EQ(factor({"B", "G", "R", "Z"}), 4);
  EXPECT_EQ(factor({"View Layer.Combined.R", "View Layer.Depth.Z"}), 2);
  EXPECT_EQ(factor({"A", "V"}), 2);
  EXPECT_EQ(factor({"B", "G", "R"}), 1);
}

TEST(ReadDepthFile, RefusesWhatIsNoDepth) {
  const auto refuses = [](const fs::path& path, const char* word) {
    try {
      read_depth_file(path);
      ADD_FAILURE() << path;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(path.filename().string()));
      EXPECT_THAT(error.what(), HasSubstr(word));
    }
  };
  cv::imwrite(test_file("gray.png").string(), cv::Mat(4, 4, CV_8U, cv::Scalar(7)));
  cv::imwrite(test_file("color.png").string(), cv::Mat(4, 4, CV_16UC3, cv::Scalar(7, 7, 7)));
  cv::imwrite(test_file("alpha.png").string(), cv::Mat(4, 4, CV_16UC4, cv::Scalar(7, 7, 7, 7)));
  cv::imwrite(test_file("double.tiff").string(), cv::Mat(4, 4, CV_64F, cv::Scalar(7)));
  std::ofstream(test_file("text.exr")) << "depth";
  refuses(test_file("gray.png"), "8 bits");
  refuses(test_file("color.png"), "3 channel");
  refuses(test_file("alpha.png"), "4 channel");
  refuses(test_file("double.tiff"), "64 bits");
  refuses(test_file("text.exr"), "no image format");
  refuses(test_file("nothing.exr"), "no file");
}

TEST(ReadDepthFile, SurvivesDamagedExrFiles) {
  write_exr(test_file("depth.exr"), ramp(), {"Y"}, Imf::FLOAT);
  std::ifstream whole(test_file("depth.exr"), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(whole), {}};
  for (std::size_t i = 0; i < bytes.size(); i += 7) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0xa5);
    std::ofstream(test_file("depth.exr"), std::ios::binary | std::ios::trunc) << damaged;
    try {
      read_depth_file(test_file("depth.exr"));  // values may differ, the program may not end
    } catch (const InputError&) {
    }
  }
}

TEST(WriteImage, NamesAFileThatCannotBeWritten) {
  const cv::Mat image(4, 4, CV_8U, cv::Scalar(7));
  EXPECT_THROW(write_image(test_file("x").parent_path() / "no folder" / "image.png", image),
               std::runtime_error);
  EXPECT_THROW(write_image(test_file("image.unheard-of"), image), std::runtime_error);
}

}  // namespace
}  // namespace framewise
