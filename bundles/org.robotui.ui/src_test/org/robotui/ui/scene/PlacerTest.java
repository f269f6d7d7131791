package org.robotui.ui.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.frame.Frames;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.TransformLookup;
import org.robotui.ui.scene.Placer.Placement;

class PlacerTest {
  private static final FrameId ODOM = new FrameId("Keira", "odom");
  private static final FrameId LASER = new FrameId("Keira", "laser");
  private static final long NEWEST = 5_000_000_000L;

  /** Knows one transform, up to a time. */
  private static final class Late implements Frames {
    @Override
    public TransformLookup<FrameId> lookup(FrameId target, FrameId source, Optional<Stamp> stamp) {
      if (!source.equals(LASER)) {
        return new TransformLookup.UnknownFrame<>(source);
      }
      return stamp.filter(s -> s.nanos() > NEWEST)
          .<TransformLookup<FrameId>>map(s -> new TransformLookup.TooNew<>(ODOM, LASER, NEWEST, s.nanos()))
          .orElse(new TransformLookup.Found<>(RigidTransform.planar(1, 2, 0), NEWEST));
    }

    @Override
    public List<FrameId> all() {
      return List.of(LASER, ODOM);
    }

    @Override
    public Optional<FrameId> parent(FrameId frame) {
      return frame.equals(LASER) ? Optional.of(ODOM) : Optional.empty();
    }
  }

  private final Placer placer = new Placer(new Late(), ODOM);

  @Test
  void theFixedFrameItselfNeedsNoTransform() {
    assertEquals(Optional.of(RigidTransform.IDENTITY), placer.latest(ODOM).found());
  }

  @Test
  void aTransformThatIsALittleLateIsTaken() {
    assertEquals(Optional.of(RigidTransform.planar(1, 2, 0)), placer.at(LASER, stamp(NEWEST + 200_000_000)).found());
  }

  @Test
  void oneThatIsTooLateIsMissingWithItsReason() {
    Placement.Missing missing =
        assertInstanceOf(Placement.Missing.class, placer.at(LASER, stamp(NEWEST + 3_000_000_000L)));
    assertTrue(missing.reason().startsWith("no transform odom \u2190 laser: "), missing.reason());
  }

  @Test
  void anUnknownFrameIsNamedWithoutTheRobotThatAllShare() {
    Placement.Missing missing =
        assertInstanceOf(Placement.Missing.class, placer.latest(new FrameId("Keira", "sonar")));
    assertTrue(missing.reason().startsWith("no transform odom \u2190 sonar: "), missing.reason());
    assertTrue(!missing.reason().contains("Keira"), missing.reason());
  }

  @Test
  void dataWithoutAFrameSaySo() {
    assertEquals(new Placement.Missing("the data name no frame"), placer.latest(new FrameId("Keira", "")));
  }

  private static Optional<Stamp> stamp(long nanos) {
    return Optional.of(new Stamp(nanos, ClockKind.ROBOT));
  }
}
