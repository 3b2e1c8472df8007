"""What a working tree lacks on purpose: what git ignores, and submodules that are not checked out."""

from __future__ import annotations

import pytest

from rospkg_cli.files import PackageFiles
from rospkg_cli.gitignore import is_ignored, read_patterns
from rospkg_cli.tree import MemoryTree

PATTERNS = [
    ("models/", "models", True),
    ("models/", "a/models/x.onnx", True),
    ("/models", "models/x.onnx", True),
    ("/models", "a/models/x.onnx", False),
    ("a/models", "a/models/x.onnx", True),
    ("a/models", "b/a/models", False),
    ("a/**/b", "a/b", True),
    ("a/**/b", "a/x/y/b/c", True),
    ("**/b", "a/b", True),
    ("a/**", "a/b", True),
    ("*.so", "lib/libx.so", True),
    ("*.so", "lib/libx.so.1", False),
    ("# models", "models", False),
    ("\\#models", "#models", True),
    ("*.so\n!lib*.so", "libx.so", False),
    ("!lib*.so\n*.so", "libx.so", True),
    ("models  ", "models", True),
    ("", "models", False),
    ("/", "models", False),
    ("a/**/b/**/c/**", "a/b/c", False),
    ("x" * 501, "x" * 501, False),
    ("x" * 500, "x" * 500, True),
    ("\n" * 4_999 + "a", "a", True),
    ("\n" * 5_000 + "a", "a", False),
]


@pytest.mark.parametrize(("text", "path", "ignored"), PATTERNS)
def test_patterns_are_read_as_git_reads_them(text: str, path: str, ignored: bool) -> None:
    assert is_ignored(path, {"": read_patterns(text)}) is ignored


def test_the_nearest_file_has_the_last_word() -> None:
    outer, inner = read_patterns("*.onnx\n"), read_patterns("!small.onnx\n/big\n")
    patterns = {"": outer, "models": inner}
    assert is_ignored("models/a.onnx", patterns)
    assert not is_ignored("models/small.onnx", patterns)
    assert is_ignored("models/big", patterns)
    assert not is_ignored("models/a/big", patterns)


def files(**texts: str) -> PackageFiles:
    tree = MemoryTree.of({path.replace("__", "/"): text for path, text in texts.items()})
    return PackageFiles(tree.sub("src/my_pkg"), "src/my_pkg", tree)


def test_files_above_the_package_and_inside_of_it_count() -> None:
    found = files(
        **{
            ".gitignore": "*.onnx\n",
            "src__.gitignore": "my_pkg/maps\n",
            "src__my_pkg__urdf__.gitignore": "robot.urdf\n",
        }
    )
    paths = ("models/a.onnx", "maps", "urdf/robot.urdf", "urdf/arm.urdf", "config/a.yaml")
    assert [found.absent.is_expected(path) for path in paths] == [True, True, True, False, False]


def test_a_submodule_is_expected_where_it_holds_nothing() -> None:
    modules = '[submodule "x"]\n\tpath = src/my_pkg/third_party/x\n[submodule "y"]\n\tpath=src/my_pkg/y\n'
    other = '[submodule "z"]\n\tpath = src/other/z\n'
    found = files(**{".gitmodules": modules + other, "src__my_pkg__y__a.cpp": ""})
    assert found.absent.submodule_of("third_party/x/a.cpp") == "third_party/x"
    assert found.absent.submodule_of("third_party/x") == "third_party/x"
    assert found.absent.submodule_of("third_party/xy") is None
    assert found.absent.submodule_of("y/b.cpp") is None
    assert found.absent.submodule_of("z/b.cpp") is None
    assert found.absent.is_expected("third_party/x/a.cpp")


def test_submodules_are_bounded() -> None:
    many = "path = a\n" * 9_999
    assert files(**{"src__my_pkg__.gitmodules": f"{many}path = x\n"}).absent.submodule_of("x") == "x"
    assert files(**{"src__my_pkg__.gitmodules": f"{many}path = a\npath = x\n"}).absent.submodule_of("x") is None


def test_a_package_alone_is_its_own_top() -> None:
    alone = PackageFiles(MemoryTree.of({".gitmodules": "path = x\n", ".gitignore": b"\xff\xfe\xfa"}), "src/my_pkg")
    assert alone.absent.submodule_of("x/a") == "x"
    assert not alone.absent.is_ignored("y")
