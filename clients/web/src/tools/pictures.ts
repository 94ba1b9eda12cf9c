// A picture for each tool, before and after, made by the program (pictures/tools.py).
import attract from "../../pictures/tool-attract.jpg";
import blow from "../../pictures/tool-blow.jpg";
import clump from "../../pictures/tool-clump.jpg";
import comb from "../../pictures/tool-comb.jpg";
import curl from "../../pictures/tool-curl.jpg";
import erase from "../../pictures/tool-erase.jpg";
import flow from "../../pictures/tool-flow.jpg";
import interpolate from "../../pictures/tool-interpolate.jpg";
import length from "../../pictures/tool-length.jpg";
import lift from "../../pictures/tool-lift.jpg";
import noise from "../../pictures/tool-noise.jpg";
import paint from "../../pictures/tool-paint.jpg";
import part from "../../pictures/tool-part.jpg";
import smooth from "../../pictures/tool-smooth.jpg";
import trim from "../../pictures/tool-trim.jpg";
import unify from "../../pictures/tool-unify.jpg";
import whorl from "../../pictures/tool-whorl.jpg";
import type {Op} from "../api/types";

const pictures: Partial<Record<Op, string>> = {
  attract, blow, clump, comb, curl, erase, flow, interpolate, length, lift, noise, paint, part, smooth, trim, unify, whorl,
};
export default pictures;
