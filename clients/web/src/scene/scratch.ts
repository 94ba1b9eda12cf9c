// Scenes that the studio makes for itself. Nobody grooms in them, so lists leave them out.
const preview = "studio: coat preview";
const trial = "studio: trial ";

export const preview_name = preview;
/** Of a copy that settings are tried in; it says when it was made. */
export const trialName = () => `${trial}${Math.round(Date.now() / 1000)}`;
export const isScratch = (name: string) => name === preview || name.startsWith(trial);
/** Left by a page that died. */
export const isStale = (name: string) => name.startsWith(trial) && Number(name.slice(trial.length)) < Date.now() / 1000 - 1800;
