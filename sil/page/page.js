// Page: what it shows at a time, and how one moves through time.
const VALUES = [
  { quantity: "speed", words: "Speed", unit: "km/h", digits: 1 },
  { quantity: "steering", words: "Steering wheel", unit: "deg", digits: 1, signed: true },
  { quantity: "acceleration", words: "Lateral acceleration", unit: "g", digits: 3, signed: true },
  { quantity: "threshold", words: "Its threshold", unit: "g", digits: 3, signed: true },
  { quantity: "level", words: "Level of the warning", unit: "", digits: 3 },
  { quantity: "rsi", words: "RSI as published", unit: "", digits: 3 },
  { quantity: "loadTransfer", words: "LTR of the wheel loads", unit: "", digits: 3, signed: true },
  { quantity: "roll", words: "Roll angle", unit: "deg", digits: 2, signed: true },
  { quantity: "rollRate", words: "Roll rate", unit: "deg/s", digits: 1, signed: true },
];
// The bus's words, in a driver's.
const LAMP_WORDS = { unavailable: "cannot warn", ready: "ready", advisory: "caution", warning: "warning" };
const DEGRADATION_WORDS = {
  "unavailable": "cannot warn",
  "full": "works fully",
  "roll sensor lost": "works without the roll sensor",
  "motion lost": "works, but without a stand-in for the roll sensor",
  "mass lost": "works, but does not use the vehicle's mass",
  "internal fault": "cannot warn: a check of itself has failed",
};
const PACES = [0.1, 0.25, 0.5, 1, 2, 5, 10];
const WINDOWS = [{ seconds: 0, words: "all" }, { seconds: 20, words: "20 s" }, { seconds: 8, words: "8 s" }, { seconds: 3, words: "3 s" }];
const LIVE_WINDOWS_S = [4, 8, 12]; // the shortest that holds the drive; then the last one moves on

class Page extends Sheet {
  constructor() {
    super();
    this.view = { time: 0, row: 0, from: 0, to: 1, theme: "light", live: false };
    this.direction = 1;
    this.pace = 1;
    this.window = 0;
    this.playing = false;
    this.following = false;
    this.atRest = false; // of a live drive: paused or over
    this.shownState = "";
    this.scene = new Scene(byId("scene"));
    this.plane = new Plane(byId("plane"), byId("plane-legend"));
    this.strips = STRIPS.map((strip, index) => new Strip(byId("strips"), strip, index === STRIPS.length - 1));
    this.makeValues();
    this.makeLoads();
    this.makeEvents();
    this.makeTransport();
    this.open();
  }

  // ---- parts that are made once

  makeValues() {
    byId("values").innerHTML = VALUES.map((value) => `<tr><th scope="row">${value.words}</th>` +
      `<td data-quantity="${value.quantity}"></td></tr>`).join("");
  }

  makeLoads() {
    byId("loads").innerHTML = WHEELS.map((wheel) => `<div class="wheel ${wheel.endsWith("left") ? "left" : "right"}" data-quantity="load_${wheel}">` +
      `<div class="names"><span>${wheel.replace("_", " ")}</span><span class="amount"></span></div>` +
      '<div class="track" aria-hidden="true"><div class="fill"></div></div></div>').join("");
  }

  makeEvents() {
    for (const event of EVENTS) {
      const item = document.createElement("li");
      item.innerHTML = `<button type="button" data-event="${event.name}">${shapeSample(event)}<span></span></button>`;
      item.firstChild.addEventListener("click", () => this.goToEvent(event.name));
      byId("events").append(item);
    }
  }

  makeTransport() {
    byId("pace").innerHTML = PACES.map((pace) => `<option value="${pace}"${pace === 1 ? " selected" : ""}>${pace} \u00d7</option>`).join("");
    byId("window").innerHTML = WINDOWS.map((each) => `<option value="${each.seconds}">${each.words}</option>`).join("");
    byId("start").addEventListener("click", () => this.goTo(this.recording.firstTime));
    byId("end").addEventListener("click", () => this.goTo(this.recording.lastTime));
    byId("back").addEventListener("click", () => this.step(-1));
    byId("forward").addEventListener("click", () => this.step(1));
    byId("play").addEventListener("click", () => this.play(!this.playing));
    byId("reverse").addEventListener("click", () => this.turnAround());
    byId("pace").addEventListener("change", (event) => { this.pace = Number(event.target.value); });
    byId("window").addEventListener("change", (event) => this.chooseWindow(Number(event.target.value)));
    byId("time").addEventListener("input", (event) => this.goTo(this.recording.time(Number(event.target.value))));
    for (const strip of this.strips) {
      const seek = (event) => this.goTo(strip.timeAt(event.offsetX));
      strip.canvas.addEventListener("pointerdown", (event) => {
        strip.canvas.setPointerCapture(event.pointerId);
        seek(event);
      });
      strip.canvas.addEventListener("pointermove", (event) => {
        if (event.buttons & 1) {
          seek(event);
        }
      });
    }
  }

