"""Names: what is a ROS package, what is a rosdep key, who serves an import, and what nobody can tell."""

from __future__ import annotations

import fnmatch
import pickle

import pytest

from rospkg_cli.ros.aliases import key_for_apt, key_for_pip, keys_for_cmake, successors
from rospkg_cli.ros.distros import DISTROS, Targets, distro
from rospkg_cli.ros.imports import NO_PYTHON, may_serve, providers
from rospkg_cli.ros.name_index import Index, dump
from rospkg_cli.ros.name_suggestions import MAX_TYPOS, suggested_name, typos_between
from rospkg_cli.ros.names import BUILT_IN, FetchedNames, NameKind
from rospkg_cli.ros.read_table import rows
from rospkg_cli.ros.rosdep import installer, merged, pip_names

ALL = tuple(each.name for each in DISTROS)
FETCHED = FetchedNames(
    dump(
        Index(
            "/a/copy",
            "2026-11-01T12:00:00Z",
            ALL,
            {"rclpy": ("jazzy",), "old": ("humble",), "wheel_driver": ("humble",)},
            {
                "python3-yaml": ("apt", "apt", "apt"),
                "python-old": ("apt", "-", "-"),
                "python3-new-pip": ("-", "-", "pip"),
            },
            apt={"libnew-dev": ("new",), "libtwo-dev": ("two", "deux")},
        )
    )
)


@pytest.mark.parametrize("name", ["rclpy", "rclcpp", "sensor_msgs", "nav2_bringup", "launch_ros", "xacro", "rviz2"])
def test_core_packages_are_known_without_a_network(name: str) -> None:
    assert BUILT_IN.kind_of(name) is NameKind.PACKAGE


@pytest.mark.parametrize(
    "name", ["python3-opencv", "eigen", "python3-pytest", "libopencv-dev", "python3-ultralytics-pip"]
)
def test_keys_are_known_without_a_network(name: str) -> None:
    assert BUILT_IN.kind_of(name) is NameKind.KEY


def test_what_is_built_in_never_says_that_a_name_is_unknown() -> None:
    assert BUILT_IN.kind_of("my_companys_driver") is NameKind.CANT_TELL


def test_an_index_that_was_fetched_does() -> None:
    assert FETCHED.kind_of("my_companys_driver") is NameKind.UNKNOWN
    assert FETCHED.kind_of("python3-yaml") is NameKind.KEY


def test_a_package_counts_for_the_targets_that_have_it() -> None:
    assert FETCHED.kind_of("old", Targets(("humble",))) is NameKind.PACKAGE
    assert FETCHED.kind_of("old", Targets(("jazzy",))) is NameKind.UNKNOWN
    assert FETCHED.kind_of("old") is NameKind.PACKAGE


def test_a_key_counts_for_the_targets_whose_ubuntu_has_a_rule() -> None:
    assert FETCHED.kind_of("python-old") is NameKind.KEY
    assert FETCHED.resolves("python-old", distro("humble")) is True
    assert FETCHED.resolves("python-old", distro("jazzy")) is False
    assert FETCHED.is_pip("python3-new-pip", Targets(("lyrical",)))
    assert not FETCHED.is_pip("python3-new-pip", Targets(("jazzy",)))


def test_what_is_built_in_contradicts_the_no_of_an_index() -> None:
    """A mirror may hold a part of rosdistro."""
    assert FETCHED.kind_of("sensor_msgs") is NameKind.CANT_TELL
    assert FETCHED.resolves("sensor_msgs", distro("jazzy")) is None
    assert not FETCHED.is_package("sensor_msgs")


def test_an_index_of_one_distribution_knows_nothing_of_the_others() -> None:
    names = FetchedNames(dump(Index("/a", "2026-11-01T12:00:00Z", ("humble",), {"own": ("humble",)}, {})))
    assert names.kind_of("my_companys_driver", Targets(("humble",))) is NameKind.UNKNOWN
    assert names.kind_of("my_companys_driver", Targets(("humble", "jazzy"))) is NameKind.CANT_TELL
    assert names.kind_of("my_companys_driver") is NameKind.CANT_TELL
    assert names.kind_of("sensor_msgs", Targets(("jazzy",))) is NameKind.PACKAGE
    assert set(names.packages["own"]) == {"humble"}


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
    assert providers(module).preferred == name


@pytest.mark.parametrize(
    "module", ["os", "os.path", "distutils.util", "tomllib", "google", "octomap", "no_such_module"]
)
def test_nobody_is_named_for_a_standard_or_an_unknown_module(module: str) -> None:
    assert providers(module).names == ()


