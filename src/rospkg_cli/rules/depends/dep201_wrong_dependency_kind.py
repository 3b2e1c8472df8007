"""DEP201 wrong-dependency-kind."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.dependency_kinds import DependencyKinds, WrongKind
from ...edits.manifest import add_dependency, change_tag
from ...example import Example, manifest
from ...finding import Edit, Fix, Hit, Related, Safety, Severity
from ...rule import rule

BAD = manifest("  <build_depend>rclpy</build_depend>\n")
GOOD = manifest("  <build_depend>rclpy</build_depend>\n  <exec_depend>rclpy</exec_depend>\n")


@rule(
    "DEP201",
    "wrong-dependency-kind",
    over=DependencyKinds,
    severity=Severity.WARNING,
    examples=(
        Example(
            bad={"package.xml": BAD, "my_pkg/node.py": "import «rclpy»\n"},
            good={"package.xml": GOOD},
            fix=Safety.UNSAFE,
        ),
    ),
)
def wrong_dependency_kind(kinds: DependencyKinds) -> Iterator[Hit]:
    """
    ## What it does
    Finds dependencies that are declared, but not for the time when they are used.
    A package that is used at run time (imported by what is installed, needed by launch files) is declared for building
    or testing alone; or a package whose headers are included is declared for running or testing alone.

    ## Why is this bad?
    A dependency for tests is not installed with a released package, one for running is not there when it is built.

    ## Fix safety
    The missing tag is added, or `exec_depend` becomes `depend`; another split of tags may be right.

    ## References
    - REP-149, Dependencies
    """
    for each in kinds.wrong_kinds():
        name, tag = each.dependency.name, each.dependency.tag
        when = "runs" if each.wanted == "exec_depend" else "is built"
        message = (
            f"`{name}` {each.usage}, and package.xml has it only as <{tag}>: it may not be there when the package "
            f"{when}; declare it as <{each.wanted}>"
        )
        related = (Related(kinds.declared.manifest.path, each.dependency.span, "declared here"),)
        fix = Fix(f"declare `{name}` as <{each.wanted}>", (repair(kinds, each),), Safety.UNSAFE)
        yield Hit(each.path, each.span, message, related=related, fix=fix)


def repair(kinds: DependencyKinds, each: WrongKind) -> Edit:
    manifest, name = kinds.declared.manifest, each.dependency.name
    for other in manifest.dependencies:
        if other.name == name and other.tag == "exec_depend" and each.wanted == "depend":
            return change_tag(manifest, other, "depend")
    return add_dependency(manifest, each.wanted, name)
