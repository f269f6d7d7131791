package org.robotui.core.internal.support;

import org.robotui.api.command.Principal;
import org.robotui.api.port.Arity;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.api.port.StreamPort;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.Pose;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/** Ports and values for tests. */
public final class Samples {
  public static final StreamPort<LaserScan> SCAN = new StreamPort<>("scan", LaserScan.class, Arity.ONE, "");
  public static final StreamPort<Odometry> ODOM = new StreamPort<>("odom", Odometry.class, Arity.ONE, "");
  public static final StreamPort<Pose> POSE = new StreamPort<>("pose", Pose.class, Arity.ONE, "");
  public static final StreamPort<GridMap> MAP = new StreamPort<>("map", GridMap.class, Arity.ONE, "");
  public static final StreamPort<LogEntry> LOG = new StreamPort<>("rosout", LogEntry.class, Arity.ONE, "");
  public static final CommandPort<VelocityCommand> VELOCITY =
      new CommandPort<>("cmd_vel", VelocityCommand.class, Arity.ONE, "");
  public static final CommandPort<NavigationGoal> GOAL =
      new CommandPort<>("goal", NavigationGoal.class, Arity.ONE, "");
  public static final CallPort<ServiceRequest, ServiceReply> CALL =
      new CallPort<>("call", ServiceRequest.class, ServiceReply.class, Arity.ONE, "");
  public static final BrowsePort BROWSE = new BrowsePort("robot", Arity.ONE, "");

  public static final Principal YOU = new Principal("you", "You", Principal.Kind.WINDOW);
  public static final Principal SCRIPT = new Principal("script", "A script", Principal.Kind.SCRIPT);

  private Samples() {}

  /** A scan of one beam. */
  public static LaserScan scan(float range) {
    return new LaserScan(new FrameId("r", "laser"), 0, 0.1, 0, 10, 0, Floats.of(range), Floats.EMPTY);
  }

  /** An odometry at x. */
  public static Odometry odometry(double x) {
    return new Odometry(new FrameId("r", "odom"), new FrameId("r", "base"), RigidTransform.planar(x, 0, 0),
        Doubles.EMPTY,
        Vector3.ZERO, Vector3.ZERO, Doubles.EMPTY);
  }

  /** A log entry. */
  public static LogEntry log(String text) {
    return new LogEntry(Severity.INFO, "node", text, "");
  }

  /** A goal. */
  public static NavigationGoal goal(double x) {
    return new NavigationGoal(new FrameId("r", "map"), RigidTransform.planar(x, 0, 0));
  }

  /** Forward motion. */
  public static VelocityCommand forward(double speed) {
    return VelocityCommand.planar(speed, 0);
  }
}
