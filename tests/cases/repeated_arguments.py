"""Launch arguments that are declared twice: what no example shows."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest


def launch(*lines: str) -> Example:
    text = "".join(f"  {line}\n" for line in lines)
    return Example(
        bad={
            "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"),
            "launch/a.launch.xml": f"<launch>\n{text}</launch>\n",
        },
        good={},
    )


FIRST, SECOND = '<arg name="camera1" default="/left"/>', '<{} name="camera1" default="/right"/>'
USE = '<log message="$(var camera1)"/>'
SAME = '<log message="$(var camera2 /right)"/>'
OTHER = '<log message="$(var camera2)"/>'

CASES = {
    "LCH020": (
        launch(FIRST, SECOND.format("«arg»"), USE),
        launch(FIRST, SECOND.format("arg"), USE, OTHER),
        launch(FIRST, FIRST, USE),
        launch("<group>", FIRST, "</group>", "<group>", SECOND.format("arg"), USE, "</group>"),
        launch(FIRST, '<arg name="camera1" default="/right" if="false"/>', USE),
        launch(FIRST, SECOND.format("«arg»"), '<include file="$(find-pkg-share no_one)/a.launch.xml"/>', USE, OTHER),
        launch(FIRST, SECOND.format("«arg»"), USE, SAME),
        launch(FIRST, SECOND.format("«arg»"), USE, SAME, '<log message="$(var camera2 /middle)"/>'),
    )
}
