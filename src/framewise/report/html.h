// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "framewise/report/table.h"

namespace framewise {

// Text that HTML and SVG show as it is, between tags and in quoted attributes. Control characters that XML
// does not allow are left out.
std::string html_text(std::string_view text);

// JSON to stand in a <script>: nothing in it ends the element or begins a comment. Bytes that are not UTF-8
// become U+FFFD.
std::string html_json(const nlohmann::ordered_json& json);

// A table with caption and notes, that scrolls sideways where it is too wide.
std::string html_table(const Table& table);

// Two columns, what and which, for options and the like.
std::string html_list(const std::vector<std::pair<std::string, std::string>>& entries);

// As src of an image: data:image/jpeg;base64,...
std::string data_uri(std::string_view media_type, std::string_view bytes);

// So many significant digits; "unknown" for what is not finite.
std::string figure_text(double value, int digits = 6);

}  // namespace framewise
