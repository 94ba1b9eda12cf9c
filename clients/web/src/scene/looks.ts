// The looks that come with the program; each is a coat and its shading. pictures/looks.py makes their pictures.
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
import bear_picture from "../../pictures/look-bear.jpg";
import fox_picture from "../../pictures/look-fox.jpg";
import leopard_picture from "../../pictures/look-leopard.jpg";
import rabbit_picture from "../../pictures/look-rabbit.jpg";
import sheep_picture from "../../pictures/look-sheep.jpg";
import shorthair_cat_picture from "../../pictures/look-shorthair_cat.jpg";
import toy_plush_picture from "../../pictures/look-toy_plush.jpg";
import wet_dog_picture from "../../pictures/look-wet_dog.jpg";
import zebra_picture from "../../pictures/look-zebra.jpg";

export interface Look { name: string; picture: string; commands: Command[] }

const look = (name: string, picture: string, file: {commands: unknown[]}): Look => ({name, picture, commands: file.commands as Command[]});

export const looks: Look[] = [
  look("Fox", fox_picture, fox), look("Shorthair cat", shorthair_cat_picture, shorthair_cat), look("Leopard", leopard_picture, leopard),
  look("Zebra", zebra_picture, zebra), look("Bear", bear_picture, bear), look("Wet dog", wet_dog_picture, wet_dog),
  look("Sheep", sheep_picture, sheep), look("Rabbit", rabbit_picture, rabbit), look("Toy plush", toy_plush_picture, toy_plush),
];
