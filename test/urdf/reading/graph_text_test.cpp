// SPDX-License-Identifier: BSD-3-Clause
// Joints of a graph, whichever way round they are in the tree, against what they hold together.
#include "urdf/dialects/closure_dialects.h"
#include "urdf/reading/robot_graph.h"
#include "urdf/reading/tree_reader.h"

#include <gtest/gtest.h>

#include "support/texts.h"
#include <cmath>
#include <random>

namespace parallel_aspects {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

class Random {
 public:
  double number() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
  Vector3d vector() { return {number(), number(), number()}; }
  Vector3d direction() { return vector().normalized(); }
  Isometry3d frame() {
    return Eigen::Translation3d(vector()) * Eigen::AngleAxisd(3.0 * number(), direction());
  }

 private:
  std::mt19937 random_{7};
};

// A base that turns on the world, so that it is the base whichever body is the parent.
RobotGraph graph_of(const GraphJoint& joint) {
  RobotGraph graph;
  graph.name = "robot";
  graph.bodies = {"world", "one", "other"};
  GraphJoint held;
  held.name = "held";
  held.bodies = {0, 1};
  graph.joints = {held, joint};
  return graph;
}

Tree tree_of(RobotGraph graph) {
  Problems problems;
  Notes notes;
  const auto tree = read_tree(urdf_text(graph, "robot.sdf"), "robot.sdf", problems, notes);
  EXPECT_EQ(problems, Problems());
  EXPECT_EQ(graph.problems, Problems());
  return tree.value_or(Tree{});
}

// The motion of the joint: the frame in the child, in that in the parent.
Isometry3d motion_of(const GraphJoint& joint, const Eigen::VectorXd& values) {
  const Tree tree = tree_of(graph_of(joint));
  const Poses poses = link_poses(tree, 0, values);
  const std::string names[3]{"world", "one", "other"};
  const auto pose = [&](std::size_t end) {
    return poses[*tree.link_named(names[joint.bodies[end]])] * joint.frames[end];
  };
  return pose(0).inverse() * pose(1);
}

GraphJoint random_joint(GraphJointKind kind, bool reversed, Random& random) {
  GraphJoint joint;
  joint.name = "joint";
  joint.kind = kind;
  joint.bodies = {reversed ? 2U : 1U, reversed ? 1U : 2U};
  joint.frames = {random.frame(), random.frame()};
  joint.axes = {random.direction(), random.direction()};
  return joint;
}

TEST(GraphText, JointsMoveAsTheGraphSays) {
  Random random;
  for (int trial = 0; trial < 20; ++trial)
    for (const bool reversed : {false, true}) {
      SCOPED_TRACE(std::to_string(trial) + (reversed ? " reversed" : ""));
      const double one = random.number(), two = random.number();
      GraphJoint joint = random_joint(GraphJointKind::revolute, reversed, random);
      const auto turn = [&](double angle, std::size_t axis) {
        return Isometry3d(Eigen::AngleAxisd(angle, joint.axes[axis]));
      };
      EXPECT_TRUE(motion_of(joint, Eigen::VectorXd::Constant(1, one)).isApprox(turn(one, 0), 1e-12));
      joint.kind = GraphJointKind::prismatic;
      EXPECT_TRUE(motion_of(joint, Eigen::VectorXd::Constant(1, one))
                      .isApprox(Isometry3d(Eigen::Translation3d(one * joint.axes[0])), 1e-12));
      joint.kind = GraphJointKind::universal;
      Eigen::VectorXd values(2);
      values << (reversed ? two : one), (reversed ? one : two);
      EXPECT_TRUE(motion_of(joint, values).isApprox(turn(one, 0) * turn(two, 1), 1e-12));
      joint.kind = GraphJointKind::fixed;
      EXPECT_TRUE(motion_of(joint, Eigen::VectorXd()).isApprox(Isometry3d::Identity(), 1e-12));
    }
}

TEST(GraphText, BallsKeepTheirCentreAndCoincideAtZero) {
  Random random;
  for (int trial = 0; trial < 20; ++trial) {
    const GraphJoint joint = random_joint(GraphJointKind::ball, trial % 2 == 0, random);
    EXPECT_TRUE(motion_of(joint, Eigen::VectorXd::Zero(3)).isApprox(Isometry3d::Identity(), 1e-12));
    EXPECT_LT(motion_of(joint, random.vector()).translation().norm(), 1e-12) << trial;
  }
}

// A right pitch is where roll and yaw are one.
TEST(GraphText, FramesAreKeptAtARightPitch) {
  Random random;
  for (int trial = 0; trial < 20; ++trial) {
    GraphJoint joint = random_joint(GraphJointKind::fixed, false, random);
    joint.frames[0].linear() = (Eigen::AngleAxisd(random.number(), Vector3d::UnitZ()) *
                                Eigen::AngleAxisd((trial % 2 == 0 ? 0.5 : -0.5) * M_PI, Vector3d::UnitY()) *
                                Eigen::AngleAxisd(random.number(), Vector3d::UnitX()))
                                   .toRotationMatrix();
    joint.frames[1].setIdentity();
    EXPECT_TRUE(motion_of(joint, Eigen::VectorXd()).isApprox(Isometry3d::Identity(), 1e-12)) << trial;
  }
}

// The closure that a second joint of the same two bodies becomes, after a ball in the tree.
Closure closure_of(const GraphJoint& joint, Random& random) {
  GraphJoint ball = random_joint(GraphJointKind::ball, false, random);
  ball.name = "ball";
  RobotGraph graph = graph_of(ball);
  graph.closures_described_by = "the SDF";
  graph.joints.push_back(joint);
  const std::string text = urdf_text(graph, "robot.sdf");
  tinyxml2::XMLDocument document;
  document.Parse(text.c_str());
  const Tree tree = tree_of(graph);
  const YAML::Node config(YAML::NodeType::Map);
  const SourceNames files{"robot.sdf", "robot.yaml"};
  Problems problems;
  const auto loops =
      dialects::sdf_joint({*document.FirstChildElement("robot"), config, tree, files}, problems);
  EXPECT_EQ(problems, Problems());
  EXPECT_EQ(loops.closures.size(), 1U);
  return loops.closures.empty() ? Closure{} : loops.closures.front();
}

TEST(GraphText, ClosuresHoldWhatTheirJointsHold) {
  Random random;
  for (int trial = 0; trial < 20; ++trial)
    for (const GraphJointKind kind : {GraphJointKind::revolute, GraphJointKind::universal}) {
      GraphJoint joint = random_joint(kind, trial % 2 == 0, random);
      joint.axes[1] = joint.axes[0].cross(random.direction()).normalized();
      const Closure closure = closure_of(joint, random);
      const Eigen::AngleAxisd first(random.number(), joint.axes[0]), second(random.number(), joint.axes[1]);
      const Isometry3d motion(kind == GraphJointKind::universal ? Isometry3d(first * second)
                                                                : Isometry3d(first));
      const Isometry3d child_in_parent = joint.frames[0] * motion * joint.frames[1].inverse();
      const Isometry3d one = closure.frames[0].in_link, other = child_in_parent * closure.frames[1].in_link;
      EXPECT_LT((one.translation() - other.translation()).norm(), 1e-12);
      if (kind == GraphJointKind::universal) {
        EXPECT_EQ(closure.type, ClosureType::universal);
        EXPECT_NEAR(one.linear().col(2).dot(other.linear().col(0)), 0.0, 1e-12) << trial;
      } else {
        EXPECT_EQ(closure.type, ClosureType::revolute);
        EXPECT_TRUE(one.linear().col(2).isApprox(other.linear().col(2), 1e-12)) << trial;
      }
    }
}

TEST(GraphText, SlidesAreInTheTree) {
  Random random;
  RobotGraph graph = graph_of(random_joint(GraphJointKind::ball, false, random));
  GraphJoint slide = random_joint(GraphJointKind::prismatic, false, random);
  slide.name = "slide";
  graph.joints.push_back(slide);
  const Tree tree = tree_of(graph);
  ASSERT_EQ(tree.variables(), 1);
  EXPECT_EQ(tree.joint_of(0).name, "slide");
}

TEST(GraphText, RefusesLoopsOfSlidesAndOfActuatedJoints) {
  Random random;
  for (const GraphJointKind kind : {GraphJointKind::prismatic, GraphJointKind::revolute}) {
    GraphJoint joint = random_joint(kind, false, random);
    joint.is_actuated = true;
    RobotGraph graph = graph_of(joint);
    joint.name = joint.element = "second";
    graph.joints.push_back(joint);
    urdf_text(graph, "robot.sdf");
    ASSERT_EQ(graph.problems.size(), 1U);
    EXPECT_TRUE(test::has(graph.problems.front(), "second"));
  }
}

TEST(GraphText, BodiesThatNothingHoldsAreLeftOutWithANote) {
  RobotGraph graph = graph_of(GraphJoint{});
  graph.joints[1].name = "turns";
  graph.joints[1].bodies = {1, 2};
  graph.joints[1].kind = GraphJointKind::revolute;
  graph.bodies.push_back("cup");
  urdf_text(graph, "robot.xml");
  EXPECT_EQ(graph.notes, std::vector<std::string>{
                             "has bodies that nothing connects to the base, which are left out: 'cup'."});
}

}  // namespace
}  // namespace parallel_aspects
