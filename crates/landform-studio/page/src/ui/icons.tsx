// Small pictures of buttons, drawn with one line width.
const PATHS: { [name: string]: string } = {
  undo: "M8 5 4 9l4 4M4.5 9H13a5 5 0 0 1 0 10h-3",
  redo: "m16 5 4 4-4 4M19.5 9H11a5 5 0 0 0 0 10h3",
  play: "M7 4.5v15l12-7.5z",
  pause: "M8 5v14M16 5v14",
  step: "M6 5v14l9-7zM18 5v14",
  stop: "M6 6h12v12H6z",
  plus: "M12 5v14M5 12h14",
  close: "m6 6 12 12M18 6 6 18",
  up: "m6 14 6-6 6 6",
  down: "m6 10 6 6 6-6",
  eye: "M2.5 12S6 5.5 12 5.5 21.5 12 21.5 12 18 18.5 12 18.5 2.5 12 2.5 12zM12 9.2a2.8 2.8 0 1 0 0 5.6 2.8 2.8 0 0 0 0-5.6z",
  trash: "M5 7h14M10 7V4.5h4V7M7 7l1 12.5h8L17 7M10.5 10.5v6M13.5 10.5v6",
  reset: "M5 5v5h5M5.5 10a7 7 0 1 1-.5 4",
  dice: "M5 5h14v14H5zM9 9h.01M15 15h.01M12 12h.01M15 9h.01M9 15h.01",
  home: "M4 11.5 12 5l8 6.5M6.5 10v9h11v-9",
  sun: "M12 8a4 4 0 1 0 0 8 4 4 0 0 0 0-8zM12 2.5v2M12 19.5v2M2.5 12h2M19.5 12h2M5.3 5.3l1.4 1.4M17.3 17.3l1.4 1.4M18.7 5.3l-1.4 1.4M6.7 17.3l-1.4 1.4",
  grid: "M4 4h6.5v6.5H4zM13.5 4H20v6.5h-6.5zM4 13.5h6.5V20H4zM13.5 13.5H20V20h-6.5z",
  folder: "M3.5 6.5h6l2 2.5h9v10h-17z",
  text: "M5 6h14M5 10h14M5 14h9M5 18h11",
  save: "M5 4.5h11l3.5 3.5v11.5H5zM8 4.5v5h7v-5M8 19.5v-6h8v6",
  copy: "M8.5 8.5h11v11h-11zM5 15.5V5h10.5",
  build: "M4 19.5h16M6 19.5 12 6l6 13.5M9.4 12h5.2",
  export: "M12 15V4M8 7.5 12 3.5l4 4M5 13v6.5h14V13",
  compare: "M12 3.5v17M4 6.5h5v11H4zM15 6.5h5v11h-5z",
  probe: "M12 3v6M12 15v6M3 12h6M15 12h6",
  orbit: "M12 7.5a4.5 4.5 0 1 0 0 9 4.5 4.5 0 0 0 0-9zM3 14.5c-2-4 5-8 11-8.5M21 9.500c2 4-5 8-11 8.500",
  raise: "M3.500 18.500h17M6 18.500c3.500 0 3.500-8 6-8s2.500 8 6 8M12 7.500v-5M9.500 5 12 2.500 14.500 5",
  lower: "M3.500 8.500H6c3.500 0 3.500 8 6 8s2.500-8 6-8h2.500M12 6.500v7",
  smooth: "M3.500 13c3-5 5.500-5 8.500 0s5.500 5 8.500 0M3.500 18.500h17",
  brush: "M19.500 4.500c-4.500 1.500-9 5.500-11 8.500l2.500 2.500c3-2 7-6.500 8.500-11zM8.500 13c-3 .3-2.500 3.500-5 5.500 3.500 1 7 .5 7.500-3",
  level: "M3.500 12h17M7 7.500v2M12 5.500v4M17 7.500v2M7 14.500v2M12 14.500v4M17 14.500v2",
  keys: "M3.500 7h17v10h-17zM7 10.500h.01M10.500 10.500h.01M14 10.500h.01M17 10.500h.01M8 14h8",
  help: "M9.300 9.300a2.700 2.700 0 1 1 3.900 2.400c-.9.500-1.200 1-1.200 2M12 17h.01",
  grip: "M9 6h.01M15 6h.01M9 12h.01M15 12h.01M9 18h.01M15 18h.01",
};

export function Icon({ name }: { name: string }) {
  return (
    <svg class="icon" viewBox="0 0 24 24" width="16" height="16" fill="none" stroke="currentColor" stroke-width="1.7" stroke-linecap="round" stroke-linejoin="round" aria-hidden="true">
      <path d={PATHS[name] ?? ""} />
    </svg>
  );
}
