// Charts: strips over time and the plane of lateral acceleration and roll, on canvases.
const EVENTS = [
  { name: "warning", words: "warning", colour: "--vermilion", dash: [], shape: "square" },
  { name: "one_wheel_lift", words: "one wheel lifts", colour: "--orange", dash: [7, 4], shape: "triangle" },
  { name: "two_wheel_lift", words: "two wheels lift", colour: "--ink", dash: [8, 3, 2, 3], shape: "circle" },
  { name: "ssf_crossing", words: "SSF crossed", colour: "--purple", dash: [3, 3], shape: "diamond" },
];

// Source of the value: only a simulated vehicle's is true.
function sourceOf(column) {
  const words = { true: "vehicle", sensor: "sensor", observed: "observer" };
  return words[column.split("_", 1)[0]] ?? "component";
}

// Both ends of what `quantities` reach in the rows, at least `least` and with some room.
function rangeOf(recording, quantities, first, last, least, symmetric) {
  let from = least.from;
  let to = least.to;
  const end = Math.min(last, recording.lastUpright);
  for (let row = first; row <= end; row += 1) {
    for (const quantity of quantities) {
      const value = recording.value(quantity, row);
      if (value < from) {
        from = value;
      }
      if (value > to) {
        to = value;
      }
    }
  }
  if (symmetric) {
    to = Math.max(to, -from);
    from = -to;
  }
  const room = 0.06 * (to - from);
  return { from: from === 0 ? 0 : from - room, to: to + room };
}

const STRIPS = [
  { name: "steering", words: "Steering wheel", unit: "deg", least: { from: -20, to: 20 }, digits: 0,
    lines: [{ quantity: "steering", words: "angle", colour: "--blue", width: 2 }] },
  { name: "acceleration", words: "Lateral acceleration", unit: "g", least: { from: -0.2, to: 0.2 }, digits: 3, ssf: true,
    lines: [{ quantity: "measuredAcceleration", words: "sensor", colour: "--sky", width: 1, optional: true },
      { quantity: "acceleration", ofSource: true, colour: "--blue", width: 2 },
      { quantity: "threshold", words: "threshold", colour: "--vermilion", width: 2, dash: [6, 3], breaks: true, outside: true }] },
  { name: "level", words: "Level of the warning", unit: "\u2013", least: { from: 0, to: 1.15 }, digits: 3, limit: 1, limitWords: "level 1",
    lines: [{ quantity: "rsi", words: "RSI as published", colour: "--purple", width: 1.3, dash: [4, 3] },
      { quantity: "level", words: "level", colour: "--blue", width: 2 }] },
  { name: "roll", words: "Roll angle to the road", unit: "deg", least: { from: -2, to: 2 }, digits: 2,
    lines: [{ quantity: "measuredRoll", words: "sensor", colour: "--sky", width: 1, optional: true },
      { quantity: "roll", ofSource: true, colour: "--blue", width: 2 }] },
];

function shapeSample(event) {
  const shapes = {
    square: '<rect x="4" y="2" width="8" height="8"/>', triangle: '<path d="M8 1l5 10H3z"/>',
    circle: '<circle cx="8" cy="6" r="4.5"/>', diamond: '<path d="M8 0l6 6-6 6-6-6z"/>',
  };
  return `<svg viewBox="0 0 16 12" aria-hidden="true" fill="var(${event.colour})">${shapes[event.shape]}</svg>`;
}

class Strip {
  constructor(parent, description, isLast) {
    Object.assign(this, description);
    this.isLast = isLast;
    this.still = document.createElement("canvas");
    this.stillKey = "";
    const box = document.createElement("div");
    box.className = "strip";
    box.innerHTML = `<h3><span>${this.words} [${this.unit}]</span><span class="legend">` +
      this.lines.map((line) => `<span data-line="${line.quantity}">${lineSample(line.colour, line.dash, line.width)} <b>${line.words ?? ""}</b></span>`)
        .join(" ") + (this.ssf ? ` <span>${lineSample("--purple", [3, 3], 1)} SSF</span>` : "") +
      (this.limit ? ` <span>${lineSample("--vermilion", [2, 3], 1)} ${this.limitWords}</span>` : "") + "</span></h3>";
    this.canvas = document.createElement("canvas");
    this.canvas.setAttribute("role", "img");
    this.canvas.dataset.strip = this.name;
    box.append(this.canvas);
    parent.append(box);
    this.box = box;
  }

  use(recording) {
    this.stillKey = "";
    // Two lines may be of one column: then the vehicle's own values are not known.
    this.shown = this.lines.filter((line, place) => recording.has(line.quantity) &&
      !this.lines.some((other, after) => after > place && recording.names[other.quantity] === recording.names[line.quantity]));
    for (const line of this.lines) {
      const item = this.box.querySelector(`[data-line="${line.quantity}"]`);
      item.hidden = !this.shown.includes(line);
      if (line.ofSource && recording.has(line.quantity)) {
        item.querySelector("b").textContent = sourceOf(recording.names[line.quantity]);
      }
    }
    this.box.hidden = this.shown.length === 0;
  }

