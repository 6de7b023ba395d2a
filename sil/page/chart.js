// Chart: lines and points over a quantity, with a cursor that reads them off, and a range that can be chosen.

// The point that is read off at `x`: "nearest"; "last", until there; "next", from there on. The last of several at one
// x, and null where there is none. Points are in the order of x.
function pointAt(points, x, reading) {
  let low = -1;
  let high = points.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (points[middle][0] <= x + 1e-9) {
      low = middle;
    } else {
      high = middle - 1;
    }
  }
  const before = low < 0 ? null : points[low];
  if (reading === "last" || (before !== null && Math.abs(before[0] - x) <= 1e-9)) {
    return before;
  }
  let next = low + 1;
  while (next + 1 < points.length && points[next + 1][0] === points[next][0]) {
    next += 1;
  }
  const after = points[next] ?? null;
  if (reading === "next" || before === null || after === null) {
    return reading === "next" ? after : before ?? after;
  }
  return x - before[0] <= after[0] - x ? before : after;
}

// The line through the points as they are read off within the range: steps, unless the nearest point is read.
function pathOf(points, reading, range) {
  if (reading === "nearest") {
    return points;
  }
  const path = [];
  let previous = null;
  for (const point of points) {
    if (previous !== null) {
      path.push([reading === "last" ? point[0] : previous[0], (reading === "last" ? previous : point)[1]]);
    }
    path.push(point);
    previous = point;
  }
  if (previous !== null && reading === "last" && previous[0] < range.to) {
    path.push([range.to, previous[1]]);
  } else if (previous !== null && reading === "next" && points[0][0] > range.from) {
    path.unshift([range.from, points[0][1]]);
  }
  return path;
}

const BAND_OPACITY = 0.3;

class Chart {
  // `chart`: as StudyChart (study_page.hpp) says it.
  constructor(parent, chart) {
    Object.assign(this, chart);
    this.series = chart.series.map((each) => ({ ...each, shown: each.shown !== false }));
    this.cursor = null;
    this.make(parent);
    this.showWhole();
  }

  make(parent) {
    this.box = document.createElement("figure");
    this.box.className = "chart";
    this.box.dataset.chart = this.name;
    this.box.innerHTML = '<figcaption><span></span><button type="button" class="whole" hidden>Whole range</button></figcaption>' +
      '<canvas tabindex="0" role="img"></canvas><p class="readout" aria-live="polite"></p><ul class="series"></ul>';
    this.box.querySelector("figcaption span").textContent = this.heading;
    this.canvas = this.box.querySelector("canvas");
    this.canvas.setAttribute("aria-label", `${this.heading}: ${this.y.words} over ${this.x.words}`);
    this.readout = this.box.querySelector(".readout");
    this.wholeButton = this.box.querySelector(".whole");
    this.wholeButton.addEventListener("click", () => this.showWhole());
    for (const each of this.series) {
      const item = document.createElement("li");
      item.innerHTML = `<button type="button">${lineSample(each.colour, each.dash, each.width ?? 2)}<span></span><output></output></button>`;
      each.button = item.firstChild;
      each.button.querySelector("path").style.opacity = each.style === "band" ? BAND_OPACITY : 1;
      each.button.dataset.series = each.words;
      each.button.setAttribute("aria-pressed", String(each.shown));
      each.button.querySelector("span").textContent = each.words;
      each.button.addEventListener("click", () => this.toggle(each));
      this.box.querySelector(".series").append(item);
    }
    if (this.note) {
      const note = document.createElement("p");
      note.className = "note";
      note.textContent = this.note;
      this.box.append(note);
    }
    parent.append(this.box);
    this.canvas.addEventListener("pointermove", (event) => this.onPointer(event));
    this.canvas.addEventListener("pointerdown", (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      this.dragFrom = event.offsetX;
      this.onPointer(event);
    });
    this.canvas.addEventListener("pointerup", (event) => this.onRelease(event));
    this.canvas.addEventListener("pointercancel", () => { this.dragFrom = undefined; });
    this.canvas.addEventListener("dblclick", () => this.showWhole());
    this.canvas.addEventListener("keydown", (event) => this.onKey(event));
  }

  // ---- the range

