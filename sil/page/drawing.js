// Drawing: what every chart is made of, on canvases.
function colourOf(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

// The canvas at the screen's resolution, empty, in units of CSS pixels.
function prepare(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const width = canvas.clientWidth;
  const height = canvas.clientHeight;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const pen = canvas.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  pen.font = "12px system-ui, sans-serif";
  return { pen, width, height };
}

// Round numbers within the range, about `wanted` of them, and two besides zero: fewer say nothing of the scale.
function ticks(from, to, wanted) {
  const rough = (to - from) / wanted;
  const power = 10 ** Math.floor(Math.log10(rough));
  const steps = [10, 5, 2, 1, 0.5, 0.2].map((each) => each * power);
  const within = (step) => Math.floor(to / step + 1e-9) - Math.ceil(from / step - 1e-9) + (from <= 0 && to >= 0 ? 0 : 1);
  const widest = steps.findLastIndex((each) => each >= rough);
  const step = steps.find((each, place) => place >= widest && within(each) >= 2) ?? steps[steps.length - 1];
  const all = [];
  for (let count = Math.ceil(from / step - 1e-9); count * step <= to + 1e-9 * step; count += 1) {
    all.push(count * step);
  }
  return { all, digits: Math.max(0, -Math.floor(Math.log10(step) + 1e-9)) };
}

function tickText(value, digits) {
  const text = Math.abs(value).toFixed(digits);
  return value < 0 && Number(text) !== 0 ? "\u2212" + text : text;
}

function drawShape(pen, shape, x, y, size) {
  pen.beginPath();
  if (shape === "square") {
    pen.rect(x - size, y - size, 2 * size, 2 * size);
  } else if (shape === "triangle") {
    pen.moveTo(x, y - 1.3 * size);
    pen.lineTo(x + 1.2 * size, y + size);
    pen.lineTo(x - 1.2 * size, y + size);
    pen.closePath();
  } else if (shape === "diamond") {
    pen.moveTo(x, y - 1.3 * size);
    pen.lineTo(x + 1.3 * size, y);
    pen.lineTo(x, y + 1.3 * size);
    pen.lineTo(x - 1.3 * size, y);
    pen.closePath();
  } else {
    pen.arc(x, y, 1.1 * size, 0, 2 * Math.PI);
  }
  pen.fill();
}

// A frame with ticks and a grid; gives back the way from values to pixels, and clips to the frame.
class Frame {
  constructor({ pen, width, height }, margins, x, y) {
    Object.assign(this, { pen, x, y });
    this.left = margins.left;
    this.right = width - margins.right;
    this.top = margins.top;
    this.bottom = height - margins.bottom;
  }

  toX(value) { return this.left + ((value - this.x.from) / (this.x.to - this.x.from)) * (this.right - this.left); }
  toY(value) { return this.bottom - ((value - this.y.from) / (this.y.to - this.y.from)) * (this.bottom - this.top); }
  fromX(pixel) { return this.x.from + ((pixel - this.left) / (this.right - this.left)) * (this.x.to - this.x.from); }

  drawAxes(withX) {
    const { pen } = this;
    pen.lineWidth = 1;
    pen.textBaseline = "middle";
    pen.textAlign = "right";
    const vertical = ticks(this.y.from, this.y.to, Math.max(2, (this.bottom - this.top) / 32));
    for (const value of vertical.all) {
      this.line(this.left, this.toY(value), this.right, this.toY(value), value === 0 ? "--line" : "--grid");
      pen.fillStyle = colourOf("--quiet");
      pen.fillText(tickText(value, vertical.digits), this.left - 5, this.toY(value));
    }
    pen.textAlign = "center";
    pen.textBaseline = "top";
    const horizontal = ticks(this.x.from, this.x.to, Math.max(2, (this.right - this.left) / 70));
    for (const value of horizontal.all) {
      this.line(this.toX(value), this.top, this.toX(value), this.bottom, value === 0 ? "--line" : "--grid");
      if (withX) {
        pen.fillStyle = colourOf("--quiet");
        pen.fillText(tickText(value, horizontal.digits), this.toX(value), this.bottom + 4);
      }
    }
  }

  line(x1, y1, x2, y2, colour, dash = [], lineWidth = 1) {
    const { pen } = this;
    pen.save();
    pen.strokeStyle = colourOf(colour);
    pen.lineWidth = lineWidth;
    pen.setLineDash(dash);
    pen.beginPath();
    pen.moveTo(x1, y1);
    pen.lineTo(x2, y2);
    pen.stroke();
    pen.restore();
  }

  clipped(work) {
    this.pen.save();
    this.pen.beginPath();
    this.pen.rect(this.left, this.top, this.right - this.left, this.bottom - this.top);
    this.pen.clip();
    work();
    this.pen.restore();
  }
}

function lineSample(colour, dash, width) {
  return `<svg viewBox="0 0 16 12" aria-hidden="true"><path d="M0 6h16" stroke="var(${colour})" stroke-width="${width + 0.5}" ` +
    `stroke-dasharray="${(dash ?? []).join(" ")}"/></svg>`;
}
