"""Makes meshes of quadrangles and polygons in Blender: -- FOLDER"""

import os
import sys

import bpy

folder = sys.argv[-1]


def export(name, make):
    bpy.ops.object.select_all(action="SELECT")
    bpy.ops.object.delete()
    make()
    path = os.path.join(folder, name)
    if name.endswith(".obj"):
        bpy.ops.wm.obj_export(filepath=path, export_uv=False, export_normals=False, export_materials=False)
    else:
        bpy.ops.export_mesh.ply(filepath=path, use_uv_coords=False, use_normals=False)


export("torus.obj", lambda: bpy.ops.mesh.primitive_torus_add())  # quadrangles
export("tube.obj", lambda: bpy.ops.mesh.primitive_cylinder_add(end_fill_type="NOTHING"))
export("cylinder.obj", lambda: bpy.ops.mesh.primitive_cylinder_add())  # with lids of 32 corners
export("monkey.obj", lambda: bpy.ops.mesh.primitive_monkey_add())  # a head and two eyes
export("torus.ply", lambda: bpy.ops.mesh.primitive_torus_add(location=(3, 1, 2)))
