import { render } from "preact";
import { start } from "./model/actions.ts";
import { App } from "./ui/app.tsx";

const root = document.getElementById("studio")!;
root.textContent = "";
render(<App />, root);
start();
