"""`rospkg graph`: edges, their marks, what is near a package, and the ways of showing them."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from pathlib import Path

import jsonschema
import pytest
from lxml import html

from rospkg_cli.cli import UsageError
from rospkg_cli.cli.graph.run import GraphOptions, graph
from rospkg_cli.example import BACKDROPS, manifest
from rospkg_cli.graph import workspace_graph
from rospkg_cli.graph.as_dot import as_dot, quoted
from rospkg_cli.graph.as_html import as_html
from rospkg_cli.graph.as_json import as_json
from rospkg_cli.graph.as_list import as_list
from rospkg_cli.graph.as_mermaid import as_mermaid, escaped
from rospkg_cli.graph.workspace_graph import KINDS, GraphEdge, GraphNode, WorkspaceGraph
from rospkg_cli.light_dataclasses import replace
from rospkg_cli.resources import resources

LAUNCH = """\
<launch>
  <node pkg="base_pkg" exec="drive"/>
  <node pkg="base_pkg" exec="$(env WHAT)"/>
  <include file="$(find-pkg-share base_pkg)/launch/base.launch.xml"/>
  <include file="$(dirname)/near.launch.xml"/>
  <include file="$(find-pkg-share far_pkg)/launch/far.launch.xml"/>
  <include file="$(env FILE)"/>
