package org.robotui.rfic.recording.internal.lines;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.robotui.geometry.RigidTransform;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.sensor_msgs.Imu;
import org.robotui.message.ros.sensor_msgs.Range;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;
import org.robotui.rfic.recording.internal.lines.LineChannels.Moment;

/**
 * Lines of CARMEN's logger, as the head of its files describes them. Topics are named as the ports of a robot that runs
 * CARMEN.
 */
final class CarmenLines implements LineFormat {
  private static final int TAIL = 3;
  private static final String FRONT = "robot_frontlaser";
  private static final String REAR = "robot_rearlaser";
  private static final String READINGS = "readings";
  /** What a scanner of the old messages sees, which they do not tell: farther readings are its faults. */
  private static final double OLD_RANGE = 80;
  /** What sonars see at most, which is not told. */
  private static final double SONAR_RANGE = 5;
  private static final Set<String> KNOWN = Set.of("PARAM", "SYNC", "COMMENT", "ODOM", "TRUEPOS", "GLOBALPOS",
      "RAWLASER1", "RAWLASER2", "RAWLASER3", "RAWLASER4", "RAWLASER5", "ROBOTLASER1", "ROBOTLASER2", "FLASER", "RLASER",
      "LASER3", "LASER4", "POSITIONLASER", "PANTILT", "NMEAGGA", "NMEARMC", "SONAR", "BUMPER", "SCANMARK", "IMU",
      "VECTORMOVE", "ROBOTVELOCITY", "FOLLOWTRAJECTORY", "BASEVELOCITY", "REMISSIONFLASER", "REMISSIONRLASER",
      "REMISSIONLASER3", "REMISSIONLASER4");

  private final LineChannels channels = new LineChannels();
  private final LogLineMessages robot = new LogLineMessages(channels);
  private final CarmenTimes times;

  CarmenLines(CarmenTimes times) {
    this.times = times;
  }

  /** Whether a file begins so. */
  static boolean isHead(Stream<String> lines) {
    return lines.filter(line -> !line.isBlank()).findFirst().filter(
        line -> line.startsWith("# CARMEN Logfile") || KNOWN.contains(line.split("\\s+", 2)[0]) && ends(line))
        .isPresent();
  }

  private static boolean ends(String line) {
    return line.matches(".*\\s\\S+\\s[0-9]+(\\.[0-9]*)?\\s*");
  }

  @Override
  public String name() {
    return "CARMEN log";
  }

  @Override
  public List<RecordedChannel> channels() {
    return channels.all();
  }

  @Override
  public List<RecordedMessage> messages(String line) {
    if (line.isEmpty() || line.startsWith("#")) {
      return List.of();
    }
    String[] words = line.split("\\s+");
    if (!KNOWN.contains(words[0]) || words.length < TAIL) {
      throw new IllegalArgumentException("it begins with no message of CARMEN");
    }
    if (words[0].equals("PARAM")) {
      return List.of(parameter(words));
    }
    if (words.length <= TAIL) {
      throw new IllegalArgumentException("it has no time at its end");
    }
    LogWords in = new LogWords(words, 1, words.length - TAIL);
    Moment moment = times.of(words);
    return switch (words[0]) {
      case "ODOM" -> odometry(in, moment);
      case "TRUEPOS" -> List.of(robot.estimate("/simulator_truepos", in.pose("the pose"), moment));
      case "GLOBALPOS" -> globalPose(in, moment);
      case "RAWLASER1", "RAWLASER2", "RAWLASER3", "RAWLASER4", "RAWLASER5" -> List.of(
          scan("laser_laser" + words[0].substring("RAWLASER".length()), LogLineMessages.BASE, in, moment));
      case "ROBOTLASER1" -> mounted(FRONT, in, moment);
      case "ROBOTLASER2" -> mounted(REAR, in, moment);
      case "FLASER" -> old(FRONT, in, moment);
      case "RLASER" -> old(REAR, in, moment);
      case "LASER3", "LASER4" -> List.of(
          oldScan("laser_laser" + words[0].substring("LASER".length()), LogLineMessages.BASE, in, moment));
      case "SONAR" -> sonars(in, moment);
      case "IMU" -> List.of(inertia(in, moment));
      default -> List.of(other(words[0], in, moment));
    };
  }

  /** Older loggers write no time of the message. */
  private RecordedMessage parameter(String[] words) {
    boolean both = words.length >= 6 && words[words.length - TAIL].matches("[0-9]{9,}\\.[0-9]+");
    LogWords in = new LogWords(words, 1, words.length - (both ? TAIL : TAIL - 1));
    return channels.json("/param", "carmen/param",
        Map.of("name", in.text("a name"), "value", String.join(" ", in.rest())), times.written(words));
  }

