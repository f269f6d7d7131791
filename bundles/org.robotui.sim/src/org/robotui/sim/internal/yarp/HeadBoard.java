package org.robotui.sim.internal.yarp;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.robot.Head;
import org.robotui.sim.internal.robot.Neck;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.YarpValue;

/** The head as a control board with two joints that turn: it looks around by itself until a joint is driven. */
final class HeadBoard {
  private static final int JOINTS = 2;
  private static final List<String> NAMES = List.of("neck_pan", "neck_tilt");
  private static final double[] LIMITS = {Math.toDegrees(Neck.MOST_PAN), Math.toDegrees(Neck.MOST_TILT)};
  private static final double FASTEST = Math.toDegrees(Neck.FASTEST);
  private static final String POSITION = "pos";
  private static final double MILLIS = 1e-3;

  private final SimulatedRobot robot;
  private final String[] modes = {POSITION, POSITION}; // guarded by this, as the following
  private final double[] wishes = new double[JOINTS];
  private final double[] speeds = {FASTEST, FASTEST};
  private final double[] chosen = {FASTEST, FASTEST};
  private boolean driven;
  private final AtomicInteger answers = new AtomicInteger();

  HeadBoard(SimulatedRobot robot) {
    this.robot = robot;
  }

  private static double[] degrees(double pan, double tilt) {
    return new double[]{Math.toDegrees(pan), Math.toDegrees(tilt)};
  }

  private static double[] positions(Head head) {
    return degrees(head.pan(), head.tilt());
  }

  Bottle positions(RobotState state) {
    return Bottle.reals(positions(state.head().orElseThrow()));
  }

  /** Eleven columns, each with a word that says whether it holds. */
  synchronized Bottle extended(RobotState state) {
    Head head = state.head().orElseThrow();
    Bottle position = Bottle.reals(positions(head));
    Bottle velocity = Bottle.reals(degrees(head.panSpeed(), head.tiltSpeed()));
    Bottle none = Bottle.reals(0, 0);
    List<YarpValue> columns = new ArrayList<>();
    for (Bottle column : List.of(position, velocity, none, position, velocity, none, none, none, none,
        words(modes), words("stif", "stif"))) {
      columns.add(column);
      columns.add(YarpValue.Vocab.of("ok"));
    }
    return new Bottle(columns, 0);
  }

  private static Bottle words(String... words) {
    return Bottle.of(Bottle.vocabs(words).stream()
        .map(word -> new YarpValue.Whole(((YarpValue.Vocab) word).code(), Integer.SIZE)).toList());
  }

  /** {@code [get] ...} and {@code [set] ...}, in words or vocabularies. */
  synchronized Bottle asked(Bottle question) {
    boolean mode = question.get(1).text().equals("icmd");
    String what = question.get(mode ? 2 : 1).text();
    double joint = question.get(mode ? 3 : 2).number();
    boolean known = joint >= 0 && joint < JOINTS;
    return switch (question.get(0).text()) {
      case "get" -> answer(question, get(what, known ? (int) joint : -1));
      case "set" -> Bottle.of(Bottle.vocabs(known && set(what, (int) joint, question.get(mode ? 4 : 3)) ? "ok"
          : "fail"));
      default -> Bottle.of(Bottle.vocabs("nak"));
    };
  }

  private Bottle answer(Bottle question, List<? extends YarpValue> values) {
    if (values.isEmpty()) {
      return Bottle.of(Bottle.vocabs("fail"));
    }
    List<YarpValue> answer = new ArrayList<>(List.of(YarpValue.Vocab.of("is"), question.get(1)));
    answer.addAll(values);
    answer.addAll(List.of(YarpValue.Vocab.of("tsta"), new YarpValue.Whole(answers.getAndIncrement(), Integer.SIZE),
        new YarpValue.Real(System.currentTimeMillis() * MILLIS, Double.SIZE), YarpValue.Vocab.of("ok")));
    return Bottle.of(answer);
  }

  private List<? extends YarpValue> get(String what, int joint) {
    double[] at = positions(robot.state().head().orElseThrow());
    return switch (what) {
      case "axes" -> Bottle.of(JOINTS).values();
      case "encs" -> List.of(Bottle.reals(at));
      case "enc" -> joint < 0 ? List.of() : Bottle.reals(at[joint]).values();
      case "name" -> joint < 0 ? List.of() : Bottle.of(NAMES.get(joint)).values();
      case "type" -> joint < 0 ? List.of() : Bottle.vocabs("atrv");
      case "llim" -> joint < 0 ? List.of() : Bottle.reals(-LIMITS[joint], LIMITS[joint]).values();
      case "vlim" -> joint < 0 ? List.of() : Bottle.reals(-FASTEST, FASTEST).values();
      default -> List.of();
    };
  }

  private boolean set(String what, int joint, YarpValue value) {
    switch (what) {
      case "cmod" -> modes[joint] = value.text();
      case "vel" -> chosen[joint] = Math.abs(value.number());
      case "sto" -> stay(joint);
      case POSITION, "vmo" -> {
        return modes[joint].equals(what.equals("vmo") ? "vel" : POSITION) && drive(what, joint, value.number());
      }
      default -> {
        return false;
      }
    }
    return true;
  }

  private boolean drive(String what, int joint, double value) {
    if (!Double.isFinite(value)) {
      return false;
    }
    begin();
    boolean speed = what.equals("vmo");
    wishes[joint] = speed ? Math.copySign(LIMITS[joint], value) : value;
    look(joint, speed ? Math.abs(value) : chosen[joint]);
    return true;
  }

  /** The other joint stays where it is. */
  private void begin() {
    if (!driven) {
      driven = true;
      System.arraycopy(positions(robot.state().head().orElseThrow()), 0, wishes, 0, JOINTS);
    }
  }

  private void stay(int joint) {
    if (driven) {
      wishes[joint] = positions(robot.state().head().orElseThrow())[joint];
      look(joint, FASTEST);
    }
  }

  private void look(int joint, double speed) {
    speeds[joint] = speed;
    robot.simulation().submit(new Command.Turn(new Neck.Look(Math.toRadians(wishes[0]), Math.toRadians(wishes[1]),
        Math.toRadians(speeds[0]), Math.toRadians(speeds[1]))));
  }

  /** Streams of {@code ((vmos) (...))} and {@code ((poss) (...))}. */
  synchronized void told(Bottle command) {
    String word = command.get(0).items().get(0).text();
    double[] values = command.get(1).items().numbers();
    if (values.length == JOINTS && (word.equals("vmos") || word.equals("poss"))) {
      for (int joint = 0; joint < JOINTS; joint++) {
        set(word.equals("vmos") ? "vmo" : POSITION, joint, new YarpValue.Real(values[joint], Double.SIZE));
      }
    }
  }
}
