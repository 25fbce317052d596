// Draws the plots of a report from pageData with dygraphs.
(function () {
    'use strict';
    const looks = new Map(pageData.planners.map(planner => [planner.name, planner]));
    const plots = [];
    const LEAST_EXCESS = 0.01;  // percent; the bottom of the logarithmic axis

    function shortNumber(value) {
        if (value === null || !isFinite(value)) return '-';
        const size = Math.abs(value);
        return size !== 0 && (size < 1e-4 || size >= 1e6) ? value.toExponential(1) : String(Number(value.toPrecision(4)));
    }

    // Markers that can be told apart without colours.
    function marker(index) {
        return function (graph, name, context, x, y, colour, size) {
            context.beginPath();
            context.strokeStyle = colour;
            context.lineWidth = 1.6;
            context.setLineDash([]);
            if (index % 4 === 0) context.arc(x, y, size, 0, 2 * Math.PI);
            if (index % 4 === 1) context.rect(x - size, y - size, 2 * size, 2 * size);
            const corners = index % 4 === 2 ? [[0, -1.3], [1.2, 0.9], [-1.2, 0.9]] : [[0, -1.4], [1.4, 0], [0, 1.4], [-1.4, 0]];
            if (index % 4 > 1) {
                corners.forEach(([a, b], i) => context[i === 0 ? 'moveTo' : 'lineTo'](x + size * a, y + size * b));
                context.closePath();
            }
            context.stroke();
        };
    }

    function seriesOf(names, scattered) {
        const series = {};
        names.forEach(name => {
            const look = looks.get(name);
            const place = pageData.planners.indexOf(look);
            series[name] = {color: look.colour, strokePattern: look.pattern.length ? look.pattern : null};
            if (scattered) {
                series[name].drawPointCallback = series[name].drawHighlightPointCallback = marker(place);
            }
        });
        return series;
    }

    // What the pointer is at, below the plot.
    function describe(xName, unit) {
        return function (data) {
            if (data.x === undefined || data.x === null) return '';
            const values = data.series.filter(entry => entry.isVisible && entry.y !== undefined && entry.y !== null)
                .map(entry => '<span class="value"><b style="color:' + entry.color + '">' + entry.labelHTML + '</b> ' +
                     shortNumber(entry.y) + unit + '</span>');
            return '<span class="value">' + xName + ' ' + shortNumber(data.x) + '</span>' + values.join('');
        };
    }

    function draw(element, rows, names, options) {
        const values = element.parentElement.querySelector('.values');
        const all = Object.assign({
            labels: ['x'].concat(names),
            series: seriesOf(names, options.scattered),
            labelsDiv: values, legend: 'onmouseover', legendFormatter: describe(options.xName, options.unit || ''),
            strokeWidth: 2, fillAlpha: Math.max(0.05, Math.min(0.15, 0.5 / names.length)),
             highlightCircleSize: 3, gridLineColor: '#dcdcdc', axisLineColor: '#4a4a4a',
            axisLabelWidth: 62, xLabelHeight: 20, yLabelWidth: 20, stepPlot: !options.scattered,
            visibility: names.map(isShown),
            axes: {x: {logscale: true, axisLabelFormatter: shortNumber, pixelsPerLabel: 60},
                   y: {axisLabelFormatter: shortNumber, axisLabelWidth: 52}}
        }, options.graph);
        const graph = new Dygraph(element, rows, all);
        element.dataset.drawn = 'true';
        plots.push({graph: graph, names: names, element: element});
    }

    function isShown(name) {
        const box = document.querySelector('.legend input[value="' + CSS.escape(name) + '"]');
        return box === null || box.checked;
    }

    function rangeOf(values, logarithmic) {
        const finite = values.filter(value => value !== null && isFinite(value));
        if (finite.length === 0) return [0.1, 1];
        const low = Math.min(...finite), high = Math.max(...finite);
        if (logarithmic) return [Math.max(LEAST_EXCESS, low) / 1.3, Math.max(10 * LEAST_EXCESS, high) * 1.3];
        const margin = Math.max(0.05 * (high - low), 1e-3 * Math.abs(high), 1e-12);
        return [low - margin, high + margin];
    }

    // A band without an end goes to the top of the plot, a point without a value is a gap.
    function banded(rows, range) {
        return rows.map(row => row.map((entry, i) => {
            if (i === 0) return entry;
            if (entry[1] === null) return [null, null, null];
            return [entry[0], entry[1], entry[2] === null ? range[1] : entry[2]];
        }));
    }

    // Enlarges a range of x to the left and right, so that no point is on the edge.
    function widened(values) {
        const low = Math.min(...values), high = Math.max(...values);
        return [low / 1.15, Math.max(high, low * 1.5) * 1.15];
    }

    const kinds = {
        solved(element, place) {
            const experiment = pageData.experiments[place];
            draw(element, banded(experiment.solved, [0, 100]), experiment.planners, {
                xName: 'time [s]', unit: ' %',
                graph: {customBars: true, xlabel: 'time [s]', ylabel: 'runs solved [%]', valueRange: [-2, 103]}
            });
        },
        cost(element, place, mode) {
            const experiment = pageData.experiments[place];
            const excess = mode === 'excess' && experiment.best > 0;
            const converted = value => value === null || !excess ? value :
                Math.max(LEAST_EXCESS, 100 * (value / experiment.best - 1));
            const rows = experiment.cost.map(row => row.map((entry, i) => i === 0 ? entry : entry.map(converted)));
            const range = rangeOf(rows.flatMap(row => row.slice(1).flatMap(entry => entry.slice(0, 2))), excess);
            const objective = experiment.best > 0 && excess ? 'median above the best known [%]' : 'median cost [units of the objective]';
            draw(element, banded(rows, range), experiment.planners, {
                xName: 'time [s]', unit: excess ? ' %' : '',
                graph: {customBars: true, xlabel: 'time [s]', ylabel: objective, valueRange: range, logscale: excess,
                        axes: {x: {logscale: true, axisLabelFormatter: shortNumber, pixelsPerLabel: 60},
                               y: {axisLabelFormatter: shortNumber, axisLabelWidth: 52, logscale: excess}}}
            });
        },
        runs(element, place, mode) {
            const experiment = pageData.experiments[place];
            const excess = mode === 'excess' && experiment.best > 0;
            const converted = value => excess ? Math.max(LEAST_EXCESS, 100 * (value / experiment.best - 1)) : value;
            const rows = experiment.runs.map(([time, planner, cost]) => {
                const row = [time].concat(experiment.planners.map(() => null));
                row[planner + 1] = converted(cost);
                return row;
            }).sort((a, b) => a[0] - b[0]);
            if (rows.length === 0) {
                element.textContent = 'No run has a path.';
                return;
            }
            draw(element, rows, experiment.planners, {
                scattered: true, xName: 'first solution [s]', unit: excess ? ' %' : '',
                graph: {xlabel: 'time to the first solution [s]', strokeWidth: 0, drawPoints: true, pointSize: 3.5,
                        highlightCircleSize: 5.5, dateWindow: widened(rows.map(row => row[0])),
                        ylabel: excess ? 'final cost above the best known [%]' : 'final cost [units of the objective]',
                        valueRange: rangeOf(rows.flatMap(row => row.slice(1)), excess), logscale: excess,
                        axes: {x: {logscale: true, axisLabelFormatter: shortNumber, pixelsPerLabel: 60},
                               y: {axisLabelFormatter: shortNumber, axisLabelWidth: 52, logscale: excess}}}
            });
        },
        profile(element, place) {
            const rows = pageData.profiles[place].rows.slice();
            // the curves go on at their last values
            const last = rows[rows.length - 1];
            rows.push([Math.max(2, 1.3 * last[0])].concat(last.slice(1)));
            draw(element, rows, pageData.compared, {
                xName: 'factor', unit: ' %',
                graph: {xlabel: 'time as a multiple of the best planner\'s', ylabel: 'experiments [%]', valueRange: [-2, 103]}
            });
        }
    };

    function drawAll(mode) {
        plots.forEach(plot => plot.graph.destroy());
        plots.length = 0;
        document.querySelectorAll('.plot').forEach(
            element => kinds[element.dataset.plot](element, Number(element.dataset.place), mode));
    }

    document.querySelectorAll('.legend input').forEach(box => box.addEventListener('change', () => {
        plots.forEach(plot => {
            const place = plot.names.indexOf(box.value);
            if (place >= 0) plot.graph.setVisibility(place, box.checked);
        });
    }));
    document.getElementById('cost-axis').addEventListener('change', event => drawAll(event.target.value));
    drawAll('excess');
})();
