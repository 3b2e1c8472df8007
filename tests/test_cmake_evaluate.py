"""What a package's CMake does, evaluated without CMake."""

# ruff: noqa: E501  (a case a line)

from __future__ import annotations

import pytest
from cmaking import read, read_files, shown
from hypothesis import given
from hypothesis import strategies as st

from rospkg_cli.example import manifest
from rospkg_cli.languages.cmake.argument_words import substitute
from rospkg_cli.languages.cmake.values import UNKNOWN

HEAD = "project(my_pkg)\n"


def echo(text: str, **files: str) -> list[str]:
    """Return what `echo(…)` was called with."""
    return shown(read(HEAD + text, **files).named("echo"))


@pytest.mark.parametrize(
    "text, said",
    [
        ("set(a b c)\necho(${a} \"${a}\")", ["b c b;c"]),
        ('set(a "b;c")\necho(${a})', ["b c"]),
        ("echo(${PROJECT_NAME}_node)", ["my_pkg_node"]),
        ("set(my_pkg_x 1)\necho(${${PROJECT_NAME}_x})", ["1"]),
        ("echo(${CMAKE_CURRENT_SOURCE_DIR}/src ${CMAKE_CURRENT_BINARY_DIR})", ["/~source/src /~binary"]),
        ("set(a ${a} b)\necho(${a})", ["b"]),
        ("echo(${never_heard_of})", ["∅"]),
        ("echo(x${never_heard_of}y)", ["x∅y"]),
        ("set(CMAKE_CXX_FLAGS \"${CMAKE_CXX_FLAGS} -Wall\")\necho(${CMAKE_CXX_FLAGS})", ["∅ -Wall"]),
        ("echo($<BUILD_INTERFACE:${PROJECT_NAME}>)", ["$<BUILD_INTERFACE:my_pkg>"]),
        ("echo($ENV{ROS_VERSION} $ENV{HOME})", ["2 ∅"]),
        ("echo([[${a}]] a\\;b \"c\\n\")", ["${a} a;b c\n"]),
        ("option(O \"\" ON)\necho(${O})", ["∅"]),
        ("set(a 1 CACHE STRING \"\")\nset(b ON CACHE BOOL \"\")\necho(${a} ${b})", ["1 ∅"]),
        ("set(a \"b\" c CACHE STRING \"\")\nset(a d CACHE STRING \"\")\necho(${a})", ["b c"]),
        ("set(a 1)\nset(a 2 CACHE PATH \"\" FORCE)\nset(b 1)\nset(b 2 CACHE INTERNAL \"\")\necho(${a} ${b})", ["2 2"]),
        ("option(a \"\" ON)\nset(a OFF CACHE BOOL \"\" FORCE)\necho(${a})", ["OFF"]),
        ("set(a b)\nunset(a)\necho(${a} c)", ["c"]),
        ("set(a \"[=[b;c]=]\")\nset(d \"${a} e\")\necho(\"${d}\")", ["[=[b;c]=] e"]),
    ],
)  # fmt: skip
def test_variables(text: str, said: list[str]) -> None:
    assert echo(text) == said


