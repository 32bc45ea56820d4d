"""What a code means: of a diagnostic, a rule, a claim, an assumption, or a principle; the keys of the language, and the
pages by their names."""

from __future__ import annotations

import re
from importlib import resources

from interlock.dataclass import dataclass
from interlock.diag.codes import CODES
from interlock.frontend.published import WITHOUT, language_keys
from interlock.frontend.schema import LayoutFile
from interlock.logic.plant import ASSUMPTIONS, OF_PLC
from interlock.model.principles import MEANING, PROFILES, written
from interlock.proof.claims import CLAIMS
from interlock.proof.functions import FUNCTIONS

LEVELS = {
    "T": "It is claimed of trains, whatever the controller shows",
    "S": "It is claimed of signals and requests",
    "L": "It is claimed of locks",
    "P": "It is claimed of points and of what drives them",
    "I": "It is claimed of indications and alarms",
    "D": "It is claimed of delays",
}


@dataclass(frozen=True)
class Topic:
    """Something that can be explained; `severity` of a diagnostic alone."""

    code: str
    kind: str
    title: str
    severity: str | None = None


def topics() -> tuple[Topic, ...]:
    """All of them, kind by kind."""
    pages = {p.name[:-3]: p for p in _docs("rules").iterdir() if re.fullmatch(r"R\d+\.md", p.name)}
    rules = sorted(pages, key=lambda r: int(r[1:]))
    headings = {r: pages[r].read_text("utf-8").split("\n")[0].removeprefix(f"# {r} ") for r in rules}
    return (
        *(Topic(code, "diagnostic", title, str(severity)) for code, (severity, title) in sorted(CODES.items())),
        *(Topic(r, "rule", headings[r]) for r in rules),
        *(Topic(code, "claim", sentence) for code, sentence in CLAIMS.items()),
        *(Topic(code, "function", sentence) for code, sentence in FUNCTIONS.items()),
        *(Topic(code, "assumption", sentence) for code, sentence in (ASSUMPTIONS | OF_PLC).items()),
        *(Topic(code, "principle", told) for code, told in MEANING.items()),
        *(Topic(key, "key", told) for key, told in _keys().items()),
        Topic("rules", "page", _docs("rules/README.md").read_text("utf-8").split("\n")[0].removeprefix("# ")),
        *(Topic(p.name[:-3], "page", p.read_text("utf-8").split("\n")[0].removeprefix("# ")) for p in _pages()),
    )


def _pages() -> list[resources.abc.Traversable]:
    """The pages for whoever uses interlock, as they are installed with it."""
    found = [p for p in _docs("").iterdir() if p.name.endswith(".md") and p.name not in ("house.md", "decisions.md")]
    return sorted(found, key=lambda p: p.name)


def topic(code: str) -> Topic | None:
    """What a code names, in capitals or not; R6.2 is explained where R6 is."""
    wanted = code.lower()
    if re.fullmatch(r"r\d+\.\d+", wanted):
        wanted = wanted.split(".")[0]
    return next((t for t in topics() if t.code.lower() == wanted), None) or _inner(wanted)


def explain(code: str) -> str | None:
    """The page of a code; None when it names nothing."""
    found = topic(code)
    if found is None:
        return None
    if found.kind == "diagnostic":
        return _docs(f"codes/{found.code}.md").read_text("utf-8")
    if found.kind == "rule":
        return _docs(f"rules/{found.code}.md").read_text("utf-8")
    if found.kind == "page":
        return _docs("rules/README.md" if found.code == "rules" else f"{found.code}.md").read_text("utf-8")
    return f"# {found.code}, {_ARTICLE[found.kind]} {found.kind}\n\n{_page(found)}"


_ARTICLE = {"claim": "a", "function": "a", "assumption": "an", "principle": "a", "key": "a"}


def _keys() -> dict[str, str]:
    """Every key of a layout, with its meaning."""
    return {n: str(x.description).partition(WITHOUT)[0] for n, x in LayoutFile.model_fields.items()}


def _rows(word: str) -> list[tuple[str, str, str]]:
    """Where a word is a key of what stands in a key of the layout: that key, the heading of the table, its row."""
    return [
        (key, table.partition("\n")[0], row)
        for key, tables in _tables().items()
        for table in tables
        for row in table.split("\n")
        if row.lower().startswith(f"| `{word.lower()}` |")
    ]


