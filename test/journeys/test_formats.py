"""Each format of meshes: read as other programs write it, and written as other programs read it."""

import base64
import csv
import gzip
import json
import os
import resource
import signal
import struct
import subprocess
import time
import zipfile
import zlib

import pytest

import judges
from mesh_files import read_off, read_stl, torus, triangles_of, write_off, write_stl


def box_of(points):
    return [f(p[i] for p in points) for f in (min, max) for i in range(3)]


def is_near(points, others):
    return len(points) == len(others) and all(abs(x - y) < 2e-6 for p, q in zip(points, others) for x, y in zip(p, q))


def same_triangles(one, other):
    def turned(t):
        i = t.index(min(t))
        return t[i:] + t[:i]

    return sorted(map(turned, map(tuple, one))) == sorted(map(turned, map(tuple, other)))


@pytest.fixture
def two_tori():
    """Points and triangles of two tori, whose numbers single precision has no room for."""
    points, quads = torus(shift=(0.1, 0.2, 0.3))
    more, other_quads = torus(large=1.5, shift=(10.1, 0, 0))
    n = len(points)
    faces = quads + [tuple(v + n for v in quad) for quad in other_quads]
    return points + more, triangles_of(faces)


@pytest.fixture
def mesh(tool, two_tori):
    return write_off(tool.folder / "mesh.off", *two_tori)


@pytest.mark.parametrize("ending", ["off", "obj", "ply", "3mf", "vtp", "vtu", "binary.vtp", "binary.vtu", "msh", "msh2",
                                    "off.gz", "ply.gz", "3mf.gz", "binary.vtu.gz"])
def test_what_has_room_for_all_digits_comes_back_the_same(tool, mesh, two_tori, ending):
    tool.run("repair", mesh, "-o", f"copy.{ending}", "-q")
    points, triangles = tool.as_off(f"copy.{ending}")
    assert same_triangles(triangles, two_tori[1])
    assert points == two_tori[0]


@pytest.mark.parametrize("ending", ["stl", "ascii.stl", "glb", "gii", "white", "surf", "stl.gz", "glb.gz", "white.gz"])
def test_what_has_not_comes_back_rounded(tool, mesh, two_tori, ending):
    tool.run("repair", mesh, "-o", f"copy.{ending}", "-q")
    points, triangles = tool.as_off(f"copy.{ending}")
    assert len(points) == len(two_tori[0]) and len(triangles) == len(two_tori[1])
    assert box_of(points) == pytest.approx(box_of(two_tori[0]), abs=1e-6)
    assert tool.facts(f"copy.{ending}")["genus"] == 2


def test_gzip_is_gzip(tool, mesh):
    tool.run("repair", mesh, "-o", "copy.off.gz", "-q")
    assert read_off(mesh) == read_off_text(tool, gzip.decompress((tool.folder / "copy.off.gz").read_bytes()))


def read_off_text(tool, content):
    file = tool.folder / "unpacked.off"
    file.write_bytes(content)
    return read_off(file)


def test_binary_stl_has_fifty_bytes_a_face(tool, mesh, two_tori):
    tool.run("repair", mesh, "-o", "copy.stl", "-q")
    points, triangles = read_stl(tool.folder / "copy.stl")
    assert len(triangles) == len(two_tori[1]) and len(points) == len(two_tori[0])


def test_binary_stl_refuses_to_let_points_fall_together(tool):
    points, quads = torus()
    points[1] = (points[0][0] + 1e-9, *points[0][1:])
    write_off(tool.folder / "near.off", points, triangles_of(quads))
    said = tool.run("repair", "near.off", "-o", "near.stl", "-q", code=2).stderr
    assert "1 vertex would coincide with another one in" in said and ".ascii.stl" in said
    assert not (tool.folder / "near.stl").exists()
    tool.run("repair", "near.off", "-o", "near.ascii.stl", "-q")
    assert tool.facts("near.ascii.stl")["genus"] == 1


@pytest.mark.parametrize("ending", ["stl", "glb", "gii", "surf"])
@pytest.mark.parametrize("shift, scale", [(1e9, 1.0), (0.0, 1e39), (0.0, 1e-60)])
def test_single_precision_is_refused_where_it_has_no_room(tool, ending, shift, scale):
    points, quads = torus()
    write_off(tool.folder / "mesh.off", [(scale * x + shift, scale * y, scale * z) for x, y, z in points],
              triangles_of(quads))
    assert "single precision" in tool.run("repair", "mesh.off", "-o", f"mesh.{ending}", "-q", code=2).stderr
    assert not (tool.folder / f"mesh.{ending}").exists()
    tool.run("repair", "mesh.off", "-o", "mesh.3mf", "-q")


