// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/pose_rows.h"

#include "framewise/io/input_error.h"

namespace framewise {

void expect_rotation(const std::filesystem::path& path, std::size_t line, const Eigen::Matrix3d& R) {
  const Eigen::Matrix3d error = R * R.transpose() - Eigen::Matrix3d::Identity();
  if (error.cwiseAbs().maxCoeff() < 1e-3 && R.determinant() > 0) return;
  throw InputError(path, line, "rotation",
                   "R R' away from the identity by " + shortest_text(error.norm()) + " with determinant " +
                       shortest_text(R.determinant()),
                   "a rotation matrix");
}

Pose pose_of_matrix(const NumberRows& rows, const NumberRow& row, std::size_t first) {
  Eigen::Matrix<double, 3, 4, Eigen::RowMajor> M;
  for (std::size_t i = 0; i < 12; ++i)
    M.data()[i] = rows.number(row, first + i, "column " + std::to_string(first + i + 1));
  const Eigen::Matrix3d R = M.leftCols<3>();
  expect_rotation(rows.path(), row.line, R);
  return {R, M.col(3)};
}

Pose pose_of_quaternion(const NumberRows& rows, const NumberRow& row, const Eigen::Vector3d& t,
                        const Eigen::Quaterniond& q) {
  if (!(q.norm() > 1e-3) || !(q.norm() < 1e3))
    throw InputError(rows.path(), row.line, "quaternion", "length " + shortest_text(q.norm()),
                     "a length near 1");
  return Pose::from_quaternion(q, t);
}

}  // namespace framewise