def _inner(word: str) -> Topic | None:
    """A key of what stands in keys of the layout, with what it means in the first of them."""
    rows = _rows(word)
    if not rows:
        return None
    cells = rows[0][2].strip("| ").split(" | ")
    return Topic(cells[0].strip("`"), "key", cells[-1])


def _inner_page(found: Topic) -> str:
    """What a key means in each key of the layout in which it stands, and what else tells of it."""
    rows = _rows(found.code)
    keys = list(dict.fromkeys(key for key, _, _ in rows))
    parts = [f"`{found.code}` is a key of {', '.join(f'`{key}`' for key in keys)}."]
    for heading in dict.fromkeys(heading for _, heading, _ in rows):
        table = "\n".join(["| key | value | without it | meaning |", "|---|---|---|---|"])
        parts.append(f"## {heading}\n\n{table}\n" + "\n".join(dict.fromkeys(r for _, h, r in rows if h == heading)))
    parts += [f"For instance `{key}: {entry}`." for key in keys if f"{found.code}:" in (entry := _example(key))]
    told = re.compile(rf"`{found.code}\b")
    others = [t.code for t in topics() if t.kind in ("rule", "diagnostic")]
    more = [code for code in others if told.search(explain(code) or "")]
    parts += [f"More: {', '.join(f'`interlock explain {code}`' for code in (*more, *keys))}."]
    return "\n\n".join(parts) + "\n"


def _tables() -> dict[str, list[str]]:
    """By key of a layout the tables of what stands in it: `overlaps` with `overlaps.ways`."""
    found: dict[str, list[str]] = {}
    for part in language_keys().split("### ")[1:]:
        for key in dict.fromkeys(re.findall(r"`(\w+)(?:\.\w+)?`", part.partition("\n")[0])):
            found.setdefault(key, []).append(part.strip())
    return found


def _key_page(found: Topic) -> str:
    """What a key of a layout means, an example, and the tables of what stands in it."""
    entry = _example(found.code)
    parts = [f"{found.title[0].upper()}{found.title[1:]}.", f"For instance `{found.code}: {entry}`." if entry else ""]
    parts += [f"## {x}" for x in _tables().get(found.code, ())]
    return "\n\n".join([*(p for p in parts if p), "`interlock explain language` has the whole language."]) + "\n"


def _example(key: str) -> str:
    """The example of a key of the layout that the page of the language shows."""
    page = _docs("language.md").read_text("utf-8")
    shown = re.search(rf"^\| `{key}` \| `(.+)` \|$", page, re.MULTILINE)
    entry = shown[1] if shown else ""
    if re.match(r"[^\[{:]+: ", entry):  # entries with names, which the table shows without braces
        entry = f"{{{entry}}}"
    return entry


def _page(found: Topic) -> str:
    if found.kind == "key":
        return _key_page(found) if found.code in LayoutFile.model_fields else _inner_page(found)
    if found.kind == "claim":
        return (
            f"{found.title}\n\n{LEVELS[found.code[0]]}, for every state that the controller and the trains can reach "
            "together.  `interlock prove LAYOUT` says at how many places of the layout it has something to claim, and "
            "its verdict; a refuted one is told as a story.\n"
        )
    if found.kind == "function":
        return (
            f"{found.title}\n\nIt is what the controller must do, where claims say what it must never do.  It is "
            "proved of every shipped layout by the tests, and asked by `interlock mutate`; `interlock prove` does not "
            "ask it.\n"
        )
    if found.kind == "assumption":
        besides = _docs("proof.md").read_text("utf-8").partition(f"- **{found.code}**: {found.title}")[2]
        return (
            f"{found.title}{besides.partition(chr(10))[0]}\n\n"
            "Every claim is proved under this assumption and the others (`interlock explain` lists them): where it "
            "does not hold on the ground, nothing that rests on it is proved.\n"
        )
    values = [f"| {profile} | {written(getattr(p, found.code))} |" for profile, p in PROFILES.items()]
    table = "\n".join(["| profile | value |", "|---|---|", *values])
    told = found.title[0].upper() + found.title[1:]
    return f"{told}.\n\n{table}\n\nA layout overrides it: `principles: {{{found.code}: ...}}`.\n"


def _docs(name: str) -> resources.abc.Traversable:
    return resources.files("interlock").joinpath(f"docs/{name}")
