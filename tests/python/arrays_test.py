"""Bodies, potentials and many motions at once, against the commands and against each other."""

import copy
import pickle
from fractions import Fraction

import numpy as np
import pytest
import stationary
from stationary import Stability, Status


@pytest.fixture
def material(disc):
    case = stationary.Case(disc)
    return case.body, case.potential


def test_bodies():
    body = stationary.Body(1.0, 1.7, 0.6)
    assert (body.J1, body.J2, body.J3, body.symmetric) == (1.0, 1.7, 0.6, False)
    assert stationary.Body(J1=1.0, J2=1.0, J3=2.0).symmetric
    assert body == stationary.Body(1.0, 1.7, 0.6) != stationary.Body(1.0, 1.7, 0.7)
    assert hash(body) == hash(pickle.loads(pickle.dumps(body)))
    assert eval(repr(body), {"Body": stationary.Body}) == body


@pytest.mark.parametrize(
    "J",
    [
        (1, 2, 3),
        (1, 2.0, 3.0),
        (np.float32(1), np.int64(2), Fraction(3)),
        (np.longdouble(1), np.float16(2), 3),
    ],
)
def test_bodies_of_every_kind_of_number(J):
    assert stationary.Body(*J) == stationary.Body(1.0, 2.0, 3.0)


@pytest.mark.parametrize(
    "J1", [True, np.True_, "1", np.str_("1"), None, 1j, 10**400, np.ones(2)], ids=repr
)
def test_bodies_of_no_numbers(J1):
    with pytest.raises(stationary.InputError, match="body.J: found .*; expected three numbers"):
        stationary.Body(J1, 2.0, 3.0)


def test_bodies_without_inertia():
    texts = set()
    for J in ((0, 1, 1), (0.0, 1.0, 1.0)):
        with pytest.raises(stationary.InputError) as error:
            stationary.Body(*J)
        texts.add(str(error.value))
    assert texts == {"J1 > 0 and finite"}


def test_potentials(material):
    _, potential = material
    assert potential.isotropic and potential.separable
    assert "c = 1" in repr(potential)
    again = pickle.loads(pickle.dumps(potential))
    assert again.coefficients == potential.coefficients and again.value(0.1, 1.2, 1.0, 0.9) == potential.value(0.1, 1.2, 1.0, 0.9)
    models = {"plane": {"model": "hencky", "mu": 1.0, "lambda": 1.0}}
    models["thickness"] = {"model": "reciprocal-quadratic", "a": 1.0, "b": 3.0}
    assert repr(stationary.Potential(models)) == repr(stationary.Potential(**models))
    grid = potential.value(0.0, np.linspace(0.5, 2.0, 4)[:, None], [[1.0, 1.5]], 1.0)
    assert grid.shape == (4, 2)
    with pytest.raises(stationary.InputError):
        potential.value(0.0, -1.0, 1.0, 1.0)
    assert type(potential.value(0.1, 1.2, 1.0, 0.9)) is float


def test_a_copied_potential_is_the_same_material(material):
    """Whatever became of the dict that it was made of."""
    models = {"plane": {"model": "reciprocal-determinant", "c": 1.0, "k": 2.0}}
    models["thickness"] = {"model": "reciprocal-quadratic", "a": 1.0, "b": 3.0}
    made = []
    for c in (1.0, 1.5, 2.0):
        models["plane"]["c"] = c
        made.append(stationary.Potential(models))
    for each, c in zip(made, (1.0, 1.5, 2.0)):
        for again in (pickle.loads(pickle.dumps(each)), copy.copy(each), copy.deepcopy(each)):
            assert again.coefficients["plane"]["c"] == c == each.coefficients["plane"]["c"]


@pytest.mark.parametrize("shape", [(2,), (0,), (1,), (2, 2)])
def test_fields_that_are_no_numbers_are_refused(material, shape):
    points = np.ones(3, [("nu", float), ("xi", float, shape), ("zeta", float), ("rho", float)])
    for call in (stationary.spectrum, stationary.certify):
        with pytest.raises(stationary.InputError, match='no numbers in the field "xi"'):
            call(*material, "i", points)


@pytest.mark.parametrize(
    "nu",
    [
        np.ma.masked_values([0.1, 9.96e36, 0.3], 9.96e36), np.array([0.3 + 1j]), ["0.3"], [b"0.3"], [1e-150],
        np.array(["0.3"], dtype=object), [np.ma.masked_array([0.1, 99.0], [False, True])],
    ],
)  # fmt: skip
def test_spins_that_are_no_numbers_are_refused(material, nu):
    with pytest.raises(stationary.InputError, match="nu: found"):
        stationary.sweep(*material, "i", nu)
    with pytest.raises(stationary.InputError, match="nu: found"):
        stationary.solve_batch(*material, "i", nu)


