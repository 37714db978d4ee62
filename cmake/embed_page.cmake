# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
#
# cmake -DSTYLE= -DMODULES= -DPLOTLY= -DOUTPUT= -P: the page's files as C++. Modules become one script: imports go,
# since what they name stands above.
file(READ ${STYLE} style)
set(script "")
foreach(module IN LISTS MODULES)
  file(READ ${module} text)
  string(REGEX REPLACE "(^|\n)(import|// SPDX)[^\n]*" "" text "${text}")
  string(REGEX REPLACE "(^|\n)export " "\\1" text "${text}")
  string(APPEND script "${text}")
endforeach()
file(READ ${PLOTLY} plotly)

foreach(name style script plotly)
  string(FIND "${${name}}" ")framewise\"" clash)
  string(FIND "${${name}}" "</script" ends)
  if(NOT clash EQUAL -1 OR NOT ends EQUAL -1)
    message(FATAL_ERROR "embed_page: ${name} holds what would end its place in the page")
  endif()
endforeach()
file(WRITE ${OUTPUT} "#include \"framewise/report/page_assets.h\"

namespace framewise::page_assets {

std::string_view style() { return R\"framewise(${style})framewise\"; }
std::string_view script() { return R\"framewise((() => {${script}})();
)framewise\"; }
std::string_view plotly() { return R\"framewise(${plotly})framewise\"; }

}  // namespace framewise::page_assets
")
