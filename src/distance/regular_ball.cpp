// SPDX-License-Identifier: BSD-3-Clause
#include "distance/regular_ball.h"

#include "distance/cubic_form.h"
#include "interval/interval.h"
#include "model/linear_algebra.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

using Matrix = Eigen::Matrix<double, 6, 6>;
using Vector = Eigen::Matrix<double, 6, 1>;
using Slopes = std::array<Matrix, 6>;
using Of = CubicForm<6>::Of;
constexpr auto& monomials = CubicForm<6>::monomials;

// More than some hundred roundings of one part in 2^52 each.
constexpr double many_roundings = 0x1p-44;

template <class Part>
Matrix matrix_of(const std::array<RowsInBall::Row, 6>& rows, const Part& part) {
  Matrix result;
  for (std::size_t j = 0; j < 6; ++j)
    for (std::size_t i = 0; i < 6; ++i)
      result(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) = part(rows[j][i]);
  return result;
}

Matrix coefficients(const std::array<RowsInBall::Row, 6>& rows, std::size_t of) {
  return matrix_of(rows, [of](const CubicForm<6>& each) { return each.coefficient(of); });
}

std::size_t degree_of(std::size_t monomial) {
  return monomial < Of::first_square ? (monomial > 0 ? 1 : 0) : monomial < Of::first_cube ? 2 : 3;
}

Matrix symmetric_part(const Matrix& a) { return 0.5 * (a + a.transpose()); }

// The largest eigenvalue of a matrix that is positive semidefinite, but for a rounding, or a little more, by
// powers of it.
double symmetric_norm(const Matrix& a) {
  const double trace = a.trace();
  if (!(trace > 0.0)) return trace;
  Matrix power = a / trace;
  for (int i = 0; i < 4; ++i) power = (power * power).eval();
  return trace * std::pow(power.trace(), 1.0 / 16.0);
}

/// A basis in which the symmetric parts of some matrices have the least sum of squares, by descent. Moved by
/// E = 1 - t X, a matrix M becomes E M E^-1; the derivative of half the sum by t is that of <X, gradient>.
class BalancedBasis {
 public:
  explicit BalancedBasis(const Slopes& slopes) : slopes_(slopes) {
    scale();
    size_ = size_of(slopes_);
  }

  void descend(int steps) {
    double length = 0.0;
    for (int i = 0; i < steps; ++i) {
      const Matrix gradient = find_gradient();
      const double norm = gradient.norm();
      if (!(norm > 1e-3 * size_) || !std::isfinite(norm)) return;
      if (i == 0) length = 0.2 / norm;
      length = std::min(length, 0.5 / norm);
      int tries = 0;
      while (!step(gradient, length)) {
        length *= 0.4;
        if (++tries > 5) return;
      }
      length *= 1.6;
    }
  }

  const Matrix& to_basis() const { return to_; }
  const Matrix& from_basis() const { return from_; }

 private:
  static double size_of(const Slopes& slopes) {
    double sum = 0.0;
    for (const Matrix& each : slopes) sum += symmetric_part(each).squaredNorm();
    return sum;
  }

  // Rows and columns of each coordinate come to be of the same size (Osborne 1960).
  void scale() {
    Matrix squares = Matrix::Zero();
    for (const Matrix& each : slopes_) squares += each.cwiseAbs2();
    Vector by = Vector::Ones();
    for (int sweep = 0; sweep < 4; ++sweep)
      for (Eigen::Index k = 0; k < 6; ++k) {
        const double in_row = squares.row(k).sum() - squares(k, k);
        const double in_column = squares.col(k).sum() - squares(k, k);
        if (!(in_row > 0.0 && in_column > 0.0)) continue;
        const double factor = std::sqrt(in_column / in_row);
        squares.row(k) *= factor;
        squares.col(k) /= factor;
        by[k] *= std::sqrt(factor);
      }
    const Vector back = by.cwiseInverse();
    for (Matrix& each : slopes_) each = by.asDiagonal() * each * back.asDiagonal();
    to_ = by.asDiagonal();
    from_ = back.asDiagonal();
  }

  Matrix find_gradient() const {
    Matrix sum = Matrix::Zero();
    for (const Matrix& each : slopes_) {
      const Matrix both = each + each.transpose();
      sum.noalias() += both * each.transpose();
      sum.noalias() -= each.transpose() * both;
    }
    return symmetric_part(sum);
  }

