# SPDX-License-Identifier: BSD-3-Clause
"""Asks the Python module what scripts/compare_answers compares: prints each expression and its value, or what it raises, as
JSON. Runs in the folder of the questions, with the shipped robots in share/."""
import dataclasses
import json

import numpy as np
import parallel_aspects as pa

five_bar = pa.load("five_bar")
planar = pa.load("three_rpr")
stewart = pa.load("stewart")
aspects = five_bar.map(resolution=1)

ANSWERED = """
pa.robots()
pa.load("share/urdf/five_bar.urdf", "share/config/robots/five_bar.yaml")
[pa.load(name) for name in pa.robots()]
[five_bar.name, five_bar.task_space, five_bar.coordinates, five_bar.legs, five_bar.actuated_joints, five_bar.notes]
[five_bar.working_modes, five_bar.constraints, five_bar.lengths, five_bar.size, five_bar.base_frame]
[planar.joint_limits, planar.characteristic_length, planar.constraints]
five_bar.constrained(margin={"parallel": 0.05, "serial": 0.1}).constraints
planar.constrained(no_constraint="all").constraints
planar.constrained(constraint=["actuated_limits"], tolerance=0.001).constraints
five_bar.with_lengths({"rod_1": 5.5, "rod_2": 8.8}).lengths
five_bar.with_lengths({"rod_1": 5.5}, untied=True).lengths
five_bar.describe()
five_bar.inverse((4.5, 8), "(+,-)")
five_bar.inverse([(4.5, 8), (50, 0)], (1, -1))
five_bar.configurations((4.5, 8))
five_bar.direct((0.4835, 3.1385))
five_bar.indices([(4.5, 8), (50, 0)], "(-,+)")
five_bar.jacobian((4.5, 8), mode="(+,-)")
five_bar.jacobian(joints=(-1, 0.2))
five_bar.distance((4.5, 8), "(-,+)")
five_bar.distances([(4.5, 8), (4.4, 8)], "(-,+)", tolerance=0.1, boxes=50)
five_bar.check([0, 1], [(4.5, 8), (4, 8)], "(+,-)").answer
five_bar.check([0, 1], [(4.5, 8), (4.5, -8)], "(+,-)")
five_bar.check_joints([0, 1], [(0.4835, 1.0279), (0.6, 1.1)], start_pose=(4.5, 8)).speeds
five_bar.check_joints([0, 1], [(0.4835, 1.0279), (3.2, 4.5)], start_sign="+", policy="serial").reason
five_bar.choose([0, 1], [(4.5, 8), (4, 8)], map=aspects)
five_bar.choose([0, 1], [(4.5, 8), (4, 8)], prefer="travel")
five_bar.choose_region({"x": (4, 5), "y": (7, 8)})
five_bar.plan((4.5, 8), (4, 6), samples=50)
five_bar.plan((4.5, 8), (4.5, -8), "(+,+)", "(-,+)", policy="serial", samples=50)
stewart.plan((0, 0, 1.3, 0, 0, 0, 1), (0, 0, 1.2, 0, 0, 0, 1), samples=20)
five_bar.sweep({"crank_1": (6, 8, 3), "rod_2": 7}, report=["count", "measures"], resolution=2, file="module.csv")
pa.read_sweep("module.csv")
pa.load("bipod").uniqueness()
planar.uniqueness({"strut_1_joint": 14.98})["cusps"]
planar.cusp_curves({"strut_1_joint": (26, 26.9)})["cusp_counts"]
stewart.uniqueness(samples=20, poses=2)
aspects
aspects.aspects
[aspects.coordinates, aspects.unit, aspects.region, aspects.resolution, aspects.working_modes]
[aspects.proved_count, aspects.count_at_most, aspects.unresolved, aspects.measure_undecided]
aspects.locate([(4.5, 8), (4.5, 0), (50, 0)], (1, -1))
aspects.boxes(5)
aspects.graph()
five_bar.locate((4.5, 8), mode="(+,-)")
five_bar.locate(joints=(0.4835, 1.0279))["configurations"]
aspects.undecided("(+,-)").sum(axis=0)
aspects.workspace("disc", gap=0.1)
aspects.workspace("box", [3], center={"x": 4.5}, aspect_ratio=(1, 2))
aspects.plan((4.5, 8), (4.5, -8), policy="serial", prefer="clear")
aspects.save("module.map")
five_bar.load_map("module.map", resolution=1)
aspects.outlines("(+,-)", cells=6)
len(aspects.plot(modes=["(+,-)"], cells=20).axes)
five_bar.map(slice={"x": 4.5}, mode=["(+,-)"]).aspects
five_bar.map(region="x=4:5 y=-13:13", resolution=1, threads=1, extra_levels=4).proved_count
"""

