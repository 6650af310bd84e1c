# SPDX-License-Identifier: BSD-3-Clause
"""The Python module: its numbers against formulas of the five-bar written here, its page, its example and its stubs."""
import ast
import doctest
import inspect
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODULE = os.environ["PARALLEL_ASPECTS_MODULE"]
sys.path.insert(0, MODULE)
os.environ["PYTHONPATH"] = MODULE + os.pathsep + os.environ.get("PYTHONPATH", "")
os.environ["MPLBACKEND"] = "Agg"
import parallel_aspects as pa  # pylint: disable=wrong-import-position
from parallel_aspects import _core  # pylint: disable=wrong-import-position

CENTERS = np.array([[0.0, 0.0], [9.0, 0.0]])  # the five-bar of Chablat and Wenger [m]
CRANKS, RODS = np.array([8.0, 5.0]), np.array([5.0, 8.0])
MODES = ["(+,+)", "(+,-)", "(-,+)", "(-,-)"]


@pytest.fixture(scope="module", name="robot")
def fixture_robot():
    return pa.load("five_bar")


@pytest.fixture(scope="module", name="aspects")
def fixture_aspects(robot):
    return robot.map()


def signs_of(mode):
    return np.array([1 if sign == "+" else -1 for sign in mode[1::2]])


def closed_form(points, mode):
    """q (n, 2), det A (n,) and whether both legs reach (n,), by the law of cosines: B_jj = l1 l2 sin(theta) has the sign
    of the mode."""
    d = points[:, None, :] - CENTERS
    r2 = (d**2).sum(axis=2)
    cosine = (r2 + CRANKS**2 - RODS**2) / (2 * CRANKS * np.sqrt(r2))
    reached = (np.abs(cosine) < 1).all(axis=1)
    # The rod turns counter-clockwise from the crank where B_jj > 0, so the crank is behind the line to the point.
    q = np.arctan2(d[..., 1], d[..., 0]) - signs_of(mode) * np.arccos(np.clip(cosine, -1, 1))
    elbow = CENTERS + CRANKS[:, None] * np.stack([np.cos(q), np.sin(q)], axis=2)
    u = points[:, None, :] - elbow
    determinant = u[:, 0, 0] * u[:, 1, 1] - u[:, 0, 1] * u[:, 1, 0]
    return q, determinant, reached


def random_points(count):
    return np.random.default_rng(7).uniform((-5, -14), (14, 14), (count, 2))


@pytest.mark.parametrize("mode", MODES)
def test_inverse_is_the_closed_form(robot, mode):
    points = random_points(2000)
    q, _, reached = closed_form(points, mode)
    found = robot.inverse(points, signs_of(mode))
    assert found.shape == (2000, 2)
    assert (np.isfinite(found).all(axis=1) == reached).all()
    turns = (found - q)[reached] / (2 * np.pi)
    assert np.abs(turns - np.round(turns)).max() < 1e-9


def test_direct_solutions_hold_the_pose(robot):
    points = random_points(50)
    for mode in MODES:
        q, determinant, reached = closed_form(points, mode)
        for i in np.flatnonzero(reached):
            solved = robot.direct(q[i])
            gaps = np.linalg.norm(solved.poses - points[i], axis=1)
            assert solved.status == "solved" and gaps.min() < 1e-6
            assert solved.determinants[gaps.argmin()] == pytest.approx(determinant[i], rel=1e-5, abs=1e-5)
    assert [c.working_mode for c in robot.configurations((4.5, 8))] == robot_modes(robot)


def robot_modes(robot):
    return list(robot.working_modes)


@pytest.mark.parametrize("mode", MODES)
def test_located_poses_have_the_sign_of_their_aspect(aspects, mode):
    points = random_points(3000)
    _, determinant, reached = closed_form(points, mode)
    ids = aspects.locate(points, mode)
    assert ids.shape == (3000,) and (ids > 0).sum() > 1000
    by_id = {aspect.id: aspect for aspect in aspects.aspects}
    for i in np.flatnonzero(ids > 0):
        aspect = by_id[ids[i]]
        assert aspect.working_mode == mode and reached[i] and aspect.determinant_sign * determinant[i] > 0, points[i]
    assert not reached[ids == pa.OUTSIDE].any()
    assert aspects.locate(points[0], mode) == ids[0]


