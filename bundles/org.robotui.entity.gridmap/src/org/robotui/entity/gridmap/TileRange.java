package org.robotui.entity.gridmap;

import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.scene.Bounds;

/**
 * The tiles of a level that may be seen; empty where last is before first.
 *
 * @param firstColumn along x
 * @param lastColumn along x
 * @param firstRow along y
 * @param lastRow along y
 */
record TileRange(int firstColumn, int lastColumn, int firstRow, int lastRow) {
  static TileRange seen(Pyramid pyramid, int index, RigidTransform fixedFromGrid, Bounds window) {
    RigidTransform gridFromFixed = fixedFromGrid.inverse();
    Bounds inGrid = at(gridFromFixed, window.minX(), window.minY())
        .union(at(gridFromFixed, window.maxX(), window.minY()))
        .union(at(gridFromFixed, window.minX(), window.maxY()))
        .union(at(gridFromFixed, window.maxX(), window.maxY()));
    Level level = pyramid.levels().get(index);
    double tile = pyramid.map().resolution() * level.factor() * TilePainter.EDGE;
    return new TileRange(
        first(inGrid.minX() / tile),
        last(inGrid.maxX() / tile, level.width()),
        first(inGrid.minY() / tile),
        last(inGrid.maxY() / tile, level.height()));
  }

  private static int first(double tiles) {
    return (int) Math.max(0, Math.floor(tiles));
  }

  private static int last(double tiles, int cells) {
    int count = (cells + TilePainter.EDGE - 1) / TilePainter.EDGE;
    return (int) Math.min(count - 1.0, Math.floor(tiles));
  }

  private static Bounds at(RigidTransform gridFromFixed, double x, double y) {
    Vector3 p = gridFromFixed.apply(new Vector3(x, y, 0));
    return Bounds.around(p.x(), p.y(), 0);
  }
}
