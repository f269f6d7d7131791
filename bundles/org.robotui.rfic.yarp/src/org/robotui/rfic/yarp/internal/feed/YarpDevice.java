package org.robotui.rfic.yarp.internal.feed;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;

/** What a port is, which YARP does not know: it is told by the names that its device servers give to their ports. */
public enum YarpDevice {
  /** Says scans. */
  LASER,
  /** Says pictures. */
  CAMERA,
  /** Says what gyroscopes, accelerometers and orientations measure. */
  IMU,
  /** Says forces and torques. */
  WRENCH,
  /** Says the joints of a control board. */
  BOARD,
  /** Says odometry. */
  ODOMETRY,
  /** Says where the robot is on a map. */
  PLACE,
  /** Says what a battery holds. */
  BATTERY,
  /** Takes velocities of a base. */
  VELOCITY,
  /** Is asked for ways to goals, and takes goals. */
  NAVIGATION,
  /** Is asked where the robot is on a map. */
  LOCALIZATION,
  /** Is asked for maps. */
  MAPS,
  /** Is asked for anything else, and answers. */
  RPC,
  /** Says anything else. */
  RECORD,
  /** Is not shown. */
  NONE;

  private static final Pattern LASERS = Pattern.compile("laser|lidar|rangefinder|/scan");
  private static final Pattern CAMERAS = Pattern.compile("/cam|camera|grabber|image|/rgb|depth");
  private static final Pattern FORCES = Pattern.compile("/ft|force|wrench|_ft");
  private static final Pattern NAVIGATIONS = Pattern.compile("navigation2?d?[^/]*/rpc|robotgoto[^/]*/rpc");
  private static final Pattern LOCALIZATIONS = Pattern.compile("locali[sz](ation|er)[^/]*/rpc");
  private static final Pattern MAPS_2D = Pattern.compile("map2d[^/]*/rpc|map_?server[^/]*/rpc");
  private static final Pattern OWN = Pattern.compile("/root|fallback|.*/quit|/tmp/.*|/robotui/.*|/yarplogger.*");
  private static final String OUT = ":o";
  private static final String RPC_IN = "/rpc:i";

  /** What users write for it. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** What users may write. */
  public static List<String> words() {
    return Arrays.stream(values()).map(YarpDevice::word).toList();
  }

  /** What a word stands for. */
  public static YarpDevice of(String word) {
    return valueOf(word.toUpperCase(Locale.ROOT));
  }

  /**
   * What a port is.
   *
   * @param name of the port
   * @param all names that are registered, or were
   * @param told by users
   */
  static YarpDevice of(String name, Set<String> all, Map<String, YarpDevice> told) {
    YarpDevice said = told.get(name);
    if (said != null) {
      return said;
    }
    if (OWN.matcher(name).matches()) {
      return NONE;
    }
    String device = name.substring(0, Math.max(0, name.lastIndexOf('/')));
    if (name.endsWith("/rpc") || name.contains("/rpc:")) {
      return asked(name.toLowerCase(Locale.ROOT));
    }
    if (name.endsWith("/data:i") && all.contains(device + RPC_IN)) {
      return VELOCITY;
    }
    return name.endsWith(":i") ? NONE : says(name, device, all);
  }

  /** Whether it is asked, and says nothing by itself. */
  public boolean asked() {
    return this == RPC || this == NAVIGATION || this == LOCALIZATION || this == MAPS;
  }

  private static YarpDevice asked(String name) {
    if (NAVIGATIONS.matcher(name).find()) {
      return NAVIGATION;
    }
    if (LOCALIZATIONS.matcher(name).find()) {
      return LOCALIZATION;
    }
    return MAPS_2D.matcher(name).find() ? MAPS : RPC;
  }

  private static YarpDevice says(String name, String device, Set<String> all) {
    switch (name.substring(device.length())) {
      case "/stateExt:o" :
        return BOARD;
      case "/state:o" :
        return all.contains(device + "/stateExt" + OUT) ? NONE : BOARD;
      case "/measures:o" :
        return FORCES.matcher(name.toLowerCase(Locale.ROOT)).find() ? WRENCH : IMU;
      case "/odometry:o" :
        return ODOMETRY;
      case "/streaming:o" :
        return PLACE;
      case "/data:o" :
        return all.contains(device + RPC_IN) ? BATTERY : RECORD;
      default :
        return byWord(name.toLowerCase(Locale.ROOT));
    }
  }

  private static YarpDevice byWord(String name) {
    if (LASERS.matcher(name).find()) {
      return LASER;
    }
    return CAMERAS.matcher(name).find() ? CAMERA : RECORD;
  }
}
