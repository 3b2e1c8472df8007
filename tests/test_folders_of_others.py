"""Folders for copies of what others wrote are read as such, whatever lies in them and however they are spelled."""

from __future__ import annotations

import pytest

from rospkg_cli.package.file_role import role_of


@pytest.mark.parametrize(
    ("path", "role"),
    [
        ("third_party/eigen/test/a.cpp", "aside"),
        ("ThirdParty/eigen/src/a.cpp", "aside"),
        ("src/third_parties/eigen/test/a.cpp", "aside"),
        ("3rdparty/a.py", "aside"),
        ("3rd_party/launch/a.launch.py", "aside"),
        ("party/test/a.py", "test"),
        ("src/third_part.py", "run"),
    ],
)
def test_the_role_of_a_file_of_others(path: str, role: str) -> None:
    assert role_of(path) == role
