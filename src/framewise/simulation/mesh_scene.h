// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/image/mesh.h"
#include "framewise/simulation/path.h"
#include "framewise/simulation/scene.h"

namespace framewise {

// A user's own model, in light from all around that is brighter from above. Materials with an image show it;
// those that shine show their plain colour; others have squares within squares about their colour, so that
// there is something to see at every distance. Throws std::invalid_argument for a mesh without a face.
Scene mesh_scene(const Mesh& mesh, const SceneOptions& options);

// The box about all its faces.
Eigen::AlignedBox3d bounds_of(const Mesh& mesh);

// Named paths go round the model from outside, about as far away as it fills the picture.
PathSpace mesh_space(const Mesh& mesh);

}  // namespace framewise
