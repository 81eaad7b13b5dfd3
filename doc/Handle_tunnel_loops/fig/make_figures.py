#!/usr/bin/env python3
"""Writes the drawings of the manual, as SVG files, into the folder of this script.

Nothing but the standard library is needed. To look at one: rsvg-convert -z 2 FILE.svg -o FILE.png
"""

import heapq
import math
import os

FOLDER = os.path.dirname(os.path.abspath(__file__))
RED, BLUE, DARK, PALE = "#c8202c", "#1c68b8", "#30363f", "#8a93a0"
ORANGE = "#d55e00"  # of handle loops
GREY, WARM = (196, 204, 216), "#f0a030"
FONT = "font-family='Helvetica,Arial,sans-serif'"


class Svg:
    def __init__(self, name, width, height):
        self.name, self.size, self.parts = name, (width, height), []

    def add(self, text):
        self.parts.append(text)

    def line(self, points, color, width=2.0, closed=False, dash=None, opacity=1.0, fill="none"):
        data = "M" + "L".join("%.1f %.1f" % p for p in points) + ("Z" if closed else "")
        style = " stroke-dasharray='%s'" % dash if dash else ""
        style += " opacity='%.2f'" % opacity if opacity < 1 else ""
        self.add("<path d='%s' fill='%s' stroke='%s' stroke-width='%.1f' "
                 "stroke-linejoin='round' stroke-linecap='round'%s/>" %
                 (data, fill, color, width, style))

    def area(self, points, color, opacity):
        data = "M" + "L".join("%.1f %.1f" % p for p in points) + "Z"
        self.add("<path d='%s' fill='%s' fill-opacity='%.2f'/>" % (data, color, opacity))

    def text(self, x, y, words, size=13, color=DARK, anchor="middle", weight="normal"):
        for i, line in enumerate(words.split("\n")):
            self.add("<text x='%.1f' y='%.1f' font-size='%d' fill='%s' text-anchor='%s' "
                     "font-weight='%s' %s>%s</text>" %
                     (x, y + 1.25 * size * i, size, color, anchor, weight, FONT, line))

    def dot(self, p, color, radius=3.5, opacity=1.0):
        self.add("<circle cx='%.1f' cy='%.1f' r='%.1f' fill='%s' stroke='#fff' "
                 "stroke-width='1' opacity='%.2f'/>" % (p[0], p[1], radius, color, opacity))

    def box(self, x, y, w, h, fill, stroke=DARK):
        self.add("<rect x='%.1f' y='%.1f' width='%.1f' height='%.1f' rx='6' fill='%s' "
                 "stroke='%s' stroke-width='1.2'/>" % (x, y, w, h, fill, stroke))

    def arrow(self, a, b, color=DARK, width=1.6):
        d = math.hypot(b[0] - a[0], b[1] - a[1])
        ux, uy = (b[0] - a[0]) / d, (b[1] - a[1]) / d
        back = (b[0] - 8 * ux, b[1] - 8 * uy)
        self.line([a, back], color, width)
        self.area([b, (back[0] - 4 * uy, back[1] + 4 * ux), (back[0] + 4 * uy, back[1] - 4 * ux)],
                  color, 1.0)

    def write(self):
        with open(os.path.join(FOLDER, self.name), "w", encoding="utf-8") as f:
            f.write("<svg xmlns='http://www.w3.org/2000/svg' width='%d' height='%d' "
                    "viewBox='0 0 %d %d'>\n" % (self.size * 2))
            f.write("<rect width='100%' height='100%' fill='#fff'/>\n")
            f.write("\n".join(self.parts) + "\n</svg>\n")


