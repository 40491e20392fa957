// SPDX-License-Identifier: GPL-3.0-or-later
// The content of the page: an object, and arrays of numbers that it refers to.

const kinds = { float64: Float64Array, float32: Float32Array, uint32: Uint32Array, uint8: Uint8Array };

function bytesOf(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let k = 0; k < binary.length; ++k) bytes[k] = binary.charCodeAt(k);
  return bytes.buffer;
}

// Replaces {"array": kind, "offset": bytes, "length": numbers} by the array.
function withArrays(value, buffer) {
  if (value === null || typeof value !== "object") return value;
  if (typeof value.array === "string") return new kinds[value.array](buffer, value.offset, value.length);
  for (const key of Object.keys(value)) value[key] = withArrays(value[key], buffer);
  return value;
}

export function readContent() {
  const head = JSON.parse(document.getElementById("content").textContent);
  return withArrays(head, bytesOf(document.getElementById("numbers").textContent));
}
