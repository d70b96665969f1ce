"""What goes into wheels, without building one: scripts/build_wheels does that."""

import re
import shutil
import subprocess
import tarfile
from pathlib import Path

import pytest

from murosimf import _core

# What pip brings for each library that the project cannot do without, and what only the configuration asks it for.
PIP_PACKAGES = {"Eigen3": "cmeel-eigen", "fmt": "cmeel-fmt", "tinyxml2": "cmeel-tinyxml2", "Qhull": "cmeel-qhull"}
PIP_ARCHIVES = {"nlohmann_json": "cmake/headers.txt", "CLI11": "cmake/headers.txt"}


def test_pip_brings_every_library_that_is_required(root: Path) -> None:
    text = "".join((root / file).read_text() for file in ("cmake/Dependencies.cmake", "apps/CMakeLists.txt"))
    required = set(re.findall(r"find_package\((\w+) REQUIRED\)", text)) | set(re.findall(r"murosimf_find_headers\((\w+)", text))
    assert required - {"Threads", "PkgConfig"} == set(PIP_PACKAGES) | set(PIP_ARCHIVES)
    assert all("--hash=sha256:" in (root / file).read_text() for file in PIP_ARCHIVES.values())
    table = (root / "pyproject.toml").read_text().split("[project]")[0]
    requirements = {re.split(r"[<>=]", entry)[0] for entry in re.findall(r'"([^"]+)"', table)}
    assert set(PIP_PACKAGES.values()) <= requirements


def test_nothing_of_the_library_is_seen_from_outside() -> None:
    if not shutil.which("nm"):
        pytest.skip("there is no nm")
    done = subprocess.run(["nm", "-D", "--defined-only", str(_core.__file__)], capture_output=True, text=True, check=True)
    assert [line.split()[-1] for line in done.stdout.splitlines()] == ["PyInit__core"]


def test_the_source_archive_has_what_a_build_reads(root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    build = pytest.importorskip("scikit_build_core.build")
    monkeypatch.chdir(root)
    with tarfile.open(tmp_path / build.build_sdist(str(tmp_path))) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
    wanted = {"CMakeLists.txt", "pyproject.toml", "cmake/PipPackages.cmake", "cmake/tomlplusplus.txt", "cmake/headers.txt",
              "python/murosimf/py.typed", "python/bindings/module.map", "include/murosimf/control.h", "LICENSE"}
    for folder in ("lenses", "models", "motions", "parts", "scenes", "servos", "murosimf", "apps"):
        wanted |= {str(file.relative_to(root)) for file in (root / folder).rglob("*.*") if file.is_file()}
    assert wanted <= names
    assert not [name for name in names if name.startswith(("build/", "out/", ".git/", ".ci/"))]
