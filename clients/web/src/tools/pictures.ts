// A picture for each tool, before and after, made by the program (pictures/make.py).
import type {Op} from "../api/types";

const pictures: Partial<Record<Op, string>> = {};
export default pictures;
