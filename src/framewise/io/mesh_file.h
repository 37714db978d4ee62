// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "framewise/image/mesh.h"

namespace framewise {

enum class UpAxis { kY, kZ };

struct MeshFileOptions {
  double scale = 1;        // metres in a unit of the file (0.001: it is in millimetres)
  UpAxis up = UpAxis::kZ;  // kY: the file's (x, y, z) becomes (x, -z, y)

  // Throws std::invalid_argument naming the option, what was found and what was expected.
  void check() const;
};

// Reads a model by assimp (OBJ, PLY, STL, glTF, Collada, FBX, ...): all its parts as they stand, faces cut
// into triangles, normals made where there are none, diffuse colours and images, emission. Throws InputError
// for a file that is no model, has no face, or names an image that is not there.
Mesh read_mesh(const std::filesystem::path& file, const MeshFileOptions& options = {});

}  // namespace framewise
