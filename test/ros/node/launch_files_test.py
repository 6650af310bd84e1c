# SPDX-License-Identifier: BSD-3-Clause
"""What the launch files start, read as roslaunch reads them, without a master."""
import functools
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import roslaunch.config
import roslaunch.core
import roslib.packages
import yaml

ROOT = pathlib.Path(__file__).resolve().parents[3]
LAUNCH = ROOT / "launch"


@functools.lru_cache(maxsize=None)
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

    def test_what_setup_writes_runs_wherever_it_is_moved(self):
        aspects = roslib.packages.find_node("parallel_aspects", "aspects")[0]
        with tempfile.TemporaryDirectory() as first, tempfile.TemporaryDirectory() as folder:
            shutil.copy(ROOT / "urdf/five_bar.urdf", f"{first}/my_robot.urdf")
            subprocess.run([aspects, "setup", "my_robot.urdf", "-o", "my_robot.yaml"], cwd=first, check=True,
                           stdout=subprocess.DEVNULL)
            for file in pathlib.Path(first).iterdir():
                shutil.move(str(file), folder)
            launch = f"{folder}/my_robot.launch"
            monitor = {"aspect_node", "robot_state_publisher", "show_in_rviz"}
            self.assertEqual(set(nodes(load(launch))), monitor)
            config = load(launch, "rviz:=false", "simulated:=true")
            self.assertEqual(set(nodes(config)), monitor - {"show_in_rviz"} | {"demo_motion"})
            written = yaml.safe_load(pathlib.Path(folder, "my_robot.yaml").read_text())
            self.assertEqual(config.params["/aspect_node/start/pose"].value, written["start"]["pose"])
            self.assertEqual(config.params["/robot_description"].value,
                             pathlib.Path(folder, "my_robot.urdf").read_text())

    def test_rviz_is_an_argument(self):
        self.assertIn("show_in_rviz", nodes(load("aspects.launch", "rviz:=true")))

    def test_the_demo_opens_rviz(self):
        self.assertEqual(
            set(nodes(load("demo.launch"))), {"aspect_node", "robot_state_publisher", "demo_motion", "show_in_rviz"}
        )

    def test_no_node_ends_the_monitor(self):
        for file, expected in (("aspects.launch", set()), ("demo.launch", {"aspect_node"})):
            required = {kind for kind, node in nodes(load(file, "rviz:=true")).items() if node.required}
            self.assertEqual(required, expected)

    def test_the_monitor_may_come_back(self):
        for given, expected in (([], False), (["respawn:=true"], True)):
            self.assertEqual(nodes(load("aspects.launch", *given))["aspect_node"].respawn, expected)

    def test_the_monitor_may_be_a_nodelet(self):
        alone = load("aspects.launch").params
        for given, expected in ((["manager:=/cell/manager"], "load parallel_aspects/AspectNodelet /cell/manager"),
                                ([], "standalone parallel_aspects/AspectNodelet")):
            config = load("aspects.launch", "nodelet:=true", *given)
            node = nodes(config)["nodelet"]
            self.assertEqual((node.package, node.name, node.args.strip()), ("nodelet", "aspect_node", expected))
            self.assertEqual({key: param.value for key, param in config.params.items()},
                             {key: param.value for key, param in alone.items()})

    def test_read_only_is_an_argument(self):
        for given, expected in (([], False), (["read_only:=true"], True)):
            self.assertEqual(load("aspects.launch", *given).params["/aspect_node/read_only"].value, expected)

    def test_what_two_robots_differ_in_are_arguments(self):
        thresholds = {"parallel_warn": 0.2, "parallel_stop": 0.1, "serial_warn": 0.04, "serial_stop": 0.03,
                      "limit_warn": 0.02, "limit_stop": 0.01}
        given = [f"{name}:={value}" for name, value in thresholds.items()]
        config = load("aspects.launch", "frame_prefix:=left", "map_file:=/tmp/left.map", *given)
        self.assertEqual(config.params["/aspect_node/frame_prefix"].value, "left")
        self.assertEqual(config.params["/robot_state_publisher/tf_prefix"].value, "left", "of the links too")
        self.assertEqual(config.params["/aspect_node/map/file"].value, "/tmp/left.map")
        for name, value in thresholds.items():
            self.assertEqual(config.params["/aspect_node/thresholds/" + name].value, value)

    def test_what_is_not_given_stays_as_the_files_say(self):
        params = load("aspects.launch").params
        self.assertEqual(params["/aspect_node/thresholds/parallel_stop"].value, 0.0)
        self.assertEqual(params["/aspect_node/map/file"].value, "")

    def test_what_makes_no_sense_is_left_to_the_node_which_refuses_it_by_name(self):
        for given, expected in (("-1", -1.0), ("1e-3", 1e-3), ("inf", float("inf")), ("-0.6", -0.6)):
            for argument, key in (("resolution", "map/resolution"), ("parallel_stop", "thresholds/parallel_stop")):
                params = load("aspects.launch", f"{argument}:={given}").params
                self.assertEqual(params["/aspect_node/" + key].value, expected)
        for argument in ("resolution", "parallel_stop"):
            with self.assertRaisesRegex(roslaunch.core.RLException, f"(?s)could not convert string to float.*{argument}"):
                load("aspects.launch", f"{argument}:=abc")

    def test_no_parameter_of_an_earlier_launch_counts(self):
        for file in ("aspects.launch", "demo.launch"):
            config = load(file, "rviz:=true")
            self.assertEqual({node.name for node in config.nodes},
                             {name.strip("/") for name in config.clear_params})


if __name__ == "__main__":
    unittest.main()
