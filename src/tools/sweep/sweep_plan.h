// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_SWEEP_SWEEP_PLAN_H
#define PARALLEL_ASPECTS_TOOLS_SWEEP_SWEEP_PLAN_H

#include "parallel_aspects/aspects/design.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/problems.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// A parameter that is varied, from its lower to its upper value.
struct VariedParameter {
  std::string name;
  double lower = 0.0, upper = 0.0;  ///< [m]
  std::size_t count = 1;            ///< of values, both ends among them; of a grid
};

/// How values are chosen.
enum class SweepSample {
  grid,  ///< every combination, the last parameter first
  sobol  ///< the sequence of Sobol, which fills the ranges evenly however many designs there are
};

/// All designs of a sweep, and what is asked of each. Every row follows from this and its number alone.
struct SweepPlan {
  std::shared_ptr<const Manipulator> robot;
  std::vector<VariedParameter> varied;
  SweepSample sample = SweepSample::grid;
  std::size_t count = 0;  ///< of designs
  bool keep_ties = true;
  DesignQuestion question;
};

/// The parameters that `text` varies, such as "crank_1=0.2:0.4:21 rod=1". Of `SweepSample::sobol` a range has
/// no number of values. Messages name `option`.
std::vector<VariedParameter> parse_varied(const std::string& option, const std::string& text,
                                          SweepSample sample, Problems& problems);

/// How many designs a grid has; 0 where that is more than `most_designs`.
std::size_t grid_size(const std::vector<VariedParameter>& varied);
inline constexpr unsigned most_designs = 100'000'000;

/// The values of a design, by its number from 0.
DesignValues values_of(const SweepPlan& plan, std::size_t design);

/// "design", the parameters, "status" and the figures, with commas between.
std::string column_line(const SweepPlan& plan);

/// What the row of a design begins with: its number, from 1, and its values.
std::string row_start(const SweepPlan& plan, std::size_t design);

/// Its row, without a line end; empty when cancelled.
std::string row_of(const SweepPlan& plan, std::size_t design, const MapControl& control);

/// A checksum of all that the rows follow from, and of the revision of the proofs.
std::uint32_t fingerprint(const SweepPlan& plan);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_SWEEP_SWEEP_PLAN_H
