"""Files that a robot names and that are not there: one finding for a missing folder, and none that others report."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, SETUP_PY, manifest
from rospkg_cli.finding import Finding
from rospkg_cli.testing import lint_files

HEAD = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">'
INSTALL = "install(DIRECTORY meshes urdf DESTINATION share/${PROJECT_NAME})\nament_package"


def mesh(path: str) -> str:
    return f'<m f="package://robot/{path}"/>'


def lint(
    text: str, codes: tuple[str, ...] = ("URD002",), others: dict[str, str] | None = None, **more: str | None
) -> tuple[Finding, ...]:
    """Lint a robot beside a package of parts; keyword `a__b_DOT_c` is the file `a/b.c` of the robot's package."""
    files = dict(others or {})
    for name in ("robot", "parts"):
        files[f"{name}/package.xml"] = manifest("", "ament_cmake", name)
        files[f"{name}/CMakeLists.txt"] = CMAKE.replace("my_pkg", name).replace("ament_package", INSTALL)
        files[f"{name}/meshes/arm.stl"] = "solid\n"
    files["robot/urdf/robot.xacro"] = f"{HEAD}{text}</robot>\n"
    files["robot/README.md"] = "xacro urdf/robot.xacro\n"
    for name, content in more.items():
        files["robot/" + name.replace("__", "/").replace("_DOT_", ".")] = content or ""
    return lint_files(files, list(codes)).findings


def test_the_files_of_a_missing_folder_are_one_finding() -> None:
    (finding,) = lint(mesh("meshes/pi/a.stl") + mesh("meshes/pi/b.stl") + mesh("meshes/pi/b.stl"))
    assert "`robot` has no folder `meshes/pi` for `meshes/pi/a.stl` and `meshes/pi/b.stl`" in finding.message
    assert [text for _, text in finding.related] == ["`meshes/pi/b.stl` too", "`meshes/pi/b.stl` too"]


def test_files_missing_in_a_folder_that_is_there_are_two() -> None:
    assert len(lint(mesh("meshes/legs.stl") + mesh("meshes/feet.stl"))) == 2


def test_one_place_of_a_missing_folder_names_no_more() -> None:
    (finding,) = lint(mesh("meshes/pi/a.stl"))
    assert finding.message.startswith("`robot` has no folder `meshes/pi` for `meshes/pi/a.stl`: it is missing")
    assert finding.message.endswith("; add it, or correct the path")


def test_a_near_folder_is_suggested_for_a_name_that_is_in_several() -> None:
    there: dict[str, str | None] = {f"meshes__{name}__base_DOT_dae": "d\n" for name in ("pi_260", "seeed")}
    (finding,) = lint(mesh("meshes/pii_260/base.dae"), **there)
    assert finding.message.endswith("; did you mean `meshes/pi_260`?")


def test_the_file_beside_the_robot_is_suggested() -> None:
    there = {f"urdf__{name}joint_DOT_dae": "d\n" for name in ("", "old__", "new__")}
    (finding,) = lint(mesh("robots/joint.dae"), **there)
    assert finding.message.endswith("; did you mean `urdf`?")
    assert "no folder `robots`" in finding.message


def test_a_folder_is_suggested_by_what_differs() -> None:
    (finding,) = lint(mesh("models/v1/joint.dae"), meshes__v1__joint_DOT_dae="d\n")
    assert finding.message.endswith("; did you mean `meshes`?")


def test_what_the_build_writes_is_not_missing() -> None:
    cmake = INSTALL.replace("ament_package", "configure_file(a.in leg.stl)\nament_package")
    text = CMAKE.replace("my_pkg", "robot").replace("ament_package", cmake)
    assert lint(mesh("meshes/leg.stl"), CMakeLists_DOT_txt=text, a_DOT_in="") == ()


def test_a_robot_that_is_not_installed_is_read_from_the_source_alone() -> None:
    text = f"{HEAD}{mesh('meshes/leg.stl')}</robot>\n"
    launch = "PATH = folder + '/batch/other.xacro'\n"
    (finding,) = lint("", batch__other_DOT_xacro=text, launch__other_DOT_launch_DOT_py=launch)
    assert finding.severity.value == "info"
    assert ", where the robot is read from the source: it is not installed; add it" in finding.message


def test_what_git_ignores_of_another_package_is_not_missing() -> None:
    assert len(lint('<m f="package://parts/meshes/made.stl"/>')) == 1
    other = {"parts/.gitignore": "made.stl\n"}
    assert lint('<m f="package://parts/meshes/made.stl"/>', others=other) == ()


def test_what_another_package_does_not_install() -> None:
    (finding,) = lint('<m f="package://parts/models/a.stl"/><m f="package://parts/models/b.stl"/>')
    assert finding.message.startswith("`parts` installs no folder `models` for `models/a.stl` and `models/b.stl`")


