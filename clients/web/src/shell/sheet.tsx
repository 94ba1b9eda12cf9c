// The dialog that shows a finished sheet or film and saves it.
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
