// Scene: the vehicle from behind. Left is left; a left turn leans the body to the right.
const ROAD_TEXT_PX = 30;
const EDGE_PX = 6;
const TYRE_WIDTH_M = 0.24;
const roofLoadHeight = (vehicle) => 0.16 + vehicle.roof_load_kg / 900;

class Scene {
  constructor(canvas) { this.canvas = canvas; }

  draw(recording, view) {
    const { pen, width, height } = prepare(this.canvas);
    if (width < 80 || recording.length === 0) {
      return;
    }
    if (Number.isNaN(recording.value("roll", view.row))) {
      pen.fillStyle = colourOf("--quiet");
      pen.textAlign = "center";
      pen.fillText("the roll angle is not known here", width / 2, height / 2);
      return;
    }
    const at = (quantity) => {
      const value = recording.between(quantity, view.time);
      return Number.isNaN(value) ? 0 : value;
    };
    const vehicle = recording.head.vehicle;
    const radians = Math.PI / 180;
    const tall = vehicle.cg_height_m + vehicle.top_above_cg_m;
    // In metres, z up, the road at zero; positive angles are clockwise for the viewer, hence the sign.
    const lifted = WHEELS.map((wheel) => recording.has("load_" + wheel) && recording.value("load_" + wheel, view.row) <= (recording.head.vehicle.up_below_n ?? 0) * 0.001);
    const front = this.axleOf(vehicle, at("gap_front_left"), at("gap_front_right"));
    const rear = this.axleOf(vehicle, at("gap_rear_left"), at("gap_rear_right"));
    const roll = -at("roll") * radians;
    const bank = at("bank") * radians;
    const upright = Math.min(height / (1.52 * tall), width / (4.0 * vehicle.half_width_m));
    const { scale, shift } = this.fit(this.corners(vehicle, [front, rear], roll), bank, upright, width, height - ROAD_TEXT_PX);
    pen.save();
    pen.translate(width / 2 + shift, height - ROAD_TEXT_PX);
    pen.rotate(bank);
    this.drawRoad(pen, width);
    pen.scale(scale, -scale);
    this.drawWheels(pen, vehicle, front, lifted[0], lifted[1], 0.55);
    this.drawBody(pen, vehicle, rear, roll);
    this.drawWheels(pen, vehicle, rear, lifted[2], lifted[3], 1);
    if (recording.has("acceleration")) {
      this.drawForce(pen, vehicle, rear, roll, this.slopeOfForce(at("acceleration"), at("bank") * radians), scale);
    }
    pen.restore();
    this.drawTexts(pen, width, height, at("bank"), at("acceleration"), recording.has("acceleration"));
    this.canvas.setAttribute("aria-label", `The vehicle from behind: roll ${at("roll").toFixed(1)} degrees, ` +
      (lifted.some((each) => each) ? WHEELS.filter((_, index) => lifted[index]).join(", ").replaceAll("_", " ") + " lifted" : "all wheels on the road"));
  }

  // Those of body and wheels, in metres.
  corners(vehicle, axles, roll) {
    const { half_width_m: half, top_above_cg_m: top, bottom_below_cg_m: bottom, cg_height_m: cg, wheel_radius_m: radius } = vehicle;
    const turned = (axle, angle, x, z) =>
      [axle.shift + Math.cos(angle) * x - Math.sin(angle) * z, axle.height + Math.sin(angle) * x + Math.cos(angle) * z];
    const outer = 0.5 * vehicle.track_width_m + TYRE_WIDTH_M / 2;
    const roof = cg + top - radius + (vehicle.roof_load_kg > 0 ? roofLoadHeight(vehicle) : 0);
    const box = (axle, angle, x, low, high) => [[-x, low], [x, low], [-x, high], [x, high]].map(([a, b]) => turned(axle, angle, a, b));
    return box(axles[1], roll, half, cg - bottom - radius, roof).concat(...axles.map((axle) => box(axle, axle.angle, outer, -radius, radius)));
  }

  // A scale and a shift with which all corners are in the panel; a vehicle that stands is in the middle.
  fit(corners, bank, largest, width, height) {
    const across = corners.map(([x, z]) => x * Math.cos(bank) + z * Math.sin(bank));
    const up = Math.max(...corners.map(([x, z]) => z * Math.cos(bank) - x * Math.sin(bank)));
    const [left, right] = [Math.min(...across), Math.max(...across)];
    const scale = Math.min(largest, (height - EDGE_PX) / up, (width - 2 * EDGE_PX) / (right - left));
    const room = width / 2 - EDGE_PX;
    return { scale, shift: Math.max(-room - scale * left, 0) + Math.min(room - scale * right, 0) };
  }

  // Place of the axle's middle and its lean, by the gaps below its wheels.
  axleOf(vehicle, gapLeft, gapRight) {
    const track = vehicle.track_width_m;
    const angle = Math.asin(Math.max(-1, Math.min(1, (gapRight - gapLeft) / track)));
    const height = Math.min(gapLeft, gapRight) + vehicle.wheel_radius_m * Math.cos(angle) + 0.5 * track * Math.abs(Math.sin(angle));
    // The wheels that stay down stay where they are.
    const shift = -Math.sign(angle) * 0.5 * track * (1 - Math.cos(angle)) + vehicle.wheel_radius_m * Math.sin(angle) * -1;
    return { angle, height, shift };
  }

  drawRoad(pen, width) {
    pen.fillStyle = colourOf("--road");
    pen.fillRect(-width, 0, 2 * width, 3);
    pen.save();
    pen.globalAlpha = 0.16;
    pen.fillRect(-width, 3, 2 * width, 40);
    pen.restore();
  }

