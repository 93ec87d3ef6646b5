"""Mutants, or planted faults, of some files compiled at once, each behind a switch that the environment turns: MUTANT=7 is the seventh.

What cargo-mutants would put in the place of a piece of code stands beside it: `a + b` becomes `match (a, b) { (l, r) => if is(7) { l - r }
else { l + r } }`. A fault stands in a second body of its function. What the compiler refuses is left out, round by round, by the places of
its errors.
"""
import bisect
import collections
import json
import subprocess

import tree_sitter_rust
from tree_sitter import Language, Parser

RUST = Parser(Language(tree_sitter_rust.language()))
SWITCH = """
#[doc(hidden)]
#[allow(missing_docs, clippy::all)]
pub mod mutant_switch {
    use std::sync::LazyLock;
    use std::sync::atomic::{AtomicBool, Ordering};
    static CHOSEN: LazyLock<usize> =
        LazyLock::new(|| std::env::var("MUTANT").ok().and_then(|text| text.parse().ok()).unwrap_or(0));
    static LOG: LazyLock<Option<String>> = LazyLock::new(|| std::env::var("MUTANT_LOG").ok());
    static SEEN: [AtomicBool; MUTANTS] = [const { AtomicBool::new(false) }; MUTANTS];
    pub fn is(n: usize) -> bool {
        if let Some(path) = &*LOG && !SEEN[n].swap(true, Ordering::Relaxed) {
            use std::io::Write;
            let file = std::fs::OpenOptions::new().append(true).create(true).open(path);
            file.and_then(|mut file| file.write_all(format!("{n}\\n").as_bytes())).ok();
        }
        *CHOSEN == n
    }
}
"""
# Mutants that can be told apart.
MOST = 10_000
IS = "crate::mutant_switch::is"
COMPARISONS = ["==", "!=", "<", ">", "<=", ">="]


