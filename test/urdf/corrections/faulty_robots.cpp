// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/faulty_robots.h"

#include <tinyxml2.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <functional>
#include <map>
#include <regex>
#include <sstream>

namespace parallel_aspects::test {
namespace {

using tinyxml2::XMLDocument;
using tinyxml2::XMLElement;
using Triple = std::vector<double>;

Triple triple(const char* text) {
  Triple numbers(3, 0.0);
  std::istringstream stream(text != nullptr ? text : "0 0 0");
  stream >> numbers[0] >> numbers[1] >> numbers[2];
  return numbers;
}

std::string text_of(const Triple& numbers) {
  std::ostringstream text;
  text.precision(17);
  text << numbers[0] << ' ' << numbers[1] << ' ' << numbers[2];
  return text.str();
}

XMLElement* child(XMLElement* joint, const char* name) {
  XMLElement* found = joint->FirstChildElement(name);
  return found != nullptr ? found : joint->InsertNewChildElement(name);
}

XMLElement* joint_named(XMLDocument& document, const std::string& name) {
  XMLElement* joint = document.RootElement()->FirstChildElement("joint");
  while (joint != nullptr && joint->Attribute("name") != name) joint = joint->NextSiblingElement("joint");
  if (joint == nullptr) throw std::invalid_argument("no joint '" + name + "'");
  return joint;
}

std::string printed(const XMLDocument& document) {
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

std::string changed_joint(const std::string& urdf, const std::string& name,
                          const std::function<void(XMLElement*)>& change) {
  XMLDocument document;
  document.Parse(urdf.c_str());
  change(joint_named(document, name));
  return printed(document);
}

std::string printed(const YAML::Node& yaml) {
  YAML::Emitter emitter;
  emitter << yaml;
  return emitter.c_str();
}

std::string closure_name(const YAML::Node& closure) {
  return closure["frames"][0].as<std::string>() + " - " + closure["frames"][1].as<std::string>();
}

YAML::Node closure_named(const YAML::Node& yaml, const std::string& name) {
  for (const YAML::Node& closure : yaml["mechanism"]["closures"])
    if (closure_name(closure) == name) return closure;
  throw std::invalid_argument("no closure '" + name + "'");
}

void set_actuated(YAML::Node yaml, const std::vector<std::string>& joints) {
  yaml["mechanism"]["actuated_joints"] = joints;
}

// As "base_link".
void set_end(YAML::Node yaml, const std::string& end, const std::string& link) {
  yaml["mechanism"][end] = link;
}

class Faults {
 public:
  explicit Faults(const std::string& robot) : good_(shipped_text(robot)) {}

  std::vector<FaultyRobot> all() {
    XMLDocument document;
    document.Parse(good_.urdf.c_str());
    for (XMLElement* joint = document.RootElement()->FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint"))
      add_of_joint(*joint);
    add_of_closures();
    add_of_frames(document);
    add_of_actuated_joints();
    add_of_ends(document);
    return std::move(found_);
  }

 private:
  void add_joint(const std::string& kind, const std::string& name,
                 const std::function<void(XMLElement*)>& change) {
    found_.push_back({kind, "'" + name + "'", {changed_joint(good_.urdf, name, change), good_.config}});
  }

  void add_of_joint(XMLElement& joint) {
    const std::string name = joint.Attribute("name"), type = joint.Attribute("type");
    const auto with_type = [&](const char* wanted) {
      add_joint("type", name, [wanted](XMLElement* changed) { changed->SetAttribute("type", wanted); });
    };
    if (type != "fixed") {
      add_axes(name, triple(joint.FirstChildElement("axis")->Attribute("xyz")));
      with_type("fixed");
      with_type(type == "prismatic" ? "continuous" : "prismatic");
    } else {
      with_type("continuous");
    }
    add_places(name, triple(joint.FirstChildElement("origin")->Attribute("xyz")));
    add_angles(name, triple(joint.FirstChildElement("origin")->Attribute("rpy")));
  }

  void add_axes(const std::string& name, const Triple& axis) {
    for (std::size_t k = 0; k < 3; ++k) {
      Triple other(3, 0.0);
      other[k] = 1.0;
      if (axis[k] == 0.0)
        add_joint("axis", name, [&](XMLElement* joint) {
          child(joint, "axis")->SetAttribute("xyz", text_of(other).c_str());
        });
    }
  }

  void add_places(const std::string& name, const Triple& place) {
    const auto add = [&](const std::string& kind, const Triple& changed) {
      add_joint(kind, name, [&](XMLElement* joint) {
        child(joint, "origin")->SetAttribute("xyz", text_of(changed).c_str());
      });
    };
    for (std::size_t k = 0; k < 3; ++k) {
      Triple changed = place;
      changed[k] = -place[k];
      if (place[k] != 0.0) add("sign", changed);
    }
    if (place != Triple(3, 0.0)) add("millimetres", {1e3 * place[0], 1e3 * place[1], 1e3 * place[2]});
  }

  void add_angles(const std::string& name, const Triple& angles) {
    const auto add = [&](const std::string& kind, const Triple& changed) {
      add_joint(kind, name, [&](XMLElement* joint) {
        child(joint, "origin")->SetAttribute("rpy", text_of(changed).c_str());
      });
    };
    if (angles[2] != 0.0) add("mirrored rpy", {angles[0], angles[1], -angles[2]});
    add("out of plane", {angles[0] + 1.5707963267948966, angles[1], angles[2]});
  }

  void add_config(const std::string& kind, const std::string& element,
                  const std::function<void(YAML::Node)>& change) {
    const YAML::Node yaml = YAML::Load(good_.config);
    change(yaml);
    found_.push_back({kind, element, {good_.urdf, printed(yaml)}});
  }

  void add_of_closures() {
    for (const YAML::Node& closure : YAML::Load(good_.config)["mechanism"]["closures"]) {
      const std::string name = closure_name(closure), type = closure["type"].as<std::string>();
      for (const std::string other : {"revolute", "spherical", "universal", "fixed"})
        if (type != other)
          add_config("closure", "'" + name + "'",
                     [&](const YAML::Node& yaml) { closure_named(yaml, name)["type"] = other; });
      add_config("closed twice", "'" + name + "'", [&](const YAML::Node& yaml) {
        YAML::Node closures = yaml["mechanism"]["closures"];
        closures.push_back(YAML::Clone(closure_named(yaml, name)));
      });
    }
  }

  // A frame on the link that carries the frame of another closure, or on the root; one in the place of
  // another; a closure that is missing.
  void add_of_frames(XMLDocument& document) {
    const YAML::Node closures = YAML::Load(good_.config)["mechanism"]["closures"];
    const std::string root = document.RootElement()->FirstChildElement("link")->Attribute("name");
    for (std::size_t k = 0; k < closures.size(); ++k) {
      const std::size_t next = (k + 1) % closures.size();
      for (const std::size_t end : {0, 1}) {
        const std::string frame = closures[k]["frames"][end].as<std::string>(),
                          other = closures[next]["frames"][end].as<std::string>();
        add_parent(document, frame, root);
        if (next == k) continue;
        add_parent(document, frame, parent_of(document, other));
        add_other_frame(k, end, other);
      }
      if (next != k) add_without(k);
    }
  }

  static XMLElement* joint_above(XMLDocument& document, const std::string& link) {
    XMLElement* joint = document.RootElement()->FirstChildElement("joint");
    while (joint != nullptr && joint->FirstChildElement("child")->Attribute("link") != link)
      joint = joint->NextSiblingElement("joint");
    return joint;
  }

  static std::string parent_of(XMLDocument& document, const std::string& link) {
    return joint_above(document, link)->FirstChildElement("parent")->Attribute("link");
  }

  void add_parent(XMLDocument& document, const std::string& frame, const std::string& parent) {
    XMLElement* joint = joint_above(document, frame);
    if (joint->Attribute("type", "fixed") == nullptr || parent_of(document, frame) == parent) return;
    add_joint("parent", joint->Attribute("name"),
              [&](XMLElement* changed) { child(changed, "parent")->SetAttribute("link", parent.c_str()); });
  }

  void add_other_frame(std::size_t closure, std::size_t end, const std::string& other) {
    const YAML::Node yaml = YAML::Load(good_.config);
    YAML::Node frames = yaml["mechanism"]["closures"][closure]["frames"];
    const std::string meant = frames[end].as<std::string>();
    frames[end] = other;
    found_.push_back({"frame", "link '" + meant + "'", {good_.urdf, printed(yaml)}});
  }

  void add_without(std::size_t closure) {
    const YAML::Node yaml = YAML::Load(good_.config);
    YAML::Node closures = yaml["mechanism"]["closures"];
    const YAML::Node frames = closures[closure]["frames"];
    const std::string element = "[" + frames[0].as<std::string>() + ", " + frames[1].as<std::string>() + "]";
    closures.remove(closure);
    found_.push_back({"no closure", element, {good_.urdf, printed(yaml)}});
  }

  void add_actuated(const std::string& kind, const std::vector<std::string>& joints) {
    add_config(kind, "actuated_joints", [&](const YAML::Node& yaml) { set_actuated(yaml, joints); });
  }

  // One less, one more, and one in the place of another.
  void add_of_actuated_joints() {
    const auto joints =
        YAML::Load(good_.config)["mechanism"]["actuated_joints"].as<std::vector<std::string>>();
    XMLDocument document;
    document.Parse(good_.urdf.c_str());
    for (std::size_t k = 0; k < joints.size(); ++k) {
      std::vector<std::string> fewer = joints;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
      if (!fewer.empty()) add_actuated("one missing", fewer);
    }
    for (XMLElement* joint = document.RootElement()->FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint")) {
      const std::string name = joint->Attribute("name");
      if (joint->Attribute("type", "fixed") != nullptr) continue;
      if (std::find(joints.begin(), joints.end(), name) != joints.end()) continue;
      std::vector<std::string> more = joints, other = joints;
      more.push_back(name);
      other.back() = name;
      add_actuated("one too many", more);
      add_actuated("two in a leg", other);
    }
  }

  // On each other body.
  void add_of_ends(XMLDocument& document) {
    for (XMLElement* joint = document.RootElement()->FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint")) {
      const std::string link = joint->FirstChildElement("child")->Attribute("link");
      if (joint->Attribute("type", "fixed") != nullptr) continue;
      for (const std::string end : {"operational_point", "base_link"})
        add_config(end, end + ":", [&](const YAML::Node& yaml) { set_end(yaml, end, link); });
    }
  }

  Description good_;
  std::vector<FaultyRobot> found_;
};

std::string quoted(const std::string& text, const std::string& pattern) {
  std::smatch found;
  return std::regex_search(text, found, std::regex(pattern)) ? found[1].str() : "";
}

std::string with_joint(const std::string& urdf, const std::string& remedy) {
  return changed_joint(urdf, quoted(remedy, "joint '([^']+)'"), [&](XMLElement* joint) {
    const std::string type = quoted(remedy, "type=\"([^\"]+)\""),
                      axis = quoted(remedy, "<axis xyz=\"([^\"]+)\"/>");
    const std::string parent = quoted(remedy, "<parent link=\"([^\"]+)\"/>");
    const std::string carried = quoted(remedy, "<child link=\"([^\"]+)\"/>");
    if (!parent.empty()) child(joint, "parent")->SetAttribute("link", parent.c_str());
    if (!carried.empty()) child(joint, "child")->SetAttribute("link", carried.c_str());
    for (const std::string key : {"lower", "upper"})
      if (const std::string value = quoted(remedy, key + "=\"([^\"]+)\""); !value.empty())
        child(joint, "limit")->SetAttribute(key.c_str(), value.c_str());
    if (!type.empty()) joint->SetAttribute("type", type.c_str());
    if (!axis.empty()) child(joint, "axis")->SetAttribute("xyz", axis.c_str());
  });
}

std::string with_origin(const std::string& urdf, const std::string& remedy) {
  return changed_joint(urdf, quoted(remedy, "joint '([^']+)'"), [&](XMLElement* joint) {
    for (const std::string key : {"xyz", "rpy"})
      if (const std::string value = quoted(remedy, key + "=\"([^\"]+)\""); !value.empty())
        child(joint, "origin")->SetAttribute(key.c_str(), value.c_str());
  });
}

std::string end_of(const std::string& remedy) { return quoted(remedy, "(operational_point|base_link): "); }

std::vector<std::string> listed(const std::string& text) {
  std::vector<std::string> names;
  const std::regex name("[^, ]+");
  for (std::sregex_iterator at(text.begin(), text.end(), name), end; at != end; ++at)
    names.push_back(at->str());
  return names;
}

}  // namespace

std::vector<FaultyRobot> faulty_robots(const std::string& robot) { return Faults(robot).all(); }

std::vector<FaultyRobot> robots_with_like_faults(const std::string& robot) {
  const Description good = shipped_text(robot);
  XMLDocument document;
  document.Parse(good.urdf.c_str());
  std::map<std::string, std::vector<std::string>> likes;  // by type, axis and name without numbers
  for (XMLElement* joint = document.RootElement()->FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint"))
    if (const XMLElement* axis = joint->FirstChildElement("axis"))
      likes[std::string(joint->Attribute("type")) + axis->Attribute("xyz") +
            std::regex_replace(std::string(joint->Attribute("name")), std::regex("[0-9]"), "#")]
          .emplace_back(joint->Attribute("name"));
  std::vector<FaultyRobot> found;
  const auto add = [&](const std::string& kind, const std::vector<std::string>& joints,
                       const std::function<void(XMLElement*)>& change) {
    FaultyRobot faulty{kind, joints.front(), good};
    for (const std::string& joint : joints) faulty.text.urdf = changed_joint(faulty.text.urdf, joint, change);
    if (joints.size() > 1) found.push_back(faulty);
  };
  for (const auto& [key, joints] : likes) {
    for (const char* axis : {"1 0 0", "0 1 0", "0 0 1"})
      if (key.find(axis) == std::string::npos)
        add("axes", joints, [&](XMLElement* joint) { child(joint, "axis")->SetAttribute("xyz", axis); });
    for (const char* type : {"continuous", "prismatic", "fixed"})
      if (key.find(type) != 0)
        add("types", joints, [&](XMLElement* joint) { joint->SetAttribute("type", type); });
  }
  return found;
}

std::vector<std::string> remedies(const std::string& message) {
  const std::regex remedy(
      "write ((type=\"[^\"]+\")?( and )?(<axis xyz=\"[^\"]+\"/>)? for joint '[^']+'|lower=\"[^\"]+\" "
      "upper=\"[^\"]+\" for joint '[^']+'|<child link=\"[^\"]+\"/> for joint '[^']+'|(xyz|rpy)=\"[^\"]+\" in "
      "the origin of joint '[^']+'|type: \\w+ for closure '[^']+'|<parent link=\"[^\"]+\"/> for joint "
      "'[^']+'|link '[^']+' in the place of '[^']+' in closure '[^']+'|(operational_point|base_link): \\w+( "
      "and actuated_joints: \\[[^\\]]+\\])?|actuated_joints: \\[[^\\]]+\\])|add \\{frames: \\[[^\\]]+\\], "
      "type: \\w+\\} to mechanism.closures|add <link name=\"[^\"]+\"/><joint .*?</joint>");
  std::vector<std::string> found;
  for (std::sregex_iterator at(message.begin(), message.end(), remedy), end; at != end; ++at)
    found.push_back(at->str());
  return found;
}

Description corrected(Description text, const std::string& remedy) {
  const YAML::Node yaml = YAML::Load(text.config);
  if (remedy.find("add <") == 0) {
    text.change_urdf("</robot>", remedy.substr(4) + "</robot>");
  } else if (remedy.find("in the place of") != std::string::npos) {
    YAML::Node frames = closure_named(yaml, quoted(remedy, "closure '([^']+)'"))["frames"];
    const std::string old = quoted(remedy, "place of '([^']+)'");
    for (std::size_t end = 0; end < 2; ++end)
      if (frames[end].as<std::string>() == old) frames[end] = quoted(remedy, "link '([^']+)'");
    text.config = printed(yaml);
  } else if (remedy.find("add {") == 0) {
    YAML::Node closures = yaml["mechanism"]["closures"];
    closures.push_back(YAML::Load(quoted(remedy, "add (\\{.*\\})")));
    text.config = printed(yaml);
  } else if (remedy.find("in the origin") != std::string::npos) {
    text.urdf = with_origin(text.urdf, remedy);
  } else if (remedy.find("closure") != std::string::npos) {
    closure_named(yaml, quoted(remedy, "closure '([^']+)'"))["type"] = quoted(remedy, "type: (\\w+)");
    text.config = printed(yaml);
  } else if (remedy.find("actuated_joints") != std::string::npos || !end_of(remedy).empty()) {
    const std::string end = end_of(remedy), joints = quoted(remedy, "\\[([^\\]]+)\\]");
    if (!end.empty()) set_end(yaml, end, quoted(remedy, end + ": (\\w+)"));
    if (!joints.empty()) set_actuated(yaml, listed(joints));
    text.config = printed(yaml);
  } else {
    text.urdf = with_joint(text.urdf, remedy);
  }
  return text;
}

std::vector<Description> followed(const Description& text, const std::string& message) {
  const std::string alternatives = "; or ";
  std::vector<Description> result;
  for (std::size_t start = 0; start < message.size();) {
    const std::size_t end = std::min(message.find(alternatives, start), message.size());
    const std::vector<std::string> all = remedies(message.substr(start, end - start));
    Description one = text;
    for (const std::string& remedy : all) one = corrected(one, remedy);
    if (!all.empty()) result.push_back(one);
    start = end + alternatives.size();
  }
  return result;
}

}  // namespace parallel_aspects::test