  bool step(const Matrix& gradient, double length) {
    const Matrix forth = Matrix::Identity() - length * gradient, back = inverse(forth);
    Slopes moved;
    for (std::size_t i = 0; i < 6; ++i) moved[i].noalias() = forth * (slopes_[i] * back).eval();
    const double size = size_of(moved);
    if (!(size < size_)) return false;
    slopes_ = moved;
    size_ = size;
    to_ = forth * to_;
    from_ = from_ * back;
    return true;
  }

  Slopes slopes_;
  double size_ = 0.0;
  Matrix to_, from_;
};

}  // namespace

RegularBall::RegularBall(const RowsInBall& rows) noexcept {
  assert_rounding_upward();
  choose_basis(rows);
  if (usable_) transform(rows);
}

void RegularBall::choose_basis(const RowsInBall& rows) noexcept {
  constexpr int steps = 8;
  const Matrix center_inverse = inverse(coefficients(rows.rows, 0));
  Slopes slopes;
  for (std::size_t i = 0; i < 6; ++i) slopes[i] = center_inverse * coefficients(rows.rows, 1 + i);
  BalancedBasis basis(slopes);
  basis.descend(steps);
  left_ = basis.to_basis() * center_inverse;
  right_ = basis.from_basis();
  usable_ = left_.allFinite() && right_.allFinite();
}

void RegularBall::transform(const RowsInBall& rows) noexcept {
  Matrix cubes = Matrix::Zero();
  for (std::size_t i = 0; i < Of::count; ++i) {
    parts_[i] = symmetric_part(left_ * (coefficients(rows.rows, i) * right_).eval());
    // |sum m_i P_i x| <= |x^T sum P_i^2 x / orders_i|^(1/2), where orders times squares of the m_i add up
    // to 1.
    if (i >= Of::first_cube) cubes += (parts_[i] * parts_[i]) / monomials.orders[i];
  }
  cubed_ = std::sqrt(symmetric_norm(cubes)) * (1.0 + many_roundings);
  errors_ = gaps_ = Matrix::Zero();
  for (std::size_t j = 0; j < 6; ++j) take_off_row(rows, j);
  usable_ = errors_.allFinite() && gaps_.allFinite() && std::isfinite(cubed_);
}

// With t the column of L, a row that is off by f adds  (x^T t) (f^T R x), which is at least
// -length (ratio (t^T x)^2 + |x|^2 / ratio) / 2  for every ratio > 0, as |R^T f| <= length.
void RegularBall::take_off_row(const RowsInBall& rows, std::size_t j) noexcept {
  const Vector column = left_.col(static_cast<Eigen::Index>(j));
  Vector errors;
  for (std::size_t i = 0; i < 6; ++i) {
    const CubicForm<6>& entry = rows.rows[j][i];
    errors[static_cast<Eigen::Index>(i)] = entry.error() + many_roundings * entry.size();
  }
  double length = (right_.cwiseAbs().transpose() * errors).norm() * (1.0 + many_roundings);
  if (rows.gaps[j] > 0.0) length += take_off_gap(rows, j);
  const double size = column.norm(), half = 0.5 * length * (1.0 + many_roundings);
  errors_ += (half / size) * (column * column.transpose());
  errors_.diagonal().array() += half * size * (1.0 + many_roundings);
}

