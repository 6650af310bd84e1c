// SPDX-License-Identifier: BSD-3-Clause
#include "tools/arguments.h"
#include "tools/numbers.h"

#include <algorithm>
#include <sstream>

namespace parallel_aspects::tools {
namespace {

std::string example(const std::vector<std::string>& names) {
  std::string text;
  bool has_angle = false;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : " ") + name + "=-1:1";
    has_angle = has_angle || (name != "x" && name != "y" && name != "z");
  }
  return "\"" + text + (has_angle ? "\", in m and rad" : "\", in m");
}

class RegionReader {
 public:
  RegionReader(const std::string& option, const std::vector<std::string>& names, Problems& problems)
      : option_(option), names_(names), problems_(problems), given_(names.size(), false) {}

  Box read(std::string text) {
    Box box{names_.size(), {}, {}};
    std::replace(text.begin(), text.end(), ',', ' ');
    std::istringstream words(text);
    for (std::string word; words >> word;) read_word(word, box);
    for (std::size_t i = 0; i < names_.size(); ++i)
      if (!given_[i])
        problems_.push_back(option_ + " does not say where " + names_[i] + " may be; give " +
                            example(names_) + ".");
    return box;
  }

 private:
  void read_word(const std::string& word, Box& box) {
    const std::size_t equals = word.find('='), colon = word.find(':');
    const auto name = std::find(names_.begin(), names_.end(), word.substr(0, equals));
    if (equals == std::string::npos || colon == std::string::npos || colon < equals || name == names_.end())
      return problems_.push_back(option_ + " has '" + word + "'; give " + example(names_) + ".");
    const auto i = static_cast<std::size_t>(name - names_.begin());
    if (given_[i]) problems_.push_back(option_ + " names " + *name + " twice; give one range.");
    given_[i] = true;
    const std::string ends = word.substr(equals + 1, colon - equals - 1) + " " + word.substr(colon + 1);
    const std::size_t known = problems_.size();
    const std::vector<double> range =
        parse_numbers(option_, ends, {"lower " + *name, "upper " + *name}, problems_);
    if (problems_.size() > known) return;
    if (!(range[0] < range[1]))
      problems_.push_back(option_ + " has '" + word + "', whose lower end is not below the upper; give " +
                          example(names_) + ".");
    box.lower[i] = range[0];
    box.upper[i] = range[1];
  }

  const std::string& option_;
  const std::vector<std::string>& names_;
  Problems& problems_;
  std::vector<bool> given_;
};

}  // namespace

Box parse_region(const std::string& option, const std::vector<std::string>& names, const std::string& text,
                 Problems& problems) {
  return RegionReader(option, names, problems).read(text);
}

}  // namespace parallel_aspects::tools
