package org.robotui.sim.internal.world;

/**
 * A rectangular room, which gives its walls and its floor their looks.
 *
 * @param name as in the plan
 * @param x1 west, metres
 * @param y1 south, metres
 * @param x2 east, metres
 * @param y2 north, metres
 * @param floor pattern of the floor
 * @param floorColour 0xrrggbb
 * @param wallColour 0xrrggbb
 */
public record Room(
    String name, double x1, double y1, double x2, double y2, Floor floor, int floorColour, int wallColour) {
  /** Patterns of floors. */
  public enum Floor {
    PLANK,
    TILE,
    CARPET
  }

  public boolean contains(double x, double y) {
    return x >= x1 && x < x2 && y >= y1 && y < y2;
  }

  public double centreX() {
    return (x1 + x2) / 2;
  }

  public double centreY() {
    return (y1 + y2) / 2;
  }
}