// With r = R^T along, the gap adds  g (x^T t) (r^T x)  with |g| <= gap, which is at least
// -gap (ratio (t^T x)^2 + (r^T x)^2 / ratio) / 2  for every ratio > 0. Here r is taken to the first order;
// how long gap times the rest can be is returned.
double RegularBall::take_off_gap(const RowsInBall& rows, std::size_t j) noexcept {
  const Vector column = left_.col(static_cast<Eigen::Index>(j));
  Square& along = squares_[square_count_];
  std::array<double, 4> squares{};
  Vector errors;
  for (std::size_t k = 0; k < Of::count; ++k) {
    Vector part;
    for (std::size_t i = 0; i < 6; ++i) part[static_cast<Eigen::Index>(i)] = rows.along[j][i].coefficient(k);
    const Vector turned = right_.transpose() * part;
    if (k < Of::first_square) along.segment<6>(6 * static_cast<Eigen::Index>(k)) = turned;
    squares[degree_of(k)] += turned.squaredNorm() / monomials.orders[k];
  }
  for (std::size_t i = 0; i < 6; ++i) {
    const CubicForm<6>& entry = rows.along[j][i];
    errors[static_cast<Eigen::Index>(i)] = entry.error() + many_roundings * entry.size();
  }
  const double gap = rows.gaps[j] * (1.0 + many_roundings), ratio = std::sqrt(squares[0]) / column.norm();
  const double rest =
      std::sqrt(squares[2]) + std::sqrt(squares[3]) + (right_.cwiseAbs().transpose() * errors).norm();
  if (!(ratio > 0.0)) return gap * (rest + std::sqrt(squares[1])) * (1.0 + many_roundings);
  along *= std::sqrt(0.5 * gap / ratio) * (1.0 + many_roundings);
  ++square_count_;
  gaps_ += (0.5 * gap * ratio) * (column * column.transpose());
  return gap * rest * (1.0 + many_roundings);
}

double RegularBall::proved_share() const noexcept {
  constexpr int halvings = 5;
  if (!usable_) return 0.0;
  if (is_proved(1.0)) return 1.0;
  double proved = 0.0, failed = 1.0;
  for (int i = 0; i < halvings; ++i) {
    const double share = 0.5 * (proved + failed);
    (is_proved(share) ? proved : failed) = share;
  }
  return proved;
}

double RegularBall::expected_share() const noexcept {
  constexpr int steps = 12;
  if (!usable_) return 0.0;
  Matrix slopes = Matrix::Zero();
  double squares = 0.0;
  for (std::size_t i = 1; i < Of::first_cube; ++i) {
    if (i < Of::first_square)
      slopes += parts_[i] * parts_[i];
    else
      squares += parts_[i].squaredNorm() / monomials.orders[i];
  }
  // About half of the second order is met by the quadratic form.
  Matrix gaps = gaps_;
  for (std::size_t n = 0; n < square_count_; ++n)
    gaps += squares_[n].head<6>() * squares_[n].head<6>().transpose();
  const double slope = std::sqrt(symmetric_norm(slopes)) + symmetric_norm(gaps);
  const double bend = 0.5 * std::sqrt(squares), left = symmetric_norm(errors_);
  double share = 1.0;
  for (int i = 0; i < steps; ++i)
    share /= std::pow(share * (slope + share * (bend + share * (cubed_ + share * left))), 0.6);
  return share;
}

bool RegularBall::is_proved(double share) const noexcept {
  return is_proved(share, 0.5) || is_proved(share, 0.62);
}

bool RegularBall::is_proved(double share, double weight) const noexcept {
  Form form = Form::Zero();
  const double squared = share * share;
  form.topLeftCorner<6, 6>() = parts_[0] - errors_ - gaps_;
  for (Eigen::Index i = 0; i < 6; ++i) {
    form(i, i) -= share * squared * cubed_ + weight;
    form.block<6, 6>(6 + 6 * i, 0) = (0.5 * share) * parts_[1 + static_cast<std::size_t>(i)];
  }
  for (std::size_t at = 0; at < Of::squares; ++at) {
    const auto i = static_cast<Eigen::Index>(monomials.factors[at][0]),
               k = static_cast<Eigen::Index>(monomials.factors[at][1]);
    form.block<6, 6>(6 + 6 * k, 6 + 6 * i) =
        (i == k ? squared : 0.5 * squared) * parts_[Of::first_square + at];
    if (i == k) form.block<6, 6>(6 + 6 * i, 6 + 6 * i).diagonal().array() += weight;
  }
  take_off_gaps(share, form);
  return is_positive_definite(form);
}

void RegularBall::take_off_gaps(double share, Form& form) const noexcept {
  double taken = 0.0;
  for (std::size_t n = 0; n < square_count_; ++n) {
    Square along = squares_[n];
    along.tail<36>() *= share;
    for (Eigen::Index i = 0; i < order; ++i) form.col(i).tail(order - i) -= along[i] * along.tail(order - i);
    taken += along.squaredNorm();
  }
  form.diagonal().array() -= many_roundings * (taken + errors_.norm() + gaps_.norm());
}

}  // namespace parallel_aspects
