// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/setup_config.h"

#include "urdf/description/messages.h"
#include "urdf/description/xml_values.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <sstream>
#include <utility>

namespace parallel_aspects {

std::optional<PlacedFrame> placed_frame(const std::string& text) {
  const std::size_t at = text.rfind('@');
  if (at == std::string::npos || at == 0) return std::nullopt;
  std::string coordinates = text.substr(at + 1);
  const auto colons = static_cast<std::size_t>(std::count(coordinates.begin(), coordinates.end(), ':'));
  if (colons != 2 && colons != 5) return std::nullopt;
  std::replace(coordinates.begin(), coordinates.end(), ':', ' ');
  auto found = numbers(coordinates);
  if (!found || found->size() != colons + 1) return std::nullopt;
  found->resize(6, 0.0);
  const std::vector<double>& each = *found;
  return PlacedFrame{text.substr(0, at), {each[0], each[1], each[2]}, {each[3], each[4], each[5]}};
}

void add_placed_frame(Tree& tree, const std::string& text) {
  const auto frame = placed_frame(text);
  const auto parent = frame ? tree.link_named(frame->link) : std::nullopt;
  if (!parent || tree.link_named(text)) return;
  TreeJoint joint;
  joint.name = text;
  joint.parent = *parent;
  joint.child = tree.links.size();
  joint.origin.translation() = frame->xyz;
  joint.origin.linear() = rotation_of(frame->rpy);
  tree.joint_above.emplace_back(tree.joints.size());
  tree.joints.push_back(joint);
  tree.links.push_back(text);
}

namespace {

constexpr std::size_t width = 110;           // of comments, as in the shipped files
constexpr std::size_t max_others_shown = 4;  // as many as are tried

// A text may hold anything, and a comment ends with its line.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char letter) { return static_cast<unsigned char>(letter) < 32; }, ' ');
  return text;
}

// Broken between words.
std::string wrapped(const std::string& text) {
  std::string lines, line;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    if (!line.empty() && line.size() + word.size() + 1 > width) {
      lines += line + '\n';
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
    at = end + 1;
  }
  return lines + line;
}

std::string joined(const std::vector<std::string>& values) {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "" : ", ") + value;
  return text;
}

// With quotation marks where YAML needs them.
template <class Value>
std::string yaml(const Value& value) {
  YAML::Emitter out;
  out << YAML::Flow << value;
  return out.c_str();
}

// The name of a link, or a place in its frame.
std::string yaml_frame(const std::string& text) {
  const auto frame = placed_frame(text);
  const auto in_list = [](const std::string& name) {
    const std::string list = yaml(std::vector<std::string>{name});
    return list.substr(1, list.size() - 2);
  };
  if (!frame) return in_list(text);
  const auto list = [](const Eigen::Vector3d& vector) {
    return "[" + coordinate_text(vector.x()) + ", " + coordinate_text(vector.y()) + ", " +
           coordinate_text(vector.z()) + "]";
  };
  return "{link: " + in_list(frame->link) +
         (frame->xyz.isZero(0.0) && !frame->rpy.isZero(0.0) ? "" : ", xyz: " + list(frame->xyz)) +
         (frame->rpy.isZero(0.0) ? "" : ", rpy: " + list(frame->rpy)) + "}";
}

// The emitter of yaml-cpp does not indent comments.
class Writer {
 public:
  explicit Writer(const SetupDraft& draft) : draft_(draft) {}

  std::string text() {
    comment("", "What " + draft_.urdf_name +
                    ", a tree, does not say. Written by `aspects setup`: above each value stands why it was "
                    "taken. Check the guesses.");
    text_ += "mechanism:\n";
    comment(indent, "Name of the robot in messages.");
    entry("name", yaml(draft_.robot));
    single("base_link", "Link that carries the base, in whose frame `describe` gives the task frame",
           draft_.base_link);
    single("operational_point", "Link whose origin is the operational point", draft_.operational_point);
    explain("actuated_joints", "Actuated joints, one a leg", draft_.actuated_joints);
    for (const std::string& note : draft_.notes) comment(indent, note);
    entry("actuated_joints", yaml(draft_.actuated_joints.values));
    write_task_space();
    write_closures();
    write_closure_notes();
    write_start();
    return text_;
  }

