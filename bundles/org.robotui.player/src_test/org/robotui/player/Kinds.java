package org.robotui.player;

import java.lang.reflect.Field;
import java.util.List;
import java.util.stream.Stream;
import org.robotui.player.interfaces.Actarray;
import org.robotui.player.interfaces.AnyDevice;
import org.robotui.player.interfaces.Blobfinder;
import org.robotui.player.interfaces.Bumper;
import org.robotui.player.interfaces.Camera;
import org.robotui.player.interfaces.Dio;
import org.robotui.player.interfaces.Fiducial;
import org.robotui.player.interfaces.Gps;
import org.robotui.player.interfaces.Gripper;
import org.robotui.player.interfaces.Health;
import org.robotui.player.interfaces.Imu;
import org.robotui.player.interfaces.Joystick;
import org.robotui.player.interfaces.Laser;
import org.robotui.player.interfaces.Localize;
import org.robotui.player.interfaces.Opaque;
import org.robotui.player.interfaces.Planner;
import org.robotui.player.interfaces.PlayerLog;
import org.robotui.player.interfaces.PlayerMap;
import org.robotui.player.interfaces.Pointcloud3d;
import org.robotui.player.interfaces.Position2d;
import org.robotui.player.interfaces.Position3d;
import org.robotui.player.interfaces.Power;
import org.robotui.player.interfaces.Ptz;
import org.robotui.player.interfaces.Ranger;
import org.robotui.player.interfaces.Server;
import org.robotui.player.interfaces.Simulation;
import org.robotui.player.interfaces.Sonar;
import org.robotui.player.interfaces.Speech;
import org.robotui.player.layout.Kind;

/** All kinds of messages that have a Java record. */
public final class Kinds {

  private static final List<Class<?>> CLASSES =
      List.of(Actarray.class, AnyDevice.class, Blobfinder.class, Bumper.class, Camera.class, Dio.class,
          Fiducial.class, Gps.class, Gripper.class, Health.class, Imu.class, Joystick.class, Laser.class,
          Localize.class, Opaque.class, Planner.class,
          PlayerLog.class, PlayerMap.class, Pointcloud3d.class, Position2d.class, Position3d.class, Power.class,
          Ptz.class, Ranger.class,
          Server.class, Simulation.class, Sonar.class, Speech.class);

  private Kinds() {}

  /** Every constant of those classes. */
  public static List<Kind> all() {
    return CLASSES.stream().flatMap(type -> Stream.of(type.getFields())).map(Kinds::value).toList();
  }

  private static Kind value(Field constant) {
    try {
      return (Kind) constant.get(null);
    } catch (IllegalAccessException e) {
      throw new AssertionError(e);
    }
  }
}
