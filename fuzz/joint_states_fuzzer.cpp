// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"
#include "ros/joint_states/joint_sample.h"
#include "ros/joint_states/publisher_watch.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <fuzzer/FuzzedDataProvider.h>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

// joint_states as they may come become joint values, all of them numbers, or a message.
namespace {

using parallel_aspects::JointSample;
using parallel_aspects::JointSampleReader;
using parallel_aspects::Mechanism;
using parallel_aspects::SampleStatus;

std::string text_of(const std::string& file) {
  std::ifstream stream(std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/" + file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::shared_ptr<const Mechanism> five_bar() {
  return parallel_aspects::load_mechanism(text_of("urdf/five_bar.urdf"), "five_bar.urdf",
                                          text_of("config/robots/five_bar.yaml"), "five_bar.yaml");
}

// Any bits, among them those of numbers that are none.
double number_from(FuzzedDataProvider& bytes) {
  const auto bits = bytes.ConsumeIntegral<std::uint64_t>();
  double value = 0.0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

std::vector<double> numbers_from(FuzzedDataProvider& bytes, std::size_t count) {
  std::vector<double> numbers(count);
  for (double& number : numbers) number = number_from(bytes);
  return numbers;
}

// Mostly joints that there are, and lists that are mostly of one length.
sensor_msgs::JointState message_from(FuzzedDataProvider& bytes, const std::vector<std::string>& joints) {
  sensor_msgs::JointState message;
  message.header.seq = bytes.ConsumeIntegral<std::uint32_t>();
  message.header.frame_id = bytes.ConsumeRandomLengthString(4);
  const auto size = bytes.ConsumeIntegralInRange<std::size_t>(0, joints.size() + 2);
  const auto odd = bytes.ConsumeIntegralInRange<std::size_t>(0, 15);
  for (std::size_t i = 0; i < size; ++i) {
    const auto which = bytes.ConsumeIntegralInRange<std::size_t>(0, joints.size());
    message.name.push_back(which < joints.size() ? joints[which] : bytes.ConsumeRandomLengthString(40));
  }
  message.position = numbers_from(bytes, size + (odd == 1 ? 1 : 0));
  message.velocity = numbers_from(bytes, odd == 2 ? size : odd == 3 ? size + 1 : 0);
  message.effort = numbers_from(bytes, odd == 4 ? size : odd == 5 ? size + 1 : 0);
  return message;
}

void require(bool condition) {
  if (!condition) std::abort();
}

void check(const Mechanism& mechanism, const JointSample& sample) {
  if (sample.status != SampleStatus::usable) return require(!sample.message.empty());
  require(static_cast<std::size_t>(sample.q.size()) == mechanism.manipulator()->leg_count());
  for (const double value : parallel_aspects::coefficients_of(sample.q)) require(std::isfinite(value));
  require(static_cast<std::size_t>(sample.readings.size()) == mechanism.joint_names().size());
  for (const double value : parallel_aspects::coefficients_of(sample.readings)) require(!std::isinf(value));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto mechanism = five_bar();
  static const JointSampleReader reader(mechanism);
  static parallel_aspects::PublisherWatch publishers(ros::Duration(0.5));
  FuzzedDataProvider bytes(data, size);
  const sensor_msgs::JointState message = message_from(bytes, mechanism->joint_names());
  const JointSample sample = reader.read(message);
  check(*mechanism, sample);
  const std::string& publisher = message.header.frame_id;
  publishers.count(publisher, message.header.seq);
  std::string other;
  publishers.claim(publisher, sample.named_joints, ros::Time(1000.0), other);
  require(other.empty() || other != publisher);
  return 0;
}
