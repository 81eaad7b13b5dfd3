"""Messages about arguments of a wrong type, or out of range."""

import functools

import numpy as np
import pytest

import handle_tunnel_loops as htl


@pytest.mark.parametrize("call", ["loops", "reeb", "remove_handles", "cut_to_disk", "cut_edges", "dual_cuts"])
def test_threads(torus, call):
    chosen = {"genus": 0} if call == "remove_handles" else {}
    function = functools.partial(getattr(htl, call), **chosen)
    function(*torus, threads=None)
    function(*torus, threads=10**6)
    for threads, error in [("two", TypeError), (1.5, TypeError), (-1, ValueError), (2**70, ValueError)]:
        with pytest.raises(error, match="threads"):
            function(*torus, threads=threads)


@pytest.mark.parametrize(
    "function, arguments, error, message",
    [
        ("loops", dict(seed="a"), TypeError, "seed must be a whole number, not 'a'"),
        ("loops", dict(seed=1.5), TypeError, "seed must be a whole number"),
        ("loops", dict(seed=True), TypeError, "seed must be a whole number"),
        ("loops", dict(seed=[1]), TypeError, "seed must be a whole number"),
        ("loops", dict(seed=2**70), ValueError, "seed cannot be"),
        ("loops", dict(basis=3), TypeError, "basis must be a string, not 3"),
        ("loops", dict(time_budget="soon"), TypeError, "time_budget must be a number, not 'soon'"),
        ("loops", dict(time_budget=-1), ValueError, "time_budget cannot be -1"),
        ("loops", dict(time_budget=float("nan")), ValueError, "time_budget cannot be nan"),
        ("reeb", dict(simplify="much"), TypeError, "simplify must be a number, not 'much'"),
        ("reeb", dict(simplify=-1), ValueError, "simplify cannot be -1"),
        ("reeb", dict(simplify=float("nan")), ValueError, "simplify cannot be nan"),
        ("reeb", dict(measure=3), TypeError, "measure must be a string"),
        ("reeb", dict(sources=["a"]), TypeError, "sources must be a whole number"),
        ("reeb", dict(sources=[-1]), ValueError, "vertex -1 does not exist"),
        ("reeb", dict(f="height"), TypeError, "f must be an array of real numbers"),
        ("remove_handles", dict(genus=1.5), TypeError, "genus must be a whole number"),
        ("remove_handles", dict(shorter_than="3"), ValueError, "shorter_than must be a length, such as 0.25, or a perc.* not '3'"),
        ("remove_handles", dict(shorter_than="a%"), ValueError, "shorter_than must be a length, .* of the diagonal .* not 'a%'"),
        ("remove_handles", dict(shorter_than="nan%"), ValueError, "shorter_than must be a length, .* not 'nan%'"),
        ("remove_handles", dict(shorter_than="%"), ValueError, "shorter_than must be a length, .* not '%'"),
        ("remove_handles", dict(necks="-1%"), ValueError, "necks must be a length, .* not '-1%'"),
        ("remove_handles", dict(necks="300%"), ValueError, "necks cannot be 300%: it must be at most 100% of the diagonal"),
        ("remove_handles", dict(necks=[1]), TypeError, "necks must be a number"),
        ("remove_handles", dict(shorter_than=float("nan")), ValueError, "shorter_than cannot be nan"),
        ("remove_handles", dict(necks=-2), ValueError, "necks cannot be -2"),
        ("remove_handles", dict(by=1), TypeError, "by must be a string"),
        ("remove_handles", dict(box="all"), TypeError, "box must be an array of real numbers"),
        ("remove_handles", dict(genus=0, loops=[1]), TypeError, "loops must be a result of loops.., not of type list"),
        ("cut_edges", dict(avoid=[[0.5, 1.5]]), ValueError, "avoid must be an array of integers"),
        ("cut_edges", dict(avoid=[[0, -7]]), ValueError, "vertex -7 does not exist"),
        ("cut_to_disk", dict(cones="ab"), TypeError, "cones must be a whole number"),
        ("cut_to_disk", dict(cones=[-3]), ValueError, "vertex -3 does not exist"),
        ("certify", dict(L=None), TypeError, "L must be a result of loops.., not of type NoneType"),
        ("html", dict(L=[1], path="a.html"), TypeError, "L must be a result of loops.*, not of type list"),
        ("html", dict(L=None, path=None), TypeError, "L must be a result of loops"),
        ("html", dict(L="a.html"), TypeError, "L must be a result of loops.*, not of type str"),
        ("loops", dict(basis="shrt"), ValueError, "basis must be 'pure' or 'shortest', not 'shrt'"),
        ("reeb", dict(measure="limb"), ValueError, "'limbs', 'persistence', .* or 'vertices', not 'limb'"),
        ("remove_handles", dict(by="fil"), ValueError, "'cut', 'fill', 'smallest-change' or .*, not 'fil'"),
    ],
)
def test_what_is_refused(torus, function, arguments, error, message):
    with pytest.raises(error, match=message):
        getattr(htl, function)(*torus, **arguments)


