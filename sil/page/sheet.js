// Sheet: what all pages have: light and dark, and keys.
const byId = (id) => document.getElementById(id);

function numberText(value, digits, signed) {
  if (value === null || Number.isNaN(value)) {
    return "\u2013";
  }
  const text = Math.abs(value).toFixed(digits);
  if (Number(text) === 0) {
    return text;
  }
  return (value < 0 ? "\u2212" : signed ? "+" : "") + text;
}

class Sheet {
  constructor() {
    this.view = { theme: "light" };
  }

  // Once the parts are made.
  open() {
    this.chooseTheme(matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
    byId("theme").addEventListener("click", () => this.chooseTheme(this.view.theme === "dark" ? "light" : "dark"));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", (change) => this.chooseTheme(change.matches ? "dark" : "light"));
    byId("help").addEventListener("click", () => this.toggleHelp());
    new ResizeObserver(() => this.render()).observe(document.body);
    document.addEventListener("keydown", (event) => this.onKey(event));
  }

  chooseTheme(theme) {
    document.documentElement.dataset.theme = theme;
    this.view.theme = theme;
    byId("theme").textContent = theme === "dark" ? "Light" : "Dark";
    this.render();
  }

  toggleHelp() {
    byId("keys").hidden = !byId("keys").hidden;
    byId("help").setAttribute("aria-expanded", String(!byId("keys").hidden));
  }

  // Keys of this page, besides those of all: { key, shown, words, act }.
  ownKeys() { return []; }

  keys() {
    return this.ownKeys().concat([
      { key: "t", words: "light or dark", act: () => byId("theme").click() },
      { key: "?", words: "these keys", act: () => this.toggleHelp() },
    ]);
  }

  listKeys() {
    byId("key-list").innerHTML = this.keys().map((each) => `<div><dt>${each.words}</dt><dd><kbd>${each.shown ?? each.key}</kbd></dd></div>`).join("");
  }

  // A field that the keys mean something to keeps them.
  onKey(event) {
    const target = event.target;
    const ownKeys = target instanceof HTMLSelectElement || (target instanceof HTMLInputElement && event.key.startsWith("Arrow")) ||
      (target instanceof HTMLButtonElement && (event.key === " " || event.key === "Enter"));
    if (ownKeys || event.ctrlKey || event.altKey || event.metaKey) {
      return;
    }
    const found = this.keys().find((each) => each.key === event.key || each.key === event.key.toLowerCase());
    if (found) {
      event.preventDefault();
      found.act(event);
    }
  }
}
