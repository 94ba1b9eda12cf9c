"""HTML and SVG as trees, so that texts are escaped and every tag is closed."""

from __future__ import annotations

import base64
from typing import List, Sequence, Union
from xml.etree import ElementTree

Element = ElementTree.Element
Content = Union[str, Element]

STYLE = """
body{font:16px/1.5 sans-serif;color:#2b2925;background:#faf8f4;max-width:1160px;margin:2em auto;padding:0 1.5em}
h1{font-size:1.9em;margin:0 0 .2em} h2{font-size:1.35em;margin:2em 0 .3em;border-bottom:1px solid #ddd6ca}
h3{font-size:1.05em;margin:1.2em 0 .2em} p{max-width:46em;margin:.4em 0}
table{border-collapse:collapse;font-size:14px;margin:.6em 0} th{text-align:left;color:#6b655b;font-weight:600}
td,th{padding:.15em 1em .15em 0;border-bottom:1px solid #eae4da;vertical-align:top}
.panels,.pictures{display:flex;flex-wrap:wrap;gap:10px 18px} .pair{display:flex;flex-wrap:wrap;gap:0 3em}
figure{margin:0;width:208px} figure img{width:208px;height:208px;display:block;border-radius:3px;margin-bottom:3px}
figcaption{font-size:13px;line-height:1.35;color:#55504a} svg{display:block;max-width:100%}
details{margin:1em 0} summary{cursor:pointer;color:#0072b2} .all{font-size:12px}
"""


def tag(name: str, *content: Content, **attributes: Union[str, float]) -> Element:
    """An element. `stroke_width` stands for stroke-width, `class_` for class; numbers have one decimal."""
    element = Element(name)
    for key, value in attributes.items():
        element.set(key.rstrip("_").replace("_", "-"), value if isinstance(value, str) else f"{round(value, 1):g}")
    for part in content:
        append(element, part)
    return element


def append(element: Element, part: Content) -> None:
    if not isinstance(part, str):
        element.append(part)
    elif len(element):
        element[-1].tail = (element[-1].tail or "") + part
    else:
        element.text = (element.text or "") + part


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> Element:
    body = [tag("tr", *(tag("td", cell) for cell in row)) for row in rows]
    return tag("table", tag("thead", tag("tr", *(tag("th", cell) for cell in head))), tag("tbody", *body))


def items(texts: Sequence[Sequence[Content]]) -> Element:
    return tag("ul", *(tag("li", *text) for text in texts))


def image(content: bytes, kind: str, text: str) -> Element:
    """kind: "jpeg" or "png". text: What it shows."""
    return tag("img", alt=text, src=f"data:image/{kind};base64,{base64.b64encode(content).decode()}")


def document(title: str, content: List[Element]) -> str:
    """Returns a page that is well-formed XML and valid HTML, without external resources."""
    head = tag("head", tag("meta", charset="utf-8"), tag("title", title), tag("style", STYLE))
    page = tag("html", head, tag("body", tag("h1", title), *content), lang="en")
    return "<!DOCTYPE html>\n" + ElementTree.tostring(page, encoding="unicode", short_empty_elements=False) + "\n"