def test_masked_parameters_and_frames_are_refused(material):
    masked = np.ma.masked_array([1.5, 99.0], [False, True])
    with pytest.raises(stationary.InputError, match="body.J.1: found"):
        stationary.solve_batch(*material, "i", [0.1], {"body.J.1": masked})
    assert stationary.solve_batch(
        *material, "i", [0.1], {"body.J.1": np.ma.masked_array([1.5, 1.6])}
    ).shape == (2, 1)
    pandas = pytest.importorskip("pandas")
    with pytest.raises(stationary.InputError, match="expected a dict"):
        stationary.solve_batch(*material, "i", [0.1], pandas.DataFrame({"body.J.1": [1.5, 1.6]}))
    for nothing in (np.zeros(2), [], 0):
        for call in (stationary.Case, stationary.Potential):
            with pytest.raises(stationary.InputError, match="expected a dict"):
                call(nothing)


def test_enumerations_are_those_of_the_records(material):
    points = stationary.sweep(*material, "i", [0.3, 40.0])
    assert points["status"].tolist() == [Status.SOLVED, Status.NOT_FOUND]
    assert [each.name.lower() for each in Stability][1:] == [
        "stable", "elliptic", "unstable", "oscillatory", "marginal",
    ]


@pytest.mark.parametrize("branch", ["i", "ii", "iii"])
def test_sweep_is_what_solve_finds(material, disc, branch):
    nu = np.linspace(0.0, 0.6, 7)
    points = stationary.sweep(*material, branch, nu)
    assert points.shape == nu.shape and points.flags.c_contiguous and points.base is None
    for spin, point in zip(nu, points):
        disc["motion"] = {"branch": branch, "nu": float(spin)}
        row = stationary.solve(disc).table[0]
        assert point["status"] == Status.SOLVED
        for name in ("xi", "zeta", "rho"):
            assert point[name] == pytest.approx(row[name], rel=4e-16)


def test_sweep_keeps_shapes_and_takes_starts(material):
    nu = np.linspace(0.1, 0.5, 6).reshape(2, 3)
    points = stationary.sweep(*material, "i", nu, error_bound=False)
    assert points.shape == (2, 3) and np.isnan(points["error_bound"]).all()
    first = points[0, 0]
    start = (0.0, first["xi"], first["zeta"], first["rho"])
    again = stationary.sweep(*material, "i", nu[:, ::-1][:, ::-1], start=start)
    np.testing.assert_allclose(again["xi"], points["xi"], rtol=1e-15)
    assert stationary.sweep(*material, "i", []).shape == (0,)
    with pytest.raises(stationary.NotFound):
        stationary.sweep(*material, "i", [40.0])


def test_batch_is_what_sweeps_find(material):
    body, potential = material
    J2, c, nu = np.linspace(1.1, 2.0, 37), np.linspace(0.8, 1.2, 37), np.linspace(0.0, 0.5, 5)
    cells = stationary.solve_batch(
        body, potential, "i", nu, {"body.J.1": J2, "potential.plane.c": c}
    )
    assert cells.shape == (37, 5) and (cells["status"] == Status.SOLVED).all()
    for lane in (0, 15, 16, 36):
        other = stationary.Potential(
            plane={"model": "reciprocal-determinant", "c": c[lane], "k": 2.0},
            thickness={"model": "reciprocal-quadratic", "a": 1.0, "b": 3.0},
        )
        points = stationary.sweep(stationary.Body(1.0, J2[lane], 0.6), other, "i", nu)
        for name in ("xi", "zeta", "rho"):
            np.testing.assert_allclose(cells[lane][name], points[name], rtol=3e-16)


def test_batch_does_not_depend_on_threads_or_shares(material):
    J2, nu = np.linspace(1.01, 2.0, 5000), np.linspace(0.0, 0.6, 64)
    one = stationary.solve_batch(*material, "i", nu, {"body.J.1": J2}, threads=1)
    three = stationary.solve_batch(*material, "i", nu, {"body.J.1": J2}, threads=3)
    assert one.tobytes() == three.tobytes()
    alone = stationary.solve_batch(*material, "i", nu, {"body.J.1": J2[4321:4322]})
    for name in one.dtype.names:
        np.testing.assert_array_equal(alone[0][name], one[4321][name])
    assert stationary.solve_batch(*material, "i", nu).shape == (1, 64)


