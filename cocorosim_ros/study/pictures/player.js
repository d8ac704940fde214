"use strict";
// Plays the tracks of a recording: each robot between its poses, from above and from the side, at one scale.

const recording = JSON.parse(document.getElementById("recording").textContent);
const element = (id) => document.getElementById(id);

function floats(base64) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  return new Float32Array(bytes.buffer);
}

const clocks = recording.clocks.map(floats);
const robots = recording.robots.map((robot) => ({ ...robot, time: clocks[robot.clock], poses: floats(robot.poses) }));

// The last index whose time is not after `moment`, -1 before the first.
function indexAt(time, moment) {
  let low = -1, high = time.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (time[middle] <= moment) low = middle; else high = middle;
  }
  return low;
}

// [x, y, z, yaw] at a moment, or null where the recording has no pose within a gap.
function poseAt(robot, moment) {
  const last = robot.time.length - 1, before = indexAt(robot.time, moment);
  if (before < 0 || (before === last && moment - robot.time[last] > robot.gap)) return null;
  const from = Array.from(robot.poses.subarray(4 * before, 4 * before + 4));
  if (before === last) return from;
  const interval = robot.time[before + 1] - robot.time[before];
  if (interval > robot.gap) return null;
  const share = (moment - robot.time[before]) / interval;
  const to = robot.poses.subarray(4 * before + 4, 4 * before + 8);
  const turn = Math.atan2(Math.sin(to[3] - from[3]), Math.cos(to[3] - from[3]));
  return from.map((value, column) => value + share * (column === 3 ? turn : to[column] - value));
}

const views = [{ canvas: element("above"), up: 1 }, { canvas: element("side"), up: 2 }];
const low = recording.view[0], high = recording.view[1];
let moment = 0, playing = false, chosen = null, scale = 1, previous = null;

// Both views at one scale, as large as the window allows.
function fit() {
  const width = Math.max(200, window.innerWidth - 260), height = Math.max(200, window.innerHeight - 210);
  scale = Math.min(width / (high[0] - low[0]), height / (high[1] - low[1] + high[2] - low[2]));
  for (const view of views) {
    const size = [scale * (high[0] - low[0]), scale * (high[view.up] - low[view.up])];
    const density = window.devicePixelRatio || 1;
    [view.canvas.width, view.canvas.height] = size.map((length) => Math.round(length * density));
    [view.canvas.style.width, view.canvas.style.height] = size.map((length) => length + "px");
    view.pen = view.canvas.getContext("2d");
    view.pen.setTransform(density, 0, 0, density, 0, 0);
  }
  draw();
}

const across = (x) => (x - low[0]) * scale;
const upwards = (view, value) => (high[view.up] - value) * scale;

function drawWater(view) {
  const pen = view.pen, tank = recording.tank, [width, height] = [across(high[0]), upwards(view, low[view.up])];
  pen.fillStyle = tank ? "#ffffff" : "#eaf3f8";
  pen.fillRect(0, 0, width, height);
  const area = tank || [low, high];
  const corner = [across(area[0][0]), upwards(view, area[1][view.up])];
  const size = [scale * (area[1][0] - area[0][0]), scale * (area[1][view.up] - area[0][view.up])];
  pen.fillStyle = "#eaf3f8";
  pen.fillRect(...corner, ...size);
  drawGrid(view, [corner[0], corner[1] + size[1]], [width, height]);
  pen.strokeStyle = "#33566b";
  pen.lineWidth = 2;
  if (tank) pen.strokeRect(...corner, ...size);
  drawObstacles(view);
}

// Lines through the whole view, numbers along the water's lower and left edge.
function drawGrid(view, [left, floor], [width, height]) {
  const pen = view.pen, step = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100].find((s) => s * scale > 45) || 500;
  pen.font = "11px system-ui, sans-serif";
  pen.fillStyle = "#6b7c8c";
  pen.strokeStyle = "#d3e0e8";
  pen.lineWidth = 1;
  pen.beginPath();
  for (let x = Math.ceil(low[0] / step) * step; x <= high[0]; x += step) {
    pen.moveTo(across(x), 0);
    pen.lineTo(across(x), height);
    pen.fillText(+x.toFixed(2), across(x) + 2, floor - 4);
  }
  for (let value = Math.ceil(low[view.up] / step) * step; value <= high[view.up]; value += step) {
    pen.moveTo(0, upwards(view, value));
    pen.lineTo(width, upwards(view, value));
    if (upwards(view, value) < floor - 9) pen.fillText(+value.toFixed(2), left + 4, upwards(view, value) - 2);
  }
  pen.stroke();
}

function drawObstacles(view) {
  const pen = view.pen;
  pen.fillStyle = "#8fa3b0";
  for (const [x, y, z, radius] of recording.spheres) {
    pen.beginPath();
    pen.arc(across(x), upwards(view, view.up === 1 ? y : z), radius * scale, 0, 2 * Math.PI);
    pen.fill();
  }
  for (const box of recording.boxes) {
    const top = upwards(view, box[3 + view.up]);
    pen.fillRect(across(box[0]), top, scale * (box[3] - box[0]), upwards(view, box[view.up]) - top);
  }
}

