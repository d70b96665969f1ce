"""The pages docs/python.md and docs/cookbook.md: sessions print what they say, and code runs."""

import doctest
import re
from pathlib import Path

import numpy as np
import pytest

import murosimf as ms


@pytest.mark.parametrize("page", ["docs/python.md", "docs/cookbook.md"])
def test_sessions(root: Path, page: str) -> None:
    text = "\n".join(re.findall(r"^```pycon\n(.*?)^```", (root / page).read_text(), re.DOTALL | re.MULTILINE))
    test = doctest.DocTestParser().get_doctest(text, {}, page, None, 0)
    assert len(test.examples) > 10
    said: list[str] = []
    assert doctest.DocTestRunner().run(test, out=said.append).failed == 0, "".join(said)


def test_the_cookbook_names_what_mujoco_has(root: Path) -> None:
    mujoco = pytest.importorskip("mujoco")
    names = set(re.findall(r"\bmj[A-Z_]\w+|\bMj\w+", (root / "docs/cookbook.md").read_text()))
    assert len(names) > 10
    states = {name for name in names if name.startswith("mjSTATE_")}
    assert [name for name in names - states if not hasattr(mujoco, name)] == []
    assert [name for name in states if not hasattr(mujoco.mjtState, name)] == []


def test_code(root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"^```python\n(.*?)^```", (root / "docs/python.md").read_text(), re.DOTALL | re.MULTILINE)
    assert len(blocks) == 4
    for block in blocks:
        if "gymnasium" in block:
            pytest.importorskip("gymnasium")
        exec(compile(block, "docs/python.md", "exec"), {"ms": ms, "np": np})
