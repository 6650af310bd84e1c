#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Drags the probe in rviz with a scripted mouse, on a screen in memory, and looks at what is published and drawn.

PROBE_PICTURE names a file that the picture is kept in.
"""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import rospy
import rostest
from parallel_aspects.msg import MapProgress, ProbeState, Status

ROOT = pathlib.Path(__file__).resolve().parents[3]
HANDLE = (0xE0, 0x7B, 0x00)  # as in src/ros/probe/handle_marker.cpp, in any light
WIDTH, HEIGHT = 1280, 800
ROBOT_WIDTH = 470  # left of the gallery
PROGRAMS = ("Xvfb", "rviz", "xdotool", "import", "convert")


def until(seconds, condition):
    """The first true value of the condition, before the time is up."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        found = condition()
        if found:
            return found
        time.sleep(0.05)
    return condition()


def is_handle(red, green, blue):
    """Whether a pixel has the hue of the handle."""
    return red > 100 and abs(green / red - HANDLE[1] / HANDLE[0]) < 0.08 and blue < 0.25 * red


class Screen:
    """A screen in memory with rviz on it."""

    def __init__(self, folder):
        self.picture = folder / "screen.png"
        ready, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{WIDTH}x{HEIGHT}x24", "-nolisten", "tcp"],
            pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(ready) as pipe:
            number = pipe.readline().strip()
        self.environment = dict(os.environ, DISPLAY=":" + number, LIBGL_ALWAYS_SOFTWARE="1", QT_X11_NO_MITSHM="1")
        self.environment.pop("WAYLAND_DISPLAY", None)
        self.rviz = subprocess.Popen(["rviz", "-d", str(ROOT / "rviz" / "aspects.rviz")], env=self.environment,
                                     stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def close(self):
        for child in (self.rviz, self.server):
            child.send_signal(signal.SIGTERM)
            try:
                child.wait(10)
            except subprocess.TimeoutExpired:
                child.kill()
                child.wait()

    def mouse(self, *arguments):
        subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, check=True)

    def pixels(self):
        """Bytes of red, green and blue, row by row."""
        subprocess.run(["import", "-window", "root", str(self.picture)], env=self.environment, check=True)
        return subprocess.run(["convert", str(self.picture), "-depth", "8", "rgb:-"], check=True,
                              stdout=subprocess.PIPE).stdout

    def handle(self):
        """Where the ball of the handle is, by its colour; None where it is not drawn."""
        raw = self.pixels()
        found = [i for i in range(len(raw) // 3) if i % WIDTH < ROBOT_WIDTH and is_handle(*raw[3 * i:3 * i + 3])]
        if len(found) < 40:
            return None
        return sorted(i % WIDTH for i in found)[len(found) // 2], sorted(i // WIDTH for i in found)[len(found) // 2]

    def drag(self, start, end, steps=25):
        """As a hand does, a little at a time."""
        self.mouse("mousemove", *start)
        time.sleep(0.5)
        self.mouse("mousedown", 1)
        for step in range(1, steps + 1):
            self.mouse("mousemove", *(round(a + (b - a) * step / steps) for a, b in zip(start, end)))
            time.sleep(0.03)
        time.sleep(0.3)
        self.mouse("mouseup", 1)


@unittest.skipUnless(all(shutil.which(each) for each in PROGRAMS), "needs " + ", ".join(PROGRAMS))
class ProbeDrag(unittest.TestCase):
    """The five-bar, seen from above."""

    @classmethod
    def setUpClass(cls):
        rospy.init_node("probe_drag_test")
        cls.states, cls.progress = [], []
        rospy.Subscriber("/aspect_node/probe/state", ProbeState, cls.states.append)
        rospy.Subscriber("/aspect_node/map_progress", MapProgress, cls.progress.append)
        cls.folder = tempfile.TemporaryDirectory()
        cls.screen = Screen(pathlib.Path(cls.folder.name))

    @classmethod
    def tearDownClass(cls):
        cls.screen.close()
        cls.folder.cleanup()

    def test_the_ball_is_dragged_and_the_robot_follows(self):
        self.assertTrue(until(120, lambda: self.progress and self.progress[-1].state == MapProgress.COMPLETE))
        start = until(60, self.screen.handle)
        self.assertIsNotNone(start, "the handle is not drawn")
        self.assertEqual(self.states, [], "nothing is worked out before it is moved")
        end = (start[0] - 40, start[1] + 30)  # to the left and down
        self.screen.drag(start, end)
        self.assertTrue(until(20, lambda: len(self.states) > 3))
        first, last = self.states[0], until(5, lambda: self.states[-1])
        self.assertLess(last.wanted.position.x, first.wanted.position.x)
        self.assertLess(last.wanted.position.y, first.wanted.position.y)
        self.assertEqual(last.status.code, Status.OK, last.status.message)
        self.assertGreater(last.report.configuration.aspect, 0)

        out = (60, 180)  # out of reach, to the left above
        ball = until(10, self.screen.handle)
        self.screen.drag(ball, out)
        self.assertTrue(until(10, lambda: self.states[-1].status.code == Status.NO_SOLUTION), self.states[-1].status)
        self.assertGreater(self.states[-1].off, 0.0)
        self.assertTrue(until(10, lambda: (self.screen.handle() or out)[0] > out[0] + 40), "the handle goes back")
        time.sleep(1.0)
        self.screen.pixels()
        if "PROBE_PICTURE" in os.environ:
            shutil.copy(self.screen.picture, os.environ["PROBE_PICTURE"])


if __name__ == "__main__":
    rostest.rosrun("parallel_aspects", "probe_drag_test", ProbeDrag, sys.argv)
