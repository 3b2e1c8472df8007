"""Names: what is a ROS package, what is a rosdep key, who serves an import, and what nobody can tell."""

from __future__ import annotations

import fnmatch
import pickle

import pytest

from rospkg_cli.ros.aliases import key_for_pip, keys_for_cmake, successors
from rospkg_cli.ros.distros import Targets
from rospkg_cli.ros.imports import NO_PYTHON, may_serve, serving
from rospkg_cli.ros.names import BUILT_IN, Known, Names
from rospkg_cli.ros.rosdep import installer, pip_names
from rospkg_cli.ros.table import rows

FETCHED = Names({"rclpy": ("jazzy",), "old": ("humble",)}, {"python3-yaml": ("apt", "apt", "apt")}, complete=True)


@pytest.mark.parametrize("name", ["rclpy", "rclcpp", "sensor_msgs", "nav2_bringup", "launch_ros", "xacro", "rviz2"])
def test_core_packages_are_known_without_a_network(name: str) -> None:
    assert BUILT_IN.what(name) is Known.PACKAGE


@pytest.mark.parametrize(
    "name", ["python3-opencv", "eigen", "python3-pytest", "libopencv-dev", "python3-ultralytics-pip"]
)
def test_keys_are_known_without_a_network(name: str) -> None:
    assert BUILT_IN.what(name) is Known.KEY


def test_what_is_built_in_never_says_that_a_name_is_unknown() -> None:
    assert BUILT_IN.what("my_companys_driver") is Known.CANT_TELL


def test_an_index_that_was_fetched_does() -> None:
    assert FETCHED.what("my_companys_driver") is Known.UNKNOWN
    assert FETCHED.what("python3-yaml") is Known.KEY


def test_a_package_counts_for_the_targets_that_have_it() -> None:
    assert FETCHED.what("old", Targets(("humble",))) is Known.PACKAGE
    assert FETCHED.what("old", Targets(("jazzy",))) is Known.UNKNOWN
    assert FETCHED.what("old") is Known.PACKAGE


def test_the_built_in_names_pickle_small() -> None:
    assert BUILT_IN.is_package("rclpy")
    assert len(pickle.dumps(BUILT_IN)) < 500


def test_pip_keys() -> None:
    assert BUILT_IN.is_pip("python3-ultralytics-pip", Targets())
    assert not BUILT_IN.is_pip("python3-numpy", Targets())
    assert not BUILT_IN.is_pip("no-such-key", Targets())


@pytest.mark.parametrize(
    "module, name",
    [
        ("cv2", "python3-opencv"),
        ("yaml", "python3-yaml"),
        ("numpy.linalg", "python3-numpy"),
        ("google.protobuf.message", "python3-protobuf"),
        ("PIL.Image", "python3-pil"),
        ("rclpy.node", "rclpy"),
        ("sensor_msgs.msg", "sensor_msgs"),
        ("catkin_pkg.package", "python3-catkin-pkg-modules"),
        ("ultralytics", "python3-ultralytics-pip"),
        ("tkinter", "python3-tk"),
        ("urdf_parser_py.urdf", "urdfdom_py"),
    ],
)
def test_who_serves_an_import(module: str, name: str) -> None:
    assert serving(module).preferred == name


@pytest.mark.parametrize(
    "module", ["os", "os.path", "distutils.util", "tomllib", "google", "octomap", "no_such_module"]
)
def test_nobody_is_named_for_a_standard_or_an_unknown_module(module: str) -> None:
    assert serving(module).names == ()


def test_another_way_to_get_a_module_is_seen() -> None:
    assert may_serve("python3-simple-pid-pip", "simple_pid.PID")
    assert may_serve("python-yaml", "yaml")
    assert not may_serve("python3-numpy", "yaml")


@pytest.mark.parametrize(
    "pip, key",
    [("opencv_python", "python3-opencv"), ("PyYAML", "python3-yaml"), ("ultralytics", "python3-ultralytics-pip")],
)
def test_pip_names_have_keys(pip: str, key: str) -> None:
    assert key_for_pip(pip) == key


def test_a_pip_name_without_a_key_has_none() -> None:
    assert key_for_pip("no-such-thing-on-pypi") is None


def test_cmake_names() -> None:
    assert keys_for_cmake("Eigen3")[0] == "eigen"
    assert "-" in keys_for_cmake("Threads")
    assert keys_for_cmake("rclcpp") == ()


def test_ros_1_names() -> None:
    assert successors("rospy") == ("rclpy",)
    assert successors("rosout") == ()
    assert successors("rclpy") is None


def test_the_tables_name_only_what_exists() -> None:
    known = list(BUILT_IN.all())
    for table, nothing in (("imports.txt", NO_PYTHON), ("cmake.txt", "-"), ("ros1.txt", "-")):
        for name, served in rows(table).items():
            assert [each for each in served if each != nothing and not fnmatch.filter(known, each)] == [], name


def test_what_is_ros_1s_alone_is_no_package_of_ros_2() -> None:
    assert [name for name in rows("ros1.txt") if BUILT_IN.is_package(name) or BUILT_IN.is_key(name)] == []


@pytest.mark.parametrize(
    "entry, way",
    [
        ({"ubuntu": ["libace-dev"]}, "apt"),
        ({"ubuntu": []}, "apt"),
        ({"ubuntu": {"pip": {"packages": ["x"]}}}, "pip"),
        ({"ubuntu": {"apt": {"packages": ["x"]}, "pip": {"packages": ["x"]}}}, "apt"),
        ({"ubuntu": {"jammy": ["x"], "*": {"pip": ["x"]}}}, "apt"),
        ({"ubuntu": {"focal": ["x"], "*": {"pip": {"packages": ["x"]}}}}, "pip"),
        ({"ubuntu": {"focal": ["x"]}}, "-"),
        ({"ubuntu": {"jammy": None, "*": ["x"]}}, "-"),
        ({"fedora": ["x"]}, "-"),
        (None, "-"),
    ],
)
def test_how_a_key_resolves_on_jammy(entry: object, way: str) -> None:
    assert installer(entry, "jammy") == way


def test_the_names_on_pypi_of_a_key() -> None:
    assert pip_names({"ubuntu": {"*": {"pip": {"packages": ["a", "b"]}}}}, "noble") == ("a", "b")
    assert pip_names({"ubuntu": ["a"]}, "noble") == ()
