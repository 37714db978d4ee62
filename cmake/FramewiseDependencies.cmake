# SPDX-FileCopyrightText: 2026 The Framewise authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What the rooms above the solver library use, all from the distribution's packages.
find_package(OpenCV 4.5 REQUIRED COMPONENTS core imgproc imgcodecs videoio flann features2d video calib3d)
find_package(TBB REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)

# The serial C library, which Debian and Ubuntu call hdf5-serial. CMake's own FindHDF5 wants a C compiler.
find_package(PkgConfig REQUIRED)
pkg_search_module(HDF5 REQUIRED IMPORTED_TARGET GLOBAL hdf5-serial hdf5)

# Its own CMake file wants the programs of another package.
pkg_search_module(LIBZIP REQUIRED IMPORTED_TARGET GLOBAL libzip)

# PNG files of the report's plots.
pkg_check_modules(RSVG REQUIRED IMPORTED_TARGET GLOBAL librsvg-2.0)
# Its CMake files name libraries that some distributions do not ship.
pkg_search_module(ASSIMP REQUIRED IMPORTED_TARGET GLOBAL assimp)

# OpenEXR 3 calls its library OpenEXR, OpenEXR 2 (Ubuntu 22.04) calls it IlmImf.
find_package(OpenEXR REQUIRED)
set(FRAMEWISE_OPENEXR OpenEXR::OpenEXR)
if(NOT TARGET OpenEXR::OpenEXR)
  set(FRAMEWISE_OPENEXR OpenEXR::IlmImf)
endif()

# Debian 12 and Ubuntu 22.04 ship Embree 3, Ubuntu 24.04 ships Embree 4.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 REQUIRED)
endif()
