// A line to the server that takes its time: each byte arrives `delay` milliseconds later, both ways.
import net from "node:net";

export class SlowLine {
  static open(port, delay) {
    const line = new SlowLine();
    const later = (from, to) => {
      from.on("data", (bytes) => setTimeout(() => to.write(bytes), delay));
      from.on("end", () => setTimeout(() => to.end(), delay));
      from.on("error", () => to.destroy());
      from.on("close", () => setTimeout(() => to.destroy(), delay));
    };
    line.server = net.createServer((client) => {
      const back = net.connect(port, "127.0.0.1");
      client.setNoDelay(true);
      back.setNoDelay(true);
      later(client, back);
      later(back, client);
    });
    return new Promise((ready) => line.server.listen(0, "127.0.0.1", () => {
      line.address = `http://127.0.0.1:${line.server.address().port}`;
      ready(line);
    }));
  }

  close() { this.server.close(); }
}
