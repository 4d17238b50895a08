"""The faults that tests/mutate puts in: what they are, where in a C++ source they can be, and which to take."""

import random
import re
from collections import defaultdict, namedtuple

TOKEN = re.compile(r"""(?P<gap>\s+|//[^\n]*|/\*.*?\*/|\#(?:\\\n|[^\n])*)
    |(?P<string>R"(\w*)\(.*?\)\3"|"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])+')
    |(?P<number>\.?\d(?:'?\w|(?<=[eEpP])[+-]|\.)*)|(?P<word>[A-Za-z_]\w*)
    |(?P<mark><=>|<<=|>>=|->|::|\+\+|--|<<|>>|[-+*/%&|^<>=!]=|&&|\|\||.)""", re.S | re.X)
Token = namedtuple("Token", "kind text start end")
Fault = namedtuple("Fault", "file line kind start end new")

BOUNDS = {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}
NEGATED = {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "==": "!=", "!=": "=="}
OPPOSITE = {"+": "-", "-": "+", "+=": "-=", "-=": "+=", "*": "/", "/": "*", "*=": "/=", "/=": "*=", "&&": "||",
            "||": "&&", "true": "false", "false": "true", "min": "max", "max": "min", "cwiseMin": "cwiseMax",
            "cwiseMax": "cwiseMin", "++": "--", "--": "++"}
KINDS = {"+": "sum", "-": "sum", "*": "factor", "/": "factor", "&": "and, or", "|": "and, or"}
# No test can miss these, or nobody may: a wrong process killed, a wrong folder removed.
KEPT = {"assert", "assertNotRealtime", "static_assert", "reserve", "shrink_to_fit", "_mm_prefetch",
        "__builtin_prefetch", "Q_UNUSED", "kill", "remove_all", "setContentsMargins", "setSpacing", "addStretch",
        "addSpacing"}
# Nor is what stands in the brackets after these code that runs.
SPARED = KEPT | {"noexcept", "decltype", "sizeof", "alignas", "requires", "operator"}
NO_EXPRESSION = {"if", "for", "while", "switch", "do", "else", "return", "break", "case", "default", "try", "auto",
                 "public", "private", "protected", "template"}
# `if (a < b) b = a`: what is as good as the best so far may become it.
BEST_SO_FAR = re.compile(r"\b(\w+) [<>]=? (\w+)\b.*\b(\1 = \2|\2 = \1)\b")


