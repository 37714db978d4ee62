// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/mesh_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "framewise/io/input_error.h"

namespace framewise {
namespace {

namespace fs = std::filesystem;

constexpr float kSmoothBelowDeg = 40;  // edges sharper than this stay edges where normals are made

// Of height 0 it is a compressed file of so many bytes.
cv::Mat embedded_image(const aiTexture& texture) {
  if (texture.mHeight == 0) {
    const cv::Mat bytes(1, static_cast<int>(texture.mWidth), CV_8U, texture.pcData);
    return cv::imdecode(bytes, cv::IMREAD_COLOR);
  }
  const cv::Mat bgra(static_cast<int>(texture.mHeight), static_cast<int>(texture.mWidth), CV_8UC4,
                     texture.pcData);
  cv::Mat bgr;
  cv::cvtColor(bgra, bgr, cv::COLOR_BGRA2BGR);
  return bgr;
}

cv::Mat image_of(const fs::path& file, const aiScene& scene, const aiMaterial& material) {
  aiString name;
  if (material.GetTexture(aiTextureType_BASE_COLOR, 0, &name) != aiReturn_SUCCESS &&
      material.GetTexture(aiTextureType_DIFFUSE, 0, &name) != aiReturn_SUCCESS)
    return {};
  cv::Mat image;
  if (const aiTexture* texture = scene.GetEmbeddedTexture(name.C_Str())) {
    image = embedded_image(*texture);
  } else {
    std::string path = name.C_Str();
    std::replace(path.begin(), path.end(), '\\', '/');
    // OpenCV would print that there is no such file.
    if (const fs::path beside = file.parent_path() / path; fs::is_regular_file(beside))
      image = cv::imread(beside.string(), cv::IMREAD_COLOR);
  }
  if (image.empty())
    throw InputError(file, 0, "texture", fmt::format("'{}', which is no image", name.C_Str()),
                     "an image beside the model or in it");
  return image;
}

Eigen::Vector3f color_of(const aiColor3D& color) { return {color.r, color.g, color.b}; }

MeshMaterial material_of(const fs::path& file, const aiScene& scene, const aiMaterial& found) {
  MeshMaterial material;
  aiColor3D color;
  if (found.Get(AI_MATKEY_COLOR_DIFFUSE, color) == aiReturn_SUCCESS) material.color = color_of(color);
  if (found.Get(AI_MATKEY_COLOR_EMISSIVE, color) == aiReturn_SUCCESS) material.emission = color_of(color);
  material.image = image_of(file, scene, found);
  return material;
}

Eigen::Vector3f turned(const aiVector3D& x, UpAxis up) {
  return up == UpAxis::kZ ? Eigen::Vector3f(x.x, x.y, x.z) : Eigen::Vector3f(x.x, -x.z, x.y);
}

void add_part(const aiMesh& part, const MeshFileOptions& options, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    mesh.positions.push_back(static_cast<float>(options.scale) * turned(part.mVertices[i], options.up));
    const Eigen::Vector3f normal =
        part.HasNormals() ? turned(part.mNormals[i], options.up) : Eigen::Vector3f::Zero();
    mesh.normals.push_back(normal.norm() > 0.5f ? Eigen::Vector3f(normal.normalized())
                                                : Eigen::Vector3f::UnitZ());
    const aiVector3D uv = part.HasTextureCoords(0) ? part.mTextureCoords[0][i] : aiVector3D();
    mesh.uv.push_back({uv.x, uv.y});
    const aiColor4D color = part.HasVertexColors(0) ? part.mColors[0][i] : aiColor4D(1, 1, 1, 1);
    mesh.colors.push_back({color.r, color.g, color.b});
  }
  for (unsigned i = 0; i < part.mNumFaces; ++i) {
    const aiFace& face = part.mFaces[i];
    if (face.mNumIndices != 3) continue;  // points and lines
    mesh.triangles.push_back({first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
    mesh.material_of_triangle.push_back(part.mMaterialIndex);
  }
}

void expect_finite(const fs::path& file, const Mesh& mesh) {
  const auto is_far = [](const Eigen::Vector3f& x) { return !(x.cwiseAbs().maxCoeff() < 1e6f); };
  if (const auto found = std::find_if(mesh.positions.begin(), mesh.positions.end(), is_far);
      found != mesh.positions.end())
    throw InputError(file, 0, "vertex", fmt::format("{} {} {}", found->x(), found->y(), found->z()),
                     "coordinates within 1000 km");
}

}  // namespace

void MeshFileOptions::check() const {
  if (!(scale > 0 && std::isfinite(scale)))
    throw std::invalid_argument(fmt::format("mesh scale is {}, expected a positive number", scale));
}

Mesh read_mesh(const fs::path& file, const MeshFileOptions& options) {
  options.check();
  const std::string expected = "a model with faces (OBJ, PLY, STL, glTF, Collada, FBX, ...)";
  if (!fs::is_regular_file(file)) throw InputError(file, 0, "", "no file", expected);
  Assimp::Importer importer;
  importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kSmoothBelowDeg);
  const aiScene* scene =
      importer.ReadFile(file.string(), aiProcess_Triangulate | aiProcess_SortByPType |
                                           aiProcess_GenSmoothNormals | aiProcess_PreTransformVertices);
  if (!scene) {
    std::string reason = importer.GetErrorString();
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    throw InputError(file, 0, "", reason, expected);
  }
  Mesh mesh;
  for (unsigned i = 0; i < scene->mNumMaterials; ++i)
    mesh.materials.push_back(material_of(file, *scene, *scene->mMaterials[i]));
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) add_part(*scene->mMeshes[i], options, mesh);
  if (mesh.triangles.empty()) throw InputError(file, 0, "faces", "none", expected);
  expect_finite(file, mesh);
  return mesh;
}

}  // namespace framewise
