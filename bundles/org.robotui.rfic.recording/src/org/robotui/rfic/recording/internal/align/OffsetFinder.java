package org.robotui.rfic.recording.internal.align;

import java.io.IOException;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.robotui.api.replay.OffsetEstimate;
import org.robotui.rfic.recording.internal.time.SearchableHistory;

/** Finds out how far the clocks of two recordings are apart. */
public final class OffsetFinder {
  private OffsetFinder() {}

  /**
   * By messages that both have; where they share too few, by what turned as fast.
   *
   * @param reference whose times stay
   * @param moved whose times are to be moved
   * @return what is to be added to the times of its file; empty where it cannot be told
   * @throws IOException where a file cannot be read any more
   * @throws InterruptedException where the thread was interrupted
   */
  public static Optional<OffsetEstimate> offset(SearchableHistory reference, SearchableHistory moved)
      throws IOException, InterruptedException {
    Optional<OffsetEstimate> shared = SharedMessages.offset(reference, moved);
    return shared.isPresent() ? shared : byMotion(TurningRates.of(reference), TurningRates.of(moved));
  }

  private static Optional<OffsetEstimate> byMotion(List<TurningRates.Rate> reference,
      List<TurningRates.Rate> moved) {
    return reference.stream().flatMap(one -> moved.stream().flatMap(other -> MotionDelay.offset(one, other).stream()))
        .min(Comparator.comparingLong(OffsetEstimate::deviation));
  }
}
