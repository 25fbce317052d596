// Plays the drive of pageData: what is known of the map, the path, the fireflies and the trail, in cells.
(function () {
    'use strict';
    const columns = pageData.width, rows = pageData.height, frames = pageData.frames;
    const FREE = 0, OCCUPIED = 1, UNKNOWN = 2;
    const canvas = document.querySelector('.drive canvas');
    const slider = document.getElementById('slider');
    const button = document.getElementById('play');
    const speed = document.getElementById('speed');
    const fireflies = document.getElementById('swarm');
    const last = frames.length - 1;
    let time = 0, playing = !window.matchMedia('(prefers-reduced-motion: reduce)').matches, before = null;

    // Cells are pixels of a picture that is scaled to the canvas.
    const picture = document.createElement('canvas');
    picture.width = columns;
    picture.height = rows;
    const pixels = picture.getContext('2d');
    const image = pixels.createImageData(columns, rows);
    const words = new Uint32Array(image.data.buffer);
    const obstacles = new Uint8Array(columns * rows);
    // opaque: alpha, blue, green, red
    const COLOURS = {[FREE]: 0xffffffff, [OCCUPIED]: 0xff2b2b2b, [UNKNOWN]: 0xffd9d2cc};
    const HIDDEN = 0xff9fb4dc;
    let shown = -1;

    function eachCell(runs, visit) {
        for (let i = 0; i < runs.length; i += 3) {
            for (let k = 0; k < runs[i + 1]; ++k) visit(runs[i] + k, runs[i + 2]);
        }
    }

    function pixelOf(cell) {
        if (pageData.yDown) return cell;
        return (rows - 1 - Math.floor(cell / columns)) * columns + cell % columns;
    }

    function paint(cell, kind) {
        words[pixelOf(cell)] = obstacles[cell] && kind !== OCCUPIED ? HIDDEN : COLOURS[kind];
    }

    eachCell(pageData.obstacles, cell => { obstacles[cell] = 1; });

    function showMap(index) {
        if (index < shown || shown < 0) {
            for (let cell = 0; cell < columns * rows; ++cell) paint(cell, UNKNOWN);
            eachCell(pageData.known, paint);
            shown = -1;
        }
        while (shown < index) eachCell(frames[++shown].news, paint);
        pixels.putImageData(image, 0, 0);
    }

    function draw() {
        let index = 0;
        while (index < last && frames[index + 1].time <= time) ++index;
        const frame = frames[index], next = frames[Math.min(index + 1, last)];
        showMap(index);
        const room = 0.75 * window.innerHeight;
        const width = Math.min(canvas.parentElement.clientWidth, Math.max(320, room * columns / rows));
        const scale = width / columns, height = rows * scale, density = window.devicePixelRatio || 1;
        canvas.style.width = width + 'px';
        canvas.style.height = height + 'px';
        canvas.width = Math.round(width * density);
        canvas.height = Math.round(height * density);
        const context = canvas.getContext('2d');
        context.scale(density, density);
        context.imageSmoothingEnabled = scale < 1;
        context.drawImage(picture, 0, 0, width, height);
        const place = (x, y) => [x * scale, (pageData.yDown ? y : rows - y) * scale];

        function trace(numbers, end) {
            context.beginPath();
            for (let i = 0; i < end; i += 2) {
                const [x, y] = place(numbers[i], numbers[i + 1]);
                context[i === 0 ? 'moveTo' : 'lineTo'](x, y);
            }
        }

        function line(numbers, colour, thickness, opacity, end) {
            context.globalAlpha = opacity;
            context.strokeStyle = colour;
            context.lineWidth = thickness;
            trace(numbers, end === undefined ? numbers.length : end);
            context.stroke();
            context.globalAlpha = 1;
        }

        function robot(pose, fill, stroke) {
            const corners = [], cos = Math.cos(pose[2]), sin = Math.sin(pose[2]);
            for (let i = 0; i < pageData.robot.length; i += 2) {
                const x = pageData.robot[i], y = pageData.robot[i + 1];
                corners.push(pose[0] + cos * x - sin * y, pose[1] + sin * x + cos * y);
            }
            context.fillStyle = fill;
            context.strokeStyle = stroke;
            context.lineWidth = 1.5;
            if (corners.length > 4) {
                trace(corners, corners.length);
                context.closePath();
                context.fill();
                context.stroke();
            }
            const [x, y] = place(pose[0], pose[1]);
            context.beginPath();
            context.arc(x, y, 2.5, 0, 7);
            context.fillStyle = stroke;
            context.fill();
        }

        if (fireflies.checked) frame.swarm.forEach(path => line(path, '#0072b2', 1, 0.45));
        line(frame.path, '#000000', 2.2, 1);
        // the trail up to this time
        const part = next.time > frame.time ? Math.min((time - frame.time) / (next.time - frame.time), 1) : 0;
        const point = Math.round(frame.point + part * (next.point - frame.point));
        line(pageData.trail, '#d55e00', 2.4, 1, 2 * point + 2);
        robot(pageData.goal, 'rgba(224, 96, 90, 0.35)', '#8c1d18');
        const turn = Math.atan2(Math.sin(next.pose[2] - frame.pose[2]), Math.cos(next.pose[2] - frame.pose[2]));
        robot([pageData.trail[2 * point], pageData.trail[2 * point + 1], frame.pose[2] + part * turn],
            'rgba(73, 178, 102, 0.6)', '#12632b');
        context.strokeStyle = '#5b6670';
        context.lineWidth = 1;
        context.strokeRect(0.5, 0.5, width - 1, height - 1);

        slider.value = index;
        document.getElementById('time').textContent = time.toFixed(1);
        button.textContent = playing ? 'Pause' : 'Play';
        document.querySelector('.state').textContent = 'Period ' + index + ': driven ' + frame.driven +
            (frame.blocked ? ', the path was blocked' : '') + (index === last ? ', ' + pageData.status : '');
    }

    function step(now) {
        const seconds = before === null ? 0 : Math.min((now - before) / 1000, 0.1);
        before = now;
        if (!playing) return;
        time = Math.min(time + seconds * Number(speed.value), frames[last].time);
        playing = time < frames[last].time;
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
        if (time >= frames[last].time) time = 0;
        play();
    });
    slider.addEventListener('input', () => {
        playing = false;
        time = frames[Number(slider.value)].time;
        draw();
    });
    fireflies.addEventListener('change', draw);
    window.addEventListener('resize', draw);
    draw();
    if (playing) play();
})();
