// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/load_mechanism.h"

#include "model/message_text.h"
#include "urdf/closing/chain.h"
#include "urdf/closing/ends_of_loops.h"
#include "urdf/closing/freedom.h"
#include "urdf/closing/planar_layers.h"
#include "urdf/closing/resolved_config.h"
#include "urdf/config/map_and_motion_config.h"
#include "urdf/config/mechanism_config.h"
#include "urdf/corrections/edits.h"
#include "urdf/description/yaml_values.h"
#include "urdf/diagnosis/closure_gaps.h"
#include "urdf/diagnosis/diagnosis.h"
#include "urdf/mechanism_contents.h"
#include "urdf/mechanism_recognition.h"
#include "urdf/reading/tree_reader.h"
#include "urdf/stated_constraints.h"

#include <tinyxml2.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr std::size_t max_closures = 36;  // six for each leg of a hexapod

void check_closures(const std::vector<Closure>& closures, const SourceNames& files) {
  if (closures.size() > max_closures)
    throw InvalidDescription({files.config + " and " + files.urdf + " describe " +
                              std::to_string(closures.size()) + " closures, and at most " +
                              std::to_string(max_closures) +
                              " are treated; a robot needs one for each loop."});
}

// Which joints are in the loops does not depend on the types.
ClosureSystem loops_of(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved) {
  return {tree, resolved.base, with_type(resolved.closures, ClosureType::point)};
}

// Of those that are in no loop.
std::optional<Note> joints_left_out(const ClosureSystem& loops, const SourceNames& files) {
  std::vector<std::string> names;
  for (std::size_t joint = 0; joint < loops.in_loop().size(); ++joint)
    if (!loops.in_loop()[joint]) names.push_back(loops.tree().joint_of(joint).name);
  if (names.empty()) return std::nullopt;
  return files.urdf + " has joints that no closure puts in a loop, which are no part of the robot here: " +
         listed_names(names) + ".";
}

[[noreturn]] void refuse(const Diagnosis& diagnosis) {
  if (diagnosis.kind != Diagnosis::Kind::guess) throw ExplainedDescription(diagnosis.problems);
  throw InvalidDescription(diagnosis.problems);
}

// What shows before anything is assembled. Of the joints that a URDF calls actuated, those outside of the
// loops may be of something else, as a gripper.
void check_ends(const std::shared_ptr<const Tree>& tree, const ResolvedConfig& resolved,
                const SourceNames& files, const LoadSearch& search, const Attempt& attempt) {
  ActuatedJoints listed = resolved.actuated_joints;
  if (!resolved.actuation_origin.empty()) listed.variables.clear();
  Problems problems;
  const ClosureSystem loops = loops_of(tree, resolved);
  const WrongEnds wrong =
      check_joints_in_loops(loops, files, problems) ? find_wrong_ends(loops, listed, files) : WrongEnds{};
  if (problems.empty() && wrong.found.empty()) return;
  const auto joints = std::count(loops.in_loop().begin(), loops.in_loop().end(), true);
  if (search.looks_for_remedies && !resolved.closures.empty() && joints <= max_joints_in_loops) {
    if (const auto diagnosis = diagnosis_of_ends(tree, resolved, wrong, files, attempt)) refuse(*diagnosis);
  }
  throw InvalidDescription(problems.empty() ? wrong.problems() : problems);
}

// Any loop that closes has a platform on one hinge (R1), as the gripper of an arm: that alone is no evidence.
bool may_be_guessed(const Mechanism::Contents& contents) {
  return contents.manipulator->task_space() != TaskSpace::R1;
}

