"""Programs that say what is in a file. Each function skips the test where its program is not installed."""

import json
import os
import pathlib
import shutil
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def _program(name):
    path = shutil.which(name)
    if path is None:
        pytest.skip(f"{name} is not installed")
    return path


def _done(command, code=0, timeout=300, **options):
    done = subprocess.run(command, capture_output=True, text=True, timeout=timeout, check=False, **options)
    assert done.returncode == code, f"{command}\n{done.stdout[-3000:]}\n{done.stderr[-3000:]}"
    return done


def _output(command, **options):
    return _done(command, **options).stdout


def _marked(text):
    """The object of JSON on the line that is marked so: programs print other things, too."""
    lines = [line for line in text.splitlines() if line.startswith("JUDGED ")]
    assert lines, f"the judge says nothing:\n{text[-3000:]}"
    return json.loads(lines[-1][len("JUDGED "):])


def _node(package, script, *arguments):
    """Runs a script with packages of npm: those of HTL_JUDGES, or of build/judges."""
    node = _program("node")
    folder = pathlib.Path(os.environ.get("HTL_JUDGES", ROOT / "build" / "judges")) / "node_modules"
    if not (folder / package).is_dir():
        pytest.skip(f"{package} of npm is not installed in {folder.parent}")
    prelude = (
        "const {createRequire} = require('module'); const {pathToFileURL} = require('url');"
        f"const require_judge = createRequire({json.dumps(str(folder / 'x.js'))});"
        f"const import_judge = name => import(pathToFileURL(require_judge.resolve(name)));"
    )
    return _marked(_output([node, "-e", prelude + script, "--", *map(str, arguments)]))


def gltf_validator(file):
    """{"errors", "warnings", "messages"} of Khronos' validator."""
    return _node(
        "gltf-validator",
        """
        const bytes = new Uint8Array(require('fs').readFileSync(process.argv[1]));
        require_judge('gltf-validator').validateBytes(bytes).then(report => console.log('JUDGED ' +
          JSON.stringify({errors: report.issues.numErrors, warnings: report.issues.numWarnings,
                          messages: report.issues.messages.map(m => m.code)})));
        """,
        file,
    )


def manifold(points, triangles, folder):
    """{"status", "genus", "volume"} of the solid that triangles bound."""
    data = folder / "for_manifold.json"
    data.write_text(json.dumps({"points": [x for p in points for x in p],
                                "triangles": [v for t in triangles for v in t]}))
    return _node(
        "manifold-3d",
        """
        import_judge('manifold-3d/manifold.js').then(async judge => {
          const {Manifold, Mesh} = await judge.default().then(m => (m.setup(), m));
          const data = JSON.parse(require('fs').readFileSync(process.argv[1]));
          let said;
          try {
            const solid = new Manifold(new Mesh({numProp: 3, vertProperties: Float32Array.from(data.points),
                                                 triVerts: Uint32Array.from(data.triangles)}));
            said = {status: String(solid.status()), genus: solid.decompose().reduce((g, s) => g + s.genus(), 0),
                    volume: solid.volume()};
          } catch(error) { said = {status: String(error.code || error), genus: -1, volume: 0}; }
          console.log('JUDGED ' + JSON.stringify(said));
        });
        """,
        data,
    )


def nibabel():
    return pytest.importorskip("nibabel", reason="nibabel is not installed")


def python_with(module, *others):
    """An interpreter that has a module: one with those of Debian, or one of some programs."""
    for python in ("/usr/bin/python3", shutil.which("python3"), *map(shutil.which, others)):
        if python and subprocess.run([python, "-c", f"import {module}"], capture_output=True, check=False).returncode == 0:
            return python
    return pytest.skip(f"the module {module} of Python is not installed")


def _python_of_system(module, script, *arguments):
    return _marked(_output([python_with(module), "-c", script, *map(str, arguments)]))


_GMSH = """
import json, sys
import gmsh
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
"""


