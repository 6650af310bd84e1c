// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameters/parameter_reader.h"

#include "urdf/description/nearest_name.h"

#include <utility>

namespace parallel_aspects {
namespace {

using XmlRpc::XmlRpcValue;

XmlRpcValue struct_or_nothing(const XmlRpcValue& value) {
  return value.getType() == XmlRpcValue::TypeStruct ? value : XmlRpcValue();
}

std::optional<double> number(const XmlRpcValue& value) {
  if (value.getType() == XmlRpcValue::TypeDouble) return static_cast<const double&>(value);
  if (value.getType() == XmlRpcValue::TypeInt) return static_cast<const int&>(value);
  return std::nullopt;
}

}  // namespace

ParameterReader::ParameterReader(const XmlRpcValue& values, std::string prefix, Problems& problems)
    : values_(struct_or_nothing(values)), prefix_(std::move(prefix)), problems_(problems) {
  if (values.valid() && !values_.valid())
    problems_.push_back("Parameter " + prefix_.substr(0, prefix_.size() - 1) +
                        " must hold parameters of its own, each with its name.");
}

bool ParameterReader::take(const std::string& key, XmlRpcValue& value) {
  known_.insert(key);
  if (!has(key)) return false;
  value = values_[key];
  return true;
}

void ParameterReader::report(const std::string& key, const std::string& expected) {
  problems_.push_back("Parameter " + prefix_ + key + " must be " + expected + ".");
}

void ParameterReader::read(const std::string& key, bool& value) {
  XmlRpcValue raw;
  if (!take(key, raw)) return;
  if (raw.getType() == XmlRpcValue::TypeBoolean)
    value = static_cast<bool&>(raw);
  else
    report(key, "true or false");
}

void ParameterReader::read(const std::string& key, int& value) {
  XmlRpcValue raw;
  if (!take(key, raw)) return;
  if (raw.getType() == XmlRpcValue::TypeInt)
    value = static_cast<int&>(raw);
  else
    report(key, "a whole number");
}

void ParameterReader::read(const std::string& key, double& value) {
  XmlRpcValue raw;
  if (!take(key, raw)) return;
  if (const auto read_value = number(raw))
    value = *read_value;
  else
    report(key,
           raw.getType() == XmlRpcValue::TypeString
               ? "a number, without quotes, and where it has an exponent with a dot and a sign, as 1.0e-3 "
                 "or 1.0e+3 (.inf where it is infinite)"
               : "a number");
}

void ParameterReader::read(const std::string& key, std::string& value) {
  XmlRpcValue raw;
  if (!take(key, raw)) return;
  if (raw.getType() == XmlRpcValue::TypeString)
    value = static_cast<std::string&>(raw);
  else
    report(key, "text");
}

void ParameterReader::read(const std::string& key, std::vector<double>& value) {
  XmlRpcValue raw;
  if (!take(key, raw)) return;
  if (raw.getType() != XmlRpcValue::TypeArray) return report(key, "a list of numbers");
  std::vector<double> numbers;
  for (int i = 0; i < raw.size(); ++i) {
    const auto read_value = number(raw[i]);
    if (!read_value)
      return report(key, "a list of numbers; entry " + std::to_string(i + 1) + " is not a number");
    numbers.push_back(*read_value);
  }
  value = std::move(numbers);
}

ParameterReader ParameterReader::group(const std::string& key) {
  return ParameterReader(raw(key), prefix_ + key + "/", problems_);
}

XmlRpcValue ParameterReader::raw(const std::string& key) {
  XmlRpcValue value;
  take(key, value);
  return value;
}

void ParameterReader::report_unknown_keys() {
  if (!values_.valid()) return;
  const std::vector<std::string> known(known_.begin(), known_.end());
  for (const auto& member : values_) {
    if (known_.count(member.first) != 0) continue;
    const std::string similar = similar_name(member.first, known);
    problems_.push_back(
        "Parameter " + prefix_ + member.first + " is not known; " +
        (similar.empty() ? "correct its name or remove it" : "did you mean '" + similar + "'?") +
        " (config/default.yaml lists every parameter).");
  }
}

}  // namespace parallel_aspects
