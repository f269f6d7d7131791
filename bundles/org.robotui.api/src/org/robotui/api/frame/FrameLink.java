package org.robotui.api.frame;

import java.util.List;
import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;

/**
 * What is known of the transform that carries a frame.
 *
 * @param parent the frame that carries
 * @param child the frame that is carried
 * @param fixed whether it holds for all times
 * @param newest stamp of the newest one; none where it is fixed
 * @param heldSeconds how far back it can be asked for, seconds; 0 where it is fixed
 * @param samples how many are held
 * @param authority who sent the newest one
 * @param receivedNanos {@link System#nanoTime()} when the newest one came
 * @param rateHz how many came a second lately; 0 where it is fixed, where one came only, or where they ceased
 * @param rivals who else lately said where the frame is, so that it may jump between them
 */
public record FrameLink(
    FrameId parent,
    FrameId child,
    boolean fixed,
    Optional<Stamp> newest,
    double heldSeconds,
    int samples,
    String authority,
    long receivedNanos,
    double rateHz,
    List<Rival> rivals) {
  /**
   * Copies the list.
   *
   * @param parent the frame that carries
   * @param child the frame that is carried
   * @param fixed for all times
   * @param newest stamp of the newest one
   * @param heldSeconds how far back
   * @param samples how many
   * @param authority who sent it
   * @param receivedNanos when it came
   * @param rateHz how many a second
   * @param rivals who else says it
   */
  public FrameLink {
    rivals = List.copyOf(rivals);
  }

  /**
   * Somebody else who says where the same frame is.
   *
   * @param authority who
   * @param parent in which frame
   */
  public record Rival(String authority, FrameId parent) {}
}
