"""Edits of setup.cfg."""

from __future__ import annotations

from collections.abc import Iterable

from ..finding import Create, Edit
from ..package.setup.setup_cfg import SetupCfg
from ..package.setup.setup_text import SetupText
from ..source import Span


def new_setup_cfg(name: str) -> Create:
    """Write the setup.cfg that puts executables where ROS looks for them."""
    home = f"$base/lib/{name}"
    return Create("setup.cfg", f"[develop]\nscript_dir={home}\n[install]\ninstall_scripts={home}\n")


def replace_value(value: SetupText, text: str) -> Edit:
    return Edit(value.path, value.shown, text)


def put_option(cfg: SetupCfg, missing: Iterable[tuple[str, str]], value: str) -> tuple[Edit, ...]:
    """Set options that are not there, each at the end of its section; a section that is absent comes last."""
    edits, behind = [], ""
    for name, key in missing:
        section = cfg.sections.get(name)
        if section is None:
            behind += f"[{name}]\n{key}={value}\n"
            continue
        end = max([section.span.end, *[option.span.end for option in section.options.values()]])
        edits.append(Edit(cfg.path, Span(end, end), f"\n{key}={value}"))
    if behind:
        text = cfg.source.text
        gap = "" if not text or text.endswith("\n") else "\n"
        edits.append(Edit(cfg.path, Span(len(text), len(text)), gap + behind))
    return tuple(edits)
