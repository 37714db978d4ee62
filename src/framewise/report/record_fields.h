// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace framewise {

// What a record says at a place ("/dataset/name"), as far as it says anything there: a file that another
// version wrote, or a person changed, still makes a page.

// Numbers and truth values as they are written; empty where there is nothing.
inline std::string record_text(const nlohmann::ordered_json& record, const std::string& place) {
  const nlohmann::ordered_json::json_pointer pointer(place);
  if (!record.contains(pointer) || record[pointer].is_null()) return "";
  const auto& value = record[pointer];
  if (value.is_string()) return value.get<std::string>();
  return value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

inline std::optional<double> record_number(const nlohmann::ordered_json& record, const std::string& place) {
  const nlohmann::ordered_json::json_pointer pointer(place);
  if (!record.contains(pointer) || !record[pointer].is_number()) return std::nullopt;
  return record[pointer].get<double>();
}

}  // namespace framewise
