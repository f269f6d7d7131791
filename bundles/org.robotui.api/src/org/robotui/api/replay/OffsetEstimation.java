package org.robotui.api.replay;

import java.io.IOException;
import java.util.Optional;

/** Finds out how far the clocks of recordings are apart that are open. An OSGi service, safe for all threads. */
public interface OffsetEstimation {
  /**
   * Compares what two recordings hold. Reads both, which may take minutes; not for the display thread.
   *
   * @param reference whose times stay, with the offset that it has
   * @param moved whose times are to be moved
   * @return the offset that {@link Timeline#shift} takes for it; empty where they share no messages and nothing turned
   * alike in them
   * @throws IOException where a file cannot be read any more
   * @throws InterruptedException where the thread was interrupted
   * @throws IllegalArgumentException where one of them is not open any more
   */
  Optional<OffsetEstimate> estimate(TrackId reference, TrackId moved) throws IOException, InterruptedException;
}
