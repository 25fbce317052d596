#!/usr/bin/env python3
"""Makes the maps of this folder, as map_server's YAML and PNG files: always the same ones, from fixed seeds.

make_maps.py            makes warehouse, office, parking and cave
make_maps.py --city DIR makes city, 4000 x 4000 cells, in DIR: it is too large to be kept with the sources
"""

import argparse
import pathlib
import random
import struct
import zlib

FREE, UNKNOWN, OCCUPIED = 254, 205, 0


class Map:
    """Cells in rows, the first one at y = 0. Lengths are in metres."""

    def __init__(self, width, height, resolution, fill=FREE):
        self.resolution = resolution
        self.columns = round(width / resolution)
        self.rows = round(height / resolution)
        self.cells = [bytearray([fill]) * self.columns for _ in range(self.rows)]

    def rectangle(self, x0, y0, x1, y1, value=OCCUPIED):
        left = max(0, round(x0 / self.resolution))
        right = min(self.columns, round(x1 / self.resolution))
        for row in range(max(0, round(y0 / self.resolution)), min(self.rows, round(y1 / self.resolution))):
            if right > left:
                self.cells[row][left:right] = bytes([value]) * (right - left)

    def frame(self, thickness, value=OCCUPIED):
        width, height = self.columns * self.resolution, self.rows * self.resolution
        self.rectangle(0, 0, width, thickness, value)
        self.rectangle(0, height - thickness, width, height, value)
        self.rectangle(0, 0, thickness, height, value)
        self.rectangle(width - thickness, 0, width, height, value)

    def write(self, folder, name, origin):
        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

        rows = b"".join(b"\0" + bytes(row) for row in reversed(self.cells))
        header = struct.pack(">IIBBBBB", self.columns, self.rows, 8, 0, 0, 0, 0)
        (folder / f"{name}.png").write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
                                             chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))
        (folder / f"{name}.yaml").write_text(
            f"# Written by make_maps.py.\nimage: {name}.png\nmode: trinary\nresolution: {self.resolution}\n"
            f"origin: [{origin[0]}, {origin[1]}, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n")


def between(source, low, high):
    return low + (high - low) * source.random()


def warehouse(folder):
    """Racks along aisles of 2.2 m, with cross aisles, pillars and pallets in the way."""
    source = random.Random(1)
    world = Map(60, 40, 0.05)
    world.frame(0.2)
    for row in range(9):
        y = 4.0 + 3.6 * row
        for first, last in ((4.0, 18.0), (21.0, 36.0), (39.0, 52.0)):
            # racks stand on feet: a lidar sees these and what is stored between them
            x = first
            while x < last:
                depth = between(source, 0.9, 1.3)
                world.rectangle(x, y + 0.7 - depth / 2, min(x + 2.6, last), y + 0.7 + depth / 2)
                x += 2.7
    for column in range(5):
        for row in range(3):
            x, y = 2.4 + 18.2 * column * 0.75, 3.0 + 14.4 * row
            world.rectangle(x, y, x + 0.5, y + 0.5)
    for _ in range(34):
        x, y = between(source, 4, 56), between(source, 1, 38)
        world.rectangle(x, y, x + 0.8, y + 1.2)
    world.write(folder, "warehouse", (-30.0, -20.0))


def office(folder):
    """Rooms on both sides of two corridors, doors of 0.9 m, desks and chairs; unknown behind the outer walls."""
    source = random.Random(2)
    world = Map(42, 26, 0.05, UNKNOWN)
    world.rectangle(1, 1, 41, 25, OCCUPIED)
    world.rectangle(1.2, 1.2, 40.8, 24.8, FREE)
    for low, high in ((1.2, 6.5), (8.5, 12.6), (13.4, 17.5), (19.5, 24.8)):
        corridor_above = low in (1.2, 13.4)
        wall = high if corridor_above else low - 0.15
        world.rectangle(1, wall, 41, wall + 0.15)
        x = 1.2
        while x < 40:
            width = min(between(source, 3.6, 6.2), 40.8 - x)
            width = 40.8 - x if 40.8 - x - width < 3 else width
            world.rectangle(x + width, low, x + width + 0.15, high)
            door = x + between(source, 0.4, width - 1.5)
            world.rectangle(door, wall - 0.05, door + 0.9, wall + 0.2, FREE)
            for _ in range(int(width / 1.6)):
                desk_x, desk_y = x + between(source, 0.3, width - 1.9), low + between(source, 0.9, high - low - 1.8)
                world.rectangle(desk_x, desk_y, desk_x + 1.4, desk_y + 0.7)
                world.rectangle(desk_x + 0.4, desk_y - 0.5, desk_x + 0.8, desk_y - 0.1)
            x += width + 0.15
    # the two halves are joined at both ends
    for x in (1.2, 38.6):
        world.rectangle(x, 6.0, x + 2.2, 20.0, FREE)
    world.write(folder, "office", (-1.0, -1.0))


