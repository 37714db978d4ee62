# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What web/ has for report pages, as a source of the room `report`: style, script, and plotly for 3D scenes.
#
# plotly comes by npm, as web/package-lock.json pins it, when the program is built. Where there is no npm or no
# network, and with -DFRAMEWISE_WITH_PLOTLY=OFF, pages show trajectories from three sides instead of a scene;
# nothing else is missing. FRAMEWISE_PLOTLY names a plotly bundle at hand (with scatter3d) instead.
option(FRAMEWISE_WITH_PLOTLY "3D scenes in report pages (fetched with npm)" ON)
set(FRAMEWISE_PLOTLY "" CACHE FILEPATH "plotly's bundle with scatter3d; empty: fetched with npm")

# The script is put together from modules in this order; each imports from those before it.
set(FRAMEWISE_PAGE_MODULES theme camera scene marks matches run table overlay comparison main)

function(framewise_page_assets target)
  set(web ${PROJECT_SOURCE_DIR}/web)
  set(work ${CMAKE_CURRENT_BINARY_DIR}/page)
  list(TRANSFORM FRAMEWISE_PAGE_MODULES REPLACE "(.+)" "${web}/src/\\1.js" OUTPUT_VARIABLE modules)
  file(MAKE_DIRECTORY ${work})

  find_program(NPM npm)
  set(plotly ${work}/plotly.js)
  if(NOT FRAMEWISE_WITH_PLOTLY OR NOT (FRAMEWISE_PLOTLY OR NPM))
    message(STATUS "Report pages are built without plotly: maps instead of 3D scenes")
    set(plotly ${work}/no_plotly.js)
    file(WRITE ${plotly} "")
  elseif(FRAMEWISE_PLOTLY)
    set(plotly ${FRAMEWISE_PLOTLY})
  else()
    add_custom_command(OUTPUT ${plotly}
      COMMAND ${CMAKE_COMMAND} -DNPM=${NPM} -DWEB=${web} -DWORK=${work} -DOUTPUT=${plotly}
              -P ${PROJECT_SOURCE_DIR}/cmake/fetch_plotly.cmake
      DEPENDS ${web}/package.json ${web}/package-lock.json ${PROJECT_SOURCE_DIR}/cmake/fetch_plotly.cmake
      COMMENT "Fetching plotly" VERBATIM)
  endif()

  add_custom_command(OUTPUT ${work}/page_assets.cc
    COMMAND ${CMAKE_COMMAND} "-DSTYLE=${web}/style.css" "-DMODULES=${modules}" "-DPLOTLY=${plotly}"
            "-DOUTPUT=${work}/page_assets.cc" -P ${PROJECT_SOURCE_DIR}/cmake/embed_page.cmake
    DEPENDS ${web}/style.css ${modules} ${plotly} ${PROJECT_SOURCE_DIR}/cmake/embed_page.cmake
    COMMENT "Embedding the report page" VERBATIM)
  target_sources(${target} PRIVATE ${work}/page_assets.cc)
  set_source_files_properties(${work}/page_assets.cc PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
endfunction()
