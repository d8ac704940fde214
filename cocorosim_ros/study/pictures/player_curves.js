// The metrics over time, each with a line at the moment that the views show.

const MARGIN = { left: 40, right: 6, top: 20, bottom: 16 };

for (const curve of curves) {
  curve.canvas = document.createElement("canvas");
  curve.canvas.setAttribute("aria-label", `${curve.name} over time`);
  element("curves").append(curve.canvas);
}

function fitCurves(width, height) {
  const columns = width > 420 ? 2 : 1, rows = Math.ceil(curves.length / columns);
  element("curves").style.gridTemplateColumns = `repeat(${columns}, 1fr)`;
  for (const curve of curves) {
    curve.size = [(width - 16 * (columns - 1)) / columns, Math.max(84, Math.min(220, height / rows - 4))];
    curve.pen = sharpen(curve.canvas, ...curve.size);
  }
}

const timeAt = (curve, pixel) =>
  ((pixel - MARGIN.left) / (curve.size[0] - MARGIN.left - MARGIN.right)) * recording.seconds;
const pixelOf = (curve, seconds) =>
  MARGIN.left + (seconds / (recording.seconds || 1)) * (curve.size[0] - MARGIN.left - MARGIN.right);
const heightOf = (curve, value) =>
  curve.size[1] - MARGIN.bottom - (value / curve.top) * (curve.size[1] - MARGIN.top - MARGIN.bottom);

// The value at a moment, or null where the metric is not defined.
function valueAt(curve, seconds) {
  const index = indexAt(curve.time, seconds);
  return index < 0 || Number.isNaN(curve.mean[index]) ? null : curve.mean[index];
}

const shownValue = (curve, value) => (value === null ? "-" : `${+value.toPrecision(3)}${curve.unit === "1" ? "" : ` ${curve.unit}`}`);

function tracePath(curve, values, from, to, step) {
  let broken = true;
  for (let index = from; index !== to; index += step) {
    if (Number.isNaN(values[index])) { broken = true; continue; }
    const point = [pixelOf(curve, curve.time[index]), heightOf(curve, values[index])];
    if (broken && step === 1) curve.pen.moveTo(...point); else curve.pen.lineTo(...point);
    broken = false;
  }
}

function drawBand(curve) {
  const { pen, low: least, high: most } = curve;
  for (let first = 0; first < most.length; first += 1) {
    if (Number.isNaN(most[first])) continue;
    let last = first;
    while (last < most.length && !Number.isNaN(most[last])) last += 1;
    pen.beginPath();
    tracePath(curve, most, first, last, 1);
    tracePath(curve, least, last - 1, first - 1, -1);
    pen.fill();
    first = last;
  }
}

function drawCurve(curve) {
  const { pen, size: [width, height] } = curve;
  pen.clearRect(0, 0, width, height);
  pen.font = "11px system-ui, sans-serif";
  pen.lineWidth = 1;
  pen.strokeStyle = theme.grid;
  pen.fillStyle = theme.quiet;
  pen.textAlign = "right";
  for (const value of [0, curve.top / 2, curve.top]) {
    pen.beginPath();
    pen.moveTo(MARGIN.left, heightOf(curve, value));
    pen.lineTo(width - MARGIN.right, heightOf(curve, value));
    pen.stroke();
    pen.fillText(+value.toPrecision(2), MARGIN.left - 4, heightOf(curve, value) + 4);
  }
  pen.textAlign = "left";
  pen.fillText("0", MARGIN.left, height - 3);
  pen.textAlign = "right";
  pen.fillText(`${+recording.seconds.toPrecision(4)} s`, width - MARGIN.right, height - 3);
  pen.textAlign = "left";
  pen.fillStyle = theme.band;
  drawBand(curve);
  pen.strokeStyle = theme.curve;
  pen.lineWidth = 1.4;
  pen.beginPath();
  tracePath(curve, curve.mean, 0, curve.mean.length, 1);
  pen.stroke();
  drawMoment(curve);
}

// The label; without its unit, which the value has as well, where it would touch the value.
const labelWithin = (curve, room) =>
  curve.pen.measureText(`${curve.label}  `).width <= room ? curve.label : curve.label.replace(/ \[.*\]$/, "");

function drawMoment(curve) {
  const pen = curve.pen, x = pixelOf(curve, moment), value = valueAt(curve, moment);
  pen.strokeStyle = theme.accent;
  pen.lineWidth = 1;
  pen.beginPath();
  pen.moveTo(x, MARGIN.top);
  pen.lineTo(x, curve.size[1] - MARGIN.bottom);
  pen.stroke();
  pen.fillStyle = theme.ink;
  pen.font = "600 12px system-ui, sans-serif";
  const shown = shownValue(curve, value);
  pen.fillText(labelWithin(curve, curve.size[0] - MARGIN.left - MARGIN.right - pen.measureText(shown).width), MARGIN.left, 13);
  pen.textAlign = "right";
  pen.fillText(shown, curve.size[0] - MARGIN.right, 13);
  pen.textAlign = "left";
  if (value === null) return;
  pen.beginPath();
  pen.arc(x, heightOf(curve, value), 3, 0, 2 * Math.PI);
  pen.fill();
}

function drawCurves() {
  for (const curve of curves) drawCurve(curve);
}
