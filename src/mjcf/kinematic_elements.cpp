// SPDX-License-Identifier: BSD-3-Clause
#include "mjcf/kinematic_elements.h"

#include <tinyxml2.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

namespace parallel_aspects::mjcf {
namespace {

namespace fs = std::filesystem;
using tinyxml2::XMLDocument;
using tinyxml2::XMLElement;

using Names = std::set<std::string>;

constexpr int max_includes = 100;  // one inside the other, or one after the other

// Of mass and inertia of bodies that have neither a shape nor an inertia any more, which MuJoCo asks for.
constexpr const char* any_mass = "1";

std::string attribute(const XMLElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value != nullptr ? value : "";
}

std::string element_text(const XMLElement& element) {
  const std::string name = attribute(element, "name");
  return "<" + std::string(element.Name()) + ">" + (name.empty() ? "" : " '" + name + "'");
}

// Attributes that are kept of each element.
const Names& kept_attributes(const std::string& element) {
  static const Names pose{"name",      "class",  "childclass", "pos",  "quat",
                          "axisangle", "xyaxes", "zaxis",      "euler"};
  static const std::map<std::string, Names> kept{
      {"mujoco", {"model"}},
      {"compiler", {"angle", "eulerseq", "coordinate", "autolimits"}},
      {"default", {"class"}},
      {"body", pose},
      {"frame", pose},
      {"joint", {"name", "class", "type", "pos", "axis", "limited", "range", "ref"}},
      {"freejoint", {"name"}},
      {"site",
       {"name", "class", "pos", "quat", "axisangle", "xyaxes", "zaxis", "euler", "type", "size", "fromto"}},
      {"equality", {"class", "active"}},  // in defaults
      {"connect", {"name", "class", "active", "body1", "body2", "anchor"}},
      {"weld", {"name", "class", "active", "body1", "body2", "relpose"}},
  };
  static const Names none;
  const auto found = kept.find(element);
  return found != kept.end() ? found->second : none;
}

class Collector {
 public:
  Collector(const std::string& file, Problems& problems) : file_(file), problems_(problems) {}

  KinematicElements collect() {
    XMLElement* root = result_document_.NewElement("mujoco");
    result_document_.InsertEndChild(root);
    root->SetAttribute("model", fs::path(file_).stem().string().c_str());
    lines_.push_back({file_, 1});
    add_compiler(*root);
    read_file(file_, [&](const XMLElement& mujoco) {
      if (!attribute(mujoco, "model").empty())
        root->SetAttribute("model", attribute(mujoco, "model").c_str());
      lines_.front().line = mujoco.GetLineNum();
      read_sections(mujoco, *root);
    });
    tinyxml2::XMLPrinter printer;
    result_document_.Print(&printer);
    result_.text = printer.CStr();
    result_.lines = lines_;
    return result_;
  }

 private:
  void problem(const XMLElement& element, const std::string& text) {
    problems_.push_back(present_file_ + " has " + element_text(element) + " in line " +
                        std::to_string(element.GetLineNum()) + ", " + text);
  }

  // `use` gets the root of the file.
  template <class Use>
  void read_file(const std::string& file, const Use& use) {
    XMLDocument document;
    const auto error = document.LoadFile(file.c_str());
    if (error != tinyxml2::XML_SUCCESS) {
      const bool is_missing = error == tinyxml2::XML_ERROR_FILE_NOT_FOUND ||
                              error == tinyxml2::XML_ERROR_FILE_COULD_NOT_BE_OPENED;
      problems_.push_back(
          is_missing ? present_file_ + " includes '" + file + "', which cannot be read; put that file there."
                     : file + " is not well-formed XML near line " + std::to_string(document.ErrorLineNum()) +
                           " (" + XMLDocument::ErrorIDToName(error) + "); correct it there.");
      return;
    }
    const std::string before = std::exchange(present_file_, file);
    if (document.RootElement() != nullptr) use(*document.RootElement());
    present_file_ = before;
  }

  // Each child, those of included files in the place of the <include>.
  template <class Use>
  void for_each_child(const XMLElement& parent, const Use& use) {
    for (const auto* child = parent.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      if (std::string(child->Name()) != "include") {
        use(*child);
      } else if (++includes_ > max_includes) {
        problem(*child, "which is one of more than " + std::to_string(max_includes) +
                            "; leave out files that include themselves.");
        return;
      } else {
        read_file(included_file(*child), [&](const XMLElement& root) { for_each_child(root, use); });
      }
    }
  }

  // Beside the file that names it, or beside the first one.
  std::string included_file(const XMLElement& include) const {
    const fs::path name = attribute(include, "file");
    const fs::path beside = fs::path(present_file_).parent_path() / name;
    std::error_code error;
    return (fs::exists(beside, error) ? beside : fs::path(file_).parent_path() / name).string();
  }

