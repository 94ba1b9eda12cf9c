// Job type of Flamenco 3: a task for each chunk of a folder that `pelage farm submit --dry-run` made.
// Put it into the folder `scripts` beside flamenco-manager.
const JOB_TYPE = {
  label: "Pelage",
  settings: [
    { key: "folder", type: "string", required: true, description: "The folder, as the workers see it" },
    { key: "chunks", type: "int32", required: true, description: "Lines of its chunks.txt" },
  ],
};

function compileJob(job) {
  for (let chunk = 0; chunk < job.settings.chunks; ++chunk) {
    const task = author.Task(`chunk-${chunk}`, "misc");
    task.addCommand(author.Command("exec", { exe: "sh", args: [`${job.settings.folder}/chunk.sh`, String(chunk)] }));
    job.addTask(task);
  }
}