  get wholeRange() {
    let from = this.x.from ?? Infinity;
    let to = this.x.to ?? -Infinity;
    for (const { points } of this.series) {
      for (const [x] of points) {
        from = this.x.from === undefined && x < from ? x : from;
        to = this.x.to === undefined && x > to ? x : to;
      }
    }
    return from < to ? { from, to } : { from: (Number.isFinite(from) ? from : 0) - 1, to: (Number.isFinite(from) ? from : 0) + 1 };
  }

  showWhole() { this.showRange(this.wholeRange, false); }

  showRange(range, chosen) {
    this.range = range;
    this.wholeButton.hidden = !chosen;
    this.draw();
  }

  toggle(series) {
    series.shown = !series.shown;
    series.button.setAttribute("aria-pressed", String(series.shown));
    this.draw();
  }

  // ---- the cursor

  onPointer(event) {
    if (this.frame) {
      this.dragTo = event.offsetX;
      this.moveTo(this.frame.fromX(event.offsetX));
    }
  }

  onRelease(event) {
    const from = this.dragFrom;
    this.dragFrom = undefined;
    if (from !== undefined && this.frame && Math.abs(event.offsetX - from) > 12) {
      const ends = [this.frame.fromX(from), this.frame.fromX(event.offsetX)].sort((a, b) => a - b);
      this.showRange({ from: Math.max(ends[0], this.range.from), to: Math.min(ends[1], this.range.to) }, true);
    } else {
      this.draw();
    }
  }

