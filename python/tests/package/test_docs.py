"""The page docs/python.md: sessions print what it says, and its code runs."""

import doctest
import re
from pathlib import Path

import numpy as np
import pytest

import murosimf as ms


def test_sessions(root: Path) -> None:
    text = "\n".join(re.findall(r"^```pycon\n(.*?)^```", (root / "docs/python.md").read_text(), re.DOTALL | re.MULTILINE))
    test = doctest.DocTestParser().get_doctest(text, {}, "docs/python.md", None, 0)
    assert len(test.examples) > 10
    said: list[str] = []
    assert doctest.DocTestRunner().run(test, out=said.append).failed == 0, "".join(said)


def test_code(root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"^```python\n(.*?)^```", (root / "docs/python.md").read_text(), re.DOTALL | re.MULTILINE)
    assert len(blocks) == 4
    for block in blocks:
        if "gymnasium" in block:
            pytest.importorskip("gymnasium")
        exec(compile(block, "docs/python.md", "exec"), {"ms": ms, "np": np})