REFUSED = """
pa.load("six_bar")
pa.load("nowhere.urdf", "nowhere.yaml")
pa.nothing
pa.read_sweep("share/urdf/five_bar.urdf")
five_bar.constrained(margin={"parallel": 2, "serial": -1})
five_bar.constrained(constraint="gravity")
five_bar.with_lengths({"rod_1": 5.5}).describe()
five_bar.with_lengths({"rod_1": "long"})
five_bar.with_lengths({"crank_1": -1})
five_bar.with_lengths({"wheel": 1})
five_bar.inverse((1, 2, 3), "(+,-)")
five_bar.inverse([(1, 2), (np.nan, 2)], "(+,-)")
five_bar.inverse([(1, 2), (3,)], "(+,-)")
five_bar.inverse((1, 2), "x")
five_bar.configurations([(1, 2), (3, 4)])
five_bar.direct((1, 2, 3))
five_bar.indices("ab", "(+,-)")
five_bar.jacobian()
five_bar.distance((4.5, 8), "(+,-)", boxes=1.5)
five_bar.distances((4.5, 8), "(+,-)", tolerance=2)
five_bar.check("ab", [(4.5, 8)], "(+,-)")
five_bar.check([0], [(4.5, 8), (4, 8)], "(+,-)")
five_bar.check([1, 0], [(4.5, 8), (4, 8)], "(+,-)")
five_bar.check_joints([0, 1], [(0.4835, 1.0279), (0.6, 1.1)])
five_bar.choose([0], [(4.5, 8)], prefer="best")
pa.load("five_bar").choose([0], [(4.5, 8)], map=aspects)
five_bar.choose_region({"x": (4, 5)})
five_bar.plan((4.5, 8), (4, 6), policy="any")
stewart.plan((0, 0, 1.3, 0, 0, 0, 1), (0, 0, 1.2), samples=20)
five_bar.sweep({"crank_1": (6, 8, 2.5)})
five_bar.sweep({"crank": (6, 8, 3), "crank_1": 3})
five_bar.uniqueness({"crank_1_joint": 0.3})
five_bar.cusp_curves("crank_1_joint")
planar.cusp_curves("crank")
stewart.map()
five_bar.map(resolution="fine")
five_bar.map(resolution=-1)
five_bar.map(threads=-2)
five_bar.map(slice={"q": 1})
five_bar.map(region={"x": 1, "y": (0, 1)})
five_bar.load_map("module.map", resolution=2)
aspects.locate((1, 2, 3), "(+,-)")
aspects.boxes(99)
aspects.workspace("disk")
aspects.workspace("disc", [11])
aspects.workspace("disc", center=(4.5, 8))
aspects.plan((4.5, 8), (4, 8), policy="x")
aspects.outlines("(+,-)", level=np.nan)
aspects.plot(modes=[])
aspects.save("/nowhere/map")
"""


def plain(value):
    """As JSON has it; what is printed otherwise, as it is printed."""
    if dataclasses.is_dataclass(value):
        return {field.name: plain(getattr(value, field.name)) for field in dataclasses.fields(value)}
    if isinstance(value, dict):
        return {str(key): plain(each) for key, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(each) for each in value]
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    return value if value is None or isinstance(value, (bool, int, float, str)) else repr(value)


def answer(expression):
    try:
        return plain(eval(expression))  # pylint: disable=eval-used
    except Exception as error:  # pylint: disable=broad-except
        return {"raised": type(error).__name__, "message": str(error), "problems": getattr(error, "problems", None)}


print(json.dumps({line: answer(line) for line in (ANSWERED + REFUSED).split("\n") if line}, ensure_ascii=False))
