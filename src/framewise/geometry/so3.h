// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace framewise {

// Rotations and their tangent space, the axis-angle vectors phi (rad).
// Solà, Deray, Atchuthan, A micro Lie theory for state estimation in robotics, 2018.

// [v]x, the matrix with [v]x w = v x w.
Eigen::Matrix3d skew(const Eigen::Vector3d& v);

// Rotation by |phi| about phi (Rodrigues); exact to machine precision down to phi = 0. Eq. (136).
Eigen::Matrix3d so3_exp(const Eigen::Vector3d& phi);

// Axis-angle vector of a rotation, |phi| <= pi; accurate at identity and near pi. Eq. (134).
Eigen::Vector3d so3_log(const Eigen::Matrix3d& R);

// Jr(phi): exp(phi + d) = exp(phi) exp(Jr(phi) d) to first order in d. Eq. (143).
Eigen::Matrix3d so3_right_jacobian(const Eigen::Vector3d& phi);

// Angle of a rotation in [0, pi] (rad), accurate for tiny angles, where acos((trace - 1) / 2) is not.
double rotation_angle(const Eigen::Matrix3d& R);

// Euler angles (x, y, z) of R = Rz(z) Ry(y) Rx(x) (rad): roll, pitch, yaw of a body with z up. y is within
// +-pi/2; at its ends x and z are not unique.
Eigen::Vector3d euler_zyx(const Eigen::Matrix3d& R);

// The smallest rotation that takes direction a to direction b (unit vectors); about some axis across a where
// b is -a.
Eigen::Matrix3d rotation_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

// The rotation nearest to M in the Frobenius norm.
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& M);

}  // namespace framewise
