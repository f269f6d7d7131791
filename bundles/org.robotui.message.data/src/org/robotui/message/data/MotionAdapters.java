package org.robotui.message.data;

import java.util.List;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.Footprint;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.Path;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.geometry.Vector3;
import org.robotui.message.ros.geometry_msgs.PolygonStamped;
import org.robotui.message.ros.geometry_msgs.PoseStamped;
import org.robotui.message.ros.geometry_msgs.PoseWithCovarianceStamped;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.geometry_msgs.TwistStamped;
import org.robotui.message.ros.nav_msgs.OccupancyGrid;

/** Where a robot is, how it moves, and maps. */
final class MotionAdapters {
  private MotionAdapters() {}

  static List<Adapter<?, ?>> all() {
    return List.of(
        Adapter.of(org.robotui.message.ros.nav_msgs.Odometry.class, Odometry.class,
            MotionAdapters::odometry, m -> m.header().stamp()),
        Adapter.of(org.robotui.message.ros.nav_msgs.Path.class, Path.class, MotionAdapters::path,
            m -> m.header().stamp()),
        Adapter.of(OccupancyGrid.class, GridMap.class, MotionAdapters::map,
            m -> m.header().stamp()),
        Adapter.of(PoseStamped.class, StampedPose.class,
            (m, names) -> new StampedPose(names.frame(m.header().frameId()), Geometry.transform(m.pose())),
            m -> m.header().stamp()),
        Adapter.of(PoseWithCovarianceStamped.class, PoseEstimate.class,
            MotionAdapters::estimate, m -> m.header().stamp()),
        Adapter.of(Twist.class, VelocityCommand.class, (m, names) -> velocity(m), m -> 0),
        Adapter.of(TwistStamped.class, VelocityCommand.class,
            (m, names) -> velocity(m.twist()), m -> m.header().stamp()),
        Adapter.of(PolygonStamped.class, Footprint.class, MotionAdapters::footprint,
            m -> m.header().stamp()));
  }

  private static Odometry odometry(org.robotui.message.ros.nav_msgs.Odometry m, FrameNames names) {
    Twist twist = m.twist().twist();
    return new Odometry(names.frame(m.header().frameId()), names.frame(m.childFrameId()),
        Geometry.transform(m.pose().pose()), Doubles.wrap(m.pose().covariance()), Geometry.vector(twist.linear()),
        Geometry.vector(twist.angular()), Doubles.wrap(m.twist().covariance()));
  }

  private static Path path(org.robotui.message.ros.nav_msgs.Path m, FrameNames names) {
    return new Path(names.frame(m.header().frameId()),
        m.poses().stream().map(p -> Geometry.transform(p.pose())).toList());
  }

  private static GridMap map(OccupancyGrid m, FrameNames names) {
    return new GridMap(names.frame(m.header().frameId()), m.info().resolution(), Sizes.of("width", m.info().width()),
        Sizes.of("height", m.info().height()), Geometry.transform(m.info().origin()), Bytes.wrap(m.data()));
  }

  private static PoseEstimate estimate(PoseWithCovarianceStamped m, FrameNames names) {
    return new PoseEstimate(names.frame(m.header().frameId()), Geometry.transform(m.pose().pose()),
        Doubles.wrap(m.pose().covariance()));
  }

  private static VelocityCommand velocity(Twist m) {
    return new VelocityCommand(Geometry.vector(m.linear()), Geometry.vector(m.angular()));
  }

  private static Footprint footprint(PolygonStamped m, FrameNames names) {
    List<Vector3> corners = m.polygon().points().stream().map(p -> new Vector3(p.x(), p.y(), p.z())).toList();
    return new Footprint(names.frame(m.header().frameId()), corners);
  }
}
