package org.robotui.data.navigation;

import org.robotui.data.Data;
import org.robotui.data.Delivery;
import org.robotui.data.FrameId;
import org.robotui.data.InFrame;
import org.robotui.data.array.Bytes;
import org.robotui.data.internal.Check;
import org.robotui.geometry.RigidTransform;

/**
 * A map of square cells.
 *
 * @param frame frame of the map
 * @param resolution edge of a cell, metres
 * @param width cells along x
 * @param height cells along y
 * @param origin frame from map: where the outer corner of cell (0, 0) lies, and how the grid is turned
 * @param cells row by row from the origin, x fastest: occupancy 0 to 100 percent, -1 unknown
 */
@Delivery(expires = false)
public record GridMap(FrameId frame, double resolution, int width, int height, RigidTransform origin, Bytes cells)
    implements Data, InFrame {
  /** The value of a cell of which nothing is known. */
  public static final byte UNKNOWN = -1;

  private static final double FINEST = 1e-6;
  private static final double COARSEST = 1e6;

  /**
   * Checks the sizes and the origin.
   *
   * @param frame the frame
   * @param resolution metres
   * @param width cells
   * @param height cells
   * @param origin the pose of cell (0, 0)
   * @param cells width times height of them
   */
  public GridMap {
    Check.within(resolution, FINEST, COARSEST, "resolution");
    Check.notNegative(width, "width");
    Check.notNegative(height, "height");
    Check.that((long) width * height == cells.size(), "cells",
        "must be " + width + " x " + height + ", are " + cells.size());
    Check.that(Math.max(width, height) * resolution <= Check.FARTHEST, "size",
        "must be within " + Check.FARTHEST + " m, is " + width * resolution + " x " + height * resolution);
    Check.pose(origin, "origin");
  }

  /**
   * The occupancy of a cell.
   *
   * @param column along x from 0
   * @param row along y from 0
   * @return 0 to 100, or {@link #UNKNOWN}
   */
  public byte cell(int column, int row) {
    return cells.get(row * width + column);
  }
}
