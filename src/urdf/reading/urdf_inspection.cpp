// SPDX-License-Identifier: BSD-3-Clause

#include "urdf/config/mechanism_config.h"
#include "urdf/description/nearest_name.h"
#include "urdf/description/xml_values.h"
#include "urdf/reading/description_file.h"
#include "urdf/reading/tree_reader.h"

#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <locale>
#include <map>
#include <optional>
#include <sstream>
#include <unordered_map>
#include <unordered_set>

namespace parallel_aspects {
namespace {

using tinyxml2::XMLElement;

// More than this many radians in a joint limit is more likely a number of degrees.
constexpr double suspicious_angle = 20.0;

// Metres, radians or parts of an axis: products of larger numbers overflow.
constexpr double largest_number = 1e6;

// Of an angle [rad]; 6.2832 is meant to be one.
constexpr double full_turn = 6.2832;

std::optional<double> number(const std::string& text) {
  const auto values = numbers(text);
  if (!values || values->size() != 1) return std::nullopt;
  return values->front();
}

// What is accepted with a remark, the same of many joints.
enum class Remark { zero_axis, mimic, revolute_without_limits, prismatic_without_limits, degrees };

struct RemarkText {
  Remark remark;
  const char *before, *after_one, *after_several;  // around "joint 'a'" or "joints 'a', 'b'"
};

constexpr std::array<RemarkText, 5> remark_texts{
    {{Remark::zero_axis, "gives fixed ", " a zero axis; it is not used.", " a zero axis; it is not used."},
     {Remark::mimic, "lets ", " mimic another joint; that is not used, the loop closures decide.",
      " mimic others; that is not used, the loop closures decide."},
     {Remark::revolute_without_limits, "states no limits for revolute ",
      ", or both as 0; it is taken as unlimited.", ", or both as 0; they are taken as unlimited."},
     {Remark::prismatic_without_limits, "states no limits for prismatic ",
      ", or both as 0; it is taken as unlimited.", ", or both as 0; they are taken as unlimited."},
     {Remark::degrees, "gives ", " limits that look like degrees; they are taken as radians.",
      " limits that look like degrees; they are taken as radians."}}};

// One message for each remark that was made.
Notes messages(const std::multimap<Remark, std::string>& remarks) {
  Notes result;
  for (const RemarkText& text : remark_texts) {
    const auto [first, last] = remarks.equal_range(text.remark);
    const std::size_t count = static_cast<std::size_t>(std::distance(first, last));
    if (count == 0) continue;
    std::vector<std::string> names;
    for (auto entry = first; entry != last; ++entry) names.push_back(entry->second);
    result.push_back(text.before + std::string(count == 1 ? "joint " : "joints ") + listed_names(names) +
                     (count == 1 ? text.after_one : text.after_several));
  }
  return result;
}

constexpr int max_guesses = 20;  // of names that may be meant

using NameSet = std::unordered_set<std::string>;

class Inspector {
 public:
  Inspector(const std::string& file, Problems& problems, Notes& notes)
      : file_(file), problems_(problems), notes_(notes), earlier_problems_(problems.size()) {}

  UrdfInspection inspect(const std::string& text) {
    tinyxml2::XMLDocument document;
    XMLElement* robot = parse(text, document);
    if (robot == nullptr || find_xacro(robot)) return {};
    if (attribute(robot, "name").empty())
      problem("has a <robot> without a name; write <robot name=\"...\">.");
    inspect_links(robot);
    inspect_joints(robot);
    inspect_topology();
    for (const Note& message : messages(remarks_)) notes_.push_back(file_ + " " + message);
    for (const auto* note = robot->FirstChildElement("reader_note"); note != nullptr;  // of `urdf_text`
         note = note->NextSiblingElement("reader_note"))
      notes_.push_back(file_ + " " + attribute(note, "text"));
    if (!unused_shapes_.empty())
      notes_.push_back(file_ + " has shapes that cannot be, " + unused_shapes_ +
                       "; they are not used, as kinematics needs none.");
    leave_out_what_kinematics_does_not_need(robot);
    leave_out_doctype(document);
    tinyxml2::XMLPrinter printer(nullptr, true);  // without indents, which may be longer than the text
    document.Print(&printer);
    result_.text = printer.CStr();
    return result_;
  }

 private:
  void problem(const std::string& text) { problems_.push_back(file_ + " " + text); }

