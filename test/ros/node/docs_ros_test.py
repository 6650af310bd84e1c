#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the commands of the pages of the docs that start nodes, and compares; see test/support/console.py."""
import pathlib
import sys
import unittest

import roslib.packages
import rostest

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "test" / "support"))
import console  # pylint: disable=wrong-import-position


class DocsWithRos(unittest.TestCase):
    """One page after the other, all with the master of this test."""

    def test_pages(self):
        aspects = pathlib.Path(roslib.packages.find_node("parallel_aspects", "aspects")[0])
        problems = []
        for name in ("start/tutorial.md", "howto/stack.md"):
            problems += console.Page(ROOT / "docs" / name, aspects.parent, ros=True).problems()
        self.assertTrue(problems == [], "\n\n".join(problems))


if __name__ == "__main__":
    rostest.rosrun("parallel_aspects", "docs_ros_test", DocsWithRos)