// Throws where there is none.
std::unique_ptr<Mechanism::Contents> recognise(const std::shared_ptr<const Tree>& tree,
                                               const MechanismConfig& config, const ResolvedConfig& resolved,
                                               const SourceNames& files, const LoadSearch& search) {
  const RecogniseIn recognise_in = [&](const std::shared_ptr<const Tree>& in, const ResolvedConfig& open,
                                       Problems& problems) {
    const Recognise each = [&](const ResolvedConfig& chosen, Problems& found) {
      return recognise_mechanism(in, config, chosen, files, search, found);
    };
    return recognise_open(in, open, each, files, problems);
  };
  const Attempt attempt = [&](const auto& changed_tree, const ResolvedConfig& changed) {
    Problems ignored;
    ResolvedConfig placed = changed;
    place_at_zero(*changed_tree, placed.closures);
    const auto contents = recognise_in(changed_tree, placed, ignored);
    if (!contents || !may_be_guessed(*contents)) return std::optional<std::string>();
    return std::optional<std::string>(name(contents->manipulator->task_space()));
  };
  check_ends(tree, resolved, files, search, attempt);
  const auto meant = drawn_open(*tree, resolved, files);
  Problems problems, of_written;
  for (const bool ends_meet : {true, false}) {
    if (ends_meet && !meant) continue;
    auto contents =
        recognise_in(tree, ends_meet ? *meant : resolved, meant && !ends_meet ? of_written : problems);
    if (!contents) continue;
    if (search.is_guess && !may_be_guessed(*contents))
      throw InvalidDescription(
          {files.urdf + " is a linkage of one degree of freedom, as a four-bar; write a YAML that states "
                        "which of its links is the platform."});
    if (search.looks_for_remedies) {
      const std::size_t before = contents->notes.size();
      const Subject subject(tree, resolved, files);
      if (const auto wrong = length_of_another_link(subject, attempt))
        throw ExplainedDescription({wrong->text()});
      note_ends({subject, ends_meet, recognise_in, attempt}, *contents);
      for (Note& note : notes_of_working(subject, unit_edits(subject, subject.loops, true), "if so", attempt))
        contents->notes.push_back(std::move(note));
      if (contents->notes.size() == before)  // a frame that is turned turns an axis, too
        for (Note& note : other_axes_notes(subject, attempt)) contents->notes.push_back(std::move(note));
    }
    return contents;
  }
  if (!search.looks_for_remedies) throw InvalidDescription(problems);
  if (const auto diagnosis = diagnosis_of(tree, resolved, files, attempt)) refuse(*diagnosis);
  if (!meant && !are_all_welds(resolved.closures) && with_ends_together(*tree, resolved))
    problems = {
        file_of_closures(resolved, files) + " has ends of closures apart while all joints are zero, " +
        end_gaps_text(*tree, resolved) +
        ", and they are held so; correct the origins of the joints in their loops, if they are to meet" +
        starts_of_links_text(*tree, resolved) + "."};
  throw InvalidDescription(problems);
}

// Where there are more actuated joints than a robot has: those that move nothing of the platform, as of a
// fourth axis through a telescopic shaft. Their chain follows the platform as a passive one.
std::optional<Note> leave_out_idle_joints(const std::shared_ptr<const Tree>& tree, const SourceNames& files,
                                          ResolvedConfig& resolved) {
  std::vector<std::size_t>& joints = resolved.actuated_joints.variables;
  if (is_actuation_count(joints.size()) || resolved.closures.empty()) return std::nullopt;
  const std::size_t platform = resolved.actuated_joints.platform_link;
  std::vector<Closure> closures = resolved.closures;
  for (Closure& closure : closures)  // as they hold most
    if (closure.type == ClosureType::automatic)
      closure.type = closure.weld == Weld::none ? ClosureType::point : ClosureType::fixed;
  const ClosureSystem system(tree, resolved.base, std::move(closures));
  const auto assembly = assemble(system, joints, platform).assembly;
  if (!assembly) return std::nullopt;
  std::vector<std::size_t> others = joints;
  std::vector<std::string> names;
  for (const std::size_t idle : idle_joints(system, *assembly, platform, joints)) {
    others.erase(std::find(others.begin(), others.end(), idle));
    names.push_back(tree->joint_of(idle).name);
  }
  if (!is_actuation_count(others.size())) return std::nullopt;
  joints = std::move(others);
  return files.urdf +
         " has joints that move nothing of the platform, so that they are not taken as actuated: " +
         listed_names(names) + ".";
}

