"""The notebooks run from top to bottom, and are kept without outputs."""

import json
from pathlib import Path

import pytest

import murosimf as ms

FOLDER = Path(__file__).resolve().parents[3] / "examples/python/notebooks"
NOTEBOOKS = sorted(FOLDER.glob("*.ipynb"))


def cells_of(notebook: Path) -> list[dict]:
    document = json.loads(notebook.read_text())
    assert (document["nbformat"], document["nbformat_minor"]) == (4, 5)
    return document["cells"]


def test_there_are_five_and_the_readme_names_them() -> None:
    assert len(NOTEBOOKS) == 5
    readme = (FOLDER / "README.md").read_text()
    for notebook in NOTEBOOKS:
        assert f"({notebook.name})" in readme


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda file: file.stem)
def test_is_kept_without_outputs(notebook: Path) -> None:
    cells = cells_of(notebook)
    assert len({cell["id"] for cell in cells}) == len(cells)
    for cell in cells:
        assert cell.get("outputs", []) == []
        assert cell.get("execution_count") is None


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda file: file.stem)
def test_runs(notebook: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MPLBACKEND", "Agg")  # draws for no window
    plots = pytest.importorskip("matplotlib.pyplot", reason="no Matplotlib here: pip install matplotlib")
    monkeypatch.chdir(FOLDER)  # as Jupyter does
    before = set(FOLDER.iterdir())
    names: dict = {}
    try:
        for number, cell in enumerate(cells_of(notebook)):
            if cell["cell_type"] == "code":
                exec(compile("".join(cell["source"]), f"{notebook.name}, cell {number}", "exec"), names)
                plots.close("all")
    except ms.InputError as error:
        if "no pictures by OpenGL" not in str(error):
            raise
        pytest.skip(str(error))
    assert set(FOLDER.iterdir()) == before, "it leaves nothing in the folder"
