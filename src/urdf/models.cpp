// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/urdf/mechanism.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

namespace parallel_aspects::models {
namespace {

struct Texts {
  std::string_view name;
  const char* urdf;
  const char* config;
};

// CMake writes it from the files of the shipped robots.
constexpr Texts all_texts[] = {
#include "parallel_aspects/urdf/model_texts.inc"
};

SharedMechanism shipped(std::string_view name) {
  const Texts& texts = *std::find_if(std::begin(all_texts), std::end(all_texts),
                                     [&](const Texts& each) { return each.name == name; });
  return load_mechanism(texts.urdf, std::string(name) + ".urdf", texts.config, std::string(name) + ".yaml");
}

}  // namespace

SharedMechanism bipod() { return shipped("bipod"); }
SharedMechanism five_bar() { return shipped("five_bar"); }
SharedMechanism three_prr() { return shipped("three_prr"); }
SharedMechanism three_rpr() { return shipped("three_rpr"); }
SharedMechanism three_rrr() { return shipped("three_rrr"); }
SharedMechanism delta() { return shipped("delta"); }
SharedMechanism linear_delta() { return shipped("linear_delta"); }
SharedMechanism agile_eye() { return shipped("agile_eye"); }
SharedMechanism spherical_3rrr() { return shipped("spherical_3rrr"); }
SharedMechanism hexa() { return shipped("hexa"); }
SharedMechanism six_pus() { return shipped("six_pus"); }
SharedMechanism ankle() { return shipped("ankle"); }
SharedMechanism four_bar() { return shipped("four_bar"); }
SharedMechanism tilt_table() { return shipped("tilt_table"); }
SharedMechanism skew_wrist() { return shipped("skew_wrist"); }
SharedMechanism stewart() { return shipped("stewart"); }

}  // namespace parallel_aspects::models