  // ---- a recording to show

  show(recording, live) {
    this.recording = recording;
    this.view.live = live;
    this.follow(live);
    const { head } = recording;
    document.body.dataset.mode = live ? "live" : "replay";
    byId("title").textContent = head.title;
    document.title = head.title;
    byId("subtitle").textContent = head.subtitle;
    byId("loads-panel").hidden = !recording.has("load_front_left");
    byId("scene-panel").hidden = !recording.has("roll");
    byId("values").querySelectorAll("[data-quantity]").forEach((cell) => {
      cell.parentNode.hidden = !recording.has(cell.dataset.quantity);
    });
    byId("plane-panel").hidden = !(recording.has("roll") && recording.has("acceleration"));
    this.plane.use(recording);
    this.showRemarks(head.remarks ?? []);
    byId("facts").innerHTML = "";
    for (const [name, value] of head.facts ?? []) {
      const row = byId("facts").insertRow();
      row.innerHTML = '<th scope="row"></th><td></td>';
      row.firstChild.textContent = name;
      row.lastChild.textContent = value;
    }
    for (const strip of this.strips) {
      strip.use(recording);
    }
    this.shownState = "";
    this.view.time = recording.firstTime;
    this.listKeys();
    this.render();
    document.body.dataset.ready = "yes";
  }

  showRemarks(remarks) {
    byId("remarks-panel").hidden = remarks.length === 0;
    byId("remarks").replaceChildren(...remarks.map((remark) => {
      const item = document.createElement("li");
      item.textContent = remark;
      return item;
    }));
  }

  // ---- time

  goTo(time) {
    if (this.recording.length === 0) {
      return;
    }
    this.follow(false);
    this.view.time = Math.min(Math.max(time, this.recording.firstTime), this.recording.lastTime);
    this.render();
  }

  goToEvent(name) {
    const moment = this.recording.events[name];
    if (moment) {
      this.goTo(this.recording.timeFrom(moment.time_s));
    }
  }

  // The warning; without one the lift of two wheels; without that the hardest moment.
  goToHeart() {
    const { recording } = this;
    const moment = recording.events.warning ?? recording.events.two_wheel_lift;
    this.goTo(moment ? recording.timeFrom(moment.time_s) : recording.hardestTime);
  }

  step(rows) {
    const row = Math.min(Math.max(this.view.row + rows, 0), this.recording.length - 1);
    this.play(false);
    this.goTo(this.recording.time(row));
  }

  play(playing) {
    const { firstTime, lastTime } = this.recording;
    this.playing = playing;
    if (playing) {
      this.follow(false);
      if (this.direction > 0 && this.view.time >= lastTime) {
        this.view.time = firstTime;
      } else if (this.direction < 0 && this.view.time <= firstTime) {
        this.view.time = lastTime;
      }
      this.lastFrame = performance.now();
      requestAnimationFrame((now) => this.onFrame(now));
    }
    byId("play").textContent = playing ? "Stop" : "Play";
    this.render();
  }

  turnAround() {
    this.direction = -this.direction;
    byId("reverse").setAttribute("aria-pressed", String(this.direction < 0));
  }

  changePace(steps) {
    const place = Math.min(Math.max(PACES.indexOf(this.pace) + steps, 0), PACES.length - 1);
    this.pace = PACES[place];
    byId("pace").value = String(this.pace);
  }

  chooseWindow(seconds) {
    this.window = seconds;
    this.render();
  }

  follow(following) {
    this.following = following && this.view.live;
    document.body.dataset.following = String(this.following);
    byId("follow").setAttribute("aria-pressed", String(this.following));
    if (this.following) {
      this.playing = false;
      byId("play").textContent = "Play";
    }
  }

  onFrame(now) {
    if (!this.playing) {
      return;
    }
    const passed = Math.min(Math.max(now - this.lastFrame, 0) / 1000, 0.25); // a frame may have begun before play()
    this.lastFrame = now;
    const time = this.view.time + passed * this.pace * this.direction;
    this.view.time = Math.min(Math.max(time, this.recording.firstTime), this.recording.lastTime);
    if (this.view.time !== time) {
      this.play(false);
      return;
    }
    this.render();
    requestAnimationFrame((next) => this.onFrame(next));
  }

