"""Manifests that mark a folder of files for other tools, and those of packages that nothing builds."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest

BARE = "  <export>\n    <build_type>ament_python</build_type>\n  </export>\n"


def folder(depends: str = "", **files: str) -> Example:
    named = {path.replace("__", "/").replace("_DOT_", "."): text for path, text in files.items()}
    return Example(bad={"package.xml": manifest(depends).replace(BARE, ""), **named}, good={}, on="")


CASES = {
    "XML301": (
        folder(meshes__a_DOT_stl="solid a\n"),
        folder("  <exec_depend>xacro</exec_depend>\n", meshes__a_DOT_stl="solid a\n"),
        folder(launch__a_DOT_launch_DOT_xml="<launch/>\n"),
    ),
}