  XMLElement* add(XMLElement& parent, const XMLElement& source, const char* name) {
    XMLElement* added = parent.InsertNewChildElement(name);
    lines_.push_back({present_file_, source.GetLineNum()});
    const Names& kept = kept_attributes(name);
    for (const auto* a = source.FirstAttribute(); a != nullptr; a = a->Next())
      if (kept.count(a->Name()) > 0) added->SetAttribute(a->Name(), a->Value());
    return added;
  }

  // Limits count where they are written, as with all later versions of MuJoCo.
  void add_compiler(XMLElement& root) {
    XMLElement* compiler = root.InsertNewChildElement("compiler");
    lines_.push_back({file_, 1});
    compiler->SetAttribute("autolimits", "true");
    compiler->SetAttribute("boundmass", any_mass);
    compiler->SetAttribute("boundinertia", any_mass);
  }

  void read_sections(const XMLElement& mujoco, XMLElement& root) {
    for_each_child(mujoco, [&](const XMLElement& section) {
      const std::string name = section.Name();
      if (name == "compiler") add(root, section, "compiler");
      if (name == "default") read_defaults(section, root);
      if (name == "worldbody") read_body(section, *add(root, section, "worldbody"));
      if (name == "equality") read_equalities(section, *add(root, section, "equality"));
      if (name == "actuator") read_actuators(section);
      if (name == "tendon") result_.notes.push_back("has <tendon>, which is not used.");
    });
  }

  void read_defaults(const XMLElement& source, XMLElement& parent) {
    XMLElement& added = *add(parent, source, "default");
    for_each_child(source, [&](const XMLElement& child) {
      const std::string name = child.Name();
      if (name == "default") read_defaults(child, added);
      if (name == "joint" || name == "site" || name == "equality") add(added, child, child.Name());
    });
  }

  void read_body(const XMLElement& source, XMLElement& added) {
    for_each_child(source, [&](const XMLElement& child) {
      const std::string name = child.Name();
      const bool is_frame = std::string(source.Name()) == "frame";
      if (name == "body") read_body(child, *add(added, child, "body"));
      // A frame holds what is in it as a body without joints does.
      if (name == "frame") read_body(child, *add(added, child, "body"));
      if (name == "joint" || name == "freejoint") {
        if (is_frame)
          problem(child, "which stands in a <frame>; put it into a <body>.");
        else
          add(added, child, child.Name());
      }
      if (name == "site" && child.Attribute("name") != nullptr) add(added, child, "site");
      if (name == "replicate" || name == "attach")
        problem(child,
                "which is not read; let MuJoCo write the file anew with what that stands for "
                "(mj_saveLastXML), and give that.");
      if (name == "composite" || name == "flexcomp")
        result_.notes.push_back("has " + element_text(child) + ", which is not used.");
    });
  }

  void read_equalities(const XMLElement& source, XMLElement& added) {
    for_each_child(source, [&](const XMLElement& child) {
      const std::string name = child.Name();
      if (attribute(child, "active") == "false") {
        result_.notes.push_back("has " + element_text(child) + ", which is not active and not used.");
      } else if (name != "connect" && name != "weld" && name != "joint") {
        problem(child, "which is no <connect>, <weld> or <joint>; leave it out, or set active=\"false\".");
      } else if (name == "joint") {
        read_joint_equality(child);
      } else if (child.Attribute("site1") != nullptr || child.Attribute("site2") != nullptr) {
        result_.site_equalities.push_back({attribute(child, "name"),
                                           element_text(child),
                                           {attribute(child, "site1"), attribute(child, "site2")},
                                           name == "weld"});
      } else {
        result_.equalities.push_back(element_text(child));
        add(added, child, child.Name());
      }
    });
  }

  // One joint as a function of another is what a URDF calls mimic.
  void read_joint_equality(const XMLElement& equality) {
    if (attribute(equality, "joint2").empty())
      problem(equality, "which holds a joint where it is; leave out that joint.");
    else
      result_.followers.push_back(attribute(equality, "joint1"));
  }

  void read_actuators(const XMLElement& source) {
    for_each_child(source, [&](const XMLElement& child) {
      std::string joint = attribute(child, "joint");
      if (joint.empty()) joint = attribute(child, "jointinparent");
      if (joint.empty())
        result_.notes.push_back("has " + element_text(child) + " that drives no joint, which is not used.");
      else
        result_.actuators.push_back({element_text(child), joint});
    });
  }

  const std::string& file_;
  Problems& problems_;
  std::string present_file_ = file_;
  int includes_ = 0;
  XMLDocument result_document_;
  std::vector<SourceLine> lines_;
  KinematicElements result_;
};

}  // namespace

KinematicElements kinematic_elements(const std::string& file, Problems& problems) {
  return Collector(file, problems).collect();
}

}  // namespace parallel_aspects::mjcf
