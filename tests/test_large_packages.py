"""Packages with thousands of faults of one kind: the work grows with the text, not with its square.

No test looks at a clock: what is done is counted.
"""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.languages.xml.elements import Element
from rospkg_cli.languages.xml.parser import read_xml
from rospkg_cli.package.manifest import Manifest
from rospkg_cli.rules.manifest.xml203_self_dependency import self_dependency
from rospkg_cli.source import Source


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
    assert list(self_dependency(Manifest(read_xml(Source("package.xml", text))))) == []
    assert visits < 10 * count
