import {dismiss, messages} from "../scene/messages";
import {Icon} from "../tools/icons";

export function Messages() {
  return (
    <div class="messages" role="log" aria-live="polite" aria-label="Messages">
      {messages.value.map(({id, kind, text, next}) => (
        <div key={id} class={`message message-${kind}`}>
          <p>{text}{next && <small>{next}</small>}</p>
          <button type="button" class="quiet" aria-label="Dismiss" onClick={() => dismiss(id)}><Icon sign="close" /></button>
        </div>
      ))}
    </div>
  );
}
