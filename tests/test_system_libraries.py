"""Libraries of the system that package.xml lacks: what is linked, looked for and included (DEP105, DEP115)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.ros.libraries import TABLE, stem
from rospkg_cli.ros.names import BUILT_IN
from rospkg_cli.ros.read_table import rows, sections
from rospkg_cli.testing import lint_files

NODE = "add_executable(node src/node.cpp)\n"


def told(lines: str, depends: str = "", source: str = "", **files: str) -> list[tuple[str, str, str]]:
    """Return code, level and the end of the message of what is told of a package with one program."""
    written = {
        "CMakeLists.txt": CMAKE.replace("ament_package()", f"{NODE}{lines}\nament_package()"),
        "package.xml": manifest(depends, "ament_cmake"),
        "src/node.cpp": f"{source}int main() {{return 0;}}\n",
    }
    found = lint_files({**written, **files}, ["DEP105", "DEP115"]).findings
    return [(each.code, each.severity.value, each.message.rpartition("; ")[2]) for each in found]


@pytest.mark.parametrize(
    "lines, tag, key",
    [
        ("target_link_libraries(node -liio)", "depend", "libiio-dev"),
        ("find_library(MQTT NAMES paho-mqttpp3)\ntarget_link_libraries(node ${MQTT})", "depend", "libpaho-mqttpp-dev"),
        ("pkg_check_modules(GPS libgps)\ntarget_link_libraries(node PkgConfig::GPS)", "depend", "libgps"),
        ("pkg_search_module(USB REQUIRED libusb-1.0 libusb)", "depend", "libusb-1.0-dev"),
        ("if(BUILD_TESTING)\n  target_link_libraries(node iio)\nendif()", "test_depend", "libiio-dev"),
        ("target_link_libraries(node iio)\ntarget_link_libraries(node iio)", "depend", "libiio-dev"),
    ],
)
def test_a_library_that_is_linked_is_to_be_declared(lines: str, tag: str, key: str) -> None:
    assert told(lines) == [("DEP115", "warning", f"add <{tag}>{key}</{tag}>")]


@pytest.mark.parametrize(
    "lines, depends",
    [
        ("add_library(iio SHARED src/node.cpp)\ntarget_link_libraries(node iio)", ""),
        ("link_directories(/opt/x/lib)\ntarget_link_libraries(node iio)", ""),
        ("find_library(IIO iio)", ""),
        ("find_library(IIO iio REQUIRED HINTS /opt/x)", ""),
        ("pkg_check_modules(IIO libiio)", ""),
        ("pkg_check_modules(IIO libiio)\nif(IIO_FOUND)\n  target_link_libraries(node ${IIO_LIBRARIES})\nendif()", ""),
        ("if(WITH_IIO)\n  target_link_libraries(node iio)\n  find_library(IIO iio REQUIRED)\nendif()", ""),
        ("target_link_libraries(node m pthread nobodys)", ""),
        ("target_link_libraries(node iio)", "  <depend>libiio-dev</depend>\n"),
        ("target_link_libraries(node opencv_core)", "  <depend>libopencv-contrib-dev</depend>\n"),
        ("ExternalProject_Add(ext URL https://example.com/libiio.zip)\ntarget_link_libraries(node iio)", ""),
    ],
)
def test_what_is_there_or_optional_is_left_alone(lines: str, depends: str) -> None:
    assert told(lines, depends) == []


def test_libraries_that_lie_in_the_package() -> None:
    assert told("target_link_libraries(node iio)", lib__libiio_so="") != []
    assert told("target_link_libraries(node iio)", **{"lib/libiio.so": ""}) == []
    assert told("", source="#include <iio.h>\n", **{"third_party/iio.h": ""}) == []


def test_a_header_is_told_once_and_not_the_library_as_well() -> None:
    wanted = [("DEP105", "warning", "add <depend>libiio-dev</depend>")]
    assert told("target_link_libraries(node iio)", source="#include <iio.h>\n") == wanted
    assert told("", source="#include <tins/tins.h>\n") == [("DEP105", "warning", "add <depend>libtins-dev</depend>")]
    assert told("", "  <depend>cppzmq</depend>\n", source="#include <zmq.hpp>\n") == []
    assert told("", source='#include "GL/gl.h"\n#include "thing.h"\n') == []


def test_what_a_dependency_brings_is_an_info() -> None:
    assert told("target_link_libraries(node yaml-cpp)", "  <depend>rviz_common</depend>\n") == [
        ("DEP115", "info", "declare what you use")
    ]
    commented = "  <!-- <depend>libiio-dev</depend> -->\n"
    assert [level for _, level, _ in told("target_link_libraries(node iio)", commented)] == ["info"]


@pytest.mark.parametrize("name", ["avcodec", "avformat", "avutil"])
def test_a_library_that_shares_its_key_with_others(name: str) -> None:
    lines = f"target_link_libraries(node {name})"
    assert told(lines) == [("DEP115", "warning", "add <depend>ffmpeg</depend>")]
    assert told(lines, "  <depend>libopencv-dev</depend>\n") == [("DEP115", "info", "declare what you use")]
    assert told(lines, "  <depend>libavdevice-dev</depend>\n") == []
    asked = f"pkg_check_modules(AV REQUIRED IMPORTED_TARGET lib{name})"
    assert told(asked, "  <depend>cv_bridge</depend>\n") == [("DEP115", "info", "declare what you use")]


def test_what_an_option_adds_to_the_sources_is_an_info() -> None:
    lines = "set(MORE)\nif(WITH_IIO)\n  list(APPEND MORE src/more.cpp)\nendif()\nadd_library(more src/a.cpp ${MORE})"
    files = {"src/more.cpp": "#include <iio.h>\n", "src/a.cpp": ""}
    assert [level for _, level, _ in told(lines, **files)] == ["info"]


def test_each_key_of_the_table_is_known() -> None:
    """The recommended one has to be a key; the others are other names for it, or the package with the library."""
    installed = rows("debian_dependencies.txt")
    for section in ("headers", "linked", "modules"):
        for name, keys in sections(TABLE)[section].items():
            assert BUILT_IN.is_key(keys[0]), name
            assert all(BUILT_IN.is_key(key) or BUILT_IN.is_package(key) or key in installed for key in keys), name


def test_stems() -> None:
    names = ("libusb-1.0", "boost_regex", "zmq.hpp", "GL/glew.h", "tins/tins.h", "v4l2", "X11")
    assert [*map(stem, names)] == ["usb", "boost", "zmq", "glew", "tins", "v4l", "x11"]


GST, GLIB = "pkg_check_modules(GST REQUIRED gstreamer-1.0)", "pkg_check_modules(GLIB REQUIRED glib-2.0)"
ADD_GST, ADD_GLIB = (
    ("DEP115", "warning", "add <depend>libgstreamer1.0-dev</depend>"),
    "add <depend>libglib-dev</depend>",
)


@pytest.mark.parametrize("lines", [f"{GST}\n{GLIB}", f"{GLIB}\n{GST}"])
def test_what_another_module_brings_that_cmake_requires_is_an_info(lines: str) -> None:
    assert sorted(told(lines)) == [("DEP115", "info", "declare what you use"), ADD_GST]
    declared = "  <depend>libgstreamer1.0-dev</depend>\n"
    assert told(lines, declared) == [("DEP115", "info", "declare what you use")]


@pytest.mark.parametrize(
    "lines",
    [
        GLIB,
        f"{GLIB}\npkg_check_modules(USB REQUIRED libusb-1.0)",
        f"{GLIB}\npkg_check_modules(GST gstreamer-1.0)",
        f"{GLIB}\nif(BUILD_TESTING)\n  {GST}\nendif()",
    ],
)
def test_what_no_other_module_brings_for_certain_stays_a_warning(lines: str) -> None:
    assert ("DEP115", "warning", ADD_GLIB) in told(lines)


def test_of_two_that_would_do_for_each_other_one_is_asked_for() -> None:
    lines = f"{GST}\npkg_check_modules(APP REQUIRED gstreamer-app-1.0)"
    assert told(lines) == [ADD_GST]
    assert ("DEP105", "warning") in {each[:2] for each in told(lines, source="#include <gst/gst.h>\n")}


def test_a_header_comes_with_a_module_that_cmake_requires() -> None:
    header, ftdi = "#include <libusb-1.0/libusb.h>\n", "pkg_check_modules(FTDI REQUIRED libftdi1)"
    assert ("DEP105", "info", "declare what you use") in told(ftdi, source=header)
    assert ("DEP105", "warning", "add <depend>libusb-1.0-dev</depend>") in told("", source=header)
