package org.robotui.sim.internal.world;

/**
 * Something with a name that stands on the floor, upright.
 *
 * @param name in lower case, words joined by underscores
 * @param round whether it is a column; otherwise it is a box along the axes
 * @param x of its middle, metres
 * @param y of its middle, metres
 * @param width along x, metres
 * @param depth along y, metres
 * @param height metres
 * @param colour 0xrrggbb
 */
public record Thing(String name, boolean round, double x, double y, double width, double depth, double height,
    int colour) {
  Solid solid() {
    return round
        ? Shapes.column(Solid.Kind.OBJECT, colour, x, y, width / 2, 0, height)
        : Shapes.box(colour, x - width / 2, y - depth / 2, x + width / 2, y + depth / 2, height);
  }
}