  // The static part is drawn once and kept.
  draw(recording, view) {
    const { pen, width, height } = prepare(this.canvas);
    if (width < 80 || recording.length === 0) {
      return;
    }
    const key = [width, height, devicePixelRatio, view.from, view.to, recording.changes, recording.length, view.theme].join();
    if (key !== this.stillKey) {
      this.stillKey = key;
      this.drawStill(recording, view, width, height);
    }
    pen.drawImage(this.still, 0, 0, width, height);
    const x = this.frame.toX(view.time);
    this.frame.pen = pen;
    this.frame.line(x, this.frame.top, x, this.frame.bottom, "--ink", [], 1.2);
    for (const line of this.shown) {
      const raw = recording.value(line.quantity, view.row);
      const value = line.breaks ? recording.sideAt(view.row, 1) * Math.abs(raw) : raw;
      if (!Number.isNaN(value) && !line.optional) {
        this.frame.clipped(() => {
          pen.fillStyle = colourOf(line.colour);
          drawShape(pen, "circle", x, this.frame.toY(value), 3.2);
        });
      }
    }
  }

  drawStill(recording, view, width, height) {
    const ratio = devicePixelRatio || 1;
    this.still.width = Math.round(width * ratio);
    this.still.height = Math.round(height * ratio);
    const pen = this.still.getContext("2d");
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.font = "12px system-ui, sans-serif";
    const first = recording.rowAt(view.from);
    const last = Math.min(recording.length - 1, recording.rowAt(view.to) + 1);
    const { shown } = this;
    const y = rangeOf(recording, shown.filter((line) => !line.outside).map((line) => line.quantity), first, last, this.least, false);
    const ssf = recording.head.vehicle.static_stability_factor;
    if (this.ssf) { // the side that is in danger has room for its limit
      y.to = y.to > 0.35 ? Math.max(y.to, 1.12 * ssf) : y.to;
      y.from = y.from < -0.35 ? Math.min(y.from, -1.12 * ssf) : y.from;
    }
    this.frame = new Frame({ pen, width, height }, { left: 46, right: 10, top: 5, bottom: this.isLast ? 34 : 6 },
      { from: view.from, to: view.to }, y);
    this.frame.drawAxes(this.isLast);
    if (this.isLast) {
      pen.fillStyle = colourOf("--quiet");
      pen.textAlign = "right";
      pen.fillText("Time [s]", this.frame.right, this.frame.bottom + 19);
    }
    this.frame.clipped(() => {
      this.drawLimits(ssf);
      this.drawEvents(recording);
      for (const line of shown) {
        this.drawLine(recording, line, first, last);
      }
    });
  }

  drawLimits(ssf) {
    const { frame } = this;
    const level = (value, colour, dash) => frame.line(frame.left, frame.toY(value), frame.right, frame.toY(value), colour, dash, 1.3);
    if (this.ssf) {
      level(ssf, "--purple", [3, 3]);
      level(-ssf, "--purple", [3, 3]);
    }
    if (this.limit !== undefined) {
      level(this.limit, "--vermilion", [2, 3]);
    }
  }

  drawEvents(recording) {
    const { frame } = this;
    for (const event of EVENTS) {
      const moment = recording.events[event.name];
      if (moment) {
        frame.line(frame.toX(moment.time_s), frame.top, frame.toX(moment.time_s), frame.bottom, event.colour, event.dash, 1.6);
      }
    }
  }

  // The least and the largest value of many rows in one pixel are drawn.
  drawLine(recording, line, first, last) {
    const { frame } = this;
    const { pen } = frame;
    pen.save();
    pen.strokeStyle = colourOf(line.colour);
    pen.lineWidth = line.width;
    pen.lineJoin = "round";
    pen.setLineDash(line.dash ?? []);
    pen.beginPath();
    const many = last - first > 3 * (frame.right - frame.left);
    let open = false;
    let previous = NaN;
    let side = 1;
    let pixel = -1;
    let least = 0;
    let largest = 0;
    for (let row = first; row <= last; row += 1) {
      side = recording.sideAt(row, side);
      const value = line.breaks ? side * Math.abs(recording.value(line.quantity, row)) : recording.value(line.quantity, row);
      if (Number.isNaN(value) || (line.breaks && value * previous < 0)) {
        open = false;
        pixel = -1;
      }
      previous = value;
      if (Number.isNaN(value)) {
        continue;
      }
      const x = frame.toX(recording.time(row));
      const y = frame.toY(value);
      if (!open) {
        pen.moveTo(x, y);
        open = true;
      } else if (!many) {
        pen.lineTo(x, y);
      }
      if (many) {
        if (Math.floor(x) !== pixel) {
          pen.lineTo(x, y);
          pixel = Math.floor(x);
          least = largest = y;
        } else if (y < least || y > largest) {
          least = Math.min(least, y);
          largest = Math.max(largest, y);
          pen.lineTo(x, y);
        }
      }
    }
    pen.stroke();
    pen.restore();
  }

