// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_COEFFICIENTS_H
#define PARALLEL_ASPECTS_MODEL_COEFFICIENTS_H

#include <Eigen/Core>

#include <type_traits>

namespace parallel_aspects {

/// From `first` to before `last`.
template <class Scalar>
struct CoefficientRange {
  Scalar* first;
  Scalar* last;

  Scalar* begin() const noexcept { return first; }
  Scalar* end() const noexcept { return last; }
};

/// The coefficients of a vector, for range-for and algorithms; valid as long as the vector keeps its size.
/// Eigen 3.3, of Ubuntu 20.04, has no begin() and end() of its own.
template <class Vector>
auto coefficients_of(Vector& vector) noexcept {
  using Plain = std::remove_const_t<Vector>;
  static_assert(Plain::IsVectorAtCompileTime && std::is_base_of_v<Eigen::PlainObjectBase<Plain>, Plain>,
                "only a vector of its own has its coefficients one after the other");
  using Scalar = std::remove_pointer_t<decltype(vector.data())>;
  return CoefficientRange<Scalar>{vector.data(), vector.data() + vector.size()};
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_COEFFICIENTS_H
