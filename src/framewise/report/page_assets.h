// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace framewise::page_assets {

// The files of web/ as the build put them into the program.
std::string_view style();
std::string_view script();
std::string_view plotly();  // empty in a build without it

}  // namespace framewise::page_assets
