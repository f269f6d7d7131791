package org.robotui.rfic.carmen.internal.feed;

import java.util.List;
import java.util.Optional;
import org.robotui.api.session.PlacedFrames;
import org.robotui.api.session.RobotFrames;
import org.robotui.carmen.message.FieldName;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcForm;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.NavigationStatus;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.Path;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.sensor.Bumpers;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.Imu;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.geometry.RigidTransform;
import org.robotui.rfic.carmen.internal.convert.CarmenGrids;
import org.robotui.rfic.carmen.internal.convert.CarmenPlaces;
import org.robotui.rfic.carmen.internal.convert.CarmenSensing;

/** What is made of messages, by their names. A message of a known name that consists of something else is a record. */
final class FeedMaker {
  private static final String PREFIX = "carmen_";

  private final Shared shared;
  private final PlacedFrames tree;
  private final RobotFrames frames;

  FeedMaker(Shared shared) {
    this.shared = shared;
    this.tree = shared.tree();
    this.frames = shared.frames();
  }

  /** The name of a message without what all of them begin with. */
  static String port(String message) {
    return message.startsWith(PREFIX) ? message.substring(PREFIX.length()) : message;
  }

  MessageFeed<?> make(IpcForm form) {
    boolean numbered = form.fields().stream().map(FieldName::name).anyMatch("field1"::equals);
    return numbered ? MessageFeed.records(shared, form, port(form.name())) : named(form);
  }

  private MessageFeed<?> named(IpcForm form) {
    return switch (form.name()) {
      case "carmen_base_odometry" -> of(form, Odometry.class, "where its wheels say that it is", false, this::moved);
      case "carmen_robot_frontlaser", "carmen_robot_rearlaser" -> of(form, LaserScan.class,
          "what the scanner sees, by the program robot", true, (m, stamp) -> mounted(form, m, stamp));
      case "carmen_laser_laser1", "carmen_laser_laser2", "carmen_laser_laser3", "carmen_laser_laser4",
          "carmen_laser_laser5" -> of(form, LaserScan.class, "what the scanner sees; where it is, is not told", true,
              (m, stamp) -> CarmenSensing.scan(m, middle(form)));
      case "carmen_base_sonar", "robot_sonar" -> of(form, RangeReadings.class, "what the sonars see", true,
          (m, stamp) -> sonars(m));
      case "carmen_base_bumper" -> of(form, Bumpers.class, "its bumpers, and which are pressed", true,
          (m, stamp) -> CarmenSensing.bumpers(m, frames.base()));
      case "carmen_imu_message" -> of(form, Imu.class, "orientation, turning and acceleration", false,
          (m, stamp) -> CarmenSensing.imu(m, middle(form)));
      case "carmen_gps_nmea_gpgga" -> of(form, GpsFix.class, "where its antenna is on earth", false,
          (m, stamp) -> CarmenSensing.fix(m, middle(form)));
      default -> onMap(form);
    };
  }

  private MessageFeed<?> onMap(IpcForm form) {
    return switch (form.name()) {
      case "carmen_simulator_truepos" -> of(form, PoseEstimate.class, "where the simulated robot really is", true,
          this::truth);
      case "carmen_localize_globalpos" -> of(form, PoseEstimate.class, "where the robot most likely is", true,
          this::located);
      case "carmen_localize_particle" -> of(form, PoseArray.class, "a sample of the filter", true,
          (m, stamp) -> CarmenPlaces.particles(m, frames));
      case "carmen_grid_map_message", "carmen_grid_map_update_message" -> new MessageFeed<>(shared, form,
          port(form.name()), GridMap.class, "the map", false,
          (m, body, stamp) -> CarmenGrids.of(m, body.order(), frames.map()));
      case "carmen_navigator_plan" -> of(form, Path.class, "the way that the navigator has planned", false,
          (m, stamp) -> CarmenPlaces.plan(m, frames.map()));
      case "carmen_navigator_status" -> of(form, NavigationStatus.class, "whether it drives to a goal", false,
          (m, stamp) -> CarmenPlaces.status(m));
      case "carmen_navigator_autonomous_stopped" -> of(form, NavigationStatus.class, "why it drives no more", false,
          (m, stamp) -> CarmenPlaces.ended(m));
      default -> MessageFeed.records(shared, form, port(form.name()));
    };
  }

  private interface Simple<D> {
    D of(IpcRecord record, Optional<Stamp> stamp);
  }

  private <D extends Data> MessageFeed<D> of(IpcForm form, Class<D> type, String help, boolean placed,
      Simple<D> making) {
    return new MessageFeed<>(shared, form, port(form.name()), type, form.name() + ": " + help, placed,
        (record, body, stamp) -> making.of(record, stamp));
  }

  private Odometry moved(IpcRecord m, Optional<Stamp> stamp) {
    Odometry odometry = CarmenPlaces.odometry(m, frames);
    tree.placed(frames.odom(), frames.base(), odometry.pose(), stamp);
    return odometry;
  }

  private LaserScan mounted(IpcForm form, IpcRecord m, Optional<Stamp> stamp) {
    FrameId frame = frames.device(port(form.name()));
    tree.placed(frames.base(), frame, CarmenSensing.mount(m), stamp);
    return CarmenSensing.scan(m, frame);
  }

  /** What does not say where it is, is taken to be in the middle of the robot. */
  private FrameId middle(IpcForm form) {
    FrameId frame = frames.device(port(form.name()));
    tree.mounted(frame, RigidTransform.IDENTITY);
    return frame;
  }

  private RangeReadings sonars(IpcRecord m) {
    List<RigidTransform> mounts = CarmenSensing.sonarMounts(m);
    for (int i = 0; i < mounts.size(); i++) {
      tree.mounted(frames.device("sonar_" + i), mounts.get(i));
    }
    return CarmenSensing.sonars(m, frames);
  }

  private PoseEstimate located(IpcRecord m, Optional<Stamp> stamp) {
    PoseEstimate estimate = CarmenPlaces.estimate(m, frames);
    tree.placed(frames.map(), frames.odom(),
        estimate.pose().times(CarmenPlaces.pose(m.record("odometrypos")).inverse()), stamp);
    return estimate;
  }

  private PoseEstimate truth(IpcRecord m, Optional<Stamp> stamp) {
    PoseEstimate truth = CarmenPlaces.truth(m, frames);
    if (shared.settings().truth()) {
      tree.placed(frames.map(), frames.odom(),
          truth.pose().times(CarmenPlaces.pose(m.record("odometrypose")).inverse()), stamp);
    }
    return truth;
  }
}