@pytest.mark.parametrize(
    "options, error, message",
    [
        (dict(faces=-1), ValueError, "faces cannot be -1"),
        (dict(faces="many"), TypeError, "faces must be a whole number"),
        (dict(genus=1.0), TypeError, "genus must be a whole number"),
        (dict(seed=-1), ValueError, "seed cannot be -1"),
        (dict(seed=2**32), ValueError, "seed cannot be 4294967296"),
    ],
)
def test_generators(options, error, message):
    with pytest.raises(error, match=message):
        htl.generate("torus", **options)
    with pytest.raises(TypeError, match="kind must be a string"):
        htl.generate(7)


@pytest.mark.parametrize("kind", [object, complex, str, bool])
def test_types_of_arrays(torus, kind):
    V, F = torus
    for mesh, name in [((V.astype(kind), F), "V"), ((V, F.astype(kind)), "F")]:
        for function in (htl.loops, htl.repair):
            with pytest.raises(TypeError, match=f"^{name} must be an array of .* not of "):
                function(*mesh)
    with pytest.raises(TypeError, match="^f must be"):
        htl.reeb(V, F, V[:, 0].astype(kind))


def test_masked_arrays(torus):
    V, F = torus
    assert htl.loops(np.ma.array(V), np.ma.array(F)).genus == 1
    mask = np.zeros(V.shape, dtype=bool)
    mask[7] = True
    with pytest.raises(TypeError, match="V has masked values"):
        htl.loops(np.ma.array(V, mask=mask), F)
    with pytest.raises(TypeError, match="F has masked values"):
        htl.loops(V, np.ma.array(F, mask=F == 7))
    with pytest.raises(TypeError, match="f has masked values"):
        htl.reeb(V, F, np.ma.array(V[:, 0], mask=mask[:, 0]))


def test_numbers_that_are_none(torus):
    V, F = torus
    for value in (np.nan, np.inf):
        f = V[:, 0].copy()
        f[3] = value
        with pytest.raises(ValueError, match="finite|nan|inf"):
            htl.reeb(V, F, f)
    with pytest.raises(ValueError, match="V is not an array"):
        htl.loops([[0, 0, 0], [1, 0]], F)


def test_names_of_files_are_no_meshes(tmp_path):
    for name in ("a.off", tmp_path / "a.off"):
        with pytest.raises(TypeError, match=r"; read\(\) returns the arrays of a file"):
            htl.loops(name)


def test_a_page_needs_a_name(torus):
    L = htl.loops(*torus)
    for given in [(*torus, L), (torus, L)]:
        with pytest.raises(TypeError, match=r"path, its name, is missing: html\(V, F, L, .loops.html.\)"):
            htl.html(*given)


@pytest.mark.parametrize("integer", ["i2", "u4", "i8"])
def test_faces_that_count_from_1(torus, integer):
    V, F = torus
    message = f"F refers to vertices 1 to {len(V)}, but vertices are numbered from 0: subtract 1 from F$"
    for function in (htl.loops, htl.repair, htl.reeb):
        with pytest.raises(htl.MeshError, match=message):
            function(V, (F + 1).astype(integer))
    with pytest.raises(htl.MeshError, match="refers to vertex"):  # some are wrong, for another reason
        htl.loops(V, F + 2)
