// The meshes: bytes in base64, deflated. Numbers of 16 bits are differences, low bytes first, then
// high bytes; indices and steps of parameters are varints.
async function unpack(text) {
  const packed = Uint8Array.from(atob(text), c => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  let at = 0;
  const varint = () => {
    let value = 0, shift = 1, byte;
    do {
      byte = bytes[at++];
      value += (byte & 127) * shift;
      shift *= 128;
    } while (byte > 127);
    return value;
  };
  const signed = () => {
    const z = varint();
    return z % 2 ? -(z + 1) / 2 : z / 2;
  };
  const words = count => {
    const result = new Uint16Array(count);
    for (let i = 0, sum = 0; i < count; ++i) result[i] = sum += bytes[at + i] + 256 * bytes[at + count + i];
    at += 2 * count;
    return result;
  };
  const places = (count, box) => {
    const planes = [0, 1, 2].map(() => words(count));
    return Array.from({length: count}, (_, i) =>
      planes.map((plane, k) => box.low[k] + (box.high[k] - box.low[k]) * plane[i] / 65535));
  };
  const chains = read => Array.from({length: varint()}, () => Array.from({length: varint()}, read));
  for (const s of scene.surfaces) {
    const count = varint();
    const [triangles, guesses] = walk(varint(), varint);
    s.triangles = triangles;
    s.uv = [0, 1].map(() => {
      const steps = [];
      for (let i = 0; i < count; ++i) {
        const [a, b, c] = guesses[i] || [i - 1, 0, 0];
        steps[i] = signed() + (steps[a] + steps[b] - steps[c] || 0);
      }
      return steps;
    });
    let corner = 0;
    s.known = Array.from({length: varint()}, () => corner += varint());
    s.knownPosition = places(s.known.length, s.box);
    const [a, b] = [words(s.known.length), words(s.known.length)];
    s.knownNormal = s.known.map((_, i) => {  // folded from an octahedron
      const x = a[i] / 32767.5 - 1, y = b[i] / 32767.5 - 1, z = 1 - Math.abs(x) - Math.abs(y);
      return unit(z < 0 ? [(1 - Math.abs(y)) * (x < 0 ? -1 : 1), (1 - Math.abs(x)) * (y < 0 ? -1 : 1), z] : [x, y, z]);
    });
    corner = 0;
    s.chains = chains(() => corner += signed());
    s.contourPlaces = places(varint(), s.box);
    let first = 0;
    s.contourChains = Array.from({length: varint()}, () => Array.from({length: varint()}, () => first++));
  }
  scene.maps = scene.scales.map(() => bytes.slice(at, at += 768));
  if (scene.pictures) await unpackPictures(bytes, at);
}

// The triangles, and from which corners each one is guessed, as page_triangles.h has it: 0 says that
// a side has no other triangle, 1 names the next corner, 2 the one behind on the border, 3 and more
// those before. The triangle at the side on top of `gates` comes next.
function walk(count, code) {
  const triangles = [], guesses = [], gates = [], before = [], after = [];
  let next = 0;
  const corner = (c, gate) => c > 2 ? next + 3 - c : c > 1 ? before[gate[0]] : (guesses[next] = gate, next++);
  const take = (a, b, c) => {
    triangles.push(a, b, c);
    const sides = [[a, b, c], [c, a, b], [b, c, a]], open = sides.filter(([x, y]) => after[y] != x);
    for (const [x, y] of sides) if (after[y] == x) after[y] = null;
    for (const gate of open) {
      const [x, y] = gate;
      after[x] = y;
      before[y] = x;
      gates.push(gate);
    }
  };
  while (triangles.length < 3 * count || gates.length) {
    const gate = gates.pop();
    if (!gate) {
      take(corner(code()), corner(code()), corner(code()));
    } else if (after[gate[0]] == gate[1]) {
      const c = code();
      if (c) take(gate[1], gate[0], corner(c, gate));
    }
  }
  return [triangles, guesses];
}
