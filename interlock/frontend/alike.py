"""Names that look alike: on a screen or a drawing one is taken for the other.

Output: warnings IL7010.  A layout may mean it so: `allow`, with a reason.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable

from interlock.diag import Element, Span
from interlock.diag.called import called
from interlock.frontend.context import Context

# letters of other alphabets that are drawn as Latin ones (Unicode Technical Standard 39 names many more)
_CYRILLIC = dict(
    zip(
        "\u0410\u0412\u0415\u0405\u0406\u0408\u041a\u041c\u041d\u041e\u0420\u0421\u0422\u0425\u0423\u0417\u04c0"
        "\u0430\u0435\u043e\u0440\u0441\u0445\u0443\u0456\u0458\u0455",
        "ABESIJKMHOPCTXY3Iaeopcxyijs",
        strict=True,
    )
)
_GREEK = dict(
    zip(
        "\u0391\u0392\u0395\u0396\u0397\u0399\u039a\u039c\u039d\u039f\u03a1\u03a4\u03a5\u03a7\u03bf\u03bd",
        "ABEZHIKMNOPTYXov",
        strict=True,
    )
)
_OTHERS = dict(
    zip(
        "\u03b1\u03b9\u03c1\u03c3\u03c5\u03f2\u03f3"  # Greek
        "\u051a\u051b\u051c\u051d\u0501\u04bb\u04cf\u04ae\u0474\u0475"  # Cyrillic
        "\u0555\u054f\u054d\u0585\u057d\u0578\u0570\u0566\u0581\u0575"  # Armenian
        "\u13a0\u13a1\u13a2\u13aa\u13ab\u13ac\u13b3\u13b7\u13bb\u13c0"  # Cherokee
        "\u13c3\u13ce\u13d2\u13d9\u13da\u13de\u13df\u13e2\u13e6\u13f4"
        "\u0131\u0251\u0261\ua7b3"  # Latin
        "\u0661\u06f1\u0665\u06f5\u0966\u09e6",  # digits
        "aipoucjQqWwdhlYVvOSUounhqgjDRTAJEWMHGZ4RVSLCPKBiagX11oooo",
        strict=True,
    )
)
_KANA = dict(
    zip(
        "\u30a8\u30ab\u30bf\u30c1\u30c8\u30cb\u30cf\u30ed\u3078\u308a\u30fc",
        "\u5de5\u529b\u5915\u5343\u535c\u4e8c\u516b\u53e3\u30d8\u30ea\u4e00",
        strict=True,
    )
)
"""Letters of Japanese drawings, and the ones of Chinese ones that look like them."""
_LATIN = str.maketrans(_OTHERS | _KANA | _CYRILLIC | _GREEK)
_DRAWN = str.maketrans("OIl", "011")


def latin(name: str) -> str:
    """A name in the letters as which it is drawn: full-width signs as narrow ones, look-alikes of others as Latin."""
    return unicodedata.normalize("NFKC", name).translate(_LATIN)


def drawn(name: str) -> str:
    """What two names have in common that look alike."""
    return latin(name).translate(_DRAWN)


def _keys(name: str) -> list[str]:
    """The texts of which names that look alike have one in common: a space may look like none, or like a `_`."""
    text = drawn(name)
    return [text.replace(" ", sign) for sign in ("", "_")] if " " in text else [text]


def _close(name: str) -> str:
    """A name in the letters as which it is drawn, without spaces."""
    return latin(name).replace(" ", "")


def numerals(a: str, b: str) -> bool:
    """Whether two names differ in Roman and Arabic numbers of tracks alone: SII of track II, S11 of track 11."""
    if len(a) != len(b):
        return False
    differ = [i for i, pair in enumerate(zip(a, b, strict=True)) if pair[0] != pair[1]]
    runs = [(_run(a, i), _run(b, i), {a[i], b[i]}) for i in differ]
    return bool(runs) and all(x is not None and x == y and signs == {"I", "1"} for x, y, signs in runs)


def _run(name: str, at: int) -> tuple[int, int] | None:
    """From where to where a sign is repeated; None where it stands alone."""
    first, last = at, at
    while first and name[first - 1] == name[at]:
        first -= 1
    while last + 1 < len(name) and name[last + 1] == name[at]:
        last += 1
    return (first, last) if last > first else None


def check_alike(ctx: Context, elements: Iterable[tuple[str, str, Span]]) -> None:
    """Report each name that looks like an earlier one of its kind.  Upper and lower case are told apart elsewhere."""
    seen: dict[tuple[str, str], list[tuple[str, Span]]] = {}
    for kind, name, span in elements:
        groups = [seen.setdefault((kind, key), []) for key in _keys(name)]
        before = [x for group in groups for x in group]
        alike = next(
            (x for x in before if x[0].lower() != name.lower() and not numerals(_close(x[0]), _close(name))), None
        )
        for group in groups:
            group.append((name, span))
        if alike is not None:
            ctx.add(
                "IL7010",
                f"the {called(kind, name)} looks like the {called(kind, alike[0])} of line {alike[1].line}"
                f"{_difference(name, alike[0])}",
                span,
                "rename one of them, so that nobody takes one for the other",
                about=Element({"boundary": "boundaries"}.get(kind, f"{kind.replace(' ', '_')}s"), name),
                cause=f"{kind} {name}",
            )


def _difference(a: str, b: str) -> str:
    """The first sign in which two names of one length differ, by its names."""
    for x, y in zip(a, b, strict=False):
        if x != y:
            return f": {_sign(x)} here, {_sign(y)} there"
    return ""


def _sign(sign: str) -> str:
    return unicodedata.name(sign, f"U+{ord(sign):04X}").lower()