def test_aspects_of_the_paper(aspects):
    assert aspects.proved_count == aspects.count_at_most == len(aspects.aspects) == 10
    assert aspects.unresolved.shape == (0, 2)
    assert aspects.coordinates == ("x", "y") and aspects.unit == "m^2" and list(aspects.region) == ["x", "y"]
    by_area = sorted(aspects.aspects, key=lambda aspect: aspect.measure)
    for aspect, area in zip(by_area, np.repeat([3.70, 47.85, 109.78, 135.35, 193.58], 2)):  # +- 0.5 %, by brute force
        assert aspect.measure_lower < 1.005 * area and aspect.measure_upper > 0.995 * area
        assert aspect.measure == pytest.approx(area, rel=0.03)
    for aspect in aspects.aspects:
        boxes = aspects.boxes(aspect.id)
        assert boxes.shape == (aspect.inside_leaves, 2, 2)
        assert np.prod(boxes[..., 1] - boxes[..., 0], axis=1).sum() == pytest.approx(aspect.measure_lower)
        assert aspect.measure_lower <= aspect.measure <= aspect.measure_upper
        assert aspects.locate(aspect.deepest_pose, aspect.working_mode) == aspect.id
    assert sum(len(aspects.undecided(mode)) for mode in MODES) > 0


def test_an_upper_bound_where_it_is_asked_for():
    linear_delta = pa.load("linear_delta")
    assert linear_delta.map().count_at_most is None
    assert linear_delta.map(complete=True).count_at_most == 14


def test_distances_as_published(robot):
    """Nearest singularities of the five-bar at (4.5, 8): found by brute force, of both signs of the elbow."""
    distance = robot.distance((4.5, 8), "(-,+)")
    assert distance.status == "measured" and distance.parallel.upper_proved
    assert distance.parallel.lower <= 1.5359 <= distance.parallel.upper + 1e-4
    assert distance.parallel.witness == pytest.approx((4.218, 6.490), abs=0.05)
    assert distance.serial.upper == pytest.approx(3.821220, abs=1e-5)
    assert distance.actuated_limit.status == "absent" and distance.actuated_limit.witness is None
    bounds = robot.distances([(4.5, 8), (4.4, 8)], "(-,+)")
    assert bounds.shape == (2, 3, 2)
    assert tuple(bounds[0, 0]) == (distance.parallel.lower, distance.parallel.upper)


def test_distances_of_every_mode_and_of_a_map(robot, aspects):
    alone = robot.distance((4.5, 8))
    assert [each.working_mode for each in alone] == list(robot.working_modes)
    of_map = aspects.distance((4.5, 8), "(-,+)")
    assert of_map.parallel.boxes < robot.distance((4.5, 8), "(-,+)").parallel.boxes
    assert of_map.serial.leg in robot.legs and of_map.parallel.leg is None
    assert robot.distance((4.5, 80), "(-,+)").parallel.status == "unavailable"


def test_indices_vanish_at_singularities(robot):
    parallel, serial = robot.indices((4.5, 8), "(-,+)")
    q, determinant, _ = closed_form(np.array([[4.5, 8.0]]), "(-,+)")
    assert parallel == pytest.approx(abs(determinant[0]) / np.prod(RODS))
    assert serial.shape == (2,)
    witness = robot.distance((4.5, 8), "(-,+)").parallel.witness
    assert robot.indices(witness, "(-,+)")[0] < 1e-3
    assert q.shape == (1, 2)


