// Asks for the token of a server that needs one; it is stored in this browser.
import {useSignal} from "@preact/signals";
import {refused_token, token} from "../api/identity";
import {Dialog} from "./dialog";

export function TokenDialog() {
  const typed = useSignal("");
  const refused = refused_token.value;
  if (refused === null) return null;
  const give = (event: Event) => {
    event.preventDefault();
    token.value = typed.value.trim();
    typed.value = "";
    refused_token.value = null;
  };
  return (
    <Dialog title="The server's token" close={() => { refused_token.value = null; }}>
      <form class="token-form" onSubmit={give}>
        <p>{refused ? "The server does not accept this token." : "This server needs a token."} Ask the person who started it with <code>--token</code>.</p>
        <label>Token <input type="password" autoComplete="current-password" autoFocus value={typed.value} onInput={(event) => { typed.value = event.currentTarget.value; }} /></label>
        <button type="submit" class="primary" disabled={!typed.value.trim()}>Continue</button>
      </form>
    </Dialog>
  );
}
