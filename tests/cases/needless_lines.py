"""Dependencies by a wrong name, of which the right one is the package itself, or stands there already."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest


def declared(*tags: tuple[str, str], name: str = "my_pkg") -> Example:
    body = "".join(f"  <{tag}>{each}</{tag}>\n" for tag, each in tags)
    return Example(bad={"src/a/package.xml": manifest(body, name=name)}, good={}, on="")


FAMILY = {f"src/{each}/package.xml": manifest("", name=each) for each in ("ball_msgs", "ball_vision")}
OWN = declared(("depend", "machine"), name="ball_machine")

CASES = {
    "DEP001": (
        Example(bad={**FAMILY, **OWN.bad}, good={}, on=""),
        declared(("depend", "my_robot"), name="my_robots"),
        declared(("exec_depend", "numpy"), ("exec_depend", "python3-numpy")),
        declared(("exec_depend", "numpy"), ("depend", "python3-numpy")),
        declared(("exec_depend", "numpy"), ("test_depend", "numpy"), ("exec_depend", "python3-numpy")),
    ),
}
