"""PRM010 missing-named-file."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.params.named_files import NamedFiles
from ...edits.fault_hits import hits
from ...example import CMAKE, Example
from ...finding import Hit, Severity
from ...rule import rule

MAP = """\
image: office.pgm
resolution: 0.05
origin: [0.0, 0.0, 0.0]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.25
"""
LAUNCH = """\
<launch>
  <let name="map" value="$(find-pkg-share my_pkg)/maps/office.yaml"/>
  <log message="$(var map)"/>
</launch>
"""
INSTALLS = CMAKE.replace(
    "ament_package", "install(DIRECTORY launch maps DESTINATION share/${PROJECT_NAME})\nament_package"
)


@rule(
    "PRM010",
    "missing-named-file",
    over=NamedFiles,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "nothing here installs or names the file, opens the map for its picture, or is shown to read "
        "the parameter, a launch file may give another value, or people bring what is missing"
    },
    examples=(
        Example(
            on="ament_cmake",
            bad={
                "CMakeLists.txt": INSTALLS,
                "maps/hall.pgm": "",
                "launch/a.launch.xml": LAUNCH,
                "maps/office.yaml": MAP.replace("office.pgm", "«office.pgm»"),
            },
            good={"maps/office.yaml": MAP.replace("office", "hall")},
        ),
    ),
)
def missing_named_file(scope: NamedFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds files that maps and parameter files name, and that do not exist.
    The `image` of a map is looked for in its folder; a value such as `$(find-pkg-share my_pkg)/trees/a.xml` or
    `package://my_pkg/trees/a.xml` is looked for in what this package, or another one of the workspace, installs.

    ## Why is this bad?
    map_server can't load the map, and a navigator without its tree does not start: what is renamed has to be renamed
    here, too.

    ## When it is quiet
    Left alone are files that git ignores, that the build or the package's own code writes, or that a submodule brings;
    packages of which not all is known that they install; and, in a package of tests, files that nothing names. Other
    rules report a file that is there and not installed.

    It is an info

    - where nothing names the map, or starts nav2 or a map server and names the map's folder;
    - where only programs name the map, none of them near a map server, and they name a picture of their own, or parse
      the map and never ask for its `image`;
    - where neither code of the workspace nor a well-known node is shown to read the parameter by its key;
    - where people bring the file: a page or a script fetches, saves or copies it there by its name, an archive of its
      name is in the folder, the folder is one that people fill (`maps`, `calibration`, `data`) and has nothing but a
      `.gitkeep` or a README, or a comment asks for another name (`# change this to your map`);
    - for a trained model or a recording of a kind that the package has none of, and where the parameter says that a
      node writes the file (`output_file`, `log_path`).
    """
    for path, fault in scope.faults():
        yield from hits(path, [fault])
