// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/recognition/passive_chain.h"

#include "urdf/recognition/description_rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr double infinity = std::numeric_limits<double>::infinity();

bool slides(const Pivot& pivot) { return pivot.kind == PivotKind::prismatic; }

std::string quoted(const Pivot& pivot) { return "'" + pivot.name + "'"; }

// Why joints that turn are not such as have one configuration for each orientation; empty where they are.
std::string problem_of(const Chain& rotations) {
  const bool has_ball = std::any_of(rotations.begin(), rotations.end(),
                                    [](const Pivot& pivot) { return pivot.kind == PivotKind::ball; });
  if (has_ball && rotations.size() > 1)
    return "turns about other joints besides the ball joint " + quoted(rotations.back());
  if (rotations.size() > 3) return "has more than three revolute joints";
  for (std::size_t k = 1; k < rotations.size(); ++k) {
    const Pivot &one = rotations[k - 1], &other = rotations[k];
    if (one.axis.cross(other.axis).norm() < direction_tolerance)
      return "turns about the same direction twice, at " + quoted(one) + " and " + quoted(other);
    if (rotations.size() == 3 && std::abs(one.axis.dot(other.axis)) > direction_tolerance)
      return "does not reach every orientation, as the axes of " + quoted(one) + " and " + quoted(other) +
             " are not orthogonal";
  }
  return "";
}

bool passes(const Pivot& rotation, const Vector3d& point, double tolerance) {
  const Vector3d off = point - rotation.point;
  return (rotation.kind == PivotKind::ball ? off.norm() : off.cross(rotation.axis).norm()) < tolerance;
}

// Directions of the task frame along which the slides of a chain are; nothing where they are not, or two are
// along one.
std::optional<std::vector<Eigen::Index>> directions_of(const Chain& slides, const Eigen::Matrix3d& axes) {
  std::vector<Eigen::Index> found;
  for (const Pivot& slide : slides) {
    Eigen::Index along = 0;
    (axes.transpose() * slide.axis).cwiseAbs().maxCoeff(&along);
    const bool is_parallel = axes.col(along).cross(slide.axis).norm() < direction_tolerance;
    if (!is_parallel || std::find(found.begin(), found.end(), along) != found.end()) return std::nullopt;
    found.push_back(along);
  }
  return found;
}

// Finds the box in which the operational point is while all slides are within their limits.
class Bounding {
 public:
  Bounding(const ClosureSystem& system, const Eigen::VectorXd& values, const PlatformMotion& motion)
      : system_(system),
        values_(values),
        motion_(motion),
        count_(static_cast<Eigen::Index>(directions(motion.space))),
        now_(motion.task_frame.inverse() * motion.platform.translation()) {}

  SlideBounds run(const std::vector<PassiveChain>& chains, const std::vector<Leg>& legs) {
    for (const PassiveChain& chain : chains)
      if (moves_point_by_slides_alone(chain)) add(chain);
    if (bounds_.slides.empty()) return {};
    for (const Leg& leg : legs) fill(leg);
    if (!box_.lower.head(count_).allFinite() || !box_.upper.head(count_).allFinite()) return {};
    for (Eigen::Index k = 0; k < 3; ++k)
      if (k >= count_) box_.lower[k] = box_.upper[k] = 0.0;
    bounds_.box = box_;
    return bounds_;
  }

 private:
  bool moves_point_by_slides_alone(const PassiveChain& chain) const {
    const bool turns = has_rotation(motion_.space) || motion_.point_platform;
    return !turns || std::all_of(chain.rotations.begin(), chain.rotations.end(), [&](const Pivot& rotation) {
      return passes(rotation, motion_.platform.translation(), direction_tolerance * system_.size());
    });
  }

  void add(const PassiveChain& chain) {
    const auto along = directions_of(chain.slides, motion_.task_frame.linear());
    for (std::size_t k = 0; along && k < chain.slides.size(); ++k)
      if (chain.slides[k].variable && (*along)[k] < count_) add(chain.slides[k], (*along)[k]);
  }

  void add(const Pivot& slide, Eigen::Index along) {
    const JointLimits& limits = system_.tree().joint_of(*slide.variable).limits;
    if (!limits.limited()) return;
    const double value = values_[static_cast<Eigen::Index>(*slide.variable)];
    const double sense = slide.sense * slide.axis.dot(motion_.task_frame.linear().col(along));
    const auto at = [&](double limit) {
      return without_rounding_noise(now_[along] + std::copysign(1.0, sense) * (limit - value),
                                    system_.size());
    };
    const std::array<double, 2> ends{at(limits.lower), at(limits.upper)};
    box_.lower[along] = std::max(box_.lower[along], std::min(ends[0], ends[1]));
    box_.upper[along] = std::min(box_.upper[along], std::max(ends[0], ends[1]));
    bounds_.slides.push_back(*slide.variable);
  }

