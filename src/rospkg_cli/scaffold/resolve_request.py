"""From what was typed to answers; each error is one sentence with the reason and what to do."""

from __future__ import annotations

import os
import re
from shlex import quote

from ..ros.distros import NEWEST_LTS, Distro, distro, fault_of_name
from ..ros.licenses import LICENSES, License, offered, spdx_id
from ..ros.manifest import VERSION
from ..suggest import did_you_mean
from . import ScaffoldError
from .answers import Request
from .interface import RequestedInterface, interfaces_of
from .template import Template

KEY = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.+-]*")
"""Names of ROS packages and of rosdep keys."""

LONGEST_KEY = 100
"""The longest of rosdep's has 56 characters."""

TEST_ONLY = re.compile(
    r"ament_(lint_.*|copyright|cpplint|flake8|mypy|pep257|xmllint)|launch_testing.*|python3-pytest.*"
)


def requested_interfaces(request: Request, template: Template) -> tuple[RequestedInterface, ...]:
    """Return the interfaces; one message where none was asked for, in a package that is for them."""
    asked = {"msg": request.msgs, "srv": request.srvs, "action": request.actions}
    if template.interfaces:
        return interfaces_of(asked if any(asked.values()) else {"msg": ("Status",)})
    options = [f"--{form} {quote(text)}" for form, texts in asked.items() for text in texts]
    if options:
        command = f"rospkg new {request.name}_interfaces --type interfaces {' '.join(options)}"
        raise ScaffoldError(f"{options[0].partition(' ')[0]} requires an interfaces package: {command}")
    return ()


def depends_of(asked: tuple[str, ...], package: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return what the package needs to run, and what only its tests need."""
    for key in asked:
        if key == package:
            raise ScaffoldError(f"`{key}` can't depend on itself; leave it out of --depends")
        if key == "ament_python":
            raise ScaffoldError("`ament_python` is a build type, not a package; leave it out of --depends")
        if not KEY.fullmatch(key) or len(key) > LONGEST_KEY:
            raise ScaffoldError(
                f"`{key}` is neither the name of a ROS package nor a rosdep key; --depends takes only those"
            )
    keys = sorted(set(asked))
    tests = tuple(key for key in keys if TEST_ONLY.fullmatch(key))
    return tuple(key for key in keys if key not in tests), tests


def license_of(asked: str) -> License:
    spdx = spdx_id(asked)
    found = offered(spdx) if spdx else None
    if found is None:
        known = [each.spdx for each in LICENSES]
        hint = did_you_mean(asked, known)
        raise ScaffoldError(f"the text of the license `{asked}` is not known here{hint}; known: {', '.join(known)}")
    return found


def version_of(asked: str) -> str:
    if not VERSION.fullmatch(asked):
        raise ScaffoldError(f"`{asked}` is not a package version: three numbers without leading zeros, such as 0.1.0")
    return asked


def distro_of(asked: str, notes: list[str]) -> Distro:
    """Return the distribution that was asked for, else that of $ROS_DISTRO, else the newest with long support."""
    if asked and (fault := fault_of_name(asked)):
        raise ScaffoldError(fault)
    sourced = os.environ.get("ROS_DISTRO", "")
    unknown = bool(fault_of_name(sourced))
    if not asked and sourced and unknown:
        notes.append(f"ROS_DISTRO={sourced} is unknown; written for {NEWEST_LTS} (--distro chooses)")
    return distro(asked or (NEWEST_LTS if unknown else sourced))
