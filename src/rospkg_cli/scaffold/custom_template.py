"""Templates of one's own: a folder with a template.toml, or a git repository of such a folder."""

from __future__ import annotations

import os
import re
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from . import OwnFaultError, ScaffoldError
from .bounds import MAX_FILES, bounded
from .node_kinds import LANGUAGES, all_kinds
from .template import Template, read_template
from .template_errors import template_errors
from .template_loader import check_source

ADDRESS = re.compile(r"(https|ssh|git|file)://.+|[\w.-]+@[\w.-]+:.+")
"""What git clones from; `#BRANCH` behind it chooses one."""

CLONE_SECONDS = 120


@contextmanager
def custom_template(asked: str) -> Iterator[Template]:
    """Give the template of a folder or a repository; raises ScaffoldError for what is none, and for what it gets wrong.

    Nothing of it is executed: sources are rendered in jinja2's sandbox, and git makes no links.
    """
    folder = Path(asked).expanduser()
    if folder.is_dir():
        template = checked(folder, asked)
        with template_errors(asked, template), bounded():
            yield template
    elif ADDRESS.fullmatch(asked):
        with tempfile.TemporaryDirectory(prefix="rospkg-template-") as place:
            template = checked(clone(asked, Path(place)), asked)
            with template_errors(asked, template), bounded():
                yield template
    else:
        raise ScaffoldError(f"`{asked}` is neither a folder nor the address of a git repository")


def clone(asked: str, place: Path) -> Path:
    """Clone a repository, its newest state alone; raises ScaffoldError."""
    address, _, branch = asked.partition("#")
    name = re.sub(r"[^\w-]", "", re.split(r"[/:]", address.rstrip("/"))[-1].removesuffix(".git")) or "template"
    command = ["git", "-c", "core.symlinks=false", "clone", "--quiet", "--depth", "1"]
    command += ["--branch", branch] if branch else []
    env = {**os.environ, "GIT_ALLOW_PROTOCOL": "https:ssh:git:file", "GIT_TERMINAL_PROMPT": "0"}
    try:
        done = subprocess.run(
            [*command, "--", address, str(place / name)],
            env=env,
            capture_output=True,
            text=True,
            errors="replace",
            check=False,
            timeout=CLONE_SECONDS,
        )
    except FileNotFoundError:
        raise ScaffoldError("git is not installed, and --template with an address needs it") from None
    except subprocess.TimeoutExpired:
        raise ScaffoldError(f"git did not get `{address}` within {CLONE_SECONDS} seconds") from None
    if done.returncode:
        errors = done.stderr.strip().splitlines()
        raise ScaffoldError(
            f"git can't clone `{address}`: {errors[-1] if errors else f'it exited with status {done.returncode}'}"
        )
    return place / name


def checked(folder: Path, asked: str) -> Template:
    """Read a template and check what it says of nodes; raises ScaffoldError."""
    folder = folder.resolve()
    try:
        check_source(folder / "template.toml", folder)
        template = read_template(folder)
        for problem in problems_of(template):
            raise ValueError(problem)
    except OSError as error:
        raise ScaffoldError(f"the template `{asked}` has no template.toml: {error.strerror or error}") from error
    except KeyError as error:
        raise ScaffoldError(f"the template.toml of `{asked}` lacks the key {error}") from error
    except OwnFaultError as error:
        raise ScaffoldError(f"the template `{asked}`: {error}") from error
    except (AttributeError, RecursionError, TypeError, ValueError) as error:
        raise ScaffoldError(f"the template.toml of `{asked}` is wrong: {error}") from error
    return template


def problems_of(template: Template) -> Iterator[str]:
    for what, named, known in (("kind", template.kinds, all_kinds()), ("language", template.languages, LANGUAGES)):
        for name in named:
            if name not in known:
                yield f"there is no {what} of nodes `{name}`; known: {', '.join(known)}"
    if len(template.files) > MAX_FILES:
        yield f"it lists {len(template.files)} files; at most {MAX_FILES} are written"
    if bool(template.kinds) != bool(template.languages):
        yield "`kinds` and `languages` of nodes come together"
    if template.build_type not in ("ament_python", "ament_cmake"):
        yield f"the build-type is ament_python or ament_cmake, not `{template.build_type}`"
