# SPDX-License-Identifier: BSD-3-Clause
"""What the launch files start, read as roslaunch reads them, without a master."""
import pathlib
import unittest

import roslaunch.config

LAUNCH = pathlib.Path(__file__).resolve().parents[2] / "launch"


def load(file, *arguments):
    """What `roslaunch FILE ARGUMENT...` would start."""
    return roslaunch.config.load_config_default([(str(LAUNCH / file), list(arguments))], None)


def nodes(config):
    """The nodes by their types."""
    return {node.type: node for node in config.nodes}


class LaunchFiles(unittest.TestCase):
    """What the files in launch/ start."""

    def test_the_monitor_starts_alone(self):
        self.assertEqual(set(nodes(load("aspects.launch"))), {"aspect_node", "robot_state_publisher"})

    def test_rviz_is_an_argument(self):
        self.assertIn("show_in_rviz", nodes(load("aspects.launch", "rviz:=true")))

    def test_the_demo_opens_rviz(self):
        self.assertEqual(
            set(nodes(load("demo.launch"))), {"aspect_node", "robot_state_publisher", "demo_motion", "show_in_rviz"}
        )

    def test_no_node_ends_the_monitor(self):
        for file in ("aspects.launch", "demo.launch"):
            required = {kind for kind, node in nodes(load(file, "rviz:=true")).items() if node.required}
            self.assertEqual(required, {"aspect_node"})


if __name__ == "__main__":
    unittest.main()
