// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/seam_script.h"

#include "system/files.h"
#include "write/files.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <system_error>
#include <utility>

namespace htloops {
namespace {

constexpr char head_of_script[] =
    R"(# Marks seams in Blender 3.4 or later: on the object with the mesh of a file, or on the file, which it
# imports. Open it in the workspace "Scripting" and run it, or
#   blender --python THIS.py
#   blender --background --python THIS.py -- OUT.blend
import os
import sys

import bpy
from mathutils import Vector
from mathutils.kdtree import KDTree

)";

constexpr char matching_of_script[] = R"(
TOLERANCE = 2e-6 * max((abs(x) for place in PLACES.values() for x in place), default=0.0)


def readings(obj):
    """Vertex positions as the file may have them: as they are, or before Y became up."""
    for matrix in (None, obj.matrix_world):
        places = [v.co if matrix is None else matrix @ v.co for v in obj.data.vertices]
        yield places
        yield [Vector((x, z, -y)) for x, y, z in places]


def is_at(place, vertex):
    return (place - Vector(PLACES[vertex])).length <= TOLERANCE


def find_vertices(obj):
    """For each vertex of the file those of the object: the one with its number, or all at its place."""
    best = {}
    for places in readings(obj):
        if len(places) == NUMBER_OF_VERTICES and all(is_at(places[v], v) for v in PLACES):
            return {v: [v] for v in PLACES}
        tree = KDTree(len(places))
        for i, place in enumerate(places):
            tree.insert(place, i)
        tree.balance()
        found = {v: [i for _, i, _ in tree.find_range(PLACES[v], TOLERANCE)] for v in PLACES}
        found = {v: some for v, some in found.items() if some}
        best = found if len(found) > len(best) else best
    return best


def edges_to_mark(obj):
    """The seams of the object, each with its edges there."""
    vertices = find_vertices(obj)
    edges = {frozenset(e.vertices): e for e in obj.data.edges}
    marks = {}
    for u, v in SEAMS:
        ends = [frozenset((a, b)) for a in vertices.get(u, ()) for b in vertices.get(v, ())]
        if any(e in edges for e in ends):
            marks[u, v] = [edges[e] for e in ends if e in edges]
    return marks


def mark(objects):
    """Whether the objects have all seams; if so, marks them: on the first that has all, or on several."""
    marks = {obj: edges_to_mark(obj) for obj in objects}
    whole = [obj for obj in objects if len(marks[obj]) == len(SEAMS)][:1]
    if not whole and len(set().union(*marks.values())) < len(SEAMS):
        return False
    for obj in whole or objects:
        for edges in marks[obj].values():
            for edge in edges:
                edge.use_seam = True
        print(f"{obj.name}: {len(marks[obj])} edges are seams")
    return True
)";

constexpr char rest_of_script[] = R"(

def import_file(path):
    """The objects of a file, read with whichever importer this Blender has."""
    importers = {
        ".obj": ("wm.obj_import", "import_scene.obj"),
        ".ply": ("wm.ply_import", "import_mesh.ply"),
        ".stl": ("wm.stl_import", "import_mesh.stl"),
        ".glb": ("import_scene.gltf",),
        ".gltf": ("import_scene.gltf",),
    }
    before = set(bpy.data.objects)
    for name in importers.get(os.path.splitext(path)[1].lower(), ()):
        module, operator = name.split(".")
        try:
            getattr(getattr(bpy.ops, module), operator)(filepath=path)
        except AttributeError:
            continue  # this Blender lacks it
        return [obj for obj in bpy.data.objects if obj not in before and obj.type == "MESH"]
    fail(f"this Blender cannot read {path}: import the mesh from a file in another format")


def path_of_mesh():
    folder = os.path.dirname(os.path.abspath(globals().get("__file__", bpy.data.filepath)))
    return os.path.normpath(os.path.join(folder, MESH)) if MESH else ""


def fail(text):
    if bpy.app.background:
        sys.exit(text)
    raise RuntimeError(text)


def main():
    if bpy.context.object and bpy.context.object.mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    objects = [obj for obj in bpy.context.scene.objects if obj.type == "MESH"]
    objects.sort(key=lambda obj: (obj is not bpy.context.object, not obj.select_get()))
    if not SEAMS:
        print("the mesh needs no seams")
    elif not mark(objects):
        path = path_of_mesh()
        if not os.path.exists(path):
            fail(f"no object has the mesh of {MESH or 'the file'}, and {path or 'that'} does not exist: import it first")
        if not mark(import_file(path)):
            fail(f"the seams were made for another mesh than that of {path}")
    if "--" in sys.argv and sys.argv[-1].endswith(".blend"):
        bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(sys.argv[-1]))


main()
)";

// As Python reads it, and JSON.
std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// As seen from the folder of the script, so that both may be moved together.
std::string path_from(const std::string& script, const std::string& mesh_file) {
  namespace fs = std::filesystem;
  if(mesh_file == "-")
    return "";
  std::error_code error;
  const fs::path folder = fs::absolute(path_of(destination_of(script)), error).parent_path();
  const fs::path path = fs::proximate(fs::absolute(path_of(mesh_file), error), folder, error);
  return error ? mesh_file : name_of_path(path);
}

} // namespace

void write_seam_script(const std::string& target,
                       const std::string& mesh_file,
                       const Mesh& mesh,
                       const std::vector<Mesh::Edge_index>& seams) {
  Text_writer out(target);
  out << head_of_script << "MESH = " << quoted(path_from(target, mesh_file))
      << "  # from the folder of this program\nNUMBER_OF_VERTICES = " << mesh.number_of_vertices()
      << "\nPLACES = {  # of vertices of the file\n";
  std::vector<char> is_written(mesh.number_of_vertices(), 0);
  for(const Mesh::Edge_index e : seams)
    for(const int i : {0, 1}) {
      const Mesh::Vertex_index v = mesh.vertex(e, i);
      if(std::exchange(is_written[v.idx()], 1) == 0)
        out << "    " << v.idx() << ": (" << mesh.point(v).x() << ", " << mesh.point(v).y() << ", "
            << mesh.point(v).z() << "),\n";
    }
  out << "}\nSEAMS = [\n";
  for(const Mesh::Edge_index e : seams)
    out << "    (" << mesh.vertex(e, 0).idx() << ", " << mesh.vertex(e, 1).idx() << "),\n";
  out << "]\n" << matching_of_script << rest_of_script;
  out.finish();
}

} // namespace htloops
