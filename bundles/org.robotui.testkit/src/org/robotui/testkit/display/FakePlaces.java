package org.robotui.testkit.display;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.display.Places;

/** Frames where a test says they are, at all times; the fixed frame is {@code map}. For one thread. */
public final class FakePlaces implements Places {
  /** The robot whose frames they are. */
  public static final String ROBOT = "robot";

  private final Map<FrameId, RigidTransform> known = new LinkedHashMap<>();
  private FrameId fixed = frame("map");
  private boolean everywhere;

  /** Knows the fixed frame only. */
  public FakePlaces() {
    known.put(fixed, RigidTransform.IDENTITY);
  }

  /**
   * A frame of the robot.
   *
   * @param name of the frame
   * @return the frame
   */
  public static FrameId frame(String name) {
    return new FrameId(ROBOT, name);
  }

  /**
   * Says where a frame is.
   *
   * @param name of the frame
   * @param fixedFromFrame fixed frame from it
   */
  public void put(String name, RigidTransform fixedFromFrame) {
    known.put(frame(name), fixedFromFrame);
  }

  /**
   * Makes another frame the fixed one, without moving the others.
   *
   * @param name of the frame
   */
  public void fix(String name) {
    fixed = frame(name);
    known.put(fixed, RigidTransform.IDENTITY);
  }

  /** Puts every frame that no test put elsewhere where the fixed one is. */
  public void knowAll() {
    everywhere = true;
  }

  @Override
  public FrameId fixed() {
    return fixed;
  }

  @Override
  public Place at(FrameId frame, Optional<Stamp> stamp) {
    return Optional.ofNullable(known.get(frame))
        .or(() -> everywhere ? Optional.of(RigidTransform.IDENTITY) : Optional.empty())
        .<Place>map(Place.At::new)
        .orElseGet(() -> new Place.Missing("no transform leads from " + frame.name() + " to " + fixed.name()));
  }

  @Override
  public List<FrameId> all() {
    return List.copyOf(known.keySet());
  }

  @Override
  public Optional<FrameId> parent(FrameId frame) {
    return frame.equals(fixed) ? Optional.empty() : Optional.of(fixed);
  }
}