  drawWheels(pen, vehicle, axle, leftLifted, rightLifted, alpha) {
    const half = 0.5 * vehicle.track_width_m;
    const radius = vehicle.wheel_radius_m;
    const wide = TYRE_WIDTH_M;
    pen.save();
    pen.globalAlpha = alpha;
    pen.translate(axle.shift, axle.height);
    pen.rotate(axle.angle);
    pen.strokeStyle = colourOf("--quiet");
    pen.lineWidth = 0.07;
    pen.beginPath();
    pen.moveTo(-half, 0);
    pen.lineTo(half, 0);
    pen.stroke();
    for (const [place, isLifted] of [[-half, leftLifted], [half, rightLifted]]) {
      pen.fillStyle = colourOf(isLifted ? "--lifted" : "--tyre");
      pen.beginPath();
      pen.roundRect(place - wide / 2, -radius, wide, 2 * radius, 0.07);
      pen.fill();
    }
    pen.restore();
  }

  drawBody(pen, vehicle, axle, roll) {
    const { half_width_m: half, top_above_cg_m: top, bottom_below_cg_m: bottom, cg_height_m: cg, wheel_radius_m: radius } = vehicle;
    const base = cg - bottom - radius; // above the axle
    const roof = cg + top - radius;
    const waist = base + 0.52 * (roof - base);
    pen.save();
    pen.translate(axle.shift, axle.height);
    pen.rotate(roll);
    if (vehicle.roof_load_kg > 0) {
      const size = roofLoadHeight(vehicle);
      pen.fillStyle = colourOf("--orange");
      pen.beginPath();
      pen.roundRect(-0.55 * half, roof + 0.03, 1.1 * half, size, 0.05);
      pen.fill();
    }
    pen.fillStyle = colourOf("--body");
    pen.beginPath();
    pen.moveTo(-0.9 * half, base);
    pen.quadraticCurveTo(-half, base, -half, base + 0.2);
    pen.lineTo(-half, waist - 0.05);
    pen.quadraticCurveTo(-0.97 * half, waist + 0.02, -0.93 * half, waist + 0.05);
    pen.lineTo(-0.76 * half, roof - 0.08);
    pen.quadraticCurveTo(-0.73 * half, roof, -0.6 * half, roof);
    pen.lineTo(0.6 * half, roof);
    pen.quadraticCurveTo(0.73 * half, roof, 0.76 * half, roof - 0.08);
    pen.lineTo(0.93 * half, waist + 0.05);
    pen.quadraticCurveTo(0.97 * half, waist + 0.02, half, waist - 0.05);
    pen.lineTo(half, base + 0.2);
    pen.quadraticCurveTo(half, base, 0.9 * half, base);
    pen.closePath();
    pen.fill();
    pen.fillStyle = colourOf("--glass");
    pen.beginPath();
    pen.moveTo(-0.8 * half, waist + 0.08);
    pen.lineTo(-0.66 * half, roof - 0.12);
    pen.lineTo(0.66 * half, roof - 0.12);
    pen.lineTo(0.8 * half, waist + 0.08);
    pen.closePath();
    pen.fill();
    pen.fillStyle = "#c8102e";
    for (const place of [-0.96 * half, 0.96 * half - 0.13]) {
      pen.beginPath();
      pen.roundRect(place, waist - 0.32, 0.13, 0.26, 0.03);
      pen.fill();
    }
    pen.fillStyle = "#f4f4f0";
    pen.fillRect(-0.26, base + 0.22, 0.52, 0.12);
    pen.restore();
  }

  // How far to the right weight and centrifugal force point, for each metre towards the road.
  slopeOfForce(acceleration, bank) {
    const down = Math.cos(bank) - acceleration * Math.sin(bank);
    return (acceleration * Math.cos(bank) + Math.sin(bank)) / Math.max(down, 0.1);
  }

  // From the centre of gravity to the road.
  drawForce(pen, vehicle, axle, roll, slope, scale) {
    const above = vehicle.cg_height_m - vehicle.wheel_radius_m;
    const x = axle.shift - Math.sin(roll) * above;
    const z = axle.height + Math.cos(roll) * above;
    pen.strokeStyle = colourOf("--vermilion");
    pen.lineWidth = 2 / scale;
    pen.setLineDash([6 / scale, 4 / scale]);
    pen.beginPath();
    pen.moveTo(x, z);
    pen.lineTo(x + slope * z, 0);
    pen.stroke();
    pen.setLineDash([]);
    pen.fillStyle = colourOf("--vermilion");
    pen.beginPath();
    pen.arc(x, z, 5 / scale, 0, 2 * Math.PI);
    pen.fill();
    pen.beginPath();
    pen.arc(x + slope * z, 0, 4 / scale, 0, 2 * Math.PI);
    pen.fill();
  }

  drawTexts(pen, width, height, bank, acceleration, known) {
    pen.fillStyle = colourOf("--quiet");
    pen.textBaseline = "alphabetic";
    pen.textAlign = "left";
    pen.fillText("left", 4, height - 6);
    pen.textAlign = "right";
    pen.fillText("right", width - 4, height - 6);
    pen.textAlign = "center";
    const turn = !known ? "" : Math.abs(acceleration) < 0.03 ? "straight on" : acceleration > 0 ? "turns left" : "turns right";
    pen.fillText(turn + (Math.abs(bank) > 0.2 ? `, road banked ${Math.abs(bank).toFixed(1)} deg` : ""), width / 2, height - 6);
  }
}
