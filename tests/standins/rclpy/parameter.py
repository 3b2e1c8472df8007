"""A parameter by name and value."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass
class Parameter:
    name: str
    value: object
