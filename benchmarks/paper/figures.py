"""The paper's figures, from the runs of ompl_mfa_paper_study, as SVG and PNG: figures.py FOLDER"""

import math
import os
import sys
from collections import defaultdict

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt
import numpy

from runs import ALGORITHMS, merit, read, runs_of, scenes_of
from tables import Study

COLOURS = {"ga": "#1f77b4", "fa": "#d95f02", "mfa": "#1b7837", "abc": "#7b3294", "sade": "#666666", "fa_long": "#e6ab02",
           "mfa_default": "#e7298a"}
# The first drawn is the widest, so that it remains visible under another one.
WIDTHS = {"ga": 5.0, "fa": 2.8, "mfa": 1.8}
ROBOT_RADIUS = 0.3
BUDGET = 30050


def save(figure, folder, name):
    for extension in ("svg", "png"):
        figure.savefig(os.path.join(folder, f"{name}.{extension}"), dpi=110, bbox_inches="tight", metadata=None)
    plt.close(figure)


def sinc(x, y):
    squared = x**2 + y**2
    return numpy.where(squared == 0.0, 1.0, numpy.sin(squared) / numpy.where(squared == 0.0, 1.0, squared))


def surface(folder):
    grid = numpy.linspace(-5.0, 5.0, 241)
    x, y = numpy.meshgrid(grid, grid)
    figure = plt.figure(figsize=(7.5, 5.2))
    axes = figure.add_subplot(projection="3d")
    # Antialiasing would leave a light seam around each of the small faces.
    axes.plot_surface(x, y, sinc(x, y), cmap="viridis", linewidth=0, antialiased=False, rcount=241, ccount=241,
                      rasterized=True)
    axes.set_box_aspect(None, zoom=0.8)
    axes.set(xlabel="x", ylabel="y", zlabel="f(x, y)", title="Eq. 19: sin(x² + y²) / (x² + y²)")
    axes.zaxis.labelpad = 6
    save(figure, folder, "paper_fig4_surface")


