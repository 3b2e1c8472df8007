"""DEP114 undeclared-build-tool."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.build_tools_of_cmake import ENVIRONMENT, BuildTool, BuildToolsOfCMake
from ...edits.undeclared_dependency import declaration
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Safety, Severity
from ...rule import rule

CLONES = """\
include(ExternalProject)
«ExternalProject_Add»(parts GIT_REPOSITORY https://example.com/parts.git GIT_TAG 1.0.0)
"""
ASKS = "find_package(PkgConfig)\n«pkg_check_modules»(PARTS REQUIRED parts)\n"
READS = 'if(«"$ENV{ROS_DISTRO}"» STREQUAL "humble")\n  add_definitions(-DIS_HUMBLE)\nendif()\n'


def example(lines: str, dependency: str) -> Example:
    return Example(
        on="ament_cmake",
        bad={"CMakeLists.txt": CMAKE.replace("ament_package()", f"{lines}ament_package()")},
        good={"package.xml": manifest(f"  {dependency}\n", "ament_cmake")},
        fix=Safety.SAFE,
    )


@rule(
    "DEP114",
    "undeclared-build-tool",
    over=BuildToolsOfCMake,
    severity=Severity.INFO,
    examples=(
        example(CLONES, "<buildtool_depend>git</buildtool_depend>"),
        example(ASKS, "<buildtool_depend>pkg-config</buildtool_depend>"),
        example(READS, "<build_depend>ros_environment</build_depend>"),
    ),
)
def undeclared_build_tool(tools: BuildToolsOfCMake) -> Iterator[Hit]:
    """
    ## What it does
    Finds build tools such as git, pkg-config and cmake that a build uses and package.xml lacks.
    A package of the build type `cmake` needs cmake, which nothing of ROS brings to it.
    `ExternalProject_Add()` and `FetchContent_Declare()` clone with git (`GIT_REPOSITORY`), `pkg_check_modules(…
    REQUIRED …)` runs pkg-config, `add_custom_command()` and `add_custom_target()` run what fetches or unpacks (`curl`,
    `git`, `unzip`, `wget`), `find_program(… REQUIRED)` looks for it, and `$ENV{ROS_DISTRO}` is set by the package
    ros_environment.

    ## Why is this bad?
    Most machines of developers have them. The build farm, and a container made by `rosdep install`, have what
    package.xml names: there CMake stops, or a condition on `$ENV{ROS_DISTRO}` is false without a word.

    ## When it is quiet
    What a declared dependency brings on all distributions is there, and a variable that is asked for first
    (`if(DEFINED ENV{ROS_DISTRO})`) may be absent. pkg-config counts only with REQUIRED, and a program of
    `execute_process()` with COMMAND_ERROR_IS_FATAL.

    ## References
    - REP-149, buildtool_depend
    """
    for tool in tools.missing():
        message = f"{sentence(tool)}; add <{tool.tag}>{tool.name}</{tool.tag}>"
        fix = declaration(tools.declared, tool.tag, tool.name)
        yield Hit(tool.path, tool.span, message, fix=fix)


def sentence(tool: BuildTool) -> str:
    if tool.name == ENVIRONMENT:
        return f"`{tool.name}`, which sets `{tool.what}`, is not declared: on the build farm the variable is empty here"
    if tool.bringer:
        start = f"`{tool.what}` needs `{tool.name}`, which is not declared"
        return f"{start}: it comes with `{tool.bringer}` on some distributions alone"
    return f"`{tool.what}` needs `{tool.name}`, which is not declared: a machine without it stops the build here"
