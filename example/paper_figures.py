#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The five-bar of Chablat and Wenger (1998) with its aspects, and the same with longer rods: paper_figures.py [FOLDER]

Needs the Python module (docs/reference/python.md). Writes pictures into the folder, by default the present one.
"""
import collections
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")  # files alone; no window
import matplotlib.pyplot as plt  # pylint: disable=wrong-import-position

import parallel_aspects as pa  # pylint: disable=wrong-import-position

# %% The robot of the paper: its lengths [m], and an inverse and a direct problem.
robot = pa.load("five_bar")
folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
print({name: value for name, value in robot.lengths.items() if not name.startswith("anchor")})
pose = (4.5, 8.0)
for configuration in robot.configurations(pose):
    others = len(robot.direct(configuration.joints).poses)
    print(f"{pose} in working mode {configuration.working_mode}: q = {configuration.joints.round(4)} rad, {others} assembly modes")

# %% The aspects, a picture for each working mode, and how many there are: Table 1 of the paper.
aspects = robot.map()
aspects.plot().savefig(folder / "five_bar_aspects.png", dpi=120)
table = collections.Counter((aspect.working_mode, aspect.determinant_sign) for aspect in aspects.aspects)
print(f"{len(aspects.aspects)} aspects, {aspects.proved_count} proved; at most {aspects.count_at_most}")
for (mode, sign), count in sorted(table.items()):
    print(f"B {mode}, det A {'+' if sign > 0 else '-'}: {count}")


# %% Two designs side by side: the largest disc that each aspect holds [m].
def discs(design, margin):
    """Radii, the largest first, of the aspects that keep this margin from parallel singularities."""
    kept = design.constrained(margin={"parallel": margin}).map(resolution=0.2)
    large = [aspect.id for aspect in kept.aspects if aspect.measure > 1.0]  # [m^2]
    return sorted((disc.lower for disc in kept.workspace("disc", large, gap=0.05)), reverse=True)


longer = robot.with_lengths({"rod_1": 5.5, "rod_2": 8.8})
margins = [0.0, 0.15, 0.3]
figure, axes = plt.subplots()
for design, name in ((robot, "paper"), (longer, "rods 10 % longer")):
    best = [discs(design, margin)[0] for margin in margins]
    axes.plot(margins, best, "o-", label=name)
    print(f"{name}: largest discs of radius", ", ".join(f"{radius:.2f}" for radius in best), "m")
axes.set_xlabel("margin of the parallel index")
axes.set_ylabel("radius of the largest disc, proved [m]")
axes.set_ylim(bottom=0)
axes.legend()
figure.savefig(folder / "five_bar_designs.png", dpi=120)
