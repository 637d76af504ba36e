"use strict";
const parts = (number) => document.querySelectorAll(`[data-n="${number}"]`);
const light = (number, on) => parts(number).forEach((part) => part.classList.toggle("lit", on));
let held = null;
document.querySelectorAll("[data-n]").forEach((part) => {
  const number = part.dataset.n;
  part.addEventListener("mouseenter", () => light(number, true));
  part.addEventListener("mouseleave", () => { if (held !== number) light(number, false); });
  part.addEventListener("click", () => {
    if (held !== null) light(held, false);
    held = held === number ? null : number;
    if (held !== null) light(held, true);
  });
});
window.addEventListener("beforeprint", () => {
  document.querySelectorAll("details").forEach((part) => { part.open = true; });
});
