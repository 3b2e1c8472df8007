"""Names of parameters that only another program of the package declares: no advice for the node that is started."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example

from .idle_parameters import CODE

PROGRAM = "add_executable({0} src/{1}.cpp)\ninstall(TARGETS {0} DESTINATION lib/${{PROJECT_NAME}})\n"
LAUNCH = """\
<launch>
  <node pkg="my_pkg" exec="{}">
    <param name="rate" value="1.0"/>
    <param name="port" value="a"/>
    <param name="globalframe" value="a"/>
  </node>
</launch>
"""
FRAME = '    declare_parameter("global_frame", "map");\n'


def started(program: str, source: str = "walker", build: str = "walker") -> Example:
    """A package of two programs, of which one declares what the other one may be given."""
    lines = PROGRAM.format("talker", "talker") + PROGRAM.format(build, source)
    lines += "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\n"
    files = {
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{lines}ament_package"),
        "src/talker.cpp": CODE.replace(FRAME, ""),
        f"src/{source}.cpp": CODE.replace('"talker"', '"walker"'),
        "launch/a.launch.xml": LAUNCH.format(program),
    }
    return Example(on="ament_cmake", bad=files, good={})


CASES = {"PRM007": (started("talker"), started("walker"), started("talker", "frames"), started("frames", "frames"))}