class Source:
    """The tokens of a file, its brackets, and the faults that can be there. It relies on the format, which a test
    holds: `a < b` is a relation and `T<b>` a template, `a && b` an operation and `T&& b` a reference."""

    def __init__(self, name, text):
        self.name, self.text = name, text
        self.tokens = [Token(m.lastgroup, m[0], *m.span()) for m in TOKEN.finditer(text) if m.lastgroup != "gap"]
        self.words = [token.text for token in self.tokens] + [";"] # also what is before the first
        self.mate = {} # the other bracket
        self.inside = [] # the innermost open bracket
        self.role = {-1: "scope"} # of a brace: block, switch, list, or scope of a class or namespace
        self.bools = {-1: False} # of a block: its function returns a bool
        self.spared = set()
        self.pair_brackets()

    def pair_brackets(self):
        stack, templates = [-1], []
        for i, word in enumerate(self.words[:-1]):
            before = self.words[i - 1]
            if word in (")", "]", "}") and len(stack) > 1:
                o = stack.pop()
                self.mate[i], self.mate[o] = o, i
                if word == ")" and self.words[o - 1] in SPARED:
                    self.spared.update(range(o, i))
            self.inside.append(stack[-1])
            if word == "{":
                self.role[i], self.bools[i] = self.brace(i)
            if word in ("(", "[", "{"):
                stack.append(i)
            elif word == "<" and before != "operator" and (before == "template" or not self.gap(i)):
                templates.append(i)
            elif word in (">", ">>") and templates and not self.gap(i):
                self.spared.update(range(templates[-len(word):][0], i))
                del templates[-len(word):]
            elif word == ";":
                templates.clear()

    def gap(self, i):
        """Is there room before token i?"""
        return not 0 < i < len(self.tokens) or self.tokens[i - 1].end < self.tokens[i].start

    def line(self, i):
        return self.text[self.text.rfind("\n", 0, self.tokens[i].start) + 1:].partition("\n")[0]

    def brace(self, i):
        """The role of an open brace, and whether its function returns a bool."""
        before, bool_outside = self.words[i - 1], self.bools.get(self.inside[i], False)
        if before == ")" and (control := self.control(i - 1)):
            return "switch" if control == "switch" else "block", bool_outside
        if before in ("else", "do", "try"):
            return "block", bool_outside
        head, k = [], i - 1 # what leads to the brace, without what stands in brackets
        while k >= 0 and self.words[k] not in ("{", "}", ";", "(", "["):
            head.insert(0, self.words[k])
            k = (self.mate.get(k, k) if self.words[k] in (")", "]") else k) - 1
        head = " ".join(head)
        if result := re.search(r"[)\]] -> ([\w:<>*&, ]+)$", head):
            return "block", result[1] == "bool"
        if before in (")", "]", "const", "noexcept", "override", "mutable", "}"):
            return "block", bool(re.search(r"\bbool (?=\w)|\boperator bool ", head))
        if re.search(r"\b(namespace|class|struct|union|enum|extern)\b", head):
            return "scope", False
        if before in (";", ":") or before == "{" and self.role[i - 1] in ("block", "switch"):
            return "block", bool_outside
        return "list", False

    def control(self, i):
        """Which statement the round bracket that closes here belongs to, if to any."""
        o = self.mate.get(i, 0)
        word = self.words[o - 2 if self.words[o - 1] == "constexpr" else o - 1]
        return word if word in ("if", "for", "while", "switch") else None

    def faults(self):
        for i, token in enumerate(self.tokens):
            number = self.text.count("\n", 0, token.start) + 1
            if i not in self.spared:
                for kind, new in self.of_token(i):
                    yield Fault(self.name, number, kind, token.start, token.end, new)
            if self.starts_statement(i):
                for kind, first, last, new in self.of_statement(i):
                    yield Fault(self.name, number, kind, self.tokens[first].start, self.tokens[last].end, new)

    def of_token(self, i):
        kind, word, *_ = self.tokens[i]
        before, after, spaced = self.words[i - 1], self.words[i + 1], self.gap(i) and self.gap(i + 1)
        # What a member begins with is mostly overwritten, and = 0 makes a function abstract.
        begins = before == "=" and self.role.get(self.inside[i]) == "scope" and word in ("0", "0.0", "false")
        if before == "operator" or begins or kind == "string":
            return
        if kind == "number":
            yield from (("constant", new) for new in constants(word, before == "-"))
        elif word in ("true", "false"):
            yield "true, false", OPPOSITE[word]
        elif kind == "word" and word in OPPOSITE and after == "(" and (before == "return" or not before[0].isalpha()):
            yield "min, max", OPPOSITE[word]
        elif word in NEGATED and spaced:
            yield "relation", NEGATED[word]
            to_float = re.search(r"\d[.e]", before + " " + after)
            if word in BOUNDS and not to_float and not BEST_SO_FAR.search(self.line(i)):
                yield "bound", BOUNDS[word]
        elif word in OPPOSITE and word[0] in KINDS and spaced and after != "{": # void f() && {
            if word[0] not in "+/" or not re.search("\"|u'", self.line(i)): # a text, a path
                yield KINDS[word[0]], OPPOSITE[word]
        elif word == "-" and not self.gap(i + 1):
            yield "sign", ""
        elif word == "!" and "!" not in (before, after):
            yield "not", ""
        elif word in ("++", "--") and self.control(self.mate.get(self.inside[i])) != "for":
            yield "step", OPPOSITE[word] # in the head of a loop it shows at once

    def starts_statement(self, i):
        before = self.words[i - 1]
        if self.role.get(self.inside[i]) not in ("block", "switch"):
            return False
        if before == "}":
            return self.role.get(self.mate.get(i - 1)) != "list"
        if before == ":":
            return re.match(r"\s*(case\b|default:)", self.line(i - 1))
        return before in (";", "{", "else", "do") or before == ")" and self.control(i - 1)

    def of_statement(self, i):
        """Of one that stands on one line: (kind, its first and last token, what it becomes)."""
        end = i
        while self.words[end] not in (";", "}", ")", "]"):
            end = (self.mate.get(end, end) if self.words[end] in ("(", "[", "{") else end) + 1
        if self.words[end] != ";" or end == len(self.tokens):
            return
        whole, block, word = self.text[self.tokens[i].start:self.tokens[end].end], self.inside[i], self.words[i]
        if "\n" in whole:
            return
        if word == "return" and self.bools[block] and self.words[i + 1] not in ("true", "false", ";"):
            value = self.text[self.tokens[i + 1].start:self.tokens[end].start]
            yield "return", i + 1, end, f"!({value});"
        elif word == "continue" or word == "break" and self.role[block] != "switch" or \
                word == "return" and end == i + 1 and self.words[end + 1] != "}":
            yield "jump", i, end, "{}"
        elif self.is_expression(i) and not KEPT & set(self.words[i:end]):
            yield "left out", i, end, "{}"

    def is_expression(self, i):
        """A call or an assignment, and no declaration: `Type name`, `Type* name`, `Type<T> name`."""
        if self.words[i] in ("*", "++", "--"):
            return True
        if self.tokens[i].kind != "word" or self.words[i] in NO_EXPRESSION:
            return False
        k = i + 1 + (self.words[i] == "emit")
        while "::" in self.words[k - 1:k + 1]:
            k += 1
        return self.tokens[k].kind != "word" and (self.words[k] not in ("<", "*", "&", "&&") or self.gap(k))