def test_units_are_converted_where_a_format_has_one_of_its_own(tool):
    points, quads = torus()
    (tool.folder / "meters.glb").write_bytes(glb(*scene_of_two_nodes(points, triangles_of(quads))))
    length = tool.facts("meters.glb")["pairs"][0]["handle"]
    assert "meter" in tool.run("loops", "meters.glb").stdout
    for ending, factor in (("gii", 1000), ("surf", 1000), ("3mf", 1), ("glb", 1)):
        tool.run("repair", "meters.glb", "-o", f"copy.{ending}", "-q")
        facts = tool.facts(f"copy.{ending}")
        assert facts["pairs"][0]["handle"] == pytest.approx(factor * length, rel=1e-5)
        assert facts["unit"] == ("millimeter" if factor == 1000 else "meter")


@pytest.mark.parametrize("ending, comment", [("off", ""), ("obj", "# unit: meter"), ("ply", "comment unit: meter"),
                                             ("vtp", "<!-- unit: meter -->"), ("vtu", "<!-- unit: meter -->"),
                                             ("stl", ""), ("msh", "")])
def test_a_unit_that_a_format_has_no_place_for_is_told(tool, ending, comment):
    points, quads = torus()
    (tool.folder / "meters.glb").write_bytes(glb(*scene_of_two_nodes(points, triangles_of(quads))))
    said = tool.run("repair", "meters.glb", "-o", f"copy.{ending}").stderr
    assert said.count(f"note: copy.{ending}: the format cannot store the unit (meter)") == 1
    assert tool.run("repair", "meters.glb", "-o", f"copy.{ending}", "-q").stderr == ""
    assert comment.encode() in (tool.folder / f"copy.{ending}").read_bytes()
    assert "unit" not in tool.run("repair", f"copy.{ending}", "-o", "again.off").stderr
    assert tool.facts(f"copy.{ending}")["genus"] == 2
    if ending in ("obj", "ply"):  # comments are passed over by others, too
        judges.exported_by_assimp(tool.folder / f"copy.{ending}", tool.folder / "other.stl")
        assert (tool.folder / "other.stl").read_text().count("endfacet") == 4 * len(quads)
    if ending in ("vtp", "vtu"):
        assert judges.paraview(tool.folder / f"copy.{ending}")["triangles"] == 4 * len(quads)


@pytest.mark.parametrize("words", [["remove", "--all", "-o"], ["clean"], ["cut", "-o"], ["loops", "--write-mesh"]],
                         ids=" ".join)
def test_each_command_that_writes_a_mesh_tells_that_its_unit_is_lost(tool, words):
    points, quads = torus()
    (tool.folder / "meters.glb").write_bytes(glb(*scene_of_two_nodes(points, triangles_of(quads))))
    said = tool.run(words[0], "meters.glb", *words[1:], "copy.obj").stderr
    assert said.count("note: copy.obj: the format cannot store the unit (meter)") == 1


@pytest.mark.parametrize("ending", ["glb", "3mf", "gii", "white"])
def test_nothing_is_told_where_the_unit_is_kept(tool, ending):
    points, quads = torus()
    (tool.folder / "meters.glb").write_bytes(glb(*scene_of_two_nodes(points, triangles_of(quads))))
    assert "unit" not in tool.run("repair", "meters.glb", "-o", f"copy.{ending}").stderr


@pytest.mark.parametrize("command", [["loops"], ["measure"], ["loops", "--throats"], ["measure", "--removal"],
                                     ["remove", "--dry-run"]])
def test_rows_end_with_the_unit(tool, mesh, command):
    points, quads = torus()
    (tool.folder / "meters.glb").write_bytes(glb(*scene_of_two_nodes(points, triangles_of(quads))))
    for file, unit in (("meters.glb", "meter"), ("mesh.off", "")):
        tool.run(command[0], file, *command[1:], "--csv", "rows.csv", "-q")
        header, *rows = csv.reader((tool.folder / "rows.csv").open())
        assert header[-1] == "unit" and rows and all(len(row) == len(header) and row[-1] == unit for row in rows)


# ---- glTF


def test_glb_is_valid(tool, mesh):
    tool.run("repair", mesh, "-o", "copy.glb", "-q")
    said = judges.gltf_validator(tool.folder / "copy.glb")
    assert said["errors"] == 0 and said["warnings"] == 0, said


