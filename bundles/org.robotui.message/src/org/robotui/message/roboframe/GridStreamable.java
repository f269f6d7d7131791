package org.robotui.message.roboframe;

import java.nio.ByteBuffer;
import org.robotui.message.MessageType;

/**
 * A map of cells ({@code roboframe/Grid}).
 *
 * @param stamp when it was made, nanoseconds by the clock of the application
 * @param frame the frame
 * @param resolution side of a cell, metres
 * @param width cells in a row
 * @param height rows
 * @param x where the first cell has its corner, metres in the frame
 * @param y likewise
 * @param cells row by row: 0 is free, 100 occupied, -1 not known
 */
@MessageType("roboframe/Grid")
public record GridStreamable(long stamp, String frame, double resolution, long width, long height, double x, double y,
    ByteBuffer cells) {
  /** Keeps a read-only view of the bytes. */
  public GridStreamable {
    cells = cells.slice().asReadOnlyBuffer();
  }

  /**
   * The bytes, without a copy.
   *
   * @return a fresh read-only view
   */
  @Override
  public ByteBuffer cells() {
    return cells.duplicate();
  }
}
