package org.robotui.ui.scene;

import java.util.Optional;
import org.robotui.api.frame.Frames;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.TransformLookup;

/** Finds where data lies in the fixed frame. */
public final class Placer {
  /**
   * A transform that is this much off in time is better than none: transforms are often sent a little after the data.
   */
  private static final long TOLERANCE_NANOS = 1_000_000_000L;

  private final Frames frames;
  private final FrameId fixed;

  /**
   * Places things in a frame.
   *
   * @param frames what is known
   * @param fixed the frame that things are shown in
   */
  public Placer(Frames frames, FrameId fixed) {
    this.frames = frames;
    this.fixed = fixed;
  }

  /** Where something is, or why that is not known. */
  public sealed interface Placement {
    /**
     * Known.
     *
     * @param transform fixed from source
     */
    record At(RigidTransform transform) implements Placement {}

    /**
     * Not known.
     *
     * @param reason a sentence that names the missing link
     */
    record Missing(String reason) implements Placement {}

    /**
     * The transform, where it is known.
     *
     * @return fixed from source
     */
    default Optional<RigidTransform> found() {
      return this instanceof At at ? Optional.of(at.transform()) : Optional.empty();
    }
  }

  /**
   * The frame that things are shown in.
   *
   * @return the fixed frame
   */
  public FrameId fixed() {
    return fixed;
  }

  /**
   * At the time of a measurement, or near it.
   *
   * @param source the frame of the data
   * @param stamp when; empty for the newest time known
   * @return the place, or why there is none
   */
  public Placement at(FrameId source, Optional<Stamp> stamp) {
    if (source.equals(fixed)) {
      return new Placement.At(RigidTransform.IDENTITY);
    }
    if (source.name().isEmpty()) {
      return new Placement.Missing("the data name no frame");
    }
    TransformLookup<FrameId> then = frames.lookup(fixed, source, stamp);
    if (stamp.isPresent() && then.transform().isEmpty() && nearly(then)) {
      return placement(source, frames.lookup(fixed, source, Optional.empty()));
    }
    return placement(source, then);
  }

  /**
   * Now, for what does not move of itself.
   *
   * @param source the frame of the data
   * @return the place, or why there is none
   */
  public Placement latest(FrameId source) {
    return at(source, Optional.empty());
  }

  private static boolean nearly(TransformLookup<FrameId> lookup) {
    return switch (lookup) {
      case TransformLookup.TooNew<FrameId> t -> t.askedNanos() - t.newestNanos() <= TOLERANCE_NANOS;
      case TransformLookup.TooOld<FrameId> t -> t.oldestNanos() - t.askedNanos() <= TOLERANCE_NANOS;
      default -> false;
    };
  }

  private Placement placement(FrameId source, TransformLookup<FrameId> lookup) {
    return lookup.transform()
        .<Placement>map(Placement.At::new)
        .orElseGet(() -> new Placement.Missing(reason(source, lookup.explanation())));
  }

  private String reason(FrameId source, String explanation) {
    boolean sameRobot = source.robot().equals(fixed.robot());
    String from = sameRobot ? source.name() : source.toString();
    String why = sameRobot ? explanation.replace(fixed.robot() + ":", "") : explanation;
    return "no transform " + fixed.name() + " \u2190 " + from + ": " + why;
  }
}
