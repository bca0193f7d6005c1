// Sizes of elements.

/** Calls with the element's size, now and when it changes. */
export function follow(element: HTMLElement, resized: (width: number, height: number) => void): () => void {
  const observer = new ResizeObserver(() => resized(element.clientWidth, element.clientHeight));
  observer.observe(element);
  resized(element.clientWidth, element.clientHeight);
  return () => observer.disconnect();
}