@pytest.mark.parametrize(
    "text, said",
    [
        ("list(APPEND a b c)\nlist(PREPEND a d)\necho(${a})", ["d b c"]),
        ("set(a b c b)\nlist(REMOVE_DUPLICATES a)\nlist(REMOVE_ITEM a c)\necho(${a})", ["b"]),
        ("set(a x.cpp y.hpp)\nlist(FILTER a INCLUDE REGEX \"\\\\.cpp$\")\necho(${a})", ["x.cpp"]),
        ("set(a b c d)\nlist(LENGTH a n)\nlist(GET a 0 -1 e)\nlist(JOIN a - j)\necho(${n} ${e} ${j})", ["3 b d b-c-d"]),
        ("set(a c b)\nlist(SORT a)\nlist(REVERSE a)\nlist(INSERT a 1 x)\necho(${a})", ["c x b"]),
        ("set(a b c)\nlist(TRANSFORM a PREPEND src/)\nlist(TRANSFORM a APPEND .cpp)\necho(${a})", ["src/b.cpp src/c.cpp"]),
        ("set(a b c)\nlist(POP_FRONT a f)\necho(${f} ${a})", ["b c"]),
        ("set(a b c)\nlist(FIND a c i)\nlist(SUBLIST a 1 1 s)\necho(${i} ${s})", ["1 c"]),
        ("set(a b)\nlist(ODD a)\necho(${a})", ["∅"]),
        ("string(REPLACE a b x banana)\nstring(TOUPPER ${x} y)\necho(${x} ${y})", ["bbnbnb BBNBNB"]),
        ("string(REGEX REPLACE \"(.*)\\\\.cpp\" \"\\\\1.hpp\" x a.cpp)\necho(${x})", ["a.hpp"]),
        ("string(REGEX MATCH \"[0-9]+\" x a12b)\nstring(CONCAT y a b)\nstring(LENGTH abc z)\necho(${x} ${y} ${z})", ["12 ab 3"]),
        ("string(TIMESTAMP x)\nstring(SUBSTRING abcdef 1 3 y)\nstring(APPEND y !)\necho(${x} ${y})", ["∅ bcd!"]),
        ("get_filename_component(n src/a.b.cpp NAME_WE)\nget_filename_component(d src/a.cpp DIRECTORY)\necho(${n} ${d})", ["a src"]),
        ("get_filename_component(p ../x ABSOLUTE)\nget_filename_component(e a.tar.gz EXT)\necho(${p} ${e})", ["∅ .tar.gz"]),
        ("get_filename_component(u ${CMAKE_CURRENT_SOURCE_DIR} DIRECTORY)\nget_filename_component(v ${u} PATH)\nget_filename_component(w ${v}/a/b DIRECTORY)\necho(${u} ${v} ${w})", ["/~source/.. /~source/../.. /~source/../../a"]),
        ("get_filename_component(u ${CMAKE_CURRENT_SOURCE_DIR}/src DIRECTORY)\nget_filename_component(v ${CMAKE_CURRENT_SOURCE_DIR}/a/b.c DIRECTORY)\necho(${u} ${v})", ["/~source /~source/a"]),
        ("get_filename_component(n ${CMAKE_CURRENT_SOURCE_DIR} NAME)\nget_filename_component(m ${CMAKE_CURRENT_SOURCE_DIR}/.. NAME)\nget_filename_component(a ${CMAKE_CURRENT_SOURCE_DIR} ABSOLUTE)\necho(${n} ${m} ${a})", ["∅ ∅ /~source"]),
        ("math(EXPR x \"2 * 21\")\nmath(EXPR y \"1 / 0\")\necho(${x} ${y})", ["42 ∅"]),
        ("string(REGEX REPLACE \"(a+)+$\" b x aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaac)\necho(${x})", ["∅"]),
        ("execute_process(COMMAND git OUTPUT_VARIABLE v)\nfind_library(l x)\necho(${v} ${l})", ["∅ ∅"]),
        ("set(v old)\nsomeones_command(v)\necho(${v})", ["∅"]),
        ("set(v a.cpp)\nqt5_wrap_cpp(v include/b.hpp ${never_heard_of})\necho(${v})", ["a.cpp /~binary/wrapped_b.hpp.cpp ∅"]),
        ("qt_wrap_ui(v b.ui)\nqt6_wrap_cpp()\necho(${v})", ["/~binary/wrapped_b.ui.cpp"]),
        ("set(v 'a b')\nset(w a b)\nseparate_arguments(w)\necho(${w})", ["a b"]),
    ],
)  # fmt: skip
def test_lists_and_strings(text: str, said: list[str]) -> None:
    assert echo(text) == said


