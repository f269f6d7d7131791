package org.robotui.player.interfaces;

import java.util.List;
import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** Maps: grids of cells, and lines. The interface {@code map}. */
public final class PlayerMap {

  /** Data: info. */
  public static final Kind.Data<Info> INFO = new Kind.Data<>("map", "info", Info.class);

  /** Request: get info; answered by {@link Info}. */
  public static final Kind.Request<Empty, Info> GET_INFO =
      new Kind.Request<>("map", "get_info", Empty.class, Info.class);

  /** Request: get tile with {@link Tile}; answered by {@link Tile}. */
  public static final Kind.Request<Tile, Tile> GET_TILE = new Kind.Request<>("map", "get_tile", Tile.class, Tile.class);

  /** Request: get vector; answered by {@link Vector}. */
  public static final Kind.Request<Empty, Vector> GET_VECTOR =
      new Kind.Request<>("map", "get_vector", Empty.class, Vector.class);

  private PlayerMap() {}

  /**
   * A grid's size.
   *
   * @param scale the side of a cell, metres
   * @param width cells along x
   * @param height cells along y
   * @param origin of the cell (0, 0)
   */
  public record Info(float scale, long width, long height, Pose2d origin) {}

  /**
   * A part of a grid.
   *
   * @param column its first column
   * @param row its first row
   * @param width cells along x
   * @param height cells along y
   * @param range cells are from -range for free, over 0 for unknown, to range for occupied
   * @param cells row by row from the first, as a zlib stream; empty in questions
   */
  public record Tile(long column, long row, long width, long height, int range, byte[] cells) {}

  /**
   * A map of lines, and its bounds.
   *
   * @param minX of all lines, metres
   * @param maxX of all lines, metres
   * @param minY of all lines, metres
   * @param maxY of all lines, metres
   * @param segments the lines
   */
  public record Vector(float minX, float maxX, float minY, float maxY, List<Segment> segments) {}
}