def test_glb_is_read_by_blender(tool, mesh, two_tori):
    tool.run("repair", mesh, "-o", "copy.glb", "-q")
    said = judges.imported_by_blender(tool.folder / "copy.glb")
    assert said["triangles"] == len(two_tori[1])


def glb(document, buffer):
    """The bytes of a GLB."""
    text = json.dumps({"asset": {"version": "2.0"}, "buffers": [{"byteLength": len(buffer)}], **document}).encode()
    text += b" " * (-len(text) % 4)
    buffer += b"\0" * (-len(buffer) % 4)
    return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(buffer)) + struct.pack("<I4s", len(text), b"JSON")
            + text + struct.pack("<I4s", len(buffer), b"BIN\0") + buffer)


def scene_of_two_nodes(points, triangles):
    """The same mesh twice, once turned, shifted and mirrored."""
    places = b"".join(struct.pack("<3f", *p) for p in points)
    corners = b"".join(struct.pack("<3H", *t) for t in triangles)
    document = {
        "scene": 0,
        "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"mesh": 0, "translation": [100, 0, 0]},
                  {"scale": [2, 2, 2], "children": [2]},
                  {"mesh": 0, "matrix": [-1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 5, 1]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3",
                       "min": box_of(points)[:3], "max": box_of(points)[3:]},
                      {"bufferView": 1, "componentType": 5123, "count": 3 * len(triangles), "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": len(places)},
                        {"buffer": 0, "byteOffset": len(places), "byteLength": len(corners)}],
    }
    return document, places + corners


def test_glb_has_all_meshes_of_the_scene_with_their_transforms(tool):
    points, quads = torus()
    (tool.folder / "scene.glb").write_bytes(glb(*scene_of_two_nodes(points, triangles_of(quads))))
    found, triangles = tool.as_off("scene.glb")
    assert len(found) == 2 * len(points)
    assert found[0] == pytest.approx((points[0][0] + 100, points[0][1], points[0][2]), abs=1e-5)
    x, y, z = points[5]
    assert found[len(points) + 5] == pytest.approx((-2 * x, 2 * z, 2 * (y + 5)), abs=1e-5)
    facts = tool.facts("scene.glb")
    assert (facts["components"], facts["genus"]) == (2, 2)
    # A transform that is a turn keeps what is inside inside; this one mirrors twice.
    volume = judges.manifold(found, triangles, tool.folder)
    assert volume["status"] in ("0", "NoError") and volume["volume"] > 0


