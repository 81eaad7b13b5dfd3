"""Answers as records: what they lack is said, and equal ones are equal."""

import pickle

import numpy as np
import pytest

import handle_tunnel_loops as htl


@pytest.mark.parametrize("key", ["points", "edges", "ratios", "starts", "lengths", "number_of_faces", "basis"])
def test_what_a_record_lacks_is_said(torus, key):
    L = pickle.loads(pickle.dumps(htl.loops(*torus)))
    del L._record[key]
    with pytest.raises(ValueError, match=f"record of the loops is incomplete: it has no '{key}'"):
        htl.certify(*torus, L)


def test_what_a_part_of_a_record_lacks_is_said(torus):
    record = htl.loops(*torus)._record
    for part, key in [("holes", "diameters"), ("waists", "numbers"), ("certificate", "pairing")]:
        rest = {name: value for name, value in record[part].items() if name != key}
        with pytest.raises(ValueError, match=f"{part} of the loops is incomplete: it has no '{key}'"):
            htl.Loops({**record, part: rest}).table()


def answers(V, F):
    L = htl.loops(V, F, waists=True, layers=True)
    yield from (L, L.handles[0], L.certificate)
    yield from (htl.measure(V, F, L), htl.removal_costs(V, F, L))
    yield from (htl.reeb(V, F), htl.curve_skeleton(V, F), htl.throats(V, F, L), htl.dual_cuts(V, F))


def test_answers_are_equal_after_a_pickle(torus, genus_3):
    for answer, other in zip(answers(*torus), answers(*genus_3)):
        again = pickle.loads(pickle.dumps(answer))
        assert again == answer and not again != answer, type(answer)
        assert answer != other and answer != 1 and answer is not None, type(answer)


def test_one_number_makes_a_difference(torus):
    L = htl.loops(*torus)
    assert L == htl.loops(*torus, threads=1)  # though the times differ
    again = pickle.loads(pickle.dumps(L))
    again.tunnels[0].points[3, 1] += 1e-12
    assert again != L and again.tunnels[0] != L.tunnels[0] and again.handles[0] == L.handles[0]
    assert L != htl.loops(*torus, basis="shortest")


def test_what_is_not_known_equals_itself():
    V, F = htl.generate("torus", faces=32)
    one, two = (htl.removal_costs(V, F, htl.loops(V, F)) for _ in range(2))
    one.cut.areas[:] = two.cut.areas[:] = np.nan
    assert one == two


def test_what_can_be_found_by_a_hash(genus_3):
    L = htl.loops(*genus_3)
    again = pickle.loads(pickle.dumps(L))
    assert set(L.handles) == set(again.handles) and len(set(L.handles + L.tunnels)) == 6
    assert len({L.certificate, again.certificate}) == 1
    for cut, same in zip(htl.dual_cuts(*genus_3), htl.dual_cuts(*genus_3)):
        assert cut == same and hash(cut) == hash(same)
    with pytest.raises(TypeError, match="unhashable"):
        hash(L)


def test_loops_are_a_sequence_of_pairs(genus_3):
    L = htl.loops(*genus_3)
    assert len(L) == 3 and list(L) == list(zip(L.handles, L.tunnels))
    assert L[0] == L[-3] == (L.handles[0], L.tunnels[0])
    assert L[1:] == list(L)[1:] and L[::-1] == list(reversed(L)) and L[np.int64(2)] == L[2]
    assert L[1] in L and L.index(L[1]) == 1
    for i in (3, -4):
        with pytest.raises(IndexError, match=f"there is no pair {i}: the genus is 3"):
            L[i]
    with pytest.raises(TypeError):
        L["handles"]
    assert list(htl.loops(*htl.generate("sphere", faces=320))) == []