def test_trajectories(robot, aspects):
    safe = robot.check([0, 1], [(4.5, 8), (4, 8)], "(+,-)")
    assert safe.answer == "yes" and safe.first_violation is None and len(safe.speeds) == 2
    assert safe.samples["q"] == pytest.approx(robot.inverse(safe.samples["poses"], "(+,-)"), abs=1e-6)
    unsafe = robot.check([0, 1], [(4.5, 8), (4.5, -8)], "(+,-)")
    assert unsafe.answer == "no" and unsafe.first_violation["kind"] == "parallel_singularity"
    at = np.array([[4.5, 8 - 16 * unsafe.first_violation[end]] for end in ("after", "before")])
    assert np.prod(closed_form(at, "(+,-)")[1]) < 0
    joints = robot.check_joints([0, 1], safe.samples["q"][[0, -1]], start_pose=(4.5, 8))
    assert joints.answer == "yes"
    chosen = robot.choose([0, 1], [(4.5, 8), (4, 8)], map=aspects)
    assert chosen["answer"] == "yes" and {mode["aspect"] for mode in chosen["modes"]} <= {1, 3, 8, 9}
    changed = robot.choose([0, 1], [(2, -7), (8.4, 8.8)], changes=True)
    assert changed["answer"] == "no" and changed["with_changes"]["answer"] == "yes"
    assert changed["with_changes"]["changes"][0]["leg"] in robot.legs
    region = robot.choose_region({"x": (4, 5), "y": (7, 8)})
    assert region["answer"] == "yes" and region["region"]["x"] == (4, 5) and region["prefer"] is None


def test_planned_segments_keep_the_sign(robot, aspects):
    start, goal = (4.5, 8), (11.5, -2)
    path = aspects.plan(start, goal, "(+,-)", "(+,-)")
    assert path and path.poses[0] == pytest.approx(start) and path.poses[-1] == pytest.approx(goal)
    t = np.linspace(0, 1, 200)[:, None]
    for i in range(len(path.poses) - 1):
        points = (1 - t) * path.poses[i] + t * path.poses[i + 1]
        _, determinant, reached = closed_form(points, path.modes[i])
        assert reached.all() and (determinant * determinant[0] > 0).all()
    turns = (path.q - robot.inverse(path.poses, "(+,-)")) / (2 * np.pi)
    assert turns == pytest.approx(np.round(turns), abs=1e-9)
    assert aspects.plan(start, (4.5, -8), "(+,-)", "(+,-)").answer == "yes"
    assert aspects.plan(start, (4.5, 11.8), "(+,-)", "(+,-)").answer == "no"
    assert pa.load("stewart").plan((0, 0, 1.3, 0, 0, 0, 1), (0, 0, 1.2, 0, 0, 0, 1), samples=20).poses.shape[1] == 7


def test_acceleration_is_that_of_the_yaml(robot, tmp_path):
    stated = [robot, robot.constrained(margin={"parallel": 0.01}), robot.with_lengths({"rod_1": 5.1}), robot.map(resolution=0.5)]
    for each in stated:
        assert each.plan((4.5, 8), (4.4, 8), prefer="fast").seconds > 0
    yaml = (ROOT / "config" / "robots" / "five_bar.yaml").read_text()
    (tmp_path / "five_bar.yaml").write_text(yaml.replace("  acceleration: [10.0, 10.0]", ""))
    unstated = pa.load(ROOT / "urdf" / "five_bar.urdf", tmp_path / "five_bar.yaml")
    with pytest.raises(pa.InvalidDescription, match="prefer fast needs acceleration"):
        unstated.plan((4.5, 8), (4.4, 8), prefer="fast")
    (tmp_path / "five_bar.yaml").write_text(yaml.replace("[10.0, 10.0]", "[10.0]"))
    with pytest.raises(pa.InvalidDescription, match="motion.acceleration"):
        pa.load(ROOT / "urdf" / "five_bar.urdf", tmp_path / "five_bar.yaml")


def test_paths_know_what_the_command_knows(robot):
    fast = robot.plan((4.5, 8), (4, 6), prefer="fast", acceleration=(100, 100))
    assert fast.prefer == "fast" and fast.seconds > 0 and fast.trajectory["q"].shape[1] == 2
    assert fast.trajectory["times"][-1] == pytest.approx(fast.seconds)
    planar = pa.load("three_rpr")
    held = {"strut_1_joint": 14.98}
    aspects = planar.map(slice=held)
    around = aspects.plan(aspects.aspects[0].deepest_pose, around_cusp=1)
    again = planar.plan(aspects.aspects[0].deepest_pose, slice=held, around_cusp=1)
    for path in (around, again):
        assert path.around_cusp == 1 and path.slice["held"] == held and path.answer == around.answer
    assert around.turns_around_cusps == again.turns_around_cusps and around.poses == pytest.approx(again.poses)
    with pytest.raises(TypeError):
        robot.plan((4.5, 8), (4, 8), polciy="stay")


