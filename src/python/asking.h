// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_PYTHON_ASKING_H
#define PARALLEL_ASPECTS_PYTHON_ASKING_H

#include "parallel_aspects/ask/check.h"
#include "parallel_aspects/ask/choose.h"
#include "parallel_aspects/ask/plan.h"
#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/ask/session.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/motion/plan_path.h"

#include "python/arrays.h"
#include "python/bindings.h"
#include <optional>
#include <pybind11/pybind11.h>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Questions as keywords, and answers as dictionaries: by their lists of fields alone.
namespace parallel_aspects::python {

/// Reads the fields of a question. Throws `InvalidDescription` where a value is none of its kind.
class KeywordReader {
 public:
  KeywordReader(const Manipulator& robot, const pybind11::dict& keywords)
      : robot_(robot), keywords_(keywords) {}

  template <class Value>
  void operator()(const ask::Field& field, Value& value) {
    known_.push_back(field.name);
    const pybind11::str key(field.name);
    if (!keywords_.contains(key)) return;
    const pybind11::object given = keywords_[key];
    if (!given.is_none()) read(field.name, given, value);
  }

  /// Throws a TypeError for the first keyword that is no field.
  void require_known() const;

 private:
  using Object = pybind11::object;

  template <class Value>
  void read(const std::string& name, const Object& given, std::optional<Value>& value) {
    read(name, given, value.emplace());
  }
  template <unsigned least, unsigned largest>
  void read(const std::string& name, const Object& given, ask::Count<least, largest>& value) {
    value.value = whole_number(name, given, least, largest);
  }
  /// One, or several.
  template <unsigned least, unsigned largest>
  void read(const std::string& name, const Object& given, std::vector<ask::Count<least, largest>>& values) {
    for (const Object& each : listed(given)) read(name, each, values.emplace_back());
  }
  template <class Choice, class = std::enable_if_t<std::is_enum_v<Choice>>>
  void read(const std::string& field, const Object& given, Choice& value) {
    const std::string text = pybind11::str(given);
    std::string names;
    const auto found = ask::choice_named<Choice>(text, names);
    if (!found) throw InvalidDescription({field + " is '" + text + "'; give " + names + "."});
    value = *found;
  }
  void read(const std::string& name, const Object& given, std::string& value);
  void read(const std::string& name, const Object& given, double& value);
  static void read(const std::string& name, const Object& given, bool& value);
  void read(const std::string& name, const Object& given, Pose& value);
  void read(const std::string& name, const Object& given, WorkingMode& value);
  void read(const std::string& name, const Object& given, JointVector& value);
  void read(const std::string& name, const Object& given, MapSlice& value);
  void read(const std::string& name, const Object& given, HeldJoint& value);
  void read(const std::string& name, const Object& given, HeldRange& value);
  void read(const std::string& name, const Object& given, std::vector<double>& values);
  void read(const std::string& name, const Object& given, std::vector<WorkingMode>& values);
  void read(const std::string& name, const Object& given, std::vector<HeldCoordinate>& values);
  void read(const std::string& name, const Object& given, std::vector<ask::NamedRange>& values);
  void read(const std::string& name, const Object& given, std::vector<PoseWaypoint>& waypoints);
  void read(const std::string& name, const Object& given, std::vector<JointWaypoint>& waypoints);
  static std::vector<Object> listed(const Object& given);
  static unsigned whole_number(const std::string& name, const Object& given, unsigned least,
                               unsigned largest);

  const Manipulator& robot_;
  const pybind11::dict& keywords_;
  std::vector<std::string> known_;
};

/// Writes the fields of an answer. The points of a path are arrays of their own, `poses`, `q` and `modes`.
class DictWriter {
 public:
  explicit DictWriter(const Manipulator& robot) : robot_(robot) {}

  template <class Value>
  void operator()(const ask::Field& field, const Value& value) {
    dict_[pybind11::str(field.name)] = object_of_value(value);
  }
  void operator()(const ask::Field& field, const std::vector<PathPoint>& points);

  pybind11::dict take() { return std::move(dict_); }

