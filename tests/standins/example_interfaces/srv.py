from dataclasses import dataclass


class AddTwoInts:
    @dataclass
    class Request:
        a: int = 0
        b: int = 0

    @dataclass
    class Response:
        sum: int = 0
