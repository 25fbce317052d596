#!/usr/bin/env python3
"""Writes the worlds and robots of benchmarks/configs, except the paper's scene, to the folder of this file.

Each is drawn from a fixed seed: running this again changes nothing. Lengths are metres.
"""

import math
import random
from pathlib import Path

FOLDER = Path(__file__).resolve().parent


class Mesh:
    """Triangles of closed bodies, written as Wavefront OBJ."""

    def __init__(self, planar=False):
        """Bodies of a planar world also have a floor at half their height: a mesh is a surface, and a planar robot
        entirely inside would not touch it."""
        self.planar = planar
        self.vertices = []
        self.triangles = []

    def prism(self, outline, z_min, z_max):
        """A prism over a star-shaped polygon with counter-clockwise corners."""
        first = len(self.vertices)
        count = len(outline)
        centre = (sum(x for x, _ in outline) / count, sum(y for _, y in outline) / count)
        levels = [z_min, (z_min + z_max) / 2, z_max] if self.planar else [z_min, z_max]
        for z in levels:
            self.vertices += [*((x, y, z) for x, y in outline), (*centre, z)]
        top = first + (len(levels) - 1) * (count + 1)
        for i in range(count):
            j = (i + 1) % count
            self.triangles += [(first + i, first + j, top + j), (first + i, top + j, top + i)]
            for level in range(len(levels)):
                base = first + level * (count + 1)
                ends = (base + i, base + j) if level > 0 else (base + j, base + i)
                self.triangles.append((*ends, base + count))

    def box(self, lower, upper):
        (x0, y0, z0), (x1, y1, z1) = lower, upper
        self.prism([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], z0, z1)

    def octahedron(self, centre, axes):
        """The convex hull of centre +- axis for three axes."""
        first = len(self.vertices)
        for axis in axes:
            for sign in (1, -1):
                self.vertices.append(tuple(c + sign * a for c, a in zip(centre, axis)))
        for i in (0, 1):
            for j in (2, 3):
                for k in (4, 5):
                    face = (i, j, k) if (i + j + k) % 2 == 0 else (i, k, j)
                    self.triangles.append(tuple(first + corner for corner in face))

    def write(self, name, comment):
        lines = [f"# {comment}", "# Written by make_worlds.py."]
        lines += ["v " + " ".join(f"{value:.6g}" for value in vertex) for vertex in self.vertices]
        lines += ["f " + " ".join(str(corner + 1) for corner in triangle) for triangle in self.triangles]
        (FOLDER / name).write_text("\n".join(lines) + "\n")


def write_scene(name, comment, objects):
    """objects: (id, type, dimensions, position, rotation about z)."""
    lines = [f"# {comment}", "# Written by make_worlds.py.", "world:", "  collision_objects:"]
    for identity, kind, dimensions, position, angle in objects:
        sizes = ", ".join(f"{value:.6g}" for value in dimensions)
        place = ", ".join(f"{value:.6g}" for value in position)
        lines += [
            f"    - id: {identity}",
            f"      primitives: [{{type: {kind}, dimensions: [{sizes}]}}]",
            f"      primitive_poses: [{{position: [{place}],"
            f" orientation: [0, 0, {math.sin(angle / 2):.9g}, {math.cos(angle / 2):.9g}]}}]",
        ]
    (FOLDER / name).write_text("\n".join(lines) + "\n")


def disc(identity, x, y, radius):
    return (identity, "cylinder", (1.0, radius), (x, y, 0.0), 0.0)


def wall(identity, x0, y0, x1, y1):
    return (identity, "box", (x1 - x0, y1 - y0, 1.0), ((x0 + x1) / 2, (y0 + y1) / 2, 0.0), 0.0)


def circle_field():
    """Random discs, each with a gap of at least 0.12 to the others, to the start and to the goal."""
    draw = random.Random(20)
    discs = []
    ends = [(0.5, 0.5), (9.5, 9.5)]
    while len(discs) < 70:
        x, y, radius = draw.uniform(0, 10), draw.uniform(0, 10), draw.uniform(0.2, 0.62)
        apart = all(math.hypot(x - a, y - b) > radius + r + 0.12 for a, b, r in discs)
        clear = all(math.hypot(x - a, y - b) > radius + 0.4 for a, b in ends)
        if apart and clear:
            discs.append((x, y, radius))
    write_scene("circle_field.yaml", "70 discs, 10 m x 10 m; many narrow homotopy classes.",
                [disc(f"disc_{i}", *values) for i, values in enumerate(discs)])