def constants(word, negative):
    """k becomes k + 1, or 2 k where one more is hardly a fault; x becomes 2 x or -x."""
    if whole := re.fullmatch(r"(0x[\da-fA-F']+|0|[1-9][\d']*)([uUlLzZ]*)", word):
        value = int(whole[1].replace("'", ""), 0)
        yield (hex(value + 1) if word[:2] == "0x" else str(value + 1 if value < 1000 else 2 * value)) + whole[2]
    elif real := re.fullmatch(r"(?=.*[.eE])([\d']*\.?[\d']*(?:[eE][-+]?\d+)?)([fFlL]?)", word):
        value = float(real[1].replace("'", ""))
        if value == 0:
            yield "1.0" + real[2]
        elif value >= 1e-5: # below that it is a matter of rounding
            yield repr(2 * value) + real[2]
            yield from [] if negative else ["-" + word]


def shown(fault, text):
    """before -> after, with a little of the line around."""
    left, right = text[:fault.start].rpartition("\n")[2].lstrip(), text[fault.end:].partition("\n")[0]
    if len(left) > 40:
        left = "…" + re.sub(r"^\w+", "", left[-40:])
    if len(right) > 40:
        right = re.sub(r"\w+$", "", right[:40]) + "…"
    if fault.kind == "left out":
        left = right = ""
    return f"{left}{text[fault.start:fault.end]}{right} -> {left}{fault.new}{right}"


def drawn(seed, sources):
    """All faults, in an order that the seed chooses: the file by its lines with faults, the kind, the place."""
    dice, left, lines = random.Random(seed), {}, {}
    for name, source in sources.items():
        kinds = defaultdict(list)
        for fault in source.faults():
            kinds[fault.kind].append(fault)
        if kinds:
            left[name], lines[name] = kinds, len({fault.line for faults in kinds.values() for fault in faults})
    while left:
        name = dice.choices(list(left), [lines[name] for name in left])[0]
        kind = dice.choice(list(left[name]))
        yield left[name][kind].pop(dice.randrange(len(left[name][kind])))
        if not left[name][kind]:
            del left[name][kind]
        if not left[name]:
            del left[name]


