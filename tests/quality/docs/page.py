"""A Markdown page: its lines, and what of them is code, comment or prose."""

import pathlib
import re

CHANGELOG = "CHANGELOG.md"
FENCE = re.compile(r"^\s*(```|~~~)")
HEADING = re.compile(r"^(#{1,6})\s+(.*?)\s*#*\s*$")
ITEM = re.compile(r"^\s*(?:[-+*]|\d+\.)\s")
COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
INLINE_CODE = re.compile(r"`[^`]*`")
LINK = re.compile(r"!?\[([^\]]*)\]\(([^)\s]+)\)")


def blanked(text):
    """As many blanks, and the line breaks stay: places keep their line and column."""
    return re.sub(r"[^\n]", " ", text)


class Page:
    def __init__(self, project, path, text=None):
        self.project = project
        self.path = path  # from the project's folder
        self.text = (project / path).read_text(encoding="utf-8") if text is None else text
        self.lines = self.text.splitlines()
        self.in_fence = []  # by line
        open_fence = False
        for line in self.lines:
            fence = bool(FENCE.match(line))
            self.in_fence.append(open_fence or fence)
            open_fence ^= fence

    def place(self, offset):
        return f"{self.path}:{self.text.count(chr(10), 0, offset) + 1}"

    def without_fences(self):
        return "\n".join(blanked(line) if fenced else line for line, fenced in zip(self.lines, self.in_fence))

    def prose(self):
        """Text without code, comments and the targets of links."""
        text = COMMENT.sub(lambda found: blanked(found[0]), self.without_fences())
        text = INLINE_CODE.sub(lambda found: blanked(found[0]), text)
        return LINK.sub(lambda found: found[0][: found.start(2) - found.start()] + blanked(found[2]) + ")", text)

    def links(self):
        """Place and target of every link and picture."""
        text = INLINE_CODE.sub(lambda found: blanked(found[0]), self.without_fences())
        return [(self.place(found.start()), found[2]) for found in LINK.finditer(text)]

    def code(self):
        """Place and text of every inline code span and of every line within a fence."""
        text = COMMENT.sub(lambda found: blanked(found[0]), self.without_fences())
        found = [(self.place(span.start()), span[0].strip("`")) for span in INLINE_CODE.finditer(text)]
        fences = [(f"{self.path}:{number}", line) for number, (line, fenced) in enumerate(zip(self.lines, self.in_fence), 1)
                  if fenced and not FENCE.match(line)]
        return found, fences

    def list_items_by_accident(self):
        """Lines that Markdown takes for items of a list, in the middle of a paragraph or of a code span."""
        text = COMMENT.sub(lambda found: blanked(found[0]), self.without_fences())
        found, in_list, in_code, before = [], False, False, ""
        for number, line in enumerate(text.splitlines(), 1):
            if not before.strip() or HEADING.match(before):
                in_list, in_code = bool(ITEM.match(line)), False
            elif ITEM.match(line) and (in_code or not in_list or (line[0] == " " and not before.endswith(":"))):
                found.append(f"{self.path}:{number}: begins like an item of a list within a paragraph: break the line "
                             "elsewhere")
            in_code ^= line.count("`") % 2 == 1
            before = line
        return found

    def anchors(self):
        """Anchors of the headings, as GitHub makes them."""
        found = set()
        for line, fenced in zip(self.lines, self.in_fence):
            heading = None if fenced else HEADING.match(line)
            if not heading:
                continue
            words = LINK.sub(lambda link: link[1], heading[2]).replace("`", "")
            anchor = re.sub(r"[^\w\- ]", "", words.lower()).replace(" ", "-")
            number = 0
            while (name := anchor if number == 0 else f"{anchor}-{number}") in found:
                number += 1
            found.add(name)
        return found


def tracked(project):
    """Paths of all files of the project; without git, of whatever is there but for build folders."""
    import subprocess

    done = subprocess.run(["git", "-C", str(project), "ls-files", "--cached", "--others", "--exclude-standard"],
                          capture_output=True, text=True, check=False)
    if done.returncode == 0:
        names = done.stdout.splitlines()
    else:
        names = [str(file.relative_to(project)) for file in project.rglob("*") if file.is_file()]
        names = [name for name in names if not name.startswith(("build/", "output/", ".git/"))]
    return sorted(name for name in names if (project / name).is_file())


def newest_changes(project):
    """CHANGELOG.md down to the end of its newest version; what older ones name need not be there any more."""
    if not (project / CHANGELOG).is_file():
        return None
    text = (project / CHANGELOG).read_text(encoding="utf-8")
    older = [found.start() for found in re.finditer(r"^## ", text, re.MULTILINE)][1:]
    text = text[: older[0]] if older else text
    return Page(project, CHANGELOG, re.sub(r"\(were? [^)]*\)|\(was [^)]*\)", lambda found: blanked(found[0]), text))


def written_pages(project):
    """Pages written by hand; CHANGELOG.md is checked for its newest version only (newest_changes)."""
    pages = [str(page.relative_to(project)) for page in (project / "docs").glob("*.md")]
    return sorted(pages) + [name for name in ("README.md", "CONTRIBUTING.md", "SECURITY.md") if (project / name).is_file()]


def all_pages(project):
    return sorted({*written_pages(project), *(name for name in tracked(project) if name.endswith(".md"))})
