"""Packages with thousands of faults of one kind: the work grows with the text, not with its square.

No test looks at a clock: what is done is counted.
"""

from __future__ import annotations

import ast
import difflib
import gc
from collections.abc import Iterator

import pytest

from rospkg_cli import suggest
from rospkg_cli.example import manifest
from rospkg_cli.files import PackageFiles
from rospkg_cli.languages.python import file, syntax
from rospkg_cli.languages.python.syntax import parse
from rospkg_cli.languages.xml.elements import Element
from rospkg_cli.languages.xml.parser import read_xml
from rospkg_cli.package.launch.launch_file import LaunchFile
from rospkg_cli.package.launch.read_launch_files import MAX_CHARACTERS
from rospkg_cli.package.manifest import Manifest
from rospkg_cli.package.package import Package
from rospkg_cli.package.python.python_imports import PackageImports
from rospkg_cli.rules.manifest.xml203_self_dependency import self_dependency
from rospkg_cli.source import Source
from rospkg_cli.suggest import nearest, refill
from rospkg_cli.tree import MemoryTree

LAUNCH = """\
from launch import LaunchDescription


def generate_launch_description():
    return LaunchDescription([])
"""


@pytest.fixture(autouse=True)
def full_effort() -> Iterator[None]:
    refill()
    yield
    refill()


def test_the_name_of_a_package_is_not_looked_for_among_all_its_dependencies(monkeypatch: pytest.MonkeyPatch) -> None:
    visits = 0
    children = Element.children.fget  # type: ignore[attr-defined]

    def counted(element: Element) -> list[Element]:
        nonlocal visits
        visits += len(element.nodes)
        return list(children(element))

    monkeypatch.setattr(Element, "children", property(counted))
    count = 4_000
    text = manifest("".join(f"  <depend>unknown_{n}</depend>\n" for n in range(count)))
    assert list(self_dependency.check(Manifest(read_xml(Source("package.xml", text))))) == []
    assert visits < 10 * count


def test_no_name_is_looked_at_once_effort_is_used_up() -> None:
    class Names(list[str]):
        iterations = 0

        def __iter__(self) -> Iterator[str]:
            Names.iterations += 1
            return super().__iter__()

    names, words = Names(f"a{n}" for n in range(3_000)), [f"b{n}" for n in range(3_000)]
    assert [nearest(word, names) for word in words][-1] is None
    assert Names.iterations < 1_000


def test_words_that_share_few_letters_are_not_compared(monkeypatch: pytest.MonkeyPatch) -> None:
    """The effort for one rule is enough for 100 wrong names among 1,000."""
    monkeypatch.setattr(difflib, "SequenceMatcher", None)
    monkeypatch.setattr(suggest, "distance", None)
    names = [f"{first}_driver_{n}" for n in range(500) for first in ("camera", "gripper")]
    assert {nearest(f"ouzouz_hook_{n}", names) for n in range(100)} == {None}
    assert suggest.Effort.left > 0


def test_launch_files_that_are_skipped_are_not_parsed_for_their_imports(monkeypatch: pytest.MonkeyPatch) -> None:
    parsed = []

    def counted(source: Source) -> ast.Module:
        assert gc.isenabled()
        parsed.append(source.path)
        return parse(source)

    monkeypatch.setattr(file, "parse", counted)
    text = LAUNCH + "# a\n" * (MAX_CHARACTERS // 40)
    names = [f"launch/{n}.launch.py" for n in range(60)]
    package = Package(PackageFiles(MemoryTree.of({"package.xml": manifest(""), **dict.fromkeys(names, text)})))
    imports = package.parts(PackageImports).only
    assert imports is not None
    assert not imports.is_complete
    assert len(parsed) < 12
    assert len(package.parts(LaunchFile).broken) == len(names) - len(parsed)
    assert gc.isenabled()


def test_the_collector_rests_while_a_tree_is_built(monkeypatch: pytest.MonkeyPatch) -> None:
    states = []
    monkeypatch.setattr(syntax.ast, "parse", lambda *_: states.append(gc.isenabled()))
    monkeypatch.setattr(syntax, "is_too_deep", lambda _: False)
    monkeypatch.setattr(syntax, "compile_error", lambda *_: None)
    parse(Source("a.py", "a = 1\n"))
    assert (states, gc.isenabled()) == ([False], True)
