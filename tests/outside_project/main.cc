#include <framewise/robust/registration.h>

int main() {
  const std::vector<Eigen::Vector3d> X1 = {{0, 0, 1}, {1, 0, 2}, {0, 1, 3}, {1, 1, 2}, {0.5, 0.2, 1}};
  std::vector<Eigen::Vector3d> X2;
  for (const auto& X : X1) X2.push_back(X + Eigen::Vector3d(0.1, 0, 0));
  const auto estimate = framewise::estimate_registration(X1, X2, {});
  return estimate && (estimate->cam2_from_cam1.t - Eigen::Vector3d(0.1, 0, 0)).norm() < 1e-9 ? 0 : 1;
}
