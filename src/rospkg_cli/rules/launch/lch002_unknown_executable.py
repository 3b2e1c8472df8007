"""LCH002 unknown-executable."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.launch.executable_use import ExecutableUse, WellKnownUse
from ...checks.launch.node_executables import NodeExecutables
from ...checks.launch.one_cause import CausedPlace
from ...checks.launch.renamed_executables import renamed_together
from ...checks.launch.unknown_executables import unknown_together
from ...checks.launch.without_package import NodesWithoutPackage
from ...edits.blank_names import blank_name
from ...edits.caused_places import level_of, other_places
from ...edits.unknown_executables import hint, not_offered, without_package
from ...example import SETUP_PY_FOR_ALL, Example, manifest
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...rule import rule

SETUP = SETUP_PY_FOR_ALL.replace(
    "    license=", "    entry_points={'console_scripts': ['talker = my_pkg.talker:main']},\n    license="
)
BAD = """\
<launch>
  <node pkg="my_pkg" exec="«taker»"/>
</launch>
"""
FILES = {
    "setup.py": SETUP,
    "my_pkg/talker.py": "def main():\n    pass\n",
    "package.xml": manifest(),
    "launch/a.launch.xml": BAD,
}


@rule(
    "LCH002",
    "unknown-executable",
    over=NodeExecutables,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "its condition can't be evaluated, `ros2 run` starts it, the launch file is for Foxy, or an "
        "old distribution had it, and the repository is for later ones",
        Severity.INFO: "the node is off by default or never added to the launch description, an old distribution had "
        "it, and nothing shows that the repository is for later ones, or another package may have the known name",
    },
    examples=(
        Example(
            bad=FILES,
            good={"launch/a.launch.xml": BAD.replace("«taker»", "talker")},
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={**FILES, "launch/a.launch.xml": BAD.replace('pkg="my_pkg" exec="«taker»"', 'exec="«talker»"')},
            good={"launch/a.launch.xml": BAD.replace("«taker»", "talker")},
        ),
    ),
)
def unknown_executable(started: NodeExecutables) -> Iterator[Hit]:
    """
    ## What it does
    Finds nodes in launch files whose executable nothing installs.
    The node is of this package, or of another package of the workspace, and is neither a console_script nor a target or
    script that CMake installs. Commands of `ros2 run` and `ExecutableInPackage` are checked in the same way. A node
    without a package is looked for on the PATH, where only what packages install into `bin/` is. Of well-known packages
    it knows the executables: it reports names that are a letter or two away from one, and those that only old
    distributions had. All places of a name in the launch files of a package are one finding, at the worst of them.

    ## Why is this bad?
    The launch stops with "executable 'taker' not found on the libexec directory".

    ## When it is quiet
    Left alone are

    - packages whose executables are not all known, or whose build may write the file;
    - launch files of tests that CMake does not run;
    - paths that begin at the root or at the folder of the launch file: launch starts them as they are.

    It is a warning where the condition of the node can't be evaluated, or Python makes the node in one branch only, or
    in a file without `generate_launch_description`.

    It is an info

    - where the node is off by default or never added to the launch description, or the function that makes it is never
      called;
    - where every launch ends before, as it looks for a package that is neither here, nor released, nor in a listed
      repository;
    - where the first lines of the file, or a page, say that it is not to be started (`# deprecated`);
    - where the name is still to be filled in (`TODO`), or to be replaced by what a comment says;
    - for names of Foxy or Galactic, unless the run checks for a distribution (`--target`), or pages, scripts and
      workflows name Humble or later ones alone; and always where a folder above is named after an old distribution, or
      parameters of the package name plugins of that time (`nav2_recoveries/Spin`);
    - where package.xml declares a package of the same prefix that no distribution has: a fork may have the executable;
    - for a well-known package that is not here where another one of its name may be used: listed repositories are not
      here, or a page clones one of that name. This does not count for packages that `ros_base` brings, or that a page
      or a container installs (`apt install ros-jazzy-topic-monitor`).

    Where no README, script or workflow names a distribution, other pages, launch files, docstrings and names of files
    decide; where several are named, the package's own description does.

    ## Fix safety
    The name is replaced by the only similar one; another program may be right.
    """
    for uses in unknown_together(started):
        node = uses[0].item
        start = f"`{node.facts.name}` installs no executable `{node.executable}`"
        whole = f"{start}: {node.ends}"
        texts = {None: whole, "warning": f"{whole}, {node.why}", "info": f"{start}, {node.why}"}
        message = f"{texts[node.level]}; {hint(node, started.scope.package)}"
        fix = rename([each.item for each in uses], node.suggestion)
        yield Hit(node.path, node.span, message, level_of(uses), other_places(uses), fix)
    for places in renamed_together(started):
        first, fix = places[0], other_name(places)
        yield Hit(first.path, first.span, not_offered(first.item), level_of(places), other_places(places), fix)
    for text, what in started.blank():
        yield blank_name(started.scope.file.path, text, what)
    for use in NodesWithoutPackage(started.scope).uses():
        level = Severity(use.level) if use.level else None
        yield Hit(started.scope.file.path, use.executable.span, without_package(use), level)


def other_name(places: list[CausedPlace[WellKnownUse]]) -> Fix | None:
    """Return what writes the other name wherever the old one stands as it is."""
    better = places[0].item.wrong.better
    edits = tuple(Edit(each.path, each.span, better) for each in places if each.item.plain)
    if not better or "/" in better or not edits:
        return None
    return Fix(f"start `{better}`", edits, Safety.UNSAFE)


def rename(nodes: list[ExecutableUse], suggestion: str | None) -> Fix | None:
    if suggestion is None or not all(node.plain for node in nodes):
        return None
    return Fix(f"start `{suggestion}`", tuple(Edit(each.path, each.span, suggestion) for each in nodes), Safety.UNSAFE)
