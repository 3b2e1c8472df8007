"""Parameter files that are known as such only because a launch file gives them to a node."""

from __future__ import annotations

import pytest

from rospkg_cli.testing import lint_files

LAUNCH = '<launch>\n  <node pkg="{pkg}" exec="talker">\n    <param from="{path}"/>\n  </node>\n</launch>\n'
BARE = "talker:\n  rate: 1.0\n"


def found(clean: dict[str, str], path: str, text: str = BARE, pkg: str = "my_pkg") -> list[str]:
    files = {**clean, "launch/a.launch.xml": LAUNCH.format(path=path, pkg=pkg), "config/numbers.yaml": text}
    return [f.location.path for f in lint_files(files, ["PRM001"]).findings]


def test_what_a_node_is_given_holds_parameters(clean) -> None:
    assert found(clean, "$(find-pkg-share my_pkg)/config/numbers.yaml") == ["config/numbers.yaml"]


@pytest.mark.parametrize("path", ["$(find-pkg-share other)/config/numbers.yaml", "$(var x)/config/numbers.yaml", "x"])
def test_what_may_be_another_file_is_left_alone(clean, path: str) -> None:
    assert found(clean, path) == []


@pytest.mark.parametrize("key", ["/**", "'/**'", "/*", "/**/talker"])
def test_a_name_for_many_nodes_tells_too(clean, key: str) -> None:
    assert found(clean, "x", f"{key}:\n  rate: 1.0\n") == ["config/numbers.yaml"]


def test_templates_are_left_alone(clean) -> None:
    assert found(clean, "$(find-pkg-share my_pkg)/config/numbers.yaml", BARE + "{{ more }}\n") == []