class Source:
    """One file, with the mutants that are wanted of it by the places of their spans."""

    def __init__(self, text, mutants):
        self.sound, self.out, self.ranges, self.done = text.encode(), bytearray(), [], set()
        lines = text.splitlines(keepends=True)
        starts = [0]
        for line in lines:
            starts.append(starts[-1] + len(line.encode()))
        byte = lambda at: starts[at["line"] - 1] + len(lines[at["line"] - 1][:at["column"] - 1].encode())
        self.at, self.bodies, self.fields = (collections.defaultdict(list) for _ in range(3))
        for number, one in mutants.items():
            span = byte(one["span"]["start"]), byte(one["span"]["end"])
            # The span of a field holds the comma behind it.
            into = {"FnValue": self.bodies, "StructField": self.fields}.get(one["genre"])
            into = self.at[span] if into is None else into[span[0]]
            into.append((number, one["replacement"]))
        self.tree = RUST.parse(self.sound)
        self.render(self.tree.root_node)

    def write(self, text):
        self.out += text if isinstance(text, bytes) else text.encode()

    def within(self, numbers, kind, write):
        """Writes something and keeps where it lies: the text of one mutant, or what is around those of one place."""
        begin = len(self.out)
        write()
        self.ranges.append((begin, len(self.out), tuple(numbers), kind))
        self.done.update(numbers)

    def choice(self, mutants, of, sound):
        """`if is(1) { … } else if is(2) { … } else { … }`, where `of` writes a replacement."""
        for number, replacement in mutants:
            self.write(f"if {IS}({number}) {{ ")
            self.within([number], "mutant", lambda: of(replacement))
            self.write(" } else ")
        self.write("{ ")
        of(sound)
        self.write(" }")

    def render(self, node):
        """Writes a node with its mutants."""
        whole = self.at.pop((node.start_byte, node.end_byte), [])
        if whole and node.parent.type == "match_pattern":
            return self.within([number for number, _ in whole], "place", lambda: self.guard(node, whole))
        if whole:
            self.at[node.start_byte, node.end_byte] = whole
        self.operate(node)

    def operate(self, node):
        """The same where it is no guard."""
        whole = self.at.get((node.start_byte, node.end_byte), [])
        operator = node.child_by_field_name("operator") or (node.children[0] if node.type == "unary_expression" else None)
        of_operator = self.at.get((operator.start_byte, operator.end_byte), []) if operator else []
        numbers = [number for number, _ in of_operator]
        if of_operator and node.type == "binary_expression" and (node.parent.type != "let_chain" or operator.text not in (b"&&", b"||")):
            self.within(numbers, "place", lambda: self.binary(node, operator.text.decode(), of_operator))
        elif of_operator and node.type == "compound_assignment_expr":
            self.within(numbers, "place", lambda: self.compound(node, operator.text.decode(), of_operator))
        elif of_operator and node.type == "unary_expression":
            self.within(numbers, "place", lambda: self.unary(node, operator.text.decode(), of_operator))
        elif whole and node.type == "match_arm":
            self.within([number for number, _ in whole], "place", lambda: self.arm(node, whole[0][0]))
        elif node.type.endswith("field_initializer") and node.start_byte in self.fields:
            [(number, _)] = self.fields.pop(node.start_byte)
            self.within([number], "place", lambda: self.field(node, number))
        else:
            self.inside(node)

    def inside(self, node):
        """Writes a node as it is, but for the mutants of what it holds."""
        here = node.start_byte
        for child in node.children:
            self.write(self.sound[here:child.start_byte])
            for number, replacement in self.bodies.pop(child.start_byte, []):
                self.within([number], "body", lambda: self.write(f"if {IS}({number}) {{ return {replacement}; }} "))
            self.render(child)
            here = child.end_byte
        self.write(self.sound[here:node.end_byte])

    def binary(self, node, sound, mutants):
        left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
        if sound in ("&&", "||"):
            # `r` is asked only where `l` decides nothing: with && where it is true, with || where it is false.
            self.write("(match (")
            self.render(left)
            self.write(f") {{ l => if l {'!=' if sound == '&&' else '=='} {IS}({mutants[0][0]}) {{ ")
            self.render(right)
            return self.write(" } else { l } })")
        lent, used = ("&(", "*") if sound in COMPARISONS else ("(", "")
        self.write(f"(match ({lent}")
        self.render(left)
        self.write(f"), {lent}")
        self.render(right)
        self.write(")) { (l, r) => ")
        self.choice(mutants, lambda operator: self.write(f"{used}l {operator} {used}r"), sound)
        self.write(" })")

    def compound(self, node, sound, mutants):
        left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
        self.write("(match (")
        self.render(right)
        self.write(") { r => ")
        self.choice(mutants, lambda operator: self.write(left.text + f" {operator} r".encode()), sound)
        self.write(" })")

    def unary(self, node, sound, mutants):
        self.write("(match (")
        self.render(node.children[1])
        self.write(") { v => ")
        self.choice(mutants, lambda operator: self.write(f"{operator} v"), sound)
        self.write(" })")

    def arm(self, node, number):
        pattern = node.child_by_field_name("pattern")
        guard = pattern.child_by_field_name("condition")
        for child in node.children:
            if child != pattern:
                self.write(" ")
                self.render(child)
                continue
            self.write(self.sound[pattern.start_byte:(pattern.children[0] if guard else pattern).end_byte])
            self.write(f" if !{IS}({number})")
            if guard:
                self.write(" && (")
                self.render(guard)
                self.write(")")

    def guard(self, node, mutants):
        self.write("(match (")
        self.operate(node)
        self.write(") { l => ")
        self.choice(mutants, lambda own: self.write(own or "l"), "")
        self.write(" })")

    def field(self, node, number):
        base = next(child for child in node.parent.children if child.type == "base_field_initializer")
        name, value = (node.child_by_field_name(part) or node.children[0] for part in ["field", "value"])
        self.write(name.text + f": if {IS}({number}) {{ ".encode())
        self.within([number], "mutant", lambda: self.write(b"(" + base.children[-1].text + b")." + name.text))
        self.write(" } else { ")
        self.render(value)
        self.write(" }")

    def function_at(self, place):
        """Numbers of all mutants in the smallest range, or in the function, around a place of what was written."""
        tree = RUST.parse(bytes(self.out))
        node = tree.root_node.descendant_for_byte_range(place, place)
        while node and node.type != "function_item":
            node = node.parent
        begin, end = (node.start_byte, node.end_byte) if node else (place, place)
        return {number for b, e, numbers, kind in self.ranges if begin <= b and e <= end and kind == "body" for number in numbers} or {
            number for b, e, numbers, _ in self.ranges if begin <= b and e <= end for number in numbers}