def box_field():
    draw = random.Random(5)
    objects = []
    while len(objects) < 35:
        x, y = draw.uniform(0.5, 9.5), draw.uniform(0.5, 9.5)
        size = (draw.uniform(0.5, 1.8), draw.uniform(0.2, 0.9), 1.0)
        reach = math.hypot(size[0], size[1]) / 2 + 0.45
        if min(math.hypot(x - 0.6, y - 5), math.hypot(x - 9.4, y - 5)) > reach:
            objects.append((f"box_{len(objects)}", "box", size, (x, y, 0.0), draw.uniform(0, math.pi)))
    write_scene("box_field.yaml", "35 turned boxes, 10 m x 10 m; some overlap and close passages.", objects)


def dividing_walls():
    """Walls between start and goal, each with one wide gap far off the straight line and one narrow gap near it."""
    draw = random.Random(3)
    objects = []
    for number, x in enumerate((2.0, 4.0, 6.0, 8.0)):
        narrow = 5.0 + draw.uniform(-1.0, 1.0)
        wide = 1.2 if number % 2 == 0 else 8.8
        cuts = sorted([(narrow - 0.13, narrow + 0.13), (wide - 0.5, wide + 0.5)])
        bottom = 0.0
        for index, (low, high) in enumerate([*cuts, (10.0, 10.0)]):
            objects.append(wall(f"wall_{number}_{index}", x - 0.15, bottom, x + 0.15, low))
            bottom = high
    write_scene("dividing_walls.yaml", "Four walls, each with a narrow gap near the straight line and a wide one off it.",
                objects)


def double_enclosure():
    """Start and goal each in a box that is open on the side away from the other."""
    objects = []
    for name, x, back in (("start", 2.5, -1), ("goal", 7.5, 1)):
        front = x - back * 1.0
        objects += [
            wall(f"{name}_front", front - 0.1, 3.5, front + 0.1, 6.5),
            wall(f"{name}_below", x - 1.1, 3.4, x + 1.1, 3.6),
            wall(f"{name}_above", x - 1.1, 6.4, x + 1.1, 6.6),
        ]
        rear = x + back * 1.0
        objects += [wall(f"{name}_rear_below", rear - 0.1, 3.5, rear + 0.1, 4.75),
                    wall(f"{name}_rear_above", rear - 0.1, 5.25, rear + 0.1, 6.5)]
    write_scene("double_enclosure.yaml", "Two enclosures whose openings look away from each other.", objects)


def bubbles():
    draw = random.Random(11)
    balls = []
    ends = [(0.7, 0.7, 0.7), (9.3, 9.3, 9.3)]
    while len(balls) < 120:
        centre = tuple(draw.uniform(0, 10) for _ in range(3))
        radius = draw.uniform(0.6, 1.3)
        if all(math.dist(centre, end) > radius + 0.6 for end in ends):
            balls.append((f"ball_{len(balls)}", "sphere", (radius,), centre, 0.0))
    write_scene("bubbles.yaml", "120 balls, 10 m x 10 m x 10 m.", balls)


