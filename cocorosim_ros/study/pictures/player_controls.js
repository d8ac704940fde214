// Buttons, keys and mouse.

function choose(number) {
  chosen = number === chosen ? null : number;
  [...element("robots").children].forEach((item, place) => item.classList.toggle("chosen", place === chosen));
  draw();
}

function wholeTank() {
  [camera.centre, camera.zoom] = [middle.slice(), 1];
  element("follow").checked = false;
  draw();
}

// Zooms so that what lies below the pointer stays there.
function zoom(factor, view, [x, y] = [0, 0]) {
  const before = pixels();
  camera.zoom = Math.min(200, Math.max(0.5, camera.zoom * factor));
  if (view) {
    camera.centre[0] += (x - view.size[0] / 2) * (1 / before - 1 / pixels());
    camera.centre[view.up] -= (y - view.size[1] / 2) * (1 / before - 1 / pixels());
  }
  draw();
}

// All robots that are there as large as both views allow, and followed.
function wholeSwarm() {
  const poses = robots.map((robot) => poseAt(robot, moment)).filter(Boolean);
  if (!poses.length) return;
  const length = (axis) => Math.max(...poses.map((pose) => pose[axis])) - Math.min(...poses.map((pose) => pose[axis])) + 0.6;
  const room = views.flatMap(({ size, up }) => [size[0] / length(0), size[1] / length(up)]);
  camera.zoom = Math.min(200, Math.max(1, Math.min(...room) / scale));
  if (chosen !== null) choose(chosen);
  element("follow").checked = true;
  draw();
}

const pointOf = (event) => [event.offsetX, event.offsetY];

// The number of the robot nearest to a point of a view, or null where none is near.
function robotAt(view, [x, y]) {
  let nearest = null, least = 18;
  robots.forEach((robot, number) => {
    const pose = poseAt(robot, moment);
    const distance = pose ? Math.hypot(across(view, pose[0]) - x, upwards(view, pose[view.up]) - y) : Infinity;
    if (distance < least) [nearest, least] = [number, distance];
  });
  return nearest;
}

function hint(event, text) {
  const box = element("hint");
  box.hidden = !text;
  if (!text) return;
  box.textContent = text;
  box.style.left = `${Math.min(event.clientX + 14, window.innerWidth - 190)}px`;
  box.style.top = `${Math.min(event.clientY + 14, window.innerHeight - 60)}px`;
}

function robotText(number) {
  if (number === null) return "";
  const pose = poseAt(robots[number], moment), [x, y, z] = pose.map((part) => part.toFixed(3));
  const heading = Number.isNaN(pose[3]) ? "not known" : `${Math.round((pose[3] * 180) / Math.PI)}°`;
  return `${robots[number].name}\n${x}, ${y}, ${z} m\nheading ${heading}`;
}

for (const view of views) {
  let held = null;
  view.canvas.onwheel = (event) => {
    event.preventDefault();
    zoom(Math.exp(-0.0015 * event.deltaY), view, pointOf(event));
  };
  view.canvas.onpointerdown = (event) => {
    held = { point: pointOf(event), centre: camera.centre.slice(), moved: false };
    view.canvas.setPointerCapture(event.pointerId);
  };
  view.canvas.onpointermove = (event) => {
    const [x, y] = pointOf(event);
    hint(event, held ? "" : robotText(robotAt(view, [x, y])));
    if (!held || Math.hypot(x - held.point[0], y - held.point[1]) < 4) return;
    held.moved = true;
    camera.centre[0] = held.centre[0] - (x - held.point[0]) / pixels();
    camera.centre[view.up] = held.centre[view.up] + (y - held.point[1]) / pixels();
    draw();
  };
  view.canvas.onpointerup = (event) => {
    const number = held && !held.moved ? robotAt(view, pointOf(event)) : null;
    held = null;
    if (number !== null) choose(number);
  };
  view.canvas.onpointerleave = (event) => hint(event, "");
  view.canvas.ondblclick = wholeTank;
}

for (const curve of curves) {
  curve.canvas.onpointermove = (event) => {
    const seconds = timeAt(curve, event.offsetX);
    if (event.buttons) goTo(seconds);
    hint(event, seconds < 0 ? "" : `${seconds.toFixed(1)} s\n${curve.label}: ${shownValue(curve, valueAt(curve, seconds))}`);
  };
  curve.canvas.onpointerdown = (event) => goTo(timeAt(curve, event.offsetX));
  curve.canvas.onpointerleave = (event) => hint(event, "");
}

robots.forEach((robot, number) => {
  const item = document.createElement("li");
  item.textContent = robot.name;
  item.style.borderColor = robot.colour;
  item.onclick = () => choose(number);
  element("robots").append(item);
});
element("swarm").onclick = wholeSwarm;
element("tank").onclick = wholeTank;
element("play").onclick = () => play(!playing);
element("moment").oninput = (event) => goTo(Number(event.target.value));
element("trail").onchange = element("names").onchange = element("follow").onchange = draw;

function faster(places) {
  const list = element("speed");
  list.selectedIndex = Math.min(list.options.length - 1, Math.max(0, list.selectedIndex + places));
}

function next(places) {
  const count = robots.length;
  choose(chosen === null ? (places > 0 ? 0 : count - 1) : (chosen + places + count) % count);
}

function turn(id) {
  element(id).checked = !element(id).checked;
  draw();
}

const KEYS = {
  " ": () => play(!playing),
  ArrowLeft: (event) => goTo(moment - (event.shiftKey ? 10 : 1)),
  ArrowRight: (event) => goTo(moment + (event.shiftKey ? 10 : 1)),
  ArrowUp: () => faster(1), ArrowDown: () => faster(-1),
  Home: () => goTo(0), End: () => goTo(recording.seconds),
  ",": () => next(-1), ".": () => next(1), Escape: () => chosen !== null && choose(chosen),
  f: () => turn("follow"), n: () => turn("names"),
  "+": () => zoom(1.25), "=": () => zoom(1.25), "-": () => zoom(0.8), 0: wholeTank, s: wholeSwarm,
};
document.onkeydown = (event) => {
  if (["SELECT", "SUMMARY"].includes(event.target.tagName) || event.ctrlKey || event.altKey || event.metaKey || !(event.key in KEYS)) return;
  KEYS[event.key](event);
  event.preventDefault();
};
window.onresize = fit;
window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { readTheme(); draw(); });
const asked = new URLSearchParams(location.hash.slice(1)).get("t");  // PAGE#t=60 opens at that moment
readTheme();
fit();
fit();  // the first may have brought a scroll bar
if (asked === null) play(true); else goTo(Number(asked));
document.documentElement.dataset.shown = "yes";
