// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include "arms/inverse_candidates.h"
#include <array>
#include <cmath>
#include <random>

// Raghavan and Roth, Inverse kinematics of the general 6R manipulator and related linkages, J. Mech. Des.
// 115, 1993: fourteen equations without theta6, bilinear in cosines and sines of theta1 and theta2 on one
// side, of theta4 and theta5, with coefficients that are linear in those of theta3, on the other. Without
// theta1 and theta2 six are left; with tangents of half angles and a multiple of each they are twelve linear
// equations in twelve monomials, whose matrix is quadratic in tan(theta3 / 2). Manocha and Canny solve it as
// an eigenvalue problem.
namespace parallel_aspects {
namespace {

constexpr int attempts = 3;  // each way round, with other offsets of the angles each
constexpr unsigned seed = 1993;
constexpr double almost_real = 0.05;  // Newton's method decides

using Fourteen = Eigen::VectorXd;  // sizes at run time: large fixed ones take the compiler minutes
using Vector = Eigen::Vector3d;

// The point and the direction of the last axis.
struct PointAndAxis {
  Vector point, axis;

  Fourteen equations() const {
    Fourteen values(14);
    const double squared = point.squaredNorm(), along = point.dot(axis);
    values << point, axis, squared, along, point.cross(axis), squared * axis - 2.0 * along * point;
    return values;
  }
};

// Coefficients of 1, cos and sin by values at three angles: column k of the inverse for the k-th of them.
Eigen::Matrix3d from_values() {
  Eigen::Matrix3d matrix;
  for (int k = 0; k < 3; ++k) {
    const double angle = 2.0 * half_turn * k / 3.0;
    matrix.col(k) << 1.0 / 3.0, 2.0 / 3.0 * std::cos(angle), 2.0 / 3.0 * std::sin(angle);
  }
  return matrix;
}

class Elimination {
 public:
  Elimination(const std::vector<LinkNumbers>& links, const Eigen::Isometry3d& goal)
      : links_(links), goal_(goal) {
    scale_ = goal.translation().norm();
    for (const LinkNumbers& link : links) scale_ += std::abs(link.length) + std::abs(link.offset);
    goal_.translation() /= scale_;
    for (LinkNumbers& link : links_) link.length /= scale_, link.offset /= scale_;
  }

  void add_candidates(const std::array<double, 3>& offsets, Candidates& found) {
    offsets_ = offsets;
    if (!eliminate()) return;
    Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(24, 24);
    companion.topRightCorner(12, 12).setIdentity();
    const Eigen::PartialPivLU<Eigen::MatrixXd> leading(matrices_[2]);
    companion.bottomLeftCorner(12, 12) = -leading.solve(matrices_[0]);
    companion.bottomRightCorner(12, 12) = -leading.solve(matrices_[1]);
    if (!companion.allFinite()) return;
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(companion);
    for (int i = 0; i < 24; ++i) {
      const std::complex<double> x = solver.eigenvalues()[i];
      if (std::abs(x.imag()) < almost_real * (1.0 + std::abs(x)))
        add_candidate(x.real(), solver.eigenvectors().col(i).head(12), found);
    }
  }

 private:
  PointAndAxis behind(double third, double fourth, double fifth) const {  // theta3 to theta5
    PointAndAxis at{shift_of(links_[4]), twist_of(links_[4]).col(2)};
    at.point = shift_of(links_[3]) + twist_of(links_[3]) * (about_z(fifth) * at.point);
    at.axis = twist_of(links_[3]) * (about_z(fifth) * at.axis);
    at.point = shift_of(links_[2]) + twist_of(links_[2]) * (about_z(fourth) * at.point);
    at.axis = twist_of(links_[2]) * (about_z(fourth) * at.axis);
    at.point = shift_of(links_[1]) + twist_of(links_[1]) * (about_z(third) * at.point);
    at.axis = twist_of(links_[1]) * (about_z(third) * at.axis);
    return at;
  }
  PointAndAxis before(double first, double second) const {  // theta1 and theta2
    const Eigen::Matrix3d back = about_z(-second) * twist_of(links_[0]).transpose();
    return {back * (about_z(-first) * goal_.translation() - shift_of(links_[0])),
            back * (about_z(-first) * goal_.linear().col(2))};
  }

