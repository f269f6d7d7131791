package org.robotui.gl.display;

import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.geometry.RigidTransform;

/**
 * Where one value lies. One that was measured at a time is placed once, by the transform of that time; until that is
 * known it is placed by the newest one, and says so where it is not about to come. Worker thread.
 */
public final class Anchor {
  /** Which transform counts. */
  public enum When {
    /** That of the time of measurement: a scan stays where it was made. */
    MEASURED,
    /** The newest: a map or a path moves with its frame. */
    NOW
  }

  /**
   * By which transforms may come behind what was measured, as those of robots that send their odometry ten times a
   * second: nobody needs to be told.
   */
  private static final long LAG_NANOS = 250_000_000;

  private final When when;
  private final FrameId frame;
  private final Optional<Stamp> stamp;
  private Optional<FrameId> fixed = Optional.empty();
  private Places.Place place = new Places.Place.Missing("not looked for yet");
  private Optional<String> guess = Optional.empty();
  private boolean exact;

  /**
   * Not placed yet.
   *
   * @param when which transform counts
   * @param frame of the value
   * @param stamp when it was measured
   */
  public Anchor(When when, FrameId frame, Optional<Stamp> stamp) {
    this.when = when;
    this.frame = frame;
    this.stamp = when == When.NOW ? Optional.empty() : stamp;
  }

  /**
   * Looks where it is; to be called each tick.
   *
   * @param places where frames are
   */
  public void update(Places places) {
    if (!settled(places)) {
      fixed = Optional.of(places.fixed());
      place = places.at(frame, stamp);
      guess = Optional.empty();
      exact = place.found().isPresent();
      if (place instanceof Places.Place.Missing missing && stamp.isPresent()) {
        place = places.at(frame, Optional.empty());
        guess = place.found().filter(any -> !isAboutToCome(places))
            .map(any -> "placed by the newest transform: " + missing.reason());
      }
    }
  }

  private boolean isAboutToCome(Places places) {
    return places.at(frame, stamp.map(s -> new Stamp(s.nanos() - LAG_NANOS, s.clock()))).found().isPresent();
  }

  /**
   * The place.
   *
   * @return fixed frame from the value's frame, or none
   */
  public Optional<RigidTransform> found() {
    return place.found();
  }

  /**
   * What is wrong with the place.
   *
   * @return no frame, or placed by another time's transform; nothing where all is well
   */
  public Optional<DisplayStatus> trouble() {
    return place instanceof Places.Place.Missing missing
        ? Optional.of(new DisplayStatus.NoFrame(missing.reason()))
        : guess.map(DisplayStatus.Partly::new);
  }

  private boolean settled(Places places) {
    boolean sameFixed = fixed.filter(places.fixed()::equals).isPresent();
    return when == When.MEASURED && stamp.isPresent() && sameFixed && exact;
  }
}