def populations(folder):
    points = defaultdict(list)
    shares = defaultdict(dict)
    for row in read(folder, "populations.csv"):
        points[row["algorithm"], row["run"]].append((float(row["x"]), float(row["y"])))
        shares[row["algorithm"]][row["run"]] = float(row["share"])
    grid = numpy.linspace(-5.0, 5.0, 201)
    x, y = numpy.meshgrid(grid, grid)
    figure, panels = plt.subplots(1, 2, figsize=(11, 5.4), sharey=True, layout="constrained")
    for axes, algorithm in zip(panels, ("fa", "mfa")):
        ranked = sorted(shares[algorithm], key=shares[algorithm].get)
        run = ranked[(len(ranked) - 1) // 2]
        filled = axes.contourf(x, y, sinc(x, y), levels=14, cmap="Blues")
        for layer in filled.collections:
            layer.set_rasterized(True)
        axes.plot(*zip(*points[algorithm, run]), "o", color="#d95f02", markeredgecolor="black", markersize=5,
                  markeredgewidth=0.5, label="fireflies after 50 generations")
        axes.add_patch(plt.Circle((0.0, 0.0), 0.5, fill=False, color="black", linestyle="--",
                                  label="within 0.5 of the maximum"))
        axes.set(xlabel="x", title=f"{algorithm.upper()}, median run: {100 * shares[algorithm][run]:.0f} % near the maximum",
                 aspect="equal", xlim=(-5, 5), ylim=(-5, 5))
        axes.legend(loc="lower left", fontsize=8, framealpha=0.9)
    panels[0].set_ylabel("y")
    figure.colorbar(filled, ax=panels, label="f(x, y)")
    save(figure, folder, "paper_fig5_6_populations")


def points_by(folder, name, keys):
    points = defaultdict(list)
    for row in read(folder, name):
        points[tuple(row[key] for key in keys)].append((float(row["x"]), float(row["y"])))
    return points


def grown(vertices):
    """Outline of a convex polygon grown by the robot's radius."""
    corners = numpy.array(vertices)
    area = numpy.sum(numpy.cross(corners, numpy.roll(corners, -1, axis=0)))
    corners = corners if area > 0.0 else corners[::-1]
    edges = numpy.roll(corners, -1, axis=0) - corners
    normals = numpy.arctan2(-edges[:, 0], edges[:, 1])
    outline = []
    for corner, before, after in zip(corners, numpy.roll(normals, 1), normals):
        angles = before + numpy.linspace(0.0, (after - before) % (2.0 * math.pi), 8)
        outline += [corner + ROBOT_RADIUS * numpy.array([math.cos(a), math.sin(a)]) for a in angles]
    return outline


class Scene:
    """Draws a scene and the paths through it."""

    def __init__(self, folder):
        self.runs = runs_of(folder)
        self.paths = points_by(folder, "paths.csv", ("scene", "algorithm", "run"))
        self.optima = points_by(folder, "optima.csv", ("scene",))
        self.lengths = scenes_of(folder)
        self.obstacles = defaultdict(list)
        radii = {(row["scene"], row["obstacle"]): float(row["radius"]) for row in read(folder, "obstacles.csv")}
        for (scene, obstacle), vertices in points_by(folder, "obstacles.csv", ("scene", "obstacle")).items():
            self.obstacles[scene].append((vertices, radii[scene, obstacle]))

    def draw(self, axes, scene):
        for k, (vertices, radius) in enumerate(self.obstacles[scene]):
            label, outline = ("obstacles", "the same, grown by the robot's radius") if k == 0 else (None, None)
            if len(vertices) == 1:
                axes.add_patch(plt.Circle(vertices[0], radius, color="#b0b0b0", label=label))
                axes.add_patch(plt.Circle(vertices[0], radius + ROBOT_RADIUS, fill=False, color="#b0b0b0", linestyle=":",
                                          label=outline))
            else:
                axes.add_patch(plt.Polygon(vertices, color="#b0b0b0", label=label))
                axes.add_patch(plt.Polygon(grown(vertices), fill=False, color="#b0b0b0", linestyle=":", label=outline))
        axes.set(xlim=(0, 20.3), ylim=(0, 20.3), aspect="equal", xlabel="x [m]", ylabel="y [m]")

    def draw_optimum(self, axes, scene, **style):
        axes.plot(*zip(*self.optima[scene,]), color="black", linestyle="--", linewidth=1.2, **style)

    def ranked(self, scene, algorithm):
        """Numbers of the runs, the best first; runs are numbered by row in the table, from 1."""
        costs = [merit(run) for run in self.runs[scene, algorithm]]
        return [str(i + 1) for i in numpy.argsort(costs, kind="stable")]

    def draw_path(self, axes, scene, algorithm, label=None, every=True):
        order = self.ranked(scene, algorithm)
        if every:
            for run in order:
                axes.plot(*zip(*self.paths[scene, algorithm, run]), color=COLOURS[algorithm], alpha=0.25, linewidth=0.8)
        middle = order[(len(order) - 1) // 2]
        axes.plot(*zip(*self.paths[scene, algorithm, middle]), color=COLOURS[algorithm],
                  linewidth=WIDTHS.get(algorithm, 2.2), marker="o", markersize=4, label=label)
        return merit(self.runs[scene, algorithm][int(middle) - 1])

    def ends(self, axes, scene):
        start, goal = self.optima[scene,][0], self.optima[scene,][-1]
        axes.plot(*start, "s", color="black", markersize=8, label="start", zorder=5)
        axes.plot(*goal, "*", color="black", markersize=14, label="goal", zorder=5, clip_on=False)


def versus(scene_drawing, folder, other, name):
    figure, axes = plt.subplots(figsize=(7.2, 8.2), layout="constrained")
    scene = "paper_1"
    scene_drawing.draw(axes, scene)
    optimum = scene_drawing.lengths[scene]["optimum"]
    scene_drawing.draw_optimum(axes, scene, label=f"exact optimum, {optimum:.2f} m")
    for algorithm in (other, "mfa"):
        runs = scene_drawing.runs[scene, algorithm]
        order = scene_drawing.ranked(scene, algorithm)
        middle = merit(runs[int(order[(len(order) - 1) // 2]) - 1])
        scene_drawing.draw_path(axes, scene, algorithm,
                                f"{algorithm.upper()}: median run {middle:.2f} m, all {len(runs)} runs faintly")
    scene_drawing.ends(axes, scene)
    axes.set_title(f"{other.upper()} and MFA on the paper's scene, equal evaluations")
    figure.legend(*axes.get_legend_handles_labels(), loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=2, fontsize=9)
    save(figure, folder, name)


def four_starts(scene_drawing, folder):
    figure, panels = plt.subplots(2, 2, figsize=(11, 11.6), layout="constrained")
    for i, axes in enumerate(panels.flat, 1):
        scene = f"paper_{i}"
        scene_drawing.draw(axes, scene)
        scene_drawing.draw_optimum(axes, scene, label="exact optimum")
        lengths = [f"optimum {scene_drawing.lengths[scene]['optimum']:.2f}"]
        for algorithm in ("ga", "fa", "mfa"):
            length = scene_drawing.draw_path(axes, scene, algorithm, f"{algorithm.upper()}, median run", every=False)
            lengths.append(f"{algorithm.upper()} {length:.2f}" if length < 1e6 else f"{algorithm.upper()} collides")
        scene_drawing.ends(axes, scene)
        axes.set_title(f"start {i}: " + ", ".join(lengths) + " m", fontsize=10)
    figure.legend(*panels[0, 0].get_legend_handles_labels(), loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=4)
    save(figure, folder, "paper_fig9_starts")


def convergence(folder):
    optimum = scenes_of(folder)["paper_1"]["optimum"]
    traces = defaultdict(lambda: defaultdict(dict))
    for row in read(folder, "convergence.csv"):
        if row["scene"] == "paper_1" and row["algorithm"] in COLOURS:
            traces[row["algorithm"]][int(row["run"])][int(row["hundredth"])] = float(row["cost"])
    figure, axes = plt.subplots(figsize=(8.5, 5.2), layout="constrained")
    evaluations = numpy.arange(1, 101) * BUDGET / 100
    for algorithm, runs in sorted(traces.items()):
        table = numpy.array([[run[k] for k in range(1, 101)] for run in runs.values()])
        excess = 100.0 * (numpy.where(numpy.isfinite(table), table, 1e6) / optimum - 1.0)
        low, middle, high = numpy.percentile(excess, (25, 50, 75), axis=0)
        axes.plot(evaluations, middle, color=COLOURS[algorithm], linewidth=2, label=ALGORITHMS[algorithm])
        axes.fill_between(evaluations, low, high, color=COLOURS[algorithm], alpha=0.15)
    axes.axhline(1.0, color="black", linestyle=":", linewidth=1)
    axes.annotate("1 % above the optimum", (evaluations[-1], 1.0), xytext=(0, -12), textcoords="offset points",
                  ha="right", fontsize=9)
    axes.set(xlabel="path evaluations", ylabel="best path so far, above the exact optimum [%]", yscale="log",
             ylim=(0.01, 100), xlim=(0, BUDGET), title=f"Paper's scene: median and quartiles of {len(runs)} runs")
    axes.set_yticks([0.01, 0.1, 1, 2, 5, 10, 20, 50, 100], ["0.01", "0.1", "1", "2", "5", "10", "20", "50", "100"])
    axes.legend(fontsize=9, ncols=2, loc="upper right")
    save(figure, folder, "paper_convergence")


def ranking(folder):
    study = Study(folder)
    order = sorted(study.contenders, key=study.ranks.get)
    figure, axes = plt.subplots(figsize=(8.5, 4.8), layout="constrained")
    ranks = [study.ranks[a] for a in order]
    colours = [COLOURS.get(a, "#999999") for a in order]
    axes.barh([ALGORITHMS[a] for a in order], ranks, color=colours)
    best = ranks[0]
    axes.axvspan(best, best + study.critical_difference, color="#1b7837", alpha=0.12, zorder=0,
                 label=f"not told apart from the first (critical difference {study.critical_difference:.2f})")
    axes.invert_yaxis()
    axes.set(xlabel=f"average rank over {len(study.scenes)} scenes (1 is best)", title="Ranking by mean path length")
    axes.legend(loc="upper right", fontsize=8, bbox_to_anchor=(1.0, 1.0))
    axes.set_xlim(0, max(ranks) + 3.5)
    save(figure, folder, "paper_ranks")


def main():
    folder = sys.argv[1]
    plt.rcParams["svg.hashsalt"] = "ompl_mfa"
    surface(folder)
    populations(folder)
    drawing = Scene(folder)
    versus(drawing, folder, "fa", "paper_fig7_fa_mfa")
    versus(drawing, folder, "ga", "paper_fig8_ga_mfa")
    four_starts(drawing, folder)
    convergence(folder)
    ranking(folder)


if __name__ == "__main__":
    main()
