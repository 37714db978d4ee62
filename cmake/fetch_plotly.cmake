# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
#
# cmake -DNPM= -DWEB= -DWORK= -DOUTPUT= -P: plotly's bundle with scatter3d. Without a network an empty file, and the
# pages do without.
file(COPY ${WEB}/package.json ${WEB}/package-lock.json DESTINATION ${WORK})
execute_process(COMMAND ${NPM} ci --omit=dev --ignore-scripts --no-audit --no-fund --fetch-retries=1
  WORKING_DIRECTORY ${WORK} RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said TIMEOUT 120)
set(bundle ${WORK}/node_modules/plotly.js-gl3d-dist-min/plotly-gl3d.min.js)
if(failed OR NOT EXISTS ${bundle})
  message(WARNING "npm could not fetch plotly: report pages show maps instead of 3D scenes "
                  "(delete ${OUTPUT} to try again)\n${said}")
  file(WRITE ${OUTPUT} "")
else()
  configure_file(${bundle} ${OUTPUT} COPYONLY)
  file(TOUCH ${OUTPUT})
endif()