class Torus:
    """A ring, seen obliquely from above, and a field on it."""

    NU, NV = 96, 36

    def __init__(self, tube=0.42, elevation=52):
        self.r = tube
        self.e = math.radians(elevation)

    def point(self, u, v, push=0.0):
        r = self.r + push
        d = 1.0 + r * math.cos(v)
        return (d * math.cos(u), d * math.sin(u), r * math.sin(v))

    def facing(self, u, v):
        n = (math.cos(v) * math.cos(u), math.cos(v) * math.sin(u), math.sin(v))
        return -n[1] * math.cos(self.e) + n[2] * math.sin(self.e)

    def light(self, u, v):
        n = (math.cos(v) * math.cos(u), math.cos(v) * math.sin(u), math.sin(v))
        return max(0.0, -0.35 * n[0] - 0.3 * n[1] + 0.88 * n[2])

    def place(self, center, scale):
        def screen(p):
            up = p[1] * math.sin(self.e) + p[2] * math.cos(self.e)
            return (center[0] + scale * p[0], center[1] - scale * up)
        return screen

    def cell(self, i, j):
        return (2 * math.pi * i / self.NU, 2 * math.pi * j / self.NV)

    @staticmethod
    def polygon(corners):
        """A path with short relative steps, in tenths."""
        p = [(round(10 * x), round(10 * y)) for x, y in corners]
        return "M%d %dl" % p[0] + " ".join(
            "%d %d" % (b[0] - a[0], b[1] - a[1]) for a, b in zip(p, p[1:])) + "z"

    def draw(self, svg, screen, opacity=1.0, step=2):
        """The ring, in quadrilaterals of step x step cells."""
        shapes = {}
        for i in range(0, self.NU, step):
            for j in range(0, self.NV, step):
                u, v = self.cell(i + step / 2, j + step / 2)
                if self.facing(u, v) <= -0.1:
                    continue
                shade = round(48 * (0.62 + 0.43 * self.light(u, v))) / 48
                color = "#%02x%02x%02x" % tuple(min(255, int(c * shade)) for c in GREY)
                corners = [screen(self.point(*self.cell(i + step * a, j + step * b)))
                           for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
                shapes.setdefault(color, []).append(self.polygon(corners))
        group = "".join("<path d='%s' fill='%s' stroke='%s' stroke-width='8'/>\n" %
                        ("".join(paths), c, c) for c, paths in shapes.items())
        svg.add("<g transform='scale(.1)' opacity='%.2f'>\n%s</g>" % (opacity, group))

    def triangles(self):
        for i in range(self.NU):
            for j in range(self.NV):
                for corners in (((0, 0), (1, 0), (1, 1)), ((0, 0), (1, 1), (0, 1))):
                    yield [(i + a, j + b) for a, b in corners]

    def covered(self, svg, screen, d, level):
        """What lies below a level, as one pale area."""
        at = lambda k: d[(k[0] % self.NU, k[1] % self.NV)] - level
        paths = []
        done = set()
        for i in range(0, self.NU, 2):  # whole quadrilaterals of the drawing
            for j in range(0, self.NV, 2):
                block = [(i, j), (i + 2, j), (i + 2, j + 2), (i, j + 2)]
                inner = [(i + a, j + b) for a in range(3) for b in range(3)]
                if self.facing(*self.cell(i + 1, j + 1)) <= -0.1 or all(at(k) > 0 for k in inner):
                    done.update((i + a, j + b) for a in (0, 1) for b in (0, 1))
                elif all(at(k) <= 0 for k in inner):
                    done.update((i + a, j + b) for a in (0, 1) for b in (0, 1))
                    paths.append(self.polygon([screen(self.point(*self.cell(*k))) for k in block]))
        for i in range(self.NU):
            for j in range(self.NV):
                if (i, j) in done:
                    continue
                cell = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                for t in (cell[:3], [cell[0], cell[2], cell[3]]):
                    kept = []
                    for k, l in zip(t, t[1:] + t[:1]):
                        x, y = at(k), at(l)
                        if x <= 0:
                            kept.append(k)
                        if x * y < 0:
                            r = x / (x - y)
                            kept.append((k[0] + r * (l[0] - k[0]), k[1] + r * (l[1] - k[1])))
                    if len(kept) > 2:
                        paths.append(
                            self.polygon([screen(self.point(*self.cell(*k))) for k in kept]))
        svg.add("<g transform='scale(.1)' opacity='0.55'>"
                "<path d='%s' fill='%s' stroke='%s' stroke-width='6'/></g>" %
                ("".join(paths), WARM, WARM))

    def curve(self, svg, screen, places, color, width=2.6):
        """Hidden parts are pale."""
        for is_visible in (False, True):
            run = []
            for (u, v), (u2, v2) in zip(places, places[1:]):
                if (self.facing((u + u2) / 2, (v + v2) / 2) > 0) == is_visible:
                    run = run or [screen(self.point(u, v))]
                    run.append(screen(self.point(u2, v2)))
                elif run:
                    self.piece(svg, run, color, width, is_visible)
                    run = []
            if run:
                self.piece(svg, run, color, width, is_visible)

    @staticmethod
    def piece(svg, run, color, width, is_visible):
        svg.line(run, color, width if is_visible else width * 0.8, opacity=1 if is_visible else 0.4,
                 dash=None if is_visible else "4 4")

    def handle(self, u):
        return [(u, 2 * math.pi * k / 72) for k in range(73)]

    def tunnel(self, v=math.pi):
        return [(2 * math.pi * k / 144, v) for k in range(145)]

    def distances(self, seed):
        """Geodesic distances by Dijkstra's algorithm, with steps in 32 directions."""
        steps = [(a, b) for a in range(-3, 4) for b in range(-3, 4) if math.gcd(a, b) == 1]
        points = {(i, j): self.point(*self.cell(i, j))
                  for i in range(self.NU) for j in range(self.NV)}
        best, queue = {seed: 0.0}, [(0.0, seed)]
        while queue:
            d, (i, j) = heapq.heappop(queue)
            if d > best[(i, j)]:
                continue
            for a, b in steps:
                k = ((i + a) % self.NU, (j + b) % self.NV)
                e = d + math.dist(points[(i, j)], points[k])
                if e < best.get(k, math.inf):
                    best[k] = e
                    heapq.heappush(queue, (e, k))
        return best

    def contour(self, svg, screen, d, level, color):
        """The pieces of a contour in the triangles of the grid."""
        paths = {True: [], False: []}
        for t in self.triangles():
            ends = []
            for k, l in zip(t, t[1:] + t[:1]):
                x = d[(k[0] % self.NU, k[1] % self.NV)] - level
                y = d[(l[0] % self.NU, l[1] % self.NV)] - level
                if x * y < 0:
                    r = x / (x - y)
                    ends.append(self.cell(k[0] + r * (l[0] - k[0]), k[1] + r * (l[1] - k[1])))
            if len(ends) == 2:
                u, v = (ends[0][0] + ends[1][0]) / 2, (ends[0][1] + ends[1][1]) / 2
                paths[self.facing(u, v) > 0].append(
                    "M%.1f %.1fL%.1f %.1f" % sum((screen(self.point(*e)) for e in ends), ()))
        for is_visible, style in ((False, "1.6' opacity='0.35"), (True, "2.8")):
            svg.add("<path d='%s' fill='none' stroke='%s' stroke-linecap='round' "
                    "stroke-width='%s'/>" % ("".join(paths[is_visible]), color, style))


def definitions():
    svg, torus = Svg("definitions.svg", 720, 300), Torus()
    screen = torus.place((360, 150), 116)
    torus.draw(svg, screen)
    u = math.radians(-38)
    handle, tunnel = torus.handle(u), torus.tunnel()
    svg.area([screen(torus.point(*p)) for p in tunnel], BLUE, 0.22)
    svg.area([screen(torus.point(*p)) for p in handle], ORANGE, 0.30)
    torus.curve(svg, screen, tunnel, BLUE)
    torus.curve(svg, screen, handle, ORANGE)
    crossing = screen(torus.point(u, math.pi))
    svg.dot(crossing, DARK, 4)
    svg.text(640, 196, "handle loop", 16, ORANGE, "middle", "bold")
    svg.text(640, 216, "its disk lies\nin the solid", 13)
    svg.line([(586, 202), screen(torus.point(u, 0.25))], ORANGE, 1)
    svg.text(86, 74, "tunnel loop", 16, BLUE, "middle", "bold")
    svg.text(86, 94, "its disk lies outside,\nacross the hole", 13)
    svg.line([(142, 72), screen(torus.point(math.radians(140), math.pi))], BLUE, 1)
    svg.text(610, 60, "they cross once", 13)
    svg.line([(566, 66), crossing], DARK, 1)
    svg.write()


def fronts():
    svg, torus = Svg("fronts.svg", 760, 230), Torus()
    seed = (3 * torus.NU // 4, 0)
    d = torus.distances(seed)
    split = d[(3 * torus.NU // 4, torus.NV // 2)]
    meeting = d[(torus.NU // 4, torus.NV // 2)]
    panels = [(0.62 * split, "1  A front grows", "from the seed."),
              (1.16 * split, "2  It meets itself behind", "the tube, and splits."),
              (0.78 * meeting, "3  Each part moves", "around the tube."),
              (1.0 * meeting, "4  They merge: a handle.", "")]
    for k, (level, first, second) in enumerate(panels):
        screen = torus.place((95 + 190 * k, 92), 62)
        torus.draw(svg, screen)
        torus.covered(svg, screen, d, level)
        torus.contour(svg, screen, d, level, RED)
        svg.dot(screen(torus.point(*torus.cell(*seed))), DARK, 3)
        if k == 3:
            svg.dot(screen(torus.point(math.pi / 2, math.pi)), RED, 4.5)
        svg.text(95 + 190 * k, 186, first, 13)
        svg.text(95 + 190 * k, 203, second or "Just before, each part", 13)
        if not second:
            svg.text(95 + 190 * k, 220, "is a handle loop.", 13)
    svg.write()


class Strip:
    """An unrolled tube of triangles: the left side is the right side."""

    NX, NY, W, H = 8, 4, 216.0, 130.0

    def __init__(self):
        self.vertex = {}
        for i in range(self.NX + 1):
            for j in range(self.NY + 1):
                k = i % self.NX
                dx = 5 * math.sin(2.3 * k + 1.7 * j) if 0 < k else 0
                dy = 5 * math.cos(1.9 * k + 2.9 * j) if 0 < j < self.NY else 0
                self.vertex[(i, j)] = (i * self.W / self.NX + dx, j * self.H / self.NY + dy)
        self.triangles = []
        for i in range(self.NX):
            for j in range(self.NY):
                a, b, c, e = (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)
                self.triangles += [(a, b, c), (a, c, e)] if (i + j) % 2 else [(a, b, e), (b, c, e)]

    def find(self, p):
        for t in self.triangles:
            a, b, c = (self.vertex[k] for k in t)
            s = [(q[0] - o[0]) * (p[1] - o[1]) - (q[1] - o[1]) * (p[0] - o[0])
                 for o, q in ((a, b), (b, c), (c, a))]
            if min(s) >= -1e-9 or max(s) <= 1e-9:
                return t
        return None

    def passed(self, curve):
        """The triangles that a curve passes."""
        strip = []
        for k in range(4001):
            t = self.find(curve(self.W * k / 4000))
            if t and (not strip or strip[-1] != t):
                strip.append(t)
        return strip

    def shortest(self, strip):
        """The shortest closed path through a strip: the places on its portals, and the bends."""
        portals = [[self.vertex[v] for v in a if v in b] for a, b in zip(strip, strip[1:])]
        portals = [p for p in portals if len(p) == 2]
        t = [0.5] * len(portals)
        y = 0.5
        left = [self.vertex[v] for v in strip[0] if v[0] == 0]

        def at(k):
            if k in (-1, len(portals)):
                (x0, y0), (x1, y1) = left
                return (0.0 if k < 0 else self.W, y0 + y * (y1 - y0))
            (x0, y0), (x1, y1) = portals[k]
            return (x0 + t[k] * (x1 - x0), y0 + t[k] * (y1 - y0))

        def length(k):
            return math.dist(at(k - 1), at(k)) + math.dist(at(k), at(k + 1))

        def best(f):
            lo, hi = 0.0, 1.0
            for _ in range(40):
                a, b = lo + (hi - lo) / 3, hi - (hi - lo) / 3
                if f(a) < f(b):
                    hi = b
                else:
                    lo = a
            return (lo + hi) / 2

        for _ in range(400):
            for k in range(len(t)):
                def f(x):
                    t[k] = x
                    return length(k)
                t[k] = best(f)

            def g(x):
                nonlocal y
                y = x
                return math.dist(at(-1), at(0)) + math.dist(at(len(t) - 1), at(len(t)))
            y = best(g)
        bends = [at(k) for k in range(len(t)) if t[k] < 1e-3 or t[k] > 1 - 1e-3]
        return [at(k) for k in range(-1, len(t) + 1)], bends

    def draw(self, svg, x, y, strip):
        move = lambda p: (x + p[0], y + p[1])
        for t in self.triangles:
            corners = [move(self.vertex[v]) for v in t]
            if t in strip:
                svg.area(corners, "#f4c98c", 0.9)
            svg.line(corners, PALE, 0.8, closed=True)
        for side in (0, self.NX):
            svg.line([move(self.vertex[(side, j)]) for j in range(self.NY + 1)], DARK, 1.6,
                     dash="2 4")
        return move


def tightening():
    svg, mesh = Svg("tightening.svg", 760, 220), Strip()
    wave = lambda x: (x, 62 + 44 * math.sin(2 * math.pi * x / mesh.W + 0.5))
    strip = mesh.passed(wave)
    path, bends = mesh.shortest(strip)
    straight = mesh.passed(lambda x: (x, 62))
    portals = [[mesh.vertex[v] for v in a if v in b] for a, b in zip(strip, strip[1:])]
    middles = [((p[0][0] + p[1][0]) / 2, (p[0][1] + p[1][1]) / 2) for p in portals if len(p) == 2]
    start = (path[0][0], (wave(0)[1] + wave(mesh.W)[1]) / 2)
    traced = [start] + middles + [(mesh.W, start[1])]
    panels = [(strip, traced, [], "1  As traced: a loop passes\na strip of triangles."),
              (strip, path, bends, "2  The shortest path in the strip.\nIt bends at vertices only."),
              (straight, [(0, 62), (mesh.W, 62)], [],
               "3  Each bend passes to the other side\nof its vertex: a geodesic.")]
    for k, (triangles, line, dots, words) in enumerate(panels):
        x = 19 + 253 * k
        move = mesh.draw(svg, x, 20, triangles)
        svg.line([move(p) for p in line], RED, 2.8)
        for p in dots:
            svg.dot(move(p), DARK, 4)
        svg.text(x + mesh.W / 2, 180, words, 13)
    svg.write()


def linking():
    svg, torus = Svg("linking.svg", 760, 236), Torus(0.36, 48)
    circle = lambda cx, cy, r, a, b: [(cx + r * math.cos(math.radians(a + (b - a) * k / 60)),
                                       cy + r * math.sin(math.radians(a + (b - a) * k / 60)))
                                      for k in range(61)]
    half = math.degrees(math.acos(26 / 44))
    for k, is_linked in enumerate((False, True)):
        x, y, r = 90 + 185 * k, 92, 44
        a, b = (x - 26, y), (x + 26, y)
        svg.line(circle(*b, r, 0, 360), BLUE, 3)
        over = [(-180, 180)] if not is_linked else [(-half - 40, half - 12)]
        svg.line(circle(*a, r, 0, 360), RED, 3)
        if is_linked:  # at the lower place the blue curve lies above
            svg.line(circle(*b, r, 180 - half - 14, 180 - half + 14), "#fff", 9)
            svg.line(circle(*b, r, 180 - half - 14, 180 - half + 14), BLUE, 3)
            svg.line(circle(*a, r, -half - 14, -half + 14), "#fff", 9)
        else:
            svg.line(circle(*a, r, half - 14, half + 14), "#fff", 9)
            svg.line(circle(*a, r, -half - 14, -half + 14), "#fff", 9)
            svg.line(circle(*a, r, half - 14, half + 14), RED, 3)
        svg.line(circle(*a, r, -half - 14, -half + 14), RED, 3)
        h = r * math.sin(math.radians(half))
        svg.text(x, y - h - 12, "+1", 14, RED, weight="bold")
        if not is_linked:
            svg.text(x, y + h + 22, "-1", 14, RED, weight="bold")
    svg.text(90, 182, "linking number 0", 14, weight="bold")
    svg.text(90, 200, "red passes over blue twice,\nin opposite senses", 12)
    svg.text(275, 182, "linking number 1", 14, weight="bold")
    svg.text(275, 200, "red passes over blue once,\nand once under it", 12)
    u = math.radians(-50)
    for k in range(2):
        screen = torus.place((465 + 195 * k, 92), 66)
        torus.draw(svg, screen, opacity=0.75)
        push_handle, push_tunnel = (0.0, 0.22) if k == 0 else (0.22, 0.0)
        handle = [screen(torus.point(*p, push_handle)) for p in torus.handle(u)]
        if k == 0:
            svg.area(handle, ORANGE, 0.35)
            tunnel = [screen(torus.point(*p, push_tunnel)) for p in torus.tunnel()]
            torus.curve(svg, screen, torus.handle(u), ORANGE)
            svg.line(tunnel, BLUE, 2.6, closed=True)
        else:
            svg.area(handle, ORANGE, 0.2)
            torus.curve(svg, screen, torus.tunnel(), BLUE)
            svg.line(handle, ORANGE, 2.6, closed=True)
            svg.dot(screen(torus.point(u, math.pi)), BLUE, 4.5)
    svg.text(465, 182, "handle, pushed tunnel: 0", 13, weight="bold")
    svg.text(465, 200, "the handle loop is not linked:\nit bounds inside", 12)
    svg.text(660, 182, "tunnel, pushed handle: 1", 13, weight="bold")
    svg.text(660, 200, "the tunnel loop is linked:\nit does not bound inside", 12)
    svg.write()


def design():
    svg = Svg("design.svg", 760, 300)
    main = [("mesh", "FaceListGraph", "the user's"), ("adaptor", "HandleTunnelLoops-\nMeshAdaptor", "mesh"),
            ("arrays", "Flat_mesh", "mesh"), ("passes", "HandleTunnelLoops-\nPasses", "passes, shortening,\nhomology"),
            ("conversion", "Loop_converter", "mesh"), ("certificate", "Certification", "certificate,\nlinking")]
    w, gap, y = 108, 20.8, 30
    for k, (what, who, folder) in enumerate(main):
        x = 4 + k * (w + gap)
        is_concept = k in (0, 1, 3)
        svg.box(x, y, w, 92, "#fdebd0" if is_concept else "#e8edf4")
        svg.text(x + w / 2, y + 20, what, 14, DARK, weight="bold")
        svg.text(x + w / 2, y + 37, who, 10, DARK)
        svg.text(x + w / 2, y + 67, folder, 11, BLUE)
        if k:
            svg.arrow((x - gap + 2, y + 42), (x - 2, y + 42))
    px = 4 + 3 * (w + gap) + w / 2
    svg.box(px - 110, 162, 220, 44, "#fdebd0")
    svg.text(px, 181, "backend", 14, DARK, weight="bold")
    svg.text(px, 198, "HandleTunnelLoopsBackend", 11)
    svg.arrow((px - 14, y + 94), (px - 14, 160))
    svg.arrow((px + 14, 160), (px + 14, y + 94))
    svg.text(px - 22, 143, "questions", 11, DARK, "end")
    svg.text(px + 22, 143, "times, contours, walks", 11, DARK, "start")
    for k, (name, folder) in enumerate((("Host_backend", "passes, field"),
                                        ("Device_solver", "device"),
                                        ("Fallback_backend", "device"))):
        x = px - 186 + 126 * k
        svg.box(x, 238, 120, 56, "#e8edf4")
        svg.text(x + 60, 255, name, 11, DARK, weight="bold")
        svg.text(x + 60, 270, folder, 11, BLUE)
        svg.line([(x + 60, 238), (px, 206)], PALE, 1.2)
    svg.box(6, 222, 16, 12, "#fdebd0")
    svg.text(28, 232, "a concept", 11, DARK, "start")
    svg.box(6, 242, 16, 12, "#e8edf4")
    svg.text(28, 252, "a class", 11, DARK, "start")
    svg.text(6, 272, "blue: folder in internal/", 11, BLUE, "start")
    svg.write()


if __name__ == "__main__":
    definitions()
    fronts()
    tightening()
    linking()
    design()
