package org.robotui.rfic.player.internal.device;

import java.util.function.Function;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.player.interfaces.Pose3d;
import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;
import org.robotui.rfic.player.internal.convert.Poses;

/**
 * Where devices are on the robot. One that does not tell is taken to be in the middle of the base, as Player's other
 * clients do.
 */
final class Mount {
  private Mount() {}

  static <G> FrameId of(DeviceFeed feed, Kind.Request<Empty, G> geometry, Function<G, Pose3d> pose) {
    FrameTree tree = feed.around().tree();
    FrameId frame = tree.names().device(feed.name());
    feed.onOpen(() -> feed.ask(geometry, g -> tree.mounted(frame, Poses.mounted(pose.apply(g)), feed.name()),
        reason -> tree.mounted(frame, RigidTransform.IDENTITY, feed.name())));
    return frame;
  }

  /** For interfaces that cannot be asked. */
  static FrameId inTheMiddle(DeviceFeed feed) {
    FrameTree tree = feed.around().tree();
    FrameId frame = tree.names().device(feed.name());
    feed.onOpen(() -> tree.mounted(frame, RigidTransform.IDENTITY, feed.name()));
    return frame;
  }
}
