"""Plugins that `new` writes: compiled against signatures of their base classes, not run (`standins/plugins`)."""

from __future__ import annotations

from pathlib import Path

import pytest
from shell import Shell
from testing_new import STANDINS, linted, plan, write

from rospkg_cli.scaffold.plan import Plan
from rospkg_cli.scaffold.plugin_kinds import plugin_kinds

pytestmark = pytest.mark.debian
HEADERS = STANDINS / "plugins"
STRICT = ("-Wall", "-Wextra", "-Wpedantic", "-Werror")
EXPORT = """
macro(pluginlib_export_plugin_description_file category file)
  install(FILES ${file} DESTINATION share/${PROJECT_NAME}/plugins)
endmacro()
"""


def plugins(distro: str, kinds: tuple[str, ...] = plugin_kinds()) -> Plan:
    names = tuple(f"a_{kind.replace('-', '_')}:{kind}" for kind in kinds)
    return plan("my_plugins", template="plugin", plugins=names, distro=distro)


@pytest.mark.parametrize("distro", ["humble", "kilted", "lyrical"])
def test_sources_and_tests_compile(shell: Shell, tmp_path: Path, distro: str) -> None:
    folder = write(plugins(distro), tmp_path)
    whole = tmp_path / "whole.cpp"
    (tmp_path / "gtest").mkdir()
    (tmp_path / "gtest/gtest.h").write_text(
        "#define TEST(one, two) void one##_##two()\n#define EXPECT_NE(a, b) ((void)((a) != (b)))\n"
        '#define EXPECT_EQ(a, b) ((void)((a) == (b)))\n#define LIBRARY ""\n'
    )
    whole.write_text("".join(f'#include "{path}"\n' for path in sorted(folder.rglob("*.cpp"))))
    include = (f"-I{HEADERS}", f"-I{folder / 'include'}", f"-I{tmp_path}")
    options = ("-std=c++17", "-fsyntax-only", *STRICT, f"-D{distro.upper()}", *include)
    made = shell.run("g++", *options, whole, cwd=tmp_path)
    assert (made.returncode, made.stderr) == (0, "")


def test_it_builds_and_installs_libraries_and_descriptions(shell: Shell, tmp_path: Path) -> None:
    planned = plugins("jazzy", ("pluginlib", "nav2-controller", "bt-node"))  # of each form of CMake's commands one
    folder, prefix = write(planned, tmp_path), tmp_path / "install"
    linted(shell, folder, ("cpplint", "uncrustify"))
    for plugin in planned.answers.plugins:
        for package, target in plugin.kind.libraries.items():
            config = tmp_path / f"share/{package}/cmake/{package}Config.cmake"
            config.parent.mkdir(parents=True, exist_ok=True)
            config.write_text(found(package, target))
    options = (f"-DCMAKE_PREFIX_PATH={tmp_path}", f"-DCMAKE_INSTALL_PREFIX={prefix}", "-DBUILD_TESTING=OFF")
    flags = f"-DCMAKE_CXX_FLAGS=-Werror -DJAZZY -I{HEADERS}"
    for command in (
        ("cmake", "-S", folder, "-B", tmp_path / "build", *options, flags),
        ("cmake", "--build", tmp_path / "build", "--target", "install"),
    ):
        made = shell.run(*command, cwd=tmp_path)
        assert (made.returncode, made.stderr) == (0, ""), made.stdout
    for plugin in planned.answers.plugins:
        assert (prefix / f"lib/lib{plugin.library}.so").is_file()
        assert (prefix / f"share/my_plugins/{plugin.description}").is_file() == bool(plugin.base)
    assert (prefix / "include/my_plugins/my_plugins/filter.hpp").is_file()
    assert (prefix / "share/my_plugins/cmake/export_my_pluginsExport.cmake").is_file()


def found(package: str, target: str) -> str:
    """Return the CMake config of a stand-in."""
    if target.startswith("$"):
        return f"set({package}_TARGETS)\n"
    made = f"add_library({target} INTERFACE IMPORTED)\n" if target else f'set({package}_INCLUDE_DIRS "{HEADERS}")\n'
    return made + (EXPORT if package == "pluginlib" else "")
