"""DEP202 unused-dependency."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.unused_dependencies import UnusedDependencies
from ...edits.manifest import change_tag, remove_element
from ...example import CMAKE, Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...rule import Profile, rule

USED = "  <exec_depend>rclpy</exec_depend>\n  <exec_depend>std_msgs</exec_depend>\n"
CMAKE_NODE = CMAKE.replace(
    "ament_package()",
    "add_executable(node src/node.cpp)\ninstall(TARGETS node DESTINATION lib/${PROJECT_NAME})\nament_package()",
)
NODE = "import rclpy\nfrom std_msgs.msg import String\n"


@rule(
    "DEP202",
    "unused-dependency",
    over=UnusedDependencies,
    severity=Severity.INFO,
    profile=Profile.PEDANTIC,
    examples=(
        Example(
            on="ament_cmake",
            bad={
                "package.xml": manifest("  <depend>«geometry_msgs»</depend>\n", "ament_cmake"),
                "CMakeLists.txt": CMAKE_NODE,
                "src/node.cpp": "int main() {return 0;}\n",
            },
            good={"package.xml": manifest("", "ament_cmake")},
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={
                "package.xml": manifest("  <exec_depend>«geometry_msgs»</exec_depend>\n" + USED),
                "my_pkg/talker.py": NODE,
            },
            good={"package.xml": manifest(USED)},
            fix=Safety.UNSAFE,
        ),
    ),
)
def unused_dependency(unused: UnusedDependencies) -> Iterator[Hit]:
    """
    ## What it does
    Finds dependencies that nothing in the package uses.
    No import, launch file, parameter file or robot names them. In a Python package `<depend>`, `<build_depend>`, and
    `<exec_depend>` of interfaces and Python libraries are checked; in a CMake package `<depend>` and `<build_depend>`
    on ROS packages, all tags on interfaces, on ros2_control's controllers and on commands of ros2cli, and tools for
    launch tests. Any other `<exec_depend>` may be a node that is started by name, or a plugin, and is left alone. Where
    nothing that is built uses a package, and a launch file, a document or nothing at all in a package that builds
    nothing does, `<exec_depend>` is enough.

    ## Why is this bad?
    All users of the package install it too, and `colcon build` waits for it.

    ## When it is quiet
    Whatever names the package anywhere, in code, launch files, parameters, robots or documents, counts as a use, and so
    does a controller that parameters of another package name. Packages without code gather dependencies on purpose, for
    which `<exec_depend>` will do; a command that reads package.xml (`ament_auto_find_build_dependencies()`) counts as a
    use for the build. Where a part can't be read nothing is said.

    ## Fix safety
    Something outside of the package may rely on the dependency being installed.
    """
    manifest = unused.declared.manifest
    for each in unused.dependencies():
        name, tag = each.dependency.name, each.dependency.tag
        if each.is_run_only:
            message = (
                f"`{name}` is declared as <{tag}>, and nothing that is built uses it: every build of the package waits "
                f"for it; write <exec_depend>{name}</exec_depend>"
            )
            edit, title = change_tag(manifest, each.dependency, "exec_depend"), f"declare `{name}` as <exec_depend>"
        else:
            message = (
                f"`{name}` is declared, and nothing in the package {verb(tag)} it: all users install it all the same; "
                "remove the line"
            )
            edit, title = remove_element(manifest, each.dependency.element), f"remove <{tag}>{name}</{tag}>"
        yield Hit(manifest.path, each.dependency.span, message, fix=Fix(title, (edit,), Safety.UNSAFE))


def verb(tag: str) -> str:
    return "tests with" if tag == "test_depend" else "imports, includes or names"