  // ---- keys

  ownKeys() {
    if (!this.recording) {
      return [];
    }
    const transport = [
      { key: " ", shown: "Space", words: "play, stop", act: () => this.play(!this.playing) },
      { key: "ArrowLeft", shown: "\u2190", words: "one row back (Shift: ten)", act: (event) => this.step(event.shiftKey ? -10 : -1) },
      { key: "ArrowRight", shown: "\u2192", words: "one row on (Shift: ten)", act: (event) => this.step(event.shiftKey ? 10 : 1) },
      { key: "Home", words: "to the start", act: () => this.goTo(this.recording.firstTime) },
      { key: "End", words: "to the end", act: () => this.goTo(this.recording.lastTime) },
      { key: "r", words: "backwards, forwards", act: () => this.turnAround() },
      { key: "-", words: "slower", act: () => this.changePace(-1) },
      { key: "+", words: "faster", act: () => this.changePace(1) },
      { key: "z", words: "shorter or longer window", act: () => this.nextWindow() },
      { key: "1", words: "to the warning", act: () => this.goToEvent("warning") },
      { key: "2", words: "to the lift of one wheel", act: () => this.goToEvent("one_wheel_lift") },
      { key: "3", words: "to the lift of two wheels", act: () => this.goToEvent("two_wheel_lift") },
    ];
    return this.driver ? this.driver.keys() : transport;
  }

  nextWindow() {
    const place = WINDOWS.findIndex((each) => each.seconds === this.window);
    byId("window").value = String(WINDOWS[(place + 1) % WINDOWS.length].seconds);
    this.chooseWindow(WINDOWS[(place + 1) % WINDOWS.length].seconds);
  }

  // ---- the visible range

  render() {
    const { recording, view } = this;
    if (!recording) {
      return;
    }
    if (this.following) {
      view.time = recording.lastTime;
    }
    view.row = recording.rowAt(view.time);
    this.chooseSpan();
    this.showTime();
    this.showWarning();
    this.showValues();
    this.showLoads();
    this.showDiagnosis();
    this.scene.draw(recording, view);
    for (const strip of this.strips) {
      strip.draw(recording, view);
    }
    this.plane.draw(recording, view);
  }

  chooseSpan() {
    const { recording, view } = this;
    if (this.following) {
      const driven = recording.lastTime - recording.firstTime;
      const longest = LIVE_WINDOWS_S[LIVE_WINDOWS_S.length - 1];
      const shown = LIVE_WINDOWS_S.find((each) => each >= driven) ?? longest;
      view.from = Math.max(recording.firstTime, recording.lastTime - longest);
      view.to = this.atRest ? Math.max(recording.lastTime, view.from + 0.1) : view.from + shown;
    } else if (this.window === 0 || this.window >= recording.lastTime - recording.firstTime) {
      view.from = recording.firstTime;
      view.to = Math.max(recording.lastTime, recording.firstTime + 0.1);
    } else {
      const middle = Math.min(Math.max(view.time, recording.firstTime + this.window / 2), recording.lastTime - this.window / 2);
      view.from = middle - this.window / 2;
      view.to = middle + this.window / 2;
    }
  }

  showTime() {
    const { recording, view } = this;
    const slider = byId("time");
    slider.max = String(Math.max(recording.length - 1, 0));
    slider.value = String(view.row);
    const time = recording.length ? recording.time(view.row) : 0;
    byId("time-text").textContent = time.toFixed(2) + " s";
    byId("time-text").dataset.value = String(time);
    slider.setAttribute("aria-valuetext", time.toFixed(2) + " seconds");
  }

  showWarning() {
    const { recording, view } = this;
    if (this.lost && view.row === recording.length - 1) {
      this.showLamp("lost", "none", "no connection"); // the last row is no longer what is
    } else {
      this.showLamp(recording.raw("state", view.row) ?? "unavailable", recording.raw("side", view.row) ?? "none");
    }
    for (const button of byId("events").querySelectorAll("button")) {
      const event = EVENTS.find((each) => each.name === button.dataset.event);
      const moment = recording.events[event.name];
      button.parentNode.hidden = !moment;
      if (moment) {
        button.classList.toggle("ahead", moment.time_s > view.time + 1e-9);
        button.dataset.value = String(moment.time_s);
        button.querySelector("span").textContent = `${event.words} ${moment.time_s.toFixed(2)} s`;
      }
    }
    byId("lead").textContent = this.leadText();
    byId("lead").dataset.value = String(recording.judgement.lead_time_s ?? "");
  }

