package org.robotui.message.data;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.geometry.TransformSet;
import org.robotui.data.joint.JointState;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.sensor.Battery;
import org.robotui.message.data.DataMessages.Maker;
import org.robotui.message.ros.geometry_msgs.PoseStamped;
import org.robotui.message.ros.geometry_msgs.PoseWithCovariance;
import org.robotui.message.ros.geometry_msgs.Transform;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.geometry_msgs.TwistWithCovariance;
import org.robotui.message.ros.nav_msgs.MapMetaData;
import org.robotui.message.ros.nav_msgs.OccupancyGrid;
import org.robotui.message.ros.sensor_msgs.BatteryState;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.tf2_msgs.TFMessage;

/** What robots say of themselves and of where they are, as messages. */
final class StateMessages {
  private StateMessages() {}

  static List<Maker<?, ?>> all() {
    return List.of(
        Maker.of(Odometry.class, org.robotui.message.ros.nav_msgs.Odometry.class, StateMessages::odometry),
        Maker.of(StampedPose.class, PoseStamped.class,
            (p, at) -> new PoseStamped(SensorMessages.header(p.frame(), at), Geometry.pose(p.pose()))),
        Maker.of(GridMap.class, OccupancyGrid.class, StateMessages::map),
        Maker.of(Battery.class, BatteryState.class, StateMessages::battery),
        Maker.of(JointState.class, org.robotui.message.ros.sensor_msgs.JointState.class, StateMessages::joints),
        Maker.of(TransformSet.class, TFMessage.class,
            (set, at) -> new TFMessage(set.transforms().stream().map(StateMessages::transform).toList())));
  }

  private static org.robotui.message.ros.nav_msgs.Odometry odometry(Odometry o, long at) {
    Twist twist = new Twist(Geometry.vector(o.linear()), Geometry.vector(o.angular()));
    return new org.robotui.message.ros.nav_msgs.Odometry(SensorMessages.header(o.frame(), at), o.childFrame().name(),
        new PoseWithCovariance(Geometry.pose(o.pose()), CommandType.covariance(o.poseCovariance())),
        new TwistWithCovariance(twist, CommandType.covariance(o.twistCovariance())));
  }

  private static OccupancyGrid map(GridMap m, long at) {
    return new OccupancyGrid(SensorMessages.header(m.frame(), at),
        new MapMetaData(at, (float) m.resolution(), m.width(), m.height(), Geometry.pose(m.origin())),
        SensorMessages.bytes(m.cells()));
  }

  private static BatteryState battery(Battery b, long at) {
    float unknown = Float.NaN;
    return new BatteryState(new Header(0, at, ""), (float) b.voltage(), unknown, (float) b.current(), unknown, unknown,
        unknown, (float) b.charge(), b.status().ordinal(), 0, 0, true, new float[0], new float[0], "", "");
  }

  /** A quantity that no joint has is an empty list, by the convention of the message. */
  private static org.robotui.message.ros.sensor_msgs.JointState joints(JointState s, long at) {
    return new org.robotui.message.ros.sensor_msgs.JointState(new Header(0, at, ""),
        s.joints().stream().map(JointState.Joint::name).toList(), values(s, JointState.Joint::position),
        values(s, JointState.Joint::velocity), values(s, JointState.Joint::effort));
  }

  private static double[] values(JointState state, ToDoubleFunction<JointState.Joint> quantity) {
    double[] values = state.joints().stream().mapToDouble(quantity).toArray();
    return Arrays.stream(values).allMatch(Double::isNaN) ? new double[0] : values;
  }

  /** Transforms have stamps of their own. */
  private static TransformStamped transform(FrameTransform t) {
    org.robotui.message.ros.geometry_msgs.Pose pose = Geometry.pose(t.parentFromChild());
    return new TransformStamped(SensorMessages.header(t.parent(), t.stamp().nanos()), t.child().name(),
        new Transform(Geometry.vector(t.parentFromChild().translation()), pose.orientation()));
  }
}
