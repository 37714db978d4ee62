// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

namespace framewise {

// What is known of a frame's pose. Every frame has one, and a frame that failed says so.
enum class Status {
  kOk,            // rotation and translation were measured
  kLowParallax,   // the translation direction is uncertain
  kRotationOnly,  // the camera only turned; the step's translation is zero
  kPredicted,     // not measured; foretold from the motion before
  kNoDepth,       // the method needs depth and the frame has too little; the last pose is repeated
  kLost           // no motion explains the matches; the last pose is repeated
};

inline constexpr std::array kAllStatuses = {Status::kOk,        Status::kLowParallax, Status::kRotationOnly,
                                            Status::kPredicted, Status::kNoDepth,     Status::kLost};

constexpr std::string_view name(Status status) {
  constexpr std::array<std::string_view, 6> kNames = {"ok",        "low-parallax", "rotation-only",
                                                      "predicted", "no-depth",     "lost"};
  return kNames[static_cast<std::size_t>(status)];
}

// Whether the frame's pose was measured against the frame before it.
constexpr bool is_measured(Status status) {
  return status == Status::kOk || status == Status::kLowParallax || status == Status::kRotationOnly;
}

}  // namespace framewise