def gmsh(file):
    """{"points", "triangles", "groups": {name: [dimension, edges or triangles]}}."""
    return _python_of_system(
        "gmsh",
        _GMSH + """
gmsh.open(sys.argv[1])
def elements(dimension, type_, width, entity=-1):
    tags, nodes = gmsh.model.mesh.getElementsByType(type_, entity)
    return [[int(v) for v in nodes[i * width:(i + 1) * width]] for i in range(len(tags))]
tags, x, _ = gmsh.model.mesh.getNodes()
groups = {}
for dimension, tag in gmsh.model.getPhysicalGroups():
    kind, width = {1: (1, 2), 2: (2, 3)}[dimension]
    entities = gmsh.model.getEntitiesForPhysicalGroup(dimension, tag)
    groups[gmsh.model.getPhysicalName(dimension, tag)] = [
        dimension, [e for entity in entities for e in elements(dimension, kind, width, entity)]]
print("JUDGED " + json.dumps({
    "points": {int(t): list(x[3 * i:3 * i + 3]) for i, t in enumerate(tags)},
    "triangles": elements(2, 2, 3), "groups": groups}))
""",
        file,
    )


def make_msh(file, version, binary, order=1):
    """A torus by Gmsh, in a version of MSH."""
    return _python_of_system(
        "gmsh",
        _GMSH + """
version, binary, order = float(sys.argv[2]), int(sys.argv[3]), int(sys.argv[4])
gmsh.model.occ.addTorus(0, 0, 0, 2, 0.7)
gmsh.model.occ.synchronize()
gmsh.option.setNumber("Mesh.MeshSizeMax", 0.5)
gmsh.option.setNumber("Mesh.ElementOrder", order)
gmsh.model.mesh.generate(2)
gmsh.option.setNumber("Mesh.MshFileVersion", version)
gmsh.option.setNumber("Mesh.Binary", binary)
gmsh.write(sys.argv[1])
tags, _ = gmsh.model.mesh.getElementsByType(2 if order == 1 else 9)
print("JUDGED " + json.dumps({"triangles": len(tags)}))
""",
        file, version, int(binary), order,
    )


_BLENDER = """
import json, sys
import bpy
import numpy
numpy.bool = bool  # which Blender 3.4 asks for, and numpy of the same Debian has no more
arguments = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
def load(file):
    ending = file.rsplit(".", 1)[1]
    {"stl": lambda: bpy.ops.import_mesh.stl(filepath=file),
     "ply": lambda: bpy.ops.import_mesh.ply(filepath=file),
     "obj": lambda: bpy.ops.wm.obj_import(filepath=file),
     "glb": lambda: bpy.ops.import_scene.gltf(filepath=file)}[ending]()
    return [o for o in bpy.context.scene.objects if o.type == "MESH"]
def say(**words):
    print("JUDGED " + json.dumps(words))
"""


def _blender(*words):
    return [_program("blender"), "-b", "--factory-startup", "--python-exit-code", "1", *map(str, words)]


def blender(script, *arguments):
    """Runs a script in Blender without a window; `load(file)` imports one, `say(...)` is the answer."""
    return _marked(_output(_blender("--python-expr", _BLENDER + script, "--", *arguments),
                           env={**os.environ, "PYTHONPATH": ""}))


def program_in_blender(program, *arguments, folder=None, code=0):
    """Runs a program in Blender beside the cube that it begins with: its output."""
    done = _done(_blender("--python", program, "--", *arguments), code, cwd=folder)
    return done.stdout + done.stderr


def program_in_paraview(program, *arguments):
    """Runs a program in ParaView without a window, but with a display if there can be one: its output."""
    # A display that begins anew when nobody uses it is not there for who comes meanwhile.
    display = ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -noreset"]
    has_display = os.environ.get("DISPLAY") or not shutil.which(display[0])
    done = _done([*([] if has_display else display), _program("pvpython"), *map(str, (program, *arguments))])
    return done.stdout + done.stderr


def script_says(python, script, *arguments, folder=None):
    """The output of a script beside this file, which has to be content."""
    return _output([python, str(pathlib.Path(__file__).parent / script), *map(str, arguments)], cwd=folder)


def imported_by_blender(file):
    """{"points", "triangles", "box"} of all that Blender imports."""
    return blender(
        """
objects = load(arguments[0])
points = [tuple(o.matrix_world @ v.co) for o in objects for v in o.data.vertices]
say(points=len(points), triangles=sum(len(p.vertices) - 2 for o in objects for p in o.data.polygons),
    box=[min(p[i] for p in points) for i in range(3)] + [max(p[i] for p in points) for i in range(3)])
""",
        file,
    )


