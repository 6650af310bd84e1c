// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/closing/chain.h"

#include <algorithm>
#include <set>

namespace parallel_aspects {
namespace {

// Each is assembled and recognised, which takes tenths of a second for a hexapod.
constexpr std::size_t max_choices = 24;

using Choice = std::vector<std::size_t>;

auto at(std::size_t depth) {
  return [depth](const LegJoint& joint) { return joint.depth == depth; };
}

class Chooser {
 public:
  Chooser(std::vector<std::vector<LegJoint>> legs, const Choice& described) : described_(described) {
    for (std::vector<LegJoint>& leg : legs) {
      leg.erase(std::remove_if(leg.begin(), leg.end(),
                               [&](const LegJoint& joint) { return !is_described(joint.variable); }),
                leg.end());
      if (!leg.empty()) legs_.push_back(std::move(leg));
    }
  }

  // At one distance from the base in all legs, or in all but one.
  std::vector<Choice> alike() {
    std::set<std::size_t> depths;
    for (const auto& leg : legs_)
      for (const LegJoint& joint : leg) depths.insert(joint.depth);
    for (const std::size_t depth : depths) {
      Choice choice;
      for (const auto& leg : legs_)
        if (std::count_if(leg.begin(), leg.end(), at(depth)) == 1)
          choice.push_back(std::find_if(leg.begin(), leg.end(), at(depth))->variable);
      add(choice);
      for (std::size_t without = 0; without < choice.size(); ++without) {
        Choice fewer = choice;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(without));
        add(fewer);
      }
    }
    return std::move(choices_);
  }

 private:
  bool is_described(std::size_t variable) const {
    return std::find(described_.begin(), described_.end(), variable) != described_.end();
  }

  // In the order of the description, once.
  void add(Choice choice) {
    const auto place = [this](std::size_t variable) {
      return std::find(described_.begin(), described_.end(), variable);
    };
    std::sort(choice.begin(), choice.end(),
              [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
    if (is_actuation_count(choice.size()) && choices_.size() < max_choices && tried_.insert(choice).second)
      choices_.push_back(choice);
  }

  const Choice& described_;
  std::vector<std::vector<LegJoint>> legs_;
  std::vector<Choice> choices_;
  std::set<Choice> tried_;
};

}  // namespace

bool is_actuation_count(std::size_t count) noexcept { return (count >= 1 && count <= 3) || count == 6; }

std::vector<Choice> actuation_choices(const ClosureSystem& system, const ActuatedJoints& described,
                                      const SourceNames& files) {
  return Chooser(joints_by_leg(system, described, files), described.variables).alike();
}

}  // namespace parallel_aspects
