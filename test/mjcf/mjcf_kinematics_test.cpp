// SPDX-License-Identifier: BSD-3-Clause
// The tree that is read, against the kinematics of MuJoCo itself.
#include "urdf/dialects/closure_dialects.h"
#include "urdf/reading/description_file.h"
#include "urdf/reading/tree_reader.h"

#include <gtest/gtest.h>
#include <tinyxml2.h>
#include <yaml-cpp/yaml.h>

#include "support/loops.h"
#include "support/robots/shipped.h"
#include <array>
#include <memory>
#include <mujoco/mujoco.h>
#include <random>

namespace parallel_aspects {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

const std::string file = std::string(PARALLEL_ASPECTS_SOURCE_DIR) + "/test/data/mjcf/many_joints.xml";

Isometry3d frame(const mjtNum* position, const mjtNum* quaternion) {
  return Eigen::Translation3d(position[0], position[1], position[2]) *
         Eigen::Quaterniond(quaternion[0], quaternion[1], quaternion[2], quaternion[3]);
}

struct Free {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};

// What MuJoCo asks for that kinematics does not, and without <frame>, which this version has not.
class MjcfKinematics : public testing::Test {
 protected:
  void SetUp() override {
    std::string text = test::source_file("test/data/mjcf/many_joints.xml");
    text = test::replaced(text, "<compiler ",
                          "<compiler autolimits=\"true\" boundmass=\"1\" boundinertia=\"1\" ");
    text = test::replaced(text, "<frame ", "<body ");
    text = test::replaced(text, "</frame>", "</body>");
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "robot.xml", static_cast<int>(text.size()));
    std::copy(text.begin(), text.end(), static_cast<char*>(files->filedata[0]));
    std::array<char, 1000> error{};
    model_.reset(mj_loadXML("robot.xml", files.get(), error.data(), static_cast<int>(error.size())));
    mj_deleteVFS(files.get());
    ASSERT_TRUE(model_) << error.data();
    data_.reset(mj_makeData(model_.get()));
    Problems problems;
    Notes notes;
    urdf_ = read_description_file(file, problems).value_or("");
    tree_ = read_tree(urdf_, file, problems, notes).value_or(Tree{});
    ASSERT_EQ(problems, Problems());
  }

  // The same values of all joints for both. A ball turns about x, y and z one after the other.
  Eigen::VectorXd random_values(std::mt19937& random) {
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    Eigen::VectorXd values(tree_.variables());
    for (double& value : values) value = number(random);
    for (int joint = 0; joint < model_->njnt; ++joint) {
      const std::string name = model_->names + model_->name_jntadr[joint];
      mjtNum* q = data_->qpos + model_->jnt_qposadr[joint];
      if (model_->jnt_type[joint] != mjJNT_BALL) {
        q[0] = value(name, values);
        continue;
      }
      const Eigen::Quaterniond turned(Eigen::AngleAxisd(value(name + "_x", values), Vector3d::UnitX()) *
                                      Eigen::AngleAxisd(value(name + "_y", values), Vector3d::UnitY()) *
                                      Eigen::AngleAxisd(value(name + "_z", values), Vector3d::UnitZ()));
      const std::array<double, 4> parts{turned.w(), turned.x(), turned.y(), turned.z()};
      std::copy(parts.begin(), parts.end(), q);
    }
    mj_kinematics(model_.get(), data_.get());
    return values;
  }

  double value(const std::string& joint, const Eigen::VectorXd& values) const {
    const auto found = tree_.joint_named(joint);
    EXPECT_TRUE(found) << joint;
    return found ? values[static_cast<Eigen::Index>(*tree_.joints[*found].variable)] : 0.0;
  }

  Isometry3d pose_in_mujoco(const std::string& body) const {
    const int id = mj_name2id(model_.get(), mjOBJ_BODY, body.c_str());
    return frame(data_->xpos + 3 * id, data_->xquat + 4 * id);
  }

  std::vector<Closure> closures() const {
    tinyxml2::XMLDocument document;
    document.Parse(urdf_.c_str());
    const YAML::Node config(YAML::NodeType::Map);
    const SourceNames files{file, "robot.yaml"};
    Problems problems;
    const auto loops =
        dialects::equality({*document.FirstChildElement("robot"), config, tree_, files}, problems);
    EXPECT_EQ(problems, Problems());
    return loops.closures;
  }

  std::unique_ptr<mjModel, Free> model_;
  std::unique_ptr<mjData, Free> data_;
  std::string urdf_;
  Tree tree_;
};

TEST_F(MjcfKinematics, BodiesMoveAsInMujoco) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 50; ++trial) {
    const Poses poses = link_poses(tree_, 0, random_values(random));
    for (const char* body : {"a", "b", "c", "d", "e", "f"})
      EXPECT_TRUE(poses[*tree_.link_named(body)].isApprox(pose_in_mujoco(body), 1e-9)) << body << trial;
  }
}

TEST_F(MjcfKinematics, LimitsAreInTheValuesOfMujoco) {
  const TreeJoint& slide = tree_.joints[*tree_.joint_named("b_slide")];
  EXPECT_EQ(slide.motion, JointMotion::prismatic);
  EXPECT_EQ(slide.limits.lower, -1.0);
  EXPECT_EQ(slide.limits.upper, 2.0);
  EXPECT_FALSE(tree_.joints[*tree_.joint_named("a_hinge")].limits.limited());
}

// In the configuration of the file each closes, but for the weld whose pose is stated.
TEST_F(MjcfKinematics, ClosuresHoldWhatMujocoHolds) {
  const std::vector<Closure> all = closures();
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].type, ClosureType::point);
  EXPECT_EQ(all[1].type, ClosureType::revolute) << "two anchors of the same bodies";
  EXPECT_EQ(all[2].type, ClosureType::fixed);
  EXPECT_EQ(all[3].type, ClosureType::fixed);
  mj_resetData(model_.get(), data_.get());
  mj_kinematics(model_.get(), data_.get());
  const auto gap = [&](const Closure& closure) {
    std::array<Isometry3d, 2> ends;
    for (std::size_t k = 0; k < 2; ++k)
      ends[k] = pose_in_mujoco(tree_.links[closure.frames[k].link]) * closure.frames[k].in_link;
    return Isometry3d(ends[0].inverse() * ends[1]);
  };
  EXPECT_LT(gap(all[0]).translation().norm(), 1e-12);
  EXPECT_LT(gap(all[1]).translation().norm(), 1e-12);
  EXPECT_LT((gap(all[1]).linear().col(2) - Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_TRUE(gap(all[2]).isApprox(Isometry3d::Identity(), 1e-12));
  // The second body is at `relpose` in the first where the closure holds.
  const Closure& weld = all[3];
  const std::size_t first = tree_.links[weld.frames[0].link] == "d" ? 0 : 1;
  const Isometry3d second_in_first = weld.frames[first].in_link * weld.frames[1 - first].in_link.inverse();
  const mjtNum pose[7]{1.0, 2.0, 3.0, std::sqrt(0.5), std::sqrt(0.5), 0.0, 0.0};
  EXPECT_TRUE(second_in_first.isApprox(frame(pose, pose + 3), 1e-12));
}

}  // namespace
}  // namespace parallel_aspects