def test_another_way_to_get_a_module_is_seen() -> None:
    assert may_serve("python3-simple-pid-pip", "simple_pid.PID")
    assert may_serve("python-yaml", "yaml")
    assert not may_serve("python3-numpy", "yaml")
    assert not any(may_serve(name, name) for name in ("git", "msgpack", "vlc", "yaml"))


@pytest.mark.parametrize(
    "pip, key",
    [("opencv_python", "python3-opencv"), ("PyYAML", "python3-yaml"), ("ultralytics", "python3-ultralytics-pip")],
)
def test_pip_names_have_keys(pip: str, key: str) -> None:
    assert key_for_pip(pip) == key


def test_a_pip_name_without_a_key_has_none() -> None:
    assert key_for_pip("no-such-thing-on-pypi") is None


@pytest.mark.parametrize(
    "name, meant",
    [
        ("libeigen3-dev", "eigen"),
        ("ros-jazzy-nav2-bringup", "nav2_bringup"),
        ("ros-jazzy-no-such-thing", None),
        ("libopencv-dev", None),
        ("libqt5core5a", None),
    ],
)
def test_names_in_ubuntu_have_keys(name: str, meant: str | None) -> None:
    assert key_for_apt(name) == meant


def test_a_name_in_ubuntu_with_several_keys_means_none() -> None:
    assert key_for_apt("libnew-dev", FETCHED) == "new"
    assert key_for_apt("libtwo-dev", FETCHED) is None


@pytest.mark.parametrize(
    "name, meant",
    [
        ("sensor_msg", "sensor_msgs"),
        ("Sensor-Msgs", "sensor_msgs"),
        ("robot_localisation", "robot_localization"),
        ("python3-pyserial", "python3-serial"),
        ("eigen3", "eigen"),
        ("turtlebot4", None),
        ("nav_msg", "nav_msgs"),
        ("carla_msgs", None),
        ("umx_driver", None),
        ("my_companys_driver", None),
        ("std_srvs", None),
    ],
)
def test_what_is_likely_meant(name: str, meant: str | None) -> None:
    assert suggested_name(name, BUILT_IN, Targets(("jazzy",))) == meant


@pytest.mark.parametrize(
    "word, other, far",
    [
        ("robot", "robot", 0),
        ("robot", "robor", 1),  # of five letters one may be another
        ("urdf", "urdg", MAX_TYPOS + 1),
        ("msg", "msgs", 1),  # of three one may be left out
        ("ms", "msg", MAX_TYPOS + 1),
        ("navigator", "nabigatos", 2),  # of nine two may be others
        ("navigate", "nabigats", MAX_TYPOS + 1),
        ("turtlelib", "turtlesim", MAX_TYPOS + 1),  # another part is another name
        ("transforms", "transformer", MAX_TYPOS + 1),
        ("descritpionn", "description", 2),  # letters that are swapped or doubled are slips
        ("descriptionns", "description", 2),
        ("generators", "generatosr", 1),
    ],
)
def test_a_slip_wants_a_word_that_is_long_enough(word: str, other: str, far: int) -> None:
    assert typos_between(word, other) == typos_between(other, word) == far


def test_only_what_a_target_has_is_meant() -> None:
    assert suggested_name("wheel_drivers", FETCHED, Targets(("humble",))) == "wheel_driver"
    assert suggested_name("wheel_drivers", FETCHED, Targets(("jazzy",))) is None


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
        ({"ubuntu": {"jammy": "x y"}}, "apt"),
        ({"ubuntu": {"snap": {"packages": ["x"]}}}, "-"),
        ({"ubuntu": {"npm": {"packages": ["x"]}}}, "npm"),
        ({"ubuntu": {"jammy": {"unheard-of": ["x"]}}}, "apt"),
        ({"*": {"pip": {"packages": ["x"]}}, "fedora": ["x"]}, "pip"),
        ({"*": ["x"]}, "-"),
        ({"ubuntu": None, "*": {"pip": ["x"]}}, "-"),
        ({"ubuntu": 3}, "-"),
        ({"fedora": ["x"]}, "-"),
        (None, "-"),
    ],
)
def test_how_a_key_resolves_on_jammy(entry: object, way: str) -> None:
    assert installer(entry, "jammy") == way


def test_the_names_on_pypi_of_a_key() -> None:
    assert pip_names({"ubuntu": {"*": {"pip": {"packages": ["a", "b"]}}}}, "noble") == ("a", "b")
    assert pip_names({"ubuntu": ["a"]}, "noble") == ()


def test_the_first_list_holds_for_each_operating_system() -> None:
    lists = [{"a": {"ubuntu": ["x"]}}, {"a": {"ubuntu": ["y"], "fedora": ["z"]}, "b": None, 3: {}}]
    assert merged(lists) == {"a": {"ubuntu": ["x"], "fedora": ["z"]}}
