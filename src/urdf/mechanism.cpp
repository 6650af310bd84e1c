// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/urdf/mechanism.h"

#include "model/linear_algebra.h"
#include "parallel_aspects/model/problems.h"
#include "urdf/description/text_file.h"
#include "urdf/mechanism_contents.h"
#include "urdf/reading/description_file.h"

#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

// A completion is closed form, so that it either closes to rounding or not at all; rounded descriptions do as
// well as they assembled.
constexpr double completion_tolerance = 1e-9;

// Of singular values and of unit vectors: far above rounding, far below a joint that moves.
constexpr double idle_tolerance = 1e-6;

// Completed values are known no better.
constexpr double limit_tolerance = 1e-9;

}  // namespace

SharedMechanism::SharedMechanism(std::shared_ptr<const Mechanism> mechanism)
    : mechanism_(std::move(mechanism)) {
  if (!mechanism_) throw InvalidDescription({});
}

Mechanism::Mechanism(std::unique_ptr<const Contents> contents)
    : contents_(std::move(contents)), notes_(texts_of(contents_->notes)) {}
Mechanism::~Mechanism() = default;

const std::shared_ptr<const Manipulator>& Mechanism::manipulator() const noexcept {
  return contents_->manipulator;
}
const std::shared_ptr<const Manipulator>& Mechanism::mapped_manipulator() const noexcept {
  return contents_->mapped_manipulator;
}
const std::string& Mechanism::platform_link() const noexcept { return contents_->platform_link; }
const std::string& Mechanism::platform_frame() const noexcept { return contents_->platform_frame; }
const std::vector<std::string>& Mechanism::link_names() const noexcept {
  return contents_->completion.system().tree().links;
}

const std::vector<std::string>& Mechanism::joint_names() const noexcept { return contents_->joint_names; }
const std::vector<JointLimits>& Mechanism::joint_limits() const noexcept { return contents_->joint_limits; }
const std::vector<std::string>& Mechanism::notes() const noexcept { return notes_; }
const std::vector<Note>& Mechanism::notes_in_pieces() const noexcept { return contents_->notes; }
const JointVector& Mechanism::acceleration() const noexcept { return contents_->acceleration; }
int Mechanism::mobility() const noexcept { return contents_->mobility; }
int Mechanism::idle_degrees_of_freedom() const noexcept { return contents_->idle_degrees_of_freedom; }

// Idle motions are the kernel of the closures with the actuated joints locked; of the joints inside the loops
// alone, since there may be thousands outside.
std::vector<PassiveJoint> Mechanism::determined_joints() const {
  const Completion& completion = contents_->completion;
  const ClosureSystem& system = completion.system();
  Eigen::MatrixXd locked =
      system.jacobian(completion.joint_values(completion.reference_pose(), completion.reference_joints()));
  for (const std::size_t actuation : completion.actuated_variables())
    locked.col(static_cast<Eigen::Index>(actuation)).setZero();
  std::vector<std::size_t> inside;
  for (std::size_t k = 0; k < system.in_loop().size(); ++k)
    if (system.in_loop()[k]) inside.push_back(k);
  Eigen::MatrixXd columns(locked.rows(), static_cast<Eigen::Index>(inside.size()));
  for (std::size_t k = 0; k < inside.size(); ++k)
    columns.col(static_cast<Eigen::Index>(k)) = locked.col(static_cast<Eigen::Index>(inside[k]));
  const auto svd = singular_value_decomposition(columns);
  const Eigen::MatrixXd idle = svd.null_space(svd.rank_above(idle_tolerance * svd.values[0]));
  std::vector<PassiveJoint> joints;
  for (std::size_t k = 0; k < inside.size(); ++k)
    if (!(idle.row(static_cast<Eigen::Index>(k)).norm() > idle_tolerance))
      joints.push_back({inside[k], system.tree().joint_of(inside[k]).motion == JointMotion::revolute});
  return joints;
}

AssembledConfiguration Mechanism::assembled() const {
  return {contents_->completion.reference_pose(), contents_->completion.reference_joints()};
}

AssembledConfiguration Mechanism::home() const { return contents_->home.value_or(assembled()); }

std::optional<std::size_t> Mechanism::joint_outside_limits(
    const Eigen::Ref<const Eigen::VectorXd>& positions) const noexcept {
  return contents_->joint_outside_limits(positions);
}

bool Mechanism::complete(const Pose& pose, const JointVector& q,
                         Eigen::Ref<Eigen::VectorXd> positions) const noexcept {
  return contents_->complete(pose, q, positions);
}

std::optional<std::size_t> Mechanism::Contents::joint_outside_limits(
    const Eigen::Ref<const Eigen::VectorXd>& positions) const noexcept {
  const Tree& tree = completion.system().tree();
  for (std::size_t k = 0; k < joint_limits.size() && static_cast<Eigen::Index>(k) < positions.size(); ++k) {
    const double value = positions[static_cast<Eigen::Index>(k)];
    if (std::isfinite(value) && turns_freely(tree.joint_of(k))) continue;
    if (!(value >= joint_limits[k].lower - limit_tolerance &&
          value <= joint_limits[k].upper + limit_tolerance))
      return k;
  }
  return std::nullopt;
}

bool Mechanism::Contents::complete(const Pose& pose, const JointVector& q,
                                   Eigen::Ref<Eigen::VectorXd> positions) const noexcept {
  if (positions.size() != completion.system().tree().variables()) return false;
  if (q.size() != static_cast<Eigen::Index>(manipulator->leg_count())) return false;
  const Eigen::VectorXd values = completion.joint_values(pose, q);
  if (!values.allFinite()) return false;
  if (!(completion.residual(values) < completion_tolerance + accepted_residual)) return false;
  positions = values;
  return true;
}

SharedMechanism load_mechanism_files(const std::string& urdf_file, const std::string& config_file,
                                     const std::string& frame_prefix) {
  Problems problems;
  const std::optional<std::string> urdf = read_description_file(urdf_file, problems);
  const std::optional<std::string> config = read_text_file(config_file, problems);
  if (!problems.empty()) throw InvalidDescription(problems);
  return load_mechanism(*urdf, urdf_file, *config, config_file, frame_prefix);
}

}  // namespace parallel_aspects
