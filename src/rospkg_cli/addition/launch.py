"""A launch file: its source, what installs it, and what it depends on."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence

from ..change import ChangeError
from ..package.install_table import InstallTable
from ..package.launch.launch_file import LaunchFile
from ..package.package import Package
from ..scaffold.bringup import NODE_NAME, PROGRAM, Bringup, StartedNode
from ..scaffold.template import load_template
from ..suggest import did_you_mean
from .dependency import NAME, AddedDependency, manifest_of
from .new_file import NewFile
from .part import Part
from .rendered import rendered_files
from .share_file import ShareFile

FORMATS = {
    "py": ("launch", "launch_ros"),
    "xml": ("launch_xml", "launch_ros"),
    "yaml": ("launch_yaml", "launch_ros"),
}
"""What each format of launch files needs to be read and run."""

FILE_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.-]*")
SUFFIX = re.compile(r"([._])launch\.(py|xml|yaml|yml)$")


def launch_parts(package: Package, asked: str, nodes: Sequence[str] = (), force: bool = False) -> tuple[Part, ...]:
    """Return the parts of a launch file that was asked for as NAME[:FORMAT]; raises ChangeError.

    `nodes` are executables of the package, or PACKAGE/EXECUTABLE; where none is given, those that its name means.
    """
    stem, mark, form = named_file(package, asked)
    manifest = manifest_of(package)
    starts = tuple(started(package, manifest.name, nodes, stem))
    path = f"launch/{stem}{mark or usual_mark(package, form)}launch.{form}"
    template = load_template("bringup")
    [file] = [each for each in template.files if each.source == "bringup.launch.{{ launch }}"]
    [made] = rendered_files(
        template, (file,), manifest, manifest.name, started=Bringup(starts, params=False), launch=form
    )
    others = sorted({each.package for each in starts} - {manifest.name})
    return (
        *(AddedDependency(name, "exec") for name in (*FORMATS[form], *others)),
        NewFile(path, made.entry.text.text, force=force),
        ShareFile(path),
    )


def named_file(package: Package, asked: str) -> tuple[str, str, str]:
    """Return a launch file's name without its end, the `.` or `_` before it ("" where none was typed), and its format.

    Raises ChangeError.
    """
    name, colon, form = asked.partition(":")
    mark = ""
    if (found := SUFFIX.search(name)) and not colon:
        name, mark, form = name[: found.start()], found[1], {"yml": "yaml"}.get(found[2], found[2])
    form = form or usual_format(package)
    if form not in FORMATS:
        raise ChangeError(f"there are no launch files in `{form}`{did_you_mean(form, FORMATS)}; known: py, xml, yaml")
    if not FILE_NAME.fullmatch(name):
        raise ChangeError(f"`{name}` can't be the name of a launch file: letters, digits, `_`, `-` and `.`")
    return name, mark, form


def usual_format(package: Package) -> str:
    """Return the format of most launch files of the package; py where there is none."""
    found = Counter(each.path.rpartition(".")[2].replace("yml", "yaml") for each in package.parts(LaunchFile).good)
    return next((form for form, _ in found.most_common() if form in FORMATS), "py")


def usual_mark(package: Package, form: str) -> str:
    """Return what is before `launch.py` in the names of the neighbours: a point, or an underscore."""
    ends = Counter(path[-len(f"_launch.{form}") :] for path in package.files.below("launch"))
    return "_" if ends[f"_launch.{form}"] > ends[f".launch.{form}"] else "."


def started(package: Package, name: str, nodes: Sequence[str], stem: str) -> Iterator[StartedNode]:
    """Yield the nodes to start; raises ChangeError for one that the package has not."""
    own = executables(package, name)
    chosen = list(nodes) or ([stem] if stem in own else own)
    for each in chosen:
        other, slash, executable = each.rpartition("/")
        if not PROGRAM.fullmatch(executable) or (slash and not NAME.fullmatch(other)):
            raise ChangeError(f"`{each}` can't be a node to start: EXECUTABLE, or PACKAGE/EXECUTABLE")
        if not slash and own and executable not in own:
            raise ChangeError(f"the package has no executable `{executable}`{did_you_mean(executable, own)}")
        yield StartedNode(other or name, executable, node_name(executable))


def executables(package: Package, name: str) -> list[str]:
    """Return the executables of the package that can be a node, by name."""
    table = package.parts(InstallTable).only
    found = {path for path, row in table.below(f"lib/{name}") if row.what == "executable"} if table else set()
    return sorted(each for each in found if PROGRAM.fullmatch(each))


def node_name(executable: str) -> str:
    """Return a name for a node: the executable's own, where ROS takes it."""
    stem = re.sub(r"\.(py|sh|exe)$", "", executable)
    return stem if NODE_NAME.fullmatch(stem) else re.sub(r"\W", "_", f"node_{stem}" if stem[:1].isdigit() else stem)
