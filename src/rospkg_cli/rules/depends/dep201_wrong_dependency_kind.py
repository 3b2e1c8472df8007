"""DEP201 wrong-dependency-kind."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from ...checks.depends.dependency_kind_sentences import ending, usage
from ...checks.depends.dependency_kinds import DependencyKinds, WrongKind
from ...checks.enumeration import in_ticks
from ...checks.launch.example_files import is_example
from ...edits.brought_hits import comes_with
from ...edits.manifest import add_dependencies, change_tag
from ...example import Example, manifest
from ...finding import Edit, Fix, Hit, Related, Safety, Severity
from ...rule import rule

BAD = manifest("  <build_depend>rclpy</build_depend>\n")
CHANGES = """\
Changelog for package my_pkg
============================

1.0.0 (2026-01-02)
------------------
* Drive.
"""
GOOD = manifest("  <build_depend>rclpy</build_depend>\n  <exec_depend>rclpy</exec_depend>\n")


@rule(
    "DEP201",
    "wrong-dependency-kind",
    over=DependencyKinds,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "where nothing shows that the package is released, where another dependency, or `ros2 launch`, "
        "brings or may bring it, for examples, and for what an option of CMake asks for; and for libraries, which "
        "Debian packages bring by themselves"
    },
    examples=(
        Example(
            bad={"CHANGELOG.rst": CHANGES, "package.xml": BAD, "my_pkg/node.py": "import «rclpy»\n"},
            good={"package.xml": GOOD},
            fix=Safety.UNSAFE,
        ),
    ),
)
def wrong_dependency_kind(kinds: DependencyKinds) -> Iterator[Hit]:
    """
    ## What it does
    Finds dependencies that are declared, but not for the time when they are used.
    A package that is used at run time (imported by what is installed, needed by launch files or by interfaces that are
    generated, or a library that an installed program is linked with) is declared for building or testing alone; or a
    package whose headers are included, or that CMake requires, is declared for running or testing alone.
    A metapackage stands for its members where the build uses one of them and nothing else declares it.

    ## Why is this bad?
    A released package is installed without its test_depends and build_depends; what is declared for running or testing
    alone need not be there when the package is built.

    ## When it is quiet
    `rosdep install` installs the dependencies of all tags, and colcon builds them all first: a build from source lacks
    nothing. It is a warning where the repository is visibly released (bloom's files, a job for it, or a CHANGELOG.rst
    whose title names the package among packages that all have one), or where a page, a script or a workflow of it runs
    `rosdep install --dependency-types …`; an info elsewhere. What another dependency brings at that time or may bring,
    or `ros2 launch` itself to a launch file, is an info, and so is what only a launch file needs that is called an
    example or a demo, and what only files include that an option of CMake must ask for. What others bring is one
    finding. A `<build_export_depend>` is right for headers that are installed for others and not compiled here. A
    library that comes with another dependency for running, or a part of which is one (`libmodbus5` next to
    `libmodbus-dev`), is there. Optional imports and files that nothing installs are left alone, and so is whatever is
    not declared at all (DEP101, DEP103, DEP105).

    ## Fix safety
    The missing tag is added, or `exec_depend` becomes `depend`; another split of tags may be right.

    ## References
    - REP-149, Dependencies
    """
    brought: list[WrongKind] = []
    loaded: list[WrongKind] = []
    for each in kinds.wrong_kinds():
        if each.bringer or each.use.need == "link":
            (brought if each.bringer else loaded).append(each)
            continue
        is_for_example = each.use.need == "launch" and is_example(each.use.path)
        is_mild = is_for_example or each.use.is_optional or not kinds.apart.are_apart
        yield hit(kinds, each, Severity.INFO if is_mild else None)
    for group in (brought, loaded):
        if group:
            yield hit(kinds, group[0], Severity.INFO) if len(group) == 1 else in_one(kinds, group)


def hit(kinds: DependencyKinds, each: WrongKind, level: Severity | None) -> Hit:
    name, tag, wanted = each.dependency.name, each.dependency.tag, each.use.wanted
    message = f"`{name}` is only a <{tag}>, and {usage(each)}: {consequence(each)}; declare it as <{wanted}>"
    related = (Related(kinds.declared.manifest.path, each.dependency.span, "declared here"),)
    fix = Fix(f"declare `{name}` as <{wanted}>", repairs(kinds, [each]), Safety.UNSAFE)
    return Hit(each.use.path, each.use.span, message, level, related, fix)


def in_one(kinds: DependencyKinds, wrong: Sequence[WrongKind]) -> Hit:
    """Return one info for several that others bring, or may bring, when they are used, or that nothing brings."""
    first, *others = wrong
    names = in_ticks([each.dependency.name for each in wrong])
    come = "come" if all(each.bringer and each.bringer.is_certain for each in wrong) else "may come"
    so = f"they {come} with other dependencies" if first.bringer else ending(first)
    message = f"{names} are not declared for the time when they are used: {so}; declare those uses"
    path = kinds.declared.manifest.path
    related = [Related(path, first.dependency.span, f"only a <{first.dependency.tag}>, and {usage(first)}")]
    for each in others:
        what = f"`{each.dependency.name}` is only a <{each.dependency.tag}>, and {usage(each)}"
        related.append(Related(each.use.path, each.use.span, what))
    fix = Fix(f"declare the uses of {names}", repairs(kinds, wrong), Safety.UNSAFE)
    return Hit(first.use.path, first.use.span, message, Severity.INFO, tuple(related), fix)


def consequence(each: WrongKind) -> str:
    return comes_with(each.bringer) if each.bringer else ending(each)


def repairs(kinds: DependencyKinds, wrong: Iterable[WrongKind]) -> tuple[Edit, ...]:
    manifest = kinds.declared.manifest
    changed: list[Edit] = []
    added: list[tuple[str, str]] = []
    for each in wrong:
        name, wanted = each.dependency.name, each.use.wanted
        as_run = (d for d in manifest.dependencies if d.name == name and d.tag == "exec_depend" and wanted == "depend")
        if (other := next(as_run, None)) is not None:
            changed.append(change_tag(manifest, other, "depend"))
        else:
            added.append((wanted, name))
    return (*changed, *add_dependencies(manifest, added))
