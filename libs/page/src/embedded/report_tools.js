  // Behind report.js, in the same function: two runs against each other, what can be saved, and the
  // address of what is shown.

  // ---- Two runs: one on each side of a line, or side by side.

  let pair = null;  // {kind, left, right, share}

  const imageOf = (run) => layers["run-" + run].getElement && layers["run-" + run].getElement();

  /** The left run up to the line, the right one from there on. */
  function clipPair() {
    data.runs.forEach((run, i) => { if (imageOf(i)) imageOf(i).style.clipPath = ""; });
    if (!pair || pair.kind !== "swipe") return;
    const line = pair.share * map.getSize().x;
    [[pair.left, true], [pair.right, false]].forEach(([run, isLeft]) => {
      const image = imageOf(run);
      if (!image) return;
      const start = map.layerPointToContainerPoint(L.DomUtil.getPosition(image)).x;
      const cut = isLeft ? start + image.offsetWidth - line : line - start;
      image.style.clipPath = isLeft ? "inset(0 " + Math.max(0, cut) + "px 0 0)"
        : "inset(0 0 0 " + Math.max(0, cut) + "px)";
    });
    divider.style.left = line + "px";
    divider.setAttribute("aria-valuenow", Math.round(100 * pair.share));
  }

  const divider = element("div", {id: "divider", role: "slider", tabindex: "0", hidden: "",
    "aria-label": "Line between the two runs", "aria-valuemin": "0", "aria-valuemax": "100",
    "aria-valuenow": "50"});

  function moveDivider(share) {
    pair.share = Math.min(1, Math.max(0, share));
    clipPair();
    changed();
  }

  function wireDivider() {
    one("#map").append(divider);
    L.DomEvent.disableClickPropagation(divider);
    divider.addEventListener("pointerdown", (event) => divider.setPointerCapture(event.pointerId));
    divider.addEventListener("pointermove", (event) => {
      if (!divider.hasPointerCapture(event.pointerId)) return;
      const box = one("#map").getBoundingClientRect();
      moveDivider((event.clientX - box.left) / box.width);
    });
    divider.addEventListener("keydown", (event) => {
      const step = {ArrowLeft: -0.02, ArrowRight: 0.02}[event.key];
      if (!step) return;
      event.preventDefault();
      event.stopPropagation();
      moveDivider(pair.share + step);
    });
    map.on("move zoom zoomend viewreset resize", clipPair);
  }

  let beside = null;  // the second map

  function makeBeside() {
    if (beside) return;
    beside = L.map("map-beside", Object.assign({}, map.options, {zoomControl: false, layers: []}));
    L.DomUtil.addClass(beside.getContainer(), "beside");
    beside.createPane("runs").style.zIndex = 300;
    let isMoving = false;  // one map follows the other, which must not answer
    const follow = (from, to) => from.on("move", () => {
      if (isMoving || !pair || pair.kind !== "beside") return;
      isMoving = true;
      to.setView(from.getCenter(), from.getZoom(), {animate: false});
      isMoving = false;
    });
    beside.setView(map.getCenter(), map.getZoom(), {animate: false});
    follow(map, beside);
    follow(beside, map);
  }

  let besideLayers = null;

  function showBeside() {
    one(".maps").classList.add("two");
    one("#map-beside").hidden = false;
    makeBeside();
    if (besideLayers) besideLayers.remove();
    const run = data.runs[pair.right];
    besideLayers = L.layerGroup(run.picture
      ? [pictureLayer(run.picture, "runs", "Walls of " + run.name)] : []);
    data.rooms.forEach((room) => ringsOf(room).length && besideLayers.addLayer(
      L.polygon(ringsOf(room).map((ring) => ring.map(latLng)),
        Object.assign({interactive: false}, styleOf(room)))));
    besideLayers.addTo(beside);
    map.invalidateSize({animate: false});
    beside.invalidateSize({animate: false});
    if (isWhole) home();
    beside.setView(map.getCenter(), map.getZoom(), {animate: false});
  }

  function nameSides() {
    all(".side-name").forEach((name) => name.remove());
    if (!pair) return;
    const name = (run, side, host) => host.append(element("span", {class: "side-name " + side}, data.runs[run].name));
    name(pair.left, "left", one("#map"));
    name(pair.right, pair.kind === "swipe" ? "right" : "left", pair.kind === "swipe" ? one("#map") : one("#map-beside"));
  }

  function endPair() {
    if (!pair) return;
    pair = null;
    one(".maps").classList.remove("two");
    one("#map-beside").hidden = true;
    divider.hidden = true;
    ["#swipe", "#beside"].forEach((id) => one(id).setAttribute("aria-pressed", "false"));
    map.invalidateSize({animate: false});
    if (isWhole) home();
    clipPair();
    nameSides();
    changed();
  }

  function startPair(kind, left, right, share) {
    endPair();
    pair = {kind: kind, left: left, right: right, share: share === undefined ? 0.5 : share};
    one("#left-run").value = left;
    one("#right-run").value = right;
    one("#" + kind).setAttribute("aria-pressed", "true");
    showRuns((i) => i === left || (kind === "swipe" && i === right));
    divider.hidden = kind !== "swipe";
    if (kind === "beside") showBeside();
    clipPair();
    nameSides();
    one("#said").textContent = data.runs[left].name + " is on the left, " + data.runs[right].name + " on the right.";
    changed();
  }

  function wirePair() {
    if (!one("#swipe")) return;
    const chosenRun = (id) => Number(one(id).value);
    const torn = data.breaks.length ? placeOf.get(data.breaks[0].run) : 1;
    one("#right-run").value = torn > 0 ? torn : 1;
    ["swipe", "beside"].forEach((kind) => one("#" + kind).addEventListener("click", () => {
      if (pair && pair.kind === kind) endPair();
      else startPair(kind, chosenRun("#left-run"), chosenRun("#right-run"));
    }));
    ["#left-run", "#right-run"].forEach((id) => one(id).addEventListener("change", () => {
      if (pair) startPair(pair.kind, chosenRun("#left-run"), chosenRun("#right-run"), pair.share);
    }));
    wireDivider();
  }

  // ---- What can be saved: tables as CSV, figures as SVG and PNG.

  function save(name, content, type) {
    const url = URL.createObjectURL(new Blob([content], {type: type}));
    const link = element("a", {href: url, download: name});
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(url), 10000);
  }

  /** What a cell says, and what it says in small letters. */
  function cellTexts(cell) {
    const copy = cell.cloneNode(true), small = all("small", copy);
    const aside = small.map((part) => part.textContent.trim()).join(" ");
    small.forEach((part) => part.remove());
    all("svg, .strip", copy).forEach((part) => part.remove());
    return [copy.textContent.trim().replace(/\s+/g, " "), aside];
  }

  function csvOf(table) {
    const rows = all("tr", table).filter((row) => !row.closest("tr.details") && !row.matches(".details"));
    const cells = rows.map((row) => Array.from(row.cells).map(cellTexts));
    const hasAside = cells[0].map((_, column) => cells.some((row) => row[column] && row[column][1]));
    const quoted = (text) => (/[",\n]/.test(text) ? '"' + text.replace(/"/g, '""') + '"' : text);
    return cells.map((row, k) => row.map(([text, aside], column) => quoted(text) + (hasAside[column]
      ? "," + quoted(k === 0 ? text + " (more)" : aside) : "")).join(",") + "\n").join("");
  }

  function wireTables() {
    all("main table[id]").forEach((table) => {
      const button = element("button", {type: "button", class: "csv"}, "Save as CSV");
      button.addEventListener("click", () => save(table.id.replace("-table", "") + ".csv", csvOf(table), "text/csv"));
      (table.closest(".scroll") || table).after(button);
    });
  }

  /** The map as it is shown now, with the names of the runs in their colours. */
  function mapFigure() {
    const around = map.getBounds(), size = map.getSize();
    const scale = size.x / (around.getEast() - around.getWest());
    const x = (value) => (scale * (value - around.getWest())).toFixed(2);
    const y = (value) => (scale * (around.getNorth() - value)).toFixed(2);
    const isOn = (name) => boxOf(name) && boxOf(name).checked;
    const shown = data.runs.map((run, i) => i).filter((i) => isOn("run-" + i));
    const height = size.y + 18 * shown.length + 6;
    const svg = drawing("svg", {width: size.x, height: height,
      viewBox: "0 0 " + size.x + " " + height, "font-family": "sans-serif", "font-size": 13});
    const frame = drawing("svg", {width: size.x, height: size.y});
    svg.append(drawing("rect", {width: size.x, height: height, fill: "#fff"}), frame);
    const image = (picture) => picture && frame.append(drawing("image", {href: picture.url,
      x: x(picture.box[0][0]), y: y(picture.box[1][1]), preserveAspectRatio: "none",
      width: (scale * (picture.box[1][0] - picture.box[0][0])).toFixed(2),
      height: (scale * (picture.box[1][1] - picture.box[0][1])).toFixed(2)}));
    shown.slice().reverse().forEach((i) => image(data.runs[i].picture));
    if (isOn("heat")) image(drawn.heat);
    const points = (places) => places.map((at) => x(at[0]) + "," + y(at[1])).join(" ");
    if (isOn("rooms")) data.rooms.forEach((room, i) => {
      ringsOf(room).forEach((ring) => frame.append(drawing("polygon", {points: points(ring), fill: "none",
        stroke: styleOf(room).color, "stroke-dasharray": styleOf(room).dashArray || "none"})));
      const at = rooms[i].label.getLatLng();
      frame.append(drawing("text", {x: x(at.lng), y: y(at.lat), "text-anchor": "middle", fill: "#17202e"}, room.name || room.id));
    });
    if (isOn("paths")) shown.forEach((i) => data.runs[i].path.forEach((to, k, path) => k > 0 &&
      frame.append(drawing("polyline", {points: points([[path[k - 1].x, path[k - 1].y], [to.x, to.y]]),
        fill: "none", "stroke-width": 2, stroke: colourOfError(to.error_m)}))));
    if (isOn("breaks")) data.breaks.forEach((tear) => shown.includes(placeOf.get(tear.run)) &&
      frame.append(drawing("path", {d: "M0,-10.5L11,9H-11Z", fill: data.runs[placeOf.get(tear.run)].colour,
        stroke: "#fff", transform: "translate(" + x(tear.x) + "," + y(tear.y) + ")"})));
    shown.forEach((i, row) => svg.append(drawing("path", {d: data.runs[i].shape, fill: data.runs[i].colour,
      transform: "translate(14," + (size.y + 14 + 18 * row) + ")"}),
    drawing("text", {x: 28, y: size.y + 18 + 18 * row, fill: "#17202e"}, data.runs[i].name)));
    return svg;
  }

  /** A plot with its style written into it, on white. */
  function plotFigure(host) {
    const plot = one(host + " svg");
    if (!plot) return null;
    const copy = plot.cloneNode(true), from = all("*", plot);
    all("*", copy).forEach((part, i) => {
      const style = getComputedStyle(from[i]);
      ["fill", "stroke", "font-size", "font-weight", "font-family"].forEach((key) =>
        part.style.setProperty(key, style.getPropertyValue(key)));
    });
    copy.prepend(drawing("rect", {width: "100%", height: "100%",
      fill: getComputedStyle(document.body).backgroundColor}));
    return copy;
  }

  function savePng(name, svg, text) {
    const image = new Image(), width = Number(svg.getAttribute("width"));
    const height = width * svg.viewBox.baseVal.height / svg.viewBox.baseVal.width;
    image.onload = () => {
      const canvas = element("canvas", {width: 2 * width, height: Math.round(2 * height)});
      canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
      canvas.toBlob((png) => save(name, png, "image/png"));
    };
    image.src = "data:image/svg+xml;charset=utf-8," + encodeURIComponent(text);
  }

  function wireFigures() {
    const figures = {map: mapFigure, plot: () => plotFigure("#plot"), along: () => plotFigure("#along")};
    all(".save").forEach((host) => ["SVG", "PNG"].forEach((kind) => {
      const button = element("button", {type: "button", class: "csv", "data-kind": kind}, kind);
      button.addEventListener("click", () => {
        const svg = figures[host.dataset.figure]();
        if (!svg) return;
        const text = new XMLSerializer().serializeToString(svg), name = host.dataset.figure + "." + kind.toLowerCase();
        if (kind === "SVG") save(name, text, "image/svg+xml"); else savePng(name, svg, text);
      });
      host.append(" ", button);
    }));
  }

  // ---- The address of what is shown: #runs=1,3&layers=rooms,breaks&view=x,y,zoom&room=R3&break=2.

  const siteLayers = ["rooms", "breaks", "paths", "heat"];

  function addressOfState() {
    const isOn = (name) => boxOf(name) && boxOf(name).checked;
    const parts = [
      ["runs", data.runs.map((run, i) => i).filter((i) => isOn("run-" + i)).map((i) => i + 1).join(",")],
      ["layers", siteLayers.filter(isOn).join(",")]];
    const center = map.getCenter(), [x, y] = siteFromShown([center.lng, center.lat]);
    if (!isWhole) parts.push(["view", [x.toFixed(2), y.toFixed(2), map.getZoom()].join(",")]);
    if (chosen !== null) parts.push(["room", data.rooms[chosen].id]);
    if (chosenBreak !== null) parts.push(["break", chosenBreak + 1]);
    if (pair) parts.push([pair.kind, [pair.left + 1, pair.right + 1, Math.round(100 * pair.share)].join(",")]);
    return "#" + parts.map(([key, value]) => key + "=" + encodeURIComponent(value)).join("&");
  }

  let isRestoring = false;

  function restore() {
    const said = new URLSearchParams(location.hash.slice(1));
    if (!location.hash.includes("=")) return;
    isRestoring = true;
    const list = (key) => (said.get(key) || "").split(",");
    const numbers = (key) => list(key).map(Number);
    if (said.has("layers")) siteLayers.forEach((name) => boxOf(name) && show(name, list("layers").includes(name)));
    if (said.has("runs")) showRuns((i) => numbers("runs").includes(i + 1));
    ["swipe", "beside"].forEach((kind) => {
      const [left, right, percent] = numbers(kind).map((value) => value - 1);
      if (said.has(kind) && data.runs[left] && data.runs[right]) startPair(kind, left, right, (percent + 1) / 100);
    });
    const room = data.rooms.findIndex((one) => one.id === said.get("room"));
    if (room >= 0 && room !== chosen) choose(room, "row");
    const tear = Number(said.get("break")) - 1;
    if (data.breaks[tear]) chooseBreak(tear);
    const [x, y, zoom] = numbers("view");
    if (said.has("view") && [x, y, zoom].every(Number.isFinite)) {
      isWhole = false;
      map.setView(latLng(shownFromSite([x, y])), zoom, {animate: false});
    }
    isRestoring = false;
  }

  function wireAddress() {
    let waiting = 0;
    changed = () => {
      if (isRestoring) return;
      clearTimeout(waiting);
      waiting = setTimeout(() => {
        try { history.replaceState(null, "", addressOfState()); } catch (error) { /* a page that may not */ }
      }, 150);
    };
    map.on("moveend", () => changed());
    window.addEventListener("hashchange", restore);
    restore();
  }

  all("tr.break").forEach((row) => {
    const picture = breakPicture(Number(row.dataset.break), 120, 84);
    if (picture) row.querySelector(".scans").replaceChildren(picture);
  });
  wirePair();
  wireTables();
  wireFigures();
  wireAddress();