  showLamp(state, side, words = (LAMP_WORDS[state] ?? state) + (side === "none" ? "" : ", " + side + " side")) {
    const lamp = byId("lamp");
    lamp.dataset.state = state;
    lamp.dataset.side = side;
    byId("lamp-text").textContent = words;
    if (words !== this.shownState) {
      this.shownState = words;
      byId("announcement").textContent = state === "warning" || state === "advisory" ? words : "";
    }
  }

  // The live drive is out of reach: what there is can be looked back at.
  lose() {
    this.lost = true;
    this.driver = undefined;
    if (this.following && this.recording) {
      this.view.time = this.recording.lastTime; // rows may have come since the last picture
    }
    this.follow(false);
    this.listKeys();
    this.showLamp("lost", "none", "no connection");
    this.render();
  }

  leadText() {
    const { judgement, events } = this.recording;
    const side = events.warning ? this.recording.raw("side", this.recording.rowFrom(events.warning.time_s)) : null;
    const warned = side === "left" || side === "right" ? `warned of the ${side} side` : "warned"; // a long drive is forgotten
    if (this.recording.head.lift_off_is_known === false) {
      return (events.warning ? warned : "not warned") + "; whether wheels lifted is not known";
    }
    if (!events.two_wheel_lift) {
      return (events.warning ? warned + "; " : "") + "no two wheels of a side have lifted";
    }
    const lift = `two wheels lift at ${events.two_wheel_lift.time_s.toFixed(3)} s`; // the first time; there may be others
    return typeof judgement.lead_time_s === "number"
      ? `warned of the ${judgement.falling_side} side ${judgement.lead_time_s.toFixed(3)} s before ${lift}`
      : `${lift} without a warning of the ${judgement.falling_side ?? "falling"} side`;
  }

  showValues() {
    const { recording, view } = this;
    for (const each of VALUES) {
      const cell = byId("values").querySelector(`[data-quantity="${each.quantity}"]`);
      const value = recording.value(each.quantity, view.row);
      cell.textContent = numberText(value, each.digits, each.signed) + (each.unit && !Number.isNaN(value) ? " " + each.unit : "");
      cell.dataset.value = String(recording.raw(each.quantity, view.row) ?? "");
      cell.dataset.column = recording.names[each.quantity] ?? "";
    }
  }

  showLoads() {
    const { recording, view } = this;
    if (!recording.has("load_front_left") || recording.length === 0) {
      return;
    }
    const { vehicle } = recording.head;
    const largest = vehicle.mass_kg * STANDARD_GRAVITY * 0.001 * 0.62;
    for (const box of byId("loads").children) {
      const load = recording.value(box.dataset.quantity, view.row);
      const lifted = load <= (vehicle.up_below_n ?? 0) * 0.001;
      box.classList.toggle("lifted", lifted);
      box.dataset.value = String(recording.raw(box.dataset.quantity, view.row) ?? "");
      box.dataset.column = recording.names[box.dataset.quantity];
      box.querySelector(".amount").textContent = lifted ? "lifted" : numberText(load, 1) + (Number.isNaN(load) ? "" : " kN");
      box.querySelector(".fill").style.width = `${Math.min(100, Math.max(0, (100 * (load || 0)) / largest))}%`;
    }
  }

  showDiagnosis() {
    const entry = this.recording.diagnosisAt(this.view.time);
    const key = entry ? JSON.stringify(entry) : "";
    if (key === this.shownDiagnosis) {
      return;
    }
    this.shownDiagnosis = key;
    byId("degradation").textContent = entry ? DEGRADATION_WORDS[entry.degradation] ?? entry.degradation : "nothing heard yet";
    byId("codes").innerHTML = "";
    const lists = entry ? [[entry.confirmed, "confirmed"], [entry.set.filter((code) => !entry.confirmed.includes(code)), "set"]] : [];
    for (const [codes, status] of lists) {
      for (const code of codes) {
        const item = document.createElement("li");
        item.className = status;
        item.textContent = status === "confirmed" ? code : `${code} (not yet confirmed)`;
        byId("codes").append(item);
      }
    }
    if (entry && entry.set.length === 0) {
      byId("codes").innerHTML = "<li>no diagnostic codes</li>";
    }
  }
}