def rooms():
    """Rooms for an L-shaped robot, with doors that it passes straight, rotated, or not at all."""
    world = Mesh(planar=True)
    height = (0.0, 1.0)

    def block(x0, y0, x1, y1):
        world.box((x0, y0, height[0]), (x1, y1, height[1]))

    def wall_with_doors(along, fixed, low, high, doors):
        bottom = low
        for centre, width in [*sorted(doors), (high, 0.0)]:
            top = centre - width / 2
            if top > bottom:
                if along == "y":
                    block(fixed - 0.1, bottom, fixed + 0.1, top)
                else:
                    block(bottom, fixed - 0.1, top, fixed + 0.1)
            bottom = centre + width / 2

    for corners in ((-0.2, -0.2, 20.2, 0), (-0.2, 15, 20.2, 15.2), (-0.2, 0, 0, 15), (20, 0, 20.2, 15)):
        block(*corners)
    wall_with_doors("y", 5.0, 0, 15, [(2.5, 1.6), (9.5, 1.25), (13.2, 2.2)])
    wall_with_doors("y", 10.0, 0, 15, [(4.0, 1.3), (12.0, 2.0)])
    wall_with_doors("y", 15.0, 0, 15, [(2.0, 2.2), (7.5, 1.25), (13.5, 1.5)])
    wall_with_doors("x", 7.0, 0, 5.0, [(2.5, 2.0)])
    wall_with_doors("x", 7.0, 5.0, 10.0, [(7.5, 1.4)])
    wall_with_doors("x", 6.0, 10.0, 15.0, [(12.2, 1.8)])
    wall_with_doors("x", 9.0, 15.0, 20.0, [(18.0, 1.8)])
    draw = random.Random(8)
    for x, y in ((2.4, 4.6), (7.5, 3.2), (7.4, 10.5), (12.6, 8.6), (12.4, 2.4), (17.6, 5.2), (17.2, 11.8)):
        angle = draw.uniform(0, math.pi)
        corners = [(0.55, 0.3), (-0.55, 0.3), (-0.55, -0.3), (0.55, -0.3)]
        world.prism([(x + math.cos(angle) * a - math.sin(angle) * b, y + math.sin(angle) * a + math.cos(angle) * b)
                     for a, b in corners], *height)
    world.write("rooms.obj", "A floor of 20 m x 15 m with rooms, doors of several widths and furniture.")

    robot = Mesh()
    robot.box((0, 0, 0.2), (1.8, 0.4, 0.8))
    robot.box((0, 0.4, 0.2), (0.4, 1.3, 0.8))
    robot.write("l_robot.obj", "An L of 1.8 m x 1.3 m, arms 0.4 m wide.")


def slalom():
    """Staggered plates that a long bar passes by rotating between them."""
    world = Mesh(planar=True)
    for corners in ((0, -0.2, 16, 0), (0, 8, 16, 8.2), (-0.2, -0.2, 0, 8.2), (16, -0.2, 16.2, 8.2)):
        world.box((corners[0], corners[1], 0), (corners[2], corners[3], 1))
    for number, x in enumerate((4.0, 7.4, 10.8, 13.6)):
        low, high = (3.0, 7.2) if number % 2 == 0 else (0.2, 4.8)
        world.box((x - 0.15, low, 0), (x + 0.15, high, 1))
    world.write("slalom.obj", "Four plates in a hall of 16 m x 8 m: two have a gap on either side, two on one.")
    robot = Mesh()
    robot.box((-1.25, -0.15, 0.2), (1.25, 0.15, 0.8))
    robot.write("bar.obj", "A bar of 2.5 m x 0.3 m.")


def street():
    """Parallel parking: two rows of parked cars with one free space."""
    world = Mesh(planar=True)
    draw = random.Random(2)
    world.box((-0.2, -0.4, 0), (30.2, 0, 1))
    world.box((-0.2, 9, 0), (30.2, 9.4, 1))
    for row, y in ((0, 1.15), (1, 7.85)):
        x = 2.6
        for place in range(5):
            if row == 1 or place != 2:
                length, width, turn = 4.2, 1.75, draw.uniform(-0.03, 0.03)
                corners = [(length / 2, width / 2), (-length / 2, width / 2), (-length / 2, -width / 2),
                           (length / 2, -width / 2)]
                world.prism([(x + math.cos(turn) * a - math.sin(turn) * b, y + math.sin(turn) * a + math.cos(turn) * b)
                             for a, b in corners], 0.0, 1.0)
            x += 6.2
    world.write("street.obj", "A street of 30 m x 9 m with parked cars and one free place of 6.2 m + 2 m.")
    robot = Mesh()
    robot.box((-2.1, -0.88, 0.2), (2.1, 0.88, 0.8))
    robot.write("car.obj", "A car of 4.2 m x 1.76 m; it turns about its middle.")


