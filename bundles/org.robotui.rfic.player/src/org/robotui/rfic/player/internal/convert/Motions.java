package org.robotui.rfic.player.internal.convert;

import java.util.List;
import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.Footprint;
import org.robotui.data.navigation.Odometry;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.player.interfaces.Body;
import org.robotui.player.interfaces.Pose2d;
import org.robotui.player.interfaces.Pose3d;
import org.robotui.player.interfaces.Position2d;
import org.robotui.player.interfaces.Position3d;

/** Where a base is, how it moves, and how large it is. */
public final class Motions {
  private Motions() {}

  public static Odometry odometry(Position2d.State m, FrameId frame, FrameId child) {
    Pose2d v = m.velocity();
    return new Odometry(frame, child, Poses.of(m.position()), Doubles.EMPTY,
        Poses.finite(new Vector3(v.x(), v.y(), 0), "velocity"),
        Poses.finite(new Vector3(0, 0, v.yaw()), "velocity"), Doubles.EMPTY);
  }

  public static Odometry odometry(Position3d.State m, FrameId frame, FrameId child) {
    return new Odometry(frame, child, Poses.of(m.position()), Doubles.EMPTY,
        Poses.finite(Poses.position(m.velocity()), "velocity"), Poses.finite(Poses.angles(m.velocity()), "velocity"),
        Doubles.EMPTY);
  }

  /** The rectangle around a body; none where the device does not tell its size. */
  public static Optional<Footprint> footprint(Body body, FrameId base) {
    double x = Poses.sane(body.size().length()) / 2;
    double y = Poses.sane(body.size().width()) / 2;
    if (x <= 0 || y <= 0) {
      return Optional.empty();
    }
    RigidTransform middle = Poses.mounted(body.pose());
    return Optional.of(new Footprint(base, List.of(new Vector3(x, y, 0), new Vector3(-x, y, 0), new Vector3(-x, -y, 0),
        new Vector3(x, -y, 0)).stream().map(middle::apply).toList()));
  }

  /** The motors stay on: a stop must not let a robot roll down a ramp, and Player's other clients say the same. */
  public static Position2d.Velocity planar(VelocityCommand c) {
    return new Position2d.Velocity(new Pose2d(c.linear().x(), c.linear().y(), c.angular().z()), true);
  }

  public static Position3d.Velocity spatial(VelocityCommand c) {
    return new Position3d.Velocity(
        new Pose3d(c.linear().x(), c.linear().y(), c.linear().z(), c.angular().x(), c.angular().y(),
            c.angular().z()),
        true);
  }
}
