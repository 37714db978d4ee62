// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace framewise {

// What a figure's ink looks like on light and on dark paper. Truth is red, the estimate blue and their
// difference green.
struct Ink {
  std::string_view name, light, dark;
};

inline constexpr std::array kInks = {
    Ink{"truth", "#c62828", "#ff6b6b"},
    Ink{"estimate", "#1756c4", "#6ea8ff"},
    Ink{"difference", "#1f8a3b", "#5fd07f"},
    Ink{"final", "#7b2fb5", "#c792ff"},
    Ink{"x", "#c62828", "#ff6b6b"},
    Ink{"y", "#1f8a3b", "#5fd07f"},
    Ink{"z", "#1756c4", "#6ea8ff"},
    Ink{"load", "#757575", "#a0a0a0"},
    Ink{"features", "#c2570c", "#ffa15c"},
    Ink{"match", "#8a6d00", "#e0c341"},
    Ink{"step", "#1756c4", "#6ea8ff"},
    Ink{"matches", "#757575", "#a0a0a0"},
    Ink{"inliers", "#1f8a3b", "#5fd07f"},
    Ink{"ok", "#1f8a3b", "#3f9d5c"},
    Ink{"low-parallax", "#c9a400", "#d9bd45"},
    Ink{"rotation-only", "#1756c4", "#5b8fe0"},
    Ink{"predicted", "#7b2fb5", "#a86fe0"},
    Ink{"no-depth", "#c2570c", "#e08a4a"},
    Ink{"lost", "#c62828", "#e05555"},
    Ink{"other", "#757575", "#a0a0a0"},
};

// Rules for all figures: of the page, with both papers, and of a file on white.
std::string page_plot_style();
std::string file_plot_style();

}  // namespace framewise
