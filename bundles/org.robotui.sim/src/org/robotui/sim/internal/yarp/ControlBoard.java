package org.robotui.sim.internal.yarp;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.robotui.sim.internal.yarp.BoardJoints.BoardJoint;
import org.robotui.sim.internal.yarp.BoardJoints.JointMotion;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.YarpValue;

/** What a control board says of its joints, and how they are driven by questions and by streams. */
final class ControlBoard {
  private static final String POSITION = "pos";
  private static final String VELOCITY = "vel";
  private static final double MILLIS = 1e-3;

  private final BoardJoints board;
  private final int count;
  private final String[] modes; // guarded by this, as the following
  private final double[] chosen;
  private int answers;

  ControlBoard(BoardJoints board) {
    this.board = board;
    this.count = board.joints().size();
    this.modes = new String[count];
    Arrays.fill(modes, POSITION);
    this.chosen = board.joints().stream().mapToDouble(BoardJoint::fastest).toArray();
  }

  Bottle positions() {
    return column(JointMotion::position);
  }

  /** Eleven columns, each with a word that says whether it holds. */
  synchronized Bottle extended() {
    Bottle position = positions();
    Bottle velocity = column(JointMotion::speed);
    Bottle none = Bottle.reals(new double[count]);
    List<YarpValue> columns = new ArrayList<>();
    for (Bottle column : List.of(position, velocity, none, position, velocity, none, none, none, none,
        words(Arrays.asList(modes)), words(Collections.nCopies(count, "stif")))) {
      columns.add(column);
      columns.add(YarpValue.Vocab.of("ok"));
    }
    return new Bottle(columns, 0);
  }

  private Bottle column(ToDoubleFunction<JointMotion> number) {
    return Bottle.reals(board.motions().stream().mapToDouble(number).toArray());
  }

  private static Bottle words(List<String> words) {
    return Bottle.of(Bottle.vocabs(words.toArray(String[]::new)).stream()
        .map(word -> new YarpValue.Whole(((YarpValue.Vocab) word).code(), Integer.SIZE)).toList());
  }

  /** {@code [get] ...} and {@code [set] ...}, in words or vocabularies. */
  synchronized Bottle asked(Bottle question) {
    boolean mode = question.get(1).text().equals("icmd");
    String what = question.get(mode ? 2 : 1).text();
    YarpValue second = question.get(mode ? 3 : 2);
    double joint = second.number();
    boolean known = joint >= 0 && joint < count;
    return switch (question.get(0).text()) {
      case "get" -> answer(question, known ? get(what, (int) joint) : getAll(what));
      case "set" -> Bottle.of(Bottle.vocabs(known && set(what, (int) joint, question.get(mode ? 4 : 3))
          || !known && setAll(what, second) ? "ok" : "fail"));
      default -> Bottle.of(Bottle.vocabs("nak"));
    };
  }

  private Bottle answer(Bottle question, List<? extends YarpValue> values) {
    if (values.isEmpty()) {
      return Bottle.of(Bottle.vocabs("fail"));
    }
    List<YarpValue> answer = new ArrayList<>(List.of(YarpValue.Vocab.of("is"), question.get(1)));
    answer.addAll(values);
    answer.addAll(List.of(YarpValue.Vocab.of("tsta"), new YarpValue.Whole(answers++, Integer.SIZE),
        new YarpValue.Real(System.currentTimeMillis() * MILLIS, Double.SIZE), YarpValue.Vocab.of("ok")));
    return Bottle.of(answer);
  }

  private List<? extends YarpValue> getAll(String what) {
    return switch (what) {
      case "axes" -> Bottle.of(count).values();
      case "encs" -> List.of(positions());
      default -> List.of();
    };
  }

  private List<? extends YarpValue> get(String what, int joint) {
    BoardJoint known = board.joints().get(joint);
    return switch (what) {
      case "enc" -> Bottle.reals(board.motions().get(joint).position()).values();
      case "name" -> Bottle.of(known.name()).values();
      case "type" -> Bottle.vocabs(known.slides() ? "atpr" : "atrv");
      case "llim" -> Bottle.reals(known.lower(), known.upper()).values();
      case "vlim" -> Bottle.reals(-known.fastest(), known.fastest()).values();
      case "cmod" -> Bottle.vocabs(modes[joint]);
      default -> getAll(what);
    };
  }

  private boolean set(String what, int joint, YarpValue value) {
    switch (what) {
      case "cmod" -> {
        if (!List.of(POSITION, VELOCITY).contains(value.text())) {
          return false;
        }
        modes[joint] = value.text();
      }
      case VELOCITY -> chosen[joint] = Math.abs(value.number());
      case "sto" -> board.stay(joint);
      case POSITION -> {
        return modes[joint].equals(POSITION) && move(joint, value.number(), chosen[joint]);
      }
      case "vmo" -> {
        BoardJoint known = board.joints().get(joint);
        double end = value.number() < 0 ? known.lower() : known.upper();
        return modes[joint].equals(VELOCITY) && move(joint, end, Math.abs(value.number()));
      }
      default -> {
        return false;
      }
    }
    return true;
  }

  /** All joints at once: {@code poss} and {@code vmos} with a list, {@code stos} without one. */
  private boolean setAll(String what, YarpValue list) {
    if (what.equals("stos")) {
      IntStream.range(0, count).forEach(board::stay);
      return true;
    }
    List<YarpValue> values = list.items().values();
    boolean all = values.size() == count && (what.equals("vmos") || what.equals("poss"));
    for (int joint = 0; all && joint < count; joint++) {
      all = set(what.equals("vmos") ? "vmo" : POSITION, joint, values.get(joint));
    }
    return all;
  }

  private boolean move(int joint, double position, double speed) {
    boolean meant = Double.isFinite(position) && Double.isFinite(speed);
    if (meant) {
      board.move(joint, position, speed);
    }
    return meant;
  }

  /** Streams of {@code ((vmos) (...))} and {@code ((poss) (...))}. */
  synchronized void told(Bottle command) {
    setAll(command.get(0).items().get(0).text(), command.get(1));
  }
}