  // Six equations, with theta1 and theta2 eliminated.
  bool eliminate() {
    const Eigen::Matrix3d weights = from_values();
    Eigen::MatrixXd known = Eigen::MatrixXd::Zero(14, 9);  // by 1, c, s of both
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) {
        const Fourteen values = before(2.0 * half_turn * i / 3.0, 2.0 * half_turn * k / 3.0).equations();
        for (int m = 0; m < 9; ++m) known.col(m) += weights(m / 3, i) * weights(m % 3, k) * values;
      }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(known.rightCols(8), Eigen::ComputeFullU);
    Eigen::Index rank = 0;
    while (rank < 8 && svd.singularValues()[rank] > 1e-10 * svd.singularValues()[0]) ++rank;
    Eigen::MatrixXd null = svd.matrixU().rightCols(14 - rank);
    if (null.cols() > 6) {  // any six combinations
      std::mt19937 random(seed);
      std::normal_distribution<double> normal;
      Eigen::MatrixXd mixed(null.cols(), 6);
      for (Eigen::Index i = 0; i < mixed.size(); ++i) mixed.data()[i] = normal(random);
      null = null * mixed;
    }
    std::array<Eigen::MatrixXd, 3> behind_by;  // by 1, c, s of theta3
    for (auto& each : behind_by) each = Eigen::MatrixXd::Zero(14, 9);
    for (int h = 0; h < 3; ++h)
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
          const Fourteen values =
              behind(2.0 * half_turn * h / 3.0 + offsets_[0], 2.0 * half_turn * i / 3.0 + offsets_[1],
                     2.0 * half_turn * k / 3.0 + offsets_[2])
                  .equations();
          for (int b = 0; b < 3; ++b)
            for (int m = 0; m < 9; ++m)
              behind_by[static_cast<std::size_t>(b)].col(m) +=
                  weights(b, h) * weights(m / 3, i) * weights(m % 3, k) * values;
        }
    behind_by[0].col(0) -= known.col(0);
    set_matrices(null, behind_by);
    return matrices_[2].allFinite();
  }

  // By tangents of half angles: 1, c and s are 1 + x^2, 1 - x^2 and 2 x, over 1 + x^2.
  void set_matrices(const Eigen::MatrixXd& null, const std::array<Eigen::MatrixXd, 3>& behind_by) {
    Eigen::Matrix3d half;  // row: 1, c, s; column: power
    half << 1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 0.0, 2.0, 0.0;
    Eigen::MatrixXd both(9, 9);
    for (int m = 0; m < 9; ++m)
      for (int n = 0; n < 9; ++n) both(m, n) = half(m / 3, n / 3) * half(m % 3, n % 3);
    for (int power = 0; power < 3; ++power) {
      Eigen::MatrixXd six = Eigen::MatrixXd::Zero(6, 9);
      for (int b = 0; b < 3; ++b)
        six += half(b, power) * (null.transpose() * behind_by[static_cast<std::size_t>(b)] * both);
      auto& matrix = matrices_[static_cast<std::size_t>(power)];
      matrix = Eigen::MatrixXd::Zero(12, 12);
      matrix.topLeftCorner(6, 9) = six;
      matrix.bottomRightCorner(6, 9) = six;
    }
  }

