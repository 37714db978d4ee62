// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/evaluation/presets.h"

#include <stdexcept>

namespace framewise {
namespace {

EvaluationOptions evo() {
  EvaluationOptions options;
  options.alignment = Alignment::kNone;
  options.relative.pairs = PairChoice::kConsecutive;
  options.relative.order = RelativeErrorOrder::kEvo;
  return options;
}

EvaluationOptions tum() {
  EvaluationOptions options;
  options.association = {AssociationMethod::kGreedy, 0.02, 0};
  options.alignment = Alignment::kSe3;
  options.relative.unit = DeltaUnit::kSeconds;
  options.relative.pairs = PairChoice::kTum;
  options.relative.order = RelativeErrorOrder::kTum;
  return options;
}

EvaluationOptions kitti() {
  EvaluationOptions options = evo();
  options.association.method = AssociationMethod::kIndex;
  return options;
}

EvaluationOptions lab() {
  EvaluationOptions options = evo();
  options.association.method = AssociationMethod::kInterpolated;
  options.alignment = Alignment::kOrigin;
  return options;
}

}  // namespace

EvaluationOptions evaluation_preset(const std::string& name) {
  if (name == "evo") return evo();
  if (name == "tum") return tum();
  if (name == "kitti") return kitti();
  if (name == "lab") return lab();
  throw std::invalid_argument("preset is '" + name + "', expected one of evo tum kitti lab");
}

}  // namespace framewise
