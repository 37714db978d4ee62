// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/association.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <tuple>

namespace framewise {
namespace {

// For each stamp of few, the nearest of many + offset.
std::vector<std::pair<std::size_t, std::size_t>> nearest_of_many(std::span<const double> few,
                                                                 std::span<const double> many, double offset,
                                                                 double max_difference) {
  std::vector<double> shifted(many.begin(), many.end());
  for (double& t : shifted) t += offset;
  std::vector<std::pair<std::size_t, std::size_t>> matches;
  for (std::size_t i = 0; i < few.size(); ++i) {
    const std::size_t j = nearest_index(shifted, few[i]);
    if (std::abs(shifted[j] - few[i]) <= max_difference) matches.emplace_back(i, j);
  }
  return matches;
}

std::string span_of(const Trajectory& trajectory) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << trajectory.size() << " poses from " << std::fixed << std::setprecision(6)
       << trajectory.times.front() << " s to " << trajectory.times.back() << " s";
  return text.str();
}

std::string no_match(const Trajectory& reference, const Trajectory& estimate,
                     const AssociationOptions& options) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "no pose of the estimate matches the reference in time: reference has " << span_of(reference)
       << ", estimate has " << span_of(estimate) << ", limit " << options.max_difference << " s, time offset "
       << options.time_offset << " s";
  return text.str();
}

TrajectoryPair interpolated_reference(const Trajectory& reference, const Trajectory& estimate,
                                      const AssociationOptions& options) {
  TrajectoryPair pair;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    const double time = estimate.times[i] + options.time_offset;
    const auto pose = pose_at(reference, time, 2 * options.max_difference);
    if (!pose) continue;
    pair.reference.add(time, *pose);
    pair.estimate.add(estimate.times[i], estimate.world_from_cam[i]);
  }
  return pair;
}

std::vector<Match> matches_of(const Trajectory& reference, const Trajectory& estimate,
                              const AssociationOptions& options) {
  switch (options.method) {
    case AssociationMethod::kGreedy:
      return associate_greedy(reference.times, estimate.times, options.max_difference, options.time_offset);
    case AssociationMethod::kIndex: {
      if (reference.size() != estimate.size())
        throw std::invalid_argument("association by index: reference has " +
                                    std::to_string(reference.size()) + " poses, estimate has " +
                                    std::to_string(estimate.size()) + ", expected as many");
      std::vector<Match> matches;
      for (std::size_t i = 0; i < reference.size(); ++i) matches.push_back({i, i});
      return matches;
    }
    default:
      return associate_nearest(reference.times, estimate.times, options.max_difference, options.time_offset);
  }
}

}  // namespace

std::size_t nearest_index(std::span<const double> increasing, double x) {
  const auto after = std::lower_bound(increasing.begin(), increasing.end(), x);
  if (after == increasing.begin()) return 0;
  const std::size_t j = after - increasing.begin();
  if (after == increasing.end()) return j - 1;
  return x - increasing[j - 1] <= increasing[j] - x ? j - 1 : j;
}

std::vector<Match> associate_nearest(std::span<const double> reference, std::span<const double> estimate,
                                     double max_difference, double time_offset) {
  std::vector<Match> matches;
  if (reference.empty() || estimate.empty()) return matches;
  if (estimate.size() > reference.size()) {
    for (const auto& [i, j] : nearest_of_many(reference, estimate, time_offset, max_difference))
      matches.push_back({i, j});
  } else {
    for (const auto& [i, j] : nearest_of_many(estimate, reference, -time_offset, max_difference))
      matches.push_back({j, i});
  }
  return matches;
}

std::vector<Match> associate_greedy(std::span<const double> reference, std::span<const double> estimate,
                                    double max_difference, double time_offset) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> candidates;
  std::size_t first = 0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    while (first < estimate.size() && estimate[first] + time_offset <= reference[i] - max_difference) ++first;
    for (std::size_t j = first; j < estimate.size(); ++j) {
      const double difference = std::abs(reference[i] - (estimate[j] + time_offset));
      if (difference < max_difference) candidates.emplace_back(difference, i, j);
      if (estimate[j] + time_offset >= reference[i] + max_difference) break;
    }
  }
  std::sort(candidates.begin(), candidates.end());

  std::vector<bool> reference_used(reference.size()), estimate_used(estimate.size());
  std::vector<Match> matches;
  for (const auto& [difference, i, j] : candidates) {
    if (reference_used[i] || estimate_used[j]) continue;
    reference_used[i] = estimate_used[j] = true;
    matches.push_back({i, j});
  }
  std::sort(matches.begin(), matches.end(),
            [](const Match& a, const Match& b) { return a.reference < b.reference; });
  return matches;
}

TrajectoryPair associate(const Trajectory& reference, const Trajectory& estimate,
                         const AssociationOptions& options) {
  if (reference.empty()) throw std::invalid_argument("reference has no poses, expected one or more");
  if (estimate.empty()) throw std::invalid_argument("estimate has no poses, expected one or more");
  TrajectoryPair pair;
  if (options.method == AssociationMethod::kInterpolated) {
    pair = interpolated_reference(reference, estimate, options);
  } else {
    for (const Match& m : matches_of(reference, estimate, options)) {
      pair.reference.add(reference.times[m.reference], reference.world_from_cam[m.reference]);
      pair.estimate.add(estimate.times[m.estimate], estimate.world_from_cam[m.estimate]);
    }
  }
  if (pair.size() == 0) throw std::invalid_argument(no_match(reference, estimate, options));
  return pair;
}

}  // namespace framewise
