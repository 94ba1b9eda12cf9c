// A sheet of pictures that was asked for: to look at, and to keep.
import {closeSheet, keepSheet, sheet} from "../files/sheets";
import {Dialog} from "./dialog";

export function SheetDialog() {
  const now = sheet.value;
  if (!now) return null;
  return (
    <Dialog title={now.name} close={closeSheet}>
      <div class="sheet">
        {now.is_film ? <video src={now.address} autoPlay loop muted controls /> : <img src={now.address} alt={now.name} />}
        <button type="button" class="primary" onClick={keepSheet}>Download</button>
      </div>
    </Dialog>
  );
}
