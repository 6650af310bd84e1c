# SPDX-License-Identifier: BSD-3-Clause
"""Reads a page of the docs as a reader would: writes its files, runs its commands, compares what they print.

- A block of ```console holds commands behind "$ ", each followed by what it prints. A line "..." stands for any lines,
  "..." in a line for any text, and a time such as "0.05 s" for any time. A command that ends with " &" goes on.
- A block after a line that ends with the name of a file and a colon, as in "Write `my.urdf`:", is that file. A page that
  says "The files are those of [another.md](another.md)" begins with the files of that page.
"""
import os
import pathlib
import re
import signal
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
FILES_OF = re.compile(r"files are those of\s\[[^\]]*\]\(([^)]+)\)")
FILE_NAME = re.compile(r"`([\w.]+)`:\s*\Z")
COMMAND = re.compile(r"^\$ ((?:.*\\\n)*.*)\n((?:(?!\$ ).*\n)*)", re.MULTILINE)
NEEDS_ROS = re.compile(r"^(ros\w+|python3)\b")
TIME = re.compile(r"\b[0-9][0-9.e-]* s\b")
DEADLINE = 60.0  # [s]


def fenced_blocks(text):
    """(language, text, name of the file that it is or None) of every block."""
    for block in FENCE.finditer(text):
        name = FILE_NAME.search(text[: block.start()])
        yield block.group(1), block.group(2), name.group(1) if name else None


def commands(block):
    """(command, what it prints) of a console block."""
    return [(command, printed) for command, printed in COMMAND.findall(block)]


def fits(expected, printed):
    """Whether what was printed is what the docs say."""
    pattern = ""
    for line in TIME.sub("T s", expected).splitlines():
        pattern += r"(?:.*\n)*?" if line == "..." else r".*".join(map(re.escape, line.rstrip().split("..."))) + r"\n"
    return re.fullmatch(pattern, TIME.sub("T s", printed)) is not None


class Page:
    """One page, in a folder of its own, with the programs of `path` before all others."""

    def __init__(self, file, path, ros):
        self.file, self.ros = pathlib.Path(file), ros
        self.folder = tempfile.TemporaryDirectory(prefix="docs_")
        self.environment = dict(os.environ, PATH=f"{path}:{os.environ['PATH']}")
        scripts = pathlib.Path(self.folder.name) / "scripts"  # as in a clone
        scripts.mkdir()
        (scripts / "aspects").symlink_to(pathlib.Path(path) / "aspects")
        for each in ("urdf", "config"):
            (pathlib.Path(self.folder.name) / each).symlink_to(ROOT / each)
        self.background = []
        self.log = pathlib.Path(self.folder.name) / "background.log"

    def problems(self):
        """What does not hold, a text each."""
        found = []
        page = self.file.read_text(encoding="utf-8")
        try:
            for other in FILES_OF.findall(page):
                for _, text, name in fenced_blocks((self.file.parent / other).read_text(encoding="utf-8")):
                    self.write(name, text)
            for language, text, name in fenced_blocks(page):
                if name:
                    self.write(name, text)
                elif language == "console":
                    found += filter(None, [self.run(*each) for each in commands(text)])
        finally:
            self.close()
        return found

    def write(self, name, text):
        """A file of the reader, if the block has a name."""
        if name:
            (pathlib.Path(self.folder.name) / name).write_text(text, encoding="utf-8")

    def run(self, command, expected):
        """None, or what is wrong."""
        if NEEDS_ROS.match(command) and not self.ros:
            return None
        options = {"shell": True, "cwd": self.folder.name, "env": self.environment, "start_new_session": True}
        if command.endswith(" &"):
            log = open(self.log, "a", encoding="utf-8")
            self.background.append(subprocess.Popen(command[:-2], stdout=log, stderr=log, **options))
            return None
        # Tools of ROS warn of what is not there yet; refusals of `aspects` are part of the docs.
        errors = subprocess.DEVNULL if NEEDS_ROS.match(command) else subprocess.STDOUT
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=errors, text=True, **options)
        try:
            printed = process.communicate(timeout=DEADLINE)[0]
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            log = self.log.read_text(encoding="utf-8") if self.log.exists() else ""
            return f"$ {command}\ndoes not end; so far: {process.communicate()[0]}\nof those that go on:\n{log}"
        return None if fits(expected, printed) else f"$ {command}\nprints\n{printed}and not\n{expected}"

    def close(self):
        """Ends what goes on, and forgets the folder."""
        for process in self.background:
            os.killpg(process.pid, signal.SIGINT)
        for process in self.background:
            try:
                process.wait(20.0)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
        self.folder.cleanup()
