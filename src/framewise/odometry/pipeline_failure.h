// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <exception>

namespace framewise {

// A stage of a frame's passage, unless one before it failed; what it throws is kept in the passage.
template <typename Passage, typename Stage>
void attempt(Passage& passage, const Stage& stage) {
  if (passage.failure) return;
  try {
    stage();
  } catch (...) {
    passage.failure = std::current_exception();
  }
}

// What the first frame that failed threw. All frames before it are handed over, none after it, and nothing is
// thrown through the pipeline: TBB lets go of the frames on their way only where it comes to its end.
class PipelineFailure {
 public:
  bool happened() const { return happened_; }

  // The last stage, which sees the frames in order.
  template <typename Passage, typename Stage>
  void attempt_last(Passage& passage, const Stage& stage) {
    if (happened_) return;
    attempt(passage, stage);
    if (!passage.failure) return;
    failure_ = passage.failure;
    happened_ = true;
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::exception_ptr failure_;
  std::atomic<bool> happened_ = false;
};

}  // namespace framewise
