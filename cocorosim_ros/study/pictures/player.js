"use strict";
// Plays a recording: what it holds, and where each robot is at a moment, between its poses.

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

const curves = recording.curves.map((curve) => ({
  ...curve, time: floats(curve.time), low: floats(curve.low), mean: floats(curve.mean), high: floats(curve.high),
}));
let moment = 0, playing = false, chosen = null, previous = null;

// Colours of the page, which are others in the dark.
const theme = {};
function readTheme() {
  const style = getComputedStyle(document.documentElement);
  for (const name of ["ink", "quiet", "line", "paper", "raised", "accent", "water", "wall", "grid", "solid", "curve", "band", "edge"])
    theme[name] = style.getPropertyValue(`--${name}`).trim();
}

function sharpen(canvas, width, height) {
  const density = window.devicePixelRatio || 1;
  [canvas.width, canvas.height] = [Math.round(width * density), Math.round(height * density)];
  [canvas.style.width, canvas.style.height] = [`${width}px`, `${height}px`];
  const pen = canvas.getContext("2d");
  pen.setTransform(density, 0, 0, density, 0, 0);
  return pen;
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
