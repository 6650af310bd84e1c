// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/check.h"
#include "parallel_aspects/ask/choose.h"
#include "parallel_aspects/ask/connect.h"
#include "parallel_aspects/ask/distance.h"
#include "parallel_aspects/ask/inverse_direct.h"
#include "parallel_aspects/ask/jacobian.h"
#include "parallel_aspects/ask/map.h"
#include "parallel_aspects/ask/plan.h"
#include "parallel_aspects/ask/robot_description.h"
#include "parallel_aspects/ask/uniqueness_question.h"
#include "parallel_aspects/ask/workspace.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/urdf/mechanism.h"
#include "tools/report/report.h"
#include "tools/subcommands.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {
namespace {

/// The fields of an answer, or of each entry of a list in it.
struct FieldTable {
  std::string subcommand;
  std::string entries;  ///< of which list; empty for the answer itself
  std::vector<ask::Field> fields{};

  template <class Value>
  void operator()(const ask::Field& field, const Value& /*value*/) {
    fields.push_back({field.name, field.value, ask::with_names(field.help, in_code)});
  }

 private:
  static std::string in_code(const std::string& field) { return "`" + option_name(field) + "`"; }
};

/// Those of one subcommand, or of all.
class FieldTables {
 public:
  explicit FieldTables(std::string only) : only_(std::move(only)) {}

  template <class Answer>
  void add(const std::string& subcommand, const std::string& entries, const Answer& answer) {
    if (names_.empty() || names_.back() != subcommand) names_.push_back(subcommand);
    if (!only_.empty() && only_ != subcommand) return;
    tables_.push_back({subcommand, entries});
    describe(tables_.back(), answer);
  }
  template <class Answer>
  void add(const std::string& subcommand, const std::string& entries) {
    add(subcommand, entries, *std::make_unique<const Answer>());
  }

  const std::vector<FieldTable>& tables() const noexcept { return tables_; }
  const std::vector<std::string>& names() const noexcept { return names_; }

