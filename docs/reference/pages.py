"""Makes the pages: the first one, and one for each command, each group of operations and each type."""

from __future__ import annotations

import pathlib
from typing import Any, Dict, Iterator, List, Sequence, Tuple

import examples
from contract import Command, Contract, Operation, group_page
from groups import GROUPS, UNITS
from markup import Links, code, escape, inline, link, navigation, page, paragraphs, table
from schema_rows import KNOWN, Row, Schema, name_of

HEADS = ("Member", "Type", "Unit", "Range", "Default", "Meaning")
RULES = ("oneOf", "anyOf", "allOf", "not", "if", "then", "else", "dependentRequired")
SHARED = ("Stroke", "Brush", "Camera")  # used by so many commands that their tables would bury the command's own
CAPTIONS = {True: "Before and after this example, on the built-in creature.", False: "Before and after, with the recipe of the tool's page in the manual."}


def first_sentence(text: str) -> str:
    return " ".join(text.split()).split(". ")[0].rstrip(".") + "."


def address_text(path: str) -> str:
    """Escapes a path and allows a line break after each slash."""
    return escape(path).replace("/", "/<wbr>")


class Pages:
    """`clients`: by operation, how the command line and the Python package send its example. `pictures`: by op, a file and
    whether it shows the command's own example."""

    def __init__(self, contract: Contract, clients: Dict[str, Dict[str, str]], pictures: Dict[str, Tuple[str, bool]]) -> None:
        self.contract, self.clients, self.pictures = contract, clients, pictures
        grouped = [op for ops in GROUPS.values() for op in ops]
        missing = {command.op for command in contract.commands} ^ set(grouped)
        missing |= {operation.id for operation in contract.operations} ^ set(clients)
        if missing:
            raise SystemExit(f"docs/reference: groups.py, clients.yaml and the contract differ in {sorted(missing)}")

    def all(self) -> Iterator[Tuple[str, str]]:
        """Yields file names and contents. The first page comes last: the build takes it as the sign that all pages exist."""
        for command in self.contract.commands:
            yield f"{command.op}.html", self.frame(command.op, "Command", self.command(command), f"{command.op}.html")
        for group in self.contract.groups:
            yield group_page(group), self.frame(group.capitalize(), "Operations", self.group(group), group_page(group))
        for name, schema in self.contract.types().items():
            yield self.contract.page_of(name), self.frame(name, "Type", self.type(name, schema), self.contract.page_of(name))
        yield "index.html", self.frame("Reference", "", self.index(), "index.html")

    def frame(self, title: str, kind: str, body: str, file: str) -> str:
        groups: List[Tuple[str, Links]] = [(name, [(op, f"{op}.html", file == f"{op}.html") for op in ops]) for name, ops in GROUPS.items()]
        groups.append(("Operations", [(group.capitalize(), group_page(group), file == group_page(group)) for group in self.contract.groups]))
        groups.append(("More", [("All types", "index.html#types", file.startswith("type-")), ("Units", "index.html#units", False)]))
        return page(title, kind, body, navigation(groups), self.contract.document["info"]["version"])

    # Tables

    def type_cell(self, row: Row) -> str:
        if row.target is None:
            known = row.kind.capitalize()
            return link(row.kind, self.contract.page_of(known)) if known in KNOWN else inline(row.kind)
        before = row.kind.rsplit(" ", 1)[0] + " " if row.many else ""
        others = [part for part in row.kind.split(" or ") if part != "object"] if not row.many and " or " in row.kind else []
        return " or ".join([*map(inline, others), f"{escape(before)}{link(row.target, self.contract.page_of(row.target))}"])

    def row(self, row: Row) -> List[str]:
        default = '<span class="required">required</span>' if row.required else f"<code>{escape(row.default)}</code>" if row.default is not None else ""
        return [f"<code>{escape(row.name)}</code>", self.type_cell(row), inline(row.unit), inline(row.range), default, inline(row.words)]

    def members(self, schema: Schema) -> str:
        rows = self.contract.schemas.rows(schema)
        return table(HEADS, map(self.row, rows)) if rows else "<p>It has no members.</p>\n"

    def rules(self, schema: Schema) -> str:
        """Shows the rules of a schema about which members exclude or need others, as JSON."""
        rules = {name: schema[name] for name in RULES if name in schema}
        if not rules:
            return ""
        return f"<details class=\"rules\"><summary>Rules between members</summary>\n{code(examples.as_json(rules), 'json')}</details>\n"

    def inner_types(self, schema: Schema, seen: Sequence[str]) -> Iterator[str]:
        """Yields the types of the members, and recursively those of their members, each once and without SHARED ones."""
        found = list(seen)
        for row in self.contract.schemas.rows(schema):
            if row.target and row.target not in (*found, *SHARED) and row.target in self.contract.types():
                found.append(row.target)
                yield row.target
                for inner in self.inner_types(self.contract.schemas.all[row.target], found):
                    found.append(inner)
                    yield inner

    # Commands

    def command(self, command: Command) -> str:
        parts = [f"<h1><code>{command.op}</code></h1>", f'<div class="lead">{paragraphs(command.schema["description"])}</div>']
        where = self.contract.schemas.where(command.schema)
        parts += [f"<p>{inline(where)}</p>"] if where else []
        if command.op in self.pictures:
            file, own = self.pictures[command.op]
            parts.append(f'<figure><img src="{escape(file)}" alt="{escape(command.op)}: before and after" loading="lazy">'
                         f"<figcaption>{CAPTIONS[own]}</figcaption></figure>")
        parts.append('<h2 id="example">Example</h2>')
        parts.append(self.samples(command.op, [("JSON", examples.as_json(command.example), "json"), ("Command line", examples.command_cli(command.example), "shell"),
                                               ("Python", examples.command_python(command.example), "python")]))
        parts.append(f"<p>Over HTTP the JSON is the body of {link('runCommands', group_page('commands') + '#runCommands')}; a list "
                     "<code>commands</code> runs several as one undo step.</p>")
        parts += ['<h2 id="members">Members</h2>', self.members(command.schema), self.rules(command.schema)]
        for name in self.inner_types(command.schema, ()):
            schema = self.contract.schemas.all[name]
            parts += [f'<h3 id="{name.lower()}">{link(name, self.contract.page_of(name))}</h3>', paragraphs(schema["description"]), self.forms(schema)]
        return "\n".join(parts)

    @staticmethod
    def samples(name: str, each: Sequence[Tuple[str, str, str]]) -> str:
        """Shows code samples as tabs, one open at a time. `name`: a name for the tabs, unique on the page."""
        shown = [one for one in each if one[1]]
        heads = "".join(f'<input type="radio" name="{name}" id="{name}-{kind}"{" checked" if k == 0 else ""}><label for="{name}-{kind}">{escape(title)}</label>'
                        for k, (title, _, kind) in enumerate(shown))
        return f'<div class="tabs">{heads}\n' + "".join(code(text, kind) for _, text, kind in shown) + "</div>\n"

    # Operations

    def group(self, group: str) -> str:
        operations = [operation for operation in self.contract.operations if operation.group == group]
        rows = [[f'<a href="#{one.id}"><code>{one.id}</code></a>', f'<span class="method {one.method.lower()}">{one.method}</span> '
                 f"<code>{escape(one.path)}</code>", inline(one.about["summary"])] for one in operations]
        parts = [f"<h1>{escape(group.capitalize())}</h1>", f'<div class="lead">{paragraphs(self.contract.groups[group])}</div>',
                 table(("Operation", "Request", "What it does"), rows, "overview")]
        if group == "commands":
            parts.append(f"<p>Each of the {len(self.contract.commands)} commands has {link('a page of its own', 'index.html#commands')}.</p>")
        return "\n".join([*parts, *map(self.operation, operations)])

    def operation(self, operation: Operation) -> str:
        about = operation.about
        parts = [f'<section class="operation"><h2 id="{operation.id}">{escape(operation.id)}</h2>',
                 f'<p class="address"><span class="method {operation.method.lower()}">{operation.method}</span> <code>{address_text(operation.path)}</code></p>',
                 f'<p class="summary">{inline(about["summary"])}</p>', paragraphs(about["description"])]
        if operation.parameters:
            parts += ["<h3>Parameters</h3>", table(("Parameter", "In", *HEADS[1:]), map(self.parameter, operation.parameters))]
        if operation.body_types():
            needed = "" if about["requestBody"].get("required") else " It may be left out."
            parts += ["<h3>Request</h3>", "<p>" + " or ".join(f"{self.schema_words(media['schema'])} as <code>{kind}</code>"
                                                                for kind, media in operation.body_types().items()) + f".{needed}</p>"]
        parts += ["<h3>Answers</h3>", table(("Status", "Holds", "Headers", "Meaning"), self.answers(operation), "answers"), "<h3>Example</h3>",
                  self.operation_samples(operation), "</section>"]
        return "\n".join(parts)

    def operation_samples(self, operation: Operation) -> str:
        client = self.clients[operation.id]
        none = f'<p class="none">{inline(client["none"])}</p>\n' if "none" in client else ""
        return self.samples(f"with-{operation.id}", [("HTTP", examples.curl(operation), "http"), ("Command line", client.get("cli", ""), "shell"),
                                                     ("Python", examples.operation_python(client["python"]), "python")]) + none

    def parameter(self, one: Dict[str, Any]) -> List[str]:
        own = {**one["schema"], "description": one["description"]}
        cells = self.row(self.contract.schemas.row(one["name"], own, one.get("required", False)))
        return [cells[0], one["in"], *cells[1:]]

    def answers(self, operation: Operation) -> Iterator[List[str]]:
        for status, given in operation.about["responses"].items():
            answer = self.contract.component(given)
            kinds: Dict[str, List[str]] = {}
            for kind, media in answer.get("content", {}).items():
                kinds.setdefault(self.schema_words(media["schema"]), []).append(f"<code>{kind}</code>")
            holds = "<br>".join(f"{words}: {', '.join(each)}" if words not in ("Text", "Bytes") else ", ".join(each) for words, each in kinds.items())
            headers = ", ".join(f"<code>{name}</code>" for name in answer.get("headers", {}))
            words = " ".join(f"{inline(answer['description'])}".split())
            yield [f"<code>{'any other' if status == 'default' else status}</code>", holds, headers, words]

    def schema_words(self, schema: Schema) -> str:
        """Names a schema in a word or two, as HTML."""
        if name_of(schema):
            return link(name_of(schema), self.contract.page_of(name_of(schema)))
        if "oneOf" in schema:
            return " or ".join(map(self.schema_words, schema["oneOf"]))
        return "Bytes" if schema.get("format") == "binary" else "Text" if schema.get("type") == "string" else "JSON"

    # Types

    def type(self, name: str, schema: Schema) -> str:
        parts = [f"<h1>{escape(name)}</h1>", f'<div class="lead">{paragraphs(schema["description"])}</div>']
        parts += ['<h2 id="members">Members</h2>' if self.contract.schemas.has_members(schema) and "discriminator" not in schema else "", self.forms(schema)]
        if "examples" in schema:
            parts += ['<h2 id="example">Example</h2>', code(examples.as_json(schema["examples"][0]), "json")]
        users = self.contract.users_of(name)
        if users:
            parts += ['<h2 id="used">Used by</h2>', '<p class="users">' + " ".join(link(f"`{user}`", to) for user, to in users.items()) + "</p>"]
        return "\n".join(parts)

    def forms(self, schema: Schema) -> str:
        """Shows a table of members for each form of a type; for a type without members, its type, unit, range and pattern."""
        if "discriminator" in schema:
            return '<p class="users">' + " ".join(link(f"`{op}`", f"{op}.html") for op in schema["discriminator"]["mapping"]) + "</p>"
        if "properties" in schema:
            return self.members(schema) + self.rules(schema)
        each = [one for one in schema.get("oneOf", []) if "properties" in one]
        if each:
            return "<p>or</p>\n".join(map(self.members, each))
        if "type" in schema and schema["type"] == "object":
            return "<p>It has no members.</p>\n"
        kind, unit, range_ = KNOWN["Colour"] if "oneOf" in schema else self.contract.schemas.parts(schema)
        rows = [[inline(kind), inline(unit), inline(range_), f"<code>{escape(schema['pattern'])}</code>" if "pattern" in schema else ""]]
        return table(("Type", "Unit", "Range", "Pattern"), rows, "plain")

    # The first page

    def index(self) -> str:
        info = self.contract.document["info"]
        parts = ["<h1>Pelage reference</h1>", f'<div class="lead">{paragraphs(info["summary"])}</div>', paragraphs(info["description"]),
                 f"<p>Made from {link('/openapi.json', '../openapi.json')}, the contract of this server: {len(self.contract.commands)} commands, "
                 f"{len(self.contract.operations)} operations, {len(self.contract.types())} types.</p>", '<h2 id="commands">Commands</h2>']
        by_op = {command.op: command for command in self.contract.commands}
        for title, ops in GROUPS.items():
            parts.append(f"<h3>{escape(title)}</h3>\n" + table(("Command", "What it does"), (
                [link(f"`{op}`", f"{op}.html"), inline(first_sentence(by_op[op].schema["description"]))] for op in ops), "overview"))
        parts += ['<h2 id="operations">Operations</h2>', table(("Group", "Operations", "What it is about"), (
            [link(group.capitalize(), group_page(group)), " ".join(link(f"`{one.id}`", f"{group_page(group)}#{one.id}") for one in self.contract.operations if one.group == group),
             inline(words)] for group, words in self.contract.groups.items()), "overview")]
        parts += ['<h2 id="units">Units</h2>', table(("Unit", "What it is"), ([inline(unit), inline(words)] for unit, words in UNITS.items()), "overview")]
        types = " ".join(link(f"`{name}`", self.contract.page_of(name)) for name in sorted(self.contract.types()))
        return "\n".join([*parts, '<h2 id="types">Types</h2>', f'<p class="users">{types}</p>'])


def read_pictures(folder: pathlib.Path) -> Dict[str, Tuple[str, bool]]:
    """Finds pictures by op, and whether they show the command's example: settings do, tools show the recipe of their page."""
    return {path.stem: (path.name, path.stem in GROUPS["Coat, body and light"]) for path in sorted(folder.glob("*.jpg"))}