  // The <robot> element; null, with what is wrong, where there is none.
  XMLElement* parse(const std::string& text, tinyxml2::XMLDocument& document) {
    const auto fault = parse_robot(text, document);
    if (fault) problem(*fault);
    return fault ? nullptr : document.FirstChildElement("robot");
  }

  bool find_xacro(const XMLElement* element) {
    const bool tag = std::strncmp(element->Name(), "xacro:", 6) == 0;
    const char* expression = nullptr;
    for (const auto* a = element->FirstAttribute(); a != nullptr; a = a->Next())
      if (std::strstr(a->Value(), "${") != nullptr || std::strstr(a->Value(), "$(") != nullptr)
        expression = a->Value();
    if (tag || expression != nullptr) {
      problem("still contains xacro ('" + std::string(tag ? element->Name() : expression) + "' in line " +
              std::to_string(element->GetLineNum()) + "); expand it first with " + xacro_command(file_) +
              ".");
      return true;
    }
    for (const auto* child = element->FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement())
      if (find_xacro(child)) return true;
    return false;
  }

  void inspect_links(const XMLElement* robot) {
    for (const auto* link = robot->FirstChildElement("link"); link != nullptr;
         link = link->NextSiblingElement("link")) {
      const std::string name = attribute(link, "name");
      if (name.empty())
        problem("has a link without a name in line " + std::to_string(link->GetLineNum()) + "; name it.");
      if (!link_names_.insert(name).second) problem("has two links named '" + name + "'; rename one.");
      links_.push_back(name);
      for (const char* part : {"visual", "collision"})
        for (const auto* body = link->FirstChildElement(part); body != nullptr;
             body = body->NextSiblingElement(part))
          inspect_body(body, "link '" + name + "'");
    }
    if (links_.empty()) problem("has no links; give a URDF with the links and joints of the robot.");
  }

  // What is wrong here is none of the robot's motion.
  void inspect_body(const XMLElement* body, const std::string& owner) {
    const auto* origin = body->FirstChildElement("origin");
    for (const char* name : {"xyz", "rpy"})
      if (origin != nullptr && origin->Attribute(name) != nullptr && !has_numbers(origin, name, 3))
        remark_shape(origin, name, owner);
    const auto* geometry = body->FirstChildElement("geometry");
    if (geometry == nullptr) return;
    check_lengths(geometry->FirstChildElement("box"), "size", 3, owner);
    check_lengths(geometry->FirstChildElement("cylinder"), "radius", 1, owner);
    check_lengths(geometry->FirstChildElement("cylinder"), "length", 1, owner);
    check_lengths(geometry->FirstChildElement("sphere"), "radius", 1, owner);
    const auto* mesh = geometry->FirstChildElement("mesh");
    if (mesh != nullptr && attribute(mesh, "filename").empty()) remark_shape(mesh, "filename", owner);
  }

  void check_lengths(const XMLElement* shape, const char* name, std::size_t count, const std::string& owner) {
    if (shape == nullptr) return;
    const auto values = numbers(attribute(shape, name));
    if (!has_numbers(shape, name, count) ||
        !std::all_of(values->begin(), values->end(), [](double value) { return value > 0.0; }))
      remark_shape(shape, name, owner);
  }

  static bool has_numbers(const XMLElement* element, const char* name, std::size_t count) {
    const auto values = numbers(attribute(element, name));
    return values && values->size() == count;
  }

  void remark_shape(const XMLElement* shape, const char* name, const std::string& owner) {
    unused_shapes_ += (unused_shapes_.empty() ? "<" : ", <") + std::string(shape->Name()) + " " + name +
                      "='" + attribute(shape, name) + "'> in " + owner;
  }

  // Which urdfdom cannot read; text beside <robot> is what is left of one.
  static void leave_out_doctype(tinyxml2::XMLDocument& document) {
    for (auto* node = document.FirstChild(); node != nullptr;) {
      auto* next = node->NextSibling();
      if (node->ToUnknown() != nullptr || node->ToText() != nullptr) document.DeleteChild(node);
      node = next;
    }
  }