  onKey(event) {
    const steps = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (event.ctrlKey || event.altKey || event.metaKey) {
      return;
    }
    const middle = this.cursor ?? (this.range.from + this.range.to) / 2;
    const half = (this.range.to - this.range.from) / 2;
    if (steps) {
      this.moveTo(middle + (steps * half) / (event.shiftKey ? 10 : 100));
    } else if (event.key === "Home" || event.key === "End") {
      this.moveTo(event.key === "Home" ? this.range.from : this.range.to);
    } else if (event.key === "+") {
      this.showRange({ from: middle - half / 2, to: middle + half / 2 }, true);
    } else if (event.key === "-") {
      this.showWhole();
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  }

  moveTo(x) {
    this.cursor = Math.min(Math.max(x, this.range.from), this.range.to);
    this.draw();
  }

  // The series' value at the cursor; the nearest mark.
  pointOf(series) {
    if (series.style === "cloud") {
      return null;
    }
    const point = pointAt(series.points, this.cursor, series.style === "mark" ? "nearest" : this.reading);
    const far = series.style === "mark" && point !== null && Math.abs(point[0] - this.cursor) > 0.05 * (this.range.to - this.range.from);
    return far ? null : point;
  }

  showReadout() {
    if (this.cursor === null) {
      this.readout.textContent = "";
      return;
    }
    this.readout.textContent = `${this.x.words}: ${numberText(this.cursor, this.x.digits ?? 2)}${this.x.unit ? " " + this.x.unit : ""}`;
    for (const each of this.series) {
      const output = each.button.querySelector("output");
      const point = this.pointOf(each);
      const value = point === null ? null : point[1];
      output.dataset.x = value === null ? "" : String(point[0]);
      output.dataset.value = value === null ? "" : String(value);
      const [unit, digits] = [this.y.unit ? " " + this.y.unit : "", this.y.digits ?? 2];
      if (value === null) {
        output.textContent = "";
      } else if (each.style === "band") {
        output.textContent = `${numberText(value, digits)} to ${numberText(point[2], digits)}${unit}`;
      } else {
        output.textContent = numberText(value, digits) + unit + (point.length > 2 ? ` (${numberText(point[2], 3)})` : "");
      }
    }
  }

  // ---- the picture

  get shownSeries() { return this.series.filter((each) => each.shown); }

  yRange() {
    let { from = Infinity, to = -Infinity } = this.y.least ?? {};
    for (const { points, style } of this.shownSeries) {
      // A step may go through the range and have no point in it.
      const ends = style === "line" && this.reading !== "nearest"
        ? [this.range.from, this.range.to].map((x) => [x, pointAt(points, x, this.reading)?.[1] ?? null]) : [];
      for (const [x, y, end] of points.concat(ends)) {
        if (x >= this.range.from && x <= this.range.to && y !== null) {
          from = Math.min(from, y);
          to = Math.max(to, style === "band" && end !== null ? end : y);
        }
      }
    }
    if (!(from < to)) {
      from = Number.isFinite(from) ? from - 1 : 0;
      to = from + 2;
    }
    const room = 0.05 * (to - from);
    return { from: from === 0 ? 0 : from - room, to: to + room };
  }

  draw() {
    if (!this.canvas.isConnected) {
      return;
    }
    const sheet = prepare(this.canvas);
    if (sheet.width < 80) {
      return;
    }
    const { pen } = sheet;
    this.frame = new Frame(sheet, { left: 52, right: 12, top: 22, bottom: 38 }, this.range, this.yRange());
    const { frame } = this;
    frame.drawAxes(true);
    const unitOf = (axis) => axis.words + (axis.unit ? ` [${axis.unit}]` : "");
    pen.fillStyle = colourOf("--quiet");
    pen.textBaseline = "middle";
    pen.textAlign = "right";
    pen.fillText(unitOf(this.x), frame.right, frame.bottom + 27);
    pen.textAlign = "left";
    pen.fillText(unitOf(this.y), frame.left, 10);
    frame.clipped(() => {
      for (const mark of this.marks ?? []) {
        if (mark.x !== undefined) {
          frame.line(frame.toX(mark.x), frame.top, frame.toX(mark.x), frame.bottom, "--quiet", [3, 3]);
        } else {
          frame.line(frame.left, frame.toY(mark.y), frame.right, frame.toY(mark.y), "--quiet", [3, 3]);
        }
      }
      for (const each of this.shownSeries) {
        this.drawSeries(pen, each);
      }
      this.drawCursor(pen);
    });
    this.showReadout();
  }

  drawSeries(pen, series) {
    const { frame } = this;
    pen.save();
    pen.strokeStyle = pen.fillStyle = colourOf(series.colour);
    if (series.style === "band") {
      this.drawBand(pen, series);
    } else if (series.style !== "line") {
      pen.globalAlpha = series.style === "cloud" ? 0.45 : 1;
      for (const [x, y] of series.points) {
        if (y !== null && x >= this.range.from && x <= this.range.to) {
          drawShape(pen, series.style === "cloud" ? "circle" : "diamond", frame.toX(x), frame.toY(y), series.style === "cloud" ? 1.4 : 5);
        }
      }
    } else {
      pen.lineWidth = series.width ?? 2;
      pen.lineJoin = "round";
      pen.setLineDash(series.dash ?? []);
      pen.beginPath();
      let open = false;
      for (const [x, y] of pathOf(series.points, this.reading, this.range)) {
        if (y === null) {
          open = false;
        } else if (open) {
          pen.lineTo(frame.toX(x), frame.toY(y));
        } else {
          pen.moveTo(frame.toX(x), frame.toY(y));
          open = true;
        }
      }
      pen.stroke();
    }
    pen.restore();
  }

  // Piece by piece: along one end and back along the other.
  drawBand(pen, series) {
    const { frame } = this;
    const pieces = [[]];
    for (const point of series.points) {
      if (point[1] === null || point[2] === null) {
        pieces.push([]);
      } else {
        pieces[pieces.length - 1].push(point);
      }
    }
    pen.globalAlpha = BAND_OPACITY;
    for (const piece of pieces) {
      pen.beginPath();
      piece.forEach(([x, y]) => pen.lineTo(frame.toX(x), frame.toY(y)));
      piece.reverse().forEach(([x, , end]) => pen.lineTo(frame.toX(x), frame.toY(end)));
      pen.fill();
    }
  }

  drawCursor(pen) {
    const { frame } = this;
    if (this.dragFrom !== undefined && this.dragTo !== undefined) {
      pen.save();
      pen.globalAlpha = 0.15;
      pen.fillStyle = colourOf("--accent");
      pen.fillRect(this.dragFrom, frame.top, this.dragTo - this.dragFrom, frame.bottom - frame.top);
      pen.restore();
    }
    if (this.cursor === null || this.cursor < this.range.from || this.cursor > this.range.to) {
      return;
    }
    frame.line(frame.toX(this.cursor), frame.top, frame.toX(this.cursor), frame.bottom, "--ink", [], 1);
    for (const each of this.shownSeries) {
      const point = this.pointOf(each);
      if (point !== null && point[1] !== null && each.style !== "band") {
        pen.fillStyle = colourOf(each.colour);
        drawShape(pen, "circle", frame.toX(point[0]), frame.toY(point[1]), 3.2);
      }
    }
  }
}
