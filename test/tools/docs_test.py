#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the commands of the docs that need no ROS, and compares: docs_test.py ASPECTS FIRST_MAP RESULTS_XML"""
import pathlib
import re
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "test" / "support"))
import console  # pylint: disable=wrong-import-position

PAGES = [ROOT / "README.md"] + sorted((ROOT / "docs").rglob("*.md"))
LANGUAGES = {"console", "sh", "bash", "python", "cpp", "cmake", "xml", "yaml", "json", "text", ""}
PROGRAMS = {}


class Docs(unittest.TestCase):
    def test_commands_print_what_the_pages_say(self):
        for page in PAGES:
            with self.subTest(page=page.name):
                problems = console.Page(page, PROGRAMS["aspects"].parent, ros=False).problems()
                self.assertTrue(problems == [], "\n\n".join(problems))

    def test_commands_are_in_console_blocks(self):
        for page in PAGES:
            for language, text, _ in console.fenced_blocks(page.read_text(encoding="utf-8")):
                self.assertIn(language, LANGUAGES, page.name)
                self.assertTrue(language == "console" or not text.startswith("$ "), f"{page.name}: {text}")
                self.assertTrue(language != "console" or console.commands(text), f"{page.name}: {text}")

    def test_the_readme_has_the_first_example(self):
        readme = (ROOT / "README.md").read_text(encoding="utf-8")
        programs = [text for language, text, _ in console.fenced_blocks(readme) if language == "cpp"]
        example = (ROOT / "example" / "first_map.cpp").read_text(encoding="utf-8")
        self.assertEqual(programs, [example.split("\n", 1)[1]])
        self.assertLessEqual(len(programs[0].splitlines()), 20)
        printed = subprocess.run([PROGRAMS["first_map"]], check=True, capture_output=True, text=True).stdout
        self.assertEqual(len(printed.splitlines()), 11)
        self.assertIn("(4.5, 8) is in aspect 8\n", printed)

    def test_the_readme_is_short(self):
        self.assertLessEqual(len((ROOT / "README.md").read_text(encoding="utf-8").splitlines()), 130)


class Architecture(unittest.TestCase):
    """The page that says what is where."""

    PAGE = (ROOT / "docs" / "development" / "architecture.md").read_text(encoding="utf-8")

    def test_every_room_has_its_row(self):
        named, layer = [], ""
        for first, second in re.findall(r"^\| (`\w+/`)? ?\| (`\w+/`|\(itself\))? ?\| ", self.PAGE, re.MULTILINE):
            layer = first or layer
            named.append((layer + (second if second != "(itself)" else "")).replace("`", "").rstrip("/"))
        folders = {each.parent.relative_to(ROOT / "src") for each in (ROOT / "src").rglob("*.cpp")}
        self.assertEqual(sorted(named), sorted(map(str, folders)))

    def test_every_file_that_is_named_is_there(self):
        places = [ROOT / each for each in ("", "src", "include/parallel_aspects", "test/support")]
        for name in re.findall(r"`([\w/]+\.(?:h|cpp|cmake|txt|yaml|rviz))`", self.PAGE):
            if "NAME" in name:
                continue
            found = any((place / name).is_file() for place in places)
            found = found or "/" not in name and any((ROOT / "src").rglob(name))
            found = found or "/" not in name and any((ROOT / "include").rglob(name))
            self.assertTrue(found, name)


class Comparison(unittest.TestCase):
    """Of the runner itself."""

    def test_lines_are_compared(self):
        self.assertTrue(console.fits("a\n", "a\n"))
        self.assertFalse(console.fits("a\n", "b\n"))
        self.assertFalse(console.fits("a\n", "a\nb\n"))
        self.assertTrue(console.fits("a\n...\n", "a\nb\nc\n"))
        self.assertTrue(console.fits("a ... c\n", "a b c\n"))
        self.assertTrue(console.fits("in 0.05 s\n", "in 1e-3 s\n"))
        self.assertFalse(console.fits("0.05 m\n", "0.06 m\n"))

    def test_files_and_commands_are_found(self):
        text = "Write `a.yaml`:\n\n```yaml\nx: 1\n```\n\n```console\n$ one \\\n  two\nprinted\n$ three\n```\n"
        blocks = list(console.fenced_blocks(text))
        self.assertEqual(blocks[0], ("yaml", "x: 1\n", "a.yaml"))
        self.assertEqual(console.commands(blocks[1][1]), [("one \\\n  two", "printed\n"), ("three", "")])


def write_xml(result, file):
    """As gtest does, so that cases are counted."""
    suite = ElementTree.Element("testsuite", name="docs_test")
    failures = result.failures + result.errors
    for test, text in failures:
        case = ElementTree.SubElement(suite, "testcase", classname="docs_test", name=str(test))
        ElementTree.SubElement(case, "failure").text = text
    for number in range(result.testsRun - min(result.testsRun, len({test.id() for test, _ in failures}))):
        ElementTree.SubElement(suite, "testcase", classname="docs_test", name=f"passed_{number}")
    pathlib.Path(file).parent.mkdir(parents=True, exist_ok=True)
    ElementTree.ElementTree(suite).write(file)


if __name__ == "__main__":
    PROGRAMS["aspects"], PROGRAMS["first_map"] = (pathlib.Path(each).resolve() for each in sys.argv[1:3])
    results = sys.argv[3]
    program = unittest.main(argv=sys.argv[:1], exit=False)
    write_xml(program.result, results)
    sys.exit(not program.result.wasSuccessful())