@pytest.mark.parametrize(
    "text, said",
    [
        ("foreach(x a b)\necho(${x})\nendforeach()", ["a", "b"]),
        ("set(l a b)\nforeach(x IN LISTS l ITEMS c)\necho(${x})\nendforeach()", ["a", "b", "c"]),
        ("foreach(x RANGE 1 5 2)\necho(${x})\nendforeach()", ["1", "3", "5"]),
        ("foreach(x ${unheard})\necho(${x})\nendforeach()", ["? ∅"]),
        ("foreach(x a b c)\nif(x STREQUAL b)\ncontinue()\nendif()\necho(${x})\nendforeach()", ["a", "c"]),
        ("foreach(x a b c)\nif(x STREQUAL b)\nbreak()\nendif()\necho(${x})\nendforeach()", ["a"]),
        ("set(i 0)\nwhile(i LESS 3)\nmath(EXPR i \"${i} + 1\")\nendwhile()\necho(${i})", ["3"]),
        ("function(f a)\necho(${a} ${ARGN} ${ARGC})\nset(b 1)\nendfunction()\nf(x y z)\necho(${b} end)", ["x y z 3", "end"]),
        ("function(f)\nset(b 1 PARENT_SCOPE)\nendfunction()\nf()\necho(${b})", ["1"]),
        ("macro(m a)\nset(b ${a}1)\nendmacro()\nM(x)\necho(${b})", ["x1"]),
        ("function(f)\nif(TRUE)\nreturn()\nendif()\necho(no)\nendfunction()\nf()\necho(yes)", ["yes"]),
        ('set(G "N;n;S;a;b")\ncmake_parse_arguments(A "" "N" "S" "${G}" u)\necho(${A_N} ${A_S})', ["n a b u"]),
        ('cmake_parse_arguments("" "" "N" "" N n)\necho(${_N})', ["n"]),
        ('function(f)\ncmake_parse_arguments(PARSE_ARGV 0 A "" "" "S")\necho(${A_S})\nendfunction()\nf(S "a;b")',
         ["a b"]),
        ("function(f)\ncmake_parse_arguments(A \"Q\" \"N\" \"S\" ${ARGN})\necho(${A_N} ${A_S} ${A_Q} ${A_UNPARSED_ARGUMENTS})\nendfunction()\nf(u N n v S a b Q)", ["n a b TRUE u v"]),
        ("block(PROPAGATE x)\nset(x 1)\nset(y 1)\nendblock()\nset(y ${y} 2)\necho(${x} ${y})", ["1 2"]),
    ],
)  # fmt: skip
def test_loops_and_functions(text: str, said: list[str]) -> None:
    assert echo(text) == said


@pytest.mark.parametrize(
    "condition, branches",
    [
        ("TRUE", ["yes"]),
        ("0", ["no"]),
        ("unheard_of", ["? yes", "? no"]),
        ("NOT WIN32 AND UNIX", ["yes"]),
        ("MSVC OR APPLE", ["no"]),
        ("$ENV{ROS_VERSION} EQUAL 2", ["yes"]),
        ("\"$ENV{ROS_VERSION}\" STREQUAL \"1\"", ["no"]),
        ("$ENV{ROS_DISTRO} STREQUAL humble", ["? yes", "? no"]),
        ("DEFINED ENV{AMENT_PREFIX_PATH}", ["yes"]),
        ("DEFINED ENV{HOME}", ["? yes", "? no"]),
        ("3.10.1 VERSION_LESS 3.9", ["no"]),
        ("CMAKE_BUILD_TYPE MATCHES \"^[a-z]$\"", ["? yes", "? no"]),
        ("a MATCHES \"^[a-z]$\"", ["yes"]),
        ("\"a\" MATCHES \"^[a-z]$\"", ["yes"]),
        ("EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/package.xml", ["yes"]),
        ("EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/nothing", ["no"]),
        ("IS_DIRECTORY /usr", ["? yes", "? no"]),
        ("TARGET lib", ["yes"]),
        ("TARGET only_perhaps", ["? yes", "? no"]),
        ("TARGET tests", ["? yes", "? no"]),
        ("BUILD_TESTING AND TARGET tests", ["T yes", "? no"]),
        ("POLICY CMP0057", ["yes"]),
        ("POLICY CMP0167", ["? yes", "? no"]),
        ("found_FOUND", ["yes"]),
        ("perhaps_FOUND", ["? yes", "? no"]),
        ("b IN_LIST letters", ["yes"]),
        ("DEFINED letters AND NOT (FALSE OR letters STREQUAL \"a;c\")", ["yes"]),
        ("BUILD_TESTING", ["T yes", "? no"]),
        ("NOT BUILD_TESTING", ["? yes", "T no"]),
        ("BUILD_TESTING AND unheard_of", ["T ? yes", "? no"]),
        ("A AND AND B", ["? yes", "? no"]),
    ],
)  # fmt: skip
def test_conditions(condition: str, branches: list[str]) -> None:
    before = "add_library(lib x.cpp)\nfind_package(found REQUIRED)\nfind_package(perhaps)\nset(letters a b)\n"
    before += "if(unheard_of)\nadd_library(only_perhaps x.cpp)\nendif()\nif(BUILD_TESTING)\nament_add_gtest(tests a.cpp)\nendif()\n"
    assert echo(f"{before}if({condition})\necho(yes)\nelse()\necho(no)\nendif()") == branches


