"use strict";
// Plays a run: parts get their transform from the pose of the bodies at the present time.
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const $ = (id) => document.getElementById(id);
  const { t: times, scale, poses, anchors, arrows } = data;
  const last = times.length - 1, start = times[0], end = times[last];
  const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
  const stage = $("stage");

  // ---- state at a time: x and y in pixels, y downwards; angles in radians, counterclockwise

  let now = start, playing = false, frame = 0, part = 0;

  function locate(t) {
    let a = 0, b = last;
    while (b - a > 1) { const m = (a + b) >> 1; if (times[m] <= t) a = m; else b = m; }
    frame = a;
    part = b > a ? Math.min(1, Math.max(0, (t - times[a]) / (times[b] - times[a]))) : 0;
  }
  const next = () => Math.min(frame + 1, last);
  const mix = (list) => list[frame] + part * (list[next()] - list[frame]);

  function pose(i) { const [x, y, phi] = poses[i]; return [mix(x), mix(y), mix(phi)]; }

  function local(k) {
    const [, x, y] = anchors[k];
    if (typeof x === "number") return [x, y];
    return [0, 1].map((i) => x[frame][i] + part * (x[next()][i] - x[frame][i]));
  }
  function vector(k) {
    const body = anchors[k][0], [x, y] = local(k);
    if (body < 0) return [x, y];
    const phi = mix(poses[body][2]), c = Math.cos(phi), s = Math.sin(phi);
    return [x * c - y * s, x * s + y * c];
  }
  function point(k) {
    const body = anchors[k][0], [x, y] = vector(k);
    return body < 0 ? [x, y] : [mix(poses[body][0]) + x, mix(poses[body][1]) + y];
  }
  const pixels = ([x, y]) => [x * scale, -y * scale];
  const turn = ([x, y]) => -Math.atan2(y, x);
  const short = (x) => x.toFixed(2);

  // Place in pixels, angle clockwise and stretch along x of a part.
  function placed([kind, a, b]) {
    if (kind === "body") {
      const [x, y, phi] = pose(a);
      return [x * scale, -y * scale, -phi, 1];
    }
    const p = point(a), [x, y] = pixels(p);
    if (kind === "at") return [x, y, b === null ? 0 : turn(vector(b)), 1];
    const q = point(b), gap = [q[0] - p[0], q[1] - p[1]];
    return [x, y, turn(gap), Math.hypot(...gap) * scale / 100];
  }

  // ---- the whole motion: boxes around points

  const box = { left: Infinity, right: -Infinity, top: Infinity, bottom: -Infinity };
  let size = 0;
  {
    const shown = [...data.bodies.keys()].map((i) => () => pose(i).slice(0, 2));
    const standing = data.parts.flatMap(([kind, a, b]) => (kind === "body" ? [] : kind === "at" ? [a] : [a, b]));
    new Set(standing).forEach((k) => shown.push(() => point(k)));
    const stride = Math.max(1, Math.floor(last * shown.length / 40000));
    for (let i = 0; i <= last; i += stride) {
      frame = i; part = 0;
      const own = shown.map((f) => pixels(f()));
      const xs = own.map((p) => p[0]), ys = own.map((p) => p[1]);
      const [l, r, u, d] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
      if (i === 0) size = Math.max(r - l, d - u, 100);
      box.left = Math.min(box.left, l); box.right = Math.max(box.right, r);
      box.top = Math.min(box.top, u); box.bottom = Math.max(box.bottom, d);
    }
    const margin = Math.max(40, 0.08 * size);
    box.left -= margin; box.right += margin; box.top -= margin; box.bottom += margin;
  }

  // ---- camera

  let zoom = 1, factor = 1, offset = [0, 0], origin = [0, 0];
  const view = () => [stage.clientWidth || 800, stage.clientHeight || 450];

  function camera() {
    const [w, h] = view(), body = +$("follow").value;
    for (const layer of [stage, $("back")]) layer.setAttribute("viewBox", `0 0 ${w} ${h}`);
    let centre;
    if (body < 0) {
      zoom = factor * Math.min(w / (box.right - box.left), h / (box.bottom - box.top));
      centre = [(box.left + box.right) / 2, (box.top + box.bottom) / 2];
    } else {
      zoom = factor * Math.min(w / 2, h) / (1.5 * size);
      centre = pixels(pose(body));
    }
    centre = [centre[0] - offset[0] / zoom, centre[1] - offset[1] / zoom];
    const [ox, oy] = origin = [w / 2 - zoom * centre[0], h / 2 - zoom * centre[1]];
    for (const world of document.querySelectorAll(".world")) world.setAttribute("transform", `translate(${short(ox)} ${short(oy)})scale(${zoom.toFixed(5)})`);
    const step = nice(90 / (zoom * scale)) * zoom * scale;
    let lines = "";
    for (let x = ((ox % step) + step) % step; x < w; x += step) lines += `M${short(x)} 0V${h}`;
    for (let y = ((oy % step) + step) % step; y < h; y += step) lines += `M0 ${short(y)}H${w}`;
    $("grid").setAttribute("d", lines);
    const [bar, label] = $("bar").children, x = w - step - 14, y = h - 14;
    bar.setAttribute("d", `M${short(x)} ${y - 4}v8m0 -4h${short(step)}m0 -4v8`);
    label.setAttribute("x", short(x + step / 2)); label.setAttribute("y", y - 8);
    label.textContent = `${+(step / zoom / scale).toPrecision(3)} m`;
  }
  // A length of 1, 2 or 5 times a power of ten, not below x.
  function nice(x) {
    const power = 10 ** Math.floor(Math.log10(x));
    return power * [1, 2, 5, 10].find((f) => f * power >= x * 0.999);
  }

  // ---- parts: their outlines once, their looks for each colour scheme

  const canvas = $("canvas"), ink = canvas.getContext("2d");
  const parts = [...$("parts").children].map((element, i) => ({
    element, motion: data.parts[i], title: element.firstChild.textContent,
    shapes: [...element.children].slice(1).map((shape) => ({ shape, outline: outline(shape) })),
  }));
  function outline(shape) {
    const path = new Path2D(shape.getAttribute("d") || ""), number = (name) => +shape.getAttribute(name);
    if (shape.tagName === "circle") path.arc(0, 0, number("r"), 0, 2 * Math.PI);
    if (shape.tagName === "rect") path.roundRect(number("x"), number("y"), number("width"), number("height"), number("rx"));
    return path;
  }
  function look() {
    const known = {};
    const read = ({ fill, fillOpacity, stroke, strokeWidth, strokeLinecap, strokeLinejoin }) => ({
      fill: fill === "none" ? null : fill.replace(/rgb\((.*)\)/, `rgba($1, ${fillOpacity})`),
      stroke: stroke === "none" ? null : stroke, width: parseFloat(strokeWidth), cap: strokeLinecap, join: strokeLinejoin,
    });
    for (const part of parts) {
      const kind = part.element.getAttribute("class");
      part.hidden = known[kind] ??= getComputedStyle(part.element).display === "none";
      for (const drawn of part.shapes) drawn.look = known[`${kind} ${drawn.shape.getAttribute("class")}`] ??= read(getComputedStyle(drawn.shape));
    }
  }
  // The axes of the canvas become those of a part. Lines are as wide wherever they are, so that a stretch is not of the axes.
  function enter([x, y, angle]) {
    const dots = devicePixelRatio, c = zoom * dots * Math.cos(angle), s = zoom * dots * Math.sin(angle);
    ink.setTransform(c, s, -s, c, dots * (origin[0] + zoom * x), dots * (origin[1] + zoom * y));
  }
  function stretched(outline, stretch) {
    if (stretch === 1) return outline;
    const path = new Path2D();
    path.addPath(outline, new DOMMatrix([stretch, 0, 0, 1, 0, 0]));
    return path;
  }
  function drawParts() {
    const size = view().map((side) => Math.round(side * devicePixelRatio));
    if (canvas.width !== size[0] || canvas.height !== size[1]) [canvas.width, canvas.height] = size;
    ink.setTransform(1, 0, 0, 1, 0, 0);
    ink.clearRect(0, 0, ...size);
    let last = null;
    for (const { hidden, motion, shapes } of parts) {
      if (hidden) continue;
      const at = placed(motion);
      enter(at);
      for (const { outline, look } of shapes) {
        const path = stretched(outline, at[3]);
        if (look !== last) {
          ink.fillStyle = look.fill;
          ink.strokeStyle = look.stroke;
          ink.lineWidth = look.width / zoom;
          ink.lineCap = look.cap;
          ink.lineJoin = look.join;
          last = look;
        }
        if (look.fill) ink.fill(path);
        if (look.stroke) ink.stroke(path);
      }
    }
  }
  // The name of the foremost part there.
  function named(event) {
    const at = [event.offsetX * devicePixelRatio, event.offsetY * devicePixelRatio];
    const isThere = ({ hidden, motion, shapes }) => {
      if (hidden) return false;
      const place = placed(motion);
      enter(place);
      ink.lineWidth = 6 / zoom;
      return shapes.some(({ outline, look }) => {
        const path = stretched(outline, place[3]);
        return look.fill && ink.isPointInPath(path, ...at) || ink.isPointInStroke(path, ...at);
      });
    };
    return parts.findLast(isThere)?.title ?? "";
  }
  // For paper: the same parts as SVG.
  function drawSharp() {
    for (const { element, motion } of parts) {
      const [x, y, angle, stretch] = placed(motion);
      element.setAttribute("transform", `translate(${short(x)} ${short(y)})rotate(${short(angle * 180 / Math.PI)})scale(${stretch.toFixed(4)} 1)`);
    }
  }

  // ---- arrows, names, traces

  const svg = (name, parent, attributes = {}) => {
    const element = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const key in attributes) element.setAttribute(key, attributes[key]);
    return parent.appendChild(element);
  };
  const largest = (unit) => Math.max(1e-300, ...arrows.filter((a) => a.unit === unit).map((a) => percentile(a.values.map((v) => Math.hypot(...v)))));
  // Of a peak, such as an impact, the rest of the motion says the scale.
  function percentile(values) { values.sort((a, b) => a - b); return values[Math.floor(0.98 * (values.length - 1))] || 0; }
  const LONGEST = 90;
  const most = { "N": largest("N"), "N*m": largest("N*m") };
  const arrowPaths = arrows.map((arrow) => {
    const path = svg("path", $("arrows"), { class: `arrow ${arrow.reaction ? "reaction" : "applied"}`, "marker-end": "url(#head)" });
    svg("title", path).textContent = `${arrow.reaction ? "constraint force of" : "force of"} ${arrow.name}`;
    return path;
  });

  function drawArrows() {
    if (!$("showforces").checked) return;
    arrows.forEach((arrow, i) => {
      const value = arrow.values[frame].map((x, k) => x + part * (arrow.values[next()][k] - x));
      const [x, y] = pixels(arrow.at === null ? pose(arrow.body) : point(arrow.at));
      const share = Math.min(2, Math.hypot(...value) / most[arrow.unit]);
      let d = "";
      if (share > 0.03 && arrow.unit === "N") {
        const f = LONGEST / zoom / most.N, k = share >= 2 ? 2 * most.N / Math.hypot(...value) : 1;
        d = `M${short(x)} ${short(y)}l${short(value[0] * f * k)} ${short(-value[1] * f * k)}`;
      } else if (share > 0.03) {
        const r = 26 / zoom, angle = Math.sign(value[0]) * Math.min(1, share) * 4.5;
        const to = [x + r * Math.cos(angle), y - r * Math.sin(angle)];
        d = `M${short(x + r)} ${short(y)}A${short(r)} ${short(r)} 0 ${Math.abs(angle) > Math.PI ? 1 : 0} ${angle > 0 ? 0 : 1} ${to.map(short).join(" ")}`;
      }
      arrowPaths[i].setAttribute("d", d);
    });
  }

  const places = [...data.points.map(([name, k]) => [name, () => pixels(point(k))]), ...data.bodies.map((name, i) => [name, () => pixels(pose(i))])];
  const labels = places.length <= 60 ? places : [];
  const texts = labels.map(([name]) => { const text = svg("text", $("names")); text.textContent = name; return text; });

  function drawNames() {
    if (!$("shownames").checked) return;
    const taken = [];
    texts.forEach((text, i) => {
      const [x, y] = labels[i][1]();
      // of names at one place the first is shown
      const free = taken.every(([a, b]) => Math.abs(a - x) * zoom > 8 * labels[i][0].length || Math.abs(b - y) * zoom > 13);
      text.style.display = free ? "" : "none";
      if (!free) return;
      taken.push([x, y]);
      text.setAttribute("transform", `translate(${short(x)} ${short(y)})scale(${(1 / zoom).toFixed(4)})translate(9 -9)`);
    });
  }

  let traced = [];
  function retrace() {
    const at = $("traceof").value, held = [frame, part];
    traced = [];
    if (at !== "") for (let i = 0; i <= last; i++) { frame = i; part = 0; traced.push(places[at][1]().map(short).join(" ")); }
    [frame, part] = held;
    $("trace").setAttribute("d", traced.length ? `M${traced.join("L")}` : "");
  }
  function drawTrace() {
    const until = traced.length ? traced.slice(0, frame + 1).concat(places[$("traceof").value][1]().map(short).join(" ")) : [];
    $("traced").setAttribute("d", until.length ? `M${until.join("L")}` : "");
  }

  // ---- plots

  const H = 130, L = 46, B = 16, T = 6;
  let plots = [], width = 0;
  // Curves are drawn for the width that there is, so that letters keep their shape.
  function layPlots() {
    const first = document.createElement("div");
    $("plots").replaceChildren(first);
    width = Math.max(160, first.clientWidth);
    $("plots").replaceChildren();
    plots = data.plots.map(lay);
  }
  function lay(plot) {
    const W = width, figure = document.createElement("div");
    figure.className = "plot";
    const title = document.createElement("h2"), unit = document.createElement("span");
    unit.textContent = plot.unit && plot.unit !== "1" ? ` in ${plot.unit}` : "";
    title.append(plot.title, unit);
    const values = plot.curves.flatMap((c) => c.values);
    let low = Math.min(...values), high = Math.max(...values);
    const least = 2e-4 * Math.max(Math.abs(high), Math.abs(low)) || 1;
    if (high - low < least) { low -= 0.5 * (Math.abs(low) || 1); high += 0.5 * (Math.abs(high) || 1); }
    const x = (t) => L + (W - L - 4) * (end > start ? (t - start) / (end - start) : 0);
    const y = (v) => T + (H - T - B) * (1 - (v - low) / (high - low));
    const picture = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    for (const [key, value] of [["viewBox", `0 0 ${W} ${H}`], ["role", "img"], ["aria-label", `${plot.title} over time`]]) picture.setAttribute(key, value);
    svg("path", picture, { class: "axis", d: `M${L} ${T}V${H - B}H${W - 4}${low < 0 && high > 0 ? `M${L} ${short(y(0))}H${W - 4}` : ""}` });
    const tick = (value, px, py, anchor) => { svg("text", picture, { x: px, y: py, "text-anchor": anchor }).textContent = label(value, 3); };
    tick(high, L - 4, T + 9, "end"); tick(low, L - 4, H - B, "end");
    tick(start, L, H - 3, "start"); tick(end, W - 4, H - 3, "end");
    plot.curves.forEach((curve, i) => {
      svg("path", picture, { class: `curve c${i % 3}`, d: "M" + curve.values.map((v, k) => `${short(x(times[k]))} ${short(y(v))}`).join("L") });
    });
    for (const [name, t] of data.events.slice(0, 200)) {
      const mark = svg("path", picture, { class: "event", d: `M${short(x(t))} ${H - B}v-9` });
      svg("title", mark).textContent = `${name}, t = ${label(t, 5)} s`;
    }
    const cursor = svg("path", picture, { class: "cursor" });
    const legend = document.createElement("p");
    const readings = plot.curves.map((_, i) => {
      const item = document.createElement("span");
      item.className = `c${i % 3}`;
      legend.append(item);
      return item;
    });
    figure.append(title, picture, legend);
    $("plots").append(figure);
    const seek = (event) => {
      const box = picture.getBoundingClientRect(), px = (event.clientX - box.left) / box.width * W;
      show(start + (end - start) * Math.min(1, Math.max(0, (px - L) / (W - L - 4))));
    };
    picture.addEventListener("pointerdown", (event) => { picture.setPointerCapture(event.pointerId); pause(); seek(event); });
    picture.addEventListener("pointermove", (event) => { if (event.buttons) seek(event); });
    return () => {
      const at = short(x(now));
      cursor.setAttribute("d", `M${at} ${T}V${H - B}`);
      readings.forEach((item, i) => { item.textContent = `${plot.curves.length > 1 ? plot.curves[i].name + " " : ""}${label(mix(plot.curves[i].values), 4)}`; });
    };
  }
  function label(x, digits) {
    const size = Math.abs(x);
    return (size !== 0 && (size < 1e-3 || size >= 1e5) ? x.toExponential(2) : String(+x.toPrecision(digits))).replace("-", "−");
  }

  // ---- one frame

  const decimals = Math.max(0, Math.min(6, 3 - Math.floor(Math.log10(end - start || 1))));
  function show(t) {
    now = Math.min(end, Math.max(start, t));
    locate(now);
    camera();
    drawParts(); drawArrows(); drawNames(); drawTrace();
    plots.forEach((plot) => plot());
    $("time").value = Math.round(1e4 * (end > start ? (now - start) / (end - start) : 0));
    $("clock").textContent = `t = ${now.toFixed(decimals)} s`;
    $("time").setAttribute("aria-valuetext", `${now.toFixed(decimals)} seconds`);
  }

  // ---- playing

  const span = end - start;
  // Seconds of motion for a second: real time, unless that takes too short or too long.
  const usual = span < 2 ? span / 8 : span > 200 ? span / 60 : 1;
  const speeds = [...new Set([0.1, 0.25, 0.5, 1, 2, 4, 8].map((f) => +(f * (usual === 1 ? 1 : nice(usual))).toPrecision(3)))];
  speeds.forEach((s) => $("speed").add(new Option(`${s} ×`, s)));
  $("speed").value = usual === 1 ? 1 : +nice(usual).toPrecision(3);

  let before = 0;
  function tick(at) {
    if (!playing) return;
    const step = Math.min(0.1, (at - before) / 1000) * $("speed").value;
    before = at;
    show(now + step);
    if (now < end) requestAnimationFrame(tick); else if (data.repeats) { show(start); requestAnimationFrame(tick); } else pause();
  }
  function play() {
    if (span <= 0) return;
    if (now >= end) show(start);
    playing = true;
    document.body.classList.add("playing");
    $("play").setAttribute("aria-label", "Pause");
    before = performance.now();
    requestAnimationFrame(tick);
  }
  function pause() {
    playing = false;
    document.body.classList.remove("playing");
    $("play").setAttribute("aria-label", "Play");
  }
  const again = () => show(now);
  function move(frames) { pause(); const i = Math.min(last, Math.max(0, Math.round(frame + part) + frames)); show(times[i]); }
  function grow(by) { factor *= by; again(); }
  function faster(by) { const s = $("speed"); s.selectedIndex = Math.min(s.length - 1, Math.max(0, s.selectedIndex + by)); }
  function toggle(id) { $(id).checked = !$(id).checked; $(id).dispatchEvent(new Event("change")); }
  function fit() { factor = 1; offset = [0, 0]; again(); }

  const keys = {
    " ": () => (playing ? pause() : play()),
    ArrowLeft: (e) => move(e.shiftKey ? -10 : -1), ArrowRight: (e) => move(e.shiftKey ? 10 : 1),
    Home: () => { pause(); show(start); }, End: () => { pause(); show(end); },
    ArrowUp: () => faster(1), ArrowDown: () => faster(-1),
    "+": () => grow(1.25), "-": () => grow(0.8), "0": fit,
    f: () => toggle("showforces"), n: () => toggle("shownames"), "?": () => $("keys").showModal(),
  };
  document.addEventListener("keydown", (event) => {
    const typed = event.target.closest?.("select, dialog, details, button");
    if (typed && (event.key === " " || event.key.startsWith("Arrow")) || event.ctrlKey || event.metaKey || event.altKey) return;
    const act = keys[event.key];
    if (act) { event.preventDefault(); act(event); }
  });
  $("play").addEventListener("click", () => (playing ? pause() : play()));
  $("time").addEventListener("input", () => { pause(); show(start + span * $("time").value / 1e4); });
  $("in").addEventListener("click", () => grow(1.25));
  $("out").addEventListener("click", () => grow(0.8));
  $("fit").addEventListener("click", fit);
  $("help").addEventListener("click", () => $("keys").showModal());
  $("follow").addEventListener("change", fit);
  $("traceof").addEventListener("change", () => { retrace(); again(); });
  $("showforces").addEventListener("change", () => { $("arrows").style.display = $("showforces").checked ? "" : "none"; $("legend").hidden = !$("showforces").checked; again(); });
  $("shownames").addEventListener("change", () => { $("names").style.display = $("shownames").checked ? "" : "none"; again(); });
  stage.addEventListener("wheel", (event) => { if (event.ctrlKey) { event.preventDefault(); grow(Math.exp(-event.deltaY / 200)); } }, { passive: false });
  stage.addEventListener("pointermove", (event) => {
    if (!event.buttons && !playing) stage.parentElement.title = named(event);
    if (event.buttons && event.pointerType === "mouse") { offset[0] += event.movementX; offset[1] += event.movementY; again(); }
  });

  addEventListener("beforeprint", () => { document.querySelector("details").open = true; again(); drawSharp(); });
  addEventListener("afterprint", again);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { look(); again(); });

  // ---- first view

  document.body.classList.add("scripted");
  look();
  $("time").max = 1e4;
  data.bodies.slice(0, 100).forEach((name, i) => $("follow").add(new Option(name, i)));
  places.slice(0, 100).forEach(([name], i) => $("traceof").add(new Option(name, i)));
  const far = Math.max(box.right - box.left, box.bottom - box.top) > 6 * size;
  if (far) $("follow").value = 0;
  $("traceof").value = data.bodies.length <= 40 ? String(data.points.length && !far ? data.points.length - 1 : data.points.length) : "";
  if (arrows.length === 0) $("showforces").closest("label").hidden = true;
  else {
    const items = [["reaction", "constraint forces"], ["applied", "applied forces and torques"]].filter(([kind]) => arrows.some((a) => a.reaction === (kind === "reaction")));
    const sample = (kind) => `<svg width="34" height="10" aria-hidden="true"><path class="arrow ${kind}" d="M2 5H24" marker-end="url(#head)"/></svg>`;
    const unit = nice(most.N / 3);
    $("legend").innerHTML = items.map(([kind, text]) => `${sample(kind)} ${text}`).join(" &ensp; ")
      + (arrows.some((a) => a.unit === "N") ? ` &ensp; <svg width="${LONGEST * unit / most.N + 4}" height="10" aria-hidden="true"><path d="M2 2v6m0 -3h${LONGEST * unit / most.N}m0 -3v6" stroke="currentColor" fill="none"/></svg> ${label(unit, 3)} N` : "");
  }
  if (labels.length === 0) $("shownames").closest("label").hidden = true;
  if (labels.length > 16) toggle("shownames");
  $("arrows").style.display = "none";
  layPlots();
  retrace();
  show(start);
  new ResizeObserver(() => { layPlots(); again(); }).observe(stage);
  if (!calm) play();
})();
