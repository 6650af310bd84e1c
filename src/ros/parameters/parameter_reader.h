// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PARAMETERS_PARAMETER_READER_H
#define PARALLEL_ASPECTS_ROS_PARAMETERS_PARAMETER_READER_H

#include "parallel_aspects/model/problems.h"

#include <XmlRpcValue.h>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// Reads typed values out of one struct of parameters and keeps every problem: wrong types, and keys that
/// were not asked for.
class ParameterReader {
 public:
  /// `values` is a struct, or invalid for one without members. `prefix` is its full name and a slash.
  ParameterReader(const XmlRpc::XmlRpcValue& values, std::string prefix, Problems& problems);

  /// Each leaves `value` as it is where the key is absent, and reports a wrong type.
  void read(const std::string& key, bool& value);
  void read(const std::string& key, int& value);
  void read(const std::string& key, double& value);  ///< takes whole numbers too
  void read(const std::string& key, std::string& value);
  void read(const std::string& key, std::vector<double>& value);

  /// Sets `value` where the key is there and of the right type.
  template <typename T>
  void read(const std::string& key, std::optional<T>& value) {
    if (!has(key)) return;
    T read_value{};
    const std::size_t before = problems_.size();
    read(key, read_value);
    if (problems_.size() == before) value = read_value;
  }

  /// Reads each key into the value that follows it, and reports every key that is none of these.
  template <class T, class... More>
  void read_all(const std::string& key, T& value, More&&... more) {
    read(key, value);
    read_all(std::forward<More>(more)...);
  }
  void read_all() { report_unknown_keys(); }

  /// The reader of a struct inside; empty where it is absent.
  ParameterReader group(const std::string& key);

  /// The raw value, known from now on; invalid where it is absent.
  XmlRpc::XmlRpcValue raw(const std::string& key);

  bool has(const std::string& key) const { return values_.hasMember(key); }

  /// Reports each key that was never asked for.
  void report_unknown_keys();

 private:
  bool take(const std::string& key, XmlRpc::XmlRpcValue& value);
  void report(const std::string& key, const std::string& expected);

  XmlRpc::XmlRpcValue values_;
  std::string prefix_;
  Problems& problems_;
  std::set<std::string> known_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PARAMETERS_PARAMETER_READER_H