@pytest.mark.parametrize(
    "condition, said",
    [
        ("NOT DEFINED a", ["x"]),
        ("NOT a", ["x"]),
        ("NOT DEFINED a AND DEFINED ENV{ROS_VERSION}", ["x"]),
        ("NOT DEFINED a AND unheard", ["x?"]),
        ("NOT DEFINED b", ["x?"]),
    ],
)
def test_what_is_asked_for_has_a_value(condition: str, said: list[str]) -> None:
    """Where `if(NOT DEFINED a)` sets it, it has a value behind the block, whatever was before."""
    before = "if(unheard)\nset(a x)\nendif()\n"
    assert echo(f"{before}if({condition})\nset(a x)\nendif()\necho(${{a}})") == said


def test_branches_are_united() -> None:
    text = "set(a x)\nset(b x)\nif(unheard)\nlist(APPEND a y)\nset(b y)\nelse()\nset(c z)\nendif()\necho(${a} | ${b} | ${c})"
    assert echo(text) == ["x y? | ∅ | z?"]


def test_what_follows_a_return() -> None:
    assert echo("if(NOT BUILD_TESTING)\nreturn()\nendif()\necho(a)") == ["T a"]
    assert echo("if(unheard)\nreturn()\nendif()\necho(a)") == ["? a"]
    assert echo("if(unheard)\nmessage(FATAL_ERROR no)\nendif()\necho(a)") == ["a"]
    assert echo("if(BUILD_TESTING)\nif(NOT BUILD_TESTING)\necho(never)\nendif()\necho(a)\nendif()") == ["T a"]


def test_included_and_added_files() -> None:
    found = read_files(
        {
            "CMakeLists.txt": HEAD + "set(a 1)\ninclude(cmake/x.cmake)\nadd_subdirectory(sub)\necho(${a} ${b} ${CMAKE_CURRENT_SOURCE_DIR})",
            "cmake/x.cmake": "set(b 2)\necho(${CMAKE_CURRENT_LIST_DIR} ${CMAKE_CURRENT_SOURCE_DIR})",
            "sub/CMakeLists.txt": "set(a 3)\necho(${a} ${b} ${CMAKE_CURRENT_SOURCE_DIR})",
        }
    )  # fmt: skip
    assert shown(found.named("echo")) == ["/~source/cmake /~source", "3 2 /~source/sub", "1 2 /~source"]
    assert [file.path for file in found.files] == ["CMakeLists.txt", "cmake/x.cmake", "sub/CMakeLists.txt"]


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ("list(APPEND CMAKE_MODULE_PATH ${PROJECT_SOURCE_DIR}/cmake)\ninclude(Own)", "1"),
        ("set(CMAKE_MODULE_PATH /usr/share/cmake ${PROJECT_SOURCE_DIR}/cmake)\ninclude(Own)", "1"),
        ("list(APPEND CMAKE_MODULE_PATH ${PROJECT_SOURCE_DIR}/cmake)\ninclude(CTest)", "0"),
        ("list(APPEND CMAKE_MODULE_PATH ${elsewhere_DIR})\ninclude(Own)", "0"),
        ("list(APPEND CMAKE_MODULE_PATH ${PROJECT_SOURCE_DIR}/../../cmake)\ninclude(CTest)", "0"),
        ("include(Own)", "0"),
    ],
)
def test_own_modules_are_found_through_their_path(lines: str, expected: str) -> None:
    found = read_files({"CMakeLists.txt": f"{HEAD}set(b 0)\n{lines}\necho(${{b}})", "cmake/Own.cmake": "set(b 1)"})
    assert shown(found.named("echo")) == [expected]
    assert found.reads_unknown_files is (expected == "0" and "Own" in lines)


def test_modules_of_a_folder_above_the_package_are_not_read() -> None:
    for folder, name, is_unknown in (
        ("${PROJECT_SOURCE_DIR}/../../cmake", "Shared", True),
        ("../cmake", "Shared", True),
        ("${PROJECT_SOURCE_DIR}/../../cmake", "CheckIPOSupported", False),
        ("${PROJECT_SOURCE_DIR}/cmake", "Shared", False),
        ("${elsewhere_DIR}", "Shared", False),
    ):
        lines = f"list(APPEND CMAKE_MODULE_PATH {folder})\ninclude({name})"
        assert read_files({"CMakeLists.txt": HEAD + lines}).reads_unknown_files is is_unknown


