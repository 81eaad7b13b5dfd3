#!/usr/bin/env python3
"""The words of the manual: how many there are, and whether they say all that they have to.

Prints the words of each page that a user reads; then what breaks a rule, a line per finding, and fails if there is any.
Lines of code, commands and what they print are no words.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
MANUAL = ROOT / "doc/Handle_tunnel_loops"
HEADERS = [*sorted((ROOT / "include/CGAL").glob("*.h")), *sorted((ROOT / "include/CGAL/Handle_tunnel_loops").glob("*.h"))]

ALL_WORDS = 16000
LIMITS = {
    "README.md": 1300, "guides/*.txt": 600, "Handle_tunnel_loops.txt": 2000, "Reeb_graphs_and_skeletons.txt": 2000,
    "Removal_and_cutting.txt": 2000, "Named_parameters.txt": 1200, "Tool_reference.txt": 2500, "Comparison.txt": 800,
    "Gallery.txt": 300,
}
# What has been mended once, and is not to come back.
PHRASES = ("letter of the paper", "in whose place", "nobody's business", "ends unheard", "second look", "pulled taut",
           "often forth as back", "comes apart", "come apart", "falls open", "each other's name", "hang on a",
           "less long than thick", "not fit as it is", "as a rule", "is told", "are told")
PRINTED = ("mended", "mends this", "mends it", "for want of", "its box", "centre of", "boundary curves but", "is no array",
           "have each other's", "comes off", "is to be positive")
findings = []


def complain(*words):
    findings.append(" ".join(map(str, words)))


def words_of(text):
    for begin, end in (r"<pre>", r"</pre>"), (r"\\code", r"\\endcode"), (r"```", r"```"), (r"<table", r">"):
        text = re.sub(f"{begin}.*?{end}", " ", text, flags=re.DOTALL)
    text = re.sub(r"\]\([^)]*\)", "]", text)
    text = re.sub(r"^    .*$|^\\(cgal\w+|page|anchor|author)\b.*$|<[^>]*>|\\\w+|[|`*#-]+", " ", text, flags=re.MULTILINE)
    return len(re.findall(r"\w[\w'’./-]*", text))


def check_lengths():
    whole = 0
    for pattern, limit in LIMITS.items():
        for page in sorted((MANUAL if pattern != "README.md" else ROOT).glob(pattern)):
            count = words_of(page.read_text(encoding="utf-8"))
            whole += count
            print(f"{count:6} {page.relative_to(ROOT)}")
            if count > limit:
                complain(f"{page.relative_to(ROOT)}: {count} words, more than {limit}")
    print(f"{whole:6} in all")
    if whole > ALL_WORDS:
        complain(f"the pages have {whole} words, more than {ALL_WORDS}")


def pages():
    return sorted(MANUAL.rglob("*.txt"))


def check_labels():
    text = {page: page.read_text(encoding="utf-8") for page in [*pages(), *HEADERS, *sorted(MANUAL.glob("Concepts/*.h"))]}
    labels = [label for words in text.values()
              for label in re.findall(r"\\(?:page|section|subsection|subsubsection|anchor|defgroup) +(\w+)", words)]
    for label in {label for label in labels if labels.count(label) > 1}:
        complain(f"{label}: a label of {labels.count(label)} sections")
    for page, words in text.items():
        for label in set(re.findall(r"\\ref +(HTL\w+)", words)) - set(labels):
            complain(f"{page.relative_to(ROOT)}: there is no section {label}")


def check_links():
    files = [ROOT / "README.md", ROOT / "CHANGES.md", *sorted(ROOT.glob("doc/submission/*.md")),
             *sorted(ROOT.glob("benchmark/**/*.md"))]
    for file in files:
        for path in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", file.read_text(encoding="utf-8")):
            if not (file.parent / path).exists():
                complain(f"{file.relative_to(ROOT)}: there is no {path}")


def check_reference():
    """Every public header is in the reference, and every function and class of it in the list of the package."""
    listed = (MANUAL / "PackageDescription.txt").read_text(encoding="utf-8")
    for header in HEADERS:
        if header.name == "parameters.h":
            continue
        text = header.read_text(encoding="utf-8")
        if "\\ingroup PkgHandleTunnelLoops" not in text:
            complain(f"{header.relative_to(ROOT)}: not in the reference manual")
        for comment, name in re.findall(
                r"/\*!((?:(?!\*/).)*?)\*/\s*(?:template\s*<[^;{]*?>\s*)?(?:class|struct|enum class|enum)\s+(\w+)", text,
                re.DOTALL):
            if "\\ingroup PkgHandleTunnelLoops" in comment and not re.search(rf"\b{name}\b", listed):
                complain(f"PackageDescription.txt: {name} is not in it")


def members_of_options(text):
    for struct, body in re.findall(r"\nstruct (\w+_(?:options|constants|rules))\s*\{(.*?)\n\};", text, re.DOTALL):
        for member in re.findall(r"^\s+[\w:<>, ()*]+[ >](\w+)(?: = [^;]*|\{[^;]*\})?;", body, re.MULTILINE):
            yield struct, member


def check_parameters():
    told = (MANUAL / "Named_parameters.txt").read_text(encoding="utf-8")
    parameters = (ROOT / "include/CGAL/Handle_tunnel_loops/parameters.h").read_text(encoding="utf-8")
    for name in re.findall(r"_ADD_\w+\(\w+, (?:\w+, )?([a-z]\w+)\)", parameters):
        if f"`{name}" not in told:
            complain(f"Named_parameters.txt: the parameter {name} is not in it")
    count = 0
    for header in HEADERS:
        for struct, member in members_of_options(header.read_text(encoding="utf-8")):
            count += 1
            if f"`{member}`" not in told:
                complain(f"Named_parameters.txt: {struct}::{member} is not in it")
    if count < 20:
        complain(f"only {count} members of options were found in the headers")


def check_phrases():
    for page in [ROOT / "README.md", *pages(), *HEADERS, *sorted(MANUAL.glob("Concepts/*.h"))]:
        text = " ".join(page.read_text(encoding="utf-8").lower().split())
        for phrase in PHRASES:
            if phrase in text:
                complain(f"{page.relative_to(ROOT)}: \"{phrase}\"")


def check_messages():
    for room in "src", "python", "include", "cuda":
        for file in sorted(file for file in (ROOT / room).rglob("*") if file.suffix in (".cpp", ".h", ".py", ".js", ".ts", ".cu")):
            for line in file.read_text(encoding="utf-8").splitlines():
                for text in [] if line.lstrip().startswith(("//", "#", "*")) else re.findall(r'"[^"]*"|\'[^\']*\'|`[^`]*`', line):
                    for phrase in PRINTED:
                        if re.search(rf"\b{phrase}\b", text):
                            complain(f"{file.relative_to(ROOT)}: {text}")


def check_figures():
    """Of each table of figures it is known at which commit it was measured."""
    for file in sorted((ROOT / "benchmark/results").glob("*.md")):
        if not re.search(r"\b[0-9a-f]{8}\b", file.read_text(encoding="utf-8")):
            complain(f"{file.relative_to(ROOT)}: no commit at which its figures were measured")


def check_files():
    settings = (MANUAL / "Doxyfile.in").read_text(encoding="utf-8")
    for page in pages():
        for file in re.findall(r'<(?:img src|a href)="([^":#]+)"', page.read_text(encoding="utf-8")):
            if f"/{file} " not in settings and f"/{file}\n" not in settings:
                complain(f"Doxyfile.in: {file} is not in it")


for check in (check_lengths, check_labels, check_links, check_reference, check_parameters, check_phrases,
              check_messages, check_figures, check_files):
    check()
for finding in sorted(findings):
    print(finding, file=sys.stderr)
print("words: see above" if findings else "words: all is well", file=sys.stderr if findings else sys.stdout)
sys.exit(1 if findings else 0)
