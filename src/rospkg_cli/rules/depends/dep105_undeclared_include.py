"""DEP105 undeclared-include."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.undeclared_includes import IncludeDependencies
from ...edits.manifest import add_dependency
from ...example import CMAKE, Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...rule import rule

NODE = CMAKE.replace(
    "ament_package()",
    "add_executable(node src/node.cpp)\ninstall(TARGETS node DESTINATION lib/${PROJECT_NAME})\nament_package()",
)


@rule(
    "DEP105",
    "undeclared-include",
    over=IncludeDependencies,
    severity=Severity.WARNING,
    levels={Severity.INFO: "where a declared dependency is known to bring it, or package.xml has it in a comment"},
    examples=(
        Example(
            on="ament_cmake",
            bad={"CMakeLists.txt": NODE, "src/node.cpp": "#include <«std_msgs/msg/string.hpp»>\n"},
            good={"package.xml": manifest("  <depend>std_msgs</depend>\n", "ament_cmake")},
            fix=Safety.SAFE,
        ),
    ),
)
def undeclared_include(includes: IncludeDependencies) -> Iterator[Hit]:
    """
    ## What it does
    Finds C++ includes of other packages and libraries that package.xml does not declare.
    ROS packages are checked, and libraries that have a rosdep key. Files that no target compiles, and includes under
    `#if`, are left alone.

    ## Why is this bad?
    The header is found only as long as another dependency brings it. The day that one changes, or on a machine where
    it is not installed, the build ends with "No such file or directory"; in a workspace colcon may build it too early.

    ## References
    - REP-149, depend
    """
    for each in includes.undeclared():
        first, *others = each.uses
        name = each.names[0]
        kind = "test_depend" if each.role == "test" else "depend"
        tag = f"<{kind}>{name}</{kind}>"
        transitive = includes.is_transitive(each)
        ends = "it is there only as long as another dependency brings it"
        if not transitive:
            ends = 'the build ends with "No such file or directory" where nothing else brings it'
        message = f"package.xml does not declare `{name}`, whose `{first.header}` is included here: {ends}; add {tag}"
        fix = Fix(f"add {tag}", (add_dependency(includes.declared.manifest, kind, name),))
        related = tuple(Related(use.path, use.span, "and here") for use in others[:3])
        mild = transitive or name in includes.declared.commented_out
        yield Hit(first.path, first.span, message, Severity.INFO if mild else None, related, fix)
