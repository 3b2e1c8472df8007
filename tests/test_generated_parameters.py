"""`new --params generate`: definitions for generate_parameter_library, and nodes that use what is made of them.

What the library makes of them is not run here: it needs ROS.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml
from in_process import run_here
from planned import plan, texts
from test_kept_record import removed
from test_templates import faultless, node_sets

from rospkg_cli.ros.distros import DISTROS
from rospkg_cli.scaffold import ScaffoldError
from rospkg_cli.scaffold.answers_record import RECORD, read_record, with_record
from rospkg_cli.scaffold.node_kinds import all_kinds
from rospkg_cli.scaffold.write import write_folder
from rospkg_cli.testing import lint_files

TYPES = ("ament_python", "ament_cmake", "mixed")
SEVERAL = "k1:{}:subscriber:sensor_msgs/Imu@/imu+publisher:geometry_msgs/Twist@/cmd_vel"


def generated(template: str = "ament_python", **asked: Any) -> dict[str, str]:
    planned = plan("my_pkg", template=template, parameters="generate", **asked)
    faultless(planned)
    return texts(planned)


@pytest.mark.parametrize("distro", [distro.name for distro in DISTROS])
@pytest.mark.parametrize("template", TYPES)
def test_every_kind_of_node_is_written_without_a_finding(template: str, distro: str) -> None:
    kinds_of = [node.partition(":")[2] for node in node_sets(template)["all"]]
    nodes = tuple(f"n{number}:{kind}" for number, kind in enumerate(kinds_of))
    files = generated(template, nodes=nodes, distro=distro)
    assert not [path for path, text in files.items() if "declare_parameter" in text or "ParameterDescriptor" in text]
    kinds = {node.partition(":")[0]: node.split(":")[1] for node in nodes}
    definitions = {Path(path).stem: yaml.safe_load(text) for path, text in files.items() if "_parameters.y" in path}
    assert set(definitions) == {f"{name}_parameters" for name, kind in kinds.items() if all_kinds()[kind].parameters}
    for name, kind in kinds.items():
        declared = definitions.get(f"{name}_parameters", {f"{name}_parameters": {}})[f"{name}_parameters"]
        assert list(declared) == [each.name for each in all_kinds()[kind].parameters]


@pytest.mark.parametrize("asked", [{"params": False}, {"tests": "none"}, {"tests": "minimal", "launch": "xml"}])
@pytest.mark.parametrize("template", TYPES)
def test_so_it_is_with_fewer_files(template: str, asked: dict[str, Any]) -> None:
    assert [path for path in generated(template, **asked) if path.endswith("_parameters.yaml")]


def test_definitions_have_types_defaults_and_bounds() -> None:
    text = generated(nodes=("count_down:timer",))["my_pkg/count_down_parameters.yaml"]
    start = yaml.safe_load(text)["count_down_parameters"]["start"]
    assert start["type"] == "int"
    assert start["default_value"] == 10
    assert start["description"] == "the number to count down from"
    assert start["read_only"] is True
    assert start["validation"] == {"bounds<>": [1, 1000000]}


def test_a_parameter_that_may_change_is_not_read_only() -> None:
    text = generated(nodes=("keeper:parameter",))["my_pkg/keeper_parameters.yaml"]
    assert yaml.safe_load(text)["keeper_parameters"]["text"] == {
        "type": "string",
        "default_value": "Hello",
        "description": "what it keeps in mind",
        "validation": {"not_empty<>": []},
    }


@pytest.mark.parametrize(("template", "language"), [("ament_python", "python"), ("ament_cmake", "cpp")])
def test_a_node_with_several_interfaces_reads_its_rate_there(template: str, language: str) -> None:
    files = generated(template, nodes=(SEVERAL.format(language),))
    assert "params.rate" in "".join(text for path, text in files.items() if Path(path).stem == "k1")


def test_what_has_no_parameters_needs_no_library() -> None:
    files = generated("mixed", nodes=("adder:service", "idle:empty:python"))
    assert not [path for path, text in files.items() if "generate_parameter" in text]


@pytest.mark.parametrize(("right", "wrong", "code"), [("x: 1.0", "x: far", "PRM006"), ("parent:", "parant:", "PRM007")])
@pytest.mark.parametrize("template", ["ament_python", "ament_cmake"])
def test_a_wrong_name_or_type_in_the_file_of_values_is_found(template: str, right: str, wrong: str, code: str) -> None:
    files = generated(template, nodes=("base:tf-broadcaster",))
    assert right in files["config/params.yaml"]
    changed = {**files, "config/params.yaml": files["config/params.yaml"].replace(right, wrong)}
    assert [finding.code for finding in lint_files(changed, ["PRM006", "PRM007"]).findings] == [code]


@pytest.mark.parametrize("template", ["interfaces", "description", "bringup", "library", "plugin"])
def test_what_has_no_nodes_of_its_own_is_refused(template: str) -> None:
    with pytest.raises(ScaffoldError, match="--params generate is for packages of --type ament_python"):
        plan(template=template, parameters="generate")


def test_a_node_with_the_name_of_generated_code_is_refused() -> None:
    with pytest.raises(ScaffoldError, match="generated for the node `talker`; choose another name"):
        plan(parameters="generate", nodes=("talker", "talker_parameters"))


def test_the_option_takes_three_words(tmp_path: Path) -> None:
    def written(*options: str) -> set[str]:
        done = run_here("new", "my_pkg", "--into", "_".join(options), *options, cwd=tmp_path)
        assert done.returncode == 0, done.stderr
        folder = tmp_path / "_".join(options) / "my_pkg"
        return {path.name for path in folder.rglob("*.yaml")}

    assert written("--params", "file") == {"params.yaml"}
    assert written("--params", "none") == written("--no-params") == set()
    assert written("--params", "generate") == {"params.yaml", "my_pkg_node_parameters.yaml"}
    done = run_here("new", "my_pkg", "--params", "generated", cwd=tmp_path)
    assert done.returncode == 2
    assert "did you mean `generate`" in done.stderr


def test_of_a_family_the_package_with_the_nodes_is_meant(tmp_path: Path) -> None:
    assert run_here("new", "my_bot", "--family", "--params", "generate", cwd=tmp_path).returncode == 0
    assert [path.parent.parent.name for path in tmp_path.rglob("*_node_parameters.yaml")] == ["my_bot"]


def test_a_node_that_add_wrote_stays_as_it_is(tmp_path: Path) -> None:
    assert run_here("new", "my_pkg", "--params", "generate", "--node", "talker", cwd=tmp_path).returncode == 0
    assert run_here("add", "node", "later:timer", cwd=tmp_path / "my_pkg").returncode == 0
    done = run_here("new", "--update", ".", cwd=tmp_path / "my_pkg")
    assert "nothing is to be done" in done.stderr


def written(package: Path, template: str, *nodes: str) -> Path:
    asked = {"launch": "none", "params": False, "tests": "none", "description": "Does it"}
    planned = plan("my_pkg", template=template, parameters="generate", nodes=nodes, **asked)
    write_folder(package, with_record(planned).files)
    return package


def same_files(one: Path, other: Path) -> dict[str, bool]:
    names = ("CMakeLists.txt", "setup.py", "package.xml", ".gitignore")
    same = {name: (one / name).read_text() == (other / name).read_text() for name in names if (one / name).exists()}
    return {**same, RECORD: read_record(one).request == read_record(other).request}


FIRST = {
    "ament_python": ("talker",),
    "ament_cmake": ("talker",),
    "mixed": ("talker", "idle:empty:python"),
    "mixed in Python": ("idle:empty", "caller:client:python"),
}


@pytest.mark.parametrize("case", FIRST)
def test_a_node_goes_with_its_definitions(tmp_path: Path, case: str) -> None:
    template, first = case.partition(" ")[0], FIRST[case]
    more = "counter:timer:python" if "Python" in case else "counter:timer"
    package, fresh = (
        written(tmp_path / n / "my_pkg", template, *ns) for n, ns in (("a", (*first, more)), ("b", first))
    )
    removed(package, "node", "counter")
    assert [path.name for path in package.rglob("counter*")] == []
    same = same_files(package, fresh)
    assert same.pop("CMakeLists.txt", True) or template == "mixed"
    assert set(same.values()) == {True}, same


def test_the_last_one_takes_the_library_with_it(tmp_path: Path) -> None:
    for template, last in (("ament_python", "counter:timer"), ("mixed", "counter:timer:python")):
        kept = ("idle:empty", *(("other:empty:python",) if template == "mixed" else ()))
        package = written(tmp_path / template, template, last, *kept)
        removed(package, "node", "counter")
        files = (path for path in package.rglob("*") if path.is_file() and path.suffix != ".md")
        assert not [path for path in files if b"generate_par" in path.read_bytes()]
        again = written(tmp_path / "again" / template, template, *kept)
        assert same_files(package, again) == dict.fromkeys(same_files(again, again), True)


def test_definitions_that_were_edited_need_force(tmp_path: Path) -> None:
    package = written(tmp_path / "my_pkg", "ament_python", "talker", "counter:timer")
    definitions = package / "my_pkg/counter_parameters.yaml"
    definitions.write_text(definitions.read_text().replace("10", "20"))
    done = run_here("remove", "node", "counter", "--allow-dirty", cwd=package)
    assert (done.returncode, definitions.exists()) == (2, True)
    assert "`my_pkg/counter_parameters.yaml` is not as `add` writes it; --force" in done.stderr
    assert run_here("remove", "node", "counter", "--allow-dirty", "--force", cwd=package).returncode == 0
    assert not definitions.exists()
