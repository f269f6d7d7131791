package org.robotui.sim.internal.world;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;

/** Draws the map that a robot would have made of the building: what the laser meets, and where one can get to. */
public final class MapRasterizer {
  private static final double MARGIN = 0.6;

  private final World world;
  private final double resolution;
  private final double laserHeight;

  public MapRasterizer(World world, double resolution, double laserHeight) {
    this.world = world;
    this.resolution = resolution;
    this.laserHeight = laserHeight;
  }

  public GridMap rasterize() {
    double minX = world.rooms().stream().mapToDouble(Room::x1).min().orElse(0) - MARGIN;
    double minY = world.rooms().stream().mapToDouble(Room::y1).min().orElse(0) - MARGIN;
    double maxX = world.rooms().stream().mapToDouble(Room::x2).max().orElse(0) + MARGIN;
    double maxY = world.rooms().stream().mapToDouble(Room::y2).max().orElse(0) + MARGIN;
    int width = (int) Math.ceil((maxX - minX) / resolution - 1e-9);
    int height = (int) Math.ceil((maxY - minY) / resolution - 1e-9);
    byte[] cells = new byte[width * height];
    Arrays.fill(cells, GridMap.UNKNOWN);
    GridMap empty = new GridMap(width, height, resolution, minX, minY, cells);
    markOccupied(empty, cells);
    floodFree(empty, cells);
    return new GridMap(width, height, resolution, minX, minY, cells);
  }

  private void markOccupied(GridMap grid, byte[] cells) {
    for (int i = 0; i < cells.length; i++) {
      double x = grid.centreX(i % grid.width());
      double y = grid.centreY(i / grid.width());
      if (isSolid(x, y)) {
        cells[i] = GridMap.OCCUPIED;
      }
    }
  }

  /** Half a diagonal of a cell, so that a wall thinner than a cell still leaves an unbroken line. */
  private boolean isSolid(double x, double y) {
    double reach = resolution / 2;
    return world.solids().stream()
        .anyMatch(s -> s.covers(laserHeight) && s.isNear(x, y, reach) && s.distance(x, y) <= reach * 0.7);
  }

  private void floodFree(GridMap grid, byte[] cells) {
    Deque<Integer> open = new ArrayDeque<>();
    open.add(grid.row(world.start().y()) * grid.width() + grid.column(world.start().x()));
    while (!open.isEmpty()) {
      int cell = open.remove();
      if (cells[cell] != GridMap.UNKNOWN) {
        continue;
      }
      cells[cell] = GridMap.FREE;
      addNeighbours(grid, cell, open);
    }
  }

  private static void addNeighbours(GridMap grid, int cell, Deque<Integer> open) {
    int column = cell % grid.width();
    int row = cell / grid.width();
    if (column > 0) {
      open.add(cell - 1);
    }
    if (column < grid.width() - 1) {
      open.add(cell + 1);
    }
    if (row > 0) {
      open.add(cell - grid.width());
    }
    if (row < grid.height() - 1) {
      open.add(cell + grid.width());
    }
  }
}