// Both texts have been read once, so that they are known to parse, or the problem is known.
ResolvedConfig resolved_names(const Tree& tree, const MechanismConfig& config, const std::string& urdf_text,
                              const std::string& config_text, const SourceNames& files, Problems& problems,
                              Notes& notes) {
  tinyxml2::XMLDocument document;
  document.Parse(urdf_text.data(), urdf_text.size());
  YAML::Node yaml;
  try {
    yaml = yaml_document(config_text);
  } catch (const YAML::Exception&) {
    return {};
  }
  return resolve_config(config, {*document.FirstChildElement("robot"), yaml, tree, files}, problems, notes);
}

// For maps alone: a robot that runs is followed by the numbers of its description.
void take_tolerance(double share, const SourceNames& files, Mechanism::Contents& contents) {
  if (share == 0.0) return;
  contents.mapped_manipulator = contents.mapped_manipulator->with_tolerance(share);
  contents.notes.push_back("By mechanism.tolerance: " + number_text(share, 3) + " of " + files.config +
                           " maps hold for every robot whose points and lengths are within " +
                           number_text(contents.mapped_manipulator->tolerance(), 3) + " m of those of " +
                           files.urdf + ".");
}

}  // namespace

std::unique_ptr<Mechanism::Contents> recognise_named(NamedDescription description, const SourceNames& files,
                                                     const LoadSearch& search) {
  const std::shared_ptr<const Tree>& tree = description.tree;
  ResolvedConfig& resolved = description.resolved;
  check_closures(resolved.closures, files);
  Notes notes;
  if (const auto note = leave_out_repeated(resolved, files)) notes.push_back(*note);
  for (const std::string& note :
       join_layers(*tree, resolved.actuated_joints.platform_link, files, resolved.closures))
    notes.push_back(note);
  if (auto note = leave_out_idle_joints(tree, files, resolved)) notes.push_back(std::move(*note));
  auto contents = recognise(tree, description.config, resolved, files, search);
  const ClosureSystem loops = loops_of(tree, resolved);
  for (const std::string& note : shared_frame_notes(*tree, resolved, loops.size())) notes.push_back(note);
  for (const std::string& note : reversed_axes_notes(*tree, resolved, files)) notes.push_back(note);
  if (const auto note = joints_left_out(loops, files)) notes.push_back(*note);
  contents->notes.insert(contents->notes.begin(), notes.begin(), notes.end());
  return contents;
}

SharedMechanism load_mechanism(const std::string& urdf_text, const std::string& urdf_name,
                               const std::string& config_text, const std::string& config_name,
                               const std::string& frame_prefix) {
  return load_mechanism(urdf_text, urdf_name, config_text, config_name, frame_prefix, LoadSearch{});
}

SharedMechanism load_mechanism(const std::string& urdf_text, const std::string& urdf_name,
                               const std::string& config_text, const std::string& config_name,
                               const std::string& frame_prefix, const LoadSearch& search) {
  if (const auto text = from_latin_1(urdf_text))
    return load_mechanism(*text, urdf_name, config_text, config_name, frame_prefix, search);
  Problems problems;
  Notes notes;
  const SourceNames files{urdf_name, config_name, search.as_options};
  MechanismConfig config = read_mechanism_config(config_text, config_name, problems);
  config.frame_prefix = frame_prefix;
  auto tree = read_tree(urdf_text, urdf_name, problems, notes);
  if (!tree) throw InvalidDescription(problems);
  add_operational_point(config.operational_point, files, *tree, problems);
  ResolvedConfig resolved = resolved_names(*tree, config, urdf_text, config_text, files, problems, notes);
  if (!problems.empty()) throw InvalidDescription(problems);
  auto contents =
      recognise_named({std::make_shared<const Tree>(std::move(*tree)), config, resolved}, files, search);
  add_stated_constraints(config.constraints, config.symmetrize, files, *contents, problems);
  contents->acceleration =
      read_acceleration(config_text, config_name, contents->manipulator->leg_count(), problems);
  if (!problems.empty()) throw InvalidDescription(problems);
  find_home(config, files, *contents);
  take_tolerance(config.tolerance, files, *contents);
  if (search.looks_for_remedies)
    if (const auto note = note_on_symmetry(*contents, config, files)) contents->notes.push_back(*note);
  contents->notes.insert(contents->notes.begin(), notes.begin(), notes.end());
  return SharedMechanism(std::make_shared<const Mechanism>(std::move(contents)));
}

}  // namespace parallel_aspects