  // So that urdfdom does not refuse it.
  static void leave_out_what_kinematics_does_not_need(XMLElement* robot) {
    leave_out(robot, {"material"});
    for (auto* link = robot->FirstChildElement("link"); link != nullptr;
         link = link->NextSiblingElement("link"))
      leave_out(link, {"visual", "collision", "inertial"});
    for (auto* joint = robot->FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint"))
      leave_out(joint, {"dynamics", "safety_controller", "calibration"});
  }

  static void leave_out(XMLElement* parent, std::initializer_list<const char*> names) {
    for (const char* name : names)
      while (auto* child = parent->FirstChildElement(name)) parent->DeleteChild(child);
  }

  // Its rpy, where it states one.
  std::optional<std::vector<double>> check_origin(const XMLElement* parent, const std::string& owner) {
    const auto* origin = parent != nullptr ? parent->FirstChildElement("origin") : nullptr;
    if (origin == nullptr) return std::nullopt;
    check_vector(origin, "xyz", owner);
    return check_vector(origin, "rpy", owner);
  }

  // Quaternions forget it.
  void keep_wide_angles(const std::string& joint, const std::vector<double>& angles) {
    const auto is_wide = [](double angle) { return std::abs(angle) > full_turn; };
    if (std::any_of(angles.begin(), angles.end(), is_wide))
      result_.wide_angles[joint] = {angles[0], angles[1], angles[2]};
  }

  std::optional<std::vector<double>> check_vector(const XMLElement* element, const char* name,
                                                  const std::string& owner) {
    if (element == nullptr || element->Attribute(name) == nullptr) return std::nullopt;
    auto values = numbers(attribute(element, name));
    const bool are_three = values && values->size() == 3;
    const bool are_small = are_three && std::all_of(values->begin(), values->end(), [](double value) {
                             return std::abs(value) <= largest_number;
                           });
    if (are_small) return values;
    problem("gives " + owner + " the " + element->Name() + " " + name + "=\"" + attribute(element, name) +
            (are_three ? "\", which has a number beyond a million; write metres in xyz, radians in rpy."
                       : "\", which is not three finite numbers; write three, separated by blanks."));
    return std::nullopt;
  }

  void inspect_joints(XMLElement* robot) {
    for (auto* joint = robot->FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint")) {
      const std::string name = attribute(joint, "name");
      const std::string owner = "joint '" + name + "'";
      if (name.empty())
        problem("has a joint without a name in line " + std::to_string(joint->GetLineNum()) + "; name it.");
      if (!joint_names_.insert(name).second) problem("has two joints named '" + name + "'; rename one.");
      result_.joints.push_back(name);
      if (const auto angles = check_origin(joint, owner)) keep_wide_angles(name, *angles);
      inspect_connection(joint, owner);
      inspect_type(joint, name, owner);
    }
    if (result_.joints.empty() && !links_.empty())
      problem("has no joints; give a URDF with the joints of the robot.");
  }

  void inspect_connection(const XMLElement* joint, const std::string& owner) {
    std::array<std::string, 2> ends;
    const std::array<const char*, 2> tags{"parent", "child"};
    for (std::size_t k = 0; k < 2; ++k) {
      ends[k] = attribute(joint->FirstChildElement(tags[k]), "link");
      if (link_names_.count(ends[k]) > 0) continue;
      problem("gives " + owner + " the " + tags[k] + " link '" + ends[k] + "', which does not exist; " +
              remedy_for_missing(ends[k]));
    }
    if (!parent_joint_.emplace(ends[1], attribute(joint, "name")).second)
      problem("makes link '" + ends[1] + "' the child of " + owner + " and of joint '" +
              parent_joint_[ends[1]] + "'; a URDF is a tree, so cut one and close the loop in the YAML.");
    parent_[ends[1]] = ends[0];
  }

  // Comparing a name with all others takes long where both are many.
  std::string remedy_for_missing(const std::string& link) {
    const std::string similar = guesses_++ < max_guesses ? similar_name(link, links_) : "";
    return similar.empty() ? "add it." : "add it, or write '" + similar + "'.";
  }

  void inspect_type(XMLElement* joint, const std::string& name, const std::string& owner) {
    const std::string type = attribute(joint, "type");
    const auto axis = check_vector(joint->FirstChildElement("axis"), "xyz", owner);
    const bool zero = axis && length(*axis) < 1e-9;
    if (type == "fixed") {
      // urdfdom examines the limits of a joint that has none to keep, too.
      if (auto* limit = joint->FirstChildElement("limit")) joint->DeleteChild(limit);
      if (zero) remarks_.emplace(Remark::zero_axis, name);
      return;
    }
    if (type != "revolute" && type != "continuous" && type != "prismatic") {
      problem("gives " + owner + (type.empty() ? " no type" : " the type '" + type + "'") +
              "; use revolute, continuous, prismatic or fixed, and several joints in place of one with more "
              "degrees of freedom.");
      return;
    }
    if (zero) problem("gives " + owner + " a zero axis; give the direction of the joint.");
    if (joint->FirstChildElement("mimic") != nullptr) {
      remarks_.emplace(Remark::mimic, name);
      result_.mimics.insert(name);
    }
    inspect_limits(joint, name, owner, type);
  }

  static double length(const std::vector<double>& v) { return std::hypot(v[0], v[1], v[2]); }

  void inspect_limits(XMLElement* joint, const std::string& name, const std::string& owner,
                      const std::string& type) {
    auto* limit = joint->FirstChildElement("limit");
    std::array<double, 2> range{0.0, 0.0};
    const std::array<const char*, 2> tags{"lower", "upper"};
    for (std::size_t k = 0; limit != nullptr && k < 2; ++k) {
      const std::string text = attribute(limit, tags[k]);
      const auto value = number(text);
      if (value) range[k] = *value;
      if (!value && limit->Attribute(tags[k]) != nullptr)
        problem("gives " + owner + " the " + tags[k] + " limit '" + text +
                "', which is not a finite number; give " + (type == "prismatic" ? "metres." : "radians."));
    }
    if (range[0] > range[1]) problem("gives " + owner + " a lower limit above its upper one; exchange them.");
    supply_limit(joint, limit);
    if (type == "continuous") return;
    if (range[0] == 0.0 && range[1] == 0.0) {
      result_.without_limits.insert(name);
      remarks_.emplace(
          type == "prismatic" ? Remark::prismatic_without_limits : Remark::revolute_without_limits, name);
    } else if (type == "revolute" && std::max(-range[0], range[1]) > suspicious_angle) {
      remarks_.emplace(Remark::degrees, name);
    }
  }

  // urdfdom refuses a limit without effort and velocity, and a revolute or prismatic joint without a limit.
  static void supply_limit(XMLElement* joint, XMLElement* limit) {
    if (limit == nullptr) limit = joint->InsertNewChildElement("limit");
    for (const char* name : {"lower", "upper", "effort", "velocity"})
      if (!number(attribute(limit, name))) limit->SetAttribute(name, "0");
  }

  void inspect_topology() {
    if (problems_.size() > earlier_problems_) return;
    std::vector<std::string> roots;
    for (const std::string& link : links_)
      if (parent_.count(link) == 0) roots.push_back(link);
    if (roots.size() > 1)
      problem("has two root links, '" + roots[0] + "' and '" + roots[1] + "'; connect them with a joint.");
    if (roots.size() != 1) {
      if (roots.empty())
        problem("has links in a circle and no root; cut one joint and close the loop in the YAML.");
      return;
    }
    const NameSet hanging = links_below(roots.front());
    for (const std::string& link : links_)
      if (hanging.count(link) == 0)
        problem("has link '" + link +
                "' in a circle of joints; cut one joint and close the loop in the YAML.");
  }

  NameSet links_below(const std::string& root) const {
    std::unordered_map<std::string, std::vector<std::string>> children;
    for (const auto& [child, parent] : parent_) children[parent].push_back(child);
    NameSet below{root};
    std::vector<std::string> open{root};
    while (!open.empty()) {
      const std::string link = std::move(open.back());
      open.pop_back();
      for (const std::string& child : children[link])
        if (below.insert(child).second) open.push_back(child);
    }
    return below;
  }

  const std::string& file_;
  Problems& problems_;
  Notes& notes_;
  std::size_t earlier_problems_;
  UrdfInspection result_;
  std::multimap<Remark, std::string> remarks_;  // and the joints that they are about
  std::string unused_shapes_;                   // for a note
  std::vector<std::string> links_;
  NameSet link_names_, joint_names_;
  int guesses_ = 0;
  std::unordered_map<std::string, std::string> parent_;        // link above each link
  std::unordered_map<std::string, std::string> parent_joint_;  // joint above each link
};

}  // namespace

UrdfInspection inspect_urdf(const std::string& text, const std::string& file, Problems& problems,
                            Notes& notes) {
  return Inspector(file, problems, notes).inspect(text);
}

}  // namespace parallel_aspects
