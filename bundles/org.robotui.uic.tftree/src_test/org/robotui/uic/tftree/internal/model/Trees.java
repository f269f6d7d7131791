package org.robotui.uic.tftree.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.api.frame.FrameLink;
import org.robotui.api.frame.FrameRefusal;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.geometry.RigidTransform;
import org.robotui.testkit.FakeFrames;

/** Frames for tests and pictures. Now is 100 s. */
public final class Trees {
  public static final long NOW = 100_000_000_000L;

  private static final RigidTransform STEP = RigidTransform.planar(1, 0.5, 0.3);

  private Trees() {}

  public static FrameId id(String name) {
    return new FrameId("Keira", name);
  }

  public static FrameLink moving(String parent, String child, double rate, double age, String authority,
      FrameLink.Rival... rivals) {
    return new FrameLink(id(parent), id(child), false, Optional.of(Stamp.of(1_700_000_000, 0, ClockKind.ROBOT)), 10,
        (int) (rate * 10), authority,
        NOW - (long) (age * 1e9), rate, List.of(rivals));
  }

  public static FrameLink fixed(String parent, String child) {
    return new FrameLink(id(parent), id(child), true, Optional.empty(), 0, 1, "/robot_state_publisher", 0, 0,
        List.of());
  }

  /** A mobile base as many are. */
  public static List<FrameLink> base() {
    return List.of(moving("map", "odom", 10, 0.04, "/amcl"),
        moving("odom", "base_footprint", 50, 0.012, "/base_driver"),
        fixed("base_footprint", "base_link"), fixed("base_link", "laser"), fixed("base_link", "imu_link"),
        fixed("base_link", "camera_link"),
        fixed("camera_link", "camera_color_frame"), fixed("camera_color_frame", "camera_color_optical_frame"),
        fixed("camera_link", "camera_depth_frame"), fixed("camera_depth_frame", "camera_depth_optical_frame"),
        moving("base_link", "wheel_left_link", 30, 0.02, "/robot_state_publisher"),
        moving("base_link", "wheel_right_link", 30, 0.02, "/robot_state_publisher"));
  }

  /** With all that can be wrong. */
  public static List<FrameLink> faulty() {
    List<FrameLink> links = new ArrayList<>(base());
    links.set(0, moving("map", "odom", 0, 12.4, "/amcl"));
    links.set(1, moving("odom", "base_footprint", 50, 0.012, "/base_driver", new FrameLink.Rival("/ekf", id("odom"))));
    links.add(moving("world", "marker_17", 5, 0.1, "/apriltag"));
    return links;
  }

  public static FrameRefusal refusal() {
    return new FrameRefusal(
        "the transform 'Keira:laser' -> 'Keira:map' would close a loop: 'Keira:laser' is below 'Keira:map'",
        "/static_tf_7", 12, NOW);
  }

  /** Frames that say this of themselves, and can be looked up. */
  public static FakeFrames frames(List<FrameLink> links, FrameRefusal... refusals) {
    FakeFrames frames = new FakeFrames();
    links.forEach(link -> frames.fix(link.parent(), link.child(), STEP));
    frames.known(links, List.of(refusals));
    return frames;
  }

  /** As large as it gets: a chain of arms, each with many fingers. */
  public static List<FrameLink> many(int count) {
    List<FrameLink> links = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      links.add(
          i % 10 == 0 ? moving("world", "arm_" + i, 100, 0.01, "/arms") : fixed("arm_" + (i - i % 10), "finger_" + i));
    }
    return links;
  }
}
