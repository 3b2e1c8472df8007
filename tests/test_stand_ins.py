"""Files that git holds in place of others, as pointers of Git LFS: said once, and nothing follows from them."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, scripts, setup_py
from rospkg_cli.testing import lint_files

POINTER = "version https://git-lfs.github.com/spec/v1\noid sha256:54dfe59b1c181fb1ba17c8abf8fa7e1f47bf\nsize 2608\n"
FETCH = "is a pointer of Git LFS, not the file itself: `git lfs pull` fetches that"
PYTHON, CMAKE = (existing_files(BACKDROPS[each]) for each in ("ament_python", "ament_cmake"))
NODE = {**PYTHON, "setup.py": setup_py(scripts("talker = my_pkg.talker:main"))}


@pytest.mark.parametrize(
    ("files", "path"),
    [
        (CMAKE, "CMakeLists.txt"),
        (CMAKE, "package.xml"),
        (CMAKE, "launch/robot.launch.py"),
        (CMAKE, "launch/robot.launch.xml"),
        (CMAKE, "urdf/robot.urdf"),
        (CMAKE, "msg/Grip.msg"),
        (NODE, "setup.py"),
        (NODE, "my_pkg/talker.py"),
    ],
)
def test_a_pointer_is_an_info_and_nothing_follows(files: dict[str, str], path: str) -> None:
    found = lint_files({**files, path: POINTER}, None).findings
    told = [(each.code, each.severity.value, each.message) for each in found if each.severity.value != "info"]
    assert told == []
    assert ("RPK007", f"`{path}` {FETCH}") in [(each.code, each.message) for each in found]


def test_an_encrypted_file() -> None:
    found = lint_files({**CMAKE, "CMakeLists.txt": b"\0GITCRYPT\0\xff\xfe\x80"}, ["RPK001", "RPK007"]).findings
    why = "`CMakeLists.txt` is encrypted by git-crypt: `git-crypt unlock` makes it readable"
    assert [(each.code, each.message) for each in found] == [("RPK007", why)]
