// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>

namespace framewise {

// Whether a file begins as OpenEXR files do. No file at all is none.
bool is_exr_file(const std::filesystem::path& path);

// CV_32F: the channel Z, of a layer if need be ("ViewLayer.Depth.Z"), else V (Blender's name for it), else
// the first. Throws InputError that names the file where it is cut short, damaged, or without a plain image.
cv::Mat read_exr_depth(const std::filesystem::path& path);

}  // namespace framewise
