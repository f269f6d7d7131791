package org.robotui.sim.internal.smartsoft;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.smartsoft.client.ParameterMaster;
import org.robotui.smartsoft.client.ParameterMaster.Response;
import org.robotui.smartsoft.client.StateMaster;
import org.robotui.smartsoft.object.CommType;
import org.robotui.smartsoft.object.CommTypes;

/** Turns what others send into commands. */
final class SmartTasks {
  static final String VELOCITY = "CommBasicObjects::CommNavigationVelocity";
  static final List<String> PARAMETER = List.of(ParameterMaster.REQUEST, ParameterMaster.RESPONSE);
  static final List<String> STATE = List.of(StateMaster.REQUEST, StateMaster.RESPONSE);
  static final List<String> STATES = List.of("Neutral", "PathPlanning");
  /** How long a velocity holds. */
  private static final double HOLD = 1;
  private static final double PER_METRE = 1000;
  private static final String DESTINATION = ".SETDESTINATIONCIRCLE";
  private static final String DELETE = ".DELETEGOAL";
  private static final int CIRCLE = 3;

  private final SimulatedRobot robot;
  private final CommType velocity;
  private final AtomicLong goals = new AtomicLong();

  SmartTasks(SimulatedRobot robot, CommTypes types) {
    this.robot = robot;
    this.velocity = types.get(VELOCITY);
  }

  void drive(ByteBuffer object) throws MessageException {
    DynamicMessage said = velocity.read(object);
    Speed speed = new Speed(said.number("vX").orElse(0) / PER_METRE, said.number("omega").orElse(0));
    if (speed.isFinite()) {
      submit(new Command.Drive(speed, HOLD));
    }
  }

  /** A goal is a circle on the map, in millimetres; its radius is not looked at. */
  Response parameter(String name, List<String> values) {
    String upper = name.toUpperCase(Locale.ROOT);
    if (upper.endsWith(DELETE)) {
      cancel();
      return Response.OK;
    }
    return upper.endsWith(DESTINATION) && values.size() == CIRCLE ? go(values.get(0), values.get(1))
        : Response.INVALID;
  }

  private Response go(String x, String y) {
    try {
      Pose2 there = new Pose2(Double.parseDouble(x) / PER_METRE, Double.parseDouble(y) / PER_METRE,
          robot.state().estimate().yaw());
      if (!Double.isFinite(there.x() + there.y())) {
        return Response.INVALID;
      }
      submit(new Command.Goal("smartsoft-" + goals.incrementAndGet(), there));
      return Response.OK;
    } catch (NumberFormatException e) {
      return Response.INVALID;
    }
  }

  /** A planner that is neutral plans nothing. */
  void state(String state) {
    if (state.equals(STATES.getFirst())) {
      cancel();
    }
  }

  private void cancel() {
    submit(new Command.Cancel("smartsoft-" + goals.get()));
  }

  private void submit(Command command) {
    robot.simulation().submit(command);
  }
}
