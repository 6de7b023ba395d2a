// Recording: what a run, a replay or a live drive has told, row by row; the columns bear the names of the CSV file.
const STANDARD_GRAVITY = 9.80665;
const OVERTURNED_DEG = 41; // 0.6 of the roll angle that ends a run (closed_loop.cpp)
const LEAST_TURN_G = 0.05;
const STEEP_DEG = 15; // of a vehicle on two wheels that may come back
const WHEELS = ["front_left", "front_right", "rear_left", "rear_right"];

// A quantity, the columns that can tell of it (the first that is there does), and the factor to what people read.
const QUANTITIES = {
  steering: { columns: ["true_steering_wheel_angle_deg", "sensor_steering_wheel_angle_deg"], factor: 1 },
  speed: { columns: ["true_speed_mps", "sensor_speed_mps"], factor: 3.6 },
  acceleration: { columns: ["true_lateral_acceleration_mps2", "lateral_acceleration_mps2"], factor: 1 / STANDARD_GRAVITY },
  measuredAcceleration: { columns: ["sensor_lateral_acceleration_mps2"], factor: 1 / STANDARD_GRAVITY },
  threshold: {
    columns: ["ecu_lateral_acceleration_threshold_mps2", "lateral_acceleration_threshold_mps2"],
    factor: 1 / STANDARD_GRAVITY,
  },
  level: { columns: ["ecu_warning_level", "warning_level"], factor: 1 },
  rsi: { columns: ["ecu_rsi", "rsi"], factor: 1 },
  roll: { columns: ["true_roll_angle_deg", "sensor_roll_angle_deg", "observed_roll_angle_deg"], factor: 1 },
  measuredRoll: { columns: ["sensor_roll_angle_deg"], factor: 1 },
  rollRate: { columns: ["true_roll_rate_degps", "sensor_roll_rate_degps"], factor: 1 },
  loadTransfer: { columns: ["measured_load_transfer_ratio"], factor: 1 },
  bank: { columns: ["true_bank_angle_deg", "sensor_bank_angle_deg"], factor: 1 },
  state: { columns: ["ecu_state", "state"] },
  side: { columns: ["ecu_side", "side"] },
};
for (const wheel of WHEELS) {
  QUANTITIES["load_" + wheel] = { columns: ["true_wheel_load_" + wheel + "_n", "measured_wheel_load_" + wheel + "_n"], factor: 0.001 };
  QUANTITIES["gap_" + wheel] = { columns: ["true_wheel_gap_" + wheel + "_m"], factor: 1 };
}

class Recording {
  // `head`: the recording as JSON. A live one has no rows yet.
  constructor(head) {
    this.head = head;
    this.rows = head.rows ?? [];
    this.events = head.events ?? {};
    this.judgement = head.judgement ?? {};
    this.diagnosis = head.diagnosis ?? [];
    this.changes = 0;
    this.places = {};
    this.names = {};
    for (const [quantity, { columns }] of Object.entries(QUANTITIES)) {
      const name = columns.find((column) => head.columns.includes(column));
      this.names[quantity] = name;
      this.places[quantity] = name === undefined ? -1 : head.columns.indexOf(name);
    }
    this.timePlace = head.columns.indexOf("time_s");
  }

  get length() { return this.rows.length; }
  get firstTime() { return this.rows.length ? this.rows[0][this.timePlace] : 0; }
  get lastTime() { return this.rows.length ? this.rows[this.rows.length - 1][this.timePlace] : 0; }

  append(rows) {
    for (const row of rows) {
      this.rows.push(row);
    }
    this.changes += 1;
  }

  // Keeps the latest ones only.
  forget(longest) {
    if (this.rows.length > longest) {
      this.rows.splice(0, this.rows.length - longest);
    }
  }

  has(quantity) { return this.places[quantity] >= 0; }
  time(row) { return this.rows[row][this.timePlace]; }

  // As the file says it; null where it says nothing.
  raw(quantity, row) {
    const place = this.places[quantity];
    return place < 0 || row < 0 || row >= this.rows.length ? null : this.rows[row][place];
  }

  // In the unit that people read; NaN where there is nothing.
  value(quantity, row) {
    const raw = this.raw(quantity, row);
    return raw === null ? NaN : raw * QUANTITIES[quantity].factor;
  }

  // The last row that is not after `time`; the first one before all of them.
  rowAt(time) {
    let low = 0;
    let high = this.rows.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.time(middle) <= time + 1e-9) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return Math.max(low, 0);
  }

  // The side of the turn, as a sign; on a straight, where that of a noisy value says nothing, `before`.
  sideAt(row, before) {
    const acceleration = this.value("acceleration", row);
    return Math.abs(acceleration) > LEAST_TURN_G ? Math.sign(acceleration) : before;
  }

  // The first row from `time` on; the last one after all of them.
  rowFrom(time) {
    const row = this.rowAt(time);
    return this.rows.length > row + 1 && this.time(row) < time - 1e-9 ? row + 1 : row;
  }

  timeFrom(time) { return this.time(this.rowFrom(time)); }

  // The time of the largest lateral acceleration.
  get hardestTime() {
    let hardest = 0;
    let largest = 0;
    for (let row = 0; row < this.rows.length; row += 1) {
      const acceleration = Math.abs(this.value("acceleration", row));
      if (acceleration > largest) {
        [hardest, largest] = [row, acceleration];
      }
    }
    return this.rows.length ? this.time(hardest) : 0;
  }

  // Between two rows, for pictures that move; texts show the row itself.
  between(quantity, time) {
    const row = this.rowAt(time);
    const value = this.value(quantity, row);
    if (row + 1 >= this.rows.length || time <= this.time(row)) {
      return value;
    }
    const share = (time - this.time(row)) / (this.time(row + 1) - this.time(row));
    const next = this.value(quantity, row + 1);
    return Number.isNaN(next) ? value : value + share * (next - value);
  }

  diagnosisAt(time) {
    let found = null;
    for (const entry of this.diagnosis) {
      if (entry.time_s > time + 1e-9) {
        break;
      }
      found = entry;
    }
    return found;
  }

  // The last row for the ranges of pictures: a vehicle that falls over in the end leaves every one of them.
  get lastUpright() {
    const rollIn = (row) => Math.abs(this.value("roll", row));
    let row = this.rows.length - 1;
    if (rollIn(row) > OVERTURNED_DEG) {
      while (row > 0 && !(rollIn(row) <= STEEP_DEG)) {
        row -= 1;
      }
    }
    return row;
  }
}
