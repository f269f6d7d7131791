package org.robotui.rfic.ros.internal;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.command.Motion;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.RigidTransform;
import org.robotui.guard.Guards;
import org.robotui.message.RawCodec;
import org.robotui.message.RawMessage;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.PoseWithCovariance;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.geometry_msgs.TwistWithCovariance;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.net.socket.HostPort;
import org.robotui.rfic.ros.internal.graph.SharedMasters;
import org.robotui.ros.GraphName;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosEnvironment;
import org.robotui.ros.RosNode;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.SystemState;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.internal.xmlrpc.XmlRpcClient;
import org.robotui.ros.internal.xmlrpc.XmlRpcFault;
import org.robotui.ros.internal.xmlrpc.XmlRpcLimits;
import org.robotui.ros.master.MasterOptions;
import org.robotui.ros.master.RosMaster;
import org.robotui.testkit.rfic.Capability;
import org.robotui.testkit.rfic.Gate;
import org.robotui.testkit.rfic.Peer;
import org.robotui.testkit.rfic.Sample;

/**
 * A base with a laser on a master of its own, which is behind a gate. Nodes speak to each other without the master:
 * what hangs is the master, and a second node that says that it publishes the odometry and then takes calls without an
 * answer.
 */
final class RosPeer implements Peer {
  private static final Duration PATIENCE = Duration.ofSeconds(60);
  private static final Stamp STAMP = Stamp.of(1_700_000_000L, 500, ClockKind.ROBOT);
  private static final Sample POSE = new Sample("odom",
      new Odometry(new FrameId("robby", "odom"), new FrameId("robby", "base_link"),
          new RigidTransform(new org.robotui.geometry.Vector3(1, -2, 3), org.robotui.geometry.Quaternion.fromYaw(0.5)),
          Doubles.wrap(covariance(0.25)),
          new org.robotui.geometry.Vector3(0.3, 0.1, 0.2), new org.robotui.geometry.Vector3(0.4, 0.5, -0.2),
          Doubles.wrap(covariance(0.5))),
      Optional.of(STAMP));
  private static final Sample SCAN = new Sample("scan",
      new LaserScan(new FrameId("robby", "laser"), -1, 1, 0.1, 30, 0.05,
          Floats.of(1, Float.NaN, Float.POSITIVE_INFINITY),
          Floats.EMPTY),
      Optional.of(STAMP));
  private static final VelocityCommand MOTION =
      new VelocityCommand(new org.robotui.geometry.Vector3(0.3, 0.1, 0.2),
          new org.robotui.geometry.Vector3(0.4, 0.5, -0.2));
  private static final Set<String> MASTERS_OWN = Set.of("/rosout");

  private final List<Data> heard = new CopyOnWriteArrayList<>();
  private final Gate gate;
  private final boolean guard;
  private Optional<Running> running = Optional.empty();

  /** What is there between a start and its end. */
  private record Running(RosMaster master, RosNode node, Publisher<org.robotui.message.ros.nav_msgs.Odometry> poses,
      Publisher<org.robotui.message.ros.sensor_msgs.LaserScan> scans, ServerSocket mute) {
    Publisher<?> publisher(Sample sample) {
      return sample.equals(POSE) ? poses : scans;
    }

    XmlRpcValue tellMaster(String method, String... arguments) {
      List<XmlRpcValue> values = Stream.of(arguments).map(XmlRpcValue::of).toList();
      try (XmlRpcClient client =
          new XmlRpcClient(HostPort.ofUri(master.uri().toString(), "http"), XmlRpcLimits.standard())) {
        return client.call(method, values);
      } catch (IOException | XmlRpcFault e) {
        throw new IllegalStateException(e);
      }
    }

    String muteUri() {
      return "http://127.0.0.1:" + mute.getLocalPort() + "/";
    }
  }

