// Names of temporary scenes that the studio creates for itself. Nobody grooms in them, so lists omit them.
const preview = "studio: coat preview";
const trial = "studio: trial ";

export const preview_name = preview;
/** Returns the name of a trial copy; it contains the creation time, seconds of the epoch. */
export const trialName = () => `${trial}${Math.round(Date.now() / 1000)}`;
export const isScratch = (name: string) => name === preview || name.startsWith(trial);
/** Returns true for a trial copy of more than 1800 s ago, which a crashed page left. */
export const isStale = (name: string) => name.startsWith(trial) && Number(name.slice(trial.length)) < Date.now() / 1000 - 1800;
