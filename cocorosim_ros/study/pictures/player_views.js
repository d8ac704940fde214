// The tank from above and from the side, at one scale, around one place that both views show.

const views = [{ canvas: element("above"), up: 1, size: [1, 1] }, { canvas: element("side"), up: 2, size: [1, 1] }];
const low = recording.view[0], high = recording.view[1];
const middle = low.map((least, axis) => (least + high[axis]) / 2);
const camera = { centre: middle.slice(), zoom: 1 };
let scale = 1;

const pixels = () => scale * camera.zoom;
const across = (view, x) => view.size[0] / 2 + (x - camera.centre[0]) * pixels();
const upwards = (view, value) => view.size[1] / 2 + (camera.centre[view.up] - value) * pixels();

// Both views as large as the window allows: beside each other in a wide one, with the curves below the flat one.
function fit() {
  const [x, y, z] = low.map((least, axis) => high[axis] - least);
  const width = Math.max(240, document.documentElement.clientWidth - 42);
  const height = Math.max(240, window.innerHeight - element("main").offsetTop - 58);
  const wide = width > 1.2 * height && width > 800;
  element("main").className = wide ? "" : "tall";
  const gap = 20, curveHeight = recording.curves.length ? 3 * 96 : 0;
  scale = wide ? Math.min((width - gap) / (2 * x), height / y, (height - curveHeight - 24) / z) : Math.min(width / x, height / (y + z));
  if (wide && 2 * x * scale + gap < width && x * scale < 400) scale = Math.min(height / y, (width - gap - 420) / x);
  const beside = wide ? width - gap - x * scale : x * scale;
  views[0].size = [scale * x, scale * y];
  views[1].size = [wide ? beside : scale * x, scale * z];
  for (const view of views) view.pen = sharpen(view.canvas, ...view.size);
  fitCurves(beside, wide ? height - views[1].size[1] - 24 : 3 * 110);
  draw();
}

function drawWater(view) {
  const pen = view.pen, tank = recording.tank, [width, height] = view.size;
  pen.fillStyle = tank ? theme.paper : theme.water;
  pen.fillRect(0, 0, width, height);
  const area = tank || [low, high];
  const corner = [across(view, area[0][0]), upwards(view, area[1][view.up])];
  const size = [pixels() * (area[1][0] - area[0][0]), pixels() * (area[1][view.up] - area[0][view.up])];
  pen.fillStyle = theme.water;
  pen.fillRect(...corner, ...size);
  drawGrid(view, [Math.max(0, corner[0]), Math.min(height, corner[1] + size[1])]);
  pen.strokeStyle = theme.wall;
  pen.lineWidth = 2;
  if (tank) pen.strokeRect(...corner, ...size);
  drawObstacles(view);
}

// Lines through the whole view, numbers along the water's lower and left edge.
function drawGrid(view, [left, floor]) {
  const pen = view.pen, [width, height] = view.size, zoomed = pixels();
  const step = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100].find((s) => s * zoomed > 45) || 500;
  const first = (centre, length) => Math.ceil((centre - length / 2 / zoomed) / step) * step;
  const last = (centre, length) => centre + length / 2 / zoomed;
  pen.font = "11px system-ui, sans-serif";
  pen.fillStyle = theme.quiet;
  pen.strokeStyle = theme.grid;
  pen.lineWidth = 1;
  pen.beginPath();
  for (let x = first(camera.centre[0], width); x <= last(camera.centre[0], width); x += step) {
    pen.moveTo(across(view, x), 0);
    pen.lineTo(across(view, x), height);
    pen.fillText(+x.toFixed(2), across(view, x) + 2, floor - 4);
  }
  for (let value = first(camera.centre[view.up], height); value <= last(camera.centre[view.up], height); value += step) {
    pen.moveTo(0, upwards(view, value));
    pen.lineTo(width, upwards(view, value));
    if (upwards(view, value) < floor - 9) pen.fillText(+value.toFixed(2), left + 4, upwards(view, value) - 2);
  }
  pen.stroke();
}