  RosPeer(boolean guard) {
    this.guard = guard;
    try {
      gate = new Gate();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static double[] covariance(double first) {
    double[] numbers = new double[Odometry.COVARIANCE_SIZE];
    numbers[0] = first;
    return numbers;
  }

  @Override
  public Map<Capability, String> lacks() {
    return Map.of();
  }

  @Override
  public Rfic create(RficContext context) {
    return new RosRfic(context,
        RosRficCase.settings(Map.of("master", "http://127.0.0.1:" + gate.port(), "guard", guard)), new SharedMasters(),
        new Guards());
  }

  @Override
  public void start() throws IOException {
    RosMaster master = RosMaster.open(MasterOptions.standard(THREADS));
    RosNode node = node(master, "robot");
    running = Optional.of(new Running(master, node,
        node.publisher("/odom", RecordCodec.of(org.robotui.message.ros.nav_msgs.Odometry.class),
            PublisherOptions.standard()),
        node.publisher("/scan", RecordCodec.of(org.robotui.message.ros.sensor_msgs.LaserScan.class),
            PublisherOptions.standard()),
        new ServerSocket(0, 50, InetAddress.getLoopbackAddress())));
    node.subscriber("/cmd_vel", RecordCodec.of(Twist.class), SubscriberOptions.standard(),
        (t, r) -> heard.add(new VelocityCommand(vector(t.linear()), vector(t.angular()))));
    if (!node.awaitRegistered(PATIENCE)) {
      throw new IOException("the robot's node does not get registered");
    }
    gate.open(URI.create(master.uri().toString()).getPort());
  }

  private static RosNode node(RosMaster master, String name) throws IOException {
    return RosNode.open(RosEnvironment.of(URI.create(master.uri().toString())), GraphName.of(name),
        NodeOptions.standard(THREADS));
  }

  private static org.robotui.geometry.Vector3 vector(Vector3 v) {
    return new org.robotui.geometry.Vector3(v.x(), v.y(), v.z());
  }

  @Override
  public void kill() {
    gate.shut();
    running.ifPresent(r -> {
      r.master().close();
      r.node().close();
      close(r.mute());
    });
    running = Optional.empty();
  }

  private static void close(ServerSocket socket) {
    try {
      socket.close();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void hang() {
    running.ifPresent(r -> r.tellMaster("registerPublisher", "/mute", "/odom", "nav_msgs/Odometry", r.muteUri()));
    gate.hold();
  }

  @Override
  public void goOn() {
    running.ifPresent(r -> r.tellMaster("unregisterPublisher", "/mute", "/odom", r.muteUri()));
    gate.goOn();
  }

  @Override
  public void garble() throws IOException {
    RawCodec broken = new RawCodec(RecordCodec.of(org.robotui.message.ros.sensor_msgs.LaserScan.class).info());
    try (RosNode mad = node(running.orElseThrow().master(), "mad")) {
      Publisher<RawMessage> scans = mad.publisher("/scan", broken, PublisherOptions.standard());
      RosRficCase.await(() -> scans.numSubscribers() > 0);
      scans.publish(new RawMessage(broken.info(), ByteBuffer.wrap(new byte[]{1, 2, 3})));
      RosRficCase.await(() -> scans.numSubscribers() == 0);
    }
  }

  @Override
  public List<Sample> samples() {
    return List.of(POSE, SCAN);
  }

  @Override
  public void say(Sample sample) {
    if (sample.equals(POSE)) {
      running.ifPresent(r -> r.poses().publish(pose()));
    } else {
      running.ifPresent(r -> r.scans()
          .publish(new org.robotui.message.ros.sensor_msgs.LaserScan(new Header(0, STAMP.nanos(), "/laser"), -1, 1, 1,
              0, 0.05f,
              0.1f, 30, new float[]{1, Float.NaN, Float.POSITIVE_INFINITY}, new float[0])));
    }
  }

  private static org.robotui.message.ros.nav_msgs.Odometry pose() {
    Pose pose = new Pose(new Point(1, -2, 3), new Quaternion(0, 0, Math.sin(0.25), Math.cos(0.25)));
    Twist twist = new Twist(new Vector3(0.3, 0.1, 0.2), new Vector3(0.4, 0.5, -0.2));
    return new org.robotui.message.ros.nav_msgs.Odometry(new Header(0, STAMP.nanos(), "odom"), "base_link",
        new PoseWithCovariance(pose, covariance(0.25)), new TwistWithCovariance(twist, covariance(0.5)));
  }

  @Override
  public int listeners(Sample sample) {
    return running.map(r -> r.publisher(sample).numSubscribers()).orElse(0);
  }

  @Override
  public String motionPort() {
    return "cmd_vel";
  }

  @Override
  public Motion<?> motion() {
    return MOTION;
  }

  @Override
  public List<Data> heard() {
    return List.copyOf(heard);
  }

  @Override
  public Set<String> registrations() {
    SystemState state = running.orElseThrow().node().master().systemState().toOptional().orElseThrow();
    Set<String> all = new TreeSet<>();
    Map.of("publishes", state.publishers(), "subscribes", state.subscribers(), "serves", state.services())
        .forEach((verb, names) -> names
            .forEach((name, nodes) -> nodes.forEach(node -> all.add(node + " " + verb + " " + name))));
    all.removeIf(each -> MASTERS_OWN.contains(each.substring(0, each.indexOf(' '))));
    return all;
  }

  @Override
  public int links() {
    return gate.links();
  }

  @Override
  public void close() {
    kill();
    gate.close();
  }
}
