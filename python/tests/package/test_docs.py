"""The pages docs/python.md, docs/cookbook.md and docs/learning.md: sessions print what they say, and code runs."""

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


@pytest.mark.parametrize(("page", "count"), [("docs/python.md", 7), ("docs/learning.md", 2)])
def test_code(root: Path, page: str, count: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"^```python\n(.*?)^```", (root / page).read_text(), re.DOTALL | re.MULTILINE)
    assert len(blocks) == count
    for block in blocks:
        for package, word in (("gymnasium", "gymnasium"), ("pettingzoo", "envs.teams")):
            if word in block:
                pytest.importorskip(package)
        exec(compile(block, page, "exec"), {"ms": ms, "np": np})
