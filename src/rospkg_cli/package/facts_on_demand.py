"""The facts of a package that is only there for others: each part is read when it is first asked for."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..files import ReaderInput
from ..light_dataclasses import field_names
from ..ros.distros import Targets
from .collect_facts import DOUBTS, PARTS, collect_part, name_of, unknown_facts
from .manifest import Manifest
from .package_facts import PackageFacts, UnknownField
from .quick_look import QuickLook

NOTHING = unknown_facts("", "")
FIELDS = {name: names for names in PARTS for name in names}


class FactsOnDemand(PackageFacts):
    """Facts whose other fields than `name` and `folder` are collected together with those of their part."""

    __slots__ = ("_doubts", "_look", "_manifest", "_reading", "_settled", "_targets")

    def __init__(self, reading: ReaderInput, targets: Targets, manifest: Manifest, folder: str, fallback: str) -> None:
        called = name_of(manifest, folder, fallback)
        own: dict[str, object] = {"name": called, "folder": folder, "_look": QuickLook(reading.files, called)}
        own |= {"_reading": reading, "_targets": targets, "_manifest": manifest, "_doubts": set(), "_settled": set()}
        for name, value in own.items():
            object.__setattr__(self, name, value)

    def __getattr__(self, name: str) -> Any:
        """Collect a field; what raises is unknown, as the facts of a package are that can't be read."""
        if name == "unknown":
            for each in FIELDS:
                getattr(self, each)
            for each in DOUBTS:
                self.knows(each)
            object.__setattr__(self, "unknown", frozenset(self._doubts))
        elif name in FIELDS:
            try:
                fields, doubts = collect_part(PARTS[FIELDS[name]], self._reading, self._targets, self._manifest)
            except Exception:
                fields = {each: getattr(NOTHING, each) for each in FIELDS[name]}
                doubts = {each for each in NOTHING.unknown if each in fields}
            self._doubts.update(doubts)
            for each, value in fields.items():
                object.__setattr__(self, each, value)
        else:
            raise AttributeError(name)
        return object.__getattribute__(self, name)

    def knows(self, field: UnknownField) -> bool:
        if field in FIELDS:
            getattr(self, field)
        if field in DOUBTS and field not in self._settled:
            self._settled.add(field)
            try:
                is_unknown = DOUBTS[field](self._reading)
            except Exception:
                is_unknown = True
            self._doubts.update([field] if is_unknown else [])
        return field not in self._doubts

    @property
    def is_on_demand(self) -> bool:
        return True

    def may_have(self, field: str, value: Sequence[str]) -> bool:
        look: QuickLook = self._look
        return look.may_have(field, value)

    def __reduce__(self) -> tuple[type[PackageFacts], tuple[Any, ...]]:
        return PackageFacts, tuple(getattr(self, name) for name in field_names(PackageFacts))


def facts_on_demand(reading: ReaderInput, targets: Targets, folder: str, fallback: str) -> PackageFacts:
    """Return what `collect_facts` returns, collected as it is asked for."""
    manifest = reading.parts(Manifest).only
    if manifest is None:
        return unknown_facts(folder, fallback)
    return FactsOnDemand(reading, targets, manifest, folder, fallback)