  private List<RecordedMessage> odometry(LogWords in, Moment moment) {
    RigidTransform pose = in.pose("the pose");
    double forward = in.number("the velocity");
    return robot.odometry("/base_odometry", pose, new double[]{forward, 0, in.number("the velocity")}, moment);
  }

  /** Where the robot is on the map, and by its odometry: that places the one frame in the other. */
  private List<RecordedMessage> globalPose(LogWords in, Moment moment) {
    RigidTransform pose = in.pose("the pose");
    RecordedMessage said = robot.estimate("/localize_globalpos", pose, moment);
    return in.left() < TAIL ? List.of(said)
        : List.of(said, robot.transform(LogLineMessages.MAP, LogLineMessages.ODOM,
            pose.times(in.pose("the odometry").inverse()), moment));
  }

  private RecordedMessage scan(String topic, String frame, LogWords in, Moment moment) {
    in.skip(1, "the type of the scanner");
    double start = in.number("the first angle");
    double field = in.number("the field of view");
    double told = in.number("the resolution");
    double range = in.number("the range");
    in.skip(2, "the accuracy");
    float[] ranges = in.counted(READINGS);
    float[] remissions = in.counted("remission values");
    double step = told != 0 || ranges.length < 2 ? told : field / (ranges.length - 1);
    return robot.scan("/" + topic, frame, start, step, range > 0 ? range : Float.MAX_VALUE, ranges,
        remissions.length == ranges.length ? remissions : new float[0], moment);
  }

  private List<RecordedMessage> mounted(String topic, LogWords in, Moment moment) {
    RecordedMessage scan = scan(topic, topic, in, moment);
    return List.of(scan, mount(topic, in, moment));
  }

  /** Where a scanner is on the robot, from where both were. */
  private RecordedMessage mount(String frame, LogWords in, Moment moment) {
    RigidTransform laser = in.pose("the pose of the scanner");
    RigidTransform base = in.pose("the pose of the robot");
    return robot.transform(LogLineMessages.BASE, frame, base.inverse().times(laser), moment);
  }

  private List<RecordedMessage> old(String topic, LogWords in, Moment moment) {
    RecordedMessage scan = oldScan(topic, topic, in, moment);
    return List.of(scan, mount(topic, in, moment));
  }

  /** Angles follow from the number of readings: half the circle, but for the mode of 100 degrees. */
  private RecordedMessage oldScan(String topic, String frame, LogWords in, Moment moment) {
    float[] ranges = in.counted(READINGS);
    int gaps = Math.max(1, ranges.length - ranges.length % 2);
    double field = gaps == 400 ? 100 : 180;
    return robot.scan("/" + topic, frame, -Math.toRadians(field / 2), Math.toRadians(field / gaps), OLD_RANGE, ranges,
        new float[0], moment);
  }

  private List<RecordedMessage> sonars(LogWords in, Moment moment) {
    float cone = (float) in.number("the angle of the cones");
    float[] ranges = in.counted(READINGS);
    List<RecordedMessage> all = new ArrayList<>();
    for (int i = 0; i < ranges.length; i++) {
      String frame = "sonar_" + i;
      float range = ranges[i] >= SONAR_RANGE ? Float.POSITIVE_INFINITY : ranges[i];
      all.add(
          channels.ros("/base_sonar", Range.class, new Range(LogLineMessages.header(frame, moment), Range.ULTRASOUND,
              cone, 0, (float) SONAR_RANGE, range), moment));
      all.add(robot.transform(LogLineMessages.BASE, frame, in.pose("the place of a sonar"), moment));
    }
    return all;
  }

  private RecordedMessage inertia(LogWords in, Moment moment) {
    Vector3 acceleration = vector(in, "the acceleration");
    double w = in.number("the orientation");
    Quaternion turned = new Quaternion(in.number("the orientation"), in.number("the orientation"),
        in.number("the orientation"), w);
    in.skip(TAIL, "the magnetic field");
    return channels.ros("/imu_message", Imu.class, new Imu(LogLineMessages.header(LogLineMessages.BASE, moment), turned,
        new double[9], vector(in, "the turn"), new double[9], acceleration, new double[9]), moment);
  }

  private static Vector3 vector(LogWords in, String what) {
    double x = in.number(what);
    double y = in.number(what);
    return new Vector3(x, y, in.number(what));
  }

  /** What has no type of ROS keeps its words, and its numbers where it consists of such. */
  private RecordedMessage other(String message, LogWords in, Moment moment) {
    List<String> words = in.rest();
    String text = String.join(" ", words);
    boolean numbers = words.stream().allMatch(word -> word.matches("[-+]?[0-9]*\\.?[0-9]+([eE][-+]?[0-9]+)?"));
    String name = message.toLowerCase(Locale.ROOT);
    return channels.json("/" + name, "carmen/" + name, numbers && !words.isEmpty()
        ? Map.of("values", words.stream().mapToDouble(Double::parseDouble).toArray())
        : Map.of("text", text), moment);
  }
}
