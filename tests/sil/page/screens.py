"""Layout of a page: what is in sight together, whether it is wider than the screen, and whether its texts can be read.

Use: screens.py VERDICT.html: of the page that `sil/tools/logs verdict` makes.
"""
import json
import pathlib
import sys
import unittest

SIZES = ((1440, 900, False), (1024, 768, False), (390, 844, True))
THEMES = ("light", "dark")
LEAST_CONTRAST = 4.5  # WCAG 2.1, 1.4.3

# The least contrast of a visible text to what is behind it, with the opacity of its elements, and that text.
CONTRAST = """(() => {
  const numbers = (text) => text.match(/[\\d.]+/g).map(Number);
  const light = (colour) => colour.slice(0, 3).map((each) => each / 255).map((each) =>
    each <= 0.04045 ? each / 12.92 : ((each + 0.055) / 1.055) ** 2.4).reduce((sum, each, place) =>
    sum + each * [0.2126, 0.7152, 0.0722][place], 0);
  const over = (front, back, alpha) => front.map((each, place) => alpha * each + (1 - alpha) * back[place]);
  const alphaOf = (colour) => colour[3] ?? 1;
  const behind = (element) => {
    if (!element) {
      return numbers(getComputedStyle(document.body).backgroundColor).slice(0, 3);
    }
    const colour = numbers(getComputedStyle(element).backgroundColor);
    const below = behind(element.parentElement);
    return alphaOf(colour) > 0 ? over(colour.slice(0, 3), below, alphaOf(colour)) : below;
  };
  let least = [21, ""];
  for (const element of document.body.querySelectorAll("*")) {
    const box = element.getBoundingClientRect();
    const text = [...element.childNodes].filter((node) => node.nodeType === 3).map((node) => node.data.trim()).join("");
    if (!text || !element.checkVisibility() || box.width < 2 || element.matches(":disabled, script, style, noscript")) {
      continue;
    }
    let opacity = 1;
    for (let each = element; each; each = each.parentElement) {
      opacity *= Number(getComputedStyle(each).opacity);
    }
    const ground = behind(element);
    const [a, b] = [light(over(numbers(getComputedStyle(element).color).slice(0, 3), ground, opacity)), light(ground)];
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    least = contrast < least[0] ? [contrast, text] : least;
  }
  return JSON.stringify(least);
})()"""


def expect_layout(case, tab, together, bar=None):
    """At the size that the tab has: `together` are whole in sight without scrolling. `bar` covers what is behind it, and may
    hold some of them."""
    width = tab.run("innerWidth")
    case.assertLessEqual(tab.run("document.documentElement.scrollWidth"), width)
    for name in together:
        left, top, right, bottom, end = json.loads(tab.run(f"""(() => {{
            const element = document.querySelector({json.dumps(name)});
            const bar = document.querySelector({json.dumps(bar)});
            const box = element.getBoundingClientRect();
            const end = !bar || bar.contains(element) ? innerHeight : bar.getBoundingClientRect().top;
            return JSON.stringify([box.left, box.top, box.right, box.bottom, end]); }})()"""))
        case.assertTrue(0 <= left < right <= width and 0 <= top < bottom <= end, (name, width, (left, top, right, bottom), end))
    tab.run("document.getAnimations().forEach((each) => each.finish())")
    contrast, text = json.loads(tab.run(CONTRAST))
    case.assertGreaterEqual(contrast, LEAST_CONTRAST, text)


def each_screen(tab):
    """The sizes, light and dark in turn: every page is seen in both."""
    for place, (width, height, phone) in enumerate(SIZES):
        tab.size(width, height, phone)
        tab.theme(THEMES[place % 2])
        yield width
    tab.theme("dark")
    yield width
    tab.theme("light")


def expect_verdict(file):
    from browser import browser  # needs websockets, which only this use of the file has

    case = unittest.TestCase()
    with browser() as tab:
        tab.open(pathlib.Path(file).resolve().as_uri(), is_ready="document.readyState === 'complete'")
        for width in each_screen(tab):
            expect_layout(case, tab, ["h1", "h2", ".pictures figure:first-child"])
            tops = json.loads(tab.run("JSON.stringify([...document.querySelectorAll('.pictures')].map((each) =>"
                                      "[...each.children].map((one) => one.getBoundingClientRect().top)))"))
            for path, acceleration in tops:
                case.assertEqual(path == acceleration, width > 390, "beside each other, except on a phone")
        case.assertEqual(tab.complaints, [])


if __name__ == "__main__":
    expect_verdict(*sys.argv[1:])