 private:
  void comment(const std::string& before, const std::string& text) {
    std::istringstream lines(wrapped(one_line(text)));
    for (std::string line; std::getline(lines, line);) text_ += before + "# " + line + '\n';
  }

  void entry(const std::string& key, const std::string& value) {
    text_ += indent + key + ": " + value + '\n';
  }

  void explain(const std::string& key, const std::string& what, const SetupCandidate& taken) {
    std::string text = what + ": " + taken.reason + ".";
    for (const SetupChoice& choice : draft_.others)
      for (std::size_t k = 0; choice.key == key && k < std::min(choice.others.size(), max_others_shown); ++k)
        text += " Would load too: " + joined(choice.others[k].values) + " (" + choice.others[k].reason + ").";
    text_ += '\n';
    comment(indent, text);
  }

  void single(const std::string& key, const std::string& what, const SetupCandidate& taken) {
    explain(key, what, taken);
    entry(key, yaml_frame(taken.values.front()));
  }

  void write_task_space() {
    if (!draft_.task_space) return;
    text_ += '\n';
    comment(indent, "Found from how the platform can move.");
    entry("task_space", std::string(name(*draft_.task_space)));
  }

  void write_closures() {
    explain("closures", "Loop closures, each holds the origins of two links together", draft_.closures);
    if (!draft_.closures.values.empty())
      comment(indent, "Their type is the first under which the mobility is the number of actuated joints.");
    if (draft_.closures.values.empty()) return;
    text_ += indent + (draft_.adds_closures ? "added_closures" : "closures") + ":\n";
    for (const std::string& pair : draft_.closures.values) {
      const std::size_t middle = pair.find('=');
      text_ += indent + indent + "- {frames: [" + yaml_frame(pair.substr(0, middle)) + ", " +
               yaml_frame(pair.substr(middle + 1)) + "], type: " + draft_.closure_type + "}\n";
    }
  }

  // A list stands below what is said of it, to be taken out of the comment.
  void write_closure_notes() {
    for (const Note& note : draft_.closure_notes) {
      std::string said, list;
      for (const Note::Piece& piece : note.pieces()) {
        const bool is_list = piece.kind == Note::Piece::Kind::closures;
        said += is_list ? "the closures below" : piece.text();
        for (std::size_t k = 0; is_list && k < piece.items.size(); ++k)
          list += indent + "#   - " + one_line(piece.items[k]) + '\n';
      }
      text_ += '\n';
      comment(indent, said);
      text_ += indent + "# closures:\n" + list;
    }
  }

  // A guess as well, but one that the node holds against the first joint sample.
  void write_start() {
    if (!draft_.task_space || !draft_.home) return;
    const PoseCoordinates coordinates = pose_coordinates(*draft_.task_space, *draft_.home);
    std::string values;
    for (Eigen::Index i = 0; i < coordinates.size(); ++i)
      values += (i == 0 ? "" : ", ") + coordinate_text(coordinates[i]);
    text_ += "\nstart:\n";
    comment(indent,
            "Where the robot is when the monitor gets its first joint sample: a guess, the pose in which the "
            "loops were closed to find the mechanism. Where its actuated joints do not assemble within "
            "start/tolerance of it, by default 1/20 of the robot's size, the assembly mode is not known. "
            "Coordinates: " +
                joined(coordinate_names(*draft_.task_space)) +
                (has_hinges(*draft_.task_space) ? " [rad]." : " [m, rad]."));
    entry("pose", "[" + values + "]");
  }

  const std::string indent = "  ";
  const SetupDraft& draft_;
  std::string text_;
};

}  // namespace

std::string config_text(const SetupDraft& draft) { return Writer(draft).text(); }

std::string options_for(const SetupDraft& draft) {
  std::string text;
  for (const auto& [key, candidate] :
       {std::pair<const char*, const SetupCandidate*>{"closures", &draft.closures},
        {"base_link", &draft.base_link},
        {"operational_point", &draft.operational_point},
        {"actuated_joints", &draft.actuated_joints}})
    if (!candidate->values.empty()) text += (text.empty() ? "" : " ") + option_for(key, candidate->values);
  return text;
}

}  // namespace parallel_aspects
