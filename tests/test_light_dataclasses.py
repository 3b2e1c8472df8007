"""Light dataclasses behave as those of the standard library do, but for assignments to frozen ones."""

from __future__ import annotations

import dataclasses
import pickle
from typing import Any, ClassVar

import pytest

from rospkg_cli import light_dataclasses
from rospkg_cli.light_dataclasses import dataclass, field, field_names, replace


@dataclass(frozen=True, slots=True, order=True)
class Point:
    x: int
    y: int = 2


@dataclass
class Basket:
    name: str
    kinds: ClassVar[int] = 3
    items: list[str] = field(default_factory=list)
    cache: dict[str, int] = field(default_factory=dict, init=False, repr=False)

    def __post_init__(self) -> None:
        self.count = len(self.items)


@dataclass(kw_only=True)
class Box(Basket):
    lid: bool = False


@dataclass(frozen=True)
class Nothing:
    pass


@dataclass(frozen=True, slots=True)
class Alone:
    value: str


@dataclass(frozen=True, eq=False)
class Same:
    value: int


@dataclass(frozen=True)
class Named:
    name: str
    place: int

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Named) and other.name == self.name

    def __hash__(self) -> int:
        return 1

    def __repr__(self) -> str:
        return self.name


def test_arguments_and_defaults() -> None:
    assert (Point(1).x, Point(1).y, Point(x=4, y=5).y) == (1, 2, 5)
    for wrong in ((), (1, 2, 3)):
        with pytest.raises(TypeError, match="__init__"):
            Point(*wrong)
    with pytest.raises(TypeError, match="unexpected keyword argument 'z'"):
        Point(1, z=2)  # type: ignore[call-arg]


def test_a_factory_makes_one_for_each() -> None:
    first, second = Basket("a"), Basket("b", ["egg"])
    first.items.append("apple")
    first.cache["a"] = 1
    assert (Basket("c").items, second.items, second.count, second.cache) == ([], ["egg"], 1, {})
    assert not hasattr(Basket, "items")
    with pytest.raises(TypeError):
        Basket("a", [], {})  # type: ignore[call-arg]


def test_fields_of_a_base_come_first() -> None:
    assert field_names(Box) == ("name", "items", "lid")
    box = Box("a", ["egg"], lid=True)
    assert (box.lid, box.count, box.kinds) == (True, 1, 3)
    with pytest.raises(TypeError):
        Box("a", [], True)  # type: ignore[misc]


def test_equality_is_of_one_class() -> None:
    assert Point(1) == Point(1, 2)
    assert Point(1) != Point(1, 3)
    assert Point(1) != (1, 2)
    assert Basket("a") == Basket("a")
    assert Basket("a") != Box("a")
    assert Alone("a") == Alone("a")
    assert Alone("a") != Alone("b")
    assert Nothing() == Nothing()
    assert Same(1) != Same(1)
    assert Named("a", 1) == Named("a", 2)


def test_only_frozen_ones_have_a_hash() -> None:
    assert len({Point(1), Point(1, 2), Point(2)}) == 2
    assert {Nothing(): 1}[Nothing()] == 1
    assert hash(Alone("a")) == hash(Alone("a"))
    assert hash(Named("a", 1)) == 1
    assert len({Same(1), Same(1)}) == 2
    with pytest.raises(TypeError, match="unhashable"):
        hash(Basket("a"))


def test_order() -> None:
    assert sorted([Point(2), Point(1, 3), Point(1)]) == [Point(1), Point(1, 3), Point(2)]
    assert Point(1) < Point(2) <= Point(2)
    assert Point(2) > Point(1) >= Point(1)
    assert not Point(1) > Point(1)
    assert not Point(1) < Point(1)
    for compare in ("__lt__", "__le__", "__gt__", "__ge__"):
        assert getattr(Point(1), compare)((1, 2)) is NotImplemented


def test_what_is_shown() -> None:
    assert repr(Point(1)) == "Point(x=1, y=2)"
    assert repr(Basket("a")) == "Basket(name='a', items=[])"
    assert repr(Named("a", 1)) == "a"
    assert repr(Nothing()) == "Nothing()"
    basket: Basket[Any] = Basket("a")  # type: ignore[type-arg]
    basket.items.append(basket)  # type: ignore[arg-type]
    assert repr(basket) == "Basket(name='a', items=[...])"


def test_slots_leave_no_room_for_others() -> None:
    with pytest.raises(AttributeError):
        Point(1).z = 3  # type: ignore[attr-defined]
    assert (Point.__qualname__, Point.__module__, Point.__slots__) == ("Point", __name__, ("x", "y"))  # type: ignore[attr-defined]


@pytest.mark.parametrize("value", [Point(1, 3), Box("a", ["egg"], lid=True), Alone("a"), Nothing()])
def test_they_pickle(value: object) -> None:
    for protocol in (2, pickle.HIGHEST_PROTOCOL):
        assert pickle.loads(pickle.dumps(value, protocol)) == value


def test_a_copy_with_changes() -> None:
    assert replace(Point(1, 3), x=5) == Point(5, 3)
    box = Box("a", ["egg"], lid=True)
    box.cache["a"] = 1
    assert (replace(box, name="b").lid, replace(box, name="b").cache) == (True, {})
    with pytest.raises(TypeError, match="unexpected keyword argument 'z'"):
        replace(Point(1), z=5)  # type: ignore[call-arg]


def test_they_match_by_position() -> None:
    match Point(1, 3):
        case Point(x, y):
            assert (x, y) == (1, 3)


def test_the_standard_library_knows_them() -> None:
    assert dataclasses.is_dataclass(Point)
    assert dataclasses.asdict(Point(1)) == {"x": 1, "y": 2}
    assert dataclasses.replace(Point(1), y=4) == Point(1, 4)
    fields = {each.name: each for each in dataclasses.fields(Basket)}
    assert list(fields) == ["name", "items", "cache"]
    assert (fields["items"].default_factory, fields["cache"].init, fields["cache"].repr) == (list, False, False)
    assert {each.name: each.default for each in dataclasses.fields(Point)} == {"x": dataclasses.MISSING, "y": 2}


def test_names_of_fields_of_either() -> None:
    @dataclasses.dataclass
    class Standard:
        a: int
        b: int = dataclasses.field(default=0, init=False)

    assert field_names(Standard) == ("a",)
    assert field_names(Basket) == ("name", "items")
    with pytest.raises(TypeError):
        field_names(int)


def test_annotations_that_are_no_strings() -> None:
    made = light_dataclasses.dataclass(type("Made", (), {"__annotations__": {"a": int, "b": ClassVar[int]}, "b": 1}))
    assert field_names(made) == ("a",)
