// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/video_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/videoio.hpp>

#include "framewise/image/gray_image.h"
#include "framewise/io/file_names.h"
#include "framewise/io/input_error.h"

namespace framewise {
namespace {

constexpr std::size_t kMostBytes = 32 << 20, kFewestKept = 16;
constexpr double kUsualRate = 30;  // where a container knows none

// The container's times where they increase, else even ones.
std::vector<double> checked_times(std::vector<double> times, double rate) {
  const bool increase = std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) == times.end();
  if (increase) return times;
  for (std::size_t i = 0; i < times.size(); ++i)
    times[i] = static_cast<double>(i) / (rate > 0 && rate < 1e5 ? rate : kUsualRate);
  return times;
}

}  // namespace

bool is_video_name(const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  for (const char* known : {".mp4", ".avi", ".mkv", ".mov", ".m4v", ".webm", ".mpg", ".mpeg", ".wmv", ".ogv"})
    if (extension == known) return true;
  return false;
}

VideoFile::VideoFile(const std::filesystem::path& path) : path_(path) {
  open();
  const double rate = capture_->get(cv::CAP_PROP_FPS);
  std::vector<double> times;
  while (capture_->grab()) {
    times.push_back(capture_->get(cv::CAP_PROP_POS_MSEC) / 1e3);
    if (times.size() > 1) continue;
    cv::Mat first;
    if (capture_->retrieve(first)) size_ = first.size();
  }
  if (times.empty() || size_.empty())
    throw InputError(path, 0, "", "no frame that can be decoded", "a video");
  times_ = checked_times(std::move(times), rate);
  most_kept_ = std::max(kFewestKept, kMostBytes / static_cast<std::size_t>(size_.area()));
  open();
}

VideoFile::~VideoFile() = default;

void VideoFile::open() {
  if (!std::filesystem::is_regular_file(path_)) throw InputError(path_, 0, "", "no file", "a video");
  bool opened = false;
  try {
    capture_ = std::make_unique<cv::VideoCapture>(path_.string());
    opened = capture_->isOpened();
  } catch (const cv::Exception&) {  // no decoder understands it
  }
  if (!opened) throw InputError(path_, 0, "", "data that no video format explains", "a video");
  next_ = 0;
}

void VideoFile::decode_next() {
  cv::Mat image;
  if (!capture_->retrieve(image) || image.size() != size_)
    throw InputError(path_, 0, fmt::format("frame {}", next_), "an image that cannot be decoded",
                     "a whole video");
  kept_[next_] = gray_image(image).clone();  // the decoder writes the next one to the same place
  if (kept_.size() > most_kept_) kept_.erase(kept_.begin());
}

void VideoFile::skip_to(std::size_t index) {
  if (index < next_) {
    kept_.clear();
    open();
  }
  for (; next_ <= index; ++next_) {
    if (!capture_->grab())
      throw InputError(path_, 0, fmt::format("frame {}", next_), "the end of the video", "another frame");
    if (next_ + most_kept_ > index) decode_next();
  }
}

cv::Mat VideoFile::gray(std::size_t index) {
  const std::lock_guard lock(decoding_);
  if (const auto found = kept_.find(index); found != kept_.end()) return found->second;
  skip_to(index);
  return kept_.at(index);
}

}  // namespace framewise
