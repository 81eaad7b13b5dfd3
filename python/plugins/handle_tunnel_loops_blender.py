"""An add-on for Blender 3.4 or later that uses the Python module handle_tunnel_loops: the tab Handles of the sidebar (N).

Install this file with Edit > Preferences > Add-ons > Install. Lengths are in world space, in the units of the scene, so
the scale of an object counts. Noise, removal and seams use the edited mesh, without modifiers; curves and armatures use
the mesh with its modifiers, unless you switch that off.
"""

import glob
import os
import sys

import bmesh
import bpy
import numpy as np
from mathutils import Vector

bl_info = {
    "name": "Handle and tunnel loops",
    "author": "The Handle_tunnel_loops authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > Handles",
    "description": "Finds handles of meshes, removes noise, marks seams, and makes curves and armatures",
    "category": "Mesh",
}


class Refusal(Exception):
    """A message for the user."""


# ---- The module


class Preferences(bpy.types.AddonPreferences):
    bl_idname = __name__

    folder: bpy.props.StringProperty(
        name="Folder of the module", subtype="DIR_PATH",
        description="The folder that contains the Python module handle_tunnel_loops, if Blender does not find it")

    def draw(self, context):
        self.layout.prop(self, "folder")
        try:
            htl = module()
            self.layout.label(text=f"handle_tunnel_loops {htl.__version__}, {os.path.dirname(htl.__file__)}", icon="CHECKMARK")
        except Refusal as refusal:
            self.layout.label(text=str(refusal), icon="ERROR")


def folders_of_module():
    """The folder in the preferences, and the places where module and add-on are installed together."""
    addon = bpy.context.preferences.addons.get(__name__)
    if addon is not None and addon.preferences is not None and addon.preferences.folder:
        folder = os.path.normpath(bpy.path.abspath(addon.preferences.folder))
        # If it is the folder of the package itself, take the one above.
        yield os.path.dirname(folder) if os.path.basename(folder) == "handle_tunnel_loops" else folder
    here = os.path.abspath(__file__)
    above = [os.path.dirname(here)]
    while len(above) < 4:
        above.append(os.path.dirname(above[-1]))
    yield above[2]
    yield from glob.glob(os.path.join(above[3], "lib*", "python3*", "*-packages"))


def module():
    try:
        import handle_tunnel_loops
    except ImportError:
        for folder in folders_of_module():
            if os.path.isdir(os.path.join(folder, "handle_tunnel_loops")) and folder not in sys.path:
                sys.path.append(folder)
        try:
            import handle_tunnel_loops
        except ImportError as error:
            raise Refusal(
                f"Python {sys.version_info[0]}.{sys.version_info[1]} does not find the module handle_tunnel_loops ({error}): "
                "install it with `cmake --install`, and enter its folder in the preferences of this add-on"
            ) from None
    return handle_tunnel_loops


# ---- Meshes


class Surface:
    """The triangles of a mesh in world space, and the polygons that they belong to. Faces of a mirrored object are
    flipped, so that they face outwards."""

    def __init__(self, mesh, matrix):
        self.matrix = matrix.copy()
        if abs(matrix.determinant()) < 1e-30:
            raise Refusal("The object is scaled to zero in some direction")
        if len(mesh.polygons) == 0:
            raise Refusal("The mesh has no faces")
        mesh.calc_loop_triangles()
        V = np.empty(3 * len(mesh.vertices))
        F = np.empty(3 * len(mesh.loop_triangles), dtype=np.int32)
        self.polygons = np.empty(len(mesh.loop_triangles), dtype=np.int32)
        mesh.vertices.foreach_get("co", V)
        mesh.loop_triangles.foreach_get("vertices", F)
        mesh.loop_triangles.foreach_get("polygon_index", self.polygons)
        to_world = np.array(matrix)
        self.V = V.reshape(-1, 3) @ to_world[:3, :3].T + to_world[:3, 3]
        self.F = F.reshape(-1, 3).astype(np.int64)
        self.is_mirrored = matrix.determinant() < 0
        if self.is_mirrored:
            self.F = self.F[:, ::-1]
        self.diagonal = float(np.linalg.norm(np.ptp(self.V[np.unique(self.F)], axis=0)))

    def diagonals(self, mesh):
        """Edges of triangles that are not edges of the mesh."""
        count = len(mesh.vertices)
        sides = edge_numbers(self.F[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), count)
        return np.stack(np.divmod(np.setdiff1d(sides, numbers_of_edges(mesh)), count), axis=1)


