"""Libraries and plugins that `new` writes: built, linted, and used by others, with Debian's ament_cmake.

Base classes of plugins are signatures (`standins/plugins`): their code is compiled, not run.
"""

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

OPEN = "import ctypes, os, sys\nfor path in sys.argv[1:]: ctypes.CDLL(path, mode=os.RTLD_NOW)"
"""Opens libraries as a class loader does: a symbol that nothing defines stops it."""


def plugins(distro: str, kinds: tuple[str, ...] = plugin_kinds()) -> Plan:
    names = tuple(f"a_{kind.replace('-', '_')}:{kind}" for kind in kinds)
    return plan("my_plugins", template="plugin", plugins=names, distro=distro)


def test_sources_and_tests_of_plugins_compile(shell: Shell, tmp_path: Path) -> None:
    folder = write(plugins("lyrical"), tmp_path)
    whole = tmp_path / "whole.cpp"
    (tmp_path / "gtest").mkdir()
    (tmp_path / "gtest/gtest.h").write_text(
        "#define TEST(one, two) void one##_##two()\n#define EXPECT_NE(a, b) ((void)((a) != (b)))\n"
        '#define EXPECT_EQ(a, b) ((void)((a) == (b)))\n#define LIBRARY ""\n'
    )
    whole.write_text("".join(f'#include "{path}"\n' for path in sorted(folder.rglob("*.cpp"))))
    include = (f"-I{HEADERS}", f"-I{folder / 'include'}", f"-I{tmp_path}")
    options = ("-std=c++17", "-fsyntax-only", *STRICT, *include)
    made = shell.run("g++", *options, whole, cwd=tmp_path)
    assert (made.returncode, made.stderr) == (0, "")


def built(shell: Shell, folder: Path, place: Path, *options: str) -> Path:
    """Configure, build and install with warnings as errors; return the prefix."""
    known = ("-DCMAKE_C_COMPILER_WORKS=1", "-DCMAKE_CXX_COMPILER_WORKS=1")  # tried by the other tests
    known += () if folder.name == "consumer" else ("-DBUILD_TESTING=OFF",)
    for command in (
        ("cmake", "-S", folder, "-B", place, f"-DCMAKE_INSTALL_PREFIX={place / 'install'}", *known, *options),
        ("cmake", "--build", place, *(("--target", "install") if folder.name != "consumer" else ())),
    ):
        made = shell.run(*command, cwd=folder)
        assert (made.returncode, made.stderr) == (0, ""), made.stdout
    return place / "install"


def test_a_project_of_its_own_finds_a_library(shell: Shell, tmp_path: Path) -> None:
    folder = write(plan("my_mean", template="library", version="1.2.3"), tmp_path)
    prefix = built(shell, folder, tmp_path / "build", "-DCMAKE_CXX_FLAGS=-Werror")
    consumer = tmp_path / "consumer"
    built(shell, folder / "test/consumer", consumer, f"-Dmy_mean_DIR={prefix}/share/my_mean/cmake")
    used = shell.run(consumer / "consumer", cwd=tmp_path)
    assert (used.returncode, used.stdout) == (0, "1.2.3\n")


def test_plugins_are_installed_with_their_descriptions(shell: Shell, tmp_path: Path) -> None:
    planned = plugins("humble", ("pluginlib", "nav2-controller"))
    folder = write(planned, tmp_path)
    write(plugins("humble"), tmp_path / "all")
    write(plan("my_mean", template="library"), tmp_path / "all")
    linted(shell, tmp_path / "all/src", ("cpplint", "uncrustify"))
    for plugin in planned.answers.plugins:
        for package, target in plugin.kind.libraries.items():
            config = tmp_path / f"share/{package}/cmake/{package}Config.cmake"
            config.parent.mkdir(parents=True, exist_ok=True)
            config.write_text(found(package, target))
    flags = f"-DCMAKE_CXX_FLAGS=-Werror -DHUMBLE -I{HEADERS}"
    prefix = built(shell, folder, tmp_path / "build", f"-DCMAKE_PREFIX_PATH={tmp_path}", flags)
    for plugin in planned.answers.plugins:
        assert (prefix / f"lib/lib{plugin.library}.so").is_file()
        assert (prefix / f"share/my_plugins/{plugin.description}").is_file() == bool(plugin.base)
    libraries = [prefix / f"lib/lib{plugin.library}.so" for plugin in planned.answers.plugins]
    opened = shell.run("/usr/bin/python3", "-c", OPEN, *libraries, cwd=tmp_path)
    assert (opened.returncode, opened.stderr) == (0, "")
    assert (prefix / "include/my_plugins/my_plugins/filter.hpp").is_file()
    assert (prefix / "share/my_plugins/cmake/export_my_pluginsExport.cmake").is_file()


def found(package: str, target: str) -> str:
    """Return the CMake config of a stand-in."""
    if target.startswith("$"):
        return f"set({package}_TARGETS)\n"
    made = f"add_library({target} INTERFACE IMPORTED)\n" if target else f'set({package}_INCLUDE_DIRS "{HEADERS}")\n'
    return made + (EXPORT if package == "pluginlib" else "")
