"""DEP001: keys of a list that a repository adds to rosdep's, and what ament_auto finds by their names."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

FOLDER = "/etc/ros/rosdep/sources.list.d"
LINE = "  <exec_depend>{}</exec_depend>\n"
ADDS = f"RUN echo 'yaml https://example.org/keys.yaml' > {FOLDER}/30-acme.list\n"
KEYS = "{}:\n  ubuntu: [gdown]\n"
STRANGE = ("python3-torch-acme-shim", "libacme-lidar-dev", "python3-acme-sdk")


def told(name: str, others: tuple[str, ...] = (), **files: str) -> list[str]:
    """Return the levels of what is said of a name; `others` are needed by another package."""
    tree = {"a/package.xml": manifest(LINE.format(name))}
    if others:
        tree["b/package.xml"] = manifest("".join(map(LINE.format, others))).replace("my_pkg", "other")
    found = lint_files({**tree, **{path.replace("__", "/"): text for path, text in files.items()}}, ["DEP001"]).findings
    return [each.severity.value for each in found if each.message.startswith(f"`{name}`")]


@pytest.mark.parametrize(
    "path, text, level",
    [
        ("Dockerfile", ADDS, "info"),
        ("README.md", f"    sudo cp acme.list {FOLDER}/\n", "info"),
        ("README.md", f"    curl -sSL https://example.org/a.list | sudo tee {FOLDER}/10-acme.list\n", "info"),
        ("docker/Dockerfile", f"COPY docker/acme.list {FOLDER}/10-acme.list\n", "info"),
        ("setup.sh", "export ROSDEP_SOURCE_PATH=/opt/acme/rosdep\n", "info"),
        ("setup.sh", f"if [ ! -f {FOLDER}/20-default.list ]; then sudo rosdep init; fi\n", "warning"),
        ("setup.sh", f"sudo curl -o {FOLDER}/20-default.list https://mirror.example.org/20-default.list\n", "warning"),
        ("setup.sh", f"sudo rm -rf {FOLDER}/\n", "warning"),
        ("rosdep/python.yaml", KEYS.format("python3-pyserial"), "info"),
        ("docker/extra_rosdeps.yaml", KEYS.format("python3-pyserial"), "info"),
        ("rosdep/python.yaml", KEYS.format("python3-other"), "warning"),
        ("config/python.yaml", KEYS.format("python3-pyserial"), "warning"),
    ],
)
def test_a_list_of_the_repository_may_have_a_key(path: str, text: str, level: str) -> None:
    assert told("python3-pyserial", **{path: text}) == [level]


@pytest.mark.parametrize("name", ["acme_other/", "rclpy.qos", "json", "sensor_msg"])
def test_no_list_has_a_slip_of_a_package(name: str) -> None:
    more = {"o/package.xml": manifest("").replace("my_pkg", "acme_other"), "Dockerfile": ADDS}
    assert told(name, **more) == ["warning"]


@pytest.mark.parametrize(
    "others, level",
    [
        (STRANGE[:2], "info"),
        (STRANGE[1:], "info"),
        (STRANGE[:1], "warning"),
        ((), "warning"),
        (("acme_common", "acme_arm", "acme_gripper"), "warning"),
        (("opencv-python", "python3-pyyaml", "python3-json"), "warning"),
        (("python3-numpy", "python3-yaml", "libopencv-dev"), "warning"),
    ],
)
def test_keys_that_are_slips_of_nothing_come_from_a_list(others: tuple[str, ...], level: str) -> None:
    assert told("python3-pyserial", others) == [level]


@pytest.mark.parametrize(
    "tags, is_found",
    [
        (("exec_depend",), False),
        (("test_depend",), False),
        (("build_export_depend",), False),
        (("build_depend",), True),
        (("exec_depend", "build_depend"), True),
        (("depend",), True),
    ],
)
def test_ament_auto_finds_what_the_build_needs_alone(tags: tuple[str, ...], is_found: bool) -> None:
    needs = "".join(f"  <{tag}>OpenCV</{tag}>\n" for tag in tags)
    lines = "find_package(ament_cmake_auto REQUIRED)\nament_auto_find_build_dependencies()\nament_auto_package()\n"
    files = {
        "package.xml": manifest(f"  <buildtool_depend>ament_cmake_auto</buildtool_depend>\n{needs}", "ament_cmake"),
        "CMakeLists.txt": f"cmake_minimum_required(VERSION 3.8)\nproject(my_pkg)\n{lines}",
    }
    (found,) = lint_files(files, ["DEP001"]).findings
    assert ("ament_auto finds it by that" in found.message) is is_found
    assert (found.fix is None) is is_found
