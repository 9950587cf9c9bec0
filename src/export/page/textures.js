// Textures of surfaces, which only pages with some need.

// The pictures' PNG files are at the end of the bytes; their rows are from below. Each channel is as
// it is in the file.
async function unpackPictures(bytes, at) {
  const options = {colorSpaceConversion: 'none', premultiplyAlpha: 'none'};
  scene.pictures = await Promise.all(scene.pictures.map(size =>
    createImageBitmap(new Blob([bytes.subarray(at, at += size)], {type: 'image/png'}), options)));
}

// A picture as a canvas with its pixels, larger or smaller by a factor.
function pixelsOf(picture, factor) {
  const canvas = document.createElement('canvas');
  canvas.width = Math.ceil(picture.width * factor);
  canvas.height = Math.ceil(picture.height * factor);
  canvas.getContext('2d').drawImage(picture, 0, 0, canvas.width, canvas.height);
  return canvas;
}

// The picture of a texture, no larger than the graphics card takes.
function glPicture(gl, {picture, wrap, smooth}) {
  const all = scene.pictures[picture];
  const fit = gl.getParameter(gl.MAX_TEXTURE_SIZE) / Math.max(all.width, all.height);
  const made = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, made);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, fit < 1 ? pixelsOf(all, fit) : all);
  gl.generateMipmap(gl.TEXTURE_2D);
  const set = (name, value) => gl.texParameteri(gl.TEXTURE_2D, gl['TEXTURE_' + name], gl[value]);
  set('MIN_FILTER', smooth ? 'LINEAR_MIPMAP_LINEAR' : 'NEAREST');
  set('MAG_FILTER', smooth ? 'LINEAR' : 'NEAREST');
  set('WRAP_S', wrap);
  set('WRAP_T', wrap);
  return made;
}

// Places on the texture of a surface's corners, 0 to 1.
const placesOf = s => Float32Array.from({length: 2 * s.uv[0].length}, (_, i) => s.uv[i % 2][i >> 1] / 65536);

// The colour in the middle of a triangle.
function texelOf(s, [a, b, c], color) {
  const {picture, wrap, scale, dark} = s.texture, image = scene.pictures?.[picture];
  const place = s.uv.map((uv, k) => scale[k] * (uv[a] + uv[b] + uv[c]) / 3 / 65536);
  if (!image) return (Math.floor(place[0]) + Math.floor(place[1])) % 2 ? times(color, dark) : color;
  image.pixels ||= pixelsOf(image, 1).getContext('2d').getImageData(0, 0, image.width, image.height).data;
  const [x, y] = place.map((t, k) => {
    const size = k ? image.height : image.width, turn = 1 - Math.abs(1 - (t - 2 * Math.floor(t / 2)));
    const share = wrap == 'REPEAT' ? t - Math.floor(t) : wrap == 'CLAMP_TO_EDGE' ? t : turn;
    return Math.min(Math.floor(share * size), size - 1);
  });
  const at = 4 * (y * image.width + x);
  return Array.from(image.pixels.slice(at, at + 3), byte => byte / 255);
}
