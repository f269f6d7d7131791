package org.robotui.script.internal.function;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.command.Authority;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.Principal;
import org.robotui.api.host.PortAccess;
import org.robotui.api.host.Ruic;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.Port;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.api.script.ScriptCall;
import org.robotui.api.script.ScriptFailure;
import org.robotui.api.script.ScriptFunction;
import org.robotui.data.Data;
import org.robotui.data.command.VelocityCommand;
import org.robotui.geometry.Vector3;

/** Control of robots, motion, and the stop: all by the arbiter of the robot, as a user's. */
final class CommandFunctions {
  private static final Duration BEAT = Duration.ofMillis(100);
  private static final Duration VALID = Duration.ofMillis(300);
  private static final double USUAL_SECONDS = 0.5;
  private static final double LONGEST_SECONDS = 3600;

  private CommandFunctions() {}

  static List<ScriptFunction> functions() {
    return List.of(
        ScriptFunction.of("robots()", "Lists the robots that can be commanded.",
            "a list of {name, ui, control, stoppedBy}; control is who has it, null for nobody",
            CommandFunctions::robots),
        ScriptFunction.of("takeControl(robot?, takeover?)",
            "Takes control of a robot. From somebody else only where takeover is true: that is the confirmation which"
                + " the window asks for.",
            "", CommandFunctions::take),
        ScriptFunction.of("giveBackControl(robot?)",
            "Gives control back; what the script moves is stopped. So does the end of the script.", "", call -> {
              Named.robot(call, 0).giveBack(call.principal());
              return null;
            }),
        ScriptFunction.of("drive(forward, turn, seconds, port?)",
            "Drives a mobile base, in m/s and rad/s (positive is to the left), and stops it after those seconds."
                + " The limits of the configuration hold.",
            "", CommandFunctions::drive),
        ScriptFunction.of("driveAlong(steps, port?, ui?)",
            "Drives a mobile base through steps without a halt between them, and stops it then. Each step is"
                + " [forward, turn, seconds], as of drive, or [forward, turn, seconds, left].",
            "", CommandFunctions::driveAlong),
        ScriptFunction.of("send(port, fields, seconds?, ui?)",
            "Gives a command of any type, such as {linear: {x: 0.2}}; absent fields are zero or empty. It is true for"
                + " 0.5 s, or those seconds: a motion that is not renewed ends then.",
            "", CommandFunctions::send),
        ScriptFunction.of("stop(robot?)", "Stops a robot, or all, until the stop is released.", "",
            CommandFunctions::stop),
        ScriptFunction.of("releaseStop(robot?)", "Releases the stop of a robot. Nothing moves by that.", "", call -> {
          Named.robot(call, 0).releaseStop(call.principal());
          return null;
        }),
        ScriptFunction.of("selectRobots(names, ui?)", "Selects robots of a team, as in its table.", "",
            CommandFunctions::select));
  }

  private static Object robots(ScriptCall call) {
    Map<String, Object> all = new LinkedHashMap<>();
    for (Ruic ruic : call.host().ruics()) {
      ruic.authorities().forEach(a -> all.putIfAbsent(a.robot(), described(ruic, a)));
    }
    return List.copyOf(all.values());
  }

