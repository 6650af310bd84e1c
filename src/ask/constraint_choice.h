// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_CONSTRAINT_CHOICE_H
#define PARALLEL_ASPECTS_ASK_CONSTRAINT_CHOICE_H

#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"

#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects::ask {

/// Which constraints bound the aspects of a robot, and of robots within which tolerance; where nothing is
/// said, those of its description.
struct ConstraintChoice {
  std::string only{}, without{};          ///< kinds by name, separated by commas or blanks
  std::vector<HeldCoordinate> margins{};  ///< by name
  std::vector<double> tolerance{};        ///< a share of the robot's size
};

/// The names that kinds of constraints are given by.
std::string constraint_names();

/// Its fields.
template <class Visit>
void describe(Visit& visit, ConstraintChoice& choice) {
  visit({"constraint", "LIST",
         "Constraints that bound the aspects besides singularities, separated by commas: " +
             constraint_names() + "; by default all that the robot has"},
        choice.only);
  visit({"no_constraint", "LIST", "Constraints to leave out"}, choice.without);
  visit({"margin", "LIST",
         "Least indices, each in place of the one that the robot has, such as \"parallel=0.05 serial=0.1\": "
         "|det A| over the norms of its rows and |B_jj| over its largest, 0 at singularities and 1 at most; "
         "det_a=20000: |det A| itself"},
        choice.margins);
  visit({"tolerance", "SHARE",
         "Prove for every robot whose points and lengths differ from the description by at most this share "
         "of the robot's size, such as 0.001; by default that of the robot's YAML, or 0"},
        choice.tolerance);
}

/// The robot with what is chosen. Where there are problems it is of no meaning.
std::shared_ptr<const Manipulator> constrained(std::shared_ptr<const Manipulator> robot,
                                               const ConstraintChoice& choice, ProblemList& problems);

/// Of a robot with this choice: direct solutions are those of one robot, so that none has a tolerance.
void refuse_tolerance(const ConstraintChoice& choice, const Manipulator& robot, ProblemList& problems);

/// Likewise, and cusps and regions of actuated values are bounded by limits of actuated joints alone.
void refuse_other_bounds(const ConstraintChoice& choice, const Manipulator& robot, ProblemList& problems);

}  // namespace parallel_aspects::ask

#endif  // PARALLEL_ASPECTS_ASK_CONSTRAINT_CHOICE_H
