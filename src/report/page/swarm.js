// Plays the recorded swarms of pageData on canvases, one per planner.
(function () {
    'use strict';
    const [left, low] = pageData.lower;
    const [right, high] = pageData.upper;
    const figures = Array.from(document.querySelectorAll('.swarms figure'));
    const slider = document.getElementById('slider');
    const button = document.getElementById('play');
    const speed = document.getElementById('speed');
    let position = 0, playing = !window.matchMedia('(prefers-reduced-motion: reduce)').matches, before = null;

    function trace(context, place, numbers) {
        for (let i = 0; i < numbers.length; i += 2) {
            const [x, y] = place(numbers[i], numbers[i + 1]);
            context[i === 0 ? 'moveTo' : 'lineTo'](x, y);
        }
    }

    function shape(context, place, polygons, fill, stroke) {
        context.fillStyle = fill;
        context.strokeStyle = stroke;
        context.lineWidth = 0.8;
        polygons.forEach(polygon => {
            context.beginPath();
            trace(context, place, polygon);
            context.closePath();
            context.fill();
            context.stroke();
        });
    }

    function line(context, place, numbers, colour, width, opacity) {
        context.globalAlpha = opacity;
        context.strokeStyle = colour;
        context.lineWidth = width;
        context.beginPath();
        trace(context, place, numbers);
        context.stroke();
        context.globalAlpha = 1;
    }

    // Between two generations each path moves straight.
    function between(from, to, part) {
        return to === undefined || from.length !== to.length ? from : from.map((value, i) => value + part * (to[i] - value));
    }

    function drawSwarm(figure, swarm) {
        const canvas = figure.querySelector('canvas');
        const width = canvas.clientWidth, height = width * (high - low) / (right - left);
        const density = window.devicePixelRatio || 1;
        canvas.style.height = height + 'px';
        canvas.width = Math.round(width * density);
        canvas.height = Math.round(height * density);
        const context = canvas.getContext('2d');
        context.scale(density, density);
        const place = (x, y) => [(x - left) / (right - left) * width, height - (y - low) / (high - low) * height];
        context.fillStyle = '#ffffff';
        context.fillRect(0, 0, width, height);
        shape(context, place, pageData.obstacles, '#aeb8c0', '#5b6670');
        swarm.slices.forEach(slice => line(context, place, slice, '#9db8d2', 0.8, 1));
        shape(context, place, pageData.start, '#49b266', '#12632b');
        shape(context, place, pageData.goal, '#e0605a', '#8c1d18');

        const last = swarm.frames.length - 1;
        const index = Math.min(Math.floor(position), last);
        const frame = swarm.frames[index], next = swarm.frames[Math.min(index + 1, last)];
        const part = Math.min(position, last) - index;
        frame.paths.forEach((path, i) => line(context, place, between(path, next.paths[i], part),
            frame.valid[i] ? '#0072b2' : '#d55e00', 1.1, 0.55));
        if (frame.best) line(context, place, frame.best, '#000000', 2.6, 1);
        context.strokeStyle = '#5b6670';
        context.strokeRect(0.5, 0.5, width - 1, height - 1);
        figure.querySelector('.state').textContent = 'Generation ' + frame.generation + ': ' +
            frame.valid.reduce((sum, one) => sum + one, 0) + ' of ' + frame.paths.length + ' collision-free, best cost ' +
            (frame.best ? frame.cost : 'none yet');
    }

    function draw() {
        figures.forEach((figure, i) => drawSwarm(figure, pageData.swarms[i]));
        slider.value = position;
        document.getElementById('generation').textContent = Math.floor(position);
        button.textContent = playing ? 'Pause' : 'Play';
    }

    function step(now) {
        const seconds = before === null ? 0 : Math.min((now - before) / 1000, 0.1);
        before = now;
        if (!playing) return;
        position = Math.min(position + seconds * Number(speed.value), Number(slider.max));
        playing = position < Number(slider.max);
        draw();
        if (playing) requestAnimationFrame(step);
    }

    function play() {
        playing = true;
        before = null;
        requestAnimationFrame(step);
    }

    button.addEventListener('click', () => {
        if (playing) {
            playing = false;
            draw();
            return;
        }
        if (position >= Number(slider.max)) position = 0;
        play();
    });
    slider.addEventListener('input', () => {
        playing = false;
        position = Number(slider.value);
        draw();
    });
    window.addEventListener('resize', draw);
    draw();
    if (playing) play();
})();
