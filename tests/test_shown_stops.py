"""Faults that are loud only where it is shown that something fails: what CMake is not given, and does not do."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, SETUP_CFG, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files


def said(files: dict[str, str], code: str) -> list[str]:
    found = lint_files({f"src/my_pkg/{path}": text for path, text in files.items()}, [code]).findings
    return [f"{each.severity.value}: {each.message}" for each in found]


def package(lines: str, **sources: str) -> dict[str, str]:
    text = CMAKE.replace("ament_package", f"{lines}\nament_package")
    named = {name.replace("__", "/"): text for name, text in sources.items()}
    return {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": text, **named}


GLOB = "file(GLOB SOURCES src/*.cpp)\nfile(GLOB HEADERS include/*.hpp)\n"
CODE = {"src/core/a.cpp": "int core() {return 1;}\n", "src/core/main.cc": "int main() {return 0;}\n"}


@pytest.mark.parametrize(
    ("lines", "level"),
    [
        ("add_library(core SHARED ${SOURCES})", "warning"),
        ("add_library(core SHARED ${SOURCES} ${HEADERS})", "warning"),
        ("add_library(core SHARED ${SOURCES} src/core/main.cc)", "info"),
        ("add_executable(core ${SOURCES} ${MORE})", "info"),
        ("foreach(each ${SOURCES})\n  message(${each})\nendforeach()", "info"),
        ("install(FILES ${SOURCES} DESTINATION share/my_pkg)", "info"),
        ("set(ALL ${SOURCES} src/core/main.cc)\nadd_library(core ${ALL})", "info"),
        ("rosidl_generate_interfaces(${PROJECT_NAME} ${SOURCES} DEPENDENCIES std_msgs)", "warning"),
    ],
)
def test_what_lacks_the_files_of_an_empty_glob(lines: str, level: str) -> None:
    (text,) = said(package(GLOB + lines) | CODE, "CMK124")
    assert text.startswith(f"{level}: ")
    assert ("; nothing here is made of it alone" in text) == (level == "info")


@pytest.mark.parametrize(
    ("lines", "level"),
    [
        ("function(message text)\nendfunction()", "info"),
        ("macro(install)\nendmacro()", "warning"),
        ("macro(find_package name)\n  list(APPEND FOUND ${name})\nendmacro()", "warning"),
        ("function(add_definitions)\n  message(STATUS none)\nendfunction()\nadd_definitions(-DARM)", "warning"),
        ("function(add_definitions)\n  add_compile_options(${ARGV})\nendfunction()\nadd_definitions(-DARM)", "info"),
        ("function(ament_package)\n  message(STATUS none)\nendfunction()", "warning"),
    ],
)
def test_a_command_that_is_defined_anew_to_do_the_same(lines: str, level: str) -> None:
    (text,) = said(package(lines), "CMK116")
    assert text.startswith(f"{level}: ")
    assert ("which may be meant" in text) == (level == "info")


NODE = "def main():\n    print('hello')\n"
STARTS = '<launch>\n  <node pkg="my_pkg" exec="talker"/>\n</launch>\n'


@pytest.mark.parametrize(("started", "level"), [("talker", "warning"), ("tuner", "error"), ("other", "error")])
def test_an_entry_point_of_a_module_that_is_left_out(started: str, level: str) -> None:
    entries = scripts("talker = my_pkg.talker:main", "tuner = my_pkg.more.tuner:main")
    files = {
        "package.xml": manifest(""),
        "setup.py": setup_py(entries).replace("find_packages(exclude=['test'])", "[package_name]"),
        "setup.cfg": SETUP_CFG,
        "launch/a.launch.xml": STARTS.replace("talker", started),
        **dict.fromkeys(("my_pkg/talker.py", "my_pkg/more/tuner.py"), NODE),
        **dict.fromkeys(("my_pkg/__init__.py", "my_pkg/more/__init__.py"), ""),
    }
    (text,) = said(files, "SET105")
    assert text.startswith(f"{level}: ")
    assert text.endswith("; nothing here starts it, as others of the package are") == (level == "warning")