def yard():
    draw = random.Random(14)
    world = Mesh(planar=True)
    ends = [(4.0, 4.0), (46.0, 46.0)]
    made = 0
    while made < 26:
        x, y, size = draw.uniform(3, 47), draw.uniform(3, 47), draw.uniform(1.5, 4.0)
        if min(math.dist((x, y), end) for end in ends) < size + 6.0:
            continue
        count = draw.randint(3, 7)
        angles = sorted(2 * math.pi * (i + draw.uniform(0.1, 0.9)) / count for i in range(count))
        world.prism([(x + size * math.cos(a), y + size * math.sin(a)) for a in angles], 0.0, 1.0)
        made += 1
    world.write("yard.obj", "26 polygons in a yard of 50 m x 50 m.")


def windows():
    """Three walls between start and goal, with windows of different sizes and positions; the plank has to rotate for
    most of them."""
    world = Mesh()
    openings = {
        4.0: [((1.0, 5.5), (3.4, 6.1)), ((6.2, 1.2), (7.8, 2.8))],
        8.0: [((1.0, 1.0), (1.7, 3.6)), ((5.0, 6.0), (8.4, 6.8))],
        12.0: [((4.2, 3.6), (5.8, 5.2)), ((0.8, 6.6), (3.6, 7.3)), ((7.6, 0.8), (8.3, 3.4))],
    }
    for x, holes in openings.items():
        ys = sorted({0.0, 9.0, *(value for hole in holes for value in (hole[0][0], hole[1][0]))})
        zs = sorted({0.0, 8.0, *(value for hole in holes for value in (hole[0][1], hole[1][1]))})
        for y0, y1 in zip(ys, ys[1:]):
            bottom = None
            for z0, z1 in zip(zs, zs[1:]):
                y, z = (y0 + y1) / 2, (z0 + z1) / 2
                open_here = any(h[0][0] < y < h[1][0] and h[0][1] < z < h[1][1] for h in holes)
                if not open_here and bottom is None:
                    bottom = z0
                if open_here and bottom is not None:
                    world.box((x - 0.1, y0, bottom), (x + 0.1, y1, z0))
                    bottom = None
            if bottom is not None:
                world.box((x - 0.1, y0, bottom), (x + 0.1, y1, 8.0))
    world.write("windows.obj", "Three walls with seven windows in a hall of 16 m x 9 m x 8 m.")
    robot = Mesh()
    robot.box((-1.0, -0.5, -0.12), (1.0, 0.5, 0.12))
    robot.write("plank.obj", "A plank of 2 m x 1 m x 0.24 m.")


def asteroids():
    draw = random.Random(7)
    world = Mesh()
    ends = [(1.6, 1.6, 1.6), (18.4, 18.4, 18.4)]
    made = 0
    while made < 90:
        centre = tuple(draw.uniform(0.5, 19.5) for _ in range(3))
        size = draw.uniform(0.9, 2.3)
        if min(math.dist(centre, end) for end in ends) < size + 1.9:
            continue
        first = [draw.gauss(0, 1) for _ in range(3)]
        second = [draw.gauss(0, 1) for _ in range(3)]
        third = [first[1] * second[2] - first[2] * second[1], first[2] * second[0] - first[0] * second[2],
                 first[0] * second[1] - first[1] * second[0]]
        second = [third[1] * first[2] - third[2] * first[1], third[2] * first[0] - third[0] * first[2],
                  third[0] * first[1] - third[1] * first[0]]
        axes = []
        for axis in (first, second, third):
            length = math.hypot(*axis)
            scale = size * draw.uniform(0.6, 1.0) / length
            axes.append([scale * value for value in axis])
        world.octahedron(centre, axes)
        made += 1
    world.write("asteroids.obj", "90 turned octahedra in a cube of 20 m.")
    robot = Mesh()
    robot.box((-0.35, -0.35, -0.35), (0.35, 0.35, 0.35))
    robot.box((-0.3, 0.35, -0.05), (0.3, 1.7, 0.05))
    robot.box((-0.3, -1.7, -0.05), (0.3, -0.35, 0.05))
    robot.write("satellite.obj", "A satellite with two panels: 0.7 m x 3.4 m x 0.7 m.")


if __name__ == "__main__":
    circle_field()
    box_field()
    dividing_walls()
    double_enclosure()
    bubbles()
    rooms()
    slalom()
    street()
    yard()
    windows()
    asteroids()