def edge_numbers(ends, count):
    """A number for each pair of vertices, regardless of their order."""
    return np.sort(ends.astype(np.int64), axis=1) @ [count, 1]


def numbers_of_edges(mesh):
    ends = np.empty(2 * len(mesh.edges), dtype=np.int32)
    mesh.edges.foreach_get("vertices", ends)
    return edge_numbers(ends.reshape(-1, 2), len(mesh.vertices))


class ObjectMode:
    """Leaves edit mode, which saves the edited mesh, and returns to it."""

    def __init__(self, obj):
        self.mode = obj.mode

    def __enter__(self):
        if self.mode != "OBJECT":
            bpy.ops.object.mode_set(mode="OBJECT")

    def __exit__(self, *error):
        if self.mode != "OBJECT":
            bpy.ops.object.mode_set(mode=self.mode)


def shorter(pair):
    return min(pair, key=lambda loop: loop.length)


# ---- Operators


class Operator(bpy.types.Operator):
    """Shows its progress; on an error, shows a message and changes nothing."""

    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        obj = context.active_object
        if obj is None or obj.type != "MESH":
            cls.poll_message_set("The active object is not a mesh")
            return False
        if obj.mode not in ("OBJECT", "EDIT"):
            cls.poll_message_set("Only available in object mode and edit mode")
            return False
        return True

    def execute(self, context):
        context.window_manager.progress_begin(0, 100)
        try:
            htl = module()
            with ObjectMode(context.active_object):
                self.report({"INFO"}, self.work(context, context.active_object, htl))
            return {"FINISHED"}
        except Refusal as refusal:
            self.report({"ERROR"}, str(refusal))
        except (ValueError, MemoryError) as error:  # MeshError is one
            self.report({"ERROR"}, f"{context.active_object.name}: {words_of(error)}")
        finally:
            context.window_manager.progress_end()
        return {"CANCELLED"}

    @staticmethod
    def told(fraction):
        bpy.context.window_manager.progress_update(100 * fraction)


def words_of(error):
    """The message of the module about a mesh, with advice for Blender."""
    if type(error).__name__ != "MeshError":
        return str(error)
    lines = [line.strip() for line in str(error).splitlines() if not line.startswith("repair()")]
    return "; ".join([*lines, "try Mesh > Clean Up, Mesh > Normals > Recalculate Outside, and Select > Select All by Trait"])


class Limit:
    """The limit below which handles are noise."""

    unit: bpy.props.EnumProperty(
        name="Limit", items=[("PERCENT", "Percentage", "A percentage of the diagonal of the bounding box"),
                             ("LENGTH", "Length", "A length in the unit of the scene")], default="PERCENT")
    percent: bpy.props.FloatProperty(
        name="Shorter Than", default=3, min=0, max=100, precision=2, subtype="PERCENTAGE",
        description="Handles with a loop shorter than this are noise")
    length: bpy.props.FloatProperty(
        name="Shorter Than", default=0.1, min=0, subtype="DISTANCE",
        description="Handles with a loop shorter than this are noise")

    def limit(self, surface):
        return self.length if self.unit == "LENGTH" else self.percent / 100 * surface.diagonal

    def draw_limit(self, layout):
        layout.prop(self, "unit")
        layout.prop(self, "length" if self.unit == "LENGTH" else "percent")


