// SPDX-License-Identifier: BSD-3-Clause
// The tables of docs/reference/command.md are the lists of fields.
#include "parallel_aspects/ask/check.h"
#include "parallel_aspects/ask/choose.h"
#include "parallel_aspects/ask/connect.h"
#include "parallel_aspects/ask/distance.h"
#include "parallel_aspects/ask/inverse_direct.h"
#include "parallel_aspects/ask/jacobian.h"
#include "parallel_aspects/ask/map.h"
#include "parallel_aspects/ask/plan.h"
#include "parallel_aspects/ask/robot_description.h"
#include "parallel_aspects/ask/workspace.h"
#include "tools/report/report.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <string>

namespace parallel_aspects::tools {
namespace {

/// A row for each field.
class TableOfFields {
 public:
  template <class Value>
  void operator()(const ask::Field& field, const Value& /*value*/) {
    const std::string unit = field.value.empty() ? "" : " [" + field.value + "]";
    rows_ += "| `" + field.name + "` | " + ask::with_names(field.help, in_code) + unit + " |\n";
  }
  const std::string& rows() const noexcept { return rows_; }

 private:
  static std::string in_code(const std::string& field) { return "`" + option_name(field) + "`"; }

  std::string rows_ = "| field | meaning |\n|---|---|\n";
};

std::string text_of_docs(const std::string& file) {
  std::ifstream stream(std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/docs/" + file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

template <class Answer>
void expect_documented(const Answer& answer) {
  TableOfFields table;
  describe(table, answer);
  EXPECT_NE(text_of_docs("reference/command.md").find(table.rows()), std::string::npos)
      << "docs/reference/command.md has not this table:\n"
      << table.rows();
}

template <class Answer>
void expect_documented() {
  expect_documented(*std::make_unique<const Answer>());
}

TEST(DocumentedFields, AreThoseOfTheAnswers) {
  expect_documented(ask::RobotDescription{models::five_bar(), {}, 0, {}});
  expect_documented<ask::PlanAnswer>();
  expect_documented<ask::MapAnswer>();
  expect_documented<ask::MappedAspect>();
  expect_documented<ask::PairBottleneck>();
  expect_documented<ask::SampledAspects>();
  expect_documented(ask::SampledSide{WorkingMode(), 1, 1, {1}, {0.0}});
  expect_documented<Basin>();
  expect_documented<ask::GraphAnswer>();
  expect_documented<ask::GraphNode>();
  expect_documented<Neighbours>();
  expect_documented<GateCrossing>();
  expect_documented<ask::JoinedAspects>();
  expect_documented<ask::LocateAnswer>();
  expect_documented<ask::LocatedConfiguration>();
  expect_documented<ask::ConnectAnswer>();
  expect_documented<ask::ConnectionInMode>();
  expect_documented<ask::CheckAnswer>();
  expect_documented<ask::ChooseAnswer>();
  expect_documented<ModeOnPath>();
  expect_documented<ModeInRegion>();
  expect_documented<ask::DistanceAnswer>();
  expect_documented<ask::DistancesInMode>();
  expect_documented<ask::DistanceTo>();
  expect_documented<ask::InverseAnswer>();
  expect_documented<ask::InverseInMode>();
  expect_documented<ask::DirectAnswer>();
  expect_documented<ask::DirectSolution>();
  expect_documented<ask::JacobianAnswer>();
  expect_documented<ask::JacobianAt>();
  expect_documented<ask::LargestShapeAnswer>();
  expect_documented<ask::ShapeInAspect>();
}

}  // namespace
}  // namespace parallel_aspects::tools
