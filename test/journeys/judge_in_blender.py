"""Judges seams in Blender: -- MESH SEAMS.py

The program marks seams on the mesh, which it imports itself. Polygons stay; no edge is marked but edges of
the file; cut along the seams, each component is one disk. Blender unwraps the mesh along them, to islands with
the same seams.
"""

import os
import runpy
import sys

import bpy

mesh_file, seams_file = sys.argv[sys.argv.index("--") + 1 :]


def find(parent, a):
    while parent[a] != a:
        parent[a] = parent[parent[a]]
        a = parent[a]
    return a


def classes(elements, pairs):
    parent = {a: a for a in elements}
    for a, b in pairs:
        parent[find(parent, a)] = find(parent, b)
    return len({find(parent, a) for a in elements}), parent


def faces_at_edges(mesh):
    at = {frozenset(e.vertices): [] for e in mesh.edges}
    for f, polygon in enumerate(mesh.polygons):
        corners = list(polygon.vertices)
        for u, v in zip(corners, corners[1:] + corners[:1]):
            at[frozenset((u, v))].append(f)
    return at


def check_disks(mesh, seams):
    """Faces and corners hang together across edges that are no seams."""
    at = faces_at_edges(mesh)
    joined = [(e, faces) for e, faces in at.items() if len(faces) == 2 and e not in seams]
    faces = range(len(mesh.polygons))
    components, _ = classes(faces, [f for f in at.values() if len(f) == 2])
    pieces, piece_of = classes(faces, [f for _, f in joined])
    assert pieces == components, (pieces, components)
    corners = [(f, v) for f in faces for v in mesh.polygons[f].vertices]
    number_of_corners, _ = classes(corners, [((f, v), (g, v)) for e, (f, g) in joined for v in e])
    edges = sum(len(f) for f in at.values()) - len(joined)
    assert number_of_corners - edges + len(faces) == pieces, "a piece is no disk"


def seams_of(mesh):
    at = faces_at_edges(mesh)
    return {frozenset(e.vertices) for e in mesh.edges if e.use_seam and len(at[frozenset(e.vertices)]) == 2}


# The program is run beside another object, the cube that Blender begins with; and once more when the mesh is there.
runpy.run_path(seams_file)
marked = [obj for obj in bpy.data.objects if obj.type == "MESH" and any(e.use_seam for e in obj.data.edges)]
mesh = marked[0].data
assert len(marked) == 1 and "Cube" not in marked[0].name
if mesh_file.endswith(".obj"):
    sizes = [len(line.split()) - 1 for line in open(mesh_file) if line.startswith("f ")]
    assert [len(p.vertices) for p in mesh.polygons] == sizes and max(sizes) > 3
seams = seams_of(mesh)
check_disks(mesh, seams)
for edge in mesh.edges:
    edge.use_seam = False
number_of_objects = len(bpy.data.objects)
runpy.run_path(seams_file)
assert seams_of(mesh) == seams and len(bpy.data.objects) == number_of_objects

obj = marked[0]
bpy.ops.object.select_all(action="DESELECT")
obj.select_set(True)
bpy.context.view_layer.objects.active = obj
bpy.ops.object.mode_set(mode="EDIT")
bpy.ops.mesh.select_all(action="SELECT")
bpy.ops.uv.unwrap()
bpy.ops.uv.select_all(action="SELECT")
bpy.ops.mesh.mark_seam(clear=True)
bpy.ops.uv.seams_from_islands(mark_seams=True, mark_sharp=False)
bpy.ops.object.mode_set(mode="OBJECT")
assert seams_of(mesh) == seams, (len(seams_of(mesh)), len(seams))
print(f"JUDGED {os.path.basename(mesh_file)}: {len(seams)} seams")
