#!/usr/bin/env python3
# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Checks that what the texts say exists: links, pictures, files, options, programs, figures, commands.

  check_documentation.py texts SOURCE_DIR BIN_DIR
  check_documentation.py manual SOURCE_DIR DOXYFILE
  check_documentation.py figures SOURCE_DIR BUILD_DIR

`texts` reads the Markdown files and the source of the manual, and runs the programs that they tell of;
`manual` makes the manual and follows the links of its pages; `figures` makes some of its pictures. The exit
code is 77 where Doxygen, or what draws the pictures, is not installed; but not having Doxygen is an error where
the environment variable CI is true.
"""

import html.parser
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import urllib.parse

MARKDOWN = ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "benchmark/Weakly_convex_segmentation/README.md")
MANUAL = pathlib.Path("doc/Weakly_convex_segmentation")
FOLDERS = ("include", "tools", "examples", "test", "benchmark", "doc", "package_info", "scripts", "cmake", r"\.ci")
NOT_OURS = {"cmake", "ctest", "parallel", "seq", "git", "mkdir", "#SBATCH"}
OPTIONS_OF_OTHERS = {"--joblog", "--resume-failed", "--sshloginfile"}  # GNU parallel


class Project:
    """The sources, and what the programs say of themselves."""

    def __init__(self, source, programs=None):
        self.source, self.programs, self.helps = pathlib.Path(source), programs, {}
        listed = subprocess.run(["git", "-C", source, "ls-files", "--cached", "--others", "--exclude-standard"],
                                capture_output=True, text=True, check=False)
        self.files = [f for f in listed.stdout.splitlines() if f] or [
            str(p.relative_to(source)) for p in self.source.rglob("*")
            if p.is_file() and not str(p.relative_to(source)).startswith("build")]
        self.names = {pathlib.PurePath(f).name for f in self.files}

    def read(self, path):
        return (self.source / path).read_text(encoding="utf-8")

    def manual(self):
        return self.read(MANUAL / "Weakly_convex_segmentation.txt")

    def help(self, name):
        """what a program or a script says of its options, None if it is neither"""
        if name not in self.helps:
            self.helps[name] = self._find_help(name)
        return self.helps[name]

    def _find_help(self, name):
        for file in self.files:
            path = pathlib.PurePath(file)
            if path.name == name and (path.suffix == ".py" or path.parts[0] == "scripts"):
                return self.read(file)
            if path.name != name + ".cpp":
                continue
            source = self.read(file)
            if "help" in source and self.programs and (self.programs / name).is_file():
                run = subprocess.run([self.programs / name, "--help"], capture_output=True, text=True,
                                     timeout=60, check=False)
                return run.stdout + run.stderr
            # not built here, or without --help: all that may be the name of an option
            names = re.findall(r'"(?:--)?([a-z][\w-]*)(?:,\w)?"', source)
            return "".join(f"\n  --{n}" for n in names)
        return None


def code_of(text):
    """all that is marked as code, spans and lines of blocks, with continued lines joined"""
    blocks = re.findall(r"```\w*\n(.*?)```|\\code\{\.sh\}\n(.*?)\\endcode", text, re.S)
    lines = "\n".join(a or b for a, b in blocks).replace("\\\n", " ").splitlines()
    rest = re.sub(r"```.*?```", "", text, flags=re.S)
    return [line.split(" # ")[0] for line in lines] + [
        re.sub(r"\s+", " ", span) for span in re.findall(r"`([^`]+)`", rest)]


def check_links(project, file, text):
    folder = pathlib.PurePosixPath(file).parent
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        place = project.source / folder / path if path else project.source / file
        if not place.exists():
            yield f"{file}: the link to {target} leads nowhere"
        elif anchor and anchor not in anchors_of(place.read_text(encoding="utf-8")):
            yield f"{file}: there is no heading for {target}"


def anchors_of(text):
    titles = re.findall(r"^#+ (.*)$", text, re.M)
    return {re.sub(r"[^\w\- ]", "", t.lower()).replace(" ", "-") for t in titles}


def check_files(project, file, text):
    """paths from the root, and the names of sources wherever they lie"""
    for code in code_of(text):
        for path in re.findall(r"(?<![\w/.-])(?:%s)/[\w./*-]*" % "|".join(FOLDERS), code):
            path = path.rstrip(".")
            if path.startswith("include/CGAL") or "*" not in path:
                exists = (project.source / path).exists()
            else:
                exists = any(project.source.glob(path))
            if not exists and not path.endswith("include/"):
                yield f"{file}: there is no {path}"
        for name in re.findall(r"(?<![\w/.*-])[\w-]+\.(?:h|cpp|py|sh|mjs)\b", code):
            if name not in project.names and name != "test_NAME.cpp":
                yield f"{file}: there is no file {name}"
        for program in re.findall(r"build/bin/(\w+)(?!\w*\*)", code):
            if project.help(program) is None and not program.endswith("_"):
                yield f"{file}: there is no program {program}"


def options_in(code):
    return re.findall(r"(?<![\w-])--[a-z][\w-]*", code)


def check_options(project, file, text):
    """options in commands, in tables below a program, and alone"""
    everything = "".join(project.help(pathlib.PurePath(f).name.replace(".cpp", "")) or ""
                         for f in project.files if re.match(r"(tools|examples|benchmark|scripts)/", f))
    program = None
    for line in text.splitlines():
        named = re.findall(r"build/bin/(\w+)", line)
        program = named[-1] if named else program
        if line.startswith("| `-") and program:
            for option in options_in(line.split("|")[1]):
                if option not in options_in(help_text(project, program)):
                    yield f"{file}: {program} has no option {option}"
    for code in code_of(text):
        words = code.split()
        known = [w for w in words if project.help(w.split("/")[-1]) and not w.startswith("-")]
        if words and words[0].split("/")[-1] in NOT_OURS:
            continue
        told = help_text(project, known[-1].split("/")[-1]) if known else everything
        for option in options_in(code):
            if option not in OPTIONS_OF_OTHERS and option not in options_in(told):
                yield f"{file}: '{code}' has an option {option} that does not exist"


def help_text(project, program):
    return project.help(program) or ""


def check_all_options_told(project):
    """the other way round, for the program that most people meet"""
    told = options_in(project.read("README.md"))
    for option in re.findall(r"^ +(?:-\w \[ )?(--[\w-]+)", project.help("segment_shape"), re.M):
        if option not in told and option not in ("--help", "--version", "--output"):
            yield f"README.md: the option {option} of segment_shape is not told of"


def check_parameters(project, file, text):
    known = project.read("include/CGAL/Weakly_convex_segmentation/Parameters.h")
    for name in re.findall(r"\bParameters::(\w+)", text):
        if not re.search(rf"\b{name}\b", known):
            yield f"{file}: Parameters has no member {name}"


def check_readme_programs(project):
    programs = re.findall(r"```cpp\n(.*?)```", project.read("README.md"), re.S)
    files = [f for f in project.files if re.match(r"test/.*/readme_\w+\.cpp", f)]
    compiled = {f: project.read(f) for f in files}
    for program in programs:
        if not any(text.endswith("\n\n" + program) for text in compiled.values()):
            yield f"README.md: this program is none of {', '.join(files)}:\n{program}"
    if len(programs) != len(files):
        yield f"README.md has {len(programs)} programs, but {len(files)} are compiled"


def check_figures(project):
    """numbers of the manual are copied from the README, or are values of parameters; pictures are used"""
    manual, readme = project.manual(), project.read("README.md")
    for row in re.findall(r"^\| .*\d\.\d.*\|$", manual, re.M):
        if row not in readme:
            yield f"the manual has a row that README.md does not have: {row}"
    sources = readme + project.read("include/CGAL/Weakly_convex_segmentation/Parameters.h")
    known = set(re.findall(r"\d+(?:[.,]\d+)+", sources))
    outside_code = re.sub(r"\\code.*?\\endcode", "", manual, flags=re.S)
    for number in set(re.findall(r"(?<![\w.])\d+(?:[.,]\d+)+", outside_code)) - known:
        yield f"the manual has a figure {number} that README.md does not have"
    for file in project.files:
        path = pathlib.PurePath(file)
        if path.parts[-2:-1] == ("fig",) and path.name not in manual + readme:
            yield f"{file} is not used"


def check_examples(project):
    built = project.read("examples/Weakly_convex_segmentation/CMakeLists.txt")
    told = project.manual() + project.read(MANUAL / "examples.txt")
    for name in re.findall(r"Weakly_convex_segmentation/(\w+\.cpp)", told):
        if f'"{name}"' not in built:
            yield f"the manual quotes {name}, which is not built"


def check_tutorial(project):
    """runs the commands of the tutorial that are those of our programs, word for word"""
    manual = project.manual()
    tutorial = manual[manual.index("\\section wcsTutorial"):manual.index("\\section wcsApproach")]
    commands = [c for c in code_of(tutorial) if c.startswith("build/bin/") and " " in c]
    if len(commands) < 5:
        yield "the tutorial of the manual has hardly any commands"
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "build").mkdir()
        (pathlib.Path(folder) / "build/bin").symlink_to(project.programs.resolve())
        for command in commands:
            run = subprocess.run(command, shell=True, cwd=folder, capture_output=True, text=True,
                                 check=False)
            if run.returncode != 0:
                yield f"the tutorial's command '{command}' fails: {run.stderr.strip()}"


def check_readme_programs_run(project):
    with tempfile.TemporaryDirectory() as folder:
        for options, program, shape in (([], "readme_mesh", "dumbbell.off"),
                                        (["--cloud", "--points", "3000"], "readme_cloud", "dumbbell.ply")):
            if not (project.programs / program).exists():
                yield f"{program} is not built"
                continue
            subprocess.run([project.programs / "make_shapes", "-o", folder, *options, "dumbbell"], check=True)
            with open(pathlib.Path(folder) / shape, "rb") as stream:
                run = subprocess.run([project.programs / program], stdin=stream, capture_output=True,
                                     text=True, check=False)
            if run.returncode != 0 or not re.fullmatch(r"\d+ parts\n", run.stdout):
                yield f"{program} fails: {run.stdout}{run.stderr}"


def check_checks(project):
    """a check that finds nothing anywhere would be no check"""
    wrong = ("[a](no/such.md) [b](README.md#no-such-heading) `scripts/no_such_script` `no_such_header.h`\n"
             "`build/bin/no_such_program` `segment_shape --no-such-option` `--neither-this` Parameters::no_such\n"
             "`build/bin/segment_shape`\n| `--no-such-row N` | text |\n")
    found = [e for check in (check_links, check_files, check_options, check_parameters)
             for e in check(project, "README.md", wrong)]
    for word in ("no/such.md", "no-such-heading", "no_such_script", "no_such_header.h", "no_such_program",
                 "--no-such-option", "--neither-this", "no_such", "--no-such-row"):
        if not any(word in error for error in found):
            yield f"the check does not notice {word}"


def check_texts(source, programs):
    project = Project(source, pathlib.Path(programs))
    texts = {file: project.read(file) for file in MARKDOWN}
    texts[str(MANUAL / "Weakly_convex_segmentation.txt")] = project.manual()
    for file, text in texts.items():
        for check in (check_links, check_files, check_options, check_parameters):
            yield from check(project, file, text)
    for check in (check_checks, check_all_options_told, check_readme_programs, check_figures, check_examples,
                  check_readme_programs_run, check_tutorial):
        yield from check(project)


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src") and value:
                self.links.append(value)
            elif name == "id" or (name == "name" and tag == "a"):
                self.anchors.add(value)


def check_pages(folder):
    pages = {p: Page(p.read_text(encoding="utf-8")) for p in folder.rglob("*.html")}
    if folder / "index.html" not in pages:
        yield "the manual has no index.html"
    for path, page in pages.items():
        for link in page.links:
            url = urllib.parse.urlsplit(link)
            if url.scheme or url.netloc:
                continue
            target = path.parent / urllib.parse.unquote(url.path) if url.path else path
            if not target.exists():
                yield f"{path.name}: the link to {link} leads nowhere"
            elif url.fragment and target in pages and url.fragment not in pages[target].anchors:
                yield f"{path.name}: {link} names no place of that page"


def check_manual(doxyfile):
    with tempfile.TemporaryDirectory() as folder:
        settings = pathlib.Path(doxyfile).read_text(encoding="utf-8")
        settings += f'\nOUTPUT_DIRECTORY = "{folder}"\nWARN_AS_ERROR = FAIL_ON_WARNINGS\n'
        run = subprocess.run(["doxygen", "-"], input=settings, capture_output=True, text=True, check=False)
        if run.returncode != 0 or run.stderr.strip():
            yield f"Doxygen complains: {run.stderr.strip()}"
        pages = pathlib.Path(folder) / "html"
        yield from check_pages(pages)
        # and it would be noticed
        (pages / "broken.html").write_text('<a href="no_such_page.html">a</a>'
                                           '<a href="index.html#no_such">b</a>')
        found = list(check_pages(pages))
        if sum("no_such" in error for error in found) != 2:
            yield "the check does not notice broken links"


def check_making_of_figures(project, build, python):
    """two of them, as all take too long for a test"""
    with tempfile.TemporaryDirectory() as folder:
        command = [python, project.source / MANUAL / "make_figures", "--build", build, "--output", folder]
        run = subprocess.run([*command, "patches", "views"], capture_output=True, text=True, check=False)
        for name in ("patches.png", "views.png"):
            picture = pathlib.Path(folder) / name
            if run.returncode != 0 or not picture.exists() or picture.read_bytes()[:4] != b"\x89PNG":
                yield f"make_figures does not make {name}: {run.stderr.strip()}"


def python_that_draws():
    """a Python with matplotlib and PIL, which the distribution installs for its own"""
    for python in (sys.executable, "/usr/bin/python3"):
        command = [python, "-c", "import matplotlib, numpy, PIL"]
        if pathlib.Path(python).exists():
            if subprocess.run(command, capture_output=True, check=False).returncode == 0:
                return python
    return None


def main():
    if len(sys.argv) != 4 or sys.argv[1] not in ("texts", "manual", "figures"):
        sys.exit(__doc__)
    if sys.argv[1] == "texts":
        errors = check_texts(sys.argv[2], sys.argv[3])
    elif sys.argv[1] == "figures" and python_that_draws():
        errors = check_making_of_figures(Project(sys.argv[2]), sys.argv[3], python_that_draws())
    elif sys.argv[1] == "figures":
        print("matplotlib or PIL is not installed: no figures are made (scripts/setup.sh report)")
        sys.exit(77)
    elif shutil.which("doxygen"):
        errors = check_manual(sys.argv[3])
    else:
        print("Doxygen is not installed: the manual is not checked (scripts/setup.sh doc)")
        sys.exit(1 if os.environ.get("CI") == "true" else 77)
    told = set()
    for error in errors:
        if error not in told:
            print(error, flush=True)
            told.add(error)
    print(f"{len(told)} errors in the {sys.argv[1]}")
    sys.exit(1 if told else 0)


if __name__ == "__main__":
    main()