def test_a_package_below_is_read_where_it_is_added() -> None:
    found = read_files({
        "CMakeLists.txt": HEAD + "add_subdirectory(lib)\nfile(GLOB g lib/*.cpp)\necho(${g})",
        "lib/package.xml": manifest(name="lib"),
        "lib/CMakeLists.txt": "project(lib)\nadd_library(l a.cpp)\n",
        "lib/a.cpp": "",
    })  # fmt: skip
    assert [target.name for target in found.targets] == ["l"]
    assert shown(found.named("echo")) == ["/~source/lib/a.cpp"]
    assert not found.reads_unknown_files


def test_globs() -> None:
    files = {"src__a_DOT_cpp": "", "src__b_DOT_hpp": "", "src__sub__c_DOT_cpp": "", "msg__A_DOT_msg": ""}
    assert echo("file(GLOB s src/*.cpp)\necho(${s})", **files) == ["/~source/src/a.cpp"]
    assert echo("file(GLOB_RECURSE s RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} src/*.cpp)\necho(${s})", **files) == [
        "src/a.cpp src/sub/c.cpp"
    ]
    assert echo("file(GLOB s src/*)\necho(${s})", **files) == ["/~source/src/a.cpp /~source/src/b.hpp /~source/src/sub"]
    assert echo("file(GLOB s ${unheard}/*)\necho(${s})", **files) == ["∅"]


def test_words_know_where_they_were_written() -> None:
    text = HEAD + "set(sources a.cpp b.cpp)\nforeach(x IN LISTS sources)\necho(${x})\nendforeach()\n"
    words = [call.words[0] for call in read(text).named("echo")]
    assert [text[word.span.start : word.span.end] for word in words] == ["a.cpp", "b.cpp"]


@pytest.mark.parametrize(
    "text",
    [
        "while(TRUE)\necho()\nendwhile()",
        "function(f)\nf()\nendfunction()\nf()",
        "foreach(a RANGE 400)\nforeach(b RANGE 400)\necho()\nendforeach()\nendforeach()",
        "set(a x)\nforeach(i RANGE 60)\nset(a \"${a}${a}\")\nendforeach()\necho(${a})",
        "set(a x)\nforeach(i RANGE 60)\nlist(APPEND a ${a})\nendforeach()",
        "include(CMakeLists.txt)",
    ],
)  # fmt: skip
def test_runs_are_bounded(text: str) -> None:
    found = read(HEAD + text)
    assert len(found.calls) <= 20_000
    assert found.is_complete == ("set(a x)" in text)


WORDS = st.sampled_from(
    "a ${a} ${b}x \"${a};c\" APPEND REGEX IN LISTS AND NOT ( ) ${ARGN} PARENT_SCOPE 1 -1 .* TRUE GLOB RENAME DESTINATION "
    "TARGETS FILES DIRECTORY PATTERN lib src/*.cpp PLUGIN EXECUTABLE $<0:a> ${CMAKE_CURRENT_SOURCE_DIR}/x".split()
)  # fmt: skip
NAMES = st.sampled_from(
    "set list string file foreach() if() function() macro() while() math install add_library add_executable include "
    "find_package cmake_parse_arguments get_filename_component return rosidl_generate_interfaces unset separate_arguments "
    "rclcpp_components_register_node ament_python_install_package a project add_subdirectory".split()
)  # fmt: skip


@given(st.lists(st.tuples(NAMES, st.lists(WORDS, max_size=6)), max_size=12))
def test_anything_can_be_evaluated(lines: list[tuple[str, list[str]]]) -> None:
    text, closing = "", []
    for name, words in lines:
        text += f"{name.removesuffix('()')}({' '.join(w for w in words if w not in '()')})\n"
        if name.endswith("()"):
            closing.append(f"end{name}\n")
    found = read(HEAD + text + "".join(reversed(closing)), src__a_DOT_cpp="")
    assert found.installs is not None
    assert found.targets is not None
    assert found.components is not None


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("${A${U}}", UNKNOWN),
        ("${A${U}}}", UNKNOWN + "}"),
        ("${A${U}}}}x${B}", UNKNOWN + "}}xb"),
        ("${${U}}/${B}", UNKNOWN + "/b"),
    ],
)
def test_references_with_an_unknown_name(text: str, value: str) -> None:
    assert substitute(text, lambda _, name: UNKNOWN if name == "U" else name.lower()) == value
