"""Mutates requests that the contract describes, as a hostile client might."""
import copy
import json

NUMBERS = [0, -0.0, 1, -1, 0.5, 2, 1e-300, 5e-324, 1e19, -1e19, 1e38, 3.5e38, 1e300, 1.7e308, 2**31, 2**32, 2**53 + 1, 2**63, 2**64, -2**63]
TEXTS = ["", "x", "../../etc/passwd", "\u0000", "\ud800", "é" * 300, "a" * 100_000, "NaN", "null", "%00", "#ffffff", "<script>", "\r\nX: y"]
OTHERS = [None, True, False, [], {}, [[[]]], {"op": "comb"}]


def nodes(document, path=()):
    """Paths of all values in a document."""
    yield path
    inner = document.items() if isinstance(document, dict) else enumerate(document) if isinstance(document, list) else ()
    for key, value in inner:
        yield from nodes(value, (*path, key))


def parent_of(document, path):
    for key in path[:-1]:
        document = document[key]
    return document


def odd_value(rng, old):
    kind = rng.random()
    if isinstance(old, (int, float)) and kind < 0.3:
        return old * rng.choice([-1, 0.1, 10, 1e6, 1e30])
    return copy.deepcopy(rng.choice(NUMBERS if kind < 0.65 else TEXTS if kind < 0.8 else OTHERS))


def mutated(rng, document):
    """Returns the document with up to three odd values, missing or unknown members, or long lists."""
    document = copy.deepcopy(document)
    for _ in range(rng.randint(1, 3)):
        paths = [path for path in nodes(document) if path]
        if not paths:
            return copy.deepcopy(rng.choice(OTHERS))
        path = rng.choice(paths)
        inside, kind = parent_of(document, path), rng.random()
        if kind < 0.7:
            inside[path[-1]] = odd_value(rng, inside[path[-1]])
        elif kind < 0.8:
            del inside[path[-1]]
        elif isinstance(inside, dict):
            inside["unknown_member"] = copy.deepcopy(rng.choice(OTHERS))
        else:
            inside *= rng.choice([2, 20])
    return document


def damaged(rng, content):
    """Returns the bytes with flips, cuts or repeats."""
    content = bytearray(content)
    for _ in range(rng.randint(1, 8)):
        at = rng.randrange(len(content) + 1)
        kind = rng.random()
        if kind < 0.6 and at < len(content):
            content[at] = rng.choice([0, 0xFF, content[at] ^ (1 << rng.randrange(8)), rng.randrange(256)])
        elif kind < 0.75:
            del content[at:]
        elif kind < 0.9:
            del content[at:at + rng.randint(1, 64)]
        else:
            content[at:at] = content[max(0, at - 40):at]
    return bytes(content)


def as_text(document):
    return json.dumps(document).encode("utf-8", "surrogatepass")


def capped(document, caps):
    """Returns the document with the numbers of these names capped. Larger ones are allowed, but might look like a hang."""
    if isinstance(document, list):
        return [capped(value, caps) for value in document]
    if not isinstance(document, dict):
        return document
    return {name: min(value, caps[name]) if name in caps and type(value) in (int, float) and value <= 1e9 else capped(value, caps)
            for name, value in document.items()}
