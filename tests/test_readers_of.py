"""Which readers are asked whether a file can be read: all that could find it unreadable, and few others."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files
from rospkg_cli.files import PackageFiles
from rospkg_cli.package.package import Package
from rospkg_cli.package.readers import READERS, readers_of
from rospkg_cli.tree import MemoryTree

BROKEN = {
    "package.xml": "<package>",
    "setup.cfg": "[options\n",
    "setup.py": "setup(",
    "CMakeLists.txt": "project(",
    "msg/Status.msg": "float32 1battery\n",
    "launch/x.launch.py": "def f(",
    "launch/x.launch.xml": "<launch>",
    "launch/x.launch.yaml": "launch: [",
    "config/p.yaml": "a: [",
    "urdf/r.urdf": "<robot>",
    "my_pkg/x.py": "def f(",
}


@pytest.mark.parametrize("path", BROKEN)
@pytest.mark.parametrize("backdrop", [name for name in BACKDROPS if name])
def test_what_all_readers_find_those_of_the_file_find(backdrop: str, path: str) -> None:
    files = MemoryTree.of({**existing_files(BACKDROPS[backdrop]), path: BROKEN[path]})
    every = [each for each in Package(PackageFiles(files)).unreadable() if each.path == path]
    assert [each for each in Package(PackageFiles(files)).unreadable([path]) if each.path == path] == every


def test_a_manifest_is_read_alone() -> None:
    assert len(list(readers_of(["a/package.xml"]))) == 1
    assert readers_of(["package.xml", "setup.py"]) is READERS
    assert readers_of([]) is READERS
