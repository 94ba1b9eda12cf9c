// The repository's looks and recipes, in a bundle that is loaded on demand.
import type {Command} from "../api/types";
import bear from "../../../looks/bear.json";
import fox from "../../../looks/fox.json";
import leopard from "../../../looks/leopard.json";
import rabbit from "../../../looks/rabbit.json";
import sheep from "../../../looks/sheep.json";
import shorthair_cat from "../../../looks/shorthair_cat.json";
import toy_plush from "../../../looks/toy_plush.json";
import wet_dog from "../../../looks/wet_dog.json";
import zebra from "../../../looks/zebra.json";
import best_in_show from "../../../recipes/best_in_show.json";
import creature from "../../../recipes/creature.json";
import dot from "../../../recipes/dot.json";
import portrait_light from "../../../recipes/portrait_light.json";
import tint from "../../../recipes/tint.json";

export const looks = {bear, fox, leopard, rabbit, sheep, shorthair_cat, toy_plush, wet_dog, zebra} as unknown as Record<string, {commands: Command[]}>;
/** Recipes by the file names that recipes use to include them. */
export const recipes: Record<string, unknown> = {
  "best_in_show.json": best_in_show, "creature.json": creature, "dot.json": dot, "portrait_light.json": portrait_light, "tint.json": tint,
};
