"""Paths that CMake names, that are not there, and that a build makes."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, INTERFACES_CMAKE, Example, manifest
from rospkg_cli.finding import Severity
from rospkg_cli.testing import lint_files

MODELS = "install(DIRECTORY models DESTINATION share/${PROJECT_NAME})\n"
FILE = "install(FILES models/net.onnx DESTINATION share/${PROJECT_NAME})\n"
TALKER = "add_executable(talker src/talker.cpp)\ninstall(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"
OTHER = "add_executable(other src/other.cpp)\ninstall(TARGETS other DESTINATION lib/${PROJECT_NAME})\n"
HERE = "${CMAKE_CURRENT_SOURCE_DIR}"


def levels(lines: str, **files: str) -> list[Severity]:
    text = CMAKE.replace("ament_package", f"{lines}ament_package")
    others = {path.replace("__", "/"): content for path, content in files.items()}
    tree = {"package.xml": manifest(build_type="ament_cmake"), "CMakeLists.txt": text, **others}
    return [finding.severity for finding in lint_files(tree, ["CMK102"]).findings]


MAKERS = [
    f"file(DOWNLOAD https://example.org/net.onnx {HERE}/models/net.onnx)",
    f"file(MAKE_DIRECTORY {HERE}/models)",
    f"file(COPY other/net.onnx DESTINATION {HERE}/models)",
    f"file(ARCHIVE_EXTRACT INPUT a.zip DESTINATION {HERE}/models)",
    f"add_custom_target(net ALL COMMAND make WORKING_DIRECTORY {HERE}/models)",
    f"add_custom_target(net ALL COMMAND make -C {HERE}/models)",
    f"add_custom_command(OUTPUT {HERE}/models/net.onnx COMMAND fetch)",
    f"execute_process(COMMAND fetch {HERE}/models)",
    f"execute_process(COMMAND /bin/git pull COMMAND fetch WORKING_DIRECTORY {HERE}/models)",
    f"ExternalProject_Add(net URL https://example.org SOURCE_DIR {HERE}/models)",
    f"FetchContent_Declare(net URL https://example.org SOURCE_DIR {HERE}/models)",
]


@pytest.mark.parametrize("maker", MAKERS)
@pytest.mark.parametrize("install", [MODELS, FILE])
def test_what_a_command_makes_need_not_be_there(maker: str, install: str) -> None:
    assert levels(install) == [Severity.ERROR]
    assert levels(f"{maker}\n{install}") == []


@pytest.mark.parametrize(
    "command",
    [
        f"execute_process(COMMAND git describe WORKING_DIRECTORY {HERE}/models)",
        f"file(WRITE {HERE}/models-2/other.onnx text)",
        f"add_custom_target(net ALL COMMAND make -C {HERE}/models-2)",
        f"file(READ {HERE}/models/net.onnx text)",
        "find_package(models)",
    ],
)
def test_what_makes_something_else_does_not_count(command: str) -> None:
    assert levels(f"{command}\n{FILE}") == [Severity.ERROR]


def test_a_program_in_the_folder_of_the_package_may_make_what_is_installed() -> None:
    run = f"execute_process(COMMAND fetch WORKING_DIRECTORY {HERE})\n"
    assert levels(run + MODELS) == [Severity.WARNING]
    assert levels(run + TALKER) == [Severity.ERROR]
    assert levels(run.replace("fetch", "git") + MODELS) == [Severity.ERROR]
    file = f"execute_process(COMMAND {HERE}/fetch)\n"
    assert levels(file + MODELS, fetch="#!/bin/sh\n") == [Severity.ERROR]


def test_what_git_ignores_and_empty_submodules_are_expected() -> None:
    assert levels(FILE, **{".gitignore": "*.onnx\n"}) == []
    assert levels(FILE, **{"models__.gitignore": "*.onnx\n"}) == []
    assert levels(FILE, **{".gitignore": "*.pt\n"}) == [Severity.ERROR]
    assert levels(FILE, **{".gitmodules": "\tpath = models\n"}) == []
    assert levels(FILE, **{".gitmodules": "\tpath = models\n", "models__a.onnx": ""}) == [Severity.ERROR]
    maybe = f"if(EXISTS {HERE}/models)\n{FILE}endif()\n"
    assert levels(maybe, **{".gitmodules": "\tpath = models\n"}) == []


@pytest.mark.parametrize(
    ("condition", "expected"),
    [
        ("WIN32", [Severity.INFO]),
        ("SOMETHING", [Severity.WARNING]),
        (f"EXISTS {HERE}/src/other.cpp", []),
        ("$ENV{ROS_VERSION} EQUAL 1", []),
        ("CATKIN_ENABLE_TESTING", []),
    ],
)
def test_a_source_that_is_asked_for_first_may_be_absent(condition: str, expected: list[Severity]) -> None:
    assert levels(f"if({condition})\n  {OTHER}endif()\n") == expected


def test_interfaces_that_a_build_makes_need_not_be_there() -> None:
    listed = INTERFACES_CMAKE.replace('"msg/Status.msg"', '"msg/Status.msg"\n  "msg/Zone.msg"')
    files = Example(bad={"CMakeLists.txt": listed}, good={}, on="interfaces").bad_files()

    def missing(**more: str) -> int:
        others = {path.replace("__", "/"): text for path, text in more.items()}
        return len(lint_files({**files, **others}, ["IDL006"]).findings)

    assert missing() == 1
    assert missing(**{"msg__.gitignore": "Zone.msg\n"}) == 0
    made = listed.replace("rosidl_gen", f"execute_process(COMMAND make -C {HERE}/msg)\nrosidl_gen")
    assert missing(**{"CMakeLists.txt": made}) == 0


def test_a_source_that_is_marked_as_generated_need_not_be_there() -> None:
    marked = "set_source_files_properties(src/other.cpp PROPERTIES {} TRUE)\n"
    assert levels(marked.format("GENERATED") + OTHER) == []
    assert levels(marked.format("HEADER_FILE_ONLY") + OTHER) == [Severity.ERROR]


def test_a_file_of_that_name_may_be_written_anywhere() -> None:
    assert levels("file(WRITE ${SOMEWHERE}/net.onnx text)\n" + FILE) == []
    assert levels("configure_file(net.in models/net.onnx)\n" + FILE) == []
    assert levels("configure_file(net.onnx models/other)\n" + FILE) == [Severity.ERROR]


def test_a_destination_below_the_prefix_is_another_folder() -> None:
    assert levels("install(FILES CMakeLists.txt DESTINATION models)\n" + MODELS) == [Severity.ERROR]
