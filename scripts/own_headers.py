"""Which header of the project declares which name: scripts/check_includes.py looks whether the files that use it include it.

Reads C++ as the project's format has it, without a compiler: what stands at namespace scope in a header is declared there,
and a file that uses such a name includes, directly or not, a header that mentions it. Members, and names that a file declares
itself, are not looked for. So most missing includes are found (CONTRIBUTING.md says how many) that sources compiled as one hide;
`scripts/check_clang --all` finds the others.
"""

import itertools
import re

not_code = re.compile(r'//[^\n]*|/\*.*?\*/|R"([^(\s]*)\(.*?\)\1"|"(?:[^"\\\n]|\\.)*"|(?<!\w)\'(?:[^\'\\\n]|\\.)+\''
                      r'|^[ \t]*#[^\n]*', re.DOTALL | re.MULTILINE)
token = re.compile(r"(?P<word>[A-Za-z_]\w*)|::|->|\d[\w.']*|[^\s\w]")
macro = re.compile(r"^#\s*define (\w+)", re.MULTILINE)
others_header = re.compile(r"^#include <(?:.*/)?(\w+)\.h(?:pp)?>", re.MULTILINE)  # often named after what it declares
system_header = re.compile(r"^#include <(?:(?:sys|net|netinet|arpa)/)?\w+\.h>", re.MULTILINE)
keywords = {"and", "auto", "case", "co_return", "co_yield", "const", "decltype", "delete", "else", "new", "not", "or",
            "return", "sizeof", "throw"}
classes = ("class", "struct", "enum", "union")
specifiers = {"inline", "constexpr", "static", "extern", "final", "template"}
overloads = 4  # in more headers: found by its arguments
tests = {"TEST", "TEST_F", "TEST_P", "INSTANTIATE_TEST_SUITE_P"}


def code_of(text):
    """The text without comments, literals and directives, with the same lines."""
    return not_code.sub(lambda found: "\n" * found[0].count("\n") or " ", text)


def words_of(text):
    """(word or sign, line number) of each one in the code."""
    return [(found[0], number) for number, line in enumerate(code_of(text).splitlines(), 1) for found in token.finditer(line)]


def without_arguments(words):
    """Words outside of <...> and [[...]]."""
    depth, left = 0, []
    for before, word in itertools.pairwise(["", *words]):
        if word == "[" or (word == "<" and (before == "template" or before.isidentifier())):
            depth += 1
        elif depth and word in ("]", ">"):
            depth -= 1
        elif not depth:
            left.append(word)
    return [word for word in left if word not in specifiers]


def name_declared_by(statement, ends_in_block):
    """The name that a statement at namespace scope defines; None where it defines none (a class that is only announced)."""
    words = without_arguments(statement)
    if len(words) < 2 or words[0] in ("namespace", "friend", "static_assert") or "operator" in words:
        return None
    if words[0] == "using":
        return words[1] if words[2:3] == ["="] else None
    if words[0] == "concept":
        return words[1]
    if words[0] in classes:
        name, *rest = [word for word in words if word not in classes]
        if not rest or rest[0] == ":":
            return name if ends_in_block or rest else None
    last = next((at for at, word in enumerate(words) if word in ("(", "=")), len(words)) - 1
    return words[last] if last > 0 and words[last].isidentifier() else None


def declared_in(words):
    """(name, innermost namespace) of what is declared at namespace scope."""
    found, statement, spaces, depth, parentheses = set(), [], [""], 0, 0
    for word in words:
        parentheses += {"(": 1, ")": -1}.get(word, 0)
        if word == "{" and not depth and not parentheses and "namespace" in statement[:2]:
            spaces.append(statement[-1])
            statement = []
        elif word == "{":
            if not depth:
                found.add((name_declared_by(statement, True), spaces[-1]))
            depth += 1
        elif word == "}" and depth:
            depth -= 1
        elif word == "}":
            spaces = spaces[:-1] or [""]
        elif not depth and word == ";" and not parentheses:
            found.add((name_declared_by(statement, False), spaces[-1]))
            statement = []
        elif not depth:
            statement.append(word)
    return {(name, space) for name, space in found if name}


def is_member(before):
    """Whether a word after these is a member of something, or names a test: TEST(Word, Word)."""
    return before[-1] in (".", "->") or bool(tests & {before[-2], before[-4]})


def is_declared(before, word, after):
    """Whether a file declares a word itself, here."""
    last = before[-1]
    if last in classes or last in ("typename", "namespace", "concept") or (last == "using" and after == "="):
        return True
    if word[0].isupper() or last == "::":
        return False
    is_type = (last.isidentifier() and last not in keywords) or last == ">" or before[-3:] == ["auto", "&", "&"] or (
        last in ("&", "*") and (before[-2].isidentifier() or before[-2] == ">"))
    return is_type or after in ("=", "{", ":")


def name_of(key):
    return key if isinstance(key, str) else key[1]


class OwnHeaders:
    """Names of the headers in `texts` (path -> text), and where the other files of it use them."""

    def __init__(self, texts):
        self.headers_of = {}  # by name, and by (namespace, name)
        self.words = {path: words_of(text) for path, text in texts.items()}
        self.named = {path: {word for word, _ in words} for path, words in self.words.items()}
        self.macros = {path: set(macro.findall(text)) for path, text in texts.items()}
        self.others = {path: set(others_header.findall(text)) for path, text in texts.items()}
        self.calls_the_system = {path for path, text in texts.items() if system_header.search(text)}
        for path in (path for path in texts if path.endswith(".h")):
            for name, space in declared_in([word for word, _ in self.words[path]]) | {(name, "") for name in self.macros[path]}:
                for key in (name, (space, name)):
                    self.headers_of.setdefault(key, set()).add(path)

    def key_of(self, before, word, after, part):
        """The key in headers_of of a word that a file in a part of the project uses; None of any other word."""
        key = (before[-2], word) if before[-1] == "::" else word
        known = self.headers_of.get(key, ())
        headers = [header for header in known if header.partition("/")[0] in ("murosimf", "include", part)]
        if not headers or word in keywords or is_member(before) or before[-4:-2] == ["std", "::"]:
            return None
        if word.isupper() and after != "(":
            return None  # an enumerator
        if not word[0].isupper() and ((after != "(" and key == word) or len(headers) > overloads):
            return None
        return key

    def used_by(self, path):
        """Keys of what the file uses and does not declare itself, each with its first line."""
        part, used, declared = path.partition("/")[0], {}, self.macros[path] | self.others[path]
        bare = ["", "", "", "", *(word for word, _ in self.words[path]), ""]
        for at, (word, line) in enumerate(self.words[path]):
            before, after = bare[at:at + 4], bare[at + 5]
            if word not in self.headers_of:
                continue
            if is_declared(before, word, after):
                declared.add(word)
            elif path in self.calls_the_system and before[-1] != "::" and word.islower():
                continue  # read() of <unistd.h>, not that of a header
            elif key := self.key_of(before, word, after, part):
                used.setdefault(key, line)
        return {key: line for key, line in used.items() if name_of(key) not in declared}

    def missing(self, path, reached):
        """Yields (line number, message) of names that the file uses, and no file mentions that it reaches."""
        others = reached - {path}
        for key, line in self.used_by(path).items():
            name = name_of(key)
            if not self.headers_of[key] & reached and not any(name in self.named.get(other, ()) for other in others):
                yield line, f"{name} is used, {' or '.join(sorted(self.headers_of[key])[:3])} not included"