class Triangles:
    """The triangles that a loop runs through."""

    def __init__(self, F):
        self.order = np.argsort(F, axis=None, kind="stable")
        self.starts = np.searchsorted(F.ravel()[self.order], np.arange(F.max() + 2))

    def along(self, loop):
        """Each place is at a vertex or on an edge; consecutive places lie on a common triangle."""
        places = [
            {u} if ratio <= 0 else {v} if ratio >= 1 else {u, v}
            for (u, v), ratio in zip(loop.edges.tolist(), loop.ratios.tolist())
        ]
        return {f for i, place in enumerate(places) for f in self.around(place | places[i - 1] if len(place) == 2 else place)}

    def around(self, corners):
        return set.intersection(*(set((self.order[self.starts[v]:self.starts[v + 1]] // 3).tolist()) for v in corners))


def noise_of(htl, surface, limit, told):
    """The loops, and the numbers of the pairs with a loop shorter than the limit."""
    L = htl.loops(surface.V, surface.F, progress=told)
    return L, [i for i, pair in enumerate(L) if shorter(pair).length < limit]


def select(mesh, polygons, is_extending):
    """Selects polygons with their edges and vertices, and unhides them."""
    if not is_extending:
        for elements in (mesh.polygons, mesh.edges, mesh.vertices):
            elements.foreach_set("select", np.zeros(len(elements), dtype=bool))
    for f in polygons:
        polygon = mesh.polygons[f]
        edges = [mesh.edges[mesh.loops[i].edge_index] for i in polygon.loop_indices]
        for element in (polygon, *edges, *(mesh.vertices[v] for v in polygon.vertices)):
            element.hide, element.select = False, True
    mesh.update()


class HTL_OT_select_noise(Limit, Operator):
    """Select the faces along the short loop of each noise handle, in edit mode"""

    bl_idname = "mesh.htl_select_noise"
    bl_label = "Select Noise Handles"

    extend: bpy.props.BoolProperty(name="Extend", description="Keep the current selection")

    def draw(self, context):
        self.draw_limit(self.layout)
        self.layout.prop(self, "extend")

    def execute(self, context):
        result = super().execute(context)
        if result == {"FINISHED"} and context.active_object.mode != "EDIT":
            bpy.ops.object.mode_set(mode="EDIT")
        return result

    def work(self, context, obj, htl):
        mesh = obj.data
        surface = Surface(mesh, obj.matrix_world)
        L, noise = noise_of(htl, surface, self.limit(surface), self.told)
        triangles = Triangles(surface.F)
        polygons = {int(surface.polygons[f]) for i in noise for f in triangles.along(shorter(L[i]))}
        select(mesh, polygons, self.extend)
        context.tool_settings.mesh_select_mode = (False, False, True)
        return f"Noise handles: {len(noise)} of {L.genus}; faces along their loops: {len(polygons)}"


def place_on_rim(corners, point):
    """The side of a triangle that a point lies on, by its first corner, and the position along it."""
    sides, ways = np.roll(corners, -1, axis=0) - corners, point - corners
    k = int(np.argmin(np.linalg.norm(np.cross(sides, ways), axis=1) / np.maximum(np.linalg.norm(sides, axis=1), 1e-300)))
    return k, float(np.clip(ways[k] @ sides[k] / max(sides[k] @ sides[k], 1e-300), 0, 1))


def interpolate(loop, face):
    """Gives a corner the data of a face, interpolated at its position."""
    try:
        loop.copy_from_face_interp(face, False, False)
    except TypeError:  # Blender 3.4 takes a tuple
        loop.copy_from_face_interp((face, False, False))


class Polygons:
    """Makes the mesh of a removal; unchanged polygons keep all their data."""

    def __init__(self, mesh, surface, V, F, face_origin, report):
        self.bm = bmesh.new()
        self.bm.from_mesh(mesh)
        self.old_vertices, self.old_faces = list(self.bm.verts), list(self.bm.faces)
        self.surface, self.V = surface, V
        self.vertex_origin, self.face_parent = report["vertex_origin"], report["face_parent"]
        whole = np.bincount(surface.polygons, minlength=len(self.old_faces))
        same = face_origin >= 0  # and on the same vertices, not on copies of them
        same[same] = np.all(self.vertex_origin[F[same]] == surface.F[face_origin[same]], axis=1)
        self.is_kept = np.bincount(surface.polygons[face_origin[same]], minlength=len(self.old_faces)) == whole
        self.parents = np.where(self.face_parent < 0, -1, surface.polygons[self.face_parent])
        self.new_faces = np.flatnonzero(~same | ~self.is_kept[self.parents])
        self.F = F[:, ::-1] if surface.is_mirrored else F

    def change(self):
        """Changes the mesh; returns the numbers of new triangles and of removed polygons."""
        gone = [face for face, is_kept in zip(self.old_faces, self.is_kept) if not is_kept]
        corners = {vertex for face in gone for vertex in face.verts}
        edges = {edge for face in gone for edge in face.edges}
        vertices = self.make_vertices()
        made = [self.make_face([vertices[v] for v in self.F[f].tolist()], int(self.parents[f]))
                for f in self.new_faces.tolist()]
        bmesh.ops.delete(self.bm, geom=gone, context="FACES_ONLY")
        self.give_materials_to_caps([face for face, f in zip(made, self.new_faces) if self.parents[f] < 0])
        bmesh.ops.delete(self.bm, geom=[e for e in edges if e.is_valid and not e.link_faces], context="EDGES")
        bmesh.ops.delete(self.bm, geom=[v for v in corners if v.is_valid and not v.link_edges], context="VERTS")
        self.bm.normal_update()
        return len(made), len(gone)

    def make_vertices(self):
        """Old vertices are reused; new ones get data interpolated along an edge of the triangles."""
        to_object = self.surface.matrix.inverted()
        places = self.places_of_new_vertices()
        vertices = {}
        for v in np.unique(self.F[self.new_faces]).tolist():
            origin = int(self.vertex_origin[v])
            vertices[v] = self.old_vertices[origin] if origin >= 0 else self.bm.verts.new(to_object @ Vector(self.V[v]))
            if origin < 0 and v in places:
                a, b, ratio = places[v]
                vertices[v].copy_from_vert_interp((self.old_vertices[a], self.old_vertices[b]), ratio)
            elif origin < 0:
                for layer in self.bm.verts.layers.shape.values():
                    vertices[v][layer] = vertices[v].co
        return vertices

    def places_of_new_vertices(self):
        """For each new vertex of a part of a triangle: two corners of it, and the position between them."""
        places = {}
        for f in self.new_faces[self.parents[self.new_faces] >= 0].tolist():
            corners = self.surface.F[self.face_parent[f]]
            for v in self.F[f].tolist():
                if self.vertex_origin[v] < 0 and v not in places:
                    k, ratio = place_on_rim(self.surface.V[corners], self.V[v])
                    places[v] = int(corners[k]), int(corners[(k + 1) % 3]), ratio
        return places

    def make_face(self, corners, parent):
        """A part of a polygon gets the data of the polygon, interpolated."""
        twin = self.bm.faces.get(corners)  # which is about to be removed
        if twin is None:
            face = self.bm.faces.new(corners)
        else:
            face = twin.copy(verts=False, edges=False)
            at = list(face.verts).index(corners[0])
            if face.verts[(at + 1) % 3] != corners[1]:
                face.normal_flip()
        if parent >= 0:
            face.copy_from(self.old_faces[parent])
            face.smooth = self.old_faces[parent].smooth
            for loop in face.loops:
                interpolate(loop, self.old_faces[parent])
        return face

    @staticmethod
    def give_materials_to_caps(caps):
        """The materials of neighbors, from the rims inwards."""
        waiting = set(caps)
        is_going_on = True
        while is_going_on:
            ring = {face: other for face in waiting for edge in face.edges for other in edge.link_faces if other not in waiting}
            for face, other in ring.items():
                face.material_index, face.smooth = other.material_index, other.smooth
            waiting.difference_update(ring)
            is_going_on = bool(ring)


def is_selected_along(mesh, surface, triangles, loop):
    return all(mesh.polygons[surface.polygons[f]].select for f in triangles.along(loop))


class HTL_OT_remove_handles(Limit, Operator):
    """Remove noise handles, handles with a loop through selected faces, the smallest handles, or all"""

    bl_idname = "mesh.htl_remove_handles"
    bl_label = "Remove Handles"

    which: bpy.props.EnumProperty(
        name="Which",
        items=[("NOISE", "Noise", "Handles with a short loop"),
               ("SELECTED", "Selected", "Handles with a loop that runs only through selected faces"),
               ("GENUS", "Down to a Number", "The smallest handles, until a given number remains"),
               ("ALL", "All", "All handles")])
    genus: bpy.props.IntProperty(name="Handles Left", default=0, min=0, description="The number of handles to keep")
    by: bpy.props.EnumProperty(
        name="By",
        items=[("smallest-change", "The Smaller Change", "Cut or fill, whichever changes the shape less"),
               ("cut", "Cutting", "Cut handles through"), ("fill", "Filling", "Fill the holes")])

    def draw(self, context):
        self.layout.prop(self, "which")
        if self.which == "NOISE":
            self.draw_limit(self.layout)
        if self.which == "GENUS":
            self.layout.prop(self, "genus")
        self.layout.prop(self, "by")

    def work(self, context, obj, htl):
        mesh = obj.data
        surface = Surface(mesh, obj.matrix_world)
        L, noise = noise_of(htl, surface, self.limit(surface), self.told)
        V, F, face_origin, report = htl.remove_handles(
            surface.V, surface.F, loops=L, by=self.by, progress=self.told, **self.chosen(mesh, surface, L, noise))
        made = gone = 0
        if report["removed"]:
            polygons = Polygons(mesh, surface, V, F, face_origin, report)
            made, gone = polygons.change()
            polygons.bm.to_mesh(mesh)
            polygons.bm.free()
            mesh.update()
        for one in report["refused"]:
            self.report({"WARNING"}, f"Handle {one['pair']} is kept: {one['reason']}")
        removed = report["genus_before"] - report["genus_after"]
        return f"Handles removed: {removed} of {report['genus_before']}; faces removed: {gone}, new triangles: {made}"

    def chosen(self, mesh, surface, L, noise):
        if self.which == "NOISE":
            return {"pairs": noise}
        if self.which == "SELECTED":
            triangles = Triangles(surface.F)
            return {"pairs": [i for i, pair in enumerate(L)
                              if any(is_selected_along(mesh, surface, triangles, loop) for loop in pair)]}
        return {"genus": self.genus if self.which == "GENUS" else 0}


class HTL_OT_mark_seams(Operator):
    """Mark edges as seams, so that each part of the mesh unfolds to one disk"""

    bl_idname = "mesh.htl_mark_seams"
    bl_label = "Mark Seams"

    clear: bpy.props.BoolProperty(name="Clear", description="Clear existing seams first")
    through: bpy.props.BoolProperty(
        name="Through Selected", description="Seams pass through all selected vertices")

    def work(self, context, obj, htl):
        mesh = obj.data
        surface = Surface(mesh, obj.matrix_world)
        cones = []
        if self.through:
            used = set(np.unique(surface.F).tolist())
            cones = [v.index for v in mesh.vertices if v.select and v.index in used]
        seams = htl.cut_edges(surface.V, surface.F, cones=cones, cut_spheres=True, avoid=surface.diagonals(mesh),
                              progress=self.told)
        is_seam = np.zeros(len(mesh.edges), dtype=bool)
        if not self.clear:
            mesh.edges.foreach_get("use_seam", is_seam)
        is_seam |= np.isin(numbers_of_edges(mesh), edge_numbers(seams, len(mesh.vertices)))
        mesh.edges.foreach_set("use_seam", is_seam)
        mesh.update()
        return f"Edges marked as seams: {len(seams)}"


# ---- Curves and armatures


class Evaluated:
    """The surface of an object, with or without its modifiers."""

    use_modifiers: bpy.props.BoolProperty(
        name="Apply Modifiers", default=True, description="Use the mesh with its modifiers")

    def surface(self, context, obj):
        if not self.use_modifiers:
            return Surface(obj.data, obj.matrix_world)
        evaluated = obj.evaluated_get(context.evaluated_depsgraph_get())
        mesh = evaluated.to_mesh()
        try:
            return Surface(mesh, obj.matrix_world)
        finally:
            evaluated.to_mesh_clear()


def add_object(name, data, obj):
    """Adds a new object to the collection of an object, in world space."""
    new = bpy.data.objects.new(name, data)
    (obj.users_collection[0] if obj.users_collection else bpy.context.scene.collection).objects.link(new)
    return new


def material_of(name, colour):
    material = bpy.data.materials.get(name) or bpy.data.materials.new(name)
    material.diffuse_color = (*colour, 1)
    material.use_nodes = True
    shader = material.node_tree.nodes.get("Principled BSDF")
    if shader is not None:
        shader.inputs["Base Color"].default_value = (*colour, 1)
    return material


COLOURS = {"handle": (0.9, 0.3, 0.02), "tunnel": (0.05, 0.25, 0.9), "boundary": (0.1, 0.6, 0.1)}


class HTL_OT_loops_to_curves(Evaluated, Operator):
    """Make curve objects of the handle loops, the tunnel loops and the boundary curves"""

    bl_idname = "object.htl_loops_to_curves"
    bl_label = "Loops to Curves"

    thickness: bpy.props.FloatProperty(
        name="Thickness", default=0.3, min=0, subtype="PERCENTAGE", precision=2,
        description="Thickness of the curves, as a percentage of the diagonal of the bounding box")

    def work(self, context, obj, htl):
        surface = self.surface(context, obj)
        L = htl.loops(surface.V, surface.F, progress=self.told)
        for kind, loops in (("handle", L.handles), ("tunnel", L.tunnels), ("boundary", L.boundaries)):
            if loops:
                self.make_curve(obj, kind, loops, self.thickness / 200 * surface.diagonal)
        return f"Handle loops: {L.genus}, tunnel loops: {L.genus}, boundary curves: {len(L.boundaries)}"

    @staticmethod
    def make_curve(obj, kind, loops, radius):
        name = f"{obj.name} {kind} loops" if kind != "boundary" else f"{obj.name} boundary"
        curve = bpy.data.curves.new(name, "CURVE")
        curve.dimensions = "3D"
        curve.bevel_depth = radius
        for loop in loops:
            spline = curve.splines.new("POLY")
            spline.points.add(len(loop) - 1)
            spline.points.foreach_set("co", np.append(loop.points, np.ones((len(loop), 1)), axis=1).ravel())
            spline.use_cyclic_u = True
        curve.materials.append(material_of(f"{kind} loops", COLOURS[kind]))
        new = add_object(name, curve, obj)
        new.parent, new.matrix_parent_inverse = obj, obj.matrix_world.inverted()
        new["lengths"] = [loop.length for loop in loops]


def is_within_balls(a, b, centres, radii):
    """Whether a segment lies in the union of balls, and meets all of them."""
    direction, length = b - a, float(np.linalg.norm(b - a))
    if length == 0:
        return False
    middles = (centres - a) @ direction / length**2
    squares = np.sum((centres - a - np.outer(middles, direction)) ** 2, axis=1)
    if np.any(squares >= radii**2):
        return False  # the arc goes elsewhere, for example around a hole
    halves = np.sqrt(np.maximum(radii**2 - squares, 0)) / length
    reached = 0.0
    for begin, end in sorted(zip((middles - halves).tolist(), (middles + halves).tolist())):
        if begin > reached:
            break
        reached = max(reached, end)
    return reached >= 1


def joints_of(points, radii):
    """The places of an arc where bones meet: as few as possible such that each bone lies in the balls of its part."""
    joints = [0]
    while joints[-1] < len(points) - 1:
        first, good, step = joints[-1], joints[-1] + 1, 1
        while first + 2 * step < len(points):  # doubles the step as long as the bone fits
            if not is_within_balls(points[first], points[first + 2 * step], points[first:first + 2 * step + 1],
                                   radii[first:first + 2 * step + 1]):
                break
            step *= 2
            good = first + step
        while step > 1:
            step //= 2
            last = good + step
            if last < len(points) and is_within_balls(points[first], points[last], points[first:last + 1], radii[first:last + 1]):
                good = last
        joints.append(good)
    return joints


class Tree:
    """The arcs of a skeleton as a forest: (arc, whether it is reversed, its parent arc or -1, whether it ends at a node
    that was already reached)."""

    def __init__(self, skeleton):
        ends = [(int(arc[0]), int(arc[-1])) for arc in skeleton.arcs]
        around = {}
        for i, (a, b) in enumerate(ends):
            around.setdefault(a, []).append(i)
            around.setdefault(b, []).append(i)
        self.rows, self.number_of_cuts, self.number_of_trees = [], 0, 0
        taken = set()
        # A tree starts at an end, if it has one, so that one bone moves all of it.
        reached = {}
        for root in sorted(around, key=lambda node: (len(around[node]) != 1, -float(skeleton.radii[node]))):
            if root in reached:
                continue
            self.number_of_trees += 1
            reached[root] = -1
            nodes = [root]
            for node in nodes:  # grows
                for i in around[node]:
                    if i in taken:
                        continue
                    taken.add(i)
                    a, b = ends[i]
                    other = b if node == a else a
                    closes = other in reached
                    self.rows.append((i, node != a, reached[node], closes))
                    self.number_of_cuts += closes
                    if not closes:
                        reached[other] = i
                        nodes.append(other)


class HTL_OT_skeleton_to_armature(Evaluated, Operator):
    """Make an armature from the curve skeleton: bones in the middle of the solid, with its radii as envelopes"""

    bl_idname = "object.htl_skeleton_to_armature"
    bl_label = "Skeleton to Armature"

    shortest_limb: bpy.props.FloatProperty(
        name="Shortest Limb", default=1.2, min=0,
        description="Leave out limbs shorter than this many times the radius at their base")
    envelope: bpy.props.FloatProperty(
        name="Envelope", default=0.25, min=0,
        description="Envelope distance of the bones, as a fraction of the radii")

    def work(self, context, obj, htl):
        surface = self.surface(context, obj)
        skeleton = htl.curve_skeleton(surface.V, surface.F, self.shortest_limb, progress=self.told)
        if not skeleton.arcs:
            raise Refusal("The skeleton has no arcs")
        if not skeleton.certificate:
            self.report({"WARNING"}, f"The skeleton is not certified: {skeleton.certificate.failure}")
        tree = Tree(skeleton)
        armature = bpy.data.armatures.new(f"{obj.name} skeleton")
        armature.display_type = "ENVELOPE"
        rig = add_object(armature.name, armature, obj)
        rig.show_in_front = True
        number = self.make_bones(context, rig, skeleton, tree)
        return (f"Bones: {number}, arcs: {len(skeleton.arcs)}, trees: {tree.number_of_trees}; "
                f"cycles that are cut, at a joint to which the last bone is not connected: {tree.number_of_cuts}")

    def make_bones(self, context, rig, skeleton, tree):
        active, selected = context.view_layer.objects.active, list(context.selected_objects)
        for other in selected:
            other.select_set(False)
        context.view_layer.objects.active = rig
        rig.select_set(True)
        bpy.ops.object.mode_set(mode="EDIT")
        last = {}  # bone of each arc
        for arc, is_backwards, before, closes in tree.rows:
            points = skeleton.arcs[arc][::-1] if is_backwards else skeleton.arcs[arc]
            last[arc] = self.make_chain(rig.data, f"arc {arc}", skeleton, points, last.get(before))
            if closes:
                last[arc]["closes_a_cycle"] = True
        number = len(rig.data.edit_bones)
        bpy.ops.object.mode_set(mode="OBJECT")
        rig.select_set(False)
        for other in selected:
            other.select_set(True)
        context.view_layer.objects.active = active
        return number

    def make_chain(self, armature, name, skeleton, points, parent):
        joints = points[joints_of(skeleton.points[points], skeleton.radii[points])]
        for k, (a, b) in enumerate(zip(joints[:-1].tolist(), joints[1:].tolist())):
            bone = armature.edit_bones.new(f"{name}.{k:03}")
            bone.head, bone.tail = skeleton.points[a], skeleton.points[b]
            bone.head_radius, bone.tail_radius = float(skeleton.radii[a]), float(skeleton.radii[b])
            bone.envelope_distance = self.envelope * float(skeleton.radii[a] + skeleton.radii[b]) / 2
            if parent is not None:
                bone.parent, bone.use_connect = parent, True
            parent = bone
        return parent


# ---- The panel


class HTL_PT_handles(bpy.types.Panel):
    bl_label = "Handles"
    bl_category = "Handles"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"

    def draw(self, context):
        column = self.layout.column(align=True)
        column.operator(HTL_OT_select_noise.bl_idname, icon="RESTRICT_SELECT_OFF")
        column.operator(HTL_OT_remove_handles.bl_idname, icon="X")
        self.layout.operator(HTL_OT_mark_seams.bl_idname, icon="UV")
        column = self.layout.column(align=True)
        column.operator(HTL_OT_loops_to_curves.bl_idname, icon="CURVE_DATA")
        column.operator(HTL_OT_skeleton_to_armature.bl_idname, icon="ARMATURE_DATA")


CLASSES = (
    Preferences,
    HTL_OT_select_noise,
    HTL_OT_remove_handles,
    HTL_OT_mark_seams,
    HTL_OT_loops_to_curves,
    HTL_OT_skeleton_to_armature,
    HTL_PT_handles,
)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)


if __name__ == "__main__":
    register()
