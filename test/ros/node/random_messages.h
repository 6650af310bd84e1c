// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_ROS_RANDOM_MESSAGES_H
#define PARALLEL_ASPECTS_TEST_ROS_RANDOM_MESSAGES_H

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <ros/time.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects::test {

/// Messages of any type, made at random from its definition: empty and enormous lists and texts, numbers that
/// are none, and often enough what makes sense, so that it gets far.
class RandomMessages {
 public:
  /// `words`: texts that mean something, those that belong together first.
  RandomMessages(unsigned seed, std::vector<std::string> words) : random_(seed), words_(std::move(words)) {}

  template <typename Message>
  Message make() {
    read(ros::message_traits::Definition<Message>::value());
    bytes_.clear();
    fill_message("");
    Message message;
    ros::serialization::IStream stream(bytes_.data(), static_cast<std::uint32_t>(bytes_.size()));
    ros::serialization::deserialize(stream, message);
    return message;
  }

  std::size_t pick(std::size_t count) { return random_() % count; }

  std::string text() {
    const std::size_t kind = pick(400);
    if (kind == 0) return std::string(200000, 'x');
    if (kind < 40) return {};
    if (kind < 300) return words_[pick(words_.size())];
    std::string text(pick(20), ' ');
    for (char& letter : text) letter = static_cast<char>(pick(256));
    return text;
  }

  double number() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double odd[] = {0.0,
                              -0.0,
                              1.0,
                              -1.0,
                              infinity,
                              -infinity,
                              1e308,
                              -1e308,
                              5e-324,
                              1e-9,
                              1e6,
                              1e12,
                              std::numeric_limits<double>::quiet_NaN()};
    switch (pick(8)) {
      case 0:
        return odd[pick(std::size(odd))];
      case 1: {
        const std::uint64_t bits = (static_cast<std::uint64_t>(random_()) << 32U) | random_();
        double value = 0.0;
        std::memcpy(&value, &bits, sizeof value);
        return value;
      }
      case 2:
        return static_cast<double>(pick(3)) - 1.0;
      default:
        return std::uniform_real_distribution<double>(-10.0, 10.0)(random_);
    }
  }

 private:
  struct Field {
    std::string type, name;
    bool is_list = false;
    std::size_t fixed_length = 0;  // of a list; 0 for any length
  };

  // "Type name" a line; types that it uses follow after a line of "=", each with a line "MSG: package/Type".
  void read(const std::string& definition) {
    types_.clear();
    std::string type;
    std::istringstream lines(definition);
    for (std::string line; std::getline(lines, line);) {
      line = line.substr(0, line.find('#'));
      if (line.compare(0, 5, "MSG: ") == 0) type = line.substr(5);
      std::istringstream words(line);
      Field field;
      if (line.find('=') != std::string::npos || !(words >> field.type >> field.name)) continue;
      if (field.type == "MSG:") continue;
      if (const auto bracket = field.type.find('['); bracket != std::string::npos) {
        field.is_list = true;
        field.fixed_length = std::strtoul(field.type.c_str() + bracket + 1, nullptr, 10);
        field.type.resize(bracket);
      }
      types_[type].push_back(field);
    }
  }

  void fill_message(const std::string& type) {
    const std::size_t usual = pick(4) == 0 ? 2 : pick(6);  // lists of one message mostly have one length
    const auto found = types_.find(type);
    if (found == types_.end()) return;
    for (const Field& field : std::vector<Field>(found->second)) {
      if (!field.is_list) {
        fill(field.type, 0, false);
        continue;
      }
      const std::size_t length = field.fixed_length > 0 ? field.fixed_length : some_length(usual);
      if (field.fixed_length == 0) put(static_cast<std::uint32_t>(length));
      const bool in_order = pick(2) == 0;
      for (std::size_t i = 0; i < length; ++i) fill(field.type, i, in_order);
    }
  }

  std::size_t some_length(std::size_t usual) {
    if (bytes_.size() > 1000000) return 0;
    const std::size_t kind = pick(300);
    return kind == 0 ? 20000 : kind < 220 ? usual : pick(8);
  }

  template <typename Value>
  void put(Value value) {
    const auto* first = reinterpret_cast<const std::uint8_t*>(&value);
    bytes_.insert(bytes_.end(), first, first + sizeof value);
  }

  void put(const std::string& text) {
    put(static_cast<std::uint32_t>(text.size()));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
  }

  // Small mostly.
  std::uint64_t integer() {
    const std::uint64_t small[] = {0, 1, ~std::uint64_t{0}, 2, 3};
    return pick(8) == 0 ? (static_cast<std::uint64_t>(random_()) << 32U) | random_() : small[pick(5)];
  }

  void fill_time() {
    const ros::Time now = ros::Time::now();
    put(pick(4) == 0 ? static_cast<std::uint32_t>(integer()) : now.sec);
    put(pick(4) == 0 ? static_cast<std::uint32_t>(integer() % 1000000000U) : now.nsec);
  }

  void fill(const std::string& type, std::size_t place, bool in_order) {
    if (type == "string") return put(in_order && place < words_.size() ? words_[place] : text());
    if (type == "float64") return put(number());
    if (type == "float32") return put(static_cast<float>(number()));
    if (type == "bool") return put(static_cast<std::uint8_t>(pick(2)));
    if (type == "int8" || type == "uint8" || type == "byte" || type == "char")
      return put(static_cast<std::uint8_t>(integer()));
    if (type == "int16" || type == "uint16") return put(static_cast<std::uint16_t>(integer()));
    if (type == "int32" || type == "uint32") return put(static_cast<std::uint32_t>(integer()));
    if (type == "int64" || type == "uint64") return put(integer());
    if (type == "time" || type == "duration") return fill_time();
    fill_message(full_name(type));
  }

  // Of a type that is named without its package.
  std::string full_name(const std::string& type) const {
    if (types_.count(type) > 0) return type;
    for (const auto& known : types_) {
      const std::string& name = known.first;
      if (name.size() > type.size() &&
          name.compare(name.size() - type.size() - 1, std::string::npos, "/" + type) == 0)
        return name;
    }
    return type;
  }

  std::mt19937 random_;
  std::vector<std::string> words_;
  std::map<std::string, std::vector<Field>> types_;  // fields of each; "" is the message itself
  std::vector<std::uint8_t> bytes_;
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_ROS_RANDOM_MESSAGES_H
