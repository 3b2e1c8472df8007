"""`rospkg new --plugin`: every kind on every distribution, and what is said of it."""

from __future__ import annotations

from pathlib import Path

import pytest
from in_process import run_here as rospkg
from planned import plan, texts

from rospkg_cli.ros.distros import DISTROS
from rospkg_cli.ros.plugins import BASE_HEADERS, LOADED_FROM
from rospkg_cli.scaffold import ScaffoldError
from rospkg_cli.scaffold.plugin_kinds import plugin_kind, plugin_kinds
from rospkg_cli.scaffold.test_level import TEST_LEVELS


@pytest.mark.parametrize("distro, level", [*zip([each.name for each in DISTROS], 2 * [*TEST_LEVELS], strict=False)])
def test_every_kind_is_written_without_a_finding(distro: str, level: str) -> None:
    names = tuple(f"{kind.replace('-', '_')}_one:{kind}" for kind in plugin_kinds())
    planned = plan("my_plugins", template="plugin", plugins=names, distro=distro, tests=level)
    assert planned.findings == ()
    files = texts(planned)
    assert ("test/test_bt_node_one.cpp" in files) == (level == "ament")
    assert not [line for text in files.values() for line in text.splitlines() if line != line.rstrip()]


@pytest.mark.parametrize("kind", ["pluginlib", "costmap-layer", "bt-node"])
def test_a_kind_alone_is_called_like_its_package(kind: str) -> None:
    planned = plan("my_thing", template="plugin", plugins=(kind,), distro="jazzy", depends=("sensor_msgs", "eigen"))
    assert planned.findings == ()
    [plugin] = planned.answers.plugins
    assert (plugin.name, plugin.library, plugin.type) == ("my_thing", "my_thing", "my_thing::MyThing")
    assert planned.answers.description.text == f"A plugin that {plugin.kind.does}"
    assert "add_library(my_thing SHARED src/my_thing.cpp)\n" in texts(planned)["CMakeLists.txt"]


def test_bases_of_all_kinds_are_known_to_the_rules() -> None:
    for kind in plugin_kinds():
        base = plugin_kind(kind, "rolling").base
        assert not base or base.startswith("{package}") or (base in LOADED_FROM and base in BASE_HEADERS), kind
    assert BASE_HEADERS.keys() <= LOADED_FROM.keys()


def test_descriptions_name_what_is_made() -> None:
    files = texts(plan("arm", template="plugin", plugins=("wrist:hardware-interface", "arm_x:costmap-layer")))
    assert '<library path="arm_wrist">' in files["plugins/wrist.xml"]
    assert '<class name="arm/Wrist" type="arm::Wrist" base_class_type="hardware' in files["plugins/wrist.xml"]
    assert '<library path="arm_x">' in files["plugins/arm_x.xml"]
    assert '<class type="arm::ArmX" base_class_type="nav2_costmap_2d::Layer">' in files["plugins/arm_x.xml"]
    assert "pluginlib_export_plugin_description_file(nav2_costmap_2d plugins/arm_x.xml)" in files["CMakeLists.txt"]


def test_each_distribution_gets_its_form() -> None:
    controllers = {
        each.name: texts(plan("fast", template="plugin", plugins=("nav2-controller",), distro=each.name))
        for each in DISTROS
    }
    forms = {name: "setPlan(" in files["src/fast.cpp"] for name, files in controllers.items()}
    assert forms == {"humble": True, "jazzy": True, "kilted": True, "lyrical": False, "rolling": False}
    trees = {
        each.name: texts(plan("wet", template="plugin", plugins=("bt-node",), distro=each.name)) for each in DISTROS
    }
    assert [name for name, files in trees.items() if "behaviortree_cpp_v3" in files["package.xml"]] == ["humble"]


def test_what_can_not_be_is_refused() -> None:
    with pytest.raises(ScaffoldError, match=r"no kind of plugin `costmap-lyer` \(did you mean `costmap-layer`\?\)"):
        plan(template="plugin", plugins=("costmap-lyer",))
    with pytest.raises(ScaffoldError, match=r"no kind of plugin `costmap` \(did you mean `costmap-layer`\?\)"):
        plan(template="plugin", plugins=("wall:costmap",))
    with pytest.raises(ScaffoldError, match=r"knows no `CI` \(did you mean `ci`\?\)"):
        plan(extras=("CI",))
    with pytest.raises(ScaffoldError, match=r"no type of package `nodes`; known: .*, workspace"):
        plan(template="nodes")
    with pytest.raises(ScaffoldError, match="named twice"):
        plan(template="plugin", plugins=("pluginlib", "controller"))
    with pytest.raises(ScaffoldError, match="rospkg new my_robot_nav_plugins --plugin controller"):
        plan(template="mixed", plugins=("controller",))
    with pytest.raises(ScaffoldError, match="a plugin can't be called `filter`"):
        plan(template="plugin", plugins=("filter:pluginlib",))
    with pytest.raises(ScaffoldError, match="two or more lowercase letters"):
        plan(template="plugin", plugins=("Wall:costmap-layer",))


def test_the_option_chooses_the_type(tmp_path: Path) -> None:
    done = rospkg("new", "wall", "--plugin", "costmap-layer", "--dry-run", cwd=tmp_path)
    assert done.returncode == 0
    assert "plugins/wall.xml" in done.stdout


def test_the_page_lists_every_kind() -> None:
    page = (Path(__file__).parents[1] / "docs/new.md").read_text()
    assert f"| `--plugin [NAME:]KIND` | {', '.join(plugin_kinds())} |" in page