def test_connections_are_those_of_the_map(robot, aspects):
    answer = robot.connect((4.5, 8), (4, 6), mode="(+,-)")
    (only,) = answer["answers"]
    assert only["same_aspect"] == "yes" and only["working_mode"] == "(+,-)" and only["clearance"] > 0
    assert only["path"].shape[1] == 2 and only["bottleneck"]["lower"] <= only["bottleneck"]["upper"]
    for each in aspects.connect((4.5, 8), (4.5, -8))["answers"]:
        ids = aspects.locate([(4.5, 8), (4.5, -8)], each["working_mode"])
        assert ids.min() <= 0 or (each["same_aspect"] == "yes") == (ids[0] == ids[1])


def test_locations_and_gates_are_those_of_the_map(robot, aspects):
    found = robot.locate((4.5, 8))["configurations"]
    assert len(found) == 4
    for each in found:
        assert each["aspect"] == aspects.locate((4.5, 8), each["working_mode"])
        again = robot.locate(joints=each["joints"], mode=each["working_mode"])["configurations"]
        assert min(np.abs(one["pose"] - (4.5, 8)).max() for one in again) < 1e-6
    graph = aspects.graph()
    sets = {aspect["id"]: aspect["set"] for aspect in graph["aspects"]}
    assert sorted(sets) == [aspect.id for aspect in aspects.aspects]
    for gate in graph["gates"]:
        first, second = gate["aspects"]
        assert gate["crossing"] != "serial" or not gate["proved"] or sets[first] == sets[second]
    with pytest.raises(pa.InvalidDescription, match="pose is required"):
        robot.locate()


def test_workspaces_lie_in_their_aspects(aspects):
    found = aspects.workspace("disc")
    assert [each.aspect for each in found] == [aspect.id for aspect in aspects.aspects]
    turns = np.linspace(0, 2 * np.pi, 400)
    rim = np.stack([np.cos(turns), np.sin(turns)], axis=1)
    for each, aspect in zip(found, aspects.aspects):
        points = np.concatenate([each.center + share * each.lower * rim for share in (0.3, 0.7, 0.999)])
        _, determinant, reached = closed_form(points, aspect.working_mode)
        assert reached.all() and (aspect.determinant_sign * determinant > 0).all() and each.lower <= each.upper
    box = aspects.workspace("box", [3], center={"x": 4.5}, aspect_ratio=(1, 2))[0]
    assert box.center[0] == 4.5 and box.lengths["edge_y"] == pytest.approx(2 * box.lengths["edge_x"])


def test_sweeps_go_on(robot, tmp_path):
    file = tmp_path / "sweep.csv"
    ask = {"vary": {"crank_1": (6, 8, 3), "rod_2": 7}, "report": ("count", "measures"), "resolution": 1.0}
    whole = robot.sweep(file=file, **ask)
    assert len(whole) == 3 and list(whole["crank_1"]) == [6, 7, 8] and set(whole["status"]) == {"mapped"}
    text = file.read_bytes()
    file.write_bytes(text[:-30])
    with pytest.raises(pa.InvalidDescription, match="of another robot, command"):
        robot.sweep(file=file, **{**ask, "resolution": 2.0})
    shares = []
    assert len(robot.sweep(file=file, progress=shares.append, **ask)) == 3
    assert file.read_bytes() == text and shares[-1] == 1.0
    for i, measure in enumerate(whole["measure_lower"]):
        design = robot.with_lengths({"crank_1": 6.0 + i, "rod_2": 7.0}).map(resolution=1.0)
        assert measure == pytest.approx(sum(aspect.measure_lower for aspect in design.aspects))
    assert pa.read_sweep(file).names() == whole.names()


