package org.robotui.sim.internal.world;

import java.util.Arrays;

/** An occupancy grid in the order of ROS: row by row from the lowest y, in each row from the lowest x. Immutable. */
public final class GridMap {
  public static final byte FREE = 0;
  public static final byte OCCUPIED = 100;
  public static final byte UNKNOWN = -1;

  private final int width;
  private final int height;
  private final double resolution;
  private final double originX;
  private final double originY;
  private final byte[] cells;

  /**
   * @param resolution metres per cell
   * @param originX x of the lower left corner of cell 0, metres
   * @param originY as originX
   */
  public GridMap(int width, int height, double resolution, double originX, double originY, byte[] cells) {
    if (cells.length != width * height) {
      throw new IllegalArgumentException("a grid of " + width + " x " + height + " needs as many cells");
    }
    this.width = width;
    this.height = height;
    this.resolution = resolution;
    this.originX = originX;
    this.originY = originY;
    this.cells = cells.clone();
  }

  public int width() {
    return width;
  }

  public int height() {
    return height;
  }

  public double resolution() {
    return resolution;
  }

  public double originX() {
    return originX;
  }

  public double originY() {
    return originY;
  }

  /** A copy of all cells. */
  public byte[] cells() {
    return Arrays.copyOf(cells, cells.length);
  }

  public int column(double x) {
    return (int) Math.floor((x - originX) / resolution);
  }

  public int row(double y) {
    return (int) Math.floor((y - originY) / resolution);
  }

  public double centreX(int column) {
    return originX + (column + 0.5) * resolution;
  }

  public double centreY(int row) {
    return originY + (row + 0.5) * resolution;
  }

  /** The cell's value, UNKNOWN outside of the grid. */
  public byte at(int column, int row) {
    boolean inside = column >= 0 && column < width && row >= 0 && row < height;
    return inside ? cells[row * width + column] : UNKNOWN;
  }
}
