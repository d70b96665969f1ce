"""The reference of the package: everything public says what it is, and scripts/python_reference writes it."""

import inspect
import os
import subprocess
import sys
from pathlib import Path

import murosimf.cluster
import pytest

import murosimf as ms


def undocumented(module: object, names: list[str]) -> list[str]:
    missing = []
    for name in names:
        value = getattr(module, name)
        if not (inspect.isclass(value) or inspect.isfunction(value)):
            continue
        if not value.__doc__ or value.__doc__.startswith(f"{name}("):  # what dataclasses and named tuples have by themselves
            missing.append(name)
        for member, entry in vars(value).items() if inspect.isclass(value) else ():
            function = getattr(entry, "__func__", getattr(entry, "fget", entry))
            if not member.startswith("_") and inspect.isfunction(function) and not inspect.getdoc(function):
                missing.append(f"{name}.{member}")
    return missing


def test_everything_public_says_what_it_is() -> None:
    assert undocumented(ms, ms.__all__) == []
    assert undocumented(murosimf.cluster, ["slurm_script", "on_dask", "on_ray"]) == []
    assert undocumented(sys.modules[__name__], ["undocumented"]) == ["undocumented"]


def test_is_written(root: Path, tmp_path: Path) -> None:
    pytest.importorskip("pdoc", reason="no pdoc here: pip install pdoc")
    build = Path(os.path.abspath(ms.__file__)).parents[2]
    if not (build / "python/murosimf").is_dir():
        pytest.skip("the package is installed, and of no build folder")
    done = subprocess.run([root / "scripts/python_reference", "--build", build, "--out", tmp_path / "out"], text=True,
                          env={**os.environ, "PYTHON": sys.executable}, capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
    page = (tmp_path / "out/murosimf.html").read_text()
    for name in ms.__all__:
        assert f'id="{name}"' in page, name
    assert 'id="on_dask"' in (tmp_path / "out/murosimf/cluster.html").read_text()
