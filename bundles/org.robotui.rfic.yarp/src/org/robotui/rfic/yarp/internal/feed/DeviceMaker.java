package org.robotui.rfic.yarp.internal.feed;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.Offer;
import org.robotui.api.session.RobotFrames;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.Wrench;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.RawImage;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.Imu;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.RigidTransform;
import org.robotui.net.socket.HostPort;
import org.robotui.rfic.yarp.internal.convert.BottleRecord;
import org.robotui.rfic.yarp.internal.convert.YarpSensing;
import org.robotui.yarp.bottle.Bottle;

/** Makes streams and commands of ports. */
final class DeviceMaker implements AutoCloseable {
  private final Wires wires;
  private final YarpDevices devices;
  private final RobotFrames frames;
  private final NavigationMaker navigation;
  private final List<Offer> commands = new CopyOnWriteArrayList<>();
  private final List<BoardFeed> boards = new CopyOnWriteArrayList<>();
  private final BodyFeed body;
  private final Set<String> taken = new HashSet<>(Set.of("tf")); // only on the thread that follows
  private volatile Optional<RigidTransform> odometry = Optional.empty();

  DeviceMaker(Wires wires, YarpDevices devices) {
    this.wires = wires;
    this.devices = devices;
    this.frames = wires.frames();
    this.body = new BodyFeed(wires);
    taken.addAll(BodyFeed.NAMES);
    this.navigation = new NavigationMaker(wires, devices, place -> located(place, Optional.empty()));
  }

  void make(String name, YarpDevice kind) {
    switch (kind) {
      case LASER -> feed(name, LaserScan.class, "what the scanner sees", true,
          (m, stamp) -> YarpSensing.scan(m, middle(name)));
      case CAMERA -> camera(name);
      case IMU -> feed(name, Imu.class, "orientation, turning and acceleration", false,
          (m, stamp) -> YarpSensing.imu(m, middle(name)));
      case WRENCH -> feed(name, Wrench.class, "forces and torques", false,
          (m, stamp) -> YarpSensing.wrench(m, middle(name)));
      case ODOMETRY -> feed(name, Odometry.class, "where its wheels say that it is", false, this::moved);
      case PLACE -> feed(name, PoseEstimate.class, "where it is on the map", true, this::located);
      case BATTERY -> feed(name, Battery.class, "what the battery holds", false, (m, stamp) -> YarpSensing.battery(m));
      case RECORD -> feed(name, DynamicRecord.class, "as the robot says it", false,
          (m, stamp) -> new BottleRecord(name, m));
      case BOARD -> board(name);
      case VELOCITY -> velocity(name);
      case NAVIGATION -> navigation.navigation(name, wires.port(Wires.device(name)));
      case LOCALIZATION -> navigation.localization(name, wires.port(Wires.device(name)));
      case MAPS -> navigation.maps(name, wires.port(Wires.device(name)));
      case RPC, NONE -> {}
    }
  }

  private interface Simple<D> {
    D of(Bottle message, Optional<Stamp> stamp);
  }

  private <D extends Data> void feed(String name, Class<D> type, String help, boolean placed, Simple<D> making) {
    PortFeed feed = new PortFeed(wires, name, address(name), placed, told(name));
    feed.offer(free(wires.port(name), name), type, help, (m, stamp) -> Optional.of(making.of(m, stamp)));
    devices.add(name, feed);
  }

  private PortAsking told(String name) {
    return new ToldPort(wires, carrier(name).told());
  }

  private StreamCarrier carrier(String name) {
    return wires.settings().carriers().getOrDefault(name, wires.settings().carrier());
  }

  private void camera(String name) {
    if (carrier(name) != StreamCarrier.MJPEG) {
      feed(name, RawImage.class, "what the camera sees", true, (m, stamp) -> YarpSensing.image(m, middle(name)));
      return;
    }
    PortFeed feed = new PortFeed(wires, name, address(name), true, new PulledPort(wires, name, devices));
    feed.offer(free(wires.port(name), name), CompressedImage.class, name + ": what the camera sees",
        (m, stamp) -> Optional.of(YarpSensing.jpeg(m, middle(name))));
    devices.add(name, feed);
  }

  /** Two ports may have one name here, as {@code /x} and {@code /x:o}: the later keeps its own. */
  private String free(String port, String name) {
    return taken.add(port) ? port : name;
  }

  private HostPort address(String name) {
    return devices.address(name).orElseThrow();
  }

  private void board(String name) {
    String device = Wires.device(name);
    String chain = wires.port(device);
    chain = taken.add(chain + "/control") && taken.add(chain + "/model") ? chain : device;
    PortFeed feed = new PortFeed(wires, name, address(name), false, told(name));
    BoardFeed board = new BoardFeed(wires, feed, free(wires.port(name), name), chain,
        () -> devices.address(device + "/rpc:i"), body);
    boards.add(board);
    body.add(board);
    devices.add(board);
    devices.add(name, feed);
  }

  private void velocity(String name) {
    BaseDriver driver = new BaseDriver(wires, name, () -> address(name), navigation::halt);
    devices.add(driver);
    commands.add(wires.context().offers().command(new CommandPort<>(wires.port(Wires.device(name)) + "/velocity",
        VelocityCommand.class, Arity.MANY, name + ": velocity of the base"), driver));
  }

  /** What does not say where it is, is taken to be in the middle of the robot. */
  private FrameId middle(String name) {
    FrameId frame = frames.device(wires.port(name));
    wires.tree().mounted(frame, RigidTransform.IDENTITY);
    return frame;
  }

  private Odometry moved(Bottle m, Optional<Stamp> stamp) {
    Odometry moved = YarpSensing.odometry(m, frames);
    odometry = Optional.of(moved.pose());
    wires.tree().placed(frames.odom(), frames.base(), moved.pose(), stamp);
    return moved;
  }

  private PoseEstimate located(Bottle m, Optional<Stamp> stamp) {
    PoseEstimate place = YarpSensing.place(m, frames.map());
    navigation.at(m);
    odometry.ifPresent(base -> wires.tree().placed(frames.map(), frames.odom(),
        place.pose().times(base.inverse()), stamp));
    return place;
  }

  /** Asks boards for what they do not say by themselves; may block. */
  void tick() {
    boards.forEach(BoardFeed::tick);
    body.tick();
  }

  @Override
  public void close() {
    navigation.close();
    body.close();
    commands.forEach(Offer::close);
  }
}