def parking(folder):
    """Pairs of rows of parked cars between lanes of 6 m; one place in six is free."""
    source = random.Random(3)
    world = Map(64, 56, 0.1)
    world.frame(0.3)
    for pair in range(3):
        for back in (0, 1):
            y = 7.0 + 16.0 * pair + 5.2 * back
            for place in range(21):
                x = 4.0 + 2.6 * place
                is_taken = source.random() > 1 / 6
                along, across = between(source, 0.1, 0.4), between(source, 0.25, 0.45)
                if is_taken:
                    world.rectangle(x + across, y + along, x + across + 1.8, y + along + 4.4)
        for pillar in range(4):
            x = 13.9 + 10.4 * pillar
            world.rectangle(x, 11.8 + 16.0 * pair, x + 0.4, 12.2 + 16.0 * pair)
    world.write(folder, "parking", (0.0, 0.0))


def cave(folder):
    """A cellular automaton: a cell is rock if most cells around it are. Caves that cannot be reached are filled."""
    source = random.Random(4)
    columns, rows = 300, 200
    rock = [[source.random() < 0.455 or x in (0, columns - 1) or y in (0, rows - 1) for x in range(columns)]
            for y in range(rows)]
    for _ in range(6):
        def around(x, y):
            return sum(rock[j][i] if 0 <= i < columns and 0 <= j < rows else 1
                       for j in (y - 1, y, y + 1) for i in (x - 1, x, x + 1))
        rock = [[around(x, y) >= 5 for x in range(columns)] for y in range(rows)]
    seen = [[False] * columns for _ in range(rows)]
    largest = []
    for y in range(rows):
        for x in range(columns):
            if rock[y][x] or seen[y][x]:
                continue
            seen[y][x] = True
            region, waiting = [], [(x, y)]
            while waiting:
                i, j = waiting.pop()
                region.append((i, j))
                for k, m in ((i + 1, j), (i - 1, j), (i, j + 1), (i, j - 1)):
                    if 0 <= k < columns and 0 <= m < rows and not rock[m][k] and not seen[m][k]:
                        seen[m][k] = True
                        waiting.append((k, m))
            largest = max(largest, region, key=len)
    world = Map(60, 40, 0.1, OCCUPIED)
    for x, y in largest:
        world.rectangle(0.2 * x, 0.2 * y, 0.2 * (x + 1), 0.2 * (y + 1), FREE)
    world.write(folder, "cave", (0.0, 0.0))


def city(folder):
    """Blocks of houses with courtyards, parks with trees, and parked cars, on a square kilometre."""
    source = random.Random(5)
    world = Map(1000, 1000, 0.25)
    world.frame(1.0)
    y = 6.0
    while y < 980:
        depth = between(source, 38, 80)
        x = 6.0
        while x < 980:
            width = between(source, 38, 95)
            block(world, source, x, y, min(x + width, 992.0), min(y + depth, 992.0))
            x += width + between(source, 8, 16)
        y += depth + between(source, 8, 16)
    for _ in range(6000):
        x, y = between(source, 2, 990), between(source, 2, 990)
        world.rectangle(x, y, x + 4.5, y + 1.8) if source.random() < 0.5 else world.rectangle(x, y, x + 1.8, y + 4.5)
    # start and goal of the config
    for x, y in ((4, 4), (996, 996)):
        world.rectangle(x - 2.5, y - 2.5, x + 2.5, y + 2.5, FREE)
    world.write(folder, "city", (0.0, 0.0))


def block(world, source, x0, y0, x1, y1):
    kind = source.random()
    if kind < 0.12:
        for _ in range(int((x1 - x0) * (y1 - y0) / 90)):
            x, y = between(source, x0, x1), between(source, y0, y1)
            world.rectangle(x, y, x + 1.0, y + 1.0)
        return
    x = x0
    while x < x1:
        width = between(source, 12, 26)
        end = min(x + width, x1)
        if source.random() < 0.85:
            world.rectangle(x, y0, end, min(y0 + between(source, 10, 15), y1))
        if source.random() < 0.85:
            world.rectangle(x, max(y1 - between(source, 10, 15), y0), end, y1)
        x = end + (between(source, 2.0, 4.0) if source.random() < 0.3 else 0.0)
    for side in (x0, x1 - 12.0):
        gap = between(source, y0, y1)
        world.rectangle(side, y0, side + 12.0, max(y0, gap - 1.8))
        world.rectangle(side, gap + 1.8, side + 12.0, y1)
    if kind > 0.6 and x1 - x0 > 40 and y1 - y0 > 50:
        x, y = between(source, x0 + 16, x1 - 24), between(source, y0 + 18, y1 - 26)
        world.rectangle(x, y, x + 8, y + 8)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--city", type=pathlib.Path, metavar="DIR", help="make only the city, in this folder")
    options = parser.parse_args()
    if options.city:
        options.city.mkdir(parents=True, exist_ok=True)
        city(options.city)
        return
    folder = pathlib.Path(__file__).parent
    for make in (warehouse, office, parking, cave):
        make(folder)


if __name__ == "__main__":
    main()