  timeAt(pixel) { return this.frame ? this.frame.fromX(pixel) : 0; }
}

// The stability boundary: roll angle over lateral acceleration, as Figs 8 and 10 of the paper.
class Plane {
  constructor(canvas, legend) {
    this.canvas = canvas;
    legend.innerHTML = `<li>${lineSample("--blue", [], 2)} <span data-line="plane"></span></li><li>${lineSample("--vermilion", [6, 3], 2)} RSI threshold</li>` +
      `<li>${lineSample("--purple", [3, 3], 1.3)} SSF</li>`;
    this.source = legend.querySelector("[data-line]");
  }

  use(recording) {
    this.source.textContent = sourceOf(recording.names.acceleration ?? "");
  }

  draw(recording, view) {
    const sheet = prepare(this.canvas);
    if (sheet.width < 80 || recording.length === 0) {
      return;
    }
    const { pen } = sheet;
    const live = view.live;
    const first = live ? recording.rowAt(recording.lastTime - 20) : 0;
    const ssf = recording.head.vehicle.static_stability_factor;
    const last = recording.length - 1;
    const key = [recording.changes, recording.length, first].join();
    if (key !== this.rangeKey) {
      this.rangeKey = key;
      this.rollRange = rangeOf(recording, ["roll"], first, last, live ? { from: -9, to: 9 } : { from: -1, to: 1 }, live);
      const reach = rangeOf(recording, ["acceleration"], first, last, { from: 0, to: 0 }, false);
      const limit = Math.min(1.25 * ssf, 2);
      this.accelerationRange = {
        from: live || reach.from < -0.2 ? Math.min(-limit, reach.from) : Math.min(-0.08, reach.from),
        to: live || reach.to > 0.2 || reach.from >= -0.2 ? Math.max(limit, reach.to) : Math.max(0.08, reach.to),
      };
    }
    const frame = new Frame(sheet, { left: 46, right: 12, top: 8, bottom: 38 }, this.accelerationRange, this.rollRange);
    frame.drawAxes(true);
    pen.fillStyle = colourOf("--quiet");
    pen.textAlign = "right";
    pen.fillText("Lateral acceleration [g]", frame.right, frame.bottom + 21);
    pen.textAlign = "left";
    pen.fillText("Roll angle [deg]", frame.left + 5, frame.top + 4);
    frame.clipped(() => {
      for (const limit of [ssf, -ssf]) {
        frame.line(frame.toX(limit), frame.top, frame.toX(limit), frame.bottom, "--purple", [3, 3], 1.3);
      }
      const path = (quantity, from, to, colour, width, dash, alpha) => {
        pen.save();
        pen.globalAlpha = alpha;
        pen.strokeStyle = colourOf(colour);
        pen.lineWidth = width;
        pen.lineJoin = "round";
        pen.setLineDash(dash);
        pen.beginPath();
        let previous = NaN;
        let side = 1;
        for (let row = from; row <= to; row += 1) {
          side = recording.sideAt(row, side);
          const across = quantity === "threshold" ? side * Math.abs(recording.value(quantity, row)) : recording.value(quantity, row);
          const up = recording.value("roll", row);
          const x = frame.toX(across);
          const y = frame.toY(up);
          // A gap, or the threshold of the other side, begins anew.
          if (Number.isNaN(previous) || (quantity === "threshold" && across * previous < 0)) {
            pen.moveTo(x, y);
          } else if (!Number.isNaN(x) && !Number.isNaN(y)) {
            pen.lineTo(x, y);
          }
          previous = Number.isNaN(y) ? NaN : across;
        }
        pen.stroke();
        pen.restore();
      };
      path("threshold", first, last, "--vermilion", 2.2, [6, 3], 1);
      path("acceleration", first, last, "--blue", 1.5, [], 0.3);
      path("acceleration", live ? recording.rowAt(view.time - 3) : first, view.row, "--blue", 2.4, [], 1);
      for (const event of EVENTS) {
        const moment = recording.events[event.name];
        if (moment && moment.ay_g !== null && moment.roll_deg !== null) {
          pen.fillStyle = colourOf(event.colour);
          pen.globalAlpha = moment.time_s <= view.time + 1e-9 ? 1 : 0.4;
          drawShape(pen, event.shape, frame.toX(moment.ay_g), frame.toY(moment.roll_deg), 4.5);
          pen.globalAlpha = 1;
        }
      }
      const x = frame.toX(recording.between("acceleration", view.time));
      const y = frame.toY(recording.between("roll", view.time));
      if (Number.isNaN(x) || Number.isNaN(y)) {
        return;
      }
      pen.fillStyle = colourOf("--panel");
      drawShape(pen, "circle", x, y, 7);
      pen.fillStyle = colourOf("--blue");
      drawShape(pen, "circle", x, y, 5);
    });
  }
}
