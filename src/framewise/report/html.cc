// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/html.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace framewise {
namespace {

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
}

// Length of the UTF-8 letter that begins at `at` (RFC 3629); 0 where none does.
std::size_t letter_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0;
  };
  const unsigned first = byte(0);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  const unsigned second = byte(1);
  const bool is_overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool is_beyond = (first == 0xED && second > 0x9F) || (first == 0xF4 && second > 0x8F);
  return length > 2 && (is_overlong || is_beyond) ? 0 : length;
}

std::string html_row(const std::vector<Table::Cell>& cells, const std::vector<Table::Column>& columns) {
  if (cells.size() != columns.size())
    throw std::invalid_argument(
        fmt::format("table: a row has {} cells, expected {}", cells.size(), columns.size()));
  std::string row = "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i)
    row += fmt::format("<td{}>{}{}{}</td>", columns[i].is_number ? " class=\"number\"" : "",
                       cells[i].bold ? "<b>" : "", html_text(cells[i].text), cells[i].bold ? "</b>" : "");
  return row + "</tr>\n";
}

}  // namespace

std::string html_text(std::string_view text) {
  std::string safe;
  safe.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = letter_length(text, i);
    const char c = text[i];
    if (length == 0)
      safe += "\xEF\xBF\xBD";
    else if (length > 1)
      safe += text.substr(i, length);
    else if (c == '&' || c == '<' || c == '>' || c == '"' || c == '\'')
      safe += fmt::format("&#{};", static_cast<int>(c));
    else if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t')
      safe += c;
    i += std::max<std::size_t>(length, 1);
  }
  return safe;
}

std::string html_json(const nlohmann::ordered_json& json) {
  std::string text = json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  replace_all(text, "<", "\\u003c");
  return text;
}

std::string html_table(const Table& table) {
  std::string html = "<div class=\"wide\"><table>\n";
  if (!table.caption.empty()) html += fmt::format("<caption>{}</caption>\n", html_text(table.caption));
  html += "<thead><tr>";
  for (const Table::Column& column : table.columns)
    html += fmt::format("<th{} scope=\"col\">{}</th>", column.is_number ? " class=\"number\"" : "",
                        html_text(column.heading));
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) html += html_row(row, table.columns);
  html += "</tbody></table></div>\n";
  if (table.notes.empty()) return html;
  html += "<ul class=\"notes\">\n";
  for (const std::string& note : table.notes) html += fmt::format("<li>{}</li>\n", html_text(note));
  return html + "</ul>\n";
}

std::string html_list(const std::vector<std::pair<std::string, std::string>>& entries) {
  std::string html = "<dl>\n";
  for (const auto& [what, which] : entries)
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", html_text(what), html_text(which));
  return html + "</dl>\n";
}

// RFC 4648, section 4.
std::string data_uri(std::string_view media_type, std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string uri = fmt::format("data:{};base64,", media_type);
  uri.reserve(uri.size() + (bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      uri += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63];
  }
  return uri;
}

std::string figure_text(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "unknown";
}

}  // namespace framewise