 private:
  std::string only_;
  std::vector<FieldTable> tables_;
  std::vector<std::string> names_;
};

void add_answers_of_maps(FieldTables& all) {
  all.add<ask::MapAnswer>("map", "");
  all.add<ask::MappedAspect>("map", "Each of `aspects`");
  all.add<ask::PairBottleneck>("map", "Each of `bottlenecks`");
  all.add<Basin>("map", "Each of `basins`");
  all.add<ask::SampledAspects>("map", "With six degrees of freedom and without `--slice`");
  all.add("map", "Each of `sides`", ask::SampledSide{WorkingMode(), 1, 1, {1}, {0.0}});
  all.add<ask::LocateAnswer>("locate", "");
  all.add<ask::LocatedConfiguration>("locate", "Each of `configurations`");
  all.add<ask::GraphAnswer>("graph", "");
  all.add<ask::GraphNode>("graph", "Each of `aspects`");
  all.add<Neighbours>("graph", "Each of `gates`");
  all.add<GateCrossing>("graph", "Each of `crossings`");
  all.add<ask::JoinedAspects>("graph", "Each of `sets`");
  all.add<ask::ConnectAnswer>("connect", "");
  all.add<ask::ConnectionInMode>("connect", "Each of `answers`");
}

void add_answers_of_motion(FieldTables& all) {
  all.add<ask::PlanAnswer>("plan", "");
  all.add<ask::CheckAnswer>("check", "");
  all.add<ask::ChooseAnswer>("choose", "");
  all.add<ModeOnPath>("choose", "Each of `modes` of a path");
  all.add<ModeInRegion>("choose", "Each of `modes` of a region");
  all.add<ask::LargestShapeAnswer>("workspace", "");
  all.add<ask::ShapeInAspect>("workspace", "Each of `workspaces`");
}

void add_answers_of_poses(FieldTables& all) {
  all.add("describe", "", ask::RobotDescription{models::five_bar(), {}, 0, {}});
  all.add<ask::DistanceAnswer>("distance", "");
  all.add<ask::DistancesInMode>("distance", "Each of `answers`");
  all.add<ask::DistanceTo>("distance", "Each of `parallel`, `serial` and `actuated_limit`");
  all.add<ask::InverseAnswer>("ik", "");
  all.add<ask::InverseInMode>("ik", "Each of `solutions`");
  all.add<ask::DirectAnswer>("fk", "");
  all.add<ask::DirectSolution>("fk", "Each of `assembly_modes`");
  all.add<ask::JacobianAnswer>("jacobian", "");
  all.add<ask::JacobianAt>("jacobian", "Each of `configurations`");
}

/// Of all poses or of a slice.
void add_answer_of_uniqueness(FieldTables& all) {
  Uniqueness of_five_bar;
  of_five_bar.map = compute_aspect_map(models::five_bar()->manipulator()).map;
  const auto uniqueness = std::make_shared<const Uniqueness>(std::move(of_five_bar));
  const AspectMap& map = *uniqueness->map;
  using ask::Part;
  all.add("uniqueness", "", ask::UniquenessAnswer{TaskSpace::T2, uniqueness});
  all.add("uniqueness", "Each of `components`", Part<Aspect, AspectMap>{&map, &map.aspects().front()});
  all.add<Cusp>("uniqueness", "Each of `cusps`");
  all.add<SolutionNode>("uniqueness", "Each of `nodes`");
  const SolutionRegion region;
  all.add("uniqueness", "Each of `regions`",
          Part<SolutionRegion, SolutionNumbers>{uniqueness.get(), &region});
  const BasicComponent component;
  all.add("uniqueness", "Each of `basic_components`",
          Part<BasicComponent, SolutionNumbers>{uniqueness.get(), &component});
  const BasicRegion basic;
  all.add("uniqueness", "Each of `basic_regions`", Part<BasicRegion, Uniqueness>{uniqueness.get(), &basic});
  const UniquenessDomain domain;
  all.add("uniqueness", "Each of `uniqueness_domains`",
          Part<UniquenessDomain, Uniqueness>{uniqueness.get(), &domain});
}

/// In SO3 with a joint held, over a held joint, and over a roadmap.
void add_other_answers_of_uniqueness(FieldTables& all) {
  all.add<ask::CuspsInSlice>("uniqueness", "With `--slice` in SO3");
  all.add<ask::CuspsOverJoint>("uniqueness", "With `--cusps-over`");
  all.add<CuspCurve>("uniqueness", "Each of `cusp_curves`");
  all.add<CuspEvent>("uniqueness", "Each of `events` and `undecided`");
  all.add<CuspCount>("uniqueness", "Each of `cusp_counts`");
  all.add<ask::SurveyOfRoadmap>("uniqueness", "In SO3 and SE3 without `--slice`");
  all.add<ComponentSurvey>("uniqueness", "Each of its `components`");
  all.add<AssemblyChange>("uniqueness", "`assembly_change`");
  all.add<ProvedSolution>("uniqueness", "`from` and `to`");
}

std::string markdown_of(const FieldTable& table) {
  std::string text = table.entries.empty() ? "## `" + table.subcommand + "`\n\n" : table.entries + ":\n\n";
  text += "| field | meaning |\n|---|---|\n";
  for (const ask::Field& field : table.fields)
    text += "| `" + field.name + "` | " + field.help + (field.value.empty() ? "" : " [" + field.value + "]") +
            " |\n";
  return text;
}

nlohmann::json json_of(const FieldTable& table) {
  nlohmann::json fields = nlohmann::json::array();
  for (const ask::Field& field : table.fields)
    fields.push_back({{"name", field.name}, {"meaning", field.help}, {"unit", field.value}});
  return {{"subcommand", table.subcommand}, {"entries", table.entries}, {"fields", fields}};
}

Report report_fields(const std::string& subcommand) {
  FieldTables all(subcommand);
  add_answers_of_maps(all);
  add_answers_of_motion(all);
  add_answers_of_poses(all);
  add_answer_of_uniqueness(all);
  add_other_answers_of_uniqueness(all);
  if (all.tables().empty())
    throw InvalidDescription(
        {"'" + subcommand + "' has no list of fields; name one of " + joined(all.names(), ", ") + "."});
  Report report{{{"tables", nlohmann::json::array()}}, ""};
  for (const FieldTable& table : all.tables()) {
    report.json["tables"].push_back(json_of(table));
    report.text += (report.text.empty() ? "" : "\n") + markdown_of(table);
  }
  return report;
}

}  // namespace

Subcommand fields_subcommand() {
  const auto name = std::make_shared<std::string>();
  return {"fields",
          "Print the fields of the JSON of a subcommand, or of all, as Markdown",
          {{"SUBCOMMAND", "", "Name of the subcommand; without one, all", name.get()}},
          [name](const Surroundings&) { return report_fields(*name); }};
}

}  // namespace parallel_aspects::tools
