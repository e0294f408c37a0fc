#!/usr/bin/env python3
"""Asks tests about all changes of a part that one build holds: run by .ci/mutate, from the repository.

    ask.py TREE CHANGES.json FOLDER SWITCHES PACKAGE... -- TEST...

TREE is a copy of the sources. FOLDER gets `asked.jsonl`, a line a change, and goes on where it stopped.
"""
import json
import os
import re
import signal
import subprocess
import sys
import time
from collections import Counter, defaultdict
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

root, here = Path.cwd(), Path(__file__).parent
split = sys.argv.index("--")
tree, changes, folder, switches = map(Path, sys.argv[1:5])
packages = [word for package in sys.argv[5:split] for word in ("-p", package)]
tests = [word for test in sys.argv[split + 1:] for word in ("--test", test)]
numbered = dict(enumerate(json.loads(changes.read_text()), 1))
# the wrapper gives features of the nightly compiler to the packages of the house alone
building = dict(os.environ, RUSTC_WORKSPACE_WRAPPER=str(here.resolve() / "rustc"), CARGO_INCREMENTAL="1")


def cargo(*words):
    """What cargo says, as objects."""
    command = ["cargo", *words, "--message-format=json", "--all-features", *packages]
    run = subprocess.run(command, cwd=tree, env=building, stdout=subprocess.PIPE, text=True)
    return run.returncode, [json.loads(line) for line in run.stdout.splitlines() if line.startswith("{")]


def faulty(message, places):
    """The changes that an error is about: those in its first places, else in any, else arms of a `match` without which it
    does not cover all."""
    def within(spans):
        return {number for span in spans for start, end, number in places[span["file_name"]]
                if start < span["byte_end"] and span["byte_start"] < end}
    spans = message["spans"] + [span for child in message["children"] for span in child["spans"]]
    found = within(span for span in spans if span["is_primary"]) or within(spans)
    if (message["code"] or {}).get("code") == "E0004":
        lines = (tree / spans[0]["file_name"]).read_text().splitlines()[spans[0]["line_start"] - 1:]
        depth = len(lines[0]) - len(lines[0].lstrip())
        ends = next(at for at, line in enumerate(lines[1:], 1) if line.startswith(" " * depth + "}"))
        found = {int(it) for line in lines[1:ends] for it in re.findall(r" if !crate::switch::on\((\d+)\)", line)}
    return found


def build():
    """The binaries of tests, with all changes but those that do not compile, which come second, and those that need a
    build of their own, which come last."""
    left_out = folder / "not-compiled"
    left_out.touch()
    while True:
        woven = subprocess.run([switches, changes, root, tree, left_out], check=True, stdout=subprocess.PIPE, text=True)
        lines = [line.split() for line in woven.stdout.splitlines()]
        places = defaultdict(list)
        for file, start, end, number in (line for line in lines if len(line) == 4):
            places[file].append((int(start), int(end), int(number)))
        # errors of the library first: tests take long to build
        for words in (["build", "--lib"], ["test", "--no-run", "--lib", *tests]):
            code, said = cargo(*words)
            errors = [it["message"] for it in said if it["reason"] == "compiler-message" and it["message"]["level"] == "error"]
            wrong = set().union(*(faulty(error, places) for error in errors))
            if code != 0:
                break
        if code == 0:
            break
        if not wrong:
            sys.exit("".join(error["rendered"] for error in errors))
        with left_out.open("a") as file:
            print(*sorted(wrong), file=file)
    binaries = [(it["executable"], Path(it["manifest_path"]).parent) for it in said
                if it["reason"] == "compiler-artifact" and it["executable"] and it["profile"]["test"]]
    return binaries, set(map(int, left_out.read_text().split())), {int(line[1]) for line in lines if len(line) == 2}


def run(binary, names, limit, **switched):
    """Whether tests pass; None if they do not end."""
    path, package = binary
    environment = dict(os.environ, INSTA_UPDATE="no", INSTA_WORKSPACE_ROOT=str(tree.resolve()), **switched)
    quiet = dict(stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
    process = subprocess.Popen([path, "--exact", "--test-threads=1", *names], cwd=package, env=environment, **quiet)
    try:
        return process.wait(limit) == 0
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()


def record(binaries):
    """For each change the tests that reach it, each with its binary and how long it takes."""
    reached, file = defaultdict(list), folder / "reached"
    for binary in binaries:
        listed = subprocess.run([binary[0], "--list", "--format=terse"], stdout=subprocess.PIPE, text=True, check=True)
        for name in (line.removesuffix(": test") for line in listed.stdout.splitlines() if line.endswith(": test")):
            file.write_text("")
            began = time.monotonic()
            if not run(binary, [name], 600, DEVC_CHANGE="all", DEVC_REACHED=str(file.resolve())):
                print(f"{name} of {binary[0]} fails without a change", file=sys.stderr)
                continue
            for number in map(int, file.read_text().split()):
                reached[number].append((time.monotonic() - began, binary, name))
    return reached


def ask(number, reaching, noticed):
    """What the tests say of a change: first those that noticed most in the time that they take."""
    for seconds, binary, name in sorted(reaching, key=lambda it: it[0] / (1 + noticed[it[2]])):
        passes = run(binary, [name], 20 + 10 * seconds, DEVC_CHANGE=str(number))
        if not passes:
            noticed[name] += 1
            return {"noticed": name, "ends": passes is not None}
    return {"unnoticed": len(reaching)}


def answer(number):
    """What is known of a change."""
    if number in not_compiled:
        said = {"not compiled": True}
    elif number in alone:
        said = {"alone": True}
    else:
        said = ask(number, reached[number], noticed)
    return {"number": number, **said, "change": numbered[number]["name"]}


binaries, not_compiled, alone = build()
asked = folder / "asked.jsonl"
answers = [json.loads(line) for line in asked.read_text().splitlines()] if asked.exists() else []
reached, noticed = record(binaries), Counter()
left = sorted(numbered.keys() - {it["number"] for it in answers})
with ThreadPoolExecutor(os.cpu_count()) as pool, asked.open("a") as file:
    for said in pool.map(answer, left):
        answers.append(said)
        print(json.dumps(said), file=file, flush=True)

for kind in ("unnoticed", "alone"):
    print(*sorted(f"{kind}: {said['change']}" for said in answers if kind in said), sep="\n")
count = Counter(next(kind for kind in ("noticed", "unnoticed", "not compiled", "alone") if kind in said) for said in answers)
print(f"{len(answers)} changes: {dict(count)}")
