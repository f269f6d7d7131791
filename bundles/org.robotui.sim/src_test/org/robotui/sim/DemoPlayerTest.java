package org.robotui.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import java.util.zip.Inflater;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.RecordCodec;
import org.robotui.net.call.Outcome;
import org.robotui.player.client.ClientOptions;
import org.robotui.player.client.DeviceState;
import org.robotui.player.client.LinkState;
import org.robotui.player.client.PlayerClient;
import org.robotui.player.client.PlayerDevice;
import org.robotui.player.client.Subscription;
import org.robotui.player.interfaces.Bumper;
import org.robotui.player.interfaces.Camera;
import org.robotui.player.interfaces.Imu;
import org.robotui.player.interfaces.Laser;
import org.robotui.player.interfaces.Localize;
import org.robotui.player.interfaces.Planner;
import org.robotui.player.interfaces.PlayerMap;
import org.robotui.player.interfaces.Pose2d;
import org.robotui.player.interfaces.Position2d;
import org.robotui.player.interfaces.Power;
import org.robotui.player.interfaces.Ptz;
import org.robotui.player.interfaces.Ranger;
import org.robotui.player.interfaces.Setting;
import org.robotui.player.interfaces.Sonar;
import org.robotui.player.interfaces.Switch;
import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;
import org.robotui.player.layout.Layouts;

/** The robots over Player, seen by clients. Runs ten times faster than real. */
class DemoPlayerTest {
  private static final long PATIENCE = 20;

  private final Layouts layouts = Layouts.standard();
  private final List<AutoCloseable> open = new ArrayList<>();
  private PlayerClient client;

  private void start(String robot) throws Exception {
    Demo demo = Demo.start(Options.parse(List.of("--robot", robot, "--speak", "player", "--speed-factor", "10")));
    open.add(demo);
    assertEquals("127.0.0.1", demo.addresses().get("PLAYER_HOST"));
    client = client(Integer.parseInt(demo.addresses().get("PLAYER_PORT")));
  }

  private PlayerClient client(int port) throws InterruptedException {
    PlayerClient made = new PlayerClient("127.0.0.1", port, layouts,
        ClientOptions.standard(task -> Thread.ofPlatform().daemon().unstarted(task)));
    open.add(made);
    eventually(() -> made.state() instanceof LinkState.Connected);
    return made;
  }

  @AfterEach
  void end() throws Exception {
    for (AutoCloseable each : open.reversed()) {
      each.close();
    }
  }