def paraview(file):
    """{"points", "triangles", "arrays", "box"} of a file of VTK."""
    return _marked(_output([_program("pvpython"), "-c", """
import json, sys
from paraview import servermanager, simple
reader = simple.OpenDataFile(sys.argv[1])
reader.UpdatePipeline()
data = servermanager.Fetch(reader)
cells = [data.GetCell(i).GetNumberOfPoints() for i in range(data.GetNumberOfCells())]
names = [attributes.GetArrayName(i) for attributes in (data.GetPointData(), data.GetCellData())
         for i in range(attributes.GetNumberOfArrays())]
print("JUDGED " + json.dumps({"points": data.GetNumberOfPoints(), "triangles": cells.count(3), "arrays": names,
                              "box": list(data.GetBounds())}))
""", str(file)]))


def make_vtk(file, mode, compressor, source="points and triangles"):
    """A torus in the XML of VTK, by ParaView; a .vtu is made of its triangles."""
    return _marked(_output([_program("pvpython"), "-c", """
import json, sys
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter
file, mode, compressor = sys.argv[1:4]
torus = vtkParametricFunctionSource()
torus.SetParametricFunction(vtkParametricTorus())
torus.SetUResolution(40)
torus.SetVResolution(20)
clean, triangles, grid = vtkCleanPolyData(), vtkTriangleFilter(), vtkAppendFilter()
clean.SetInputConnection(torus.GetOutputPort())
clean.SetTolerance(1e-6)
triangles.SetInputConnection(clean.GetOutputPort())
grid.SetInputConnection(triangles.GetOutputPort())
is_grid = file.endswith(".vtu")
writer = vtkXMLUnstructuredGridWriter() if is_grid else vtkXMLPolyDataWriter()
writer.SetInputConnection((grid if is_grid else triangles).GetOutputPort())
writer.SetFileName(file)
{"ascii": writer.SetDataModeToAscii, "binary": writer.SetDataModeToBinary,
 "appended": writer.SetDataModeToAppended, "raw": writer.SetDataModeToAppended}[mode]()
writer.SetEncodeAppendedData(mode != "raw")
{"none": writer.SetCompressorTypeToNone, "zlib": writer.SetCompressorTypeToZLib,
 "lz4": writer.SetCompressorTypeToLZ4}[compressor]()
assert writer.Write() == 1
triangles.Update()
print("JUDGED " + json.dumps({"triangles": triangles.GetOutput().GetNumberOfPolys()}))
""", str(file), mode, compressor]))


def slicer(file):
    """What PrusaSlicer says of a file, by its names: "manifold" is "yes" for a solid, "number_of_parts", "volume"."""
    words = _output([_program("prusa-slicer"), "--info", str(file)])
    return dict(map(str.strip, line.split("=")) for line in words.splitlines() if " = " in line)


def made_3mf_by_slicer(file, result):
    _output([_program("prusa-slicer"), "--export-3mf", str(file), "-o", str(result)])


def pymol(file):
    """How many atoms PyMOL loads, and the radii that it takes from the column of B factors."""
    program = _program("pymol")
    script = pathlib.Path(file).with_suffix(".pml")
    script.write_text(f"""load {file}
alter all, vdw=b
rebuild
radii = []
iterate all, radii.append(vdw)
print("\\nJUDGED " + __import__("json").dumps(dict(atoms=cmd.count_atoms("all"), radii=radii)))
""")
    return _marked(_output([program, "-cq", str(script)], env={**os.environ, "PATH": "/usr/bin:/bin"}))


def exported_by_assimp(file, result):
    _output([_program("assimp"), "export", str(file), str(result)])


def surface_by_pymol(molecule, surface):
    """The surface of a molecule, as OBJ, where its atoms are: PyMOL writes what the view sees, as that sees it."""
    script = pathlib.Path(surface).with_suffix(".pml")
    script.write_text(f"""load {molecule}
hide everything
set surface_quality, 1
show surface
set_view (1,0,0, 0,1,0, 0,0,1, 0,0,0, 0,0,0, 1,100,0)
save {surface}
""")
    _output([_program("pymol"), "-cq", str(script)], env={**os.environ, "PATH": "/usr/bin:/bin"})
