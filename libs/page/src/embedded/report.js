  // What the tables of the page cannot do alone: the plot, the map, and the links between map and
  // tables. Names are only ever set as text, never as HTML. report.html puts this and
  // report_tools.js into one function.
  const read = (id) => JSON.parse(document.getElementById(id).textContent);
  // comparison.json, as it was saved; with each run what only this page draws.
  const data = read("comparison"), drawn = read("data");
  data.runs.forEach((run, i) => Object.assign(run, drawn.runs[i]));

  // What is drawn stands upright: turned about the origin against the frame of the site.
  const rotation = (turn) => ([x, y]) =>
    [Math.cos(turn) * x - Math.sin(turn) * y, Math.sin(turn) * x + Math.cos(turn) * y];
  const shownFromSite = rotation(drawn.turn), siteFromShown = rotation(-drawn.turn);
  const turnPlace = (at) => { [at.x, at.y] = shownFromSite([at.x, at.y]); };
  const turnPose = (pose) => pose && [...shownFromSite(pose), pose[2] + drawn.turn];

  data.runs.forEach((run) => run.path.forEach(turnPlace));
  data.rooms.forEach((room) => {
    turnPlace(room);
    room.polygon = room.polygon.map(shownFromSite);
    room.holes = room.holes.map((ring) => ring.map(shownFromSite));
  });
  data.breaks.forEach((aBreak) => {
    turnPlace(aBreak);
    [aBreak.pose_drawn, aBreak.pose_untorn] = [turnPose(aBreak.pose_drawn), turnPose(aBreak.pose_untorn)];
  });
  const placeOf = new Map(data.runs.map((run, i) => [run.name, i]));  // in data.runs
  const all = (selector, root) => Array.from((root || document).querySelectorAll(selector));
  const one = (selector) => document.querySelector(selector);

  function element(tag, attributes, text) {
    const made = document.createElement(tag);
    Object.entries(attributes || {}).forEach(([key, value]) => made.setAttribute(key, value));
    if (text !== undefined) made.textContent = text;
    return made;
  }

  /** An element of a picture. */
  function drawing(tag, attributes, text) {
    const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
    Object.entries(attributes || {}).forEach(([key, value]) => made.setAttribute(key, value));
    if (text !== undefined) made.textContent = text;
    return made;
  }

  let changed = () => {};  // called when what is shown has changed

  function fixed(value, digits) {
    return value === null || value === undefined ? "–" : value.toFixed(digits);
  }

  function metres(value) { return value === null ? "–" : fixed(value, 2) + " m"; }

  function shortened(name, most) {
    return name.length <= most ? name : name.slice(0, most - 1) + "…";
  }

  // ---- The ranking: a dot and its interval for each run, score and map error side by side.

  function drawPanel(svg, panel, runs, rowHeight) {
    const x = d3.scale.linear().domain(panel.domain).range([panel.left, panel.left + panel.width]);
    const bottom = panel.top + runs.length * rowHeight;
    svg.append("text").attr("class", "head").attr("x", panel.left).attr("y", panel.top - 26)
      .text(panel.title);
    svg.append("text").attr("class", "note").attr("x", panel.left).attr("y", panel.top - 10)
      .text(panel.note);
    x.ticks(Math.max(2, Math.min(6, Math.floor(panel.width / 60)))).forEach((tick) => {
      svg.append("line").attr("class", "grid").attr("x1", x(tick)).attr("x2", x(tick))
        .attr("y1", panel.top).attr("y2", bottom);
      svg.append("text").attr("class", "tick").attr("x", x(tick)).attr("y", bottom + 16)
        .attr("text-anchor", "middle").text(tick);
    });
    runs.forEach((run, i) => {
      const [low, value, high] = panel.figures(run);
      if (value === null) return;
      const y = panel.top + (i + 0.5) * rowHeight;
      const row = svg.append("g").attr("class", "figure");
      row.append("title").text(run.name + ": " + fixed(value, panel.digits) + " (" +
        fixed(low, panel.digits) + " to " + fixed(high, panel.digits) + ")");
      row.append("line").attr("x1", x(low)).attr("x2", x(high)).attr("y1", y).attr("y2", y)
        .attr("stroke", run.colour).attr("stroke-width", 3).attr("stroke-opacity", 0.55)
        .attr("stroke-dasharray", run.meaningful ? null : "3,3");
      [low, high].forEach((end) => row.append("line").attr("x1", x(end)).attr("x2", x(end))
        .attr("y1", y - 5).attr("y2", y + 5).attr("stroke", run.colour).attr("stroke-width", 1.5));
      row.append("path").attr("d", run.shape).attr("transform", "translate(" + x(value) + "," + y + ")")
        .attr("class", run.meaningful ? "full" : "hollow")
        .attr(run.meaningful ? "fill" : "stroke", run.colour)
        .attr("stroke-width", run.meaningful ? 1 : 1.8);
    });
  }

  function drawNames(svg, runs, left, top, rowHeight, width) {
    runs.forEach((run, i) => {
      const y = top + (i + 0.5) * rowHeight;
      const row = svg.append("g").attr("class", "row");
      row.append("rect").attr("class", "band").attr("x", 0).attr("y", y - rowHeight / 2)
        .attr("width", width).attr("height", rowHeight);
      row.append("path").attr("d", run.shape).attr("fill", run.colour)
        .attr("transform", "translate(8," + y + ")");
      row.append("text").attr("x", 22).attr("y", y + 4)
        .text(shortened(run.name, Math.max(6, Math.floor((left - 34) / 7.4))))
        .append("title").text(run.name);
    });
  }

  const scoreOf = (run) => [run.score_low, run.score, run.score_high];
  const errorOf = (run) => [run.map_error_low, run.map_error_m, run.map_error_high];

  /** As wide as the page, or as asked. */
  function drawRanking(asked) {
    const runs = data.runs.filter((run) => run.score !== null);
    const host = one("#plot");
    host.textContent = "";
    if (!runs.length) return;
    const width = asked || Math.max(300, host.clientWidth), isNarrow = width < 640;
    const rowHeight = runs.length > 40 ? 18 : 26, top = 46, gap = 44;
    const longest = Math.max(...runs.map((run) => run.name.length));
    const left = Math.min(isNarrow ? 110 : 230, 36 + 7.4 * longest);
    const panelWidth = isNarrow ? width - left - 16 : (width - left - gap - 20) / 2;
    const block = top + runs.length * rowHeight + 26;
    const most = Math.max(0.1, ...runs.map((run) => run.map_error_high || 0));
    const svg = d3.select(host).append("svg")
      .attr("viewBox", "0 0 " + width + " " + (isNarrow ? 2 * block + 10 : block))
      .attr("width", width).attr("role", "img")
      .attr("aria-label", "Score and map error of each run with intervals; the table below has the numbers.");
    drawNames(svg, runs, left, top, rowHeight, width);
    if (isNarrow) drawNames(svg, runs, left, block + 10 + top, rowHeight, width);
    drawPanel(svg, {figures: scoreOf, title: "Score", note: "100 is best", digits: 1, domain: [0, 100],
      left: left, top: top, width: panelWidth}, runs, rowHeight);
    drawPanel(svg, {figures: errorOf, title: "Map error [m]", note: "0 is best", digits: 2,
      domain: [0, 1.02 * most], left: isNarrow ? left : left + panelWidth + gap,
      top: isNarrow ? block + 10 + top : top, width: panelWidth}, runs, rowHeight);
  }

  /** Along its path, in metres from its first key frame: [driven, error] of each key frame. */
  function drivenErrors(run) {
    let driven = 0;
    return run.path.map((at, k) => {
      const last = run.path[Math.max(0, k - 1)];
      driven += Math.hypot(at.x - last.x, at.y - last.y);
      return [driven, at.error_m];
    });
  }

  function drawAxes(svg, x, y, left, right, top, bottom) {
    y.ticks(5).forEach((tick) => {
      svg.append("line").attr("class", "grid").attr("x1", left).attr("x2", right)
        .attr("y1", y(tick)).attr("y2", y(tick));
      svg.append("text").attr("class", "tick").attr("x", left - 6).attr("y", y(tick) + 4)
        .attr("text-anchor", "end").text(tick);
    });
    x.ticks(Math.max(2, Math.min(8, Math.floor((right - left) / 80)))).forEach((tick) =>
      svg.append("text").attr("class", "tick").attr("x", x(tick)).attr("y", bottom + 16)
        .attr("text-anchor", "middle").text(tick));
    svg.append("text").attr("class", "head").attr("x", left).attr("y", top - 12)
      .text("Error [m] along the drive [m]");
  }

  /** As wide as the page, or as asked. Small errors have more room than large ones. */
  function drawAlong(asked) {
    const host = one("#along"), runs = data.runs.filter((run) => run.path.length > 1);
    host.textContent = "";
    one("#along-hint").hidden = !runs.length;
    if (!runs.length) return;
    const width = asked || Math.max(300, host.clientWidth), height = asked ? 150 : 210;
    const left = 44, right = width - 12, top = 34, bottom = height - 24;
    const lines = runs.map(drivenErrors);
    const x = d3.scale.linear().range([left, right])
      .domain([0, Math.max(...lines.map((line) => line[line.length - 1][0]))]);
    const most = Math.max(0.1, ...lines.flat().map((at) => at[1] || 0));
    const y = d3.scale.sqrt().domain([0, most]).range([bottom, top]);
    const svg = d3.select(host).append("svg").attr("viewBox", "0 0 " + width + " " + height)
      .attr("width", width).attr("role", "img")
      .attr("aria-label", "The error of each run along its drive; comparison.json has the numbers.");
    drawAxes(svg, x, y, left, right, top, bottom);
    const draw = d3.svg.line().x((at) => x(at[0])).y((at) => y(at[1])).defined((at) => at[1] !== null);
    runs.map((run, i) => i).reverse().forEach((i) => {
      const group = svg.append("g").attr("class", "along");
      group.append("title").text(runs[i].name);
      group.append("path").attr("d", draw(lines[i])).attr("fill", "none").attr("stroke", runs[i].colour)
        .attr("stroke-width", 1.6);
      data.breaks.filter((tear) => tear.run === runs[i].name && tear.key_frame !== null).forEach((tear) => {
        const k = runs[i].path.findIndex((at) => at.key_frame >= tear.key_frame);
        if (k >= 0) group.append("path").attr("d", runs[i].shape).attr("fill", runs[i].colour)
          .attr("transform", "translate(" + x(lines[i][k][0]) + "," + y(lines[i][k][1] || 0) + ")");
      });
    });
  }

  // ---- The map. Leaflet's lat and lng are y and x [m].

  const latLng = (point) => [point[1], point[0]];
  const bounds = (box) => L.latLngBounds(latLng(box[0]), latLng(box[1]));
  const map = L.map("map", {
    crs: L.CRS.Simple, attributionControl: false, zoomSnap: 0.25, zoomDelta: 0.5, minZoom: -6,
    maxZoom: 9, wheelPxPerZoomLevel: 90, scrollWheelZoom: false, zoomAnimation: false, fadeAnimation: false,
    markerZoomAnimation: false,
  });
  let isWhole = true;  // the whole site is shown, and nobody has moved the picture
  map.on("dragstart zoomstart", () => { isWhole = false; });
  // The wheel scrolls the page until the map was clicked, and again when the mouse has left it.
  map.on("mousedown focus", () => map.scrollWheelZoom.enable());
  map.getContainer().addEventListener("mouseleave", () => map.scrollWheelZoom.disable());

  /** The map ends with the first screen, as long as that leaves it any height. */
  function fitFirstScreen() {
    const top = one(".workbench").getBoundingClientRect().top + window.scrollY;
    document.documentElement.style.setProperty("--above-map", Math.ceil(top) + "px");
    map.invalidateSize({animate: false});
  }

  function home() {
    map.fitBounds(bounds(drawn.box), {animate: false, padding: [8, 8]});
    isWhole = true;
  }

  map.createPane("heat").style.zIndex = 320;
  map.createPane("runs").style.zIndex = 300;
  map.createPane("rooms").style.zIndex = 410;
  map.createPane("paths").style.zIndex = 415;
  map.createPane("poses").style.zIndex = 416;
  map.createPane("labels").style.zIndex = 610;  // above the marks of breaks
  map.getPane("labels").style.pointerEvents = "none";

  const layers = {};  // by name, as in data-layer

  function pictureLayer(picture, pane, description, options) {
    return L.imageOverlay(picture.url, bounds(picture.box),
      Object.assign({pane: pane, alt: description}, options));
  }

  data.runs.forEach((run, i) => {
    layers["run-" + i] = run.picture
      ? pictureLayer(run.picture, "runs", "Walls of " + run.name, {zIndex: data.runs.length - i}) : L.layerGroup();
  });
  layers.heat = drawn.heat
    ? pictureLayer(drawn.heat, "heat", "Where the runs disagree", {className: "crisp"}) : L.layerGroup();

  const plainRoom = {color: "#33415c", weight: 1.2, opacity: 0.75, fillColor: "#33415c",
    fillOpacity: 0.02, dashArray: null};
  const plainCorridor = Object.assign({}, plainRoom, {dashArray: "2,4"});
  const chosenRoom = {color: "#17202e", weight: 4, opacity: 1, fillColor: "#ffd84d",
    fillOpacity: 0.45, dashArray: null};

  const styleOf = (room) => (room.kind === "corridor" ? plainCorridor : plainRoom);
  const roomName = (room) => (room.name && room.name !== room.id ? room.id + " " + room.name : room.id);

  const ringsOf = (room) => (room.polygon.length ? [room.polygon] : []).concat(room.holes);

  /** Where a horizontal line enters and leaves a room, in pairs. */
  function crossings(rings, y) {
    const found = [];
    rings.forEach((ring) => ring.forEach((a, i) => {
      const b = ring[(i + 1) % ring.length];
      if ((a[1] > y) !== (b[1] > y)) found.push(a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]));
    }));
    return found.sort((a, b) => a - b);
  }

  /** The middle of a room where that lies in it; else, as in a corridor round a yard, the middle of
   *  the widest of some lines through it. */
  function labelPlace(room) {
    const rings = ringsOf(room);
    const before = crossings(rings, room.y).filter((x) => x < room.x).length;
    if (!rings.length || before % 2 === 1) return [room.x, room.y];
    const ys = rings[0].map((point) => point[1]), low = Math.min(...ys), high = Math.max(...ys);
    let best = [room.x, room.y], width = 0;
    for (let k = 0.5; k < 20; ++k) {
      const y = low + (high - low) * k / 20, found = crossings(rings, y);
      for (let i = 0; i + 1 < found.length; i += 2) {
        if (found[i + 1] - found[i] <= width) continue;
        width = found[i + 1] - found[i];
        best = [(found[i] + found[i + 1]) / 2, y];
      }
    }
    return best;
  }

  function makeRoom(room, i) {
    const options = Object.assign({pane: "rooms", className: "room-shape"}, styleOf(room));
    const rings = ringsOf(room);
    const shape = rings.length
      ? L.polygon(rings.map((ring) => ring.map(latLng)), options)
      : L.circleMarker([room.y, room.x], Object.assign({radius: 8}, options));
    shape.on("add", () => {
      const path = shape.getElement();
      path.setAttribute("data-room", i);
      path.setAttribute("role", "img");
      path.setAttribute("aria-label", roomName(room));
      path.classList.toggle("chosen", chosen === i);
    });
    shape.on("click", () => choose(i, "map"));
    const label = L.tooltip({permanent: true, direction: "center", className: "room-label",
      interactive: false, opacity: 1,
      pane: "labels"}).setLatLng(latLng(labelPlace(room)));
    label.setContent(element("span", {}, shortened(room.name || room.id, 16)));
    label.on("add", () => label.getElement().classList.toggle("chosen", chosen === i));
    return {shape: shape, label: label};
  }

  let chosen = null;
  const rooms = data.rooms.map(makeRoom);

  /** Hides names of rooms that lie over those of others, until the map is so large that they do not. */
  function keepNamesApart() {
    const shown = [];
    rooms.map((room) => room.label.getElement()).filter((name) => name).forEach((name) => {
      const box = name.getBoundingClientRect();
      const isHidden = shown.some((other) => box.left < other.right && other.left < box.right &&
        box.top < other.bottom && other.top < box.bottom);
      name.classList.toggle("covered", isHidden);
      if (!isHidden) shown.push(box);
    });
  }
  layers.rooms = L.layerGroup(rooms.map((room) => room.shape).concat(rooms.map((room) => room.label)));
  layers.rooms.on("add", keepNamesApart);

  const untold = "#4a5a78", beforeColour = "#00529b", drawnColour = "#d55e00", untornColour = "#00825a";

  /** A small picture of what the scans at a break met; null where they are not known. */
  function breakPicture(i, width, height) {
    const aBreak = data.breaks[i], scans = drawn.breaks[i];
    const pairs = (numbers) => numbers.filter((_, k) => k % 2 === 0)
      .map((x, k) => shownFromSite([x, numbers[2 * k + 1]]));
    const before = pairs(scans.before), behind = pairs(scans.behind);
    if (!behind.length || !aBreak.pose_drawn) return null;
    const untorn = behind.map(mended(aBreak));
    const around = before.concat(behind, untorn);
    const [low, high] = [Math.min, Math.max].map((most) => [0, 1].map((axis) =>
      around.reduce((value, point) => most(value, point[axis]), around[0][axis])));
    const scale = Math.min((width - 8) / Math.max(0.1, high[0] - low[0]), (height - 8) / Math.max(0.1, high[1] - low[1]));
    const at = ([x, y]) => (width / 2 + scale * (x - (low[0] + high[0]) / 2)).toFixed(1) + "," +
      (height / 2 - scale * (y - (low[1] + high[1]) / 2)).toFixed(1);
    const svg = drawing("svg", {viewBox: "0 0 " + width + " " + height, width: width, height: height,
      class: "scans-picture", role: "img", "aria-label": "The scans at the break: before it in blue, behind it " +
      "in orange as the run has them, in green as they would lie without the break"});
    [[before, beforeColour], [behind, drawnColour], [untorn, untornColour]].forEach(([points, colour]) =>
      svg.append(drawing("path", {d: points.map((point) => "M" + at(point) + "h0").join(""), stroke: colour,
        "stroke-width": width > 150 ? 2.4 : 1.8, "stroke-linecap": "round", fill: "none"})));
    return svg;
  }

  /** Of the mark of a break [px]: the larger, the further it moves what lies ten metres behind it. */
  function breakSide(aBreak) {
    const moved = Math.abs(aBreak.shift_m) + 10 * Math.abs(aBreak.rotation_deg) * Math.PI / 180;
    return Math.round(Math.min(30, Math.max(13, 12 + 6 * moved)));
  }

  function makeBreak(aBreak, i) {
    const run = data.runs[placeOf.get(aBreak.run)] || {name: "", colour: "#000"};
    const icon = element("span"), side = breakSide(aBreak);
    icon.innerHTML = '<svg viewBox="-12 -12 24 24" width="' + side + '" height="' + side + '" aria-hidden="true">' +
      '<path d="M0,-10.5L11,9H-11Z" stroke="#fff" stroke-width="2" stroke-linejoin="round"/>' +
      '<path d="M-3.5,7L1.5,1L-2,-0.5L2,-6" fill="none" stroke="#fff" stroke-width="1.8"/></svg>';
    icon.querySelector("path").setAttribute("fill", run.colour);
    const marker = L.marker([aBreak.y, aBreak.x], {keyboard: false, alt: "Break of " + run.name,
      icon: L.divIcon({className: "break-mark", html: icon, iconSize: [side, side]})});
    marker.on("click", () => markBreak(i, true));
    return marker;
  }

  /** What is said of a break, in a corner of the map, where it hides nothing of it. */
  const card = L.control({position: "topright"});
  const cardBox = element("div", {class: "break-card"});
  card.onAdd = () => cardBox;
  L.DomEvent.disableClickPropagation(cardBox);

  function showCard(i) {
    const aBreak = data.breaks[i];
    const close = element("button", {type: "button", "aria-label": "Show no break", title: "Close"}, "×");
    close.addEventListener("click", leaveBreak);
    cardBox.replaceChildren(close, element("b", {}, aBreak.run), element("br"),
      "turns by " + fixed(aBreak.rotation_deg, 1) + "° and shifts by " + fixed(aBreak.shift_m, 2) + " m here" +
      (aBreak.key_frame === null ? "" : ", from key frame " + aBreak.key_frame + " on"));
    const picture = breakPicture(i, 220, 150);
    if (picture) cardBox.append(picture);
    card.addTo(map);
  }

  const breaks = data.breaks.map(makeBreak);

  /** A ring where a run has too many walls that no other one has; null where it has not. */
  const rings = data.runs.map((run) => run.added && L.circleMarker(latLng(shownFromSite(run.added)),
    {pane: "poses", radius: 26, color: run.colour, weight: 3, dashArray: "7,5", fillOpacity: 0})
    .bindTooltip(element("span", {}, "Walls of " + run.name + " that no other run has")));
  layers.breaks = L.layerGroup();
  layers.paths = L.layerGroup();

  // ---- Paths: the colour of a piece says how wrong what was drawn from there is.

  const errorColours = [[0.1, "#1a9850"], [0.25, "#a6b818"], [0.5, "#f08c1d"], [Infinity, "#d7191c"]];

  function colourOfError(error) {
    return error === null ? untold : errorColours.find((entry) => error <= entry[0])[1];
  }

  /** Neighbouring pieces of one colour are one line. */
  function makePath(run) {
    const lines = [];
    run.path.forEach((at, k) => {
      if (k === 0) return;
      const colour = colourOfError(at.error_m), last = lines[lines.length - 1];
      if (last && last.colour === colour) last.points.push([at.y, at.x]);
      else lines.push({colour: colour, points: [[run.path[k - 1].y, run.path[k - 1].x], [at.y, at.x]]});
    });
    return L.layerGroup(lines.map((line) => L.polyline(line.points,
      {pane: "paths", color: line.colour, weight: 2.5, opacity: pathOpacity, interactive: false})));
  }

  // Of several runs the paths are light, so that those of one run can be told by pointing at it.
  const pathOpacity = data.runs.length > 2 ? 0.45 : 0.9;
  const paths = data.runs.map(makePath);

  function legendOfPaths() {
    const host = one("#path-legend");
    errorColours.forEach((entry, k) => {
      const part = element("span"), swatch = element("i");
      swatch.style.background = entry[1];
      part.append(swatch, k + 1 < errorColours.length ? "to " + entry[0] + " m" : "more");
      host.append(part);
    });
  }

  /** Where a place behind a break would lie without it. */
  function mended(aBreak) {
    const [x0, y0, phi0] = aBreak.pose_drawn, [x1, y1, phi1] = aBreak.pose_untorn;
    const turn = phi1 - phi0, c = Math.cos(turn), s = Math.sin(turn);
    return ([x, y]) => [x1 + c * (x - x0) - s * (y - y0), y1 + s * (x - x0) + c * (y - y0)];
  }

  /** The next key frames in both poses of a break, and the way from the one to the other. */
  function bothPoses(aBreak) {
    const run = data.runs[placeOf.get(aBreak.run)];
    if (!run || aBreak.key_frame === null || !aBreak.pose_drawn) return L.layerGroup();
    const found = run.path.findIndex((at) => at.key_frame >= aBreak.key_frame);
    const first = found < 0 ? run.path.length : found;
    const places = (from, to) => run.path.slice(from, to).map((at) => [at.x, at.y]);
    const behind = places(first, first + 11);
    const before = places(Math.max(0, first - 10), first);
    const untorn = behind.map(mended(aBreak));
    const line = (points, colour, more) => L.polyline(points.map(latLng),
      Object.assign({pane: "poses", color: colour, weight: 5, opacity: 0.95, interactive: false}, more));
    const dots = (points, colour) => points.map((point) => L.circleMarker(latLng(point),
      {pane: "poses", radius: 4, color: "#fff", weight: 1, fillColor: colour, fillOpacity: 1, interactive: false}));
    return L.layerGroup([line(before, beforeColour), line(behind, drawnColour), line(untorn, untornColour)]
      .concat(dots(before, beforeColour), dots(behind, drawnColour), dots(untorn, untornColour),
        behind.map((point, k) => line([point, untorn[k]], "#17202e", {weight: 1, dashArray: "2,3"}))));
  }

  let chosenBreak = null, posesOfBreak = null;

  /** Ends what markBreak has begun. */
  function leaveBreak() {
    if (chosenBreak !== null) setBreak(chosenBreak, false);
    if (posesOfBreak) posesOfBreak.remove();
    card.remove();
    chosenBreak = posesOfBreak = null;
    map.getPane("paths").style.opacity = 1;
    changed();
  }

  /** Highlights a break in both places; shows its poses, and the paths faintly. */
  function markBreak(i, goesToRow) {
    leaveBreak();
    chosenBreak = i;
    map.getPane("paths").style.opacity = 0.2;
    setBreak(i, true);
    showCard(i);
    posesOfBreak = bothPoses(data.breaks[i]).addTo(map);
    if (goesToRow) one("#break-" + i).scrollIntoView({block: "nearest"});
    one("#said").textContent = "Break " + (i + 1) + " of " + data.breaks.length + " is chosen.";
    changed();
  }

  function setBreak(i, isChosen) {
    const row = one("#break-" + i);
    row.classList.toggle("chosen", isChosen);
    if (isChosen) row.setAttribute("aria-current", "true"); else row.removeAttribute("aria-current");
    const made = breaks[i].getElement();
    if (made) made.classList.toggle("chosen", isChosen);
  }

  /** Marks and paths are those of the runs that are shown. */
  function showOfRuns() {
    layers.breaks.clearLayers();
    layers.paths.clearLayers();
    const isOn = (run) => !boxOf("run-" + run) || boxOf("run-" + run).checked;
    data.breaks.forEach((aBreak, i) => { if (isOn(placeOf.get(aBreak.run))) layers.breaks.addLayer(breaks[i]); });
    rings.forEach((ring, i) => { if (ring && isOn(i)) layers.breaks.addLayer(ring); });
    paths.forEach((path, i) => { if (isOn(i)) layers.paths.addLayer(path); });
  }

  // ---- Layer switches.

  const boxOf = (name) => one('input[data-layer="' + name + '"]');

  function show(name, isOn) {
    const box = boxOf(name);
    if (box) {
      box.checked = isOn;
      box.closest("label").classList.toggle("off", !isOn);
    }
    if (isOn) layers[name].addTo(map); else layers[name].remove();
    if (name.startsWith("run-") && !isShowingMany) showOfRuns();
    changed();
  }

  let isShowingMany = false;  // marks and paths follow when all runs are there

  function many(showAll) {
    isShowingMany = true;
    showAll();
    isShowingMany = false;
    showOfRuns();
  }

  function showRuns(isOn) { many(() => data.runs.forEach((run, i) => show("run-" + i, isOn(i)))); }

  const shows = {
    all: () => { showRuns(() => true); show("heat", false); },
    best: () => { showRuns((i) => i === 0); show("heat", false); },
    heat: () => { showRuns((i) => i === 0); show("heat", true); },
    fit: home,
  };

  /** Only this run, as long as it is pointed at; null ends that. */
  function spotlight(run) {
    data.runs.forEach((other, i) => {
      const layer = layers["run-" + i];
      if (layer.setOpacity) layer.setOpacity(run === null || i === run ? 1 : 0.08);
      paths[i].eachLayer((line) => line.setStyle({opacity: run === null ? pathOpacity : i === run ? 1 : 0}));
    });
  }

  function wireLayers() {
    many(() => all("input[data-layer]").forEach((box) => {
      const name = box.dataset.layer;
      box.addEventListener("change", () => show(name, box.checked));
      show(name, box.checked);
    }));
    all("button[data-show]").forEach((button) =>
      button.addEventListener("click", () => {
        leaveBreak();
        endPair();
        shows[button.dataset.show]();
      }));
    all("label[data-run]").forEach((label) => {
      const run = Number(label.dataset.run);
      const isOn = () => boxOf("run-" + run).checked;
      label.addEventListener("mouseenter", () => spotlight(isOn() ? run : null));
      label.addEventListener("mouseleave", () => spotlight(null));
      label.addEventListener("change", () => spotlight(null));
    });
  }

  // ---- Rooms: map and ledger.

  const sightings = {seen: "seen", gone: "not found", unvisited: "has not looked"};

  function doorsText(room) {
    const parts = [];
    if (room.doors_gained) parts.push("+" + room.doors_gained);
    if (room.doors_lost) parts.push("−" + room.doors_lost);
    return parts.join(" ") || (room.sighting === "seen" ? "same" : "–");
  }

  function signedPercent(value) {
    if (value === null) return "–";
    const percent = Math.round(100 * value);
    return (percent > 0 ? "+" : percent < 0 ? "−" : "") + Math.abs(percent) + " %";
  }

  function stateText(room) {
    const parts = [sightings[room.sighting]];
    if (room.pieces > 1) parts.push("in " + room.pieces + " pieces");
    if (room.sighting === "seen" && room.pieces === 0) parts.push("but as no area of its own");
    if (room.merged) parts.push("merged with another");
    return parts.join(", ");
  }

  function detailsRow(room) {
    const row = element("tr", {class: "details"}), cell = element("td", {colspan: "4"});
    const table = element("table"), head = element("tr"), body = element("tbody");
    const titles = ["Run", "State", "Shift", "Area", "Outline", "Doors"];
    if (room.kind === "corridor") titles.push("Length");
    titles.forEach((title, i) => head.append(element("th", {scope: "col", class: i > 1 ? "n" : ""}, title)));
    room.runs.forEach((said) => {
      const line = element("tr");
      line.append(element("th", {scope: "row"}, said.run), element("td", {}, stateText(said)));
      const outline = said.boundary_agreement === null ? "–"
        : Math.round(100 * said.boundary_agreement) + " %";
      const figures = [metres(said.shift_m), signedPercent(said.area_change), outline, doorsText(said)];
      if (room.kind === "corridor") figures.push(metres(said.length_error_m));
      figures.forEach((figure) => line.append(element("td", {class: "n"}, figure)));
      body.append(line);
    });
    const thead = element("thead");
    thead.append(head);
    table.append(thead, body);
    cell.append(table);
    row.append(cell);
    return row;
  }

  function mark(i, isChosen) {
    const row = one("#room-" + i), room = data.rooms[i];
    row.classList.toggle("chosen", isChosen);
    if (isChosen) row.setAttribute("aria-current", "true"); else row.removeAttribute("aria-current");
    rooms[i].shape.setStyle(isChosen ? chosenRoom : styleOf(room));
    [rooms[i].shape, rooms[i].label].forEach((layer) => {
      const made = layer.getElement && layer.getElement();
      if (made) made.classList.toggle("chosen", isChosen);
    });
  }

  /** Highlights a room in both places; `from` is where the user is already looking. */
  function choose(i, from) {
    all("tr.details").forEach((row) => row.remove());
    if (chosen !== null) mark(chosen, false);
    const again = chosen === i && from === "row";
    chosen = again ? null : i;
    changed();
    if (again) return;
    show("rooms", true);
    mark(i, true);
    const room = data.rooms[i], row = one("#room-" + i);
    if (room.runs.length) row.after(detailsRow(room));
    if (from === "row") {
      isWhole = false;
      const shape = rooms[i].shape;
      const box = shape.getBounds ? shape.getBounds() : L.latLngBounds([shape.getLatLng()]);
      map.fitBounds(box.pad(1.2), {animate: false, maxZoom: Math.max(map.getZoom(), 4.5)});
    } else {
      row.scrollIntoView({block: "center"});
      row.focus({preventScroll: true});
    }
    const seen = room.runs.filter((said) => said.sighting === "seen").length;
    one("#said").textContent = roomName(room) + " is chosen, seen in " + seen + " of " +
      room.runs.length + " runs.";
  }

  function chooseBreak(i) {
    const aBreak = data.breaks[i], layer = "run-" + placeOf.get(aBreak.run);
    show("breaks", true);
    if (boxOf(layer)) show(layer, true);
    isWhole = false;
    const near = Math.max(map.getZoom(), 4.5);
    map.setView([aBreak.y, aBreak.x], near, {animate: false});
    markBreak(i, false);
    const around = L.latLngBounds([[aBreak.y, aBreak.x]]);
    posesOfBreak.eachLayer((line) => { if (line.getBounds) around.extend(line.getBounds()); });
    if (!map.getBounds().contains(around)) map.fitBounds(around.pad(0.1), {animate: false, maxZoom: near});
    one("#map").scrollIntoView({block: "center"});
  }

  /** A click, Enter or the space bar on a row. */
  function wireRows(selector, use) {
    all(selector).forEach((row) => {
      row.addEventListener("click", () => use(row));
      row.addEventListener("keydown", (event) => {
        if (event.target !== row || (event.key !== "Enter" && event.key !== " ")) return;
        event.preventDefault();
        use(row);
      });
    });
  }

  // ---- Tables that sort.

  function sortBy(table, column, header) {
    const isDown = header.getAttribute("aria-sort") === "ascending";
    all("th[aria-sort]", table).forEach((other) => other.removeAttribute("aria-sort"));
    header.setAttribute("aria-sort", isDown ? "descending" : "ascending");
    const isNumber = header.matches(".n, .by-number");
    const value = (row) => {
      const text = row.cells[column].textContent.trim(), number = parseFloat(text);
      return !isNumber ? text : isNaN(number) ? Infinity : number;
    };
    const compare = (a, b) => (!isNumber ? a.localeCompare(b, "en", {numeric: true})
      : a < b ? -1 : a > b ? 1 : 0);
    all("tr.details", table).forEach((row) => row.remove());
    const body = table.tBodies[0];
    const rows = all("tr", body).map((row) => ({row: row, value: value(row)}));
    rows.sort((a, b) => (isDown ? -1 : 1) * compare(a.value, b.value));
    body.append(...rows.map((entry) => entry.row));
  }

  function wireFilter() {
    const box = one("#only-different"), table = one("#rooms");
    if (!box) return;
    const apply = () => {
      table.classList.toggle("only-different", box.checked);
      one("#nothing-differs").hidden = !box.checked || all("tr.room:not(.same)", table).length > 0;
    };
    box.addEventListener("change", apply);
    apply();
  }

  function wireSorting() {
    all("table.sortable").forEach((table) => all("thead th", table).forEach((header, column) => {
      const button = element("button", {type: "button", title: "Sort"}, header.textContent);
      header.textContent = "";
      header.append(button);
      button.addEventListener("click", () => sortBy(table, column, header));
    }));
  }

  // ---- Print: the map gets the size of the paper, and what is folded is opened.

  function wirePrint() {
    let closed = [], view = null;
    window.addEventListener("beforeprint", () => {
      view = {center: map.getCenter(), zoom: map.getZoom(), isWhole: isWhole};
      closed = all("main details:not([open])");
      closed.forEach((details) => { if (details.closest("#ranking")) details.open = true; });
      const size = map.getSize(), around = map.getBounds();
      Object.assign(one("#map").style, {width: "690px", height: Math.round(690 * Math.min(1, size.y / size.x)) + "px"});
      map.invalidateSize({animate: false});
      map.options.zoomSnap = 0;  // as large as fits
      if (view.isWhole) home(); else map.fitBounds(around, {animate: false});
      drawRanking(690);
      drawAlong(690);
    });
    window.addEventListener("afterprint", () => {
      closed.forEach((details) => { details.open = false; });
      Object.assign(one("#map").style, {width: "", height: ""});
      map.invalidateSize({animate: false});
      map.options.zoomSnap = 0.25;
      if (view && view.isWhole) home(); else if (view) map.setView(view.center, view.zoom, {animate: false});
      drawRanking();
      drawAlong();
    });
  }

  function addControls() {
    L.control.scale({imperial: false, maxWidth: 140}).addTo(map);
    const place = L.control({position: "bottomright"});
    const text = element("span", {class: "place", "aria-hidden": "true"});
    place.onAdd = () => text;
    place.addTo(map);
    map.on("mousemove", (event) => {
      const [x, y] = siteFromShown([event.latlng.lng, event.latlng.lat]);
      text.textContent = "x " + x.toFixed(1) + "  y " + y.toFixed(1) + " m";
    });
    map.on("mouseout", () => { text.textContent = ""; });
    map.on("zoomend", () => {
      map.getContainer().classList.toggle("far-out", map.getZoom() < 2.5);
      keepNamesApart();
    });
  }

  addControls();
  if (!drawn.hasMaps) one("#walls").textContent = "The maps were not at hand when this page was made: their walls are not drawn.";
  if (drawn.turn) one("#turned").textContent = "Turned by " + fixed(drawn.turn * 180 / Math.PI, 0) +
    "° to stand upright; places are given in the frame of the site.";
  fitFirstScreen();
  home();
  legendOfPaths();
  wireLayers();
  wireFilter();
  wireRows("tr.room", (row) => choose(Number(row.dataset.room), "row"));
  wireRows("tr.break", (row) => chooseBreak(Number(row.dataset.break)));
  wireSorting();
  wirePrint();
  drawRanking();
  drawAlong();
  let pending = 0;
  window.addEventListener("resize", () => {
    clearTimeout(pending);
    pending = setTimeout(() => {
      drawRanking();
      drawAlong();
      fitFirstScreen();
      if (isWhole) home();
    }, 100);
  });