# What may become of a source, and nothing else.
CASES = {
    "bool f(int a) { return a < 7; } // a < 8": [
        "bool f(int a) { return a >= 7; } // a < 8", "bool f(int a) { return a <= 7; } // a < 8",
        "bool f(int a) { return a < 8; } // a < 8", "bool f(int a) { return !(a < 7); } // a < 8"],
    '#include "a/b.h"\n#define K 3 + \\\n    4\nauto s = f("a < b && 1", R"(x == 2)", \'+\', u\'"\');': [],
    "template <int N = 3, bool B = true> std::array<std::array<int, 4>, N + 1> x;": [],
    "T f() && { } A&& a(B&& b) { auto&& c = *b->d << e >> f; std::map<int, T*> g; }": [],
    "bool operator<(A a, A b);\nbool operator==(const A&) const = default;\nvirtual void f() = 0;": [],
    "struct S { int a = 0; bool b = false; virtual ~S() = 0; };": [],
    "void f() { assert(a < 3); static_assert(N == 4); v.reserve(2 * n); }": [],
    "void f() { T a(b); T* c = &d; const T& e = g(); N::T<U> h{i}; using V = T; }": [],
    "void f() { a && !b; }": ["void f() { a || !b; }", "void f() { a && b; }", "void f() { {} }"],
    "bool f() { while (a) if (b) break; }": ["bool f() { while (a) if (b) {} }"],
    "void f() { switch (a) {\ncase B:\ng();\nbreak; } }": ["void f() { switch (a) {\ncase B:\n{}\nbreak; } }"],
    "void f() { a = [](T b) { return b; }; emit g(); *h = {i}; }": [
        "void f() { {} emit g(); *h = {i}; }", "void f() { a = [](T b) { return b; }; {} *h = {i}; }",
        "void f() { a = [](T b) { return b; }; emit g(); {} }"],
    "void f() { if (a) return; g({b, c}); }": ["void f() { if (a) {} g({b, c}); }", "void f() { if (a) return; {} }"],
    "double a = -0.5 * std::min(b, 1e-14);": [
        "double a = 0.5 * std::min(b, 1e-14);", "double a = -1.0 * std::min(b, 1e-14);",
        "double a = -0.5 / std::min(b, 1e-14);", "double a = -0.5 * std::max(b, 1e-14);"],
    "T a = f(2.5f, 0x1F, 0, 1'000u, 0755);": [
        "T a = f(5.0f, 0x1F, 0, 1'000u, 0755);", "T a = f(-2.5f, 0x1F, 0, 1'000u, 0755);",
        "T a = f(2.5f, 0x20, 0, 1'000u, 0755);", "T a = f(2.5f, 0x1F, 1, 1'000u, 0755);",
        "T a = f(2.5f, 0x1F, 0, 2000u, 0755);"],
    "void f() { for (T a; b(); ++a) c(d++); }": [
        "void f() { for (T a; b(); ++a) c(d--); }", "void f() { for (T a; b(); ++a) {} }"],
    "T f() const { return a(true); }": ["T f() const { return a(false); }"],
    "bool S::f() const noexcept { return a + b; }": [
        "bool S::f() const noexcept { return a - b; }", "bool S::f() const noexcept { return !(a + b); }"],
    "auto f = [&](T a) -> bool { return a; };": ["auto f = [&](T a) -> bool { return !(a); };"],
    "S::S() : a_{b}, c_(d) { e(); }": ["S::S() : a_{b}, c_(d) { {} }"],
    'T a = "text" + b + u\'.\';\nT c = d - e;': ['T a = "text" + b + u\'.\';\nT c = d + e;'],
    "void f() { if (a < b) b = a; }": ["void f() { if (a >= b) b = a; }", "void f() { if (a < b) {} }"],
}


def self_test():
    """Says each fault that is not as it should be; is there none?"""
    wrong = 0
    for text, wanted in CASES.items():
        made = {text[:fault.start] + fault.new + text[fault.end:] for fault in Source("", text).faults()}
        for what, some in ("missing", set(wanted) - made), ("not meant", made - set(wanted)):
            for each in some:
                print(f"{text}\n    {what}: {each}")
                wrong += 1
    print(f"{len(CASES)} sources, {wrong} faults that are not as they should be")
    return wrong == 0
