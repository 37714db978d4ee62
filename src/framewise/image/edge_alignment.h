// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace framewise {

// How depth would have to be moved for its edges to lie on edges of the photographs.
struct EdgeFit {
  double zoom = 1;     // about the image's middle
  int du = 0, dv = 0;  // pixels
  double score = 0;    // of this move: mean rank of the photograph's gradient under the depth's edges, 0 to 1
  double as_it_is = 0;    // the best score of moves that change nothing to speak of (2 pixels, 1 %)
  double spread = 0;      // standard deviation of the scores of all moves
  std::size_t edges = 0;  // pixels

  // Depth lies elsewhere than the photograph: another place fits better than this one by far.
  bool is_elsewhere() const { return score - as_it_is > 0.08 && score - as_it_is > 2.5 * spread; }
};

// Looks for that move over several frames of one camera, since a single one may have few edges, or chance
// ones.
class EdgeAlignment {
 public:
  // gray: CV_8U. depth: CV_32F, metres, unknown where not above 0 or NaN; of the same size as all others.
  void add(const cv::Mat& gray, const cv::Mat& depth);

  // Over zooms of 0.84 to 1.16 and shifts of 20 x 12 pixels. Empty with fewer than 1500 edge pixels in all.
  std::optional<EdgeFit> fit() const;

 private:
  struct View {
    cv::Mat rank;                    // CV_32F: share of pixels with a smaller gradient
    std::vector<cv::Point2f> edges;  // from the image's middle
  };
  double score(double zoom, int du, int dv) const;

  cv::Size size_;
  std::vector<View> views_;
};

// The pixels at a step of depth, on its nearer side: a neighbour is farther by 8 % or more.
std::vector<cv::Point> depth_edges(const cv::Mat& depth);

}  // namespace framewise
