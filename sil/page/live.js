// Driver: a live drive over a WebSocket. Its inputs go to the server, which keeps them within what hands can do.
const LONGEST_MEMORY_ROWS = 60000; // ten minutes
const KEY_ANGLE_DEG = 360;

class Driver {
  constructor(page) {
    this.page = page;
    this.turning = 0;
    this.connect();
    byId("steering").addEventListener("input", (event) => this.steer(-Number(event.target.value)));
    byId("speed").addEventListener("input", (event) => this.holdSpeed(Number(event.target.value)));
    byId("load").addEventListener("input", (event) => this.showLoad(Number(event.target.value)));
    byId("again").addEventListener("click", () => this.again());
    byId("hold").addEventListener("click", () => this.pause(!this.paused));
    byId("follow").addEventListener("click", () => {
      this.page.follow(!this.page.following);
      this.page.render();
    });
    byId("brake").addEventListener("click", () => this.brakeOnWarning());
    byId("fault-set").addEventListener("click", () => this.inject());
    byId("fault-clear").addEventListener("click", () => this.clearFault());
    byId("fault-place").addEventListener("change", () => this.listKinds());
    document.addEventListener("keyup", (event) => this.onRelease(event));
    window.addEventListener("blur", () => this.turn(0));
    this.showLoad(0);
  }

  connect() {
    this.socket = new WebSocket(`ws://${location.host}/drive`);
    this.socket.addEventListener("message", (event) => this.take(JSON.parse(event.data)));
    this.socket.addEventListener("close", (event) => {
      byId("notice").textContent = event.reason || "No connection: the program that simulates the vehicle has ended. " +
        "Start it again with sil/run --watch, then open the address that it prints.";
      for (const control of document.querySelectorAll(".live-only :is(button, input, select)")) {
        control.disabled = true; // no client is connected
      }
      this.page.lose();
      document.body.dataset.ready = "closed";
    });
  }

  send(message) {
    if (this.socket.readyState === WebSocket.OPEN) {
      this.socket.send(JSON.stringify(message));
    }
  }

  take(message) {
    if (message.drive) {
      this.begin(message.drive);
    }
    if (!this.recording) {
      return;
    }
    if (message.events) {
      this.recording.events = message.events;
      this.recording.judgement = message.judgement;
      this.recording.changes += 1;
    }
    if (message.diagnosis) {
      this.recording.diagnosis.push(message.diagnosis);
    }
    if (message.rows) {
      this.recording.append(message.rows);
      this.recording.forget(LONGEST_MEMORY_ROWS);
    }
    if (message.notice !== undefined) {
      byId("notice").textContent = message.notice;
      this.page.atRest = message.notice !== "";
    }
    if (message.fault !== undefined) {
      byId("fault-now").textContent = message.fault || "all sensors good";
      byId("fault-now").classList.toggle("broken", message.fault !== "");
    }
    if (message.brake_on_warning !== undefined) {
      byId("brake").setAttribute("aria-pressed", String(message.brake_on_warning));
    }
    if (message.paused !== undefined) {
      this.showPaused(message.paused);
    }
    this.redraw();
  }

  // Once a picture of the screen, however many messages there were.
  redraw() {
    if (!this.waiting) {
      this.waiting = true;
      requestAnimationFrame(() => {
        this.waiting = false;
        document.body.dataset.frames = String(Number(document.body.dataset.frames ?? 0) + 1);
        this.page.render();
      });
    }
  }

  begin(head) {
    this.recording = new Recording(head);
    byId("speed").value = String(head.input.speed_kmh);
    byId("steering").value = "0";
    this.showInputs();
    byId("load").value = String(head.vehicle.roof_load_kg);
    this.showLoad(head.vehicle.roof_load_kg);
    if (!byId("fault-place").length) {
      this.faults = head.faults;
      byId("fault-place").innerHTML = head.faults.map((each, index) => `<option value="${index}">${each.place}</option>`).join("");
      this.listKinds();
    }
    for (const input of ["steering", "speed"]) {
      byId(input).disabled = !head.driven; // a manoeuvre has its own driver
    }
    byId("hint").hidden = !head.driven;
    byId("heals-note").hidden = head.heals_within_s === null;
    byId("heals").textContent = String(head.heals_within_s);
    this.page.show(this.recording, true);
  }

