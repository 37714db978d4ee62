// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/features/feature_names.h"

#include <array>
#include <stdexcept>
#include <utility>

namespace framewise {
namespace {

#ifdef FRAMEWISE_WITH_SURF
constexpr bool kWithSurf = true;
#else
constexpr bool kWithSurf = false;
#endif

template <typename Value>
using Named = std::pair<const char*, Value>;

constexpr std::array<Named<Detector>, 4> kDetectors{{{"sift", Detector::kSift},
                                                     {"surf", Detector::kSurf},
                                                     {"orb", Detector::kOrb},
                                                     {"akaze", Detector::kAkaze}}};
constexpr std::array<Named<Descriptor>, 5> kDescriptors{{{"sift", Descriptor::kSift},
                                                         {"surf", Descriptor::kSurf},
                                                         {"surf-128", Descriptor::kSurf128},
                                                         {"orb", Descriptor::kOrb},
                                                         {"akaze", Descriptor::kAkaze}}};
constexpr std::array<Named<Spread>, 3> kSpreads{
    {{"none", Spread::kNone}, {"grid", Spread::kGrid}, {"anms", Spread::kAnms}}};

bool is_built(const std::string& name) { return kWithSurf || !name.starts_with("surf"); }

template <typename Value, std::size_t kCount>
std::vector<std::string> names_built(const std::array<Named<Value>, kCount>& known) {
  std::vector<std::string> names;
  for (const auto& [name, value] : known)
    if (is_built(name)) names.emplace_back(name);
  return names;
}

template <typename Value, std::size_t kCount>
Value value_of(const char* option, const std::string& found, const std::array<Named<Value>, kCount>& known) {
  for (const auto& [name, value] : known)
    if (found == name && is_built(name)) return value;
  std::string message = std::string(option) + ": found '" + found + "'";
  if (!is_built(found)) message += ", which this build leaves out (FRAMEWISE_WITH_SURF=OFF)";
  message += ", expected one of";
  for (const std::string& name : names_built(known)) message += " " + name;
  throw std::invalid_argument(message);
}

}  // namespace

const std::vector<std::string>& detector_names() {
  static const auto names = names_built(kDetectors);
  return names;
}

const std::vector<std::string>& descriptor_names() {
  static const auto names = names_built(kDescriptors);
  return names;
}

Detector detector_of(const std::string& name) { return value_of("detector", name, kDetectors); }
Descriptor descriptor_of(const std::string& name) { return value_of("descriptor", name, kDescriptors); }
Spread spread_of(const std::string& name) { return value_of("spread", name, kSpreads); }

}  // namespace framewise
