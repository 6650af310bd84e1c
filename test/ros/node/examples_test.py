#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs every example of docs/reference/examples.md against a node of the five-bar, and compares what it prints.

Commands run in this process, as `rosservice` and `rostopic` do in theirs, so that no time goes into starting them.
"""
import contextlib
import io
import pathlib
import re
import shlex
import unittest

import rospy
import rosservice
import rostopic
import rostest
from parallel_aspects.msg import AspectState, MapProgress, Status
from sensor_msgs.msg import JointState

ROOT = pathlib.Path(__file__).resolve().parents[3]
START = (1.633334, 1.027907)
BEYOND = (0.85, 1.172)  # leg 1 is stretched on the path there, and det A does not vanish
DEADLINE = 60.0  # [s]
TOOLS = {"rosservice": rosservice.rosservicemain, "rostopic": rostopic.rostopicmain}


def examples():
    """Blocks of code by heading: {heading: [(language, text)]}."""
    found = {}
    text = (ROOT / "docs" / "reference" / "examples.md").read_text(encoding="utf-8")
    for section in re.split(r"^## ", text, flags=re.MULTILINE)[1:]:
        heading, body = section.split("\n", 1)
        found[heading] = re.findall(r"```(bash|python)\n(.*?)```", body, re.DOTALL)
    return found


class Robot:
    """Publishes the actuated joints, at rest or going to and fro through a serial singularity."""

    def __init__(self):
        self.moving = False
        self.share = 0.0
        self.publisher = rospy.Publisher("/joint_states", JointState, queue_size=100)
        self.timer = None

    def begin(self):
        """From now on."""
        self.timer = rospy.Timer(rospy.Duration(0.01), self.publish)

    def publish(self, _event):
        """One sample."""
        self.share = (self.share + (0.005 if self.moving or self.share > 0.0 else 0.0)) % 2.0
        reach = 1.0 - abs(self.share - 1.0)
        reach = 0.0 if reach < 1e-9 else reach
        joints = JointState(name=["crank_1_joint", "crank_2_joint"])
        joints.position = [a + reach * (b - a) for a, b in zip(START, BEYOND)]
        joints.header.stamp = rospy.Time.now()
        self.publisher.publish(joints)


def eventually(condition):
    """Whether it becomes true before the deadline."""
    end = rospy.get_time() + DEADLINE
    while rospy.get_time() < end:
        if condition():
            return True
        rospy.sleep(0.01)
    return False


class Examples(unittest.TestCase):
    """All examples, in an order in which each has what it needs."""

    def setUp(self):
        self.examples = examples()
        self.state = AspectState()
        self.progress = MapProgress()
        self.subscribers = [
            rospy.Subscriber("/aspect_node/state", AspectState, lambda state: setattr(self, "state", state)),
            rospy.Subscriber("/aspect_node/map_progress", MapProgress, lambda each: setattr(self, "progress", each)),
        ]
        self.robot = Robot()
        self.failures = []  # rostest counts those of subtests, but does not name them

    def run_example(self, heading):
        """Every block of a section."""
        for language, text in self.examples.pop(heading):
            try:
                (self.run_commands if language == "bash" else self.run_program)(text)
            except (AssertionError, rospy.ROSException, SystemExit) as failure:
                self.failures.append(f"{heading} in {language}: {failure}")

    @staticmethod
    def output_of(run, *arguments):
        """What it prints, in whichever thread."""
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            run(*arguments)
        return printed.getvalue()

    def run_commands(self, text):
        """Each command prints what the comment after it says."""
        for command, expected in re.findall(r"^([^#\n].*)\n(?:# (.*)\n)?", text, re.MULTILINE):
            words = shlex.split(command)
            printed = self.output_of(TOOLS[words[0]], words)
            self.assertIn(expected, printed, command)

    def run_program(self, text):
        """It prints what its comments say, and a program of ten lines is not much longer."""
        self.assertLessEqual(len(text.splitlines()), 13)
        expected = [part for line in re.findall(r"print\(.*?\)  # (.*)", text) for part in line.split("  # ")]
        printed = self.output_of(exec, compile(text, "docs/reference/examples.md", "exec"), {"__name__": "__main__"})
        self.assertEqual(printed.splitlines(), expected, text)

    def test_all(self):
        """In an order in which each has what it needs."""
        self.run_example("`joint_states`, what the node hears")
        self.assertTrue(eventually(lambda: self.state.status.code != Status.NO_JOINT_STATES))
        self.robot.begin()
        self.run_example("`~candidates`")
        self.assertTrue(eventually(lambda: self.progress.state == MapProgress.COMPLETE))
        self.run_example("`~set_assembly_mode`")
        self.assertTrue(eventually(lambda: self.state.status.code == Status.OK and self.state.level != AspectState.UNKNOWN))
        moving, last = ["`~transitions`", "`~last_transition`"], ["`~compute_map`, an action", "`~reload`"]
        for heading in [each for each in self.examples if each not in moving + last]:
            self.run_example(heading)
        self.robot.moving = True
        for heading in moving + last:
            self.run_example(heading)
        self.assertEqual(list(self.examples), [], "not run")
        self.assertFalse(self.failures, "\n".join(self.failures))

    def test_every_service_has_an_example(self):
        """Every file of srv/."""
        for file in (ROOT / "srv").glob("*.srv"):
            name = re.sub(r"(?<!^)(?=[A-Z])", "_", file.stem).lower()
            self.assertIn(f"`~{name}`", self.examples)


if __name__ == "__main__":
    rospy.init_node("examples_test")
    rospy.init_node = lambda *_arguments, **_options: None
    rostest.rosrun("parallel_aspects", "examples_test", Examples)
