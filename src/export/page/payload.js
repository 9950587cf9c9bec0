// The meshes: bytes in base64, deflated. Numbers of 16 bits are differences, low bytes first, then
// high bytes; indices are varints.
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
    s.uv = [words(count), words(count)];
    let next = 0;
    s.triangles = Uint32Array.from({length: 3 * varint()}, () => {
      const back = varint();
      return back ? next - back : next++;
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
}
