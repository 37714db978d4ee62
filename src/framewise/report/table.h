// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace framewise {

// Text in rows and columns, and what stands above and below it.
struct Table {
  struct Column {
    std::string heading;
    bool is_number = true;  // stands at the right
  };
  struct Cell {
    Cell(std::string text, bool bold = false) : text(std::move(text)), bold(bold) {}
    Cell(const char* text) : text(text) {}
    std::string text;
    bool bold = false;  // not in CSV
  };

  std::string caption;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  // each as long as columns
  std::vector<std::string> notes;       // a line each, below
};

// RFC 4180, lines ended by '\n'; no caption and no notes: a header and values that programs read.
std::string to_csv(const Table& table);

// A pipe table with aligned columns, the caption above, the notes as a list below; GitHub's Markdown.
std::string to_markdown(const Table& table);

// A plain tabular with \hline, no packages needed; caption and notes as text. What LaTeX would read as a
// command is escaped.
std::string to_latex(const Table& table);

// Throw std::invalid_argument where a row is not as long as the header.

}  // namespace framewise
