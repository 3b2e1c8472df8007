"""Methods that another module of the package calls behind `rclpy.spin` alone: Ctrl-C leaves it before (DEP117)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import SETUP_PY_FOR_ALL, manifest
from rospkg_cli.testing import lint_files

SERVER = """\
from rclpy.node import Node


class Server(Node):
    def __init__(self):
        super().__init__('server')
        self.server = 1

    def destroy(self):
        self._server.destroy()
"""
MAIN = "import rclpy\nfrom my_pkg.server import Server\n\n\ndef main():\n    rclpy.init()\n    node = Server()\n"
SPIN, STOP = "    rclpy.spin(node)\n", "    node.destroy()\n"
SHIELDED = f"    try:\n    {SPIN}    finally:\n    {STOP}"


@pytest.mark.parametrize(
    ("ends", "level"),
    [
        (SPIN + STOP, "info"),
        (STOP + SPIN, "warning"),
        (SHIELDED, "warning"),
        (SPIN + STOP + "\n\ndef again(node):\n    node.destroy()\n", "warning"),
    ],
)
def test_what_stops_a_node(ends: str, level: str) -> None:
    entry = SETUP_PY_FOR_ALL.replace(
        "    license=", "    entry_points={'console_scripts': ['server = my_pkg.main:main']},\n    license="
    )
    files = {
        "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
        "setup.py": entry,
        "my_pkg/__init__.py": "",
        "my_pkg/server.py": SERVER,
        "my_pkg/main.py": MAIN + ends,
        "my_pkg/other.py": "def close(client):\n    client.destroy()\n",
    }
    found = [each for each in lint_files(files, ["DEP117"]).findings if each.location.path.endswith("server.py")]
    assert [each.severity.value for each in found] == [level]


INNER = "        while rclpy.ok():\n            if node.future.done():\n                break\n"


@pytest.mark.parametrize(
    ("loop", "level"),
    [
        (f"    while True:\n{INNER}", "info"),
        (f"    while True:\n{INNER}        else:\n            break\n", "warning"),
        (f"    while True:\n{INNER}        if node.is_done:\n            break\n", "warning"),
        ("    while True:\n        def late():\n            for _ in ():\n                break\n", "info"),
    ],
)
def test_which_break_ends_a_loop(loop: str, level: str) -> None:
    entry = SETUP_PY_FOR_ALL.replace(
        "    license=", "    entry_points={'console_scripts': ['server = my_pkg.main:main']},\n    license="
    )
    files = {
        "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
        "setup.py": entry,
        "my_pkg/__init__.py": "",
        "my_pkg/server.py": "class Server:\n    future = None\n",
        "my_pkg/main.py": f"{MAIN}{loop}    other.destroy()\n",
    }
    found = lint_files(files, ["DEP117"]).findings
    assert [each.severity.value for each in found] == [level]
