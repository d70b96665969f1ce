"""The pages docs/python.md and docs/learning.md: sessions print what they say, and their code runs."""

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


@pytest.mark.parametrize(("page", "count"), [("docs/python.md", 3), ("docs/learning.md", 2)])
def test_code(root: Path, page: str, count: int) -> None:
    blocks = re.findall(r"^```python\n(.*?)^```", (root / page).read_text(), re.DOTALL | re.MULTILINE)
    assert len(blocks) == count
    for block in blocks:
        for package, word in (("gymnasium", "gymnasium"), ("pettingzoo", "envs.teams")):
            if word in block:
                pytest.importorskip(package)
        exec(compile(block, page, "exec"), {"ms": ms, "np": np})
