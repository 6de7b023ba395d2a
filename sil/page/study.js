// Study: the report of a campaign, an identification or the like; sections of texts, tables and charts.
class SortedTable {
  // `table`: as Table (table.hpp) says it.
  constructor(parent, table) {
    Object.assign(this, table);
    this.order = { column: -1, descending: false };
    this.box = document.createElement("div");
    this.box.className = "table";
    this.box.dataset.table = this.name;
    this.box.tabIndex = 0;
    this.box.setAttribute("role", "region");
    this.box.setAttribute("aria-label", this.heading);
    if (this.heading) {
      const heading = document.createElement("h3");
      heading.textContent = this.heading;
      parent.append(heading);
    }
    this.table = document.createElement("table");
    const head = this.table.createTHead().insertRow();
    this.columns.forEach((column, place) => {
      const cell = document.createElement("th");
      cell.scope = "col";
      cell.className = column.digits < 0 ? "words" : "";
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = column.words + (column.unit ? ` [${column.unit}]` : "");
      button.addEventListener("click", () => this.sortBy(place));
      cell.append(button);
      head.append(cell);
    });
    this.body = this.table.createTBody();
    this.box.append(this.table);
    parent.append(this.box);
    if (this.note) {
      const note = document.createElement("p");
      note.className = "note";
      note.textContent = this.note;
      parent.append(note);
    }
    this.show(this.rows);
  }

  // Unknown values stand at the end in either order.
  sortBy(column) {
    const descending = this.order.column === column ? !this.order.descending : this.columns[column].digits >= 0;
    this.order = { column, descending };
    const key = (row) => (Array.isArray(row[column]) ? row[column][0] : row[column]);
    const compared = (a, b) => (typeof a === "number" ? a - b : a.localeCompare(b, "en", { numeric: true }));
    const known = this.rows.filter((row) => row[column] !== null);
    known.sort((a, b) => (descending ? -1 : 1) * compared(key(a), key(b)));
    this.show(known.concat(this.rows.filter((row) => row[column] === null)));
    [...this.table.tHead.rows[0].cells].forEach((cell, place) => {
      if (place === column) {
        cell.setAttribute("aria-sort", descending ? "descending" : "ascending");
      } else {
        cell.removeAttribute("aria-sort");
      }
    });
  }

  show(rows) {
    this.body.replaceChildren(...rows.map((row) => {
      const line = document.createElement("tr");
      row.forEach((value, place) => {
        const { digits } = this.columns[place];
        const cell = line.insertCell();
        cell.className = digits < 0 ? "words" : "";
        if (value === null || typeof value === "string") {
          cell.textContent = value ?? "\u2013";
          return;
        }
        const [number, ...interval] = [value].flat().map((each) => numberText(each, digits));
        cell.textContent = number + (interval.length > 0 ? ` (${interval.join(" to ")})` : "");
      });
      return line;
    }));
  }
}

class Study extends Sheet {
  constructor(study) {
    super();
    this.charts = {};
    byId("title").textContent = study.title;
    document.title = study.title;
    byId("subtitle").textContent = study.subtitle;
    study.sections.forEach((section, place) => this.make(section, place));
    this.listKeys();
    this.open();
    document.body.dataset.ready = "yes";
  }

  make(section, place) {
    const panel = document.createElement("section");
    panel.className = "panel";
    panel.id = `section-${place}`;
    const heading = document.createElement("h2");
    heading.id = `heading-${place}`;
    heading.textContent = section.heading;
    panel.setAttribute("aria-labelledby", heading.id);
    panel.append(heading);
    byId("sections").append(panel);
    const link = document.createElement("a");
    link.href = `#${panel.id}`;
    link.textContent = section.heading;
    byId("contents").append(link);
    const charts = document.createElement("div");
    charts.className = "charts";
    for (const block of section.blocks) {
      if (block.kind === "chart") {
        panel.append(charts);
        this.charts[block.name] = new Chart(charts, block);
      } else {
        this.makeBlock(panel, block);
      }
    }
  }

  makeBlock(panel, block) {
    if (block.kind === "table") {
      new SortedTable(panel, block);
    } else if (block.kind === "list") {
      const list = document.createElement("ul");
      list.className = "sentences";
      for (const text of block.items) {
        list.append(Object.assign(document.createElement("li"), { textContent: text }));
      }
      panel.append(list);
    } else {
      panel.append(Object.assign(document.createElement("p"), { textContent: block.text, className: "text" }));
    }
  }

  ownKeys() {
    const nothing = () => {};
    return [
      { key: "", shown: "\u2190 \u2192", words: "in a chart: move the cursor (Shift: faster)", act: nothing },
      { key: "", shown: "+ \u2212", words: "in a chart: nearer, the whole range", act: nothing },
    ];
  }

  render() {
    for (const chart of Object.values(this.charts)) {
      chart.draw();
    }
  }
}

const study = new Study(JSON.parse(byId("study").textContent));
