# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(EXPORT FramewiseTargets NAMESPACE Framewise:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Framewise)
configure_package_config_file(cmake/FramewiseConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/FramewiseConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Framewise)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/FramewiseConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/FramewiseConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/FramewiseConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Framewise)