@pytest.mark.parametrize(
    ("values", "found"),
    [(1.5, "one number"), ([[1.5, 1.6]], r"an array of shape \(1, 2\)")],
    ids=["number", "table"],
)
def test_batch_of_no_list_of_values(material, values, found):
    words = rf"body.J.1: found {found}; expected an array of shape \(lanes,\)"
    with pytest.raises(stationary.InputError, match=words):
        stationary.solve_batch(*material, "i", [0.1], {"body.J.1": values})


def test_spectra_of_batches_and_points(material):
    nu = np.linspace(0.0, 1.0, 11)
    cells, spectra = stationary.solve_batch(*material, "i", nu, spectrum="modes")
    points = stationary.sweep(*material, "i", nu)
    alone = stationary.spectrum(*material, "i", points)
    assert spectra.shape == (1, 11) and alone.shape == (11,)
    np.testing.assert_array_equal(spectra[0]["class"], alone["class"])
    np.testing.assert_array_equal(spectra[0]["krein"], alone["krein"])
    np.testing.assert_allclose(spectra[0]["im"], alone["im"], rtol=1e-12, atol=1e-14)
    _, classes = stationary.solve_batch(*material, "i", nu, spectrum="class")
    np.testing.assert_array_equal(classes["class"], spectra["class"])
    assert np.isnan(classes["growth"]).all()


def test_spectrum_is_the_commands(material, disc):
    points = stationary.sweep(*material, "i", [0.5])
    row = stationary.solve(disc).table[0]
    found = stationary.spectrum(*material, "i", points)[0]
    assert Stability(found["class"]).name.lower() == row["class"]
    assert found["growth"] == row["growth"] and found["negative"] == row["negative"]
    for k in range(5):
        assert found["re"][k] == row[f"re{k + 1}"] and found["im"][k] == row[f"im{k + 1}"]
        assert found["krein"][k] == row[f"krein{k + 1}"]
    unsolved = stationary.sweep(*material, "i", [0.5, 40.0])
    assert stationary.spectrum(*material, "i", unsolved)["class"][1] == Stability.NOT_COMPUTED


def test_certify(material, disc):
    disc["output"] = {"certificate": True}
    row = stationary.solve(disc).table[0]
    points = stationary.sweep(*material, "i", [0.3, 0.5, 40.0])
    proof = stationary.certify(*material, "i", points)
    assert proof.records["proven"].tolist() == [True, True, False]
    assert proof.records["class_proven"].tolist() == [True, True, False]
    assert proof.reasons == ["", "", "not solved"] and proof.assuming == []
    assert proof.records["error_bound"][1] == row["error_bound"]
    for name in ("xi", "zeta", "rho"):
        low, high = proof.records[name][1]
        assert low <= points[name][1] * (1 + 1e-15) and high >= points[name][1] * (1 - 1e-15)
    points["xi"][0] *= 1.001
    assert not stationary.certify(*material, "i", points).records["proven"][0]


def test_search(material, disc):
    disc["solve"] = {"all": True}
    row = stationary.solve(disc).table
    found = stationary.search(*material, "i", [0.5, 40.0])
    assert found.complete.tolist() == [True, True] and len(found.messages) == 2
    here = found.records[found.records["index"] == 0]
    assert here["xi"].tolist() == row["xi"].tolist() and here["proven"].all()
    assert not (found.records["index"] == 1).any()
    assert (stationary.spectrum(*material, "i", here)["class"] >= 0).all()
    narrow = stationary.search(*material, "i", 0.5, box=(100.0, 200.0))
    assert len(narrow.records) == 0 and narrow.complete.shape == ()


def test_of_a_formula_and_of_fibres():
    written = stationary.Potential(coupled={"expression": "mu/2*(I1 + rho^2 - 3 - 2*log(d*rho)) + k*log(d*rho)^2", "mu": 1.0, "k": 1.0})
    body = stationary.Body(1.0, 1.7, 0.6)
    points = stationary.sweep(body, written, "i", [0.0, 0.2])
    np.testing.assert_allclose([points["xi"][0], points["rho"][0]], 1.0, rtol=1e-15)
    cells = stationary.solve_batch(body, written, "i", [0.2], {"potential.coupled.mu": [1.0, 2.0]})
    assert cells["xi"][0, 0] == pytest.approx(points["xi"][1], rel=1e-15)
    assert (cells["status"] == Status.SOLVED).all() and cells["xi"][1, 0] != cells["xi"][0, 0]
