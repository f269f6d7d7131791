package org.robotui.uic.team.internal;

import java.util.List;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.Intake;
import org.robotui.api.port.Port;
import org.robotui.api.port.StreamPort;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.sensor.Battery;

/** The ports of the view. */
public final class TeamPorts {
  /** Where robots are. */
  public static final StreamPort<Odometry> ODOM =
      new StreamPort<>("odom", Odometry.class, Arity.MANY, "Where robots are, and how fast.");
  /** What is left. */
  public static final StreamPort<Battery> BATTERY =
      new StreamPort<>("battery", Battery.class, Arity.MANY, "How full their batteries are.");
  /** What they do. */
  public static final StreamPort<DynamicRecord> TASK = new StreamPort<>(
      "task", DynamicRecord.class, Arity.MANY, "What the robots do: the state of their goals.", Intake.CHOSEN);
  /** Told to keep still. */
  public static final CommandPort<VelocityCommand> VELOCITY =
      new CommandPort<>("velocity", VelocityCommand.class, Arity.MANY, "Where a velocity of zero is sent.");
  /** Tells who takes goals, and what was sent last. */
  public static final CommandPort<NavigationGoal> GOAL =
      new CommandPort<>("goal", NavigationGoal.class, Arity.MANY, "Where goals of the robots are sent.");
  /** All of them. */
  public static final List<Port> ALL = List.of(ODOM, BATTERY, TASK, VELOCITY, GOAL);

  private TeamPorts() {}
}
