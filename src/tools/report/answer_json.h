// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_REPORT_ANSWER_JSON_H
#define PARALLEL_ASPECTS_TOOLS_REPORT_ANSWER_JSON_H

#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/motion/plan_path.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {

/// Writes the fields of an answer as JSON.
class JsonWriter {
 public:
  /// Without a robot: of answers that name no leg and have no pose of a platform.
  JsonWriter() = default;
  explicit JsonWriter(const Manipulator& robot) : robot_(&robot) {}

  template <class Value>
  void operator()(const ask::Field& field, const Value& value) {
    json_[field.name] = json_of(value);
  }

  nlohmann::json take() { return std::move(json_); }

  /// One value.
  template <class Value>
  nlohmann::json json_of(const std::optional<Value>& value) const {
    return value ? json_of(*value) : nlohmann::json();
  }
  template <class Choice, class = std::enable_if_t<std::is_enum_v<Choice>>>
  nlohmann::json json_of(Choice value, int /*tag*/ = 0) const {
    return name(value);
  }
  template <unsigned least, unsigned largest>
  nlohmann::json json_of(ask::Count<least, largest> value) const {
    return value.value;
  }
  template <class Item>
  nlohmann::json json_of(const std::vector<Item>& list) const {
    nlohmann::json array = nlohmann::json::array();
    for (const Item& each : list) array.push_back(json_of(each));
    return array;
  }
  /// An object.
  template <class Value>
  nlohmann::json json_of(const std::vector<std::pair<std::string, Value>>& values) const {
    nlohmann::json object = nlohmann::json::object();
    for (const auto& [name, value] : values) object[name] = json_of(value);
    return object;
  }
  /// Of a struct that has a list of fields of its own.
  template <class Described, class = std::enable_if_t<std::is_class_v<Described>>>
  nlohmann::json json_of(const Described& described) const {
    JsonWriter writer;
    writer.robot_ = robot_;
    describe(writer, described);
    return writer.take();
  }
  nlohmann::json json_of(bool value) const { return value; }
  nlohmann::json json_of(double value) const;
  nlohmann::json json_of(const std::string& value) const { return value; }
  nlohmann::json json_of(int value) const { return value; }
  nlohmann::json json_of(std::size_t value) const { return value; }
  nlohmann::json json_of(unsigned value) const { return value; }
  nlohmann::json json_of(const TaskVector& values) const;
  nlohmann::json json_of(const TaskMatrix& matrix) const;  ///< its rows
  /// Objects by name.
  nlohmann::json json_of(const std::vector<HeldCoordinate>& values) const;
  nlohmann::json json_of(const std::vector<ask::NamedRange>& ranges) const;  ///< "lower" and "upper" of all
  nlohmann::json json_of(ask::LegIndex leg) const { return robot_->leg(leg.index).name; }
  nlohmann::json json_of(const MapSlice& slice) const;
  nlohmann::json json_of(const WorkingMode& mode) const { return mode.signs(); }
  nlohmann::json json_of(const Pose& pose) const;
  nlohmann::json json_of(const TimedPath& timed) const;

 private:
  const Manipulator* robot_ = nullptr;
  nlohmann::json json_ = nlohmann::json::object();
};

/// The fields of an answer.
template <class Answer>
nlohmann::json answer_json(const Manipulator& robot, const Answer& answer) {
  JsonWriter writer(robot);
  describe(writer, answer);
  return writer.take();
}

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_REPORT_ANSWER_JSON_H
