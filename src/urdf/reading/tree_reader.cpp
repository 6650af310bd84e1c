// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/reading/tree_reader.h"

#include "urdf/reading/console_capture.h"

#include <boost/locale/encoding_utf.hpp>
#include <urdf_parser/urdf_parser.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <unordered_map>

namespace parallel_aspects {
namespace {

constexpr std::size_t max_shown = 20;  // characters of a text that is something else

struct Format {
  std::string start, remedy;
};

const std::array<Format, 5>& formats() {
  static const std::array<Format, 5> all{
      {{"version https://git-lfs", "is a pointer of Git LFS, not the file; fetch that with 'git lfs pull'."},
       {"\xff\xfe", "is in UTF-16; save it as UTF-8."},
       {"\xfe\xff", "is in UTF-16; save it as UTF-8."},
       {"\x1f\x8b", "is compressed; unpack it with gunzip."},
       {"PK\x03\x04", "is a ZIP archive; unpack it and give the URDF in it."}}};
  return all;
}

bool starts_with(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

bool is_printable(const std::string& text) {
  for (const char letter : text)
    if (letter < ' ' || letter > '~') return false;
  return true;
}

// What a text is that does not begin as XML does.
std::optional<std::string> other_format(const std::string& text) {
  for (const Format& format : formats())
    if (starts_with(text, format.start)) return format.remedy;
  if (text.find('\0') != std::string::npos)
    return "has a byte that is 0, so that it is no text; give a URDF.";
  const std::size_t start = text.find_first_not_of(" \t\r\n", starts_with(text, "\xef\xbb\xbf") ? 3 : 0);
  if (start == std::string::npos) return "is empty or missing; give a URDF.";
  if (text[start] == '<') return std::nullopt;
  const std::string shown =
      text.substr(start, text.find_first_of("\r\n", start) - start).substr(0, max_shown);
  return "is not XML, as it does not begin with '<'" +
         (is_printable(shown) ? ", but with '" + shown + "'" : std::string()) + "; give a URDF.";
}

}  // namespace

std::optional<std::string> parse_robot(const std::string& text, tinyxml2::XMLDocument& document) {
  if (auto other = other_format(text)) return other;
  if (document.Parse(text.data(), text.size()) == tinyxml2::XML_SUCCESS) {
    if (document.FirstChildElement("robot") != nullptr) return std::nullopt;
    const tinyxml2::XMLElement* root = document.RootElement();
    return "has no <robot> element" + (root != nullptr ? ", but <" + std::string(root->Name()) + ">" : "") +
           "; give a URDF.";
  }
  if (text.find("<robot") != std::string::npos && text.find("</robot") == std::string::npos)
    return "ends before its <robot> does; give the whole file.";
  return "is not well-formed XML near line " + std::to_string(document.ErrorLineNum()) + " (" +
         tinyxml2::XMLDocument::ErrorIDToName(document.ErrorID()) + "); correct it there.";
}

std::optional<std::string> from_latin_1(const std::string& text) {
  if (other_format(text)) return std::nullopt;
  namespace conv = boost::locale::conv;
  try {
    conv::utf_to_utf<char32_t>(text, conv::stop);
    return std::nullopt;
  } catch (const conv::conversion_error&) {
  }
  std::u32string points;
  for (const char letter : text) points.push_back(static_cast<unsigned char>(letter));
  return conv::utf_to_utf<char>(points);
}

namespace {

Eigen::Isometry3d isometry(const urdf::Pose& pose) {
  Eigen::Quaterniond rotation;
  pose.rotation.getQuaternion(rotation.x(), rotation.y(), rotation.z(), rotation.w());
  return Eigen::Translation3d(pose.position.x, pose.position.y, pose.position.z) * rotation.normalized();
}

JointMotion motion(const urdf::Joint& joint) {
  if (joint.type == urdf::Joint::FIXED) return JointMotion::fixed;
  return joint.type == urdf::Joint::PRISMATIC ? JointMotion::prismatic : JointMotion::revolute;
}

urdf::ModelInterfaceSharedPtr parsed(const std::string& text, std::string& refusal) {
  ConsoleCapture console;
  try {
    auto model = urdf::parseURDF(text);
    refusal = console.first_error;
    return model;
  } catch (const std::exception& error) {
    refusal = error.what();
    return nullptr;
  }
}

class TreeBuilder {
 public:
  TreeBuilder(const urdf::ModelInterface& model, const UrdfInspection& inspection)
      : model_(model), inspection_(inspection) {}

  Tree build() {
    tree_.name = model_.getName();
    tree_.links = {model_.getRoot()->name};
    tree_.joint_above = {std::nullopt};
    // The list grows while it is walked: every link brings its children.
    for (std::size_t link = 0; link < tree_.links.size(); ++link)
      for (const auto& joint : model_.getLink(tree_.links[link])->child_joints) add(*joint, link);
    number_joints();
    return std::move(tree_);
  }

 private:
  void add(const urdf::Joint& joint, std::size_t parent) {
    TreeJoint added;
    added.name = joint.name;
    added.motion = motion(joint);
    added.parent = parent;
    added.mimics = inspection_.mimics.count(joint.name) > 0;
    added.child = tree_.links.size();
    added.origin = isometry(joint.parent_to_joint_origin_transform);
    if (const auto wide = inspection_.wide_angles.find(joint.name); wide != inspection_.wide_angles.end())
      added.wide_angles = Eigen::Vector3d(wide->second[0], wide->second[1], wide->second[2]);
    if (added.motion != JointMotion::fixed)
      added.axis = Eigen::Vector3d(joint.axis.x, joint.axis.y, joint.axis.z).normalized();
    const bool limited = joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::PRISMATIC;
    if (limited && inspection_.without_limits.count(joint.name) == 0)
      added.limits = {joint.limits->lower, joint.limits->upper};
    // Zero is what urdfdom demands of those who have no limit to give.
    if (joint.limits && std::isfinite(joint.limits->velocity) && joint.limits->velocity > 0.0)
      added.limits.velocity = joint.limits->velocity;
    tree_.links.push_back(joint.child_link_name);
    tree_.joint_above.emplace_back(tree_.joints.size());
    tree_.joints.push_back(added);
  }

  void number_joints() {
    std::unordered_map<std::string, std::size_t> indices;
    for (std::size_t k = 0; k < tree_.joints.size(); ++k) indices.emplace(tree_.joints[k].name, k);
    for (const std::string& name : inspection_.joints) {
      const std::size_t index = indices.at(name);
      if (tree_.joints[index].motion == JointMotion::fixed) continue;
      tree_.joints[index].variable = tree_.movable.size();
      tree_.movable.push_back(index);
    }
  }

  const urdf::ModelInterface& model_;
  const UrdfInspection& inspection_;
  Tree tree_;
};

}  // namespace

std::optional<Tree> read_tree(const std::string& text, const std::string& file, Problems& problems,
                              Notes& notes) {
  const std::size_t before = problems.size();
  const UrdfInspection inspection = inspect_urdf(text, file, problems, notes);
  if (problems.size() > before) return std::nullopt;
  std::string refusal;
  const urdf::ModelInterfaceSharedPtr model = parsed(inspection.text, refusal);
  if (!model || !model->getRoot()) {
    problems.push_back(file + " is refused by urdfdom: " + refusal);
    return std::nullopt;
  }
  return TreeBuilder(*model, inspection).build();
}

}  // namespace parallel_aspects