function drawTrail(view, robot, pose, seconds) {
  const pen = view.pen, first = indexAt(robot.time, moment - seconds) + 1, last = indexAt(robot.time, moment);
  if (!seconds || last < 0) return;
  pen.strokeStyle = robot.colour;
  pen.lineWidth = 1.4;
  pen.globalAlpha = 0.6;
  pen.beginPath();
  for (let index = first; index <= last; index += 1) {
    const broken = index === first || robot.time[index] - robot.time[index - 1] > robot.gap;
    const point = [across(robot.poses[4 * index]), upwards(view, robot.poses[4 * index + view.up])];
    if (broken) pen.moveTo(...point); else pen.lineTo(...point);
  }
  if (pose && first <= last) pen.lineTo(across(pose[0]), upwards(view, pose[view.up]));
  pen.stroke();
  pen.globalAlpha = 1;
}

// A dart that points where the robot does; from the side it is as long as its heading is seen there.
function drawRobot(view, robot, pose) {
  const pen = view.pen, [x, y] = [across(pose[0]), upwards(view, pose[view.up])], size = Math.max(7, 0.09 * scale);
  const heading = Number.isNaN(pose[3]) ? [0, 0] : [Math.cos(pose[3]), view.up === 1 ? -Math.sin(pose[3]) : 0];
  pen.fillStyle = robot.colour;
  pen.strokeStyle = "#1c2430";
  pen.lineWidth = 0.8;
  pen.beginPath();
  if (view.up === 1 && !Number.isNaN(pose[3])) {
    const [along, aside] = heading;
    pen.moveTo(x + 1.3 * size * along, y + 1.3 * size * aside);
    pen.lineTo(x - 0.9 * size * along - 0.6 * size * aside, y - 0.9 * size * aside + 0.6 * size * along);
    pen.lineTo(x - 0.5 * size * along, y - 0.5 * size * aside);
    pen.lineTo(x - 0.9 * size * along + 0.6 * size * aside, y - 0.9 * size * aside - 0.6 * size * along);
  } else {
    pen.arc(x, y, 0.5 * size, 0, 2 * Math.PI);
    pen.moveTo(x, y);
    pen.lineTo(x + 1.5 * size * heading[0], y);
  }
  pen.closePath();
  pen.fill();
  pen.stroke();
  if (element("names").checked) pen.fillText(robot.name, x + size, y - size);
}

function draw() {
  const seconds = Number(element("trail").value);
  const poses = robots.map((robot) => poseAt(robot, moment));
  for (const view of views) {
    drawWater(view);
    robots.forEach((robot, number) => {
      view.pen.globalAlpha = 1;
      if (chosen !== null && chosen !== number) return;
      drawTrail(view, robot, poses[number], seconds);
      if (poses[number]) drawRobot(view, robot, poses[number]);
    });
  }
  poses.forEach((pose, number) => element("robots").children[number].classList.toggle("absent", !pose));
  element("moment").value = moment;
  element("shown").textContent = `${moment.toFixed(1)} of ${recording.seconds.toFixed(1)} s`;
}

function goTo(seconds) {
  moment = Math.min(Math.max(seconds, 0), recording.seconds);
  draw();
}

function play(on) {
  if (on && moment >= recording.seconds) moment = 0;
  playing = on;
  previous = null;
  element("play").textContent = on ? "Pause" : "Play";
  if (on) requestAnimationFrame(advance);
}

function advance(now) {
  if (!playing) return;
  if (previous !== null) goTo(moment + ((now - previous) / 1000) * Number(element("speed").value));
  previous = now;
  if (moment >= recording.seconds) play(false); else requestAnimationFrame(advance);
}

robots.forEach((robot, number) => {
  const item = document.createElement("li");
  item.textContent = robot.name;
  item.style.borderColor = robot.colour;
  item.onclick = () => {
    chosen = chosen === number ? null : number;
    [...element("robots").children].forEach((other, place) => other.classList.toggle("chosen", place === chosen));
    draw();
  };
  element("robots").append(item);
});
element("play").onclick = () => play(!playing);
element("moment").oninput = (event) => goTo(Number(event.target.value));
element("trail").onchange = element("names").onchange = draw;
window.onresize = fit;
document.onkeydown = (event) => {
  if (event.target.tagName === "SELECT") return;
  const steps = { ArrowLeft: -1, ArrowRight: 1, Home: -Infinity, End: Infinity };
  if (event.key === " ") play(!playing);
  else if (event.key in steps) goTo(moment + steps[event.key]);
  else return;
  event.preventDefault();
};
const asked = new URLSearchParams(location.hash.slice(1)).get("t");  // PAGE#t=60 opens at that moment
fit();
if (asked === null) play(true); else goTo(Number(asked));
