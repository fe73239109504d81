// SPDX-License-Identifier: BSD-3-Clause
// Draws the plots of the page from the data that stands in it (report/plot.cpp).
(() => {
  "use strict";
  const plots = JSON.parse(document.getElementById("data").textContent);
  const height = 300;
  const reach = 24; // pixels from the pointer within which a point is read out

  const style = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

  // From low to high, with a lightness that can be told from white and from black.
  const scale = [[58, 82, 168], [28, 128, 170], [20, 150, 118], [140, 160, 30], [226, 142, 20], [214, 68, 48]];
  function shade(share) {
    const at = Math.min(Math.max(share, 0), 1) * (scale.length - 1);
    const low = Math.min(Math.floor(at), scale.length - 2);
    const mixed = scale[low].map((c, k) => Math.round(c + (at - low) * (scale[low + 1][k] - c)));
    return `rgb(${mixed.join(",")})`;
  }
  function color(curve) {
    if (curve.shade !== undefined) return shade(curve.shade);
    return style(curve.color < 0 ? "--gray" : `--c${curve.color % 8}`);
  }

  function text(value) {
    if (value === null || value === undefined) return "\u2013";
    return String(Number(value.toPrecision(5)));
  }
  // All digits that a step of the axis has, without those of rounding.
  const tick = (value) => String(Number(value.toPrecision(10)));

  // uPlot wants one ascending x for all curves of a plot. Two points of a curve at one x, as two measurements
  // at one velocity, are set apart by less than a pixel.
  function with_own_x(curve, span) {
    const x = [], y = [];
    curve.x.forEach((value, i) => {
      if (value === null) return;
      const last = x.length ? x[x.length - 1] : -Infinity;
      x.push(value > last ? value : last + span * 1e-6);
      y.push(curve.y[i]);
    });
    return [x, y];
  }
  function aligned(plot) {
    if (plot.shared_x) return [plot.shared_x, ...plot.curves.map((curve) => curve.y)];
    const all = plot.curves.flatMap((curve) => curve.x).filter((value) => value !== null);
    const span = Math.max(...all) - Math.min(...all) || 1;
    return uPlot.join(plot.curves.map((curve) => with_own_x(curve, span)));
  }

  // Curves have points at different x: read out the nearest one of each, if it is near enough.
  function nearest(u, series, index) {
    if (series === 0) return index;
    const x = u.data[0], y = u.data[series];
    if (index === null || index === undefined || (y[index] !== null && y[index] !== undefined)) return index;
    let low = index, high = index;
    while (low >= 0 && (y[low] === null || y[low] === undefined)) --low;
    while (high < x.length && (y[high] === null || y[high] === undefined)) ++high;
    const pixel = (i) => Math.abs(u.valToPos(x[i], "x") - u.cursor.left);
    const best = low < 0 ? high : high >= x.length || pixel(low) <= pixel(high) ? low : high;
    return best >= 0 && best < x.length && pixel(best) <= reach ? best : null;
  }

  const dashes = { dashed: [7, 4], dotted: [2, 4] };

  function series_of(curve) {
    const stroke = color(curve);
    const kind = curve.draw.split(" ")[0];
    const has_line = kind !== "points";
    const has_points = curve.draw.includes("points");
    return {
      label: curve.label, stroke, spanGaps: true, width: has_line ? 2 : 0,
      dash: dashes[kind], class: kind,
      paths: has_line ? undefined : () => null,
      points: has_line ? { show: has_points, size: 6, fill: stroke }
                       : { show: true, size: 9, width: 2, stroke, fill: style("--card") },
      value: (u, value) => text(value),
    };
  }

  function axis_of(axis) {
    return {
      label: axis.label, labelSize: 24, labelFont: "13px system-ui, sans-serif", font: "12px system-ui, sans-serif",
      stroke: style("--soft"), grid: { stroke: style("--line"), width: 1 }, ticks: { stroke: style("--line"), width: 1 },
      values: (u, splits) => splits.map(tick), incrs: axis.whole ? [1, 2, 5, 10, 20, 50, 100] : undefined,
    };
  }
  const bottom_axis = (axis) => Object.assign(axis_of(axis), { size: 36 });

  const superscript = (number) => String(number).replace(/[-0-9]/g, (c) => "\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"["-0123456789".indexOf(c)]);
  const power = (value) => value > 0 ? Math.round(1e6 * Math.log10(value)) / 1e6 : NaN;
  const powers = (u, splits) => splits.map((v) => Number.isInteger(power(v)) ? v : null);
  // Of many decades every second or third has its number.
  function power_text(u, splits) {
    const each = Math.ceil(splits.filter((v) => Number.isInteger(power(v))).length / 8);
    return splits.map((v) => power(v) % each === 0 ? `10${superscript(power(v))}` : null);
  }

  function left_axis(axis) {
    const made = axis_of(axis);
    // Room for the longest number: it must not run into the label.
    made.size = (u, values) => 24 + 7 * Math.max(2, ...(values || []).map((value) => String(value ?? "").length));
    if (axis.log) {
      made.values = power_text;
      made.grid.filter = powers;
      made.ticks.filter = powers;
    }
    return made;
  }

  function draw(place, plot) {
    place.textContent = "";
    const options = {
      width: Math.max(place.clientWidth, 240), height,
      scales: { x: { time: false }, y: plot.y.log ? { distr: 3 } : {} },
      axes: [bottom_axis(plot.x), left_axis(plot.y)],
      series: [{ label: plot.x.label, value: (u, value) => text(value) }, ...plot.curves.map(series_of)],
      cursor: { focus: { prox: 30 }, dataIdx: nearest, points: { size: 8 }, drag: { x: true, y: true, uni: 40 } },
      legend: { markers: { width: 2, fill: "transparent", dash: (u, k) => k > 0 ? { dashed: "dashed", dotted: "dotted" }[plot.curves[k - 1].draw.split(" ")[0]] || "solid" : "solid" } },
      focus: { alpha: 0.3 },
    };
    return new uPlot(options, aligned(plot), place);
  }

  const places = [...document.querySelectorAll("[data-plot]")];
  let drawn = [];
  function draw_all() {
    drawn.forEach((plot) => plot.destroy());
    drawn = places.map((place) => draw(place, plots[Number(place.dataset.plot)]));
  }
  draw_all();

  const fit = () => places.forEach((place, k) => {
    if (place.clientWidth !== drawn[k].width) drawn[k].setSize({ width: place.clientWidth, height });
  });
  new ResizeObserver(fit).observe(document.body);
  // Colors are in the canvas: draw anew where they change, on screen and for paper.
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw_all);
  matchMedia("print").addEventListener("change", draw_all);
})();