def test_curves_of_cusps_hold_the_cusps_of_a_slice():
    robot = pa.load("three_rpr")
    found = robot.cusp_curves({"strut_1_joint": (26, 27)})
    assert found["cusp_curves_complete"] and found["held_joint"] == "strut_1_joint"
    for curve in found["cusp_curves"]:
        assert curve["poses"].shape == curve["q"].shape == (len(curve["points"]), 3)
        assert robot.inverse(curve["poses"][1:-1], "(+,+,+)") == pytest.approx(curve["q"][1:-1], abs=1e-6)
        assert robot.indices(curve["poses"], "(+,+,+)")[0].max() < 1e-6  # det A = 0
    for value in (26.4, 26.79, 26.9):
        cusps = robot.uniqueness({"strut_1_joint": value})["cusps"]
        assert [len(cusps)] == [each["cusps"] for each in found["cusp_counts"] if each["lower"] <= value <= each["upper"]]
        crossings = [np.diff(np.sign(curve["q"][:, 0] - value)).astype(bool).sum() for curve in found["cusp_curves"]]
        assert sum(crossings) == len(cusps)


def test_uniqueness_over_a_roadmap():
    found = pa.load("stewart").uniqueness(samples=20, seed=2, poses=2)
    assert (found["samples"], found["seed"], found["poses"]) == (20, 2, 2)
    assert sum(each["samples"] for each in found["components"]) == 20
    assert all(each["working_mode"] == "(+,+,+,+,+,+)" for each in found["components"])


@pytest.mark.parametrize("name", pa.robots())
def test_shipped_robots(name):
    robot = pa.load(name)
    assert len(robot.legs) == len(robot.actuated_joints) == len(robot.joint_limits) and robot.size > 0
    assert name in repr(robot) and robot.working_modes


def test_own_robots_and_all_problems(robot, tmp_path):
    own = pa.load(ROOT / "urdf" / "five_bar.urdf", ROOT / "config" / "robots" / "five_bar.yaml")
    assert own.lengths == robot.lengths and own.map(resolution=1).aspects[0].measure > 0
    with pytest.raises(pa.InvalidDescription) as caught:
        pa.load(tmp_path / "a.urdf", tmp_path / "b.yaml")
    assert len(caught.value.problems) == 2 and isinstance(caught.value, ValueError)
    assert all(problem in str(caught.value) for problem in caught.value.problems)


BAD = {
    "poses has shape": lambda robot, aspects: robot.inverse((1, 2, 3), "(+,-)"),
    "Row 1 of poses": lambda robot, aspects: robot.inverse([(1, 2), (np.nan, 2)], "(+,-)"),
    "poses is no array of numbers": lambda robot, aspects: robot.inverse([(1, 2), (3,)], "(+,-)"),
    "times is no array of numbers": lambda robot, aspects: robot.check("ab", [(4.5, 8)], "(+,-)"),
    "resolution is 'fine'": lambda robot, aspects: robot.map(resolution="fine"),
    "level is nan": lambda robot, aspects: aspects.outlines("(+,-)", level=np.nan),
    "cells is 'many'": lambda robot, aspects: aspects.outlines("(+,-)", cells="many"),
    "threads is -2": lambda robot, aspects: robot.map(threads=-2),
    "boxes is 1.5": lambda robot, aspects: robot.distance((4.5, 8), "(+,-)", boxes=1.5),
    "center is (4.5, 8)": lambda robot, aspects: aspects.workspace("disc", center=(4.5, 8)),
    "center is {'x': 'x'}": lambda robot, aspects: aspects.workspace("disc", center={"x": "x"}),
    "region is {'x': 1": lambda robot, aspects: robot.map(region={"x": 1, "y": (0, 1)}),
    "values of crank_1 is 2.5": lambda robot, aspects: robot.sweep({"crank_1": (6, 8, 2.5)}),
    "rod_1 is 'long'": lambda robot, aspects: robot.with_lengths({"rod_1": "long"}),
    "mode is 'x'": lambda robot, aspects: robot.inverse((1, 2), "x"),
    "times has 1": lambda robot, aspects: robot.check([0], [(4.5, 8), (4, 8)], "(+,-)"),
    "shape is 'disk'": lambda robot, aspects: aspects.workspace("disk"),
    "aspect is 11": lambda robot, aspects: aspects.workspace("disc", [11]),
    "around_cusp is of robots": lambda robot, aspects: robot.plan((4.5, 8), around_cusp=1),
    "goal is required": lambda robot, aspects: robot.plan((4.5, 8)),
    "samples and seed are for roadmaps": lambda robot, aspects: aspects.plan((4.5, 8), (4, 8), samples=10),
    "slice is (1, 2)": lambda robot, aspects: robot.plan((4.5, 8), (4, 8), slice=(1, 2)),
    "policy is 'x'": lambda robot, aspects: aspects.plan((4.5, 8), (4, 8), policy="x"),
    "no aspect 99": lambda robot, aspects: aspects.boxes(99),
    "numbers of the same link": lambda robot, aspects: robot.sweep({"crank": (6, 8, 3), "crank_1": 3}),
    "resolution is -1": lambda robot, aspects: robot.map(resolution=-1),
    "no coordinate 'q'": lambda robot, aspects: robot.map(slice={"q": 1}),
    "region has 'z": lambda robot, aspects: robot.map(region={"z": (0, 1)}),
    "over names 'crank'": lambda robot, aspects: pa.load("three_rpr").cusp_curves("crank"),
    "'five_bar' has no cusps": lambda robot, aspects: robot.cusp_curves("crank"),
    "no shipped robot": lambda robot, aspects: pa.load("six_bar"),
    "did you mean five_bar?": lambda robot, aspects: pa.load("fiv_bar"),
    "map is of another robot": lambda robot, aspects: pa.load("five_bar").choose([0], [(4.5, 8)], map=aspects),
    "crank length of -1": lambda robot, aspects: robot.with_lengths({"crank_1": -1}),
}