function drawObstacles(view) {
  const pen = view.pen;
  pen.fillStyle = theme.solid;
  for (const [x, y, z, radius] of recording.spheres) {
    pen.beginPath();
    pen.arc(across(view, x), upwards(view, view.up === 1 ? y : z), radius * pixels(), 0, 2 * Math.PI);
    pen.fill();
  }
  for (const box of recording.boxes) {
    const top = upwards(view, box[3 + view.up]);
    pen.fillRect(across(view, box[0]), top, pixels() * (box[3] - box[0]), upwards(view, box[view.up]) - top);
  }
}

function drawTrail(view, robot, pose, seconds) {
  const pen = view.pen, first = indexAt(robot.time, moment - seconds) + 1, last = indexAt(robot.time, moment);
  if (!seconds || last < 0) return;
  pen.strokeStyle = robot.colour;
  pen.lineWidth = 1.4;
  pen.beginPath();
  for (let index = first; index <= last; index += 1) {
    const broken = index === first || robot.time[index] - robot.time[index - 1] > robot.gap;
    const point = [across(view, robot.poses[4 * index]), upwards(view, robot.poses[4 * index + view.up])];
    if (broken) pen.moveTo(...point); else pen.lineTo(...point);
  }
  if (pose && first <= last) pen.lineTo(across(view, pose[0]), upwards(view, pose[view.up]));
  pen.stroke();
}

// A dart that points where the robot does; from the side it is as long as its heading is seen there.
function drawRobot(view, robot, pose) {
  const pen = view.pen, [x, y] = [across(view, pose[0]), upwards(view, pose[view.up])];
  const size = Math.min(26, Math.max(7, 0.07 * pixels())), along = Math.cos(pose[3]), aside = -Math.sin(pose[3]);
  pen.fillStyle = robot.colour;
  pen.strokeStyle = theme.edge;
  pen.lineWidth = 0.8;
  pen.beginPath();
  if (view.up === 1 && !Number.isNaN(pose[3])) {
    pen.moveTo(x + 1.3 * size * along, y + 1.3 * size * aside);
    pen.lineTo(x - 0.9 * size * along - 0.6 * size * aside, y - 0.9 * size * aside + 0.6 * size * along);
    pen.lineTo(x - 0.5 * size * along, y - 0.5 * size * aside);
    pen.lineTo(x - 0.9 * size * along + 0.6 * size * aside, y - 0.9 * size * aside - 0.6 * size * along);
  } else {
    pen.arc(x, y, 0.5 * size, 0, 2 * Math.PI);
    pen.moveTo(x, y);
    pen.lineTo(x + 1.5 * size * (Number.isNaN(pose[3]) ? 0 : along), y);
  }
  pen.closePath();
  pen.fill();
  pen.stroke();
  pen.fillStyle = theme.ink;
  if (element("names").checked) pen.fillText(robot.name, x + size, y - size);
}

function drawView(view, poses) {
  const seconds = Number(element("trail").value);
  drawWater(view);
  robots.forEach((robot, number) => {
    const behind = chosen !== null && chosen !== number;
    view.pen.globalAlpha = behind ? 0.12 : 0.6;
    drawTrail(view, robot, poses[number], seconds);
    view.pen.globalAlpha = behind ? 0.3 : 1;
    if (poses[number]) drawRobot(view, robot, poses[number]);
    view.pen.globalAlpha = 1;
  });
}

// Where the chosen robot is, or else the middle of all.
function followed(poses) {
  const seen = poses.filter((pose, number) => pose && (chosen === null || chosen === number));
  if (!seen.length) return camera.centre;
  return [0, 1, 2].map((axis) => seen.reduce((sum, pose) => sum + pose[axis], 0) / seen.length);
}

function draw() {
  const poses = robots.map((robot) => poseAt(robot, moment));
  if (element("follow").checked) camera.centre = followed(poses);
  for (const view of views) drawView(view, poses);
  poses.forEach((pose, number) => element("robots").children[number].classList.toggle("absent", !pose));
  drawCurves();
  element("moment").value = moment;
  element("shown").textContent = `${moment.toFixed(1)} of ${recording.seconds.toFixed(1)} s`;
}
