// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <opencv2/core.hpp>
#include <vector>

namespace cv {
class VideoCapture;
}

namespace framewise {

// Whether a file's ending is a video's: .mp4, .avi, .mkv, …
bool is_video_name(const std::filesystem::path& file);

// A video's frames by their number, asked for in any order from any thread. Videos are decoded from the
// front: the decoder goes on from where it is, keeps the frames it passed last (32 MiB of them, 16 at least),
// and begins again where an earlier one is wanted. So frames asked for nearly in order cost what playing the
// video does, and memory does not grow with its length.
class VideoFile {
 public:
  // Plays the whole video once for its frames' times: how many a header promises is not to be trusted. Throws
  // InputError where it is none, or has no frames.
  explicit VideoFile(const std::filesystem::path& path);
  ~VideoFile();

  // s, strictly increasing: the container's, else even at its rate.
  const std::vector<double>& times() const { return times_; }
  cv::Size size() const { return size_; }

  // CV_8U. Throws InputError where the frame cannot be decoded (again).
  cv::Mat gray(std::size_t index);

 private:
  void open();
  void skip_to(std::size_t index);
  void decode_next();

  std::filesystem::path path_;
  std::vector<double> times_;
  cv::Size size_;
  std::size_t most_kept_ = 0;
  std::mutex decoding_;
  std::unique_ptr<cv::VideoCapture> capture_;
  std::size_t next_ = 0;                 // what the decoder gives next
  std::map<std::size_t, cv::Mat> kept_;  // the last frames it gave
};

}  // namespace framewise