@pytest.mark.parametrize("words", BAD)
def test_bad_arguments_are_refused_by_name(robot, aspects, words):
    with pytest.raises(pa.InvalidDescription) as caught:
        BAD[words](robot, aspects)
    assert any(words in problem for problem in caught.value.problems), caught.value.problems
    assert not any("--" in problem for problem in caught.value.problems)


def test_a_roadmap_takes_the_place_of_a_map_with_six_degrees_of_freedom():
    robot = pa.load("stewart")
    found = robot.map(samples=30)
    assert isinstance(found, pa.Roadmap) and found.samples == 30 and found.proved_count == len(found.sides)
    for side in found.sides:
        assert sum(side.component_sizes) == side.samples and side.largest_share == side.component_sizes[0] / side.samples
        assert len(side.largest_indices) == len(side.component_sizes)
    with pytest.raises(pa.InvalidDescription, match="resolution is for maps of boxes"):
        robot.map(resolution=0.1)


def test_saved_maps_come_back(robot, aspects, tmp_path):
    aspects.save(tmp_path / "map")
    loaded = robot.load_map(tmp_path / "map")
    assert [a.measure for a in loaded.aspects] == [a.measure for a in aspects.aspects]
    with pytest.raises(pa.InvalidDescription):
        robot.load_map(tmp_path / "map", resolution=1.0)


def test_long_work_lets_other_threads_run_and_ends_by_what_progress_raises():
    robot, counted, ended = pa.load("three_rrr"), [0], threading.Event()

    def count():
        while not ended.is_set():
            counted[0] += 1
            time.sleep(0.001)

    class Enough(Exception):
        pass

    def progress(share):
        assert 0 <= share <= 1
        if counted[0] > 20:
            raise Enough

    other = threading.Thread(target=count)
    other.start()
    try:
        with pytest.raises(Enough):
            robot.map(resolution=0.005, progress=progress)
    finally:
        ended.set()
        other.join()


@pytest.mark.parametrize("statement", ["from parallel_aspects import load", "import parallel_aspects; parallel_aspects.robots()"])
def test_without_the_compiled_module_its_option_is_named(tmp_path, statement):
    here = pathlib.Path(pa.__file__).parent
    there = tmp_path / "parallel_aspects"
    shutil.copytree(here, there, ignore=shutil.ignore_patterns("_core*.so", "__pycache__"))
    for files in (None, ["__init__.py"]):  # not built; and not configured, beside the messages
        if files:
            for each in there.glob("_*.py"):
                if each.name not in files:
                    each.unlink()
        run = subprocess.run([sys.executable, "-c", statement], capture_output=True, text=True, check=False,
                             env={**os.environ, "PYTHONPATH": str(tmp_path)})
        assert run.returncode != 0
        last = run.stderr.strip().splitlines()[-1]
        assert last.startswith("ImportError: parallel_aspects.") and "-DPARALLEL_ASPECTS_PYTHON=ON" in last, run.stderr