  template <class Monomials>
  void add_candidate(double x3, const Monomials& monomials, Candidates& found) const {
    // Entry 3 i + j is x4^i x5^j.
    double fourth_over = 0.0, fifth_over = 0.0, x4 = 0.0, x5 = 0.0;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 3; ++j) {
        const double size = std::abs(monomials[3 * i + j]);
        if (i < 3 && size > fourth_over)
          fourth_over = size, x4 = (monomials[3 * i + 3 + j] / monomials[3 * i + j]).real();
        if (j < 2 && size > fifth_over)
          fifth_over = size, x5 = (monomials[3 * i + j + 1] / monomials[3 * i + j]).real();
      }
    const double third = 2.0 * std::atan(x3) + offsets_[0], fourth = 2.0 * std::atan(x4) + offsets_[1],
                 fifth = 2.0 * std::atan(x5) + offsets_[2];
    const PointAndAxis at = behind(third, fourth, fifth);
    // Heights, p.p and p.l do not depend on theta2, and are linear in cosine and sine of theta1.
    Eigen::MatrixXd by_first(4, 3);
    const auto free_of_second = [](const PointAndAxis& each) {
      return Eigen::Vector4d(each.point.z(), each.axis.z(), each.point.squaredNorm(),
                             each.point.dot(each.axis));
    };
    by_first.setZero();
    const Eigen::Matrix3d weights = from_values();
    for (int i = 0; i < 3; ++i)
      by_first += free_of_second(before(2.0 * half_turn * i / 3.0, 0.0)) * weights.col(i).transpose();
    const Eigen::VectorXd turn = by_first.rightCols(2).colPivHouseholderQr().solve(
        Eigen::VectorXd(free_of_second(at) - by_first.col(0)));
    const double first = std::atan2(turn[1], turn[0]);
    const PointAndAxis seen = before(first, 0.0);
    const bool by_point = seen.point.head<2>().norm() > seen.axis.head<2>().norm();
    const Vector &from = by_point ? at.point : at.axis, &to = by_point ? seen.point : seen.axis;
    const double second = std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x());
    Eigen::Matrix3d all = about_z(first) * twist_of(links_[0]) * about_z(second) * twist_of(links_[1]) *
                          about_z(third) * twist_of(links_[2]) * about_z(fourth) * twist_of(links_[3]) *
                          about_z(fifth) * twist_of(links_[4]);
    const Eigen::Matrix3d rest = all.transpose() * goal_.linear() * twist_of(links_[5]).transpose();
    Eigen::VectorXd q(6);
    q << first, second, third, fourth, fifth, std::atan2(rest(1, 0), rest(0, 0));
    for (std::size_t i = 0; i < 6; ++i) q[static_cast<Eigen::Index>(i)] -= links_[i].turn;
    if (q.allFinite()) found.push_back(q);
  }

  std::vector<LinkNumbers> links_;
  Eigen::Isometry3d goal_;
  double scale_ = 0.0;
  std::array<double, 3> offsets_{};
  std::array<Eigen::MatrixXd, 3> matrices_;  // by powers of tan(theta3 / 2)
};

// The same arm from its last joint to its first: where some axes are parallel one way round is better.
std::vector<LinkNumbers> reversed(const std::vector<LinkNumbers>& links) {
  std::vector<LinkNumbers> result(6);
  for (std::size_t k = 0; k < 5; ++k) {
    const LinkNumbers& before = links[4 - k];
    result[k] = {0.0, -links[5 - k].offset, -before.length, before.cosine, -before.sine};
  }
  return result;
}

}  // namespace

Candidates elimination_candidates(const SerialArm& arm, const Eigen::Isometry3d& goal) {
  const std::vector<LinkNumbers> links = link_numbers(arm);
  Candidates found, backward;
  Elimination elimination(links, goal);
  Elimination reverse(reversed(links), goal.inverse() * Eigen::Translation3d(0.0, 0.0, links[0].offset));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> angle(-half_turn, half_turn);
  for (int k = 0; k < attempts; ++k) {
    elimination.add_candidates({angle(random), angle(random), angle(random)}, found);
    reverse.add_candidates({angle(random), angle(random), angle(random)}, backward);
  }
  for (const Eigen::VectorXd& q : backward) {
    Eigen::VectorXd each(6);
    for (std::size_t i = 0; i < 6; ++i)
      each[static_cast<Eigen::Index>(i)] = -q[static_cast<Eigen::Index>(5 - i)] - links[i].turn;
    found.push_back(each);
  }
  return found;
}

}  // namespace parallel_aspects
