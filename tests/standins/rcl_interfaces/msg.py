"""The messages of parameters; fields have the names and defaults of rcl_interfaces."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass
class FloatingPointRange:
    from_value: float = 0.0
    to_value: float = 0.0
    step: float = 0.0


@dataclass
class IntegerRange:
    from_value: int = 0
    to_value: int = 0
    step: int = 0


@dataclass
class ParameterDescriptor:
    name: str = ""
    type: int = 0
    description: str = ""
    additional_constraints: str = ""
    read_only: bool = False
    dynamic_typing: bool = False
    floating_point_range: list[FloatingPointRange] = field(default_factory=list)
    integer_range: list[IntegerRange] = field(default_factory=list)


@dataclass
class SetParametersResult:
    successful: bool = False
    reason: str = ""


class ParameterValue:
    def __init__(self, value: object) -> None:
        self.string_value = value if isinstance(value, str) else ""
        self.double_value = value if isinstance(value, float) else 0.0
        self.bool_value = value if isinstance(value, bool) else False
        self.integer_value = value if isinstance(value, int) else 0
