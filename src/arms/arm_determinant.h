// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ARMS_ARM_DETERMINANT_H
#define PARALLEL_ASPECTS_ARMS_ARM_DETERMINANT_H

#include "parallel_aspects/arms/serial_arm.h"

#include "arms/trig_polynomial.h"
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Factors of det J that no joint of another group of factors is in: aspects are products over groups.
struct FactorGroup {
  std::vector<std::size_t> joints;  ///< that they depend on
  std::vector<TrigPolynomial> factors;
};

/// det J of an arm, exactly: the product of a constant and of all factors of all groups. J is square, with
/// translations first, as `SerialArm::jacobian`.
struct ArmDeterminant {
  TrigPolynomial whole;
  int sign = 1;                     ///< of the constant
  std::vector<FactorGroup> groups;  ///< none where det J is constant
};

/// Throws `InvalidDescription` where det J vanishes everywhere.
ArmDeterminant arm_determinant(const SerialArm& arm);

/// Vectors of polynomials.
using PolynomialVector = std::array<TrigPolynomial, 3>;
PolynomialVector cross(const PolynomialVector& a, const PolynomialVector& b);
PolynomialVector sum(const PolynomialVector& a, const PolynomialVector& b);
TrigPolynomial dot(const PolynomialVector& a, const PolynomialVector& b);

/// The operational point in the second frame, that behind the first joint, as a polynomial in the joints
/// behind it [m], and what the first link adds: of arms whose task is a position.
PolynomialVector point_behind_first(const SerialArm& arm);

/// "0.4318 sin(elbow) + 0.02 cos(elbow)", with joints by their names.
std::string text_of(const TrigPolynomial& a, const SerialArm& arm);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ARMS_ARM_DETERMINANT_H