 private:
  template <class Value>
  pybind11::object object_of_value(const std::optional<Value>& value) const {
    return value ? object_of_value(*value) : pybind11::none();
  }
  template <class Choice, class = std::enable_if_t<std::is_enum_v<Choice>>>
  pybind11::object object_of_value(Choice value, int /*tag*/ = 0) const {
    return pybind11::str(name(value));
  }
  template <unsigned least, unsigned largest>
  pybind11::object object_of_value(ask::Count<least, largest> value) const {
    return pybind11::int_(value.value);
  }
  template <class Item>
  pybind11::object object_of_value(const std::vector<Item>& list) const {
    pybind11::list result;
    for (const Item& each : list) result.append(object_of_value(each));
    return std::move(result);
  }
  /// A dictionary.
  template <class Value>
  pybind11::object object_of_value(const std::vector<std::pair<std::string, Value>>& values) const {
    pybind11::dict result;
    for (const auto& [name, value] : values) result[pybind11::str(name)] = object_of_value(value);
    return std::move(result);
  }
  /// Of a struct that has a list of fields of its own.
  template <class Described, class = std::enable_if_t<std::is_class_v<Described>>>
  pybind11::object object_of_value(const Described& described) const {
    DictWriter writer(robot_);
    describe(writer, described);
    return writer.take();
  }
  pybind11::object object_of_value(bool value) const { return pybind11::bool_(value); }
  pybind11::object object_of_value(double value) const { return pybind11::float_(value); }
  pybind11::object object_of_value(int value) const { return pybind11::int_(value); }
  pybind11::object object_of_value(std::size_t value) const { return pybind11::int_(value); }
  pybind11::object object_of_value(unsigned value) const { return pybind11::int_(value); }
  pybind11::object object_of_value(const std::string& value) const { return pybind11::str(value); }
  pybind11::object object_of_value(const std::vector<int>& values) const;
  pybind11::object object_of_value(const TaskVector& values) const { return array_of(values); }
  pybind11::object object_of_value(const TaskMatrix& matrix) const;
  pybind11::object object_of_value(ask::LegIndex leg) const {
    return pybind11::str(robot_.leg(leg.index).name);
  }
  pybind11::object object_of_value(const std::vector<double>& values) const { return array_of(values); }
  pybind11::object object_of_value(const std::vector<HeldCoordinate>& values) const;
  pybind11::object object_of_value(const std::vector<ask::NamedRange>& ranges) const;
  pybind11::object object_of_value(const WorkingMode& mode) const;
  pybind11::object object_of_value(const Pose& pose) const;
  pybind11::object object_of_value(const std::vector<Pose>& poses) const;
  pybind11::object object_of_value(const MapSlice& slice) const;
  pybind11::object object_of_value(const TimedPath& timed) const;

  const Manipulator& robot_;
  pybind11::dict dict_;
};

/// Lists fields as (name, value, help).
class FieldLister {
 public:
  template <class Value>
  void operator()(const ask::Field& field, const Value& /*value*/) {
    fields_.append(
        pybind11::make_tuple(field.name, field.value, ask::with_names(field.help, ask::plain_name)));
  }
  pybind11::list take() { return std::move(fields_); }

 private:
  pybind11::list fields_;
};

/// The fields of a question or an answer.
template <class Described>
pybind11::list fields_of() {
  FieldLister lister;
  Described described;
  describe(lister, described);
  return lister.take();
}

/// Warns of sentences that do not keep a question from an answer.
void warn_of(const std::vector<std::string>& notes);

/// Adds what a plan remarks to its reason, fields as keywords.
void add_remarks(const ask::PlanAnswer& plan, pybind11::dict& answer);
/// Adds the samples of a check.
void add_remarks(const ask::CheckAnswer& answer, pybind11::dict& result);
template <class Answer>
void add_remarks(const Answer& /*has none*/, pybind11::dict& /*answer*/) {}

/// What the list of fields leaves to each face: waypoints, as their times and what is there.
template <class Question>
void read_waypoints(KeywordReader& /*reader*/, Question& /*has none*/) {}
inline void read_waypoints(KeywordReader& reader, ask::ChooseQuestion& question) {
  reader({"path", "", ""}, question.path);
}
inline void read_waypoints(KeywordReader& reader, ask::CheckQuestion& question) {
  reader({"path", "", ""}, question.path);
  reader({"trajectory", "", ""}, question.trajectory);
  question.keep_samples = true;
}

/// What is asked. Throws `InvalidDescription`, or a TypeError.
template <class Question>
Question read_question(const Manipulator& robot, const pybind11::dict& keywords) {
  Question question;
  KeywordReader reader(robot, keywords);
  describe(reader, question);
  read_waypoints(reader, question);
  reader.require_known();
  return question;
}

/// Asks in a thread of its own. Throws `InvalidDescription`.
template <class Question>
auto answered(SharedSession& shared, const Question& question, const pybind11::object& progress) {
  ask::Session& session = shared.session;
  std::vector<std::string> notes;
  auto outcome = run_long(progress, [&](const MapControl& called) {
    ask::Control control;
    control.cancelled = called.cancelled;
    control.progress = [&called](const char* /*step*/, double share) { called.progress(share); };
    control.note = [&notes](const std::string& sentence) { notes.push_back(sentence); };
    const std::lock_guard<std::mutex> lock(shared.busy);
    return answer(session, question, control);
  });
  warn_of(notes);
  if (!outcome) throw InvalidDescription(texts_of(outcome.problems, ask::plain_name));
  return std::move(outcome.answer);
}

/// The fields of an answer.
template <class Answer>
pybind11::dict dict_of(const Manipulator& robot, const Answer& answer) {
  DictWriter writer(robot);
  describe(writer, answer);
  pybind11::dict result = writer.take();
  add_remarks(answer, result);
  return result;
}

}  // namespace parallel_aspects::python

#endif  // PARALLEL_ASPECTS_PYTHON_ASKING_H
