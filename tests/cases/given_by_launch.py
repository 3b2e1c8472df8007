"""Paths in a home folder in place of which launch files give nodes another value."""

from __future__ import annotations

from rospkg_cli.example import Example, scripts, setup_py

from .personal_defaults import NODE

HOME = "/home/ada/ws/src/my_pkg/models/best.pt"
DATA = """\
        ('share/' + package_name, ['package.xml']),
        ('share/' + package_name + '/config', ['config/a.yaml']),
        ('share/' + package_name + '/launch', ['launch/a.launch.xml']),
"""
SETUP = setup_py(scripts("talker = my_pkg.talker:main")).replace(
    "        ('share/' + package_name, ['package.xml']),\n", DATA
)
FILE = '<param from="$(find-pkg-share my_pkg)/config/a.yaml"/>'
MODEL = '<param name="model" value="$(find-pkg-share my_pkg)/models/best.pt"/>'


def launched(*parameters: str, code: str = "", yaml: str = "") -> Example:
    """Return a node that is launched once with each of some parameters."""
    nodes = "".join(f'  <node pkg="my_pkg" exec="talker">{each}</node>\n' for each in parameters)
    files = {
        "setup.py": SETUP,
        "models/best.pt": "",
        "my_pkg/talker.py": NODE.replace("'out'", "'model'").format(code or "best.pt"),
        "launch/a.launch.xml": f"<launch>\n{nodes}</launch>\n",
        "config/a.yaml": f"talker:\n  ros__parameters:\n    model: {yaml or 'best.pt'}\n",
    }
    return Example(bad=files, good={})


CASES = {
    "DEP118": (
        launched(MODEL, code=HOME),
        launched("", code=HOME, yaml=HOME),
        launched(MODEL.replace("model", "other", 1), code=HOME, yaml=HOME),
        launched(FILE + MODEL, yaml=HOME),
        launched(MODEL + FILE, yaml=HOME),
        launched(FILE + MODEL, FILE, yaml=HOME),
    ),
}