@pytest.mark.parametrize(
    "around, level, ends",
    [
        ("{}", "error", "xacro stops here; add it, or correct the path"),
        ('<xacro:if value="$(arg arm)">{}</xacro:if>', "warning", "where the condition around it holds; add it"),
        ('<xacro:if value="$(arg arm)">{0}</xacro:if>{0}', "error", "xacro stops here; add it"),
        ('<xacro:macro name="m">{}</xacro:macro>', "info", "calls the macro `m`; add it"),
        ('<xacro:macro name="m">{}</xacro:macro><xacro:m/>', "error", "xacro stops here; add it"),
    ],
)
def test_the_level_is_that_of_the_most_certain_place(around: str, level: str, ends: str) -> None:
    include = '<xacro:include filename="$(find robot)/meshes/arm.xacro.in"/>'
    (finding,) = lint(around.format(include), launch__show_DOT_xml="<launch>robot.xacro</launch>\n")
    assert finding.severity.value == level
    assert ends in finding.message


def test_a_property_that_nothing_reads_is_an_info() -> None:
    (finding,) = lint('<xacro:property name="m" value="$(find robot)/meshes/legs.stl"/>')
    assert finding.severity.value == "info"


def test_files_that_are_not_installed_are_one_finding_a_folder() -> None:
    cmake = INSTALL.replace("meshes", "meshes/v1")
    text = CMAKE.replace("my_pkg", "robot").replace("ament_package", cmake.replace("NAME}", "NAME}/meshes", 1))
    there: dict[str, str | None] = {f"meshes__{name}_DOT_obj": "o\n" for name in ("a", "b", "v1__c")}
    (finding,) = lint(mesh("meshes/a.obj") + mesh("meshes/b.obj"), CMakeLists_DOT_txt=text, **there)
    assert finding.message.startswith("`meshes/a.obj` and `meshes/b.obj` are there, but `robot` does not install them")
    assert finding.message.endswith("; install `meshes` (`data_files` in setup.py, `install(…)` in CMakeLists.txt)")


def test_a_folder_that_setup_py_leaves_out_is_reported_there_alone() -> None:
    setup = SETUP_PY.replace("my_pkg", "robot").replace(
        "['package.xml']),",
        "['package.xml']),\n        ('share/robot/urdf', ['urdf/robot.xacro']),\n"
        "        ('share/robot/meshes', glob('meshes/*.stl')),",
    )
    files = {
        "package.xml": manifest("", "ament_python", "robot"),
        "setup.py": "from glob import glob\n" + setup,
        "resource/robot": "",
        "robot/__init__.py": "",
        "meshes/arm.stl": "solid\n",
        "meshes/leg.dae": "d\n",
        "urdf/robot.xacro": f"{HEAD}{mesh('meshes/leg.dae')}</robot>\n",
    }
    assert {each.code for each in lint_files(files, ["URD002", "SET207"]).findings} == {"SET207"}


GIVES = "Command(['xacro ', 'urdf/robot.xacro', ' config:=', config])\n"
MAPS = "xacro.process_file('urdf/robot.xacro', mappings={'config': config})\n"
LEAVES = "Command(['xacro ', 'urdf/robot.xacro', ' other_config:=', config])\n"
NO_ROBOT = "Command(['xacro ', 'urdf/wheel.xacro'])\n"


@pytest.mark.parametrize(
    "launches, level",
    [
        ((GIVES,), "info"),
        ((MAPS,), "info"),
        ((GIVES, MAPS, NO_ROBOT, "config = 'robot'\n"), "info"),
        ((GIVES, LEAVES), "warning"),
        ((LEAVES,), "warning"),
        ((LEAVES, "other = {'config': config}\n"), "warning"),
    ],
)
def test_a_default_that_each_launch_file_replaces_is_an_info(launches: tuple[str, ...], level: str) -> None:
    default = '<xacro:arg name="config" default="$(find robot)/meshes/arm.yaml"/><a b="$(arg config)"/>'
    files = {f"robot/launch/{at}.launch.py": text for at, text in enumerate(launches)}
    (finding,) = lint(default, others=files)
    assert finding.severity.value == level
    assert ("where no `config:=` is given" in finding.message) is (level == "info")


def test_a_default_beside_another_use_is_a_warning() -> None:
    use = '"$(find robot)/meshes/arm.yaml"/>'
    default = f'<xacro:arg name="config" default={use}<xacro:property name="c" lazy_eval="false" value={use}'
    (finding,) = lint(default, others={"robot/launch/a.launch.py": GIVES})
    assert finding.severity.value == "warning"


def test_a_package_beside_that_has_the_files_of_an_unknown_one_is_meant() -> None:
    text = '<m f="package://old_parts/meshes/arm.stl"/><m f="package://old_parts/meshes/leg.stl"/>'
    (finding,) = lint(text, ("DEP106",), {"parts/meshes/leg.stl": "solid\n"})
    assert finding.message.endswith("did you mean `parts`, which has `meshes/arm.stl` and `meshes/leg.stl`?")


def test_a_file_that_wraps_one_of_its_own_path_is_no_former_name() -> None:
    (finding,) = lint('<x:include filename="$(find old_robot)/urdf/robot.xacro"/>', ("DEP106",))
    assert "did you mean" not in finding.message
