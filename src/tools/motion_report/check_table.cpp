// SPDX-License-Identifier: BSD-3-Clause
#include "tools/motion_report/check_table.h"

#include "model/message_text.h"

namespace parallel_aspects::tools {
namespace {

void add(std::string& line, const std::string& cell) { line += (line.empty() ? "" : ",") + cell; }

void add(std::string& line, const Eigen::Ref<const Eigen::VectorXd>& values) {
  for (Eigen::Index i = 0; i < values.size(); ++i) add(line, number_text(values[i], 12));
}

std::string header(const Manipulator& manipulator, bool has_distances) {
  std::string line = "time";
  for (const auto& name : coordinate_names(manipulator.task_space())) add(line, std::string(name));
  for (const Leg& leg : manipulator.legs()) add(line, leg.actuated_joint);
  add(line, std::string("parallel_index"));
  for (const Leg& leg : manipulator.legs()) add(line, "serial_index/" + leg.name);
  if (!has_distances) return line + '\n';
  add(line, std::string("measured"));
  for (const char* name : distance_names) add(line, std::string(name));
  return line + '\n';
}

}  // namespace

std::string check_csv(const Manipulator& manipulator, const TrajectoryCheck& check,
                      const std::vector<SampleDistances>& distances) {
  std::string text = header(manipulator, !distances.empty());
  for (std::size_t i = 0; i < check.samples.size(); ++i) {
    const TrajectorySample& sample = check.samples[i];
    std::string line = number_text(sample.time, 12);
    add(line, pose_coordinates(manipulator.task_space(), sample.pose));
    add(line, sample.q);
    add(line, number_text(sample.parallel_index, 12));
    add(line, sample.serial_indices);
    if (!distances.empty()) {
      add(line, std::string(distances[i].measured ? "1" : "0"));
      for (const double lower : distances[i].lower) add(line, number_text(lower, 12));
    }
    text += line + '\n';
  }
  return text;
}

}  // namespace parallel_aspects::tools
