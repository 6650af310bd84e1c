// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_OVERLOADED_H
#define PARALLEL_ASPECTS_MODEL_OVERLOADED_H

namespace parallel_aspects {

/// One function out of several, for `std::visit`: the compiler asks for a case for every alternative.
template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_OVERLOADED_H
