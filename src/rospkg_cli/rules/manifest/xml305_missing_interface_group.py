"""XML305 missing-interface-group."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.manifest.interface_package import InterfacePackage
from ...edits.brought_hits import comes_with
from ...edits.manifest import add_dependency, add_element, rename_dependency
from ...edits.manifest_format import to_format_3
from ...example import Example, manifest
from ...finding import Fix, Hit, Operation, Safety, Severity
from ...package.dependency import Dependency
from ...ros.interfaces import GENERATORS, GROUP, RUNTIMES
from ...ros.manifest import BUILDS
from ...rule import rule

GOOD = manifest(
    "  <buildtool_depend>rosidl_default_generators</buildtool_depend>\n"
    "  <exec_depend>rosidl_default_runtime</exec_depend>\n"
    "  <member_of_group>rosidl_interface_packages</member_of_group>\n",
    build_type="ament_cmake",
)
MARKED = GOOD.replace("<name>my_pkg", "<name>«my_pkg»")
CMAKE = """\
cmake_minimum_required(VERSION 3.20)
project(my_pkg)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME} "msg/Battery.msg")
ament_export_dependencies(rosidl_default_runtime)
ament_package()
"""


def without(line: str) -> Example:
    files = {"CMakeLists.txt": CMAKE, "msg/Battery.msg": "float32 level\n"}
    bad = {"package.xml": MARKED.replace(line, ""), **files}
    return Example(on="ament_cmake", bad=bad, good={"package.xml": GOOD}, fix=Safety.SAFE)


@rule(
    "XML305",
    "missing-interface-group",
    over=InterfacePackage,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "the group is there: the package builds wherever ROS is installed with its generators",
        Severity.INFO: "the generators or the runtime come with a declared dependency, or the runtime with generators "
        "in its place",
    },
    examples=(
        without("  <member_of_group>rosidl_interface_packages</member_of_group>\n"),
        without("  <buildtool_depend>rosidl_default_generators</buildtool_depend>\n"),
        without("  <exec_depend>rosidl_default_runtime</exec_depend>\n"),
    ),
)
def missing_interface_group(package: InterfacePackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds interface packages whose package.xml lacks a group, a generator or a runtime.
    Their CMakeLists.txt calls `rosidl_generate_interfaces`. It needs the membership in the group
    `rosidl_interface_packages`, the generators to build with, and the runtime to run with.

    ## Why is this bad?
    Without the group, CMake stops: "Packages installing interfaces must include `<member_of_group>…` in their
    package.xml". Without the generators the build fails on a clean machine, without the runtime users of the package
    can't import its messages.

    ## When it is quiet
    Interfaces that are not installed (SKIP_INSTALL) or built for tests alone need neither the runtime nor the group,
    and SKIP_GROUP_MEMBERSHIP_CHECK needs no group. Where a declared dependency certainly brings the runtime, as
    std_msgs and generators that are declared to run do, it is an info. So are generators that certainly come with a
    dependency that is declared for building: another package of messages with
    `<depend>rosidl_default_generators</depend>`, for instance.

    ## References
    - [Interfaces, package.xml](https://docs.ros.org/en/rolling/Tutorials/Beginner-Client-Libraries/Custom-ROS2-Interfaces.html)
    """
    manifest = package.manifest
    upgrade: tuple[Operation, ...] = () if manifest.schema_format == 3 else to_format_3(manifest)
    line = f"<member_of_group>{GROUP}</member_of_group>"
    if package.checks_group and not package.is_member:
        message = f"interfaces are generated and the group is missing: CMake stops at the first of them; add `{line}`"
        edits = (*upgrade, add_element(manifest, "member_of_group", line, GROUP))
        yield Hit(manifest.path, manifest.name_span, message, fix=Fix("Add the group of interface packages", edits))
    for tag, names, harm in (
        ("buildtool_depend", GENERATORS, "on a clean machine `find_package` fails"),
        ("exec_depend", RUNTIMES, "users of the package can't use its messages"),
    ):
        if not package.installs or any(map(package.declares, names)):
            continue
        if names is RUNTIMES and (wrong := package.generators_to_run):
            yield generators_to_run(package, wrong)
            continue
        bringer = package.runtime_bringer if names is RUNTIMES else package.generators_bringer
        harm, level = (comes_with(bringer), Severity.INFO) if bringer else (harm, Severity.WARNING)
        message = f"interfaces are generated and `{names[0]}` is not declared: {harm}; add `<{tag}>{names[0]}</{tag}>`"
        fix = Fix(f"Add `{names[0]}`", (add_dependency(manifest, tag, names[0]),))
        yield Hit(manifest.path, manifest.name_span, message, level, fix=fix)


def generators_to_run(package: InterfacePackage, wrong: Dependency) -> Hit:
    """Ask for the runtime in the place of the generators, which are there to build."""
    manifest, name = package.manifest, RUNTIMES[0]
    others = [each for each in manifest.dependencies if each.name == wrong.name and each is not wrong]
    edit, todo = rename_dependency(manifest, wrong, name), f"write `{name}` in its place"
    if not any(each.tag in BUILDS for each in others):
        edit, todo = add_dependency(manifest, "exec_depend", name), f"add <exec_depend>{name}</exec_depend>"
    message = f"`{wrong.name}` is a <{wrong.tag}>: users install compilers and generators to have the runtime; {todo}"
    return Hit(manifest.path, wrong.span, message, Severity.INFO, fix=Fix(f"declare `{name}`", (edit,)))
