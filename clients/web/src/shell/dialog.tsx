// A modal dialog on the browser's <dialog> element: focus stays in it, Escape closes it.
import type {ComponentChildren} from "preact";
import {useLayoutEffect, useRef} from "preact/hooks";
import {Icon} from "../tools/icons";

export function Dialog({title, close, children}: {title: string; close: () => void; children: ComponentChildren}) {
  const element = useRef<HTMLDialogElement>(null);
  useLayoutEffect(() => { element.current?.showModal(); }, []);  // before a key can be pressed
  const outside = (event: MouseEvent) => { if (event.target === element.current) close(); };
  return (
    <dialog ref={element} aria-label={title} onClose={close} onClick={outside}>
      <header><h2>{title}</h2><button type="button" class="quiet" aria-label="Close" onClick={close}><Icon sign="close" /></button></header>
      {children}
    </dialog>
  );
}
