"""C++ that `new` writes, as clang-tidy sees it, with clang's own warnings: nodes of every kind, a library, plugins.

Headers of ROS are stand-ins, those of messages are real rosidl's. All sources of a package are read as one, since most
of the time goes into the standard library's headers.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest
from messages import message_prefix
from shell import Shell
from testing_new import PREFIX, STANDINS, plan, write

from rospkg_cli.scaffold.plugin_kinds import plugin_kinds
from rospkg_cli.scaffold.template import load_template

pytestmark = [pytest.mark.debian, pytest.mark.network]
CHECKS = (
    "-*", "bugprone-*", "clang-analyzer-*", "clang-diagnostic-*", "google-*", "performance-*",
    "-bugprone-easily-swappable-parameters",
    "-bugprone-reserved-identifier",  # include guards as ament_cpplint wants them have `__`
    "-performance-unnecessary-value-param",  # rclcpp says what its callbacks take
)  # fmt: skip
WARNINGS = ("-Wall", "-Wextra", "-Wpedantic")
KINDS = load_template("ament_cmake").kinds
NODES = (
    *(f"n_{kind.replace('-', '_')}:{kind}" for kind in KINDS), "hearer:subscriber:std_msgs/String",
    "all:subscriber:std_msgs/String@/in+publisher:std_msgs/String@out+client:example_interfaces/AddTwoInts",
)  # fmt: skip
PLUGINS = tuple(f"a_{kind.replace('-', '_')}:{kind}" for kind in plugin_kinds())
VERSION = '#define MY_MEAN_VERSION_STR "0.1.0"\n'


def said(shell: Shell, place: Path, packages: Sequence[Path], headers: Sequence[Path]) -> str:
    """Return what clang-tidy says of the sources of packages, where `headers` are the folders of others'."""
    sources = sorted(each for folder in packages for each in (folder / "src").glob("*.cpp"))
    whole = place / "whole.cpp"  # one text: the analyzer passes over functions of what is included
    whole.write_text("".join(f"#define main main_{n}\n{s.read_text()}#undef main\n" for n, s in enumerate(sources)))
    own = [folder / each for folder in packages for each in ("include", "src")]
    include = [*(f"-isystem{each}" for each in headers), *(f"-I{each}" for each in own)]
    options = (f"-checks={','.join(CHECKS)}", "-header-filter=.*", "-quiet")
    return shell.run("clang-tidy", *options, whole, "--", "-std=c++17", *WARNINGS, *include, cwd=place).stdout


def test_it_has_nothing_to_say_of_nodes_and_libraries(debian_colcon: Shell, tmp_path: Path) -> None:
    nodes = write(plan("my_nodes", template="ament_cmake", nodes=NODES, distro="humble"), tmp_path)
    library = write(plan("my_mean", template="library"), tmp_path)
    (tmp_path / "my_mean").mkdir()
    (tmp_path / "my_mean/version.hpp").write_text(VERSION)
    messages = (message_prefix(debian_colcon) / "include").glob("*")
    headers = [PREFIX / "include", *messages, *Path("/usr/include").glob("rosidl_*"), tmp_path]
    assert said(debian_colcon, tmp_path, [nodes, library], headers) == ""


def test_nor_of_plugins_and_it_would_say_something(shell: Shell, tmp_path: Path) -> None:
    folder = write(plan("my_plugins", template="plugin", plugins=PLUGINS, distro="lyrical"), tmp_path)
    (folder / "src/worse.cpp").write_text("int worse(int used) {int left = 1; return 4 / (left - 1);}\n")
    found = said(shell, tmp_path, [folder], [STANDINS / "plugins"])
    codes = {line.rpartition("[")[2] for line in found.splitlines() if "warning: " in line}
    assert codes == {"clang-analyzer-core.DivideZero]", "clang-diagnostic-unused-parameter]"}