  private static Map<String, Object> described(Ruic ruic, Authority robot) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("name", robot.robot());
    all.put("ui", ruic.name());
    all.put("control", robot.holder().map(Principal::label).orElse(null));
    all.put("stoppedBy", robot.stoppedBy().map(Principal::label).orElse(null));
    return all;
  }

  private static Object take(ScriptCall call) throws ScriptFailure {
    Authority robot = Named.robot(call, 0);
    boolean takeover = call.argument(1).filter(Boolean.TRUE::equals).isPresent();
    if (robot.take(call.principal(), takeover) instanceof Authority.LeaseOutcome.HeldBy held) {
      throw new ScriptFailure(held.holder().label() + " has control of " + robot.robot()
          + "; take it over with takeControl(\"" + robot.robot() + "\", true)");
    }
    return null;
  }

  private static Object drive(ScriptCall call) throws ScriptFailure, InterruptedException {
    VelocityCommand velocity = VelocityCommand.planar(call.number(0), call.number(1));
    return drive(call, call.ruic(Optional.empty()), 3, List.of(new Leg(velocity, call.seconds(2, 0))));
  }

  /** A velocity for some time. */
  private record Leg(VelocityCommand velocity, Duration lasting) {
    static Leg of(Object step) throws ScriptFailure {
      List<Double> numbers = step instanceof List<?> list ? list.stream().filter(Number.class::isInstance)
          .map(n -> ((Number) n).doubleValue()).toList() : List.of();
      boolean fits = (numbers.size() == 3 || numbers.size() == 4) && numbers.size() == ((List<?>) step).size();
      if (!fits || !(numbers.get(2) >= 0) || numbers.get(2) > LONGEST_SECONDS) {
        throw new ScriptFailure("driveAlong(steps): a step must be [forward, turn, seconds], or with left behind it,"
            + " the seconds from 0 to " + LONGEST_SECONDS + ", not " + step);
      }
      VelocityCommand planar = VelocityCommand.planar(numbers.get(0), numbers.get(1));
      Vector3 linear = new Vector3(numbers.get(0), numbers.size() == 4 ? numbers.get(3) : 0, 0);
      return new Leg(new VelocityCommand(linear, planar.angular()), Duration.ofNanos((long) (numbers.get(2) * 1e9)));
    }
  }

  private static Object driveAlong(ScriptCall call) throws ScriptFailure, InterruptedException {
    if (!(call.argument(0).orElse(null) instanceof List<?> steps)) {
      throw new ScriptFailure("driveAlong(steps): steps must be a list, such as [[0.3, 0, 2], [0.3, 0.5, 1]]");
    }
    List<Leg> legs = new ArrayList<>();
    for (Object step : steps) {
      legs.add(Leg.of(step));
    }
    return drive(call, Named.ruic(call, 2), 1, legs);
  }

  /** The port is that argument, else the only one that takes velocities. */
  private static Object drive(ScriptCall call, Ruic ruic, int portArgument, List<Leg> legs)
      throws ScriptFailure, InterruptedException {
    SourceId port = call.textIf(portArgument).isPresent() ? Named.port(call, portArgument)
        : Named.only(ruic, PortKind.COMMAND, VelocityCommand.class.getSimpleName());
    PortAccess access = call.access(ruic);
    long end = System.nanoTime();
    try {
      for (Leg leg : legs) {
        end += leg.lasting().toNanos();
        for (long left = end - System.nanoTime(); left > 0; left = end - System.nanoTime()) {
          accepted(access.send(port, leg.velocity(), VALID));
          call.pause(Duration.ofNanos(Math.min(left, BEAT.toNanos())));
        }
      }
      accepted(access.send(port, VelocityCommand.ZERO, VALID));
    } finally {
      access.release();
    }
    return null;
  }

  private static Object send(ScriptCall call) throws ScriptFailure {
    Ruic ruic = Named.ruic(call, 3);
    SourceId target = Named.port(call, 0);
    PortAccess access = call.access(ruic);
    Optional<Port> port = access.port(PortKind.COMMAND, target);
    if (!(port.orElse(null) instanceof CommandPort<?> command)) {
      throw new ScriptFailure("no command " + target + " is offered now; see ports()");
    }
    String robot = ruic.authority(target.component()).map(Authority::robot).orElse(ruic.name());
    Record made = new RecordMaker(robot).make(command.type(), call.fields(1));
    accepted(access.send(target, (Data) made, call.seconds(2, USUAL_SECONDS)));
    return null;
  }

  private static void accepted(CommandOutcome outcome) throws ScriptFailure {
    if (outcome instanceof CommandOutcome.Refused refused) {
      throw new ScriptFailure(refused.explanation());
    }
  }

  private static Object stop(ScriptCall call) throws ScriptFailure {
    if (call.textIf(0).isEmpty()) {
      call.host().stopAll(call.principal());
    } else {
      Named.robot(call, 0).stop(call.principal());
    }
    return null;
  }

  private static Object select(ScriptCall call) throws ScriptFailure {
    Ruic ruic = Named.ruic(call, 1);
    if (!(call.argument(0).orElse(null) instanceof List<?> names)) {
      throw new ScriptFailure("selectRobots(names): names must be a list of robots, such as [\"Keira\"]");
    }
    ruic.selection().set(new LinkedHashSet<>(names.stream().map(String::valueOf).toList()));
    return null;
  }
}
