"""What two parsers make of Structured Text: a grammar of the standard has no error, and blark, which knows TwinCAT, finds
the constants, enumerations, structs and texts that are printed here."""

import re
import sys

import tree_sitter
import tree_sitter_iec61131_3_st
from blark.parse import parse_source_code

sys.stdout.reconfigure(encoding="utf-8")
with open(sys.argv[1], encoding="utf-8") as file:
    source = file.read()


def faults(node):
    if node.is_error or node.is_missing:
        yield f"line {node.start_point[0] + 1}: {node.type} {node.text!r}"
    for child in node.children:
        yield from faults(child)


# Of IEC 61131-3 the grammar lacks initial values of structs within arrays, which blark reads.
simple = re.sub(r" := \[\n.*?\n    \];", ";", source, flags=re.S)
parser = tree_sitter.Parser(tree_sitter.Language(tree_sitter_iec61131_3_st.language()))
if found := list(faults(parser.parse(simple.encode()).root_node)):
    sys.exit("\n".join(found[:20]))

if sys.argv[2:] == ["grammar"]:
    sys.exit()
parsed = parse_source_code(source)
if parsed.exception:
    sys.exit(str(parsed.exception))


def number(text):
    text = str(text).replace("_", "")
    return int(text[3:], 16) if text.startswith("16#") else int(text)


def plain(item):
    "A statement or declaration as blark prints it, without comments, in one line."
    return re.sub(r"\s+", " ", re.sub(r"\(\*.*?\*\)", "", str(item), flags=re.S)).strip()


def latin(text):
    return re.sub(r"\$([0-9A-F]{2})", lambda code: chr(int(code[1], 16)), text).replace("$'", "'").replace("$$", "$")


for item in parsed.transform().items:
    kind, text = type(item).__name__, plain(item)
    if kind == "GlobalVariableDeclarations":
        for name, of, value in re.findall(r"(\w+) : (\w+) := ([\w#-]+);", text):
            print("constant", name, of, number(value))
        for name, writes in re.findall(r"(\w+) : ARRAY ?\[[^\]]+\] OF \w+_SDO_WRITE := \[(.*?)\];", text):
            row = r"index := (16#\w+), subindex := (16#\w+), size := (\d+), data := \[([^\]]*)\]"
            for index, subindex, size, data in re.findall(row, writes):
                data = [number(byte) for byte in data.split(", ")]
                if any(data[int(size) :]):
                    sys.exit(f"{name} has more than {size} bytes: {data}")
                print("write", name, number(index), number(subindex), bytes(data[: int(size)]).hex())
    elif kind == "DataTypeDeclaration" and "STRUCT" in text:
        name = re.search(r"(\w+) : STRUCT", text)[1]
        for field, of in re.findall(r"(\w+) : ([^;:]+);", text.split("STRUCT", 1)[1]):
            print("field", name, field, of.replace("ARRAY [", "ARRAY["))
    elif kind == "DataTypeDeclaration":
        for name, value in re.findall(r"(\w+) := (-?\d+)", text):
            print("value", text.split(" ")[0], name, value)
    elif kind == "Function":
        name = re.search(r"FUNCTION (\w+)", text)[1]
        for mask, pattern, state in re.findall(rf"AND (16#\w+)\) = (16#\w+)\)? THEN {name} := (\w+);", text):
            print("state", number(mask), number(pattern), state)
        for code, what in re.findall(rf"(16#\w+) ?: {name} := '((?:\$.|[^'$])*)';", text):
            print("text", name, number(code), number(code), latin(what))
        ranges = rf"code >= (16#\w+)\)? AND \(?code <= (16#\w+)\)? THEN {name} := '((?:\$.|[^'$])*)';"
        for first, last, what in re.findall(ranges, text):
            print("text", name, number(first), number(last), latin(what))