def test_ctrl_c_ends_long_work():
    program = (
        "import parallel_aspects as pa\n"
        "try:\n"
        "    pa.load('three_rrr').map(resolution=0.005, progress=lambda share: print('works', flush=True))\n"
        "except KeyboardInterrupt:\n"
        "    print('interrupted')\n"
    )
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout.readline() == "works\n"
        process.send_signal(signal.SIGINT)
        output, _ = process.communicate(timeout=120)
    assert output.endswith("interrupted\n") and process.returncode == 0


def test_messages_alone_do_not_load_the_library():
    program = "import sys, parallel_aspects; sys.exit('numpy' in sys.modules or 'parallel_aspects._core' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", program], check=False).returncode == 0


def test_pictures(aspects, tmp_path):
    figure = aspects.plot()
    assert len([axes for axes in figure.axes if axes.get_visible()]) == 4
    figure.savefig(tmp_path / "a.png")
    outlines = aspects.outlines("(+,-)", cells=100)
    for number in (6, 7, 8):
        pieces = [corners for which, corners in outlines["polygons"] if which == number]
        x, y = (np.concatenate([piece[:, i] * np.roll(piece[:, 1 - i], -1) for piece in pieces]).sum() for i in (0, 1))
        assert 0.5 * (x - y) == pytest.approx(aspects.aspects[number - 1].measure, rel=0.02, abs=0.2)
    assert {kind for kind, _ in outlines["lines"]} == {"parallel", "serial"}
    with pytest.raises(ValueError):
        aspects.plot(modes=[])


def test_the_page_is_true(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = (ROOT / "docs" / "reference" / "python.md").read_text(encoding="utf-8")
    code = "\n\n".join(re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL))
    page = doctest.DocTestParser().get_doctest(code, {}, "python.md", None, 0)
    assert len(page.examples) > 20
    result = doctest.DocTestRunner().run(page)
    assert result.failed == 0
    assert (tmp_path / "five_bar.png").stat().st_size > 10_000


def test_the_example_draws_the_figures(tmp_path):
    program = [sys.executable, ROOT / "example" / "paper_figures.py", tmp_path]
    printed = subprocess.run(program, check=True, capture_output=True, text=True, timeout=300).stdout
    assert "10 aspects, 10 proved; at most 10\n" in printed and "B (+,-), det A +: 2\n" in printed
    assert sorted(file.name for file in tmp_path.iterdir()) == ["five_bar_aspects.png", "five_bar_designs.png"]


def stub(name):
    return ast.parse((ROOT / "src" / "python" / "parallel_aspects" / name).read_text(encoding="utf-8")).body


def test_stubs_name_what_is_there():
    imported = [alias.asname for node in stub("__init__.pyi") if isinstance(node, ast.ImportFrom) for alias in node.names]
    assert sorted(imported) == sorted(pa.__all__) == sorted(set(dir(pa)) & set(imported))
    for node in stub("_core.pyi"):
        if not isinstance(node, ast.ClassDef) or node.name == "InvalidDescription":
            continue
        kind = getattr(_core, node.name)
        names = {each.name if isinstance(each, ast.FunctionDef) else each.target.id for each in node.body}
        assert names == {name for name in vars(kind) if not name.startswith("_")}
        for each in node.body:
            if isinstance(each, ast.FunctionDef):
                signature = getattr(kind, each.name).__doc__.splitlines()[0]
                assert signature.count("arg") == len(each.args.args) - 1, signature


def test_everything_public_is_documented():
    for name in pa.__all__:
        value = getattr(pa, name)
        assert isinstance(value, int) or inspect.getdoc(value), name
        for member, each in vars(value).items() if inspect.isclass(value) else ():
            is_public = not member.startswith("_") and (callable(each) or isinstance(each, property))
            assert not is_public or inspect.getdoc(each), f"{name}.{member}"
