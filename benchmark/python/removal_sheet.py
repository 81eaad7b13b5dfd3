"""Makes a sheet of meshes before and after their handles are removed, to be looked at.

    python3 benchmark/python/removal_sheet.py --htloops build/bin/htloops -o sheet.png MESH...

MESH:PAIR removes only this pair, and shows it from close by. Both pictures of a mesh are seen from the
same side, the one of some from which most of what is changed is seen. Faces that are taken away are
red, those that are new are green. What is odd at --size 130 is odd for all to see; --size 500 shows
the faces. Needs NumPy, SciPy and Pillow.
"""

import argparse
import itertools
import json
import pathlib
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor

import mesh_drawing
import numpy as np
from PIL import Image, ImageDraw, ImageFont
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

KEPT, AWAY, NEW = (0.78, 0.82, 0.88), (0.93, 0.50, 0.42), (0.55, 0.80, 0.45)
SMALL = 192


class Change:
    """A mesh before and after, and which faces are in one of them alone."""

    def __init__(self, before, after, genus):
        self.meshes = before, after
        self.genus = genus
        self.changed = faces_apart(before, after)
        self.groups = [group_of_faces(*mesh, own) for mesh, own in zip(self.meshes, self.changed)]


def faces_apart(before, after):
    """For either mesh, which faces are not in the other, by the coordinates of their corners."""
    points = np.vstack([before[0], after[0]])
    number = np.unique(points, axis=0, return_inverse=True)[1].reshape(-1)
    faces = np.vstack([before[1], after[1] + len(before[0])])
    corners = np.sort(number[faces], axis=1)
    _, kind, count = np.unique(corners, axis=0, return_inverse=True, return_counts=True)
    alone = count[kind.reshape(-1)] == 1
    return alone[: len(before[1])], alone[len(before[1]) :]


def group_of_faces(points, faces, chosen):
    """For each face that is chosen the number of what is connected with it; -1 for others."""
    corners = faces[chosen]
    ends = np.concatenate([corners[:, :2], corners[:, 1:]])
    links = coo_matrix((np.ones(len(ends)), ends.T), shape=(len(points), len(points)))
    group = np.full(len(faces), -1)
    group[chosen] = connected_components(links, directed=False)[1][corners[:, 0]]
    return group


def removed(htloops, mesh, pair, folder):
    """What the removal does to a mesh; None, and a word about it, if it cannot be done."""
    before, after, report = (folder / name for name in ("before.off", "after.off", "report.json"))
    command = [htloops, "remove", mesh, "-q", "-o", after, "--write-mesh", before]
    command += ["--report", report] + (["--pairs", pair] if pair else ["--all"])
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode != 0:
        print(f"{mesh}: {done.stderr.strip()}")
        return None
    said = json.loads(report.read_text())
    meshes = [mesh_drawing.read_off(path) for path in (before, after)]
    return Change(*meshes, (said["genus_before"], said["genus_after"]))


def score(change, view):
    """How much is seen of what is changed, each place by the root of its pixels."""
    total = 0.0
    for mesh, group in zip(change.meshes, change.groups):
        seen, _ = mesh_drawing.what_is_seen(*mesh, view)
        places = group[seen[seen >= 0]]
        total += np.sqrt(np.bincount(places[places >= 0])).sum()
    return total


def in_frame(change, closely):
    """The points that are to be in the picture: all, or those of what is changed, with a margin."""
    everything = np.vstack([points for points, _ in change.meshes])
    changed = [
        points[faces[own]].reshape(-1, 3)
        for (points, faces), own in zip(change.meshes, change.changed)
    ]
    if not closely or sum(map(len, changed)) == 0:
        return everything
    low, high = np.vstack(changed).min(axis=0), np.vstack(changed).max(axis=0)
    margin = 0.25 * np.linalg.norm(high - low)
    return np.array(list(itertools.product(*zip(low - margin, high + margin))))


def tile(change, size, closely):
    """Both pictures side by side."""
    frame = in_frame(change, closely)
    small = [mesh_drawing.View(way, frame, SMALL) for way in mesh_drawing.DIRECTIONS]
    scores = [score(change, view) for view in small]
    best = mesh_drawing.DIRECTIONS[int(np.argmax(scores))]
    view = mesh_drawing.View(best, frame, 2 * size)
    pictures = [
        mesh_drawing.drawing(*mesh, view, np.where(own[:, None], colour, KEPT))
        for mesh, own, colour in zip(change.meshes, change.changed, (AWAY, NEW))
    ]
    return Image.fromarray((255 * np.hstack(pictures)).astype(np.uint8))


def titled(picture, title, font):
    """The picture with a line of text above it and a white border."""
    line, border = int(1.5 * font.size), font.size // 2
    whole = Image.new("RGB", (picture.width + 2 * border, picture.height + line), "white")
    whole.paste(picture, (border, line))
    ImageDraw.Draw(whole).text((border, line // 6), title, "black", font)
    return whole


def draw_one(wanted, name):
    path, _, pair = name.partition(":")
    with tempfile.TemporaryDirectory() as folder:
        change = removed(wanted.htloops, path, pair, pathlib.Path(folder))
    if change is None:
        return None
    name = pathlib.Path(path).stem + (f" pair {pair}" if pair else "")
    title = f"{name}  genus {change.genus[0]} \u2192 {change.genus[1]}"
    font = ImageFont.truetype("DejaVuSans.ttf", max(11, wanted.size // 18))
    print(title, flush=True)
    return titled(tile(change, wanted.size, bool(pair)), title, font)


def sheet(tiles, columns):
    width, height = tiles[0].size
    rows = -(-len(tiles) // columns)
    whole = Image.new("RGB", (min(columns, len(tiles)) * width, rows * height), "white")
    for i, picture in enumerate(tiles):
        whole.paste(picture, (i % columns * width, i // columns * height))
    return whole


def options():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("meshes", nargs="+", metavar="MESH[:PAIR]")
    parser.add_argument("--htloops", default="build/bin/htloops", help="the tool")
    parser.add_argument("-o", "--output", default="sheet.png", help="the sheet, as PNG")
    parser.add_argument("--columns", type=int, default=4, help="meshes in a row")
    parser.add_argument("--size", type=int, default=400, help="of one picture, in pixels")
    parser.add_argument("--colours", type=int, help="at most so many, for a smaller file")
    parser.add_argument("--jobs", type=int, default=1, help="meshes at a time")
    return parser.parse_args()


def main():
    wanted = options()
    with ThreadPoolExecutor(wanted.jobs) as pool:
        tiles = list(pool.map(lambda name: draw_one(wanted, name), wanted.meshes))
    tiles = [picture for picture in tiles if picture is not None]
    if not tiles:
        raise SystemExit("no mesh could be drawn")
    whole = sheet(tiles, wanted.columns)
    if wanted.colours:
        whole = whole.quantize(wanted.colours, dither=Image.Dither.NONE)
    whole.save(wanted.output, optimize=True)


if __name__ == "__main__":
    main()
