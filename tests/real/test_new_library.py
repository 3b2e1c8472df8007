"""The C++ library that `new` writes: built, installed, and found by a project of its own, with Debian's ament_cmake."""

from __future__ import annotations

from pathlib import Path

import pytest
from shell import Shell
from testing_new import linted, plan, write

pytestmark = pytest.mark.debian


def test_a_project_of_its_own_finds_it(shell: Shell, tmp_path: Path) -> None:
    folder = write(plan("my_mean", template="library", version="1.2.3"), tmp_path)
    linted(shell, folder, ("cpplint", "lint_cmake", "uncrustify"))
    prefix, consumer = tmp_path / "install", tmp_path / "consumer"
    strict = ("-DCMAKE_CXX_FLAGS=-Werror", "-DBUILD_TESTING=OFF", f"-DCMAKE_INSTALL_PREFIX={prefix}")
    found = f"-Dmy_mean_DIR={prefix}/share/my_mean/cmake"
    for command in (
        ("cmake", "-S", folder, "-B", tmp_path / "build", *strict),
        ("cmake", "--build", tmp_path / "build", "--target", "install"),
        ("cmake", "-S", folder / "test/consumer", "-B", consumer, found),
        ("cmake", "--build", consumer),
    ):
        made = shell.run(*command, cwd=tmp_path)
        assert (made.returncode, made.stderr) == (0, ""), made.stdout
    used = shell.run(consumer / "consumer", cwd=tmp_path)
    assert (used.returncode, used.stdout) == (0, "1.2.3\n")
