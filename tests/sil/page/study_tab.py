"""The page of a study in a browser: what its charts read off, and what its tables hold."""
import json


class StudyTab:
    """A tab with such a page in it."""

    def __init__(self, tab, file):
        self.tab = tab
        self.tab.open(file.as_uri())

    def run(self, script):
        return self.tab.run(script)

    def read_off(self, chart, x):
        """The point of every line of the chart, by its words, that is nearest to `x`, as it is shown: x, value, text."""
        self.run(f"study.charts[{json.dumps(chart)}].moveTo({x})")
        shown = json.loads(self.run(
            f"JSON.stringify(study.charts[{json.dumps(chart)}].series.map((each) => {{"
            "const output = each.button.querySelector('output');"
            "return [each.words, output.dataset.x, output.dataset.value, output.textContent]; }))"))
        return {words: (float(at) if at else None, float(value) if value else None, text) for words, at, value, text in shown}

    def table(self, name):
        """Its rows as texts, in the order in which they are shown."""
        return json.loads(self.run(f"JSON.stringify([...document.querySelectorAll('[data-table={name}] tbody tr')].map((row) =>"
                                   "[...row.cells].map((cell) => cell.textContent)))"))

    def columns(self, name):
        return json.loads(self.run(f"JSON.stringify([...document.querySelectorAll('[data-table={name}] thead th')].map((cell) =>"
                                   "cell.textContent))"))

    def sort_by(self, name, column):
        self.run(f"document.querySelectorAll('[data-table={name}] thead button')[{column}].click()")

    def text(self):
        return self.run("document.body.innerText")


def number_text(value, digits):
    """A number, or none, as a table shows it."""
    if value is None:
        return "\u2013"
    text = f"{abs(value):.{digits}f}"
    return ("\u2212" if value < 0 and float(text) != 0 else "") + text


def expect_plain_page(case, tab, file):
    """Loads nothing, runs nothing else, holds no element that a name has made, and fits a phone in both themes."""
    text = file.read_text(encoding="utf-8")
    for outside in ("http:", "https:", "src=\"", "@import", "url("):
        case.assertNotIn(outside, text)
    for theme, ground in (("light", "rgb(244, 245, 246)"), ("dark", "rgb(16, 19, 22)")):
        tab.theme(theme)
        tab.size(390, 844, phone=True)
        page = StudyTab(tab, file)
        case.assertEqual(page.run("getComputedStyle(document.body).backgroundColor"), ground)
        case.assertLessEqual(page.run("document.documentElement.scrollWidth"), 390)
        case.assertEqual(page.run("[...document.querySelectorAll('canvas')].filter((each) => !each.getContext('2d').getImageData("
                                  "0, 0, each.width, each.height).data.some((byte) => byte > 0)).length"), 0)
    case.assertEqual(page.run("performance.getEntriesByType('resource').length"), 0)
    case.assertEqual(page.run("document.querySelectorAll('img, iframe').length"), 0)
    case.assertIsNone(page.run("document.body.dataset.intruder ?? null"))
    case.assertEqual(tab.complaints, [])
    page.run("(() => { const other = document.createElement('script'); other.textContent = 'document.body.dataset.intruder = 1';"
             "document.body.append(other); })()")
    case.assertIsNone(page.run("document.body.dataset.intruder ?? null"))
    case.assertTrue(any("Content Security Policy" in each for each in tab.complaints), tab.complaints)
    tab.complaints.clear()
    tab.theme("light")
    tab.size(1360, 900)
