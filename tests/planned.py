"""Packages as `new` plans them, without a disk and without this machine's git."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from rospkg_cli.scaffold.answers import Request
from rospkg_cli.scaffold.plan import Plan, make_plan
from rospkg_cli.scaffold.workspace import WorkspacePackages
from rospkg_cli.tree import MemoryTree

ADA = {"maintainer": "Ada Lovelace", "email": "ada@example.org", "year": 2026, "distro": "lyrical"}


def plan(name: str = "my_robot_nav", there: WorkspacePackages | None = None, **asked: Any) -> Plan:
    return make_plan(Request(name, **{**ADA, **asked}), Path(), {}, there or WorkspacePackages())


def around(*plans: Plan) -> WorkspacePackages:
    """Return the packages of plans as those around another."""
    return WorkspacePackages({each.answers.name: MemoryTree({f.path: f.entry for f in each.files}) for each in plans})


def texts(planned: Plan) -> dict[str, str]:
    """Return path to text of every file."""
    return {file.path: file.entry.text.text for file in planned.files}