def test_a_mirrored_node_is_turned_back(tool):
    points, quads = torus()
    document, buffer = scene_of_two_nodes(points, triangles_of(quads))
    document["nodes"][0]["scale"] = [-1, 1, 1]
    (tool.folder / "scene.glb").write_bytes(glb(document, buffer))
    found, triangles = tool.as_off("scene.glb")
    volume = 0.0
    for t in triangles[:len(triangles) // 2]:
        (a, b, c), (d, e, f), (g, h, i) = ([x - s for x, s in zip(found[v], (100, 0, 0))] for v in t)
        volume += a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    assert volume > 0


def test_glb_of_blender_is_whole_where_normals_and_textures_part_it(tool):
    file = tool.folder / "parted.glb"
    judges.blender(
        """
bpy.ops.mesh.primitive_torus_add(major_segments=30, minor_segments=12, generate_uvs=True)
bpy.ops.export_scene.gltf(filepath=arguments[0], export_format="GLB")
say(done=True)
""",
        file,
    )
    assert judges.gltf_validator(file)["errors"] == 0
    facts = tool.facts(file)
    assert (facts["vertices"], facts["faces"], facts["genus"]) == (360, 720, 1)


@pytest.mark.parametrize("extension", ["KHR_draco_mesh_compression", "EXT_meshopt_compression"])
def test_compressed_gltf_is_refused_by_name(tool, extension):
    points, quads = torus()
    document, buffer = scene_of_two_nodes(points, triangles_of(quads))
    document |= {"extensionsUsed": [extension], "extensionsRequired": [extension]}
    (tool.folder / "packed.glb").write_bytes(glb(document, buffer))
    said = tool.run("loops", "packed.glb", "-o", "x.json", code=3).stderr
    assert extension in said and "without compression" in said
    assert not (tool.folder / "x.json").exists()


def test_gltf_with_a_buffer_beside_it(tool):
    points, quads = torus()
    document, buffer = scene_of_two_nodes(points, triangles_of(quads))
    (tool.folder / "beside.bin").write_bytes(buffer)
    document |= {"asset": {"version": "2.0"}, "buffers": [{"byteLength": len(buffer), "uri": "beside.bin"}]}
    (tool.folder / "scene.gltf").write_text(json.dumps(document))
    assert tool.facts("scene.gltf")["genus"] == 2


def without_positions(document, buffer, points, moved):
    """The same, where positions are zeros but for the rows `moved`, which a sparse accessor has."""
    rows = struct.pack(f"<{len(moved)}H", *moved)
    rows += b"\0" * (-len(rows) % 4)
    places = b"".join(struct.pack("<3f", *points[v]) for v in moved)
    first = len(document["bufferViews"])
    document["bufferViews"] += [{"buffer": 0, "byteOffset": len(buffer), "byteLength": 2 * len(moved)},
                                {"buffer": 0, "byteOffset": len(buffer) + len(rows), "byteLength": len(places)}]
    accessor = document["accessors"][0]
    if len(moved) == len(points):
        del accessor["bufferView"]
        document["bufferViews"][0] = document["bufferViews"][1]  # which nobody needs
    accessor["sparse"] = {"count": len(moved), "indices": {"bufferView": first, "componentType": 5123},
                          "values": {"bufferView": first + 1}}
    return document, buffer + rows + places


def moved_by_one(points, moved):
    return [tuple(x + (v in moved) for x in p) for v, p in enumerate(points)]


@pytest.mark.parametrize("moved", [range(1), range(3, 200, 7), range(288)], ids=["one", "some", "all"])
def test_gltf_with_a_sparse_accessor(tool, moved):
    points, quads = torus()
    changed = moved_by_one(points, moved)
    document, buffer = scene_of_two_nodes(points, triangles_of(quads))
    document, buffer = without_positions(document, buffer, changed, moved)
    rounded = [struct.unpack("<3f", struct.pack("<3f", *p)) for p in changed]
    document["accessors"][0] |= {"min": box_of(rounded)[:3], "max": box_of(rounded)[3:]}
    document["nodes"] = [{"mesh": 0}]
    document["scenes"] = [{"nodes": [0]}]
    file = tool.folder / "sparse.glb"
    file.write_bytes(glb(document, buffer))
    assert judges.gltf_validator(file)["errors"] == 0
    found, triangles = tool.as_off(file)
    assert is_near(found, changed) and same_triangles(triangles, triangles_of(quads))


def test_gltf_without_positions_has_all_points_at_the_origin(tool):
    points, quads = torus()
    document, buffer = scene_of_two_nodes(points, triangles_of(quads))
    accessor = document["accessors"][0]
    del accessor["bufferView"]
    accessor |= {"min": [0, 0, 0], "max": [0, 0, 0]}
    document["bufferViews"][0] = document["bufferViews"][1]
    document["scenes"] = [{"nodes": [0]}]
    file = tool.folder / "zeros.glb"
    file.write_bytes(glb(document, buffer))
    assert judges.gltf_validator(file)["errors"] == 0
    found, triangles = tool.as_off(file, "--steps", "degenerate")
    assert found == [(100, 0, 0)] * len(points) and same_triangles(triangles, triangles_of(quads))


@pytest.mark.parametrize("change, words", [
    (lambda sparse: sparse["indices"].update(byteOffset=2), "beyond its buffer"),
    (lambda sparse: sparse["values"].update(bufferView=99), "a nonexistent view"),
    (lambda sparse: sparse.update(count=-1), "more rows than exist"),
    (lambda sparse: sparse.update(count=300), "more rows than exist"),
    (lambda sparse: sparse["values"].update(byteOffset=-12), "more rows than exist"),
], ids=["beyond", "view", "negative", "many", "before"])
def test_a_sparse_accessor_that_contradicts_itself_is_refused(tool, change, words):
    points, quads = torus()
    document, buffer = scene_of_two_nodes(points, triangles_of(quads))
    document, buffer = without_positions(document, buffer, points, range(10))
    change(document["accessors"][0]["sparse"])
    (tool.folder / "sparse.glb").write_bytes(glb(document, buffer))
    assert words in tool.run("loops", "sparse.glb", code=3).stderr


@pytest.mark.parametrize("uri", ["../beside.bin", "/etc/passwd", "$(touch made).bin", "`touch made`"])
def test_gltf_reads_no_file_elsewhere_and_runs_nothing(tool, uri):
    points, quads = torus()
    document, buffer = scene_of_two_nodes(points, triangles_of(quads))
    (tool.folder / "beside.bin").write_bytes(buffer)
    (tool.folder / "in").mkdir()
    document |= {"asset": {"version": "2.0"}, "buffers": [{"byteLength": len(buffer), "uri": uri}]}
    (tool.folder / "in" / "scene.gltf").write_text(json.dumps(document))
    tool.run("loops", "in/scene.gltf", code=3)
    assert not list(tool.folder.rglob("made"))


# ---- 3MF


def test_3mf_is_a_solid_for_a_slicer(tool, mesh, two_tori):
    tool.run("repair", mesh, "-o", "copy.3mf", "-q")
    said = judges.slicer(tool.folder / "copy.3mf")
    assert said["manifold"] == "yes" and int(said["number_of_facets"]) == len(two_tori[1])


def test_3mf_of_a_slicer_is_read(tool, two_tori):
    write_stl(tool.folder / "mesh.stl", *two_tori)
    judges.made_3mf_by_slicer(tool.folder / "mesh.stl", tool.folder / "mesh.3mf")
    facts = tool.facts("mesh.3mf")
    assert (facts["faces"], facts["genus"]) == (len(two_tori[1]), 2)


SPACES = "http://schemas.microsoft.com/3dmanufacturing/"


def write_3mf(file, points, triangles, of_model="", of_object="", parts=None):
    """A package of one object; `parts` are models besides."""
    def model(attributes, resources, build=""):
        return (f'<?xml version="1.0"?><model unit="inch" xmlns="{SPACES}core/2015/02" {attributes}><resources>'
                f"{resources}</resources><build>{build}</build></model>")

    mesh = "".join(['<vertices>', *(f'<vertex x="{x!r}" y="{y!r}" z="{z!r}"/>' for x, y, z in points), '</vertices>',
                    '<triangles>', *(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in triangles),
                    '</triangles>'])
    resources = f'<object id="1" type="model" {of_object}><mesh>{mesh}</mesh></object>'
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as package:
        if parts:
            package.writestr("3D/3dmodel.model", model(of_model, "", parts))
            package.writestr("3D/other.model", model("", resources))
        else:
            package.writestr("3D/3dmodel.model", model(of_model, resources, '<item objectid="1"/>'))
    return file


@pytest.mark.parametrize("extension", ["material/2015/02", "slice/2015/07", "trianglesets/2021/07"])
def test_3mf_is_read_where_an_extension_that_it_needs_changes_no_triangle(tool, extension):
    points, quads = torus()
    write_3mf(tool.folder / "mesh.3mf", points, triangles_of(quads),
              f'xmlns:x="{SPACES}{extension}" requiredextensions="x"')
    assert tool.as_off("mesh.3mf") == (points, triangles_of(quads))


def test_3mf_is_read_where_objects_are_in_parts_of_their_own(tool):
    points, quads = torus()
    write_3mf(tool.folder / "mesh.3mf", points, triangles_of(quads),
              f'xmlns:p="{SPACES}production/2015/06" requiredextensions="p"',
              parts='<item objectid="1" p:path="/3D/other.model"/>')
    assert tool.as_off("mesh.3mf") == (points, triangles_of(quads))


@pytest.mark.parametrize("name, space", [
    ("beamlattice/2017/02", SPACES + "beamlattice/2017/02"),
    ("booleanoperations/2023/07", "http://schemas.3mf.io/3dmanufacturing/booleanoperations/2023/07"),
    ("securecontent/2019/04", SPACES + "securecontent/2019/04"),
    ("production/alternatives/2021/04", SPACES + "production/alternatives/2021/04"),
    ("urn:mine", "urn:mine"),
])
def test_3mf_that_needs_another_extension_is_refused_by_name(tool, name, space):
    points, quads = torus()
    write_3mf(tool.folder / "mesh.3mf", points, triangles_of(quads),
              f'xmlns:m="{SPACES}material/2015/02" xmlns:x="{space}" requiredextensions="m x"')
    said = tool.run("loops", "mesh.3mf", "-o", "x.json", code=3).stderr
    assert f"requires the 3MF extension '{name}'" in said
    assert not (tool.folder / "x.json").exists()


def test_3mf_that_needs_a_prefix_that_is_not_declared_is_refused(tool):
    points, quads = torus()
    write_3mf(tool.folder / "mesh.3mf", points, triangles_of(quads), 'requiredextensions="q"')
    assert "requires the 3MF extension 'q'" in tool.run("loops", "mesh.3mf", code=3).stderr


def test_3mf_whose_triangles_stand_for_slices_is_refused(tool):
    points, quads = torus()
    for resolution, code in (("fullres", 0), ("lowres", 3)):
        write_3mf(tool.folder / "mesh.3mf", points, triangles_of(quads),
                  f'xmlns:s="{SPACES}slice/2015/07" requiredextensions="s"', f's:meshresolution="{resolution}"')
        said = tool.run("loops", "mesh.3mf", code=code).stderr
        assert ("approximate slices" in said) == (code == 3)


def test_3mf_names_what_a_recommended_extension_would_add(tool):
    points, quads = torus()
    write_3mf(tool.folder / "mesh.3mf", points, triangles_of(quads),
              f'xmlns:x="{SPACES}displacement/2022/07" recommendedextensions="x"')
    assert "displacement/2022/07" in tool.run("remove", "mesh.3mf", "--all", "-o", "x.off").stderr


# ---- surfaces of brains


def test_gifti_is_read_by_nibabel(tool, mesh, two_tori):
    nibabel = judges.nibabel()
    tool.run("repair", mesh, "-o", "copy.surf.gii", "-q")
    image = nibabel.load(tool.folder / "copy.surf.gii")
    points, triangles = image.agg_data(("pointset", "triangle"))
    assert is_near(points, two_tori[0])
    assert [tuple(map(int, t)) for t in triangles] == two_tori[1]


@pytest.mark.parametrize("encoding", [1, 2, 3])  # text, base 64, and that packed
def test_gifti_of_nibabel_is_read(tool, two_tori, encoding):
    nibabel = judges.nibabel()
    import numpy

    points, triangles = two_tori
    arrays = [nibabel.gifti.GiftiDataArray(numpy.array(points, "float32"), intent="NIFTI_INTENT_POINTSET"),
              nibabel.gifti.GiftiDataArray(numpy.array(triangles, "int32"), intent="NIFTI_INTENT_TRIANGLE")]
    for array in arrays:
        array.encoding = encoding
    nibabel.save(nibabel.gifti.GiftiImage(darrays=arrays), tool.folder / "mesh.gii")
    found, faces = tool.as_off("mesh.gii")
    assert same_triangles(faces, triangles) and is_near(found, points)


def test_freesurfer_keeps_the_geometry_of_its_volume(tool, two_tori):
    nibabel = judges.nibabel()
    import numpy

    volume = {"head": numpy.array([2, 0, 20], "int32"), "valid": "1  # volume info valid", "filename": "brain.mgz",
              "volume": numpy.array([256, 256, 256]), "voxelsize": numpy.array([1.0, 1.0, 1.0]),
              "xras": numpy.array([-1.0, 0, 0]), "yras": numpy.array([0, 0, -1.0]), "zras": numpy.array([0, 1.0, 0]),
              "cras": numpy.array([5.4, 18.0, -3.5])}
    points, triangles = two_tori
    nibabel.freesurfer.write_geometry(tool.folder / "lh.nofix", numpy.array(points), numpy.array(triangles),
                                      volume_info=volume)
    tool.run("repair", "lh.nofix", "-o", "lh.orig", "-q")
    found, faces, info = nibabel.freesurfer.read_geometry(tool.folder / "lh.orig", read_metadata=True)
    assert is_near(found, points) and (faces == numpy.array(triangles)).all()
    assert info["filename"] == "brain.mgz" and info["cras"] == pytest.approx(volume["cras"])


# ---- meshes of solvers


@pytest.mark.parametrize("version, binary, order", [(2.2, False, 1), (2.2, True, 1), (4.0, False, 1), (4.1, False, 1),
                                                    (4.1, True, 1), (2.2, True, 2), (4.1, False, 2)])
def test_msh_of_gmsh_is_read(tool, version, binary, order):
    made = judges.make_msh(tool.folder / "torus.msh", version, binary, order)
    facts = tool.facts("torus.msh")
    assert (facts["faces"], facts["genus"]) == (made["triangles"], 1)


@pytest.mark.parametrize("ending", ["vtp", "vtu"])
@pytest.mark.parametrize("mode, compressor", [("ascii", "none"), ("binary", "none"), ("binary", "zlib"),
                                              ("appended", "none"), ("appended", "zlib"), ("raw", "none"),
                                              ("raw", "zlib")])
def test_vtk_of_paraview_is_read(tool, ending, mode, compressor):
    made = judges.make_vtk(tool.folder / f"torus.{ending}", mode, compressor)
    facts = tool.facts(f"torus.{ending}")
    assert (facts["faces"], facts["genus"]) == (made["triangles"], 1)


@pytest.mark.parametrize("ending", ["msh", "msh2"])
def test_msh_is_read_by_gmsh(tool, mesh, two_tori, ending):
    tool.run("repair", mesh, "-o", f"copy.{ending}", "-q")
    said = judges.gmsh(tool.folder / f"copy.{ending}")
    assert len(said["points"]) == len(two_tori[0]) and len(said["triangles"]) == len(two_tori[1])


@pytest.mark.parametrize("ending", ["vtp", "vtu", "binary.vtp", "binary.vtu"])
def test_vtk_is_read_by_paraview(tool, mesh, two_tori, ending):
    tool.run("repair", mesh, "-o", f"copy.{ending}", "-q")
    said = judges.paraview(tool.folder / f"copy.{ending}")
    assert (said["points"], said["triangles"]) == (len(two_tori[0]), len(two_tori[1]))


def test_what_vtk_packs_otherwise_is_refused_by_name(tool):
    judges.make_vtk(tool.folder / "torus.vtp", "binary", "lz4")
    assert "vtkLZ4DataCompressor" in tool.run("loops", "torus.vtp", code=3).stderr


# ---- bad files


def vtk_file(polys, points="0 0 0 1 0 0 0 1 0", count=3, offsets="3"):
    return f"""<VTKFile type="PolyData"><PolyData><Piece NumberOfPoints="{count}"><Points>
<DataArray type="Float64" NumberOfComponents="3" format="ascii">{points}</DataArray></Points><Polys>
<DataArray type="Int64" Name="connectivity" format="ascii">{polys}</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">{offsets}</DataArray></Polys></Piece></PolyData></VTKFile>"""


@pytest.mark.parametrize("name, content, words", [
    ("deep.vtp", "<VTKFile>" + "<a><!--</a>-->" * 20000 + "</a>" * 20000 + "</VTKFile>", "nested too deeply"),
    ("quoted.gii", '<a b="/>">' * 20000, "nested too deeply"),
    ("open.vtp", "<!" * 1000000, "it is not valid XML"),
    ("few.vtp", vtk_file("0 1 2", count=4), "the declared number of points"),
    ("odd.vtp", vtk_file("0 1 2", "0 0 0 1 0 0 0 1"), "the declared number of points"),
    ("long.vtp", vtk_file("0 1 2 0"), "the whole connectivity array"),
    ("short.vtp", vtk_file("0 1"), "an invalid offset"),
    ("beyond.vtp", vtk_file("0 1 7"), "a point that does not exist"),
    ("lines.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n", "expected $EndNodes"),
    ("none.msh", "", "none.msh: the file is empty"),
    ("text.msh", "\n", "must begin with $MeshFormat"),
], ids=lambda value: value[:12])
def test_what_contradicts_itself_is_refused(tool, name, content, words):
    (tool.folder / name).write_text(content)
    assert words in tool.run("loops", name, "-o", "answer.json", code=3).stderr
    assert not (tool.folder / "answer.json").exists()


ENDINGS = ["off", "ply", "stl", "glb", "3mf", "gii", "surf", "vtp", "binary.vtu", "msh", "msh2", "off.gz"]


@pytest.mark.parametrize("ending", ENDINGS)
def test_a_file_that_was_cut_off_is_refused_and_nothing_is_written(tool, mesh, ending):
    tool.run("repair", mesh, "-o", f"whole.{ending}", "-q")
    content = (tool.folder / f"whole.{ending}").read_bytes()
    for part in (0, 1, 10, 100, len(content) // 2, len(content) - 40):
        (tool.folder / f"part.{ending}").write_bytes(content[:part])
        done = tool.run("loops", f"part.{ending}", "-o", "answer.json", code=3)
        assert done.stderr.startswith("htloops: ") and f"part.{ending}" in done.stderr
        assert not (tool.folder / "answer.json").exists()


@pytest.mark.parametrize("ending", ["surf", "glb"])
def test_a_gigabyte_announced_is_no_gigabyte_taken(tool, mesh, ending):
    tool.run("repair", mesh, "-o", f"whole.{ending}", "-q")
    content = bytearray((tool.folder / f"whole.{ending}").read_bytes())
    if ending == "surf":
        at = content.index(b"\n\n") + 2
        content[at:at + 8] = struct.pack(">ii", 2**31 - 1, 2**31 - 1)
    else:
        content = content.replace(b'"count":576', b'"count":999999999')
        struct.pack_into("<I", content, 8, len(content))
    (tool.folder / f"part.{ending}").write_bytes(content)
    tool.run("loops", f"part.{ending}", "-o", "answer.json", code=3)
    assert not (tool.folder / "answer.json").exists()


MEMBER = gzip.compress(b"\0" * (1 << 26))  # 64 kB for 64 MB


def zeros_of_zlib(megabytes):
    packer = zlib.compressobj(9)
    return b"".join([*(packer.compress(b"\0" * (1 << 20)) for _ in range(megabytes)), packer.flush()])


def bomb(file, megabytes):
    """A small file that unpacks to so much."""
    if file.suffix == ".gz":
        file.write_bytes(MEMBER * (megabytes // 64))
    elif file.suffix == ".3mf":
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as package, package.open("3D/3dmodel.model", "w") as part:
            for _ in range(megabytes):
                part.write(b" " * (1 << 20))
    elif file.suffix == ".gii":
        text = base64.b64encode(zeros_of_zlib(megabytes)).decode()
        file.write_text(f"""<GIFTI><DataArray Intent="NIFTI_INTENT_POINTSET" DataType="NIFTI_TYPE_FLOAT32" Dim0="1"
Dim1="3" Encoding="GZipBase64Binary"><Data>{text}</Data></DataArray></GIFTI>""")
    else:  # blocks of which each is small
        block = zlib.compress(b"\0" * (1 << 20), 9)
        header = struct.pack(f"<{megabytes + 3}I", megabytes, 1 << 20, 0, *[len(block)] * megabytes)
        text = base64.b64encode(header).decode() + base64.b64encode(block * megabytes).decode()
        file.write_text(f"""<VTKFile type="PolyData" compressor="vtkZLibDataCompressor"><PolyData><Piece><Points>
<DataArray type="Float32" format="appended" offset="0"/></Points></Piece></PolyData>
<AppendedData encoding="base64">_{text}</AppendedData></VTKFile>""")
    return file


@pytest.mark.parametrize("ending", ["off.gz", "3mf", "gii", "vtp"])
def test_what_unpacks_to_more_than_there_is_room_for_is_refused(tool, ending):
    file = bomb(tool.folder / f"bomb.{ending}", 512)
    assert file.stat().st_size < 2e6
    limit = 3 << 29  # of which a quarter may be unpacked
    said = tool.run("loops", file, "-o", "x.json", code=3,
                    preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit))).stderr
    assert f"more than {limit >> 22} MB" in said, said
    assert not (tool.folder / "x.json").exists()


def test_what_few_bytes_say_again_and_again_is_refused(tool):
    points, quads = torus(400, 200)
    document, buffer = scene_of_two_nodes(points, triangles_of(quads)[:30000])
    document["nodes"] = [{"mesh": 0}] * 2000
    document["scenes"] = [{"nodes": list(range(2000))}]
    (tool.folder / "nodes.glb").write_bytes(glb(document, buffer))
    zeros = json.loads(json.dumps(document))
    del zeros["accessors"][0]["bufferView"]
    zeros["accessors"][0]["count"] = 10**15
    (tool.folder / "zeros.glb").write_bytes(glb(zeros, buffer))
    limit = 3 << 29
    for name in ("nodes.glb", "zeros.glb"):
        said = tool.run("loops", name, code=3,
                        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit))).stderr
        assert f"more than {limit >> 22} MB" in said, said


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="how much memory is in use is told by Linux")
def test_unpacking_can_be_interrupted(tool):
    file = bomb(tool.folder / "bomb.off.gz", 1 << 20)
    with subprocess.Popen([os.environ["HTLOOPS"], "loops", file, "-o", tool.folder / "x.json"],
                          stderr=subprocess.PIPE, text=True) as process:
        pages = 0
        while pages < 25000 and process.poll() is None:  # of four kilobytes
            with open(f"/proc/{process.pid}/statm") as statm:
                pages = int(statm.read().split()[1])
            time.sleep(0.002)
        process.send_signal(signal.SIGINT)
        begin = time.monotonic()
        assert process.wait(60) == 130, process.stderr.read()
        assert time.monotonic() - begin < 10
    assert os.listdir(tool.folder) == ["bomb.off.gz"]


def test_unknown_endings_are_refused_and_the_known_ones_named(tool, mesh):
    said = tool.run("repair", mesh, "-o", "copy.xyz", code=2).stderr
    assert all(f".{ending}" in said for ending in ("off", "stl", "glb", "3mf", "gii"))
    (tool.folder / "mesh.xyz").write_bytes(mesh.read_bytes())
    said = tool.run("loops", "mesh.xyz", code=3).stderr
    assert ".off .obj .ply .stl" in said
    assert tool.facts("mesh.xyz", "--format", "off")["genus"] == 2