  // A box that no pose leaves bounds nothing.
  void fill(const Leg& leg) {
    const double reach = 1.01 * (leg.longest_reach() + leg.anchor.norm());
    for (Eigen::Index k = 0; k < count_; ++k) {
      if (std::isinf(box_.lower[k])) box_.lower[k] = leg.base_point()[k] - reach;
      if (std::isinf(box_.upper[k])) box_.upper[k] = leg.base_point()[k] + reach;
    }
  }

  const ClosureSystem& system_;
  const Eigen::VectorXd& values_;
  const PlatformMotion& motion_;
  Eigen::Index count_;  // of directions in which the platform can move away
  Vector3d now_;        // the operational point, in the task frame [m]
  WorkspaceBox box_{Vector3d::Constant(-infinity), Vector3d::Constant(infinity)};
  SlideBounds bounds_;
};

// Those of the slides that have limits which are not among `bounded`.
std::vector<std::string> unbounded_slides(const std::vector<PassiveChain>& chains,
                                          const std::vector<std::size_t>& bounded, const Tree& tree) {
  std::vector<std::string> names;
  for (const PassiveChain& chain : chains)
    for (const Pivot& slide : chain.follower.empty() ? chain.slides : chain.follower)
      if (slides(slide) && slide.variable && tree.joint_of(*slide.variable).limits.limited() &&
          std::find(bounded.begin(), bounded.end(), *slide.variable) == bounded.end())
        names.push_back(slide.name);
  return names;
}

std::string corner(const Vector3d& point, TaskSpace space) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  for (std::size_t k = 0; k < directions(space); ++k)
    text << (k == 0 ? "[" : ", ") << point[static_cast<Eigen::Index>(k)];
  return text.str() + "]";
}

}  // namespace

std::optional<PassiveChain> recognise_passive_chain(const PassiveChains& found, std::string& reason) {
  PassiveChain result;
  result.restricts = found.restricts;
  if (found.chains.size() != 1) {
    reason = "branches and joins again";
    return std::nullopt;
  }
  const Chain& chain = found.chains.front();
  const auto middle = std::find_if_not(chain.begin(), chain.end(), slides);
  result.slides = {chain.begin(), middle};
  result.rotations = {middle, chain.end()};
  const auto late = std::find_if(middle, chain.end(), slides);
  reason = late != chain.end() ? "has the slide " + quoted(*late) + " after a joint that turns it"
                               : problem_of(result.rotations);
  if (reason.empty()) return result;
  if (!found.is_free) return std::nullopt;
  reason.clear();
  return PassiveChain{{}, {}, chain, false};
}

SlideBounds slide_bounds(const std::vector<PassiveChain>& chains, const ClosureSystem& system,
                         const Eigen::VectorXd& values, const PlatformMotion& motion,
                         const std::vector<Leg>& legs) {
  return Bounding(system, values, motion).run(chains, legs);
}

Notes notes_on(const std::vector<PassiveChain>& chains, const SlideBounds& bounds, const Tree& tree,
               TaskSpace space) {
  Notes notes;
  for (const PassiveChain& chain : chains) {
    const bool is_pose =
        has_hinges(space) && chain.slides.empty() && chain.rotations.size() == degrees_of_freedom(space);
    if (is_pose) continue;
    Chain all = chain.slides;
    for (const Chain& more : {chain.rotations, chain.follower})
      all.insert(all.end(), more.begin(), more.end());
    notes.push_back("No joint is actuated in the chain of " + joint_names_of(all) +
                    " between base and platform; " +
                    (chain.restricts ? "it is part of what holds the platform in " + std::string(name(space))
                                     : "it takes nothing from what the legs leave the platform") +
                    ".");
  }
  std::vector<std::string> limited;
  for (const std::size_t variable : bounds.slides) limited.push_back(tree.joint_of(variable).name);
  if (bounds.box)
    notes.push_back("The limits of " + listed_names(limited) + " keep the operational point between " +
                    corner(bounds.box->lower, space) + " and " + corner(bounds.box->upper, space) +
                    " m of the task frame, as constraints.workspace does.");
  const std::vector<std::string> unbounded = unbounded_slides(chains, bounds.slides, tree);
  if (!unbounded.empty())
    notes.push_back("The limits of " + listed_names(unbounded) +
                    " bound no aspect: for that slides are along the axes of the task frame and, where the "
                    "platform turns, the operational point is on the axes of the joints that turn it.");
  return notes;
}

}  // namespace parallel_aspects
