// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

#include "framewise/simulation/path.h"
#include "framewise/simulation/rgbd_sensor.h"

namespace framewise {

// How a camera turns light into bytes. Every effect is off unless asked for.
struct ImagingOptions {
  double exposure_time = 0;  // how long the shutter is open (s); 0: an instant, without motion blur
  int blur_samples = 8;      // instants of which a frame with an exposure time is the mean
  double readout_time = 0;   // from the first row to the last, a rolling shutter's (s); 0: all rows at once
  double photons = 0;        // electrons in a pixel that is just white; 0: light without noise
  double read_noise = 0;     // of reading a pixel out (standard deviation, electrons); needs photons
  double gamma = 0;          // byte = 255 light^(1 / gamma); 0: sRGB's curve
  double vignetting = 0;     // 0: none, 1: that of a simple lens, cosine to the fourth

  bool is_plain() const {
    return exposure_time == 0 && readout_time == 0 && photons == 0 && gamma == 0 && vignetting == 0;
  }
  bool is_instant() const { return exposure_time == 0 && readout_time == 0; }

  // Throws std::invalid_argument naming the option, what was found and what was expected; exposure and
  // readout have to end before the next frame, so many seconds later.
  void check(double time_between_frames) const;
};

// The light that falls into each pixel (see RgbdSensor::light) while the shutter is open: `time` is the
// middle of the exposure of the middle row, and with that the time of the frame's true pose.
cv::Mat expose(const RgbdSensor& sensor, const RayTracer& tracer, const Path& path, double time,
               const ImagingOptions& options);

// Bytes of light, CV_8UC3. Of e = light * vignetting * photons electrons a pixel counts Poisson(e), which is
// taken for normal above 50, and reads it with normal noise. The seed is the frame's.
//   EMVA Standard 1288, Standard for characterization of image sensors and cameras, 2016.
cv::Mat develop(const cv::Mat& light, const Camera& camera, const ImagingOptions& options,
                std::uint64_t seed);

}  // namespace framewise
