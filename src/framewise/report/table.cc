// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/report/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace framewise {
namespace {

void check(const Table& table) {
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    if (table.rows[i].size() != table.columns.size())
      throw std::invalid_argument(fmt::format("table: row {} has {} cells, expected {}", i,
                                              table.rows[i].size(), table.columns.size()));
}

template <typename Range, typename Text>
std::string joined(const Range& range, const std::string& separator, Text&& text) {
  std::string all;
  for (const auto& item : range) all += (&item == &*range.begin() ? "" : separator) + text(item);
  return all;
}

std::string csv_value(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string markdown_text(const std::string& text) {
  std::string escaped;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool ends_link = c == ']' && i + 1 < text.size() &&
                           std::string_view("([:").find(text[i + 1]) != std::string_view::npos;
    if (ends_link || std::string_view("\\`*_|<>").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c == '\n' || c == '\r' ? ' ' : c;
  }
  return escaped;
}

std::string latex_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\\')
      escaped += "\\textbackslash{}";
    else if (c == '~' || c == '^')
      escaped += std::string(c == '~' ? "\\textasciitilde" : "\\textasciicircum") + "{}";
    else if (c == '[' || c == ']')  // after the end of a row it would begin an argument
      escaped += std::string("{") + c + "}";
    else if (c == '<' || c == '>')
      escaped += std::string("$") + c + "$";
    else if (std::string_view("&%$#_{}").find(c) != std::string_view::npos)
      escaped += std::string("\\") + c;
    else
      escaped += c == '\n' || c == '\r' ? ' ' : c;
  }
  return escaped;
}

// Letters as a reader counts them: bytes that continue a UTF-8 letter are none.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](unsigned char c) { return (c & 0xC0) != 0x80; }));
}

std::string markdown_line(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths,
                          const std::vector<Table::Column>& columns) {
  std::string line = "|";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string gap(widths[i] - width(cells[i]), ' ');
    line +=
        columns[i].is_number ? fmt::format(" {}{} |", gap, cells[i]) : fmt::format(" {}{} |", cells[i], gap);
  }
  return line + "\n";
}

}  // namespace

std::string to_csv(const Table& table) {
  check(table);
  std::string text = joined(table.columns, ",", [](const auto& c) { return csv_value(c.heading); }) + "\n";
  for (const auto& row : table.rows)
    text += joined(row, ",", [](const Table::Cell& cell) { return csv_value(cell.text); }) + "\n";
  return text;
}

std::string to_markdown(const Table& table) {
  check(table);
  std::vector<std::vector<std::string>> lines(1);
  for (const auto& column : table.columns) lines[0].push_back(markdown_text(column.heading));
  for (const auto& row : table.rows) {
    lines.emplace_back();
    for (const Table::Cell& cell : row) {
      const std::string text = markdown_text(cell.text);
      lines.back().push_back(cell.bold ? fmt::format("**{}**", text) : text);
    }
  }
  std::vector<std::size_t> widths(table.columns.size(), 3);
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], width(line[i]));

  std::string text =
      fmt::format("{}\n\n{}|", markdown_text(table.caption), markdown_line(lines[0], widths, table.columns));
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const std::string dashes(widths[i] + 1, '-');
    text += table.columns[i].is_number ? fmt::format("{}:|", dashes) : fmt::format(":{}|", dashes);
  }
  text += "\n";
  for (std::size_t i = 1; i < lines.size(); ++i) text += markdown_line(lines[i], widths, table.columns);
  if (!table.notes.empty()) text += "\n";
  for (const std::string& note : table.notes) text += fmt::format("- {}\n", markdown_text(note));
  return text;
}

std::string to_latex(const Table& table) {
  check(table);
  const auto place = [](const auto& column) { return std::string(column.is_number ? "r" : "l"); };
  const auto heading = [](const auto& column) { return latex_text(column.heading); };
  const auto value = [](const Table::Cell& cell) {
    return cell.bold ? fmt::format("\\textbf{{{}}}", latex_text(cell.text)) : latex_text(cell.text);
  };
  std::string text = fmt::format("\\noindent {}\n\n\\medskip\\noindent\n\\begin{{tabular}}{{{}}}\n\\hline\n",
                                 latex_text(table.caption), joined(table.columns, "", place));
  text += joined(table.columns, " & ", heading) + " \\\\\n\\hline\n";
  for (const auto& row : table.rows) text += joined(row, " & ", value) + " \\\\\n";
  text += "\\hline\n\\end{tabular}\n";
  for (const std::string& note : table.notes) text += fmt::format("\n\\noindent {}\n", latex_text(note));
  return text;
}

}  // namespace framewise
