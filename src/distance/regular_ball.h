// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_REGULAR_BALL_H
#define PARALLEL_ASPECTS_DISTANCE_REGULAR_BALL_H

#include "distance/cubic_form.h"

#include <Eigen/Core>

#include <array>

namespace parallel_aspects {

/// Six rows of functions over a ball. Row j is within  gap_j times a number from -1 to 1 times along_j(e)  of
/// rows_j(e).
struct RowsInBall {
  using Row = std::array<CubicForm<6>, 6>;
  std::array<Row, 6> rows, along;
  std::array<double, 6> gaps{};
};

/// Proves a matrix A(e) of such rows regular for all |e| <= s, where s is as large as is found.
///
/// With any L and R, A is regular where  x^T L A R x > 0  for every x != 0. L and R are chosen in floating
/// point such that  L A(0) R  is about I, and such that the linear part  sum e_i S_i  of the symmetric part
/// is small: sum |S_i|^2 is least, over all changes of the basis of x. That is what makes the criterion
/// nearly sharp. Terms up to the second order are a quadratic form in  x (1, e_1, ..., e_6), of which
/// weight (s^2 - |e|^2) |x|^2 is taken off (the S-procedure), and what gaps and errors can take; that the
/// rest is positive definite is proved by a Cholesky factorization with a bound of its rounding. Needs a live
/// `RoundingUpward`.
class RegularBall {
 public:
  explicit RegularBall(const RowsInBall& rows) noexcept;

  /// The largest s up to 1 for which the proof succeeds, or nearly so; 0 for none.
  double proved_share() const noexcept;

  /// A share that is expected to be proved of the ball of that share, as what is left falls with the fourth
  /// power of the ball. May be above 1; proves nothing.
  double expected_share() const noexcept;

 private:
  using Matrix = Eigen::Matrix<double, 6, 6>;
  static constexpr int order = 42;
  using Form = Eigen::Matrix<double, order, order>;
  using Square = Eigen::Matrix<double, order, 1>;  // of a linear function of x (1, e_1, ..., e_6)

  void choose_basis(const RowsInBall& rows) noexcept;
  void transform(const RowsInBall& rows) noexcept;
  void take_off_row(const RowsInBall& rows, std::size_t j) noexcept;
  double take_off_gap(const RowsInBall& rows, std::size_t j) noexcept;
  bool is_proved(double share) const noexcept;
  bool is_proved(double share, double weight) const noexcept;
  void take_off_gaps(double share, Form& form) const noexcept;

  bool usable_ = false;
  Matrix left_, right_;
  std::array<Matrix, CubicForm<6>::Of::count> parts_;  // symmetric, of every monomial
  // What is taken off: by errors, by the half of gaps that is constant, and the squares of the other half.
  Matrix errors_, gaps_;
  std::array<Square, 6> squares_;
  std::size_t square_count_ = 0;
  double cubed_ = 0.0;  // the third order, over the ball
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_REGULAR_BALL_H
