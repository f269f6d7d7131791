package org.robotui.sim.internal.world;

import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;

/** Small buildings whose measures are easy to see. */
public final class TestWorlds {
  private TestWorlds() {}

  /** A room of 10 x 6 m with red walls 0.2 m thick: inner faces at 0.1, 9.9 and 0.1, 5.9; the robot in the middle. */
  public static World room() {
    return of(
        """
        room hall 0 0 10 6 tile 808080 c04040
        wall 0 0 10 0 0.2
        wall 0 6 10 6 0.2
        wall 0 0 0 6 0.2
        wall 10 0 10 6 0.2
        start 5 3 0
        """);
  }

  public static World of(String plan) {
    try {
      return new World(FloorPlanReader.read(new StringReader(plan)));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