  listKinds() {
    const chosen = this.faults[Number(byId("fault-place").value)];
    byId("fault-kind").innerHTML = chosen.kinds.map((kind, index) => `<option value="${index}">${kind}</option>`).join("");
    byId("fault-kind").value = String(Math.max(chosen.kinds.indexOf("not available"), 0)); // noticed in any drive
  }

  // ---- actions of the driver

  // Left is positive, as everywhere; on the slider it is on the left.
  steer(degrees) {
    byId("steering").value = String(-degrees);
    this.showInputs();
    this.send({ steering_deg: degrees });
  }

  holdSpeed(kmh) {
    byId("speed").value = String(kmh);
    this.showInputs();
    this.send({ speed_kmh: Number(byId("speed").value) });
  }

  // A key is held: the hands turn as far as they can; released, they turn back.
  turn(direction) {
    if (direction !== this.turning) {
      this.turning = direction;
      this.steer(direction * KEY_ANGLE_DEG);
    }
  }

  showInputs() {
    const degrees = -Number(byId("steering").value);
    byId("steering-text").textContent = `${Math.abs(degrees)} deg${degrees > 0 ? " left" : degrees < 0 ? " right" : ""}`;
    byId("speed-text").textContent = byId("speed").value + " km/h";
  }

  showLoad(kilograms) { byId("load-text").textContent = `${kilograms} kg`; }

  again() {
    this.turning = 0;
    this.send({ again: true, load_kg: Number(byId("load").value), speed_kmh: Number(byId("speed").value) });
  }

  pause(paused) { this.send({ pause: paused }); }

  showPaused(paused) {
    this.paused = paused;
    document.body.dataset.paused = String(paused);
    this.page.atRest = paused || byId("notice").textContent !== "";
    byId("hold").querySelector("span").textContent = paused ? "Go on" : "Pause";
    byId("hold").setAttribute("aria-pressed", String(paused));
  }

  brakeOnWarning() { this.send({ brake_on_warning: byId("brake").getAttribute("aria-pressed") !== "true" }); }

  inject() { this.send({ fault: { place: Number(byId("fault-place").value), kind: Number(byId("fault-kind").value) } }); }
  clearFault() { this.send({ fault: null }); }

  // ---- keys

  onRelease(event) {
    if ((event.key === "ArrowLeft" && this.turning > 0) || (event.key === "ArrowRight" && this.turning < 0)) {
      this.turn(0);
    }
  }

  keys() {
    const speed = () => Number(byId("speed").value);
    return [
      { key: "ArrowLeft", shown: "\u2190", words: "turn left, while held", act: () => this.turn(1) },
      { key: "ArrowRight", shown: "\u2192", words: "turn right, while held", act: () => this.turn(-1) },
      { key: "ArrowUp", shown: "\u2191", words: "5 km/h faster", act: () => this.holdSpeed(speed() + 5) },
      { key: "ArrowDown", shown: "\u2193", words: "5 km/h slower", act: () => this.holdSpeed(speed() - 5) },
      { key: "n", words: "start again", act: () => this.again() },
      { key: "p", words: "pause, go on", act: () => this.pause(!this.paused) },
      { key: "f", words: "break the chosen sensor", act: () => this.inject() },
      { key: "g", words: "all sensors good", act: () => this.clearFault() },
      { key: "b", words: "brake on warning, or not", act: () => this.brakeOnWarning() },
      { key: "l", words: "follow the drive again", act: () => this.page.following || byId("follow").click() },
      { key: "1", words: "to the warning", act: () => this.page.goToEvent("warning") },
      { key: " ", shown: "Space", words: "play back, stop", act: () => this.page.play(!this.page.playing) },
    ];
  }
}