  private static void eventually(BooleanSupplier condition) throws InterruptedException {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE);
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, "it does not happen");
      Thread.sleep(5);
    }
  }

  /** Opens a device of which one kind of data is heard. */
  private final class Heard<T> {
    private final BlockingQueue<T> queue = new LinkedBlockingQueue<>();
    private final PlayerDevice device;
    private final Subscription subscription;

    Heard(PlayerClient by, String name, int index, Kind.Data<T> kind) throws InterruptedException {
      device = by.device(name, index);
      subscription = device.subscribe(kind, (value, stamp, receiveNanos) -> queue.add(value));
      eventually(() -> device.state() instanceof DeviceState.Open);
    }

    T await(Predicate<T> wanted) throws InterruptedException {
      long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE);
      while (true) {
        T value = queue.poll(end - System.nanoTime(), TimeUnit.NANOSECONDS);
        assertNotNull(value, "no such data of " + device.name());
        if (wanted.test(value)) {
          return value;
        }
      }
    }

    T next() throws InterruptedException {
      return await(any -> true);
    }

    <Q, A> A ask(Kind.Request<Q, A> kind, Q question) throws Exception {
      return value(device.request(kind, question));
    }

    <Q, A> void refuses(Kind.Request<Q, A> kind, Q question) throws Exception {
      assertInstanceOf(Outcome.Refused.class, device.request(kind, question).get(PATIENCE, TimeUnit.SECONDS));
    }
  }

  private static <T> T value(CompletableFuture<Outcome<T>> future) throws Exception {
    Outcome<T> outcome = future.get(PATIENCE, TimeUnit.SECONDS);
    return outcome.toOptional().orElseThrow(() -> new AssertionError(outcome.reason()));
  }

  private List<String> devices() {
    return client.devices().stream().map(layouts::nameOf).sorted().toList();
  }

  @Test
  void eachRobotHasTheDevicesOfItsSensors() throws Exception {
    start("natalie");
    assertEquals(List.of("camera:0", "camera:1", "imu:0", "laser:0", "localize:0", "map:0", "planner:0", "position2d:0",
        "power:0", "ptz:0",
        "ranger:0", "ranger:1", "sonar:0"), devices());
    start("keira");
    assertEquals(List.of("bumper:0", "camera:0", "camera:1", "imu:0", "laser:0", "localize:0", "map:0", "planner:0",
        "position2d:0", "power:0",
        "ranger:0"), devices());
  }

  @Test
  void aVelocityHoldsForAWhileAndEndsWithTheClient() throws Exception {
    start("natalie");
    Heard<Position2d.State> base = new Heard<>(client, "position2d", 0, Position2d.STATE);
    base.device.command(Position2d.VELOCITY, new Position2d.Velocity(new Pose2d(0.3, 0, 0.2), true));
    base.await(state -> Math.abs(state.velocity().x() - 0.3) < 1e-6);
    base.await(state -> state.velocity().x() == 0);
    PlayerClient other = client(client.device("position2d", 0).address().orElseThrow().robot());
    Heard<Position2d.State> second = new Heard<>(other, "position2d", 0, Position2d.STATE);
    second.device.command(Position2d.POSITION,
        new Position2d.Position(new Pose2d(50, 0, 0), new Pose2d(0.3, 0, 0.5), true));
    second.await(state -> state.velocity().x() > 0.2);
    base.subscription.close();
    eventually(() -> !(client.device("position2d", 0).state() instanceof DeviceState.Open));
    second.queue.clear();
    assertTrue(second.next().velocity().x() > 0.1, "one client is left, and it drives on");
    second.subscription.close();
    Heard<Position2d.State> third = new Heard<>(client, "position2d", 0, Position2d.STATE);
    third.await(state -> state.velocity().x() == 0);
  }

  @Test
  void thePlaceOfOdometryIsSetAndDrivenTo() throws Exception {
    start("natalie");
    Heard<Position2d.State> base = new Heard<>(client, "position2d", 0, Position2d.STATE);
    base.ask(Position2d.SET_ODOMETRY, new Position2d.Odometry(new Pose2d(1, 2, 0.5)));
    base.await(state -> state.position().equals(new Pose2d(1, 2, 0.5)));
    base.device.command(Position2d.POSITION,
        new Position2d.Position(new Pose2d(1.4, 2.2, 0), new Pose2d(0, 0, 0), true));
    base.await(state -> Math.hypot(state.position().x() - 1.4, state.position().y() - 2.2) < 0.08
        && state.velocity().x() == 0);
    base.ask(Position2d.RESET_ODOMETRY, new Empty());
    base.await(state -> Math.abs(state.position().x()) < 0.01 && Math.abs(state.position().y()) < 0.01);
    base.refuses(Position2d.SET_ODOMETRY, new Position2d.Odometry(new Pose2d(Double.NaN, 0, 0)));
    assertEquals(0.5, base.ask(Position2d.GET_GEOMETRY, new Empty()).size().length(), 1e-9);
    base.ask(Position2d.POSITION_MODE, new Setting(1));
    base.refuses(Position2d.POSITION_MODE, new Setting(7));
  }

  @Test
  void withoutMotorsNothingMoves() throws Exception {
    start("keira");
    Heard<Position2d.State> base = new Heard<>(client, "position2d", 0, Position2d.STATE);
    base.ask(Position2d.MOTOR_POWER, new Switch(false));
    Pose2d before = base.next().position();
    base.device.command(Position2d.VELOCITY, new Position2d.Velocity(new Pose2d(0.3, 0, 0), true));
    for (int i = 0; i < 20; i++) {
      assertEquals(before, base.next().position());
    }
    base.ask(Position2d.MOTOR_POWER, new Switch(true));
    base.device.command(Position2d.VELOCITY, new Position2d.Velocity(new Pose2d(0.3, 0, 0), true));
    base.await(state -> state.velocity().x() > 0.25);
  }

  @Test
  void rangesComeAsTheGeometrySays() throws Exception {
    start("natalie");
    Laser.Scan scan = new Heard<>(client, "laser", 0, Laser.SCAN).next();
    assertEquals(361, scan.ranges().length);
    assertEquals(scan.maxAngle(), scan.minAngle() + 360 * scan.resolution(), 1e-4);
    for (float range : scan.ranges()) {
      assertTrue(range > 0 && range <= scan.maxRange(), "range " + range);
    }
    Heard<Ranger.Ranges> sonars = new Heard<>(client, "ranger", 0, Ranger.RANGES);
    assertEquals(16, sonars.next().ranges().length);
    assertEquals(16, sonars.ask(Ranger.GET_GEOMETRY, new Empty()).elementPoses().size());
    assertEquals(5, sonars.ask(Ranger.GET_CONFIG, new Empty()).maxRange());
    Heard<Sonar.Ranges> old = new Heard<>(client, "sonar", 0, Sonar.RANGES);
    assertEquals(Math.toRadians(50), old.ask(Sonar.GET_GEOMETRY, new Empty()).poses().get(1).yaw(), 1e-9);
    Heard<Ranger.Ranges> laser = new Heard<>(client, "ranger", 1, Ranger.RANGES);
    Ranger.Config config = laser.ask(Ranger.GET_CONFIG, new Empty());
    assertEquals(laser.next().ranges().length - 1,
        Math.round((config.maxAngle() - config.minAngle()) / config.resolution()));
    laser.refuses(Ranger.SET_CONFIG, config);
    assertEquals(0.3, laser.ask(Ranger.GET_GEOMETRY, new Empty()).pose().z(), 1e-9);
  }

  @Test
  void aBumperTellsOfAWall() throws Exception {
    start("keira");
    Heard<Bumper.State> bumper = new Heard<>(client, "bumper", 0, Bumper.STATE);
    assertEquals(2, bumper.ask(Bumper.GET_GEOMETRY, new Empty()).bumpers().size());
    assertFalse(pressed(bumper.next()));
    Heard<Position2d.State> base = new Heard<>(client, "position2d", 0, Position2d.STATE);
    base.device.command(Position2d.POSITION,
        new Position2d.Position(new Pose2d(-5, 0, Math.PI), new Pose2d(0.4, 0, 1), true));
    bumper.await(DemoPlayerTest::pressed);
    base.await(state -> state.stall() && state.velocity().x() == 0);
    Bumper.State after = bumper.next();
    base.device.command(Position2d.VELOCITY, new Position2d.Velocity(new Pose2d(0.3, 0, 0), true));
    assertTrue(pressed(after) && pressed(bumper.next()), "it must not drive on");
    base.device.command(Position2d.VELOCITY, new Position2d.Velocity(new Pose2d(-0.2, 0, 0), true));
    bumper.await(state -> !pressed(state));
  }

  private static boolean pressed(Bumper.State state) {
    return state.pressed()[0] != 0 || state.pressed()[1] != 0;
  }

  @Test
  void picturesComeAsPixelsAndAsJpeg() throws Exception {
    start("keira");
    Heard<Camera.Image> raw = new Heard<>(client, "camera", 0, Camera.IMAGE);
    Camera.Image pixels = raw.next();
    assertEquals(320 * 240 * 3, pixels.data().length);
    assertEquals(0, pixels.compression());
    assertEquals(320, raw.ask(Camera.GET_IMAGE, new Empty()).width());
    Camera.Image jpeg = new Heard<>(client, "camera", 1, Camera.IMAGE).next();
    assertEquals(1, jpeg.compression());
    assertEquals(320, ImageIO.read(new ByteArrayInputStream(jpeg.data())).getWidth());
    raw.refuses(Camera.GET_SOURCE, new Empty());
  }

  @Test
  void theMapIsGivenInTiles() throws Exception {
    start("keira");
    Heard<PlayerMap.Info> map = new Heard<>(client, "map", 0, PlayerMap.INFO);
    PlayerMap.Info info = map.ask(PlayerMap.GET_INFO, new Empty());
    assertEquals(0.05, info.scale(), 1e-6);
    PlayerMap.Tile tile =
        map.ask(PlayerMap.GET_TILE, new PlayerMap.Tile(10, 20, info.width() - 10, info.height() - 20, 0, new byte[0]));
    byte[] cells = new byte[(int) (tile.width() * tile.height())];
    Inflater inflater = new Inflater();
    inflater.setInput(tile.cells());
    assertEquals(cells.length, inflater.inflate(cells));
    inflater.end();
    int column = (int) ((0.6 - info.origin().x()) / info.scale()) - 10;
    int row = (int) ((3.3 - info.origin().y()) / info.scale()) - 20;
    assertEquals(-1, cells[(int) (row * tile.width()) + column], "it starts on free ground");
    assertEquals(1, tile.range());
    map.refuses(PlayerMap.GET_TILE, new PlayerMap.Tile(0, 0, info.width() + 1, 1, 0, new byte[0]));
    map.refuses(PlayerMap.GET_TILE, new PlayerMap.Tile(0xffffffffL, 0, 2, 1, 0, new byte[0]));
    map.refuses(PlayerMap.GET_VECTOR, new Empty());
  }

  @Test
  void thePlannerLeadsToAGoal() throws Exception {
    start("keira");
    Heard<Planner.State> planner = new Heard<>(client, "planner", 0, Planner.STATE);
    Heard<Localize.Hypotheses> localize = new Heard<>(client, "localize", 0, Localize.HYPOTHESES);
    planner.device.command(Planner.GOAL, new Planner.Place(new Pose2d(2.6, 5.6, 1)));
    Planner.State state = planner.await(Planner.State::valid);
    assertFalse(state.done());
    assertTrue(state.index() > 0 && state.waypoints() > 5 && state.waypoints() <= 128, state.toString());
    Planner.Waypoints way = planner.ask(Planner.GET_WAYPOINTS, new Empty());
    assertEquals(new Pose2d(2.6, 5.6, 1), way.waypoints().getLast());
    assertTrue(way.distance() > 2, "distance " + way.distance());
    planner.await(Planner.State::done);
    localize.await(guess -> Math.hypot(guess.hypotheses().getFirst().mean().x() - 2.6,
        guess.hypotheses().getFirst().mean().y() - 5.6) < 0.2);
    assertEquals(100, localize.ask(Localize.GET_PARTICLES, new Empty()).particles().size());
    localize.ask(Localize.SET_POSE, new Localize.Estimate(new Pose2d(1, 1, 0), new double[6]));
    localize.await(guess -> Math.abs(guess.hypotheses().getFirst().mean().x() - 1) < 0.05);
    planner.ask(Planner.ENABLE, new Switch(false));
    planner.device.command(Planner.GOAL, new Planner.Place(new Pose2d(4, 3.5, 0)));
    for (int i = 0; i < 5; i++) {
      assertFalse(planner.next().valid());
    }
  }

  @Test
  void theHeadAndTheInertialUnitDoAsTold() throws Exception {
    start("natalie");
    Heard<Ptz.State> head = new Heard<>(client, "ptz", 0, Ptz.STATE);
    head.device.command(Ptz.MOVE, new Ptz.Move(-0.4f, 0.3f, 0, 0, 0));
    head.await(state -> Math.abs(state.pan() + 0.4) < 1e-4 && Math.abs(state.tilt() - 0.3) < 1e-4);
    head.ask(Ptz.CONTROL_MODE, new Ptz.Mode(0));
    head.device.command(Ptz.MOVE, new Ptz.Move(0, 0, 0, 0.5f, 0));
    assertEquals(0.5, head.await(state -> state.pan() > 0).panSpeed(), 1e-4);
    head.refuses(Ptz.CONTROL_MODE, new Ptz.Mode(9));
    Heard<Imu.Calibrated> imu = new Heard<>(client, "imu", 0, Imu.CALIBRATED);
    imu.ask(Imu.SET_DATA_TYPE, new Imu.DataType(2));
    assertEquals(9.81, imu.next().accelerationZ(), 0.01);
    imu.refuses(Imu.SET_DATA_TYPE, new Imu.DataType(6));
    imu.ask(Imu.SET_DATA_TYPE, new Imu.DataType(1));
    imu.ask(Imu.RESET_ORIENTATION, new Setting(0));
    Heard<Imu.State> pose = new Heard<>(client, "imu", 0, Imu.STATE);
    assertEquals(0, pose.next().pose().yaw(), 0.01);
    Power.State power = new Heard<>(client, "power", 0, Power.STATE).next();
    assertEquals(87, power.percent(), 3);
    assertEquals(31, power.valid());
  }

  @Test
  void nothingIsSentOfADeviceThatNobodyHasOpen() throws Exception {
    start("natalie");
    Heard<Laser.Scan> laser = new Heard<>(client, "laser", 0, Laser.SCAN);
    laser.next();
    laser.subscription.close();
    eventually(() -> !(laser.device.state() instanceof DeviceState.Open));
    Heard<Position2d.State> base = new Heard<>(client, "position2d", 0, Position2d.STATE);
    laser.queue.clear();
    for (int i = 0; i < 20; i++) {
      base.next();
    }
    assertTrue(laser.queue.isEmpty());
    assertEquals(0, client.unexpected());
  }

  @Test
  void twoFacesShowTheSameRobot() throws Exception {
    Demo demo = Demo.start(Options.parse(List.of("--robot", "keira", "--speak", "ros,player", "--speed-factor", "10")));
    open.add(demo);
    assertEquals(List.of("ROS_MASTER_URI", "PLAYER_HOST", "PLAYER_PORT"), List.copyOf(demo.addresses().keySet()));
    client = client(Integer.parseInt(demo.addresses().get("PLAYER_PORT")));
    Heard<Position2d.State> base = new Heard<>(client, "position2d", 0, Position2d.STATE);
    drive(demo);
    base.await(state -> state.velocity().x() > 0.15);
  }

  private void drive(Demo demo) throws IOException {
    var options = org.robotui.ros.NodeOptions.standard(task -> Thread.ofPlatform().daemon().unstarted(task));
    var node = org.robotui.ros.RosNode.open(org.robotui.ros.RosEnvironment.of(demo.masterUri()),
        org.robotui.ros.GraphName.of("driver"), options);
    open.add(node);
    node.publisher("/cmd_vel", RecordCodec.of(org.robotui.message.ros.geometry_msgs.Twist.class),
        org.robotui.ros.PublisherOptions.latched())
        .publish(new org.robotui.message.ros.geometry_msgs.Twist(
            new org.robotui.message.ros.geometry_msgs.Vector3(0.2, 0, 0),
            new org.robotui.message.ros.geometry_msgs.Vector3(0, 0, 0)));
  }
}
