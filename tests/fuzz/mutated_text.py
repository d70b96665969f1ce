"""mutated_text.py - a text with a few errors in it, as hands and programs make them (for mutations.py)."""

import re

NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?(?![\w.])")
WORD = re.compile(r"[A-Za-z_][A-Za-z_0-9]*")
QUOTED = re.compile(r"\"[^\"\n]*\"|'[^'\n]*'")

NUMBERS = ["0", "-0.0", "1", "-1", "2", "3", "7", "0.5", "-0.001", "1e-3", "1e-9", "1e-300", "1e5", "1e10", "1e18",
           "1e300", "-1e300", "1e999", "nan", "inf", "-inf", "100000", "999999999", "2147483648", "4294967296",
           "9007199254740993", "9223372036854775807", "9223372036854775808", "-9223372036854775808", "0x10", "1_000",
           "1.", ".5", "+3", "1e", "--1", "1,5", "1979-05-27", "true"]
TEXTS = ["", " ", "*", "?", ".", "..", "/", "/dev/zero", "/dev/null", "/proc/self/mem", "none", "nothing", "a" * 300,
         "[", "{}", "%s%n", "{}{0}", "\\u0000", "\\n", "\\t", "é", "名", "field", "ball", "ground", "-", "--json",
         "r1.r1", "world", "null"]
PIECES = ["[", "]", "{", "}", "\"", "'", "=", ",", ".", "#", "<", ">", "/", "/>", "<!--", "-->", "\n", "\0", "\x1b",
          "\xff", "=[", "[[", "]]", "\"\"\"", "&lt;", "&#0;", "- ", ": ", "\t", " ", "\r\n", "1", "-", "e"]


def swap_number(rng, text):
    return _replace_one(rng, text, NUMBER, lambda _: rng.choice(NUMBERS))


def scale_numbers(rng, text):
    """Numbers that are still numbers of their kind, some of them far off: these get past the readers."""
    factor = rng.choice([0, -1, 0.5, 2, 1e-3, 1e3, 1e-6, 1e6, 1e-12, 1e12])
    share = rng.choice([0.02, 0.02, 0.1, 0.5, 1])

    def scaled(match):
        return f"{float(match.group()) * factor:.6g}" if rng.random() < share else match.group()

    return NUMBER.sub(scaled, text)


def swap_quoted(rng, text):
    others = QUOTED.findall(text)

    def other(match):
        quote = match.group()[0]
        return rng.choice(others) if rng.random() < 0.5 else quote + rng.choice(TEXTS) + quote

    return _replace_one(rng, text, QUOTED, other)


def swap_word(rng, text):
    words = WORD.findall(text)
    return _replace_one(rng, text, WORD, lambda _: rng.choice(words) if words else "x")


def misspell(rng, text):
    def slip(match):
        word = match.group()
        at = rng.randrange(len(word))
        return rng.choice([word[:at] + word[at + 1:], word[:at] + word[at:at + 1] * 2 + word[at + 1:], word.upper()])

    return _replace_one(rng, text, WORD, slip)


def drop_lines(rng, text):
    lines = text.split("\n")
    at = rng.randrange(len(lines))
    del lines[at:at + rng.choice([1, 1, 1, 2, 5])]
    return "\n".join(lines)


def repeat_lines(rng, text):
    lines = text.split("\n")
    at = rng.randrange(len(lines))
    count = rng.choice([1, 1, 2, 5, 12])
    to = rng.randrange(len(lines) + 1)
    return "\n".join(lines[:to] + lines[at:at + count] * rng.choice([1, 1, 2]) + lines[to:])


def move_lines(rng, text):
    lines = text.split("\n")
    at, to = rng.randrange(len(lines)), rng.randrange(len(lines))
    lines[at], lines[to] = lines[to], lines[at]
    return "\n".join(lines)


def insert_piece(rng, text):
    at = rng.randrange(len(text) + 1)
    return text[:at] + rng.choice(PIECES) * rng.choice([1, 1, 1, 3, 100]) + text[at:]


def drop_piece(rng, text):
    at = rng.randrange(len(text) + 1)
    return text[:at] + text[at + rng.choice([1, 1, 2, 10, 100]):]


def cut_off(rng, text):
    return text[:rng.randrange(len(text) + 1)]


def nest_deep(rng, text):
    """Thousands of brackets, dots or elements where a value stands."""
    depth = rng.choice([20, 300, 5000, 50000])
    deep = rng.choice(["[" * depth, "[" * depth + "]" * depth, "{a=" * depth, "a." * depth + "a = 1",
                       "[" + "a." * depth + "a]", "<body>" * depth, "<link>" * depth + "</link>" * depth, "- " * depth,
                       "(" * depth])
    return _replace_one(rng, text, NUMBER, lambda _: deep) if rng.random() < 0.5 else deep + "\n" + text


def flip_byte(rng, text):
    if not text:
        return text
    at = rng.randrange(len(text))
    return text[:at] + chr(ord(text[at]) ^ (1 << rng.randrange(7))) + text[at + 1:]


MUTATORS = [(swap_number, 12), (scale_numbers, 8), (swap_quoted, 8), (swap_word, 5), (misspell, 4), (drop_lines, 5),
            (repeat_lines, 4), (move_lines, 2), (insert_piece, 3), (drop_piece, 3), (cut_off, 1), (nest_deep, 1),
            (flip_byte, 2)]


def mutated(rng, text):
    """`text` with one to five errors; mostly one, because the first one hides those behind it."""
    kinds, weights = zip(*MUTATORS, strict=True)
    for kind in rng.choices(kinds, weights, k=rng.choice([1, 1, 1, 1, 2, 2, 3, 5])):
        text = kind(rng, text)
    return text


def mutated_bytes(rng, data):
    data = bytearray(data)
    for _ in range(rng.choice([1, 1, 2, 10])):
        if data:
            data[rng.randrange(len(data))] = rng.choice([0, 1, 0x7F, 0x80, 0xFF, rng.randrange(256)])
    return bytes(data[:rng.randrange(len(data) + 1)] if rng.random() < 0.2 else data)


def _replace_one(rng, text, pattern, replacement):
    found = list(pattern.finditer(text))
    if not found:
        return text
    match = rng.choice(found)
    return text[:match.start()] + replacement(match) + text[match.end():]