class Spoiled(Source):
    """One file, with faults: `was` becomes `is` in a second body of its function, or in a second copy of a piece of it where `within` says which
    kind of node (what a function that returns `impl Trait` holds cannot be two)."""

    def __init__(self, text, faults):
        self.sound, self.out, self.ranges, self.done = text.encode(), bytearray(), [], set()
        self.tree = RUST.parse(self.sound)
        self.places = collections.defaultdict(list)
        for number, fault in faults.items():
            begin = self.sound.index(fault["was"].encode())
            end = begin + len(fault["was"].encode())
            self.places[self.holding(begin, end, fault.get("within"))].append((number, begin, end, fault["is"].encode()))
        here = 0
        for (begin, end), own in sorted(self.places.items()):
            if begin < here:
                raise SystemExit(f"faults inside one another: {own}")
            self.write(self.sound[here:begin] + b"{ ")
            for number, was, behind, replacement in own:
                self.write(f"if {IS}({number}) ".encode())
                self.within([number], "mutant", lambda: self.write(b"{ " + self.sound[begin:was] + replacement + self.sound[behind:end] + b" }"))
                self.write(b" else ")
            self.write(b"{ " + self.sound[begin:end] + b" } }")
            here = end
        self.write(self.sound[here:])

    def holding(self, begin, end, kind):
        """The innermost body of a function, or node of a kind, around a place."""
        node = self.tree.root_node.descendant_for_byte_range(begin, end - 1)
        is_it = lambda node: node.type == kind if kind else node.type == "block" and node.parent.type == "function_item"
        while node and not is_it(node):
            node = node.parent
        if not node:
            raise SystemExit(f"no function around `{self.sound[begin:end].decode()}`")
        return node.start_byte, node.end_byte


def plant(tree, changes, of=Source):
    """Writes all mutants, or faults, into the copy `tree`; returns the sources by file."""
    by_file = collections.defaultdict(dict)
    for number, one in changes.items():
        by_file[one["file"]][number] = one
    sources = {file: of((tree / file).read_text(), own) for file, own in by_file.items()}
    for file, source in sources.items():
        (tree / file).write_bytes(source.out)
    return sources


def called(span):
    """Where the macro stands that an error is in, else the place itself."""
    while span.get("expansion"):
        span = span["expansion"]["span"]
    return span


def refused(command, options, sources):
    """Compiles; the mutants that the compiler refuses: of themselves, or because a switch cannot stand there. None where all is compiled."""
    told = subprocess.run([*command, "--message-format=json"], **options, capture_output=True, text=True)
    if told.returncode == 0:
        return None
    own, around, unknown = set(), set(), []
    for line in told.stdout.splitlines():
        message = json.loads(line).get("message") or {}
        if message.get("level") != "error" or not message.get("spans"):
            continue
        found = False
        spans = [called(span) for span in sorted(message["spans"], key=lambda span: not span["is_primary"])]
        for span in spans:
            source = sources.get(span["file_name"])
            holding = source and [one for one in source.ranges if one[0] <= span["byte_start"] < one[1]]
            if holding:
                _, _, numbers, kind = min(holding, key=lambda one: one[1] - one[0])
                (own if kind != "place" else around).update(numbers)
                found = True
                break
        if not found:
            places = [(sources.get(span["file_name"]), span["byte_start"]) for span in spans if span["file_name"] in sources]
            for source, place in places:
                around.update(source.function_at(place))
            if not places:
                unknown.append(message["rendered"])
    if not own | around:
        raise SystemExit("\n".join(unknown) or told.stderr)
    return own, around - own