</launch>
"""
PYTHON_PACKAGE = {path: text for path, text in BACKDROPS["ament_python"].items() if text is not None}
FILES = {
    **{f"my_pkg/{path}": text for path, text in PYTHON_PACKAGE.items()},
    "my_pkg/package.xml": manifest("  <depend>nav_msgs</depend>\n  <exec_depend>top_pkg</exec_depend>\n"),
    "my_pkg/my_pkg/node.py": "import sensor_msgs.msg\nimport geometry_msgs.msg\n",
    "base_pkg/package.xml": manifest("", "ament_cmake", "base_pkg"),
    "base_pkg/CMakeLists.txt": "project(base_pkg)\nament_package()\n",
    "base_pkg/launch/base.launch.xml": "<launch/>\n",
    "top_pkg/package.xml": manifest(
        "  <exec_depend>base_pkg</exec_depend>\n  <test_depend>MINE</test_depend>\n"
        "  <doc_depend>doxygen</doc_depend>\n  <group_depend>parts</group_depend>\n",
        "ament_cmake",
        "top_pkg",
    ).replace("MINE", "my_pkg"),
    "top_pkg/CMakeLists.txt": (
        "project(top_pkg)\ninstall(DIRECTORY launch DESTINATION share/top_pkg)\nament_package()\n"
    ),
    "top_pkg/launch/top.launch.xml": LAUNCH,
    "top_pkg/launch/near.launch.xml": "<launch/>\n",
    "part_pkg/package.xml": manifest("  <member_of_group>parts</member_of_group>\n", "ament_cmake", "part_pkg"),
    "part_pkg/CMakeLists.txt": "project(part_pkg)\nament_package()\n",
}


@pytest.fixture
def workspace(tmp_path: Path, write, monkeypatch: pytest.MonkeyPatch) -> Path:
    write(tmp_path, FILES)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def shown(workspace: Path, capsys: pytest.CaptureFixture[str]):
    def shown(**options) -> list[str]:
        assert graph(GraphOptions(**options)) == 0
        return capsys.readouterr().out.splitlines()

    return shown


def test_list(shown) -> None:
    assert shown() == [
        "base_pkg",
        "  launch                base_pkg/launch/base.launch.xml",
        "my_pkg",
        "  build,exec,interface  nav_msgs  (unused, outside)",
        "  exec,interface        sensor_msgs  (undeclared, outside)",
        "  exec                  top_pkg  (cycle)",
        "part_pkg",
        "top_pkg",
        "  exec                  base_pkg",
        "  exec                  far_pkg  (undeclared, outside)",
        "  test                  my_pkg  (cycle)",
        "  build,exec            part_pkg",
        "  launch                top_pkg/launch/near.launch.xml",
        "  launch                top_pkg/launch/top.launch.xml",
        "top_pkg/launch/top.launch.xml",
        "  launch                base_pkg: drive, …",
        "  launch                base_pkg/launch/base.launch.xml: includes",
        "  launch                top_pkg/launch/near.launch.xml: includes",
        "packages: 4, launch files: 3, edges: 13, cycle: 2, undeclared: 2, unused: 1",
    ]


def test_what_is_outside_is_shown_where_that_is_asked_for(shown) -> None:
    lines = shown(outside=True)
    assert "  launch                far_pkg/launch/far.launch.xml: includes  (outside)" in lines
    assert not [line for line in lines if "doxygen" in line]


def test_kinds(shown) -> None:
    assert shown(kinds=("test",)) == [
        "base_pkg",
        "my_pkg",
        "part_pkg",
        "top_pkg",
        "  test  my_pkg  (cycle)",
        "packages: 4, launch files: 0, edges: 1, cycle: 1, undeclared: 0, unused: 0",
    ]
    assert "  build  part_pkg" in shown(kinds=("build",))


def test_packages_that_define_interfaces(shown, write, workspace: Path) -> None:
    write(
        workspace, {"base_pkg/msg/Speed.msg": "float64 value\n", "tf2_msgs/package.xml": manifest("", name="tf2_msgs")}
    )
    write(workspace, {"my_pkg/package.xml": manifest("  <depend>nav_msgs</depend>\n  <depend>tf2_msgs</depend>\n")})
    lines = shown(kinds=("interface",))
    assert [line.strip() for line in lines if "interface" in line] == [
        "interface  nav_msgs  (unused, outside)",
        "interface  sensor_msgs  (undeclared, outside)",
        "interface  base_pkg",
    ]


def test_what_is_only_started_is_no_use_of_interfaces(shown, write, workspace: Path) -> None:
    write(workspace, {"base_pkg/msg/Speed.msg": "float64 value\n"})
    assert "  launch                base_pkg: drive, …" in shown()


def test_around(shown) -> None:
    def names(depth: int) -> set[str]:
        return {line.split("/")[0] for line in shown(around="part_pkg", depth=depth)[:-1] if line[0] != " "}

    assert names(0) == {"part_pkg"}
    assert names(1) == {"part_pkg", "top_pkg"}
    assert names(2) == {"part_pkg", "top_pkg", "base_pkg", "my_pkg"}


def test_what_a_launch_file_starts_is_one_step_from_its_package(shown) -> None:
    lines = shown(around="base_pkg", depth=1, kinds=("launch",))
    assert "  launch  base_pkg: drive, …" in lines


def test_only_chosen_packages_have_edges_of_their_own(shown, workspace: Path) -> None:
    lines = shown(paths=(workspace / "my_pkg",), outside=True)
    assert [line for line in lines if line[0] != " "][:-1] == ["my_pkg"]
    assert "  exec                  top_pkg  (cycle, outside)" in lines


def test_an_ignored_finding_marks_nothing(shown, write, workspace: Path) -> None:
    why = "<!-- rospkg: ignore[DEP202] loaded by name -->"
    write(workspace, {"my_pkg/package.xml": FILES["my_pkg/package.xml"].replace("  <depend>", f"  {why}\n  <depend>")})
    assert shown()[-1].endswith("unused: 0")


def test_a_package_that_is_not_there(workspace: Path) -> None:
    with pytest.raises(UsageError, match=r"no package `base_pgk` in the graph.*`base_pkg`"):
        graph(GraphOptions(around="base_pgk"))


def test_nothing_to_show(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="there is no package at"):
        graph(GraphOptions((tmp_path,)))


def test_dot(shown) -> None:
    lines = shown(format="dot")
    assert lines[0] == "digraph workspace {"
    assert '  "my_pkg" -> "sensor_msgs" [label="exec,interface (undeclared)", color=darkorange, style=dashed];' in lines
    assert '  "my_pkg" -> "top_pkg" [label="exec (cycle)", color=red, penwidth=2];' in lines
    assert '  "nav_msgs" [style=dashed, color=gray50];' in lines
    assert '  "top_pkg/launch/top.launch.xml" [shape=note, style=solid];' in lines


def test_mermaid(shown) -> None:
    lines = shown(format="mermaid")
    keys = {line.partition('"')[2].partition('"')[0]: line.split("[")[0].split(">")[0].strip() for line in lines[1:11]}
    edges = [line for line in lines if "--" in line or "-.-" in line]
    undeclared = f'  {keys["my_pkg"]} -.->|"exec,interface (undeclared)"| {keys["sensor_msgs"]}'
    assert lines[0] == "flowchart LR"
    assert undeclared in edges
    assert f"  linkStyle {edges.index(undeclared)} stroke:#d07000" in lines
    assert {*lines[-1].split()[1].split(",")} == {keys["far_pkg"], keys["nav_msgs"], keys["sensor_msgs"]}


def test_json(shown) -> None:
    found = json.loads("\n".join(shown(format="json")))
    edge = {"source": "my_pkg", "target": "top_pkg", "kinds": ["exec"], "label": "", "marks": ["cycle"]}
    node = {"name": "sensor_msgs", "package": "sensor_msgs", "is_launch_file": False, "is_outside": True}
    assert edge in found["edges"]
    assert node in found["nodes"]
    schema = json.loads((resources("schemas") / "graph.schema.json").read_text())
    jsonschema.validate(found, schema, jsonschema.Draft202012Validator)


def test_html_holds_the_graph_and_the_licenses_and_loads_nothing(shown) -> None:
    text = "\n".join(shown(format="html"))
    page = html.document_fromstring(text)
    data, script = page.xpath("//script/text()")
    assert json.loads(data) == json.loads("\n".join(shown(format="json")))
    assert not page.xpath("//@src | //@href")
    (policy,) = page.xpath("//meta[@http-equiv]/@content")
    assert policy.startswith("default-src 'none'; style-src 'sha256-")
    assert "Cytoscape Consortium" in script
    assert "Chris Pettitt" in script
    assert "sourceMappingURL" not in text
    assert text.isascii()
    assert [box.get("value") for box in page.xpath("//input[@name='kind']")] == list(KINDS)
    asked = set(re.findall(r'get\("(\w+)"\)', script.partition("// Layout:")[2]))
    assert asked <= set(page.xpath("//@id"))


def test_versions_of_bundled_libraries_are_noticed() -> None:
    library = Path(workspace_graph.__file__).parent / "library"
    notice = (Path(__file__).parents[1] / "NOTICE").read_text("utf-8")
    version = re.search(r'="(3\.\d+\.\d+)"', (library / "cytoscape.min.js").read_text("utf-8"))
    assert version
    assert f"cytoscape {version[1]}" in notice
    version = re.search(r'="(3\.\d+\.\d+)"', (library / "dagre.min.js").read_text("utf-8"))
    assert version
    assert f"@dagrejs/dagre {version[1]}" in notice


NASTY = 'a"b\\c\n::error::]<i>#\x1b'
NASTY_GRAPH = WorkspaceGraph(
    (GraphNode(NASTY, NASTY), GraphNode("end", "end")), (GraphEdge(NASTY, "end", ("exec",), NASTY),)
)


@pytest.mark.parametrize("writer", [as_list, as_dot, as_mermaid, as_json])
def test_a_strangers_names_end_no_line_and_no_string(writer) -> None:
    lines = list(writer(NASTY_GRAPH))
    assert not [line for line in lines if "\n" in line or "\x1b" in line or line.startswith("::")]


def test_a_strangers_name_is_no_markup_and_unseen_signs_are_shown() -> None:
    text = "\n".join(as_html(replace(NASTY_GRAPH, nodes=(GraphNode("</script>\x1b", "\u202e"),), edges=())))
    data = html.document_fromstring(text).xpath("//script[@id='data']/text()")[0]
    (node,) = json.loads(data)["nodes"]
    assert (node["name"], node["package"]) == ("</script>\\x1b", "\\u202e")


def test_signs_of_the_syntaxes_are_escaped() -> None:
    assert quoted('a"\\') == '"a\\"\\\\"'
    assert escaped('a"]|#') == '"a#34;#93;#124;#35;"'


@pytest.mark.skipif(not shutil.which("dot"), reason="Graphviz is not here")
def test_graphviz_reads_it() -> None:
    text = "\n".join(as_dot(NASTY_GRAPH))
    done = subprocess.run(["dot", "-Tplain"], input=text, capture_output=True, text=True, timeout=20, check=False)
    assert done.returncode == 0, done.stderr
