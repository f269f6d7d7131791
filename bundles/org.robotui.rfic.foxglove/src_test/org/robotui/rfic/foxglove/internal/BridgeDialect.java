package org.robotui.rfic.foxglove.internal;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.message.Generation;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageException;
import org.robotui.message.MessageRegistry;
import org.robotui.message.MessageSchema;
import org.robotui.message.RecordBinding;
import org.robotui.message.SchemaLookup;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.PoseWithCovariance;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.geometry_msgs.TwistWithCovariance;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.testkit.rfic.Sample;

/** As a bridge to ROS speaks: messages of ROS with their definitions, and who subscribes to what. */
record BridgeDialect(Generation generation) implements Dialect {
  private static final Stamp STAMP = Stamp.of(1_700_000_000L, 500, ClockKind.ROBOT);
  private static final Sample POSE = new Sample("odom",
      new Odometry(new FrameId("robby", "odom"), new FrameId("robby", "base_link"),
          new RigidTransform(new Vector3(1, -2, 3), org.robotui.geometry.Quaternion.fromYaw(0.5)),
          Doubles.wrap(covariance(0.25)), new Vector3(0.3, 0.1, 0.2), new Vector3(0.4, 0.5, -0.2),
          Doubles.wrap(covariance(0.5))),
      Optional.of(STAMP));
  private static final Sample SCAN = new Sample("scan",
      new LaserScan(new FrameId("robby", "laser"), -1, 1, 0.1, 30, 0.05,
          Floats.of(1, Float.NaN, Float.POSITIVE_INFINITY), Floats.EMPTY),
      Optional.of(STAMP));

  private static double[] covariance(double first) {
    double[] numbers = new double[Odometry.COVARIANCE_SIZE];
    numbers[0] = first;
    return numbers;
  }

  private boolean second() {
    return generation == Generation.ROS2;
  }

  private String encoding() {
    return second() ? "cdr" : "ros1";
  }

  @Override
  public List<String> capabilities() {
    return List.of("clientPublish", "connectionGraph", "parameters", "services");
  }

  @Override
  public List<String> encodings() {
    return List.of(encoding());
  }

  @Override
  public void offer(FoxgloveServer server) {
    offer(server, 0, "/odom", "nav_msgs/Odometry");
    offer(server, 1, "/scan", "sensor_msgs/LaserScan");
  }

  private void offer(FoxgloveServer server, long id, String topic, String type) {
    server.channel(id, topic, encoding(), second() ? type.replace("/", "/msg/") : type,
        second() ? "ros2msg" : "ros1msg", definition(type));
  }

  String definition(String type) {
    MessageRegistry known = new MessageRegistry(new LocalDefinitions(List.of(), List.of(), generation), generation);
    return ((SchemaLookup.Found<MessageSchema>) known.message(type)).schema().info().definition();
  }

  @Override
  public List<Sample> samples() {
    return List.of(POSE, SCAN);
  }

  @Override
  public ByteBuffer message(int channel) {
    return channel == 0 ? encoded(pose())
        : encoded(new org.robotui.message.ros.sensor_msgs.LaserScan(
            new Header(0, STAMP.nanos(), "laser"), -1, 1, 1, 0, 0.05f, 0.1f, 30,
            new float[]{1, Float.NaN, Float.POSITIVE_INFINITY}, new float[0]));
  }

  @SuppressWarnings("unchecked") // of the class of the message
  private <M extends Record> ByteBuffer encoded(M message) {
    return RecordBinding.shipped((Class<M>) message.getClass(), generation).encode(message);
  }

  private static org.robotui.message.ros.nav_msgs.Odometry pose() {
    Pose pose = new Pose(new Point(1, -2, 3), new Quaternion(0, 0, Math.sin(0.25), Math.cos(0.25)));
    Twist twist = new Twist(new org.robotui.message.ros.geometry_msgs.Vector3(0.3, 0.1, 0.2),
        new org.robotui.message.ros.geometry_msgs.Vector3(0.4, 0.5, -0.2));
    return new org.robotui.message.ros.nav_msgs.Odometry(new Header(0, STAMP.nanos(), "odom"), "base_link",
        new PoseWithCovariance(pose, covariance(0.25)), new TwistWithCovariance(twist, covariance(0.5)));
  }

  @Override
  public Data heard(FoxgloveServer.Said said) {
    if (!said.encoding().equals(encoding()) || !Generation.plainName(said.type()).equals("geometry_msgs/Twist")) {
      throw new IllegalStateException("a message nobody announced: " + said);
    }
    try {
      Twist twist = RecordBinding.shipped(Twist.class, generation).decode(said.payload());
      return new VelocityCommand(vector(twist.linear()), vector(twist.angular()));
    } catch (MessageException e) {
      throw new IllegalStateException(e);
    }
  }

  private static Vector3 vector(org.robotui.message.ros.geometry_msgs.Vector3 v) {
    return new Vector3(v.x(), v.y(), v.z());
  }
}
